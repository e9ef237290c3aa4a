//! Field-oriented control of a motor without a position sensor, by blocks; and its frames in double precision.

use bessemer::prelude::*;
pub use bessemer_blocks::{
    Duties, FluxObserver, FluxParameters, Pid, PidParameters, Pll, PllGains, Rotor, Stator, clarke,
    clarke_inverse, mtpa, park, park_inverse, space_vector,
};

/// Parameters of the drive.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DriveParameters {
    /// Loops of the currents, V for A.
    pub current: PidParameters<f32>,
    /// Observer of the flux.
    pub observer: FluxParameters<f32>,
    /// Loop that follows the flux.
    pub pll: PllGains<f32>,
    /// Inductance across the flux.
    #[unit("H")]
    pub quadrature_inductance: f32,
}

/// Controls the torque of a motor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensorless {
    direct: Pid<f32>,
    quadrature: Pid<f32>,
    observer: FluxObserver<f32>,
    pll: Pll<f32>,
    /// Voltage of the last period.
    voltage: Stator<f32>,
}

#[component]
impl Sensorless {
    /// Advances one period: from the currents of two phases, A, to duties.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &DriveParameters,
        #[unit("A")] wanted: f32,
        #[unit("A")] currents: [f32; 2],
        #[unit("V")] supply: f32,
    ) -> Duties<f32> {
        let current = clarke(currents[0], currents[1]);
        let motor = &parameters.observer;
        let flux = self.observer.step(motor, self.voltage, current);
        let scale = 1.0 / motor.flux;
        let unit = Stator { alpha: flux.alpha * scale, beta: flux.beta * scale };
        let (sine, cosine) = self.pll.step(&parameters.pll, unit).sin_cos();
        let is = park(current, sine, cosine);
        let wanted = mtpa(wanted, motor.flux, motor.inductance, parameters.quadrature_inductance);
        let voltage = Rotor {
            direct: self.direct.step(&parameters.current, wanted.direct, is.direct),
            quadrature: self.quadrature.step(&parameters.current, wanted.quadrature, is.quadrature),
        };
        self.voltage = park_inverse(voltage, sine, cosine);
        space_vector(self.voltage, supply)
    }

    /// Returns the speed, rad/s.
    #[entry(infallible, single)]
    pub fn speed(&self) -> f32 {
        self.pll.speed()
    }

    /// Starts at a known angle, rad.
    #[entry(infallible)]
    pub fn align(&mut self, parameters: &DriveParameters, angle: f32) -> f32 {
        self.observer.preset(&parameters.observer, angle);
        self.observer.angle()
    }
}

/// The phases of a vector in the rotor's frame, and back.
#[function]
pub fn frames(direct: f64, quadrature: f64, angle: f64) -> ([f64; 3], Rotor<f64>) {
    let (sine, cosine) = angle.sin_cos();
    let phases = clarke_inverse(park_inverse(Rotor { direct, quadrature }, sine, cosine));
    (phases, park(clarke(phases[0], phases[1]), sine, cosine))
}

/// Follows a resolver.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resolver {
    pll: Pll<f64>,
    observer: FluxObserver<f64>,
}

#[component]
impl Resolver {
    /// Advances one period; returns the angle and the speed.
    #[entry(infallible)]
    pub fn step(&mut self, gains: &PllGains<f64>, motor: &FluxParameters<f64>, vector: Stator<f64>) -> (f64, f64) {
        let angle = self.pll.step(gains, vector);
        let flux = self.observer.step(motor, vector, Stator::default());
        (angle, self.pll.speed() + space_vector(flux, 24.0).duties[0])
    }
}
