//! Options as iterators beside other adapters: at most one item, by value, by reference and in place.

use bessemer::prelude::*;

#[function]
pub fn numbered_option(o: Option<u32>, k: u32) -> u32 {
    let mut sum = k;
    for (i, x) in o.into_iter().enumerate() {
        sum = sum.wrapping_mul(31).wrapping_add(x ^ i as u32);
    }
    for (i, x) in o.iter().enumerate() {
        sum = sum.wrapping_mul(31).wrapping_add(*x ^ i as u32);
    }
    sum
}

#[function]
pub fn option_in_place(mut o: Option<u32>, k: u32) -> (Option<u32>, u32) {
    let mut sum = k;
    for (i, x) in o.iter_mut().enumerate() {
        *x = x.wrapping_add(1);
        sum ^= i as u32;
    }
    for x in o.into_iter().rev() {
        o = None;
        sum = sum.wrapping_mul(31).wrapping_add(x);
    }
    (o, sum)
}

#[function]
pub fn option_beside(o: Option<u32>, a: [u32; 3], k: u8) -> u32 {
    let mut sum = 7_u32;
    for (x, y) in a.iter().zip(o) {
        sum = sum.wrapping_mul(31).wrapping_add(*x ^ y);
    }
    for (x, y) in o.iter().zip(a.iter()) {
        sum = sum.wrapping_mul(31).wrapping_add(*x ^ *y);
    }
    for x in o.iter().skip(usize::from(k % 2)) {
        sum = sum.wrapping_mul(31).wrapping_add(*x);
    }
    for x in o.into_iter().take(usize::from(k % 3)) {
        sum = sum.wrapping_mul(31).wrapping_add(x);
    }
    sum
}

#[function]
pub fn option_item(o: Option<u32>) -> u32 {
    let mut it = o.into_iter();
    let mut sum = 7_u32;
    if let Some(x) = it.next() {
        sum = sum.wrapping_mul(31).wrapping_add(x);
    }
    sum ^= u32::from(it.next().is_some());
    sum
}
