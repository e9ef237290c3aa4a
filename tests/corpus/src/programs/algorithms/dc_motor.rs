//! A Luenberger observer of a DC motor: speed and current from voltage and a measured current.

use bessemer::prelude::*;

/// Constants of the motor.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    /// Resistance of the winding, Ω.
    pub resistance: f64,
    /// Inductance of the winding, H.
    pub inductance: f64,
    /// Motor constant, V·s/rad, which is also N·m/A.
    pub constant: f64,
    /// Moment of inertia, kg·m².
    pub inertia: f64,
    /// Viscous friction, N·m·s/rad.
    pub friction: f64,
}

/// Estimate of the current in A and the speed in rad/s.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observer {
    estimate: Vector2<f64>,
}

#[component]
impl Observer {
    /// Advances the estimate by one period of `time` s.
    #[entry(infallible)]
    pub fn step(&mut self, motor: &Motor, voltage: f64, current: f64, time: f64) -> Vector2<f64> {
        let system = Matrix2::new(
            -motor.resistance / motor.inductance,
            -motor.constant / motor.inductance,
            motor.constant / motor.inertia,
            -motor.friction / motor.inertia,
        );
        let input = Vector2::new(voltage / motor.inductance, 0.0);
        let correction = Vector2::new(200.0, 50.0) * (current - self.estimate.x);
        let slope = system * self.estimate + input + correction;
        self.estimate += slope * time;
        self.estimate
    }
}
