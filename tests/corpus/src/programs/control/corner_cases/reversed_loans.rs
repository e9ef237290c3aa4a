//! Items that `by_ref().rev()` takes from the end, between items from the beginning.

use bessemer::prelude::*;

#[function]
fn mixed(sum: u32, item: Option<u32>) -> u32 {
    match item {
        Some(x) => sum.wrapping_mul(31).wrapping_add(x),
        None => sum ^ 5,
    }
}

#[function]
pub fn elements(a: [u32; 5]) -> u32 {
    let mut it = a.iter();
    let mut sum = mixed(7, it.next().map(|x| *x));
    for x in it.by_ref().rev() {
        sum = mixed(sum, Some(*x));
        if sum % 2 == 0 {
            break;
        }
    }
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    mixed(sum, it.next_back().map(|x| *x))
}

#[function]
pub fn elements_searched(a: [u32; 5]) -> u32 {
    let mut it = a.iter();
    let mut sum = mixed(7, it.by_ref().rev().find(|x| **x % 5 > 1).map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    sum = mixed(sum, it.by_ref().rev().next().map(|x| *x));
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn elements_limited(a: [u32; 5]) -> u32 {
    let mut it = a.iter();
    let mut sum = 7;
    for x in it.by_ref().rev().take(2) {
        sum = mixed(sum, Some(*x));
    }
    for x in it {
        sum = mixed(sum, Some(*x));
    }
    sum
}

#[function]
pub fn mapped(a: [u32; 5]) -> u32 {
    let mut it = a.iter().map(|x| *x ^ 1);
    let mut sum = mixed(7, it.next().map(|x| x));
    for x in it.by_ref().rev() {
        sum = mixed(sum, Some(x));
        if sum % 2 == 0 {
            break;
        }
    }
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    mixed(sum, it.next_back().map(|x| x))
}

#[function]
pub fn mapped_searched(a: [u32; 5]) -> u32 {
    let mut it = a.iter().map(|x| *x ^ 1);
    let mut sum = mixed(7, it.by_ref().rev().find(|x| *x % 5 > 1).map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    sum = mixed(sum, it.by_ref().rev().next().map(|x| x));
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn mapped_limited(a: [u32; 5]) -> u32 {
    let mut it = a.iter().map(|x| *x ^ 1);
    let mut sum = 7;
    for x in it.by_ref().rev().take(2) {
        sum = mixed(sum, Some(x));
    }
    for x in it {
        sum = mixed(sum, Some(x));
    }
    sum
}

#[function]
pub fn sifted(a: [u32; 5]) -> u32 {
    let mut it = a.iter().filter(|x| **x % 3 != 0);
    let mut sum = mixed(7, it.next().map(|x| *x));
    for x in it.by_ref().rev() {
        sum = mixed(sum, Some(*x));
        if sum % 2 == 0 {
            break;
        }
    }
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    mixed(sum, it.next_back().map(|x| *x))
}

#[function]
pub fn sifted_searched(a: [u32; 5]) -> u32 {
    let mut it = a.iter().filter(|x| **x % 3 != 0);
    let mut sum = mixed(7, it.by_ref().rev().find(|x| **x % 5 > 1).map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    sum = mixed(sum, it.by_ref().rev().next().map(|x| *x));
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn sifted_limited(a: [u32; 5]) -> u32 {
    let mut it = a.iter().filter(|x| **x % 3 != 0);
    let mut sum = 7;
    for x in it.by_ref().rev().take(2) {
        sum = mixed(sum, Some(*x));
    }
    for x in it {
        sum = mixed(sum, Some(*x));
    }
    sum
}

#[function]
pub fn pairs(a: [u32; 5], b: [u32; 5]) -> u32 {
    let mut it = a.iter().zip(b.iter()).map(|(x, y)| *x ^ *y);
    let mut sum = mixed(7, it.next().map(|x| x));
    for x in it.by_ref().rev() {
        sum = mixed(sum, Some(x));
        if sum % 2 == 0 {
            break;
        }
    }
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    mixed(sum, it.next_back().map(|x| x))
}

#[function]
pub fn pairs_searched(a: [u32; 5], b: [u32; 5]) -> u32 {
    let mut it = a.iter().zip(b.iter()).map(|(x, y)| *x ^ *y);
    let mut sum = mixed(7, it.by_ref().rev().find(|x| *x % 5 > 1).map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    sum = mixed(sum, it.by_ref().rev().next().map(|x| x));
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn pairs_limited(a: [u32; 5], b: [u32; 5]) -> u32 {
    let mut it = a.iter().zip(b.iter()).map(|(x, y)| *x ^ *y);
    let mut sum = 7;
    for x in it.by_ref().rev().take(2) {
        sum = mixed(sum, Some(x));
    }
    for x in it {
        sum = mixed(sum, Some(x));
    }
    sum
}
