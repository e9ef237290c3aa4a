//! Iterators that lack a part of explicit `next` and `next_back` calls.
use bessemer::prelude::*;

#[function]
fn of_pairs(items: impl Iterator<Item = u8>) -> impl Iterator<Item = u8> {
    items.flat_map(|item| [item, item ^ 1])
}

/// An iterator over parts.
#[function]
pub fn left_out_by_hand(values: &[u8; 8]) -> [Option<u8>; 2] {
    let mut items = of_pairs(values.iter().copied());
    [items.next(), items.next()]
}

/// Parts of items that a closure makes, which are not made again.
#[function]
pub fn made(values: &[u8; 8]) -> [Option<u8>; 2] {
    let mut k = 0;
    let next = || {
        k += 1;
        values.get(k).copied()
    };
    let mut items = core::iter::from_fn(next).flat_map(|x| [x, x ^ 1]);
    [items.next(), items.next()]
}

/// An adapter with state has no items from its end.
#[function]
pub fn from_the_end(values: &[u8; 8]) -> bool {
    let mut items = values.iter().map(|x| *x).step_by(2);
    items.next_back() == items.next()
}

/// The number of items that a condition keeps is not known.
#[function]
pub fn numbered(values: &[u8; 8]) -> usize {
    let items = values.iter().map(|x| *x).step_by(2);
    items.len()
}
