//! Items taken as lengths say, of an iterator that goes on.
use bessemer::prelude::*;

#[function]
pub fn taken_by_length(values: &[u8; 8], k: u8) -> usize {
    let mut items = values.iter();
    let pairs = items.by_ref().zip(0..k).count();
    pairs + items.count()
}

#[function]
pub fn compared_by_length(values: &[u8; 8], k: u8) -> usize {
    let mut items = values.iter().copied();
    usize::from(items.by_ref().eq([k; 3])) + items.count()
}
