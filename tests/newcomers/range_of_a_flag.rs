//! Ranges on whatever is set.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct RangedLimits {
    #[range(0.0..=5.0)]
    pub most: f64,
}

#[data]
#[derive(Clone, Copy, Default)]
pub struct RangedSettings {
    #[range(0.0..=1.0)]
    pub enabled: bool,
    #[range(0.0..=5.0)]
    pub limits: RangedLimits,
    #[range(0.0..=5.0)]
    pub gains: [f64; 2],
}

#[component]
#[derive(Default)]
pub struct RangedFlag {
    pub last: f64,
}

#[component]
impl RangedFlag {
    #[entry]
    pub fn step(&mut self, settings: &RangedSettings, #[range(0.0..=1.0)] hold: bool) -> f64 {
        if settings.enabled && !hold {
            self.last = settings.limits.most * settings.gains[0];
        }
        self.last
    }
}
