//! The index of a matched element is checked first, even if no pattern reads the element.

use bessemer::prelude::*;

#[function]
pub fn of_a_tuple(x: u8, state: [u8; 2], at: usize) -> u8 {
    if let (5, _length) = (x, state[at]) { 7 } else { 3 }
}

#[function]
pub fn of_arms(x: u8, state: [u8; 2], at: usize) -> u8 {
    match (x, state[at]) {
        (5, 3) => 7,
        (6, n) => n ^ 8,
        _ => 4,
    }
}

#[function]
pub fn of_a_reference(state: &mut [Option<u8>; 2], mut at: usize) -> u8 {
    match &mut state[at] {
        Some(n) if *n > 3 => {
            at = 1;
            *n = 1;
        }
        _ => at /= 2,
    }
    at as u8
}
