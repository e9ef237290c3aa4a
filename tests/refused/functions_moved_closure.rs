//! `move` closures in a statement that may write their variable through something else.

use bessemer::prelude::*;

#[function]
fn twice(f: impl Fn() -> u32) -> u32 {
    f() ^ f()
}

#[function]
fn changed(x: &mut u32) -> u32 {
    *x ^= 9;
    *x
}

#[function]
pub fn through_a_closure(a: u32) -> u32 {
    let mut n = a;
    let mut step = || {
        n += 3;
        n
    };
    step() ^ twice(move || n)
}

#[function]
pub fn through_an_iterator(a: [u32; 4]) -> u32 {
    let mut n = 0;
    let mut it = a.iter().map(|x| {
        n ^= *x;
        n
    });
    it.next().unwrap_or(1) ^ twice(move || n)
}

#[function]
pub fn through_a_reference(a: u32) -> u32 {
    let mut n = a;
    let m = &mut n;
    changed(m) ^ twice(move || n)
}

#[function]
pub fn through_a_reference_of_a_reference(a: u32) -> u32 {
    let mut n = a;
    let m = &mut n;
    let k = m;
    changed(k) ^ twice(move || n)
}

#[function]
pub fn through_a_reference_that_is_assigned(a: u32) -> u32 {
    let mut n = a;
    let m;
    m = &mut n;
    changed(m) ^ twice(move || n)
}

#[function]
pub fn through_a_pattern(a: u32) -> u32 {
    let mut n = [a; 2];
    match n {
        [ref mut m, _] => changed(m) ^ twice(move || n[0]),
    }
}

#[function]
pub fn through_an_element(a: u32) -> u32 {
    let mut n = [a; 2];
    if let Some(m) = n.first_mut() {
        return changed(m) ^ twice(move || n[0]);
    }
    0
}
