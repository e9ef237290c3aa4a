//! Adapters with state whose items are taken by explicit `next` calls. Each loop continues where the last one was left,
//! also after a `None`, and a clone has a copy of the state.

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
fn first_ones(items: impl Iterator<Item = u32> + Clone, n: usize) -> impl Iterator<Item = u32> + Clone {
    items.take(n).map(|item| item ^ 1)
}

#[function]
pub fn scanned(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().scan(1_u32, |sum, x| {
        *sum = sum.wrapping_add(*x);
        (*sum % 5 != 0).then_some(*sum)
    });
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn scanned_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().scan(1_u32, |sum, x| {
        *sum = sum.wrapping_add(*x);
        (*sum % 5 != 0).then_some(*sum)
    });
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn skipped_while(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().skip_while(|x| **x > 3).map(|x| *x);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn skipped_while_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().skip_while(|x| **x > 3).map(|x| *x);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn taken_while(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().take_while(|x| **x != 2).map(|x| *x);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn taken_while_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().take_while(|x| **x != 2).map(|x| *x);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn mapped_while(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map_while(|x| (*x != 2).then_some(*x ^ 1));
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn mapped_while_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map_while(|x| (*x != 2).then_some(*x ^ 1));
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn skipped(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x ^ 1).skip(n);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn skipped_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x ^ 1).skip(n);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn taken(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x ^ 1).take(n);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn taken_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x ^ 1).take(n);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn stepped(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x ^ 1).step_by(n + 1);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn stepped_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x ^ 1).step_by(n + 1);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn numbered(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2).enumerate().map(|(i, x)| *x ^ i as u32);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn numbered_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2).enumerate().map(|(i, x)| *x ^ i as u32);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn reversed(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map(|x| *x ^ 1).rev();
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn reversed_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map(|x| *x ^ 1).rev();
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn reversed_filter(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2).map(|x| *x ^ 1).rev();
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn reversed_filter_left(a: [u32; 5]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2).map(|x| *x ^ 1).rev();
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn joined(a: [u32; 5], b: [u32; 4]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().map(|x| *x ^ 1).chain(b.iter().map(|x| *x ^ 2));
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn zipped(a: [u32; 5], b: [u32; 4]) -> u32 {
    let a = tame(a);
    let mut it = a.iter().filter(|x| **x != 2).zip(b.iter().map(|x| *x ^ 2)).map(|(x, y)| *x ^ y);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn skipped_filter(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().filter(|x| **x != 2).skip(n).map(|x| *x);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn skipped_filter_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().filter(|x| **x != 2).skip(n).map(|x| *x);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn taken_scan(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().scan(n as u32, |sum, x| {
        *sum = sum.wrapping_add(*x);
        (*sum % 5 != 0).then_some(*sum)
    })
    .take(n + 1);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn taken_scan_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().scan(n as u32, |sum, x| {
        *sum = sum.wrapping_add(*x);
        (*sum % 5 != 0).then_some(*sum)
    })
    .take(n + 1);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn scanned_skip(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x).skip(n).scan(1_u32, |sum, x| {
        *sum = sum.wrapping_add(x);
        Some(*sum)
    });
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn scanned_skip_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x).skip(n).scan(1_u32, |sum, x| {
        *sum = sum.wrapping_add(x);
        Some(*sum)
    });
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

#[function]
pub fn joined_parts(a: [u32; 5], b: [u32; 4], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = a.iter().map(|x| *x).skip(n).chain(b.iter().map(|x| *x).take(n));
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn generated(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = first_ones(a.iter().map(|x| *x), n);
    let mut sum = mixed(7, it.next());
    let copy = it.clone();
    sum = mixed(sum, it.next());
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    let again = it.clone();
    for x in it.by_ref().take(1) {
        sum = mixed(sum, Some(x));
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next());
    }
    sum ^ again.fold(3, |all, x| mixed(all, Some(x)))
}

#[function]
pub fn generated_left(a: [u32; 5], n: u8) -> u32 {
    let (a, n) = (tame(a), usize::from(n % 4));
    let mut it = first_ones(a.iter().map(|x| *x), n);
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(x));
        if x % 2 == 0 {
            sum = mixed(sum, it.next());
        }
    }
    mixed(sum, it.next())
}

/// Leaves out the first item of an iterator.
#[function]
fn behind_first<I: Iterator<Item = u32>>(items: I) -> impl Iterator<Item = u32> + use<I> {
    items.skip(1).map(|x| x ^ 1)
}

/// Items of a function that leaves one out, taken one by one.
#[function]
pub fn left_out(a: [u32; 5], n: u8) -> u32 {
    let mut it = behind_first(a.iter().copied());
    let mut sum = it.next().unwrap_or(3);
    if n % 2 == 0 {
        sum = sum.wrapping_mul(5) ^ it.next().unwrap_or(7);
    }
    it.fold(sum, |sum, x| sum.wrapping_mul(3) ^ x)
}
