//! Supervision of a machine: a button, a timeout, a watchdog of the link and three sensors.

use bessemer::prelude::*;
pub use bessemer_blocks::{Contact, Debounce, Timer, Vote, Voter, VoterLimits, Watchdog, median};

/// Supervises a machine.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Supervisor {
    button: Debounce,
    warm_up: Timer,
    link: Watchdog,
    pressure: Voter<f32>,
}

#[component]
impl Supervisor {
    /// Advances one period; returns true while the machine may run.
    #[entry(infallible, single)]
    pub fn step(&mut self, button: bool, message: bool, is_cold: bool) -> bool {
        let Contact { is_on, rose, .. } = self.button.step(3, button);
        if rose {
            self.link.reset();
        }
        let is_slow = self.warm_up.step(1000, is_cold);
        is_on && !self.link.step(5, message) && !(is_slow && self.warm_up.elapsed() > 1200)
    }

    /// Votes on the pressure, bar.
    #[entry(infallible, single)]
    pub fn pressure(&mut self, limits: &VoterLimits<f32>, sensors: [f32; 3], reset: bool) -> Vote<f32> {
        if reset {
            self.pressure.reset();
        }
        self.pressure.step(limits, sensors)
    }
}

/// Votes on an altitude.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Altimeters {
    voter: Voter<f64>,
}

#[component]
impl Altimeters {
    /// Votes on the altitude, m; returns it with the median of the sensors.
    #[entry(infallible)]
    pub fn step(&mut self, limits: &VoterLimits<f64>, sensors: [f64; 3]) -> (f64, f64) {
        let [a, b, c] = sensors;
        (self.voter.step(limits, sensors).value, median(a, b, c))
    }
}
