//! A component that owns another and calls its entry.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Inner {
    pub last: f64,
}

#[component]
impl Inner {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}

#[component]
pub struct Outer {
    pub inner: Inner,
}

#[component]
impl Outer {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.inner.step(x)
    }
}
