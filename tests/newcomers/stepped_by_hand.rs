//! An iterator over the parts of parts, of which single items are taken.
use bessemer::prelude::*;

#[function]
pub fn stepped_by_hand(values: &[u8; 6]) -> u8 {
    let mut left = values.chunks(2).flat_map(|pair| pair.iter());
    let first = left.next().copied().unwrap_or(0);
    first ^ left.next().copied().unwrap_or(0)
}
