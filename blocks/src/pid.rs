//! PID controller: two degrees of freedom, filtered derivative, anti-windup and bumpless transfer.
//!
//! With error e = r − y of a target r and a measurement y, period h and k the number of the period:
//!
//! ```text
//! P(k) = Kp (b r − y)
//! D(k) = (Tf D(k−1) + Kd ((c r − y)(k) − (c r − y)(k−1))) / (Tf + h)
//! v(k) = P(k) + I(k) + D(k)
//! u(k) = v(k), limited to low … high
//! I(k+1) = I(k) + h (Ki e + Kt (u − v))     back-calculation, Kt > 0
//! I(k+1) = I(k) + h Ki e                    clamping, Kt = 0; I(k) if that moves v further beyond a limit
//! ```
//!
//! Source: Åström and Hägglund, *Advanced PID Control*, 2006, sections 3.4, 3.5 and 13.

use bessemer::prelude::*;

/// Gains and limits of a [`Pid`]. Units are those of the output (U), the measurement (Y) and seconds.
///
/// `Default` has no gains, no limits, `target_weight` 1 and a period of 1 s.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PidParameters<T> {
    /// Proportional gain Kp, U/Y.
    pub proportional: T,
    /// Integral gain Ki, U/(Y·s).
    pub integral: T,
    /// Derivative gain Kd, U·s/Y.
    pub derivative: T,
    /// Weight b of the target in the proportional part, 0 to 1.
    pub target_weight: T,
    /// Weight c of the target in the derivative part, 0 to 1; 0 avoids a kick when the target jumps.
    pub target_slope_weight: T,
    /// Time constant Tf of the derivative's filter, 0 or more.
    #[unit("s")]
    pub filter: T,
    /// Rate Kt at which the integral follows a limited output, 0 to 1/period; with 0 it keeps its value at a limit.
    #[unit("1/s")]
    pub tracking: T,
    /// Lowest output, U.
    pub low: T,
    /// Highest output, not below the lowest, U.
    pub high: T,
    /// Control period h, above 0.
    #[unit("s")]
    pub period: T,
}

impl<T: Real> Default for PidParameters<T> {
    fn default() -> Self {
        PidParameters {
            proportional: T::ZERO,
            integral: T::ZERO,
            derivative: T::ZERO,
            target_weight: T::ONE,
            target_slope_weight: T::ZERO,
            filter: T::ZERO,
            tracking: T::ZERO,
            low: T::MIN,
            high: T::MAX,
            period: T::ONE,
        }
    }
}

/// PID controller.
///
/// * Initialisation: `Default` has no integral, and no derivative in the first period. [`Pid::track`] starts from
///   an output.
/// * Saturation: the output is limited to `low` … `high`; with reversed limits it is `high`.
/// * NaN or infinity: the output is a limit (`low` for NaN), and the state keeps its value.
///
/// ```
/// use bessemer_blocks::{Pid, PidParameters};
///
/// let parameters = PidParameters {
///     proportional: 2.0, integral: 1.0, low: -5.0, high: 5.0, period: 0.5,
///     ..Default::default()
/// };
/// let mut pid = Pid::default();
/// assert_eq!(pid.step(&parameters, 1.0, 0.0), 2.0);
/// assert_eq!(pid.step(&parameters, 1.0, 0.0), 2.5);
/// // The integral does not grow at the limit.
/// assert_eq!(pid.step(&parameters, 9.0, 0.0), 5.0);
/// assert_eq!(pid.step(&parameters, 1.0, 0.0), 3.0);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pid<T> {
    /// Integral part of the output.
    integral: T,
    /// Derivative part of the output.
    derivative: T,
    /// Weighted target less measurement of the last period, of which the derivative is.
    before: T,
    /// True after the first period.
    running: bool,
}

#[component]
impl<T: Real> Pid<T> {
    /// Advances one period; returns the output.
    #[entry(infallible)]
    pub fn step(&mut self, parameters: &PidParameters<T>, target: T, measured: T) -> T {
        let error = target - measured;
        let weighted = parameters.target_slope_weight * target - measured;
        let change = if self.running { weighted - self.before } else { T::ZERO };
        let derivative = (parameters.filter * self.derivative + parameters.derivative * change)
            / (parameters.filter + parameters.period);
        let proportional = parameters.proportional * (parameters.target_weight * target - measured);
        let wanted = proportional + self.integral + derivative;
        let output = wanted.max(parameters.low).min(parameters.high);
        if wanted.is_finite() {
            self.derivative = derivative;
            self.before = weighted;
            self.running = true;
            let rate = parameters.integral * error;
            let beyond = wanted - output;
            if parameters.tracking > T::ZERO {
                self.integral += parameters.period * (rate - parameters.tracking * beyond);
            } else if beyond * rate <= T::ZERO {
                self.integral += parameters.period * rate;
            }
        }
        output
    }

    /// Follows an output that another controller or an operator sets. The next step with the same target and
    /// measurement returns `output` if that is within the limits.
    #[entry(infallible)]
    pub fn track(&mut self, parameters: &PidParameters<T>, target: T, measured: T, output: T) {
        let proportional = parameters.proportional * (parameters.target_weight * target - measured);
        self.integral = output - proportional;
        self.derivative = T::ZERO;
        self.before = parameters.target_slope_weight * target - measured;
        self.running = true;
    }
}
