//! An iterator with a memory of its own, gone through by hand.
use bessemer::prelude::*;

#[function]
pub fn stepped_by_hand(values: &[u8; 6]) -> u8 {
    let mut left = values.iter().skip_while(|value| **value == 0);
    let first = left.next().copied().unwrap_or(0);
    first ^ left.next().copied().unwrap_or(0)
}
