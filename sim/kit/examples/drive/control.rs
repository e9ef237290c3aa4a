//! The controller of the drive: what becomes C. It knows no plant.

use bessemer::prelude::*;
use bessemer_blocks::{
    Pid, PidParameters, Pll, PllGains, Rotor, Stator, clarke, park, park_inverse, space_vector,
};

/// Settings of the drive.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Speed loop, from rad/s to A.
    pub speed: PidParameters<f64>,
    /// Current loops, from A to V.
    pub current: PidParameters<f64>,
    /// Speed estimate from the angle.
    pub pll: PllGains<f64>,
    /// Number of pole pairs.
    pub pole_pairs: f64,
    /// Voltage of the supply, V.
    pub supply: f64,
}

/// Holds the speed of a motor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drive {
    speed: Pid<f64>,
    direct: Pid<f64>,
    quadrature: Pid<f64>,
    pll: Pll<f64>,
}

#[component]
impl Drive {
    /// Advances one period with a target speed in rad/s, two currents in A and an electrical angle in rad.
    ///
    /// Returns the duties of the three half bridges, 0 to 1.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        settings: &Settings,
        target: f64,
        currents: [f64; 2],
        angle: f64,
    ) -> [f64; 3] {
        let (sine, cosine) = angle.sin_cos();
        self.pll.step(&settings.pll, Stator { alpha: cosine, beta: sine });
        let speed = self.pll.speed() / settings.pole_pairs;
        let current = park(clarke(currents[0], currents[1]), sine, cosine);
        let torque_current = self.speed.step(&settings.speed, target, speed);
        let voltage = Rotor {
            direct: self.direct.step(&settings.current, 0.0, current.direct),
            quadrature: self.quadrature.step(&settings.current, torque_current, current.quadrature),
        };
        space_vector(park_inverse(voltage, sine, cosine), settings.supply).duties
    }
}
