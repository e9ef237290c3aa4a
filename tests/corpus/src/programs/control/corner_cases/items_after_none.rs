//! Iterators that yield items again after a `None`, under the adapters with a state of their own.

use bessemer::prelude::*;

#[function]
fn mixed(sum: u32, item: Option<u32>) -> u32 {
    match item {
        Some(x) => sum.wrapping_mul(31).wrapping_add(x),
        None => sum ^ 5,
    }
}

#[function]
pub fn while_mapped_skip(a: [u32; 6]) -> u32 {
    let mut it = a.iter().map_while(|x| x.checked_sub(1000)).skip(2);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn while_mapped_step(a: [u32; 6]) -> u32 {
    let mut it = a.iter().map_while(|x| x.checked_sub(1000)).step_by(2);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn while_mapped_chain(a: [u32; 6]) -> u32 {
    let mut it = a.iter().map_while(|x| x.checked_sub(1000)).chain([1, 2]);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn while_mapped_skip_step(a: [u32; 6]) -> u32 {
    let mut it = a.iter().map_while(|x| x.checked_sub(1000)).skip(1).step_by(3);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn while_mapped_chain_skip(a: [u32; 6]) -> u32 {
    let mut it = a.iter().map_while(|x| x.checked_sub(1000)).chain([1, 2]).skip(3);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn while_mapped_step_chain(a: [u32; 6]) -> u32 {
    let mut it = a.iter().map_while(|x| x.checked_sub(1000)).step_by(2).chain([8]);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn scanned_skip(a: [u32; 6]) -> u32 {
    let mut it = a
        .iter()
        .scan(3, |s, x| {
            *s ^= *x;
            (*s % 4 != 0).then_some(*s)
        })
        .skip(2);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn scanned_step(a: [u32; 6]) -> u32 {
    let mut it = a
        .iter()
        .scan(3, |s, x| {
            *s ^= *x;
            (*s % 4 != 0).then_some(*s)
        })
        .step_by(2);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn scanned_chain(a: [u32; 6]) -> u32 {
    let mut it = a
        .iter()
        .scan(3, |s, x| {
            *s ^= *x;
            (*s % 4 != 0).then_some(*s)
        })
        .chain([1, 2]);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn scanned_skip_step(a: [u32; 6]) -> u32 {
    let mut it = a
        .iter()
        .scan(3, |s, x| {
            *s ^= *x;
            (*s % 4 != 0).then_some(*s)
        })
        .skip(1)
        .step_by(3);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn scanned_chain_skip(a: [u32; 6]) -> u32 {
    let mut it = a
        .iter()
        .scan(3, |s, x| {
            *s ^= *x;
            (*s % 4 != 0).then_some(*s)
        })
        .chain([1, 2])
        .skip(3);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn scanned_step_chain(a: [u32; 6]) -> u32 {
    let mut it = a
        .iter()
        .scan(3, |s, x| {
            *s ^= *x;
            (*s % 4 != 0).then_some(*s)
        })
        .step_by(2)
        .chain([8]);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn made_skip(a: u32) -> u32 {
    let mut k = a;
    let mut it = core::iter::from_fn(move || {
        k = k.wrapping_mul(5).wrapping_add(1);
        (k % 4 != 0).then_some(k)
    })
    .skip(2);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn made_step(a: u32) -> u32 {
    let mut k = a;
    let mut it = core::iter::from_fn(move || {
        k = k.wrapping_mul(5).wrapping_add(1);
        (k % 4 != 0).then_some(k)
    })
    .step_by(2);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn made_chain(a: u32) -> u32 {
    let mut k = a;
    let mut it = core::iter::from_fn(move || {
        k = k.wrapping_mul(5).wrapping_add(1);
        (k % 4 != 0).then_some(k)
    })
    .chain([1, 2]);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn made_skip_step(a: u32) -> u32 {
    let mut k = a;
    let mut it = core::iter::from_fn(move || {
        k = k.wrapping_mul(5).wrapping_add(1);
        (k % 4 != 0).then_some(k)
    })
    .skip(1)
    .step_by(3);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn made_chain_skip(a: u32) -> u32 {
    let mut k = a;
    let mut it = core::iter::from_fn(move || {
        k = k.wrapping_mul(5).wrapping_add(1);
        (k % 4 != 0).then_some(k)
    })
    .chain([1, 2])
    .skip(3);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn made_step_chain(a: u32) -> u32 {
    let mut k = a;
    let mut it = core::iter::from_fn(move || {
        k = k.wrapping_mul(5).wrapping_add(1);
        (k % 4 != 0).then_some(k)
    })
    .step_by(2)
    .chain([8]);
    let mut sum = 7;
    for _ in 0..5 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    for x in it.by_ref().take(2) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}

#[function]
pub fn first_again(a: [u32; 3]) -> u32 {
    let mut it = a.into_iter().chain([a[1], 4].into_iter().map_while(|x| x.checked_sub(900)));
    let mut sum = 7;
    for _ in 0..8 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    sum
}
