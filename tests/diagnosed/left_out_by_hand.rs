//! Functions that lack a part of iterators with explicit `next` calls.
use bessemer::prelude::*;

#[function]
fn first_three(items: impl Iterator<Item = u8>) -> impl Iterator<Item = u8> {
    items.take(3).map(|item| item ^ 1)
}

#[function]
pub fn left_out_by_hand(values: &[u8; 8]) -> [Option<u8>; 2] {
    let mut items = first_three(values.iter().copied());
    [items.next(), items.next()]
}
