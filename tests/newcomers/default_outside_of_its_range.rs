//! A range that forgets the default.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct RangedGains {
    #[unit("s")]
    #[range(1e-4..=1e-2)]
    pub period: f64,
    #[range(0.0..=0.1)]
    pub slopes: [f32; 2],
    #[range(1..=8)]
    pub order: u8,
}

impl Default for RangedGains {
    fn default() -> Self {
        RangedGains { period: 0.02, slopes: [0.1, -0.1], order: 8 }
    }
}

#[component]
pub struct DefaultOutsideOfItsRange {
    pub gains: RangedGains,
    #[range(0.0..=1.0)]
    pub last: f64,
}

impl Default for DefaultOutsideOfItsRange {
    fn default() -> Self {
        DefaultOutsideOfItsRange { gains: RangedGains::default(), last: f64::NAN }
    }
}

#[component]
impl DefaultOutsideOfItsRange {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x * self.gains.period * f64::from(self.gains.slopes[0]) * f64::from(self.gains.order);
        self.last
    }
}
