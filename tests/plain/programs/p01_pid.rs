//! PID controller with derivative on the measurement, a first-order filter on
//! the derivative, output limits and back-calculation anti-windup.

use num_traits::Float;

/// Controller gains, built up from the proportional part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains<T> {
    pub kp: T,
    pub ki: T,
    pub kd: T,
}

impl<T: Float> Gains<T> {
    pub fn p(kp: T) -> Self {
        Self { kp, ki: T::zero(), kd: T::zero() }
    }

    pub fn with_i(self, ki: T) -> Self {
        Self { ki, ..self }
    }

    pub fn with_d(self, kd: T) -> Self {
        Self { kd, ..self }
    }
}

/// Actuator range; `min < max` is guaranteed by the constructor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<T> {
    min: T,
    max: T,
}

impl<T: Float> Limits<T> {
    pub fn new(min: T, max: T) -> Option<Self> {
        (min < max).then_some(Self { min, max })
    }

    pub fn symmetric(magnitude: T) -> Option<Self> {
        Self::new(-magnitude, magnitude)
    }

    fn clamp(&self, v: T) -> T {
        v.max(self.min).min(self.max)
    }
}

/// PID controller running at a fixed period.
#[derive(Clone, Debug)]
pub struct Pid<T> {
    gains: Gains<T>,
    limits: Limits<T>,
    dt: T,
    /// Smoothing factor of the derivative, in (0, 1]; 1 is unfiltered.
    d_alpha: T,
    integral: T,
    derivative: T,
    last_measured: Option<T>,
}

/// The flavour the motor boards use.
pub type PidF32 = Pid<f32>;

impl<T: Float> Pid<T> {
    pub fn new(gains: Gains<T>, limits: Limits<T>, dt: T) -> Self {
        debug_assert!(dt > T::zero());
        Self {
            gains,
            limits,
            dt,
            d_alpha: T::one(),
            integral: T::zero(),
            derivative: T::zero(),
            last_measured: None,
        }
    }

    /// Filters the derivative with the given time constant.
    pub fn with_derivative_filter(mut self, tau: T) -> Self {
        self.d_alpha = self.dt / (self.dt + tau.max(T::zero()));
        self
    }

    /// Computes the actuator command for this period.
    pub fn step(&mut self, setpoint: T, measured: T) -> T {
        let Gains { kp, ki, kd } = self.gains;
        let error = setpoint - measured;

        let raw_slope = self
            .last_measured
            .replace(measured)
            .map_or(T::zero(), |last| (measured - last) / self.dt);
        self.derivative = self.derivative + self.d_alpha * (raw_slope - self.derivative);

        let unlimited = kp * error + self.integral - kd * self.derivative;
        let output = self.limits.clamp(unlimited);

        if ki > T::zero() {
            // Tracking gain: unwind with the same time constant as the integrator.
            let back = (ki / kp.max(T::epsilon())).min(T::one() / self.dt);
            self.integral =
                self.integral + (ki * error + back * (output - unlimited)) * self.dt;
        }
        output
    }

    /// Forgets history; the next step has no derivative kick.
    pub fn reset(&mut self) {
        self.integral = T::zero();
        self.derivative = T::zero();
        self.last_measured = None;
    }

    pub fn integral(&self) -> T {
        self.integral
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run_plant(pid: &mut PidF32, setpoint: f32, steps: usize, dt: f32) -> f32 {
        (0..steps).fold(0.0, |y, _| {
            let u = pid.step(setpoint, y);
            y + dt * (u - y) / 0.5
        })
    }

    #[test]
    fn settles_without_offset() {
        let gains = Gains::p(2.0).with_i(4.0).with_d(0.02);
        let mut pid = Pid::new(gains, Limits::symmetric(10.0).unwrap(), 0.01)
            .with_derivative_filter(0.02);
        let y = run_plant(&mut pid, 1.0, 1000, 0.01);
        assert!((y - 1.0).abs() < 1e-3, "{y}");
    }

    #[test]
    fn integral_does_not_wind_up() {
        let mut pid = Pid::new(Gains::p(2.0).with_i(4.0), Limits::new(0.0, 1.0).unwrap(), 0.01);
        for _ in 0..2000 {
            assert!(pid.step(10.0, 0.0) <= 1.0);
        }
        assert!(pid.integral().abs() < 25.0);
        pid.reset();
        assert_eq!(pid.integral(), 0.0);
    }

    #[test]
    fn rejects_inverted_limits_and_works_in_f64() {
        assert!(Limits::new(1.0_f32, -1.0).is_none());
        let mut pid: Pid<f64> = Pid::new(Gains::p(3.0), Limits::symmetric(5.0).unwrap(), 0.1);
        assert_eq!(pid.step(1.0, 0.0), 3.0);
        assert_eq!(pid.step(9.0, 0.0), 5.0);
    }
}
