//! Iterators whose items are taken from both ends by `next` and `next_back`, in loops and beside a clone, and their `len`.

use bessemer::prelude::*;

#[function]
fn mixed(sum: u32, item: Option<u32>) -> u32 {
    match item {
        Some(x) => sum.wrapping_mul(31).wrapping_add(x),
        None => sum ^ 5,
    }
}

#[function]
fn tame(a: [u32; 5]) -> [u32; 5] {
    [a[0] % 8, a[1] % 8, a[2] % 3, a[3], a[4] % 5]
}

#[function]
pub fn elements(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter();
    let mut sum = mixed(7, it.next_back().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| *x));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(*x));
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next_back().map(|x| *x))
}

#[function]
pub fn elements_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter();
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(*x));
    }
    sum
}

#[function]
pub fn mapped(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map(|x| *x ^ 1);
    let mut sum = mixed(7, it.next_back().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| x));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(x));
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next_back().map(|x| x))
}

#[function]
pub fn mapped_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map(|x| *x ^ 1);
    let mut sum = mixed(7, it.next().map(|x| x));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(x));
    }
    sum
}

#[function]
pub fn filtered(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2);
    let mut sum = mixed(7, it.next_back().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(*x));
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next_back().map(|x| *x))
}

#[function]
pub fn filtered_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2);
    let mut sum = mixed(7, it.next().map(|x| *x));
    for x in it.rev() {
        sum = mixed(sum, Some(*x));
    }
    sum
}

#[function]
pub fn copied(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().copied();
    let mut sum = mixed(7, it.next_back().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| x));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(x));
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next_back().map(|x| x))
}

#[function]
pub fn copied_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().copied();
    let mut sum = mixed(7, it.next().map(|x| x));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(x));
    }
    sum
}

#[function]
pub fn numbered(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().enumerate();
    let mut sum = mixed(7, it.next_back().map(|x| x.1 ^ x.0 as u32));
    sum = mixed(sum, it.next().map(|x| x.1 ^ x.0 as u32));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| x.1 ^ x.0 as u32));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for (i, y) in copy {
        sum = mixed(sum, Some(y ^ i as u32));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(x.1 ^ x.0 as u32));
        sum = mixed(sum, it.next().map(|x| x.1 ^ x.0 as u32));
    }
    mixed(sum, it.next_back().map(|x| x.1 ^ x.0 as u32))
}

#[function]
pub fn numbered_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().enumerate();
    let mut sum = mixed(7, it.next().map(|x| x.1 ^ x.0 as u32));
    sum ^= it.len() as u32;
    for (i, y) in it.rev() {
        sum = mixed(sum, Some(y ^ i as u32));
    }
    sum
}

#[function]
pub fn parts(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 5));
    let mut it = a[n..].iter();
    let mut sum = mixed(7, it.next_back().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| *x));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(*x));
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next_back().map(|x| *x))
}

#[function]
pub fn parts_reversed(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 5));
    let mut it = a[n..].iter();
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(*x));
    }
    sum
}

#[function]
pub fn filtered_map(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter_map(|x| (*x != 2).then_some(*x ^ 3));
    let mut sum = mixed(7, it.next_back().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(x));
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next_back().map(|x| x))
}

#[function]
pub fn filtered_map_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter_map(|x| (*x != 2).then_some(*x ^ 3));
    let mut sum = mixed(7, it.next().map(|x| x));
    for x in it.rev() {
        sum = mixed(sum, Some(x));
    }
    sum
}

#[function]
pub fn from_the_end(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().rev();
    let mut sum = mixed(7, it.next_back().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| *x));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(*x));
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next_back().map(|x| *x))
}

#[function]
pub fn from_the_end_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().rev();
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(*x));
    }
    sum
}

#[function]
pub fn pairs(a: [u32; 5], b: [u32; 4]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().zip(b.iter());
    let mut sum = mixed(7, it.next_back().map(|x| *x.0 ^ *x.1));
    sum = mixed(sum, it.next().map(|x| *x.0 ^ *x.1));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| *x.0 ^ *x.1));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for (y, z) in copy {
        sum = mixed(sum, Some(*y ^ *z));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(*x.0 ^ *x.1));
        sum = mixed(sum, it.next().map(|x| *x.0 ^ *x.1));
    }
    mixed(sum, it.next_back().map(|x| *x.0 ^ *x.1))
}

#[function]
pub fn pairs_reversed(a: [u32; 5], b: [u32; 4]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().zip(b.iter());
    let mut sum = mixed(7, it.next().map(|x| *x.0 ^ *x.1));
    sum ^= it.len() as u32;
    for (y, z) in it.rev() {
        sum = mixed(sum, Some(*y ^ *z));
    }
    sum
}

#[function]
pub fn windows(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.windows(2);
    let mut sum = mixed(7, it.next_back().map(|x| x[0] ^ x[1]));
    sum = mixed(sum, it.next().map(|x| x[0] ^ x[1]));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| x[0] ^ x[1]));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(x[0] ^ x[1]));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(x[0] ^ x[1]));
        sum = mixed(sum, it.next().map(|x| x[0] ^ x[1]));
    }
    mixed(sum, it.next_back().map(|x| x[0] ^ x[1]))
}

#[function]
pub fn windows_reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.windows(2);
    let mut sum = mixed(7, it.next().map(|x| x[0] ^ x[1]));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(x[0] ^ x[1]));
    }
    sum
}

#[function]
pub fn numbers(n: u8) -> u32 {
    let n = usize::from(n % 6);
    let mut it = (0..n as u32).map(|x| x ^ 3);
    let mut sum = mixed(7, it.next_back().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let mut copy = it.clone();
    sum = mixed(sum, copy.next_back().map(|x| x));
    sum ^= (it.len() * 64 + copy.len()) as u32;
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    while let Some(x) = it.next_back() {
        sum = mixed(sum, Some(x));
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next_back().map(|x| x))
}

#[function]
pub fn numbers_reversed(n: u8) -> u32 {
    let n = usize::from(n % 6);
    let mut it = (0..n as u32).map(|x| x ^ 3);
    let mut sum = mixed(7, it.next().map(|x| x));
    sum ^= it.len() as u32;
    for x in it.rev() {
        sum = mixed(sum, Some(x));
    }
    sum
}
