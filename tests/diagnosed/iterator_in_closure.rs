//! An iterator that a closure takes along.
use bessemer::prelude::*;

#[function]
fn once_with<F: FnOnce(u32) -> u32>(f: F, start: u32) -> u32 {
    f(start)
}

#[function]
pub fn iterator_in_closure(values: &[u8; 8]) -> u32 {
    let items = values.iter().copied();
    once_with(|start| items.fold(start, |sum, item| sum ^ u32::from(item)), 1)
}
