//! Methods of an author's own types that are called as methods of lists are.
#![no_std]
use bessemer::prelude::*;

/// Numbers, each taken as its half.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Halves {
    /// Their sum.
    pub sum: f64,
}

#[data]
impl Halves {
    /// Takes the half of a number.
    pub fn push(&mut self, number: f64) {
        self.sum += 0.5 * number;
    }
    /// Takes three numbers whole.
    pub fn extend(&mut self, numbers: [f64; 3]) {
        self.sum += numbers[0] + numbers[1] + numbers[2];
    }
    /// Halves the sum unless a number is wanted.
    pub fn retain(&mut self, wanted: bool) {
        if !wanted {
            self.sum *= 0.5;
        }
    }
}

/// A call of a method that only looks like a list's.
#[function]
pub fn gather(halves: &mut Halves, numbers: [f64; 3]) {
    halves.extend(numbers);
}

/// By its path it is the type's own.
#[function]
pub fn gather_by_path(halves: &mut Halves, numbers: [f64; 3]) {
    Halves::extend(halves, numbers);
}
