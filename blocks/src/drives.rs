//! Three-phase drives: Clarke, Park, space-vector modulation, phase-locked loop, maximum torque per ampere and flux
//! observer.
//!
//! Angles and speeds are electrical. The Clarke transform keeps amplitudes: a balanced current of 1 A peak has a vector
//! of length 1 A. `Default` of each type is 0.

use bessemer::prelude::*;

/// Vector in the stator's frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stator<T> {
    /// Component along phase A.
    pub alpha: T,
    /// Component 90° ahead.
    pub beta: T,
}

/// Vector in the rotor's frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rotor<T> {
    /// Component along the flux of the magnet.
    pub direct: T,
    /// Component 90° ahead, which makes torque.
    pub quadrature: T,
}

/// Clarke transform of two currents whose sum with the third is 0: α = a, β = (a + 2 b)/√3.
///
/// ```
/// use bessemer_blocks::{Stator, clarke, clarke_inverse};
///
/// let phases = clarke_inverse(Stator { alpha: 3.0_f64, beta: 0.0 });
/// assert_eq!(phases, [3.0, -1.5, -1.5]);
/// assert!(clarke(phases[0], phases[1]).beta.abs() < 1e-12);
/// ```
#[function]
pub fn clarke<T: Real>(a: T, b: T) -> Stator<T> {
    Stator { alpha: a, beta: (a + real::<T>(2.0) * b) * real(0.577_350_269_189_625_8) }
}

/// Inverse Clarke transform: a = α, b = (√3 β − α)/2, c = −(√3 β + α)/2.
#[function]
pub fn clarke_inverse<T: Real>(vector: Stator<T>) -> [T; 3] {
    let half = real::<T>(0.5) * vector.alpha;
    let across = real::<T>(0.866_025_403_784_438_6) * vector.beta;
    [vector.alpha, across - half, -across - half]
}

/// Park transform at an angle whose `sine` and `cosine` are known: d = α cos + β sin, q = β cos − α sin.
///
/// ```
/// use bessemer_blocks::{Rotor, park, park_inverse};
///
/// let vector = Rotor { direct: 1.0, quadrature: 2.0 };
/// assert_eq!(park(park_inverse(vector, 1.0, 0.0), 1.0, 0.0), vector);
/// ```
#[function]
pub fn park<T: Real>(vector: Stator<T>, sine: T, cosine: T) -> Rotor<T> {
    Rotor {
        direct: cosine * vector.alpha + sine * vector.beta,
        quadrature: cosine * vector.beta - sine * vector.alpha,
    }
}

/// Inverse Park transform: α = d cos − q sin, β = d sin + q cos.
#[function]
pub fn park_inverse<T: Real>(vector: Rotor<T>, sine: T, cosine: T) -> Stator<T> {
    Stator {
        alpha: cosine * vector.direct - sine * vector.quadrature,
        beta: sine * vector.direct + cosine * vector.quadrature,
    }
}

/// Duties of three half bridges.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Duties<T> {
    /// Share of the period in which each upper switch is on, 0 to 1.
    pub duties: [T; 3],
    /// True if the voltage was beyond the hexagon, so that duties were limited.
    pub is_limited: bool,
}

/// Space-vector PWM of a voltage from a `supply` above 0, in one unit: the common mode centres the duties.
///
/// The vector may be as long as supply/√3 in every direction. Saturation: a longer one can leave the
/// hexagon; each duty is then limited to 0 … 1, which cycles the vector. Source: van der Broeck, Skudelny and Stanke,
/// *Analysis and Realization of a Pulsewidth Modulator Based on Voltage Space Vectors*, IEEE Transactions on Industry
/// Applications 24 (1), 1988.
///
/// ```
/// use bessemer_blocks::{Stator, space_vector};
///
/// let modulated = space_vector(Stator { alpha: 6.0, beta: 0.0 }, 24.0);
/// assert_eq!((modulated.duties, modulated.is_limited), ([0.6875, 0.3125, 0.3125], false));
/// ```
#[function]
pub fn space_vector<T: Real>(voltage: Stator<T>, supply: T) -> Duties<T> {
    let half = real::<T>(0.5);
    let phases = clarke_inverse(voltage);
    let [a, b, c] = phases;
    let highest = a.max(b).max(c);
    let lowest = a.min(b).min(c);
    let middle = half * (highest + lowest);
    let scale = T::ONE / supply;
    let duties = phases.map(|phase| (half + (phase - middle) * scale).max(T::ZERO).min(T::ONE));
    Duties { duties, is_limited: highest - lowest > supply }
}

/// Gains of a [`Pll`]. For a natural frequency w in rad/s and a damping ζ: 2 ζ w and w².
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PllGains<T> {
    /// Gain of the angle.
    #[unit("1/s")]
    pub proportional: T,
    /// Gain of the speed.
    #[unit("1/s²")]
    pub integral: T,
    /// Period h, above 0; gain · h stays below 1.
    #[unit("s")]
    pub period: T,
}

/// Phase-locked loop: follows the angle of a vector, and estimates its speed.
///
/// With the error e = sin(angle of the vector − θ) by a product: speed += h Ki e, θ += h (speed + Kp e), wrapped to
/// −π … π. The vector's length should be about 1, since the gains are multiplied by it. Initialisation: `Default` is at
/// angle 0 and at rest. An input that is not finite moves the angle by the speed.
///
/// ```
/// use bessemer_blocks::{Pll, PllGains, Stator};
///
/// let gains = PllGains { proportional: 100.0_f64, integral: 2500.0, period: 0.001 };
/// let mut pll = Pll::default();
/// for k in 0..2000 {
///     let angle = 0.02 * f64::from(k);
///     pll.step(&gains, Stator { alpha: angle.cos(), beta: angle.sin() });
/// }
/// assert!((pll.speed() - 20.0).abs() < 1e-6);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pll<T> {
    /// Angle of the next period.
    #[unit("rad")]
    angle: T,
    /// Speed.
    #[unit("rad/s")]
    speed: T,
}

#[component]
impl<T: Real> Pll<T> {
    /// Takes the vector of one period; returns the angle of the next one, rad.
    #[entry(infallible)]
    pub fn step(&mut self, gains: &PllGains<T>, vector: Stator<T>) -> T {
        let (sine, cosine) = self.angle.sin_cos();
        let error = vector.beta * cosine - vector.alpha * sine;
        let error = if error.is_finite() { error } else { T::ZERO };
        self.speed += gains.period * gains.integral * error;
        let moved = self.angle + gains.period * (self.speed + gains.proportional * error);
        self.angle = moved - T::TAU * (moved / T::TAU).round();
        self.angle
    }

    /// Returns the speed, rad/s.
    #[entry(infallible)]
    pub fn speed(&self) -> T {
        self.speed
    }
}

/// Maximum torque per ampere: the current vector that has a magnitude and the largest torque of the sign of `current`.
///
/// The magnet's `flux` is in Wb, above 0; inductances are in H, `quadrature_inductance` not below
/// `direct_inductance`.
///
/// id = −2 ΔL i²/(ψ + √(ψ² + 8 ΔL² i²)) with ΔL = Lq − Ld, and iq = ±√(i² − id²). Without saliency, id = 0. Source:
/// Morimoto, Takeda, Hirasa and Taniguchi, *Expansion of Operating Limits for Permanent Magnet Motor by Current
/// Vector Control Considering Inverter Capacity*, IEEE Transactions on Industry Applications 26 (5), 1990, in a
/// form without a difference of near values.
///
/// ```
/// use bessemer_blocks::{Rotor, mtpa};
///
/// assert_eq!(mtpa(-5.0, 0.01, 1e-3, 1e-3), Rotor { direct: 0.0, quadrature: -5.0 });
/// assert!(mtpa(5.0, 0.01, 1e-3, 2e-3).direct < -1.0);
/// ```
#[function]
pub fn mtpa<T: Real>(
    current: T,
    flux: T,
    direct_inductance: T,
    quadrature_inductance: T,
) -> Rotor<T> {
    let difference = quadrature_inductance - direct_inductance;
    let square = current * current;
    let root = (flux * flux + real::<T>(8.0) * difference * difference * square).sqrt();
    let direct = real::<T>(-2.0) * difference * square / (flux + root);
    let quadrature = (square - direct * direct).max(T::ZERO).sqrt();
    Rotor { direct, quadrature: quadrature.copysign(current) }
}

/// Motor of a [`FluxObserver`].
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FluxParameters<T> {
    /// Resistance of a phase.
    #[unit("Ω")]
    pub resistance: T,
    /// Inductance of a phase, the same in both axes.
    #[unit("H")]
    pub inductance: T,
    /// Flux linkage of the magnet, above 0.
    #[unit("Wb")]
    pub flux: T,
    /// Gain γ of the correction: about 1000/flux².
    #[unit("1/(Wb²·s)")]
    pub gain: T,
    /// Period h, above 0.
    #[unit("s")]
    pub period: T,
}

/// Flux observer of a motor with surface magnets: the angle of the rotor from voltages and currents.
///
/// With the stator's flux x and the magnet's flux η = x − L i: x' = v − R i + γ/2 η (ψ² − |η|²), by Euler's step. The
/// magnet's flux points along the rotor. It needs some speed: at rest the angle is undefined.
///
/// Initialisation: `Default` has no flux; [`FluxObserver::preset`] begins at an angle. Saturation: none; the correction
/// limits |η| to about ψ if h·γ·ψ² is below 1. An input that is not finite is ignored. Source: Lee, Hong, Nam, Ortega, Praly
/// and Astolfi, *Sensorless Control of Surface-Mount Permanent-Magnet Synchronous Motors Based on a Nonlinear Observer*,
/// IEEE Transactions on Power Electronics 25 (2), 2010.
///
/// ```
/// use bessemer_blocks::{FluxObserver, FluxParameters, Stator};
///
/// let motor = FluxParameters { resistance: 0.1, inductance: 1e-4, flux: 0.01_f64, gain: 1e7, period: 1e-4 };
/// let mut observer = FluxObserver::default();
/// observer.preset(&motor, 0.0);
/// // No current: the voltage is the speed times the flux, 90° ahead of the magnet.
/// for k in 1..=1000 {
///     let angle = 100.0 * 1e-4 * (f64::from(k) - 0.5);
///     let voltage = Stator { alpha: -angle.sin(), beta: angle.cos() };
///     observer.step(&motor, voltage, Stator::default());
/// }
/// assert!((observer.angle() - (10.0 - core::f64::consts::TAU - core::f64::consts::TAU)).abs() < 1e-3);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FluxObserver<T> {
    /// Flux of the stator.
    #[unit("Wb")]
    flux: Stator<T>,
    /// Flux of the magnet.
    #[unit("Wb")]
    magnet: Stator<T>,
}

#[component]
impl<T: Real> FluxObserver<T> {
    /// Takes the mean voltage of the last period, V, and the currents at its end, A; returns the magnet's flux, Wb.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        motor: &FluxParameters<T>,
        voltage: Stator<T>,
        current: Stator<T>,
    ) -> Stator<T> {
        let Stator { alpha, beta } = self.magnet;
        let missing = motor.flux * motor.flux - alpha * alpha - beta * beta;
        let correction = real::<T>(0.5) * motor.gain * missing;
        let flux = Stator {
            alpha: self.flux.alpha
                + motor.period
                    * (voltage.alpha - motor.resistance * current.alpha + correction * alpha),
            beta: self.flux.beta
                + motor.period
                    * (voltage.beta - motor.resistance * current.beta + correction * beta),
        };
        let magnet = Stator {
            alpha: flux.alpha - motor.inductance * current.alpha,
            beta: flux.beta - motor.inductance * current.beta,
        };
        if magnet.alpha.is_finite() && magnet.beta.is_finite() {
            self.flux = flux;
            self.magnet = magnet;
        }
        self.magnet
    }

    /// Returns the angle of the rotor, −π to π rad.
    #[entry(infallible)]
    pub fn angle(&self) -> T {
        self.magnet.beta.atan2(self.magnet.alpha)
    }

    /// Begins at an angle in rad, without current.
    #[entry(infallible)]
    pub fn preset(&mut self, motor: &FluxParameters<T>, angle: T) {
        let (sine, cosine) = angle.sin_cos();
        self.magnet = Stator { alpha: motor.flux * cosine, beta: motor.flux * sine };
        self.flux = self.magnet;
    }
}
