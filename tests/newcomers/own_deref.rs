//! A wrapper that acts as the number in it.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Volts(pub f64);

impl core::ops::Deref for Volts {
    type Target = f64;
    fn deref(&self) -> &f64 {
        &self.0
    }
}

#[component]
#[derive(Default)]
pub struct ActsAsNumber {
    pub last: f64,
}

#[component]
impl ActsAsNumber {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let wrapped = Volts(x);
        self.last = wrapped.abs();
        self.last
    }
}
