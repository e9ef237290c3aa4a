//! An author's free function named `iter`, next to loops over a list and an option.

#![allow(missing_docs, for_loops_over_fallibles)]

use bessemer::prelude::*;

#[function]
fn iter(n: u8) -> impl Iterator<Item = u8> {
    (0..n % 9).map(|x| x * 2)
}

#[function]
pub fn gone_through(n: u8, last: Option<u8>) -> (u32, u32) {
    let mut list: List<u8, 8> = List::new();
    for x in iter(n) {
        list.push(x);
    }
    let (mut sum, mut more) = (0, 0);
    for x in &list {
        sum += u32::from(*x);
    }
    for x in last {
        more += u32::from(x);
    }
    (sum, more)
}
