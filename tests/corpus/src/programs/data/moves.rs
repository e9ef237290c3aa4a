//! A value that is passed to a function is a copy: later changes of the copy do not affect the original.

use bessemer::prelude::*;

/// A state of two numbers.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Two {
    pub first: i64,
    pub second: i64,
}

/// Swaps the numbers of a copy.
#[function]
pub fn swapped(mut two: Two) -> Two {
    let first = two.first;
    two.first = two.second;
    two.second = first;
    two
}

/// The original and its swapped copy.
#[function]
pub fn both(two: Two) -> [Two; 2] {
    [two, swapped(two)]
}
