//! Numbers of calls of closures on both sides of a `zip`, an `eq` and a `ne`, for all lengths of both sides.
//!
//! One function for each pair of kinds of sides: both by index, both with known lengths, and others. In each, every consumer
//! that takes items by `next` or at once. The counts of the calls are in the result.

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

/// Elements beside elements, both by index.
#[function]
pub fn elements(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().map(|x| note(&mut c, *x)).zip(b.iter().map(|x| note(&mut e, *x))) { r = mixed(r, x ^ y); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).max().unwrap_or(3));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).skip(1).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).zip(d).count() as u32);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Copied elements beside the numbers of a range.
#[function]
pub fn numbers(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().copied().map(|x| note(&mut c, x));
    let other = (0..m).map(|x| note(&mut e, x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().copied().map(|x| note(&mut c, x));
    let other = (0..m).map(|x| note(&mut e, x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).max().unwrap_or(3));
    let one = a.iter().copied().map(|x| note(&mut c, x));
    let other = (0..m).map(|x| note(&mut e, x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().copied().map(|x| note(&mut c, x));
    let other = (0..m).map(|x| note(&mut e, x));
    r = one.zip(other).skip(1).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Chunks beside windows.
#[function]
pub fn groups(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.chunks(2).map(|x| note(&mut c, x[0]));
    let other = b.windows(2).map(|x| note(&mut e, x[1]));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.chunks(2).map(|x| note(&mut c, x[0]));
    let other = b.windows(2).map(|x| note(&mut e, x[1]));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.chunks(2).map(|x| note(&mut c, x[0]));
    let other = b.windows(2).map(|x| note(&mut e, x[1]));
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = a.chunks(2).map(|x| note(&mut c, x[0]));
    let other = b.windows(2).map(|x| note(&mut e, x[1]));
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    let one = a.chunks(2).map(|x| note(&mut c, x[0]));
    let other = b.windows(2).map(|x| note(&mut e, x[1]));
    r = mixed(r, one.zip(other).zip(d).count() as u32);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Numbered items beside elements without the first.
#[function]
pub fn indexed(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().map(|x| note(&mut c, *x)).enumerate().map(|(i, x)| x ^ i as u32).zip(b.iter().skip(1).map(|x| note(&mut e, *x))) { r = mixed(r, x ^ y); }
    let one = a.iter().map(|x| note(&mut c, *x)).enumerate().map(|(i, x)| x ^ i as u32);
    let other = b.iter().skip(1).map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().map(|x| note(&mut c, *x)).enumerate().map(|(i, x)| x ^ i as u32);
    let other = b.iter().skip(1).map(|x| note(&mut e, *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().map(|x| note(&mut c, *x)).enumerate().map(|(i, x)| x ^ i as u32);
    let other = b.iter().skip(1).map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x)).enumerate().map(|(i, x)| x ^ i as u32);
    let other = b.iter().skip(1).map(|x| note(&mut e, *x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Pairs beside elements.
#[function]
pub fn pairs(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().map(|x| note(&mut c, *x)).zip(d).map(|(x, y)| x ^ u32::from(*y));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().map(|x| note(&mut c, *x)).zip(d).map(|(x, y)| x ^ u32::from(*y));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).max().unwrap_or(3));
    let one = a.iter().map(|x| note(&mut c, *x)).zip(d).map(|(x, y)| x ^ u32::from(*y));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().map(|x| note(&mut c, *x)).zip(d).map(|(x, y)| x ^ u32::from(*y));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).skip(1).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// A closure that can fault.
#[function]
pub fn faulting(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().map(|x| u32::from(100 / *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().map(|x| u32::from(100 / *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.iter().map(|x| u32::from(100 / *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = a.iter().map(|x| u32::from(100 / *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    let one = a.iter().map(|x| u32::from(100 / *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).zip(d).count() as u32);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// A closure that can fault on the second side.
#[function]
pub fn faulting_second(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().map(|x| note(&mut c, *x)).zip(b.iter().map(|x| u32::from(100 / *x))) { r = mixed(r, x ^ y); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| u32::from(100 / *x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| u32::from(100 / *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| u32::from(100 / *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| u32::from(100 / *x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// From the last element on, beside elements.
#[function]
pub fn reversed(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().rev().map(|x| note(&mut c, *x)).zip(b.iter().map(|x| note(&mut e, *x))) { r = mixed(r, x ^ y); }
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    let one = a.iter().rev().map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Elements beside an inclusive range.
#[function]
pub fn inclusive(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = (1..=m).map(|x| note(&mut e, x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = (1..=m).map(|x| note(&mut e, x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = (1..=m).map(|x| note(&mut e, x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = (1..=m).map(|x| note(&mut e, x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Both with known lengths, neither by index.
#[function]
pub fn counted(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in (1..=k).map(|x| note(&mut c, x)).zip(b.iter().rev().map(|x| note(&mut e, *x))) { r = mixed(r, x ^ y); }
    let one = (1..=k).map(|x| note(&mut c, x));
    let other = b.iter().rev().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = (1..=k).map(|x| note(&mut c, x));
    let other = b.iter().rev().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = (1..=k).map(|x| note(&mut c, x));
    let other = b.iter().rev().map(|x| note(&mut e, *x));
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Joined elements beside elements.
#[function]
pub fn joined(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().chain(d.iter()).map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().chain(d.iter()).map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().chain(d.iter()).map(|x| note(&mut c, *x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Elements beside every second one.
#[function]
pub fn stepped(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().step_by(2).map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().step_by(2).map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().step_by(2).map(|x| note(&mut e, *x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().step_by(2).map(|x| note(&mut e, *x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// The first elements beside numbered ones.
#[function]
pub fn cut(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().take(3).map(|x| note(&mut c, *x)).zip(b.iter().enumerate().map(|(i, x)| note(&mut e, *x) ^ i as u32)) { r = mixed(r, x ^ y); }
    let one = a.iter().take(3).map(|x| note(&mut c, *x));
    let other = b.iter().enumerate().map(|(i, x)| note(&mut e, *x) ^ i as u32);
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().take(3).map(|x| note(&mut c, *x));
    let other = b.iter().enumerate().map(|(i, x)| note(&mut e, *x) ^ i as u32);
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = a.iter().take(3).map(|x| note(&mut c, *x));
    let other = b.iter().enumerate().map(|(i, x)| note(&mut e, *x) ^ i as u32);
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// An array by value beside elements.
#[function]
pub fn by_value(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    let one = p.into_iter().map(|x| note(&mut c, x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = p.into_iter().map(|x| note(&mut c, x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = p.into_iter().map(|x| note(&mut c, x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Elements that a closure chooses, whose number is unknown.
#[function]
pub fn filtered(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x)).zip(b.iter().map(|x| note(&mut e, *x))) { r = mixed(r, x ^ y); }
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).count() as u32);
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).last().unwrap_or(3));
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).map(|(x, y)| x ^ y).max().unwrap_or(3));
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).position(|(x, y)| x > y).map_or(9, |i| i as u32));
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (i, (x, y)) in one.zip(other).enumerate() { r = mixed(r, x ^ y ^ i as u32); }
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for (x, y) in one.zip(other).skip(1) { r = mixed(r, x ^ y); }
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = one.zip(other).skip(1).fold(r, |r: u32, (x, y)| mixed(r, x ^ y));
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    let one = a.iter().filter(|x| note(&mut c, **x) < 200).map(|x| u32::from(*x));
    let other = b.iter().map(|x| note(&mut e, *x));
    r = mixed(r, one.zip(other).zip(d).count() as u32);
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}

/// Elements beside inspected ones, whose number is unknown to Rust.
#[function]
pub fn inspected(p: [u8; 5], q: [u8; 4], o: [u8; 4], k: u8, m: u8, n: u8) -> u32 {
    let (k, m, n) = (k % 6, m % 5, n % 5);
    let (a, b, d) = (&p[..usize::from(k)], &q[..usize::from(m)], &o[..usize::from(n)]);
    let (mut r, mut c, mut e) = (0_u32, 1_u32, 1_u32);
    for (x, y) in a.iter().map(|x| note(&mut c, *x)).zip(b.iter().inspect(|x| tick(&mut e, **x)).map(|x| u32::from(*x))) { r = mixed(r, x ^ y); }
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().inspect(|x| tick(&mut e, **x)).map(|x| u32::from(*x));
    r = mixed(r, one.zip(other).map(|(x, y)| (x ^ y) & 1023).sum());
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().inspect(|x| tick(&mut e, **x)).map(|x| u32::from(*x));
    r ^= u32::from(one.zip(other).any(|(x, y)| x == y));
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().inspect(|x| tick(&mut e, **x)).map(|x| u32::from(*x));
    r = mixed(r, one.zip(other).filter(|(x, y)| x > y).count() as u32);
    let one = a.iter().map(|x| note(&mut c, *x));
    let other = b.iter().inspect(|x| tick(&mut e, **x)).map(|x| u32::from(*x));
    for ((x, y), z) in one.zip(other).zip(d) { r = mixed(r, x ^ y ^ u32::from(*z)); }
    r ^ c.wrapping_mul(1009) ^ e.wrapping_mul(100_003) ^ d.len() as u32
}
