//! Numbers of calls of closures in comparisons of iterators, and in a `zip` of iterators with names, for all lengths of both
//! sides. The counts of the calls are in the result.

use bessemer::prelude::*;

#[function]
fn tick(count: &mut u32, item: u8) {
    *count = count.wrapping_mul(7).wrapping_add(u32::from(item | 1));
}

#[function]
fn note(count: &mut u32, item: u8) -> u32 {
    tick(count, item);
    u32::from(item)
}

#[function]
fn mixed(so_far: u32, item: u32) -> u32 {
    so_far.wrapping_mul(31).wrapping_add(item)
}

/// `eq` and `ne` of known lengths compare these first, and call nothing if they differ.
#[function]
pub fn compared(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (p, q) = (p.map(|x| x % 3), q.map(|x| x % 3));
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = (0..m).map(|x| note(&mut e, x));
    r = mixed(r, u32::from(one.ne(other)));
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().chain(d.iter()).map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = (1..=m).map(|x| note(&mut e, x));
    r = mixed(r, u32::from(one.ne(other)));
    let one = a.iter().take(3).map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| note(&mut c, *x)).enumerate().map(|(i, x)| x ^ i as u32);
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.ne(other)));
    let one = a.iter().map(|x| note(&mut c, *x)).zip(d).map(|(x, y)| x ^ u32::from(*y));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = q.into_iter().map(|x| note(&mut e, x));
    r = mixed(r, u32::from(one.ne(other)));

    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Unknown lengths, and the comparisons by order, which take item after item.
#[function]
pub fn compared_one_by_one(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (p, q) = (p.map(|x| x % 3), q.map(|x| x % 3));
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().filter(|x| note(&mut e, **x) < 200).map(|x| u32::from(*x));
    r = mixed(r, u32::from(one.ne(other)));
    let one = a.iter().inspect(|x| tick(&mut c, **x)).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.eq(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.lt(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().rev().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.ge(other)));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.le(other)));
    let one = (0..k).map(|x| note(&mut c, x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, u32::from(one.gt(other)));

    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Iterators with names, in a function, and behind `by_ref`.
#[function]
pub fn under_names(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = one.map(|x| x ^ 1).enumerate();
    for ((i, x), y) in other.zip(b) { r = mixed(r, x ^ u32::from(*y) ^ i as u32); }
    r = mixed(r, taken(a.iter().map(|x| note(&mut c, *x)), b));
    r = mixed(r, taken_by_reference(&mut a.iter().map(|x| note(&mut c, *x)), b));
    let mut one = a.iter().map(|x| note(&mut c, *x));
    r = mixed(r, taken_by_reference(&mut one, b));
    r = mixed(r, one.next().unwrap_or(5));
    for (x, y) in one.by_ref().zip(b) { r = mixed(r, x ^ u32::from(*y)); }
    r = mixed(r, one.next().unwrap_or(5));
    r = mixed(r, gathered(a.iter().map(|x| note(&mut c, *x)).zip(b).map(|(x, y)| x ^ u32::from(*y))));
    r = mixed(r, gathered(a.iter().map(|x| note(&mut c, *x)).zip(b.iter().rev().map(|x| note(&mut e, *x))).map(|(x, y)| x ^ y)));
    r = mixed(r, e);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

#[function]
fn taken(items: impl Iterator<Item = u32>, b: &[u8]) -> u32 {
    let mut r = 1_u32;
    for (x, y) in items.zip(b) { r = mixed(r, x ^ u32::from(*y)); }
    r
}

#[function]
fn taken_by_reference(items: &mut impl Iterator<Item = u32>, b: &[u8]) -> u32 {
    let mut r = 1_u32;
    for (x, y) in items.zip(b) { r = mixed(r, x ^ u32::from(*y)); }
    r
}

#[function]
fn gathered(items: impl IntoIterator<Item = u32>) -> u32 {
    let mut r = 1_u32;
    for x in items { r = mixed(r, x); }
    r
}

/// Three side by side, and a loop that ends early.
#[function]
pub fn nested(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for ((x, y), z) in a.iter().map(|x| note(&mut c, *x)).zip(b.iter().map(|x| note(&mut e, *x))).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    for ((x, y), z) in a.iter().map(|x| note(&mut c, *x)).zip(b.iter().rev()).zip(d) { r = mixed(r, x ^ u32::from(*y ^ *z)); }
    for (x, y) in a.iter().map(|x| note(&mut c, *x)).zip(b.iter().map(|x| note(&mut e, *x))) {
        if x > y { continue; }
        if x == 7 { break; }
        r = mixed(r, x ^ y);
    }
    for (x, y) in a.iter().map(|x| note(&mut c, *x)).zip(o) { r = mixed(r, x ^ u32::from(y)); }
    let mut f = p;
    for (x, y) in f.iter_mut().map(|x| { *x = x.wrapping_add(1); tick(&mut c, *x); x }).zip(b) { *x ^= *y; }
    r = f.iter().fold(r, |r: u32, x| mixed(r, u32::from(*x)));
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// The result of a function.
#[function]
pub fn at_the_end(p: [u8; 5], q: [u8; 4], k: u8, m: u8, calls: &mut u32) -> bool {
    let (a, b) = (&p[..usize::from(k % 6)], &q[..usize::from(m % 5)]);
    a.iter().map(|x| note(calls, *x % 2)).eq(b.iter().map(|x| u32::from(*x % 2)))
}

/// A statement of its own, for its calls.
#[function]
pub fn for_its_calls(p: [u8; 5], q: [u8; 4], k: u8, m: u8) -> u32 {
    let (a, b) = (&p[..usize::from(k % 6)], &q[..usize::from(m % 5)]);
    let mut calls = 0_u32;
    let _ = a.iter().map(|x| note(&mut calls, *x % 2)).eq(b.iter().map(|x| u32::from(*x % 2)));
    calls
}
