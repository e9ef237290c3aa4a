//! Clones of iterators and of chains: items that the original yields afterwards are still in the clone.
//!
//! There is one function for each adapter; each has a clone with a name, one as an argument, one that is cloned
//! again, and a loop whose body advances the original.

use bessemer::prelude::*;

#[function]
fn eaten(it: impl Iterator<Item = u32>) -> u32 {
    let mut sum = 7_u32;
    for x in it {
        sum = sum.wrapping_mul(31).wrapping_add(x);
    }
    sum
}

#[function]
fn tame(a: [u32; 5]) -> [u32; 5] {
    [a[0] % 8, a[1] % 8, a[2] % 3, a[3], a[4] % 5]
}

/// A clone as the second argument of a `zip`, and of a `chain`.
#[function]
pub fn beside(a: [u32; 5], b: [u32; 4]) -> u32 {
    let mut it = a.iter();
    let zipped = b.iter().zip(it.clone()).map(|(y, x)| *x ^ *y);
    let mut r = it.next().map_or(1, |x| *x);
    let joined = b.iter().chain(it.clone()).map(|x| *x);
    r ^= it.next().map_or(1, |x| *x);
    for (y, x) in b.iter().zip(it.clone()) {
        r = r.wrapping_mul(31).wrapping_add(*x ^ *y);
        r ^= it.next().map_or(3, |x| *x);
    }
    r ^ eaten(zipped) ^ eaten(joined).wrapping_mul(3)
}

/// A clone of an adapter, and of a chain made from a clone.
#[function]
pub fn of_adapters(a: [u32; 5]) -> u32 {
    let mut it = a.iter().map(|x| *x ^ 1);
    let all = it.clone().map(|x| x ^ 2);
    let mut r = it.next().unwrap_or(3);
    let mut odd = a.iter().rev().filter(|x| **x % 2 == 1);
    let odds = odd.clone().map(|x| *x);
    r = r.wrapping_mul(31) ^ odd.next().map_or(5, |x| *x);
    let more = odd.clone().enumerate().map(|(i, x)| *x ^ i as u32);
    r = r.wrapping_mul(31) ^ odd.next().map_or(5, |x| *x);
    r ^ eaten(all) ^ eaten(odds).wrapping_mul(3) ^ eaten(more).wrapping_mul(5) ^ eaten(it)
}

#[function]
pub fn mapped(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().map(|x| x ^ 3);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().map(|x| x ^ 3);
    for x in it.clone().map(|x| x ^ 3) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().map(|x| x ^ 3));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn filtered(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().filter(|x| **x != 2).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().filter(|x| **x != 2).map(|x| *x);
    for x in it.clone().filter(|x| **x != 2).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().filter(|x| **x != 2).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn filter_mapped(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().filter_map(|x| if *x > 2 { Some(*x ^ 1) } else { None });
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().filter_map(|x| if *x > 2 { Some(*x ^ 1) } else { None });
    for x in it.clone().filter_map(|x| if *x > 2 { Some(*x ^ 1) } else { None }) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31)
        ^ eaten(it.clone().filter_map(|x| if *x > 2 { Some(*x ^ 1) } else { None }));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn numbered(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().enumerate().map(|(i, x)| *x ^ i as u32);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().enumerate().map(|(i, x)| *x ^ i as u32);
    for x in it.clone().enumerate().map(|(i, x)| *x ^ i as u32) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().enumerate().map(|(i, x)| *x ^ i as u32));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn zipped(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().zip(b.iter()).map(|(x, y)| *x ^ *y);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().zip(b.iter()).map(|(x, y)| *x ^ *y);
    for x in it.clone().zip(b.iter()).map(|(x, y)| *x ^ *y) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().zip(b.iter()).map(|(x, y)| *x ^ *y));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn chained(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().chain(b.iter()).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().chain(b.iter()).map(|x| *x);
    for x in it.clone().chain(b.iter()).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().chain(b.iter()).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn skipped(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().skip(1).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().skip(1).map(|x| *x);
    for x in it.clone().skip(1).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().skip(1).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn taken(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().map(|x| *x ^ 5).take(3);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().map(|x| *x ^ 5).take(3);
    for x in it.clone().map(|x| *x ^ 5).take(3) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().map(|x| *x ^ 5).take(3));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn stepped(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().step_by(2).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().step_by(2).map(|x| *x);
    for x in it.clone().step_by(2).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().step_by(2).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn taken_while(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().take_while(|x| **x != 2).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().take_while(|x| **x != 2).map(|x| *x);
    for x in it.clone().take_while(|x| **x != 2).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().take_while(|x| **x != 2).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn skipped_while(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().skip_while(|x| **x > 3).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().skip_while(|x| **x > 3).map(|x| *x);
    for x in it.clone().skip_while(|x| **x > 3).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().skip_while(|x| **x > 3).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn mapped_while(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().map_while(|x| if *x != 1 { Some(*x) } else { None });
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().map_while(|x| if *x != 1 { Some(*x) } else { None });
    for x in it.clone().map_while(|x| if *x != 1 { Some(*x) } else { None }) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().map_while(|x| if *x != 1 { Some(*x) } else { None }));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn scanned(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().scan(1_u32, |s, x| {
        *s = s.wrapping_add(*x);
        Some(*s)
    });
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().scan(1_u32, |s, x| {
        *s = s.wrapping_add(*x);
        Some(*s)
    });
    for x in it.clone().scan(1_u32, |s, x| {
        *s = s.wrapping_add(*x);
        Some(*s)
    }) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31)
        ^ eaten(it.clone().scan(1_u32, |s, x| {
            *s = s.wrapping_add(*x);
            Some(*s)
        }));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn shown(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().inspect(|_| {}).map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().inspect(|_| {}).map(|x| *x);
    for x in it.clone().inspect(|_| {}).map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().inspect(|_| {}).map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn flat(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().flat_map(|x| [*x, 1]);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().flat_map(|x| [*x, 1]);
    for x in it.clone().flat_map(|x| [*x, 1]) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().flat_map(|x| [*x, 1]));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn reversed(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().rev().map(|x| *x);
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().rev().map(|x| *x);
    for x in it.clone().rev().map(|x| *x) {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().rev().map(|x| *x));
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}

#[function]
pub fn copied(a: [u32; 5], b: [u32; 4], first: bool) -> u32 {
    let (mut r, a) = (0_u32, tame(a));
    let mut it = a.iter();
    if first {
        r = it.next().map_or(1, |x| *x);
    }
    let named = it.clone().copied();
    r ^= it.next().map_or(2, |x| *x);
    let again = named.clone();
    let between = it.clone().copied();
    for x in it.clone().copied() {
        r = r.wrapping_mul(31).wrapping_add(x);
        r ^= it.next().map_or(3, |x| *x);
    }
    r = r.wrapping_mul(31) ^ eaten(it.clone().copied());
    r = r.wrapping_mul(31) ^ named.fold(9, |sum: u32, x| sum.wrapping_mul(31).wrapping_add(x));
    r = r.wrapping_mul(31) ^ eaten(between);
    r ^ eaten(again).wrapping_mul(3) ^ it.next().map_or(4, |x| *x)
}
