//! A newtype without an attribute, in a field.
use bessemer::prelude::*;

#[derive(Clone, Copy, Default)]
pub struct Volts(pub f64);

#[component]
#[derive(Default)]
pub struct ForgotANewtype {
    pub last: Volts,
}

#[component]
impl ForgotANewtype {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = Volts(x);
        self.last.0
    }
}
