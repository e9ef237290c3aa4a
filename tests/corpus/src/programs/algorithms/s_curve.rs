//! A trajectory generator with limited acceleration and jerk: it moves as fast as it can while it can still stop in
//! time.

use bessemer::prelude::*;

/// Limits of the motion.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Largest speed, m/s.
    pub speed: f64,
    /// Largest acceleration, m/s².
    pub acceleration: f64,
    /// Largest jerk, m/s³.
    pub jerk: f64,
}

/// State of the trajectory.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    position: f64,
    speed: f64,
    acceleration: f64,
}

#[component]
impl Trajectory {
    /// Advances the trajectory by `time` s towards `target` m; returns position, speed and acceleration.
    #[entry]
    pub fn step(&mut self, limits: &Motion, target: f64, time: f64) -> [f64; 3] {
        assert!(limits.acceleration > 0.0 && limits.jerk > 0.0 && limits.speed >= 0.0);
        let away = target - self.position;
        // The speed from which it just stops in the distance that is left.
        let ramp = limits.acceleration * limits.acceleration / limits.jerk;
        let most = (ramp * ramp / 4.0 + 2.0 * limits.acceleration * away.abs()).sqrt() - ramp / 2.0;
        let wanted = most.min(limits.speed).copysign(away);
        let change = (wanted - self.speed) / time.max(1e-6);
        let sought = change.clamp(-limits.acceleration, limits.acceleration);
        let step = limits.jerk * time;
        self.acceleration += (sought - self.acceleration).max(-step).min(step);
        self.speed += self.acceleration * time;
        self.position += self.speed * time;
        [self.position, self.speed, self.acceleration]
    }
}
