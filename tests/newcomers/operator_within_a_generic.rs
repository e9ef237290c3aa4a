//! A helper for any number, with a type of its author's.
use bessemer::prelude::*;

use core::ops::Add;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Charge(pub f64);

impl Add for Charge {
    type Output = Charge;

    fn add(self, other: Charge) -> Charge {
        Charge(self.0 + other.0)
    }
}

#[function]
fn sum<T: Add<Output = T> + Copy>(a: T, b: T) -> T {
    a + b
}

#[component]
#[derive(Default)]
pub struct OperatorWithinAGeneric {
    pub last: f64,
}

#[component]
impl OperatorWithinAGeneric {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = sum(Charge(x), Charge(1.0)).0;
        self.last
    }
}
