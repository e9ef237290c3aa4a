//! A sum of two phasors.
use bessemer::prelude::*;
use core::ops::Add;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Phasor {
    pub re: f64,
    pub im: f64,
}

impl Add for Phasor {
    type Output = Phasor;

    fn add(self, other: Phasor) -> Phasor {
        Phasor { re: self.re + other.re, im: self.im + other.im }
    }
}

#[component]
#[derive(Default)]
pub struct UnmarkedOperator {
    pub sum: Phasor,
}

#[component]
impl UnmarkedOperator {
    #[entry]
    pub fn step(&mut self, x: &Phasor) -> f64 {
        self.sum = self.sum + *x;
        self.sum.re
    }
}
