//! Parts of the halves of one array, which a check at run time alone keeps apart.
#![no_std]
use bessemer::prelude::*;

/// The first of the higher ones comes below.
#[function]
pub fn merge(low: &mut [u8], high: &mut [u8]) {
    if let (Some(low), Some(high)) = (low.first_mut(), high.first_mut()) {
        core::mem::swap(low, high);
    }
}

/// A part of the lower half, which ends where the author says, beside the whole of the other.
#[function]
pub fn part_of_half(values: &mut [u8; 8], n: usize, k: usize) {
    let (low, high) = values.split_at_mut(n);
    merge(&mut low[..k], high);
}

/// A part that begins within the higher half is behind the lower one, whatever the numbers are.
#[function]
pub fn behind(values: &mut [u8; 8], n: usize, k: usize) {
    let (low, high) = values.split_at_mut(n);
    merge(low, &mut high[k..]);
}
