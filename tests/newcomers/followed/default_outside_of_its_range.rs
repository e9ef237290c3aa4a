//! The default lies within, or the range is wider.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct RangedGains {
    #[unit("s")]
    #[range(1e-4..=2e-2)]
    pub period: f64,
    #[range(-0.1..=0.1)]
    pub slopes: [f32; 2],
}

impl Default for RangedGains {
    fn default() -> Self {
        RangedGains { period: 0.02, slopes: [0.1, -0.1] }
    }
}

#[component]
#[derive(Default)]
pub struct DefaultWithinItsRange {
    pub gains: RangedGains,
    #[range(0.0..=1.0)]
    pub last: f64,
}

#[component]
impl DefaultWithinItsRange {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x * self.gains.period * f64::from(self.gains.slopes[0]);
        self.last
    }
}
