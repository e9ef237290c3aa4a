//! A trajectory generator with limited acceleration and jerk: it goes as fast as it can still stop.

use bessemer::prelude::*;

/// Limits.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// m/s.
    pub speed: f64,
    /// m/s².
    pub acceleration: f64,
    /// m/s³.
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
    /// One step of `time` s towards `target` m.
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
