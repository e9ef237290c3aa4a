//! Iterators that a closure makes: `from_fn` and `successors`, in chains and by explicit `next` calls.

use bessemer::prelude::*;

#[function]
pub fn made(n: u32, k: u8) -> u32 {
    let mut left = n;
    let mut it = core::iter::from_fn(|| {
        left = left.wrapping_add(3);
        (left % 5 != 0).then_some(left)
    });
    let mut sum = 7_u32;
    for _ in 0..4 {
        sum = sum.wrapping_mul(31).wrapping_add(it.next().unwrap_or(1));
    }
    for x in it.take(usize::from(k % 4)) {
        sum = sum.wrapping_mul(31).wrapping_add(x);
    }
    sum ^ left
}

#[function]
pub fn following(n: u32, k: u8) -> u32 {
    let mut it = core::iter::successors(Some(n), |x| x.checked_mul(2));
    let mut sum = it.next().unwrap_or(3);
    let copy = it.clone();
    sum ^= it.next().unwrap_or(4);
    for (i, x) in it.take(usize::from(k % 4)).enumerate() {
        sum = sum.wrapping_mul(31).wrapping_add(x ^ i as u32);
    }
    for x in copy.skip(1).take(3) {
        sum = sum.wrapping_mul(31).wrapping_add(x);
    }
    sum
}
