//! A conversion without an attribute, by `into`.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Speed(pub f64);

impl From<f64> for Speed {
    fn from(x: f64) -> Speed {
        Speed(x)
    }
}

#[component]
#[derive(Default)]
pub struct ForgotAConversion {
    pub last: f64,
}

#[component]
impl ForgotAConversion {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let speed: Speed = x.into();
        self.last = speed.0;
        self.last
    }
}
