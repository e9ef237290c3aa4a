//! Methods, conversions and faults of integers of 128 bits.

use bessemer::prelude::*;

/// Counts and their sum.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Totals {
    pub count: u128,
    pub sums: [i128; 2],
    pub last: Option<u128>,
}

#[data]
impl Totals {
    /// Adds a sample.
    pub fn add(&mut self, sample: i64) -> bool {
        self.count += 1;
        self.sums[0] += sample as i128;
        self.sums[1] -= i128::from(sample) * i128::from(sample);
        self.last = self.last.and_then(|last| last.checked_mul(3)).or(Some(7));
        *self > Totals::default()
    }
}

/// Checked operations.
#[function]
pub fn checked(a: u128, b: u128, c: i128, d: i128) -> (Option<u128>, Option<u128>, Option<i128>, Option<i128>) {
    (a.checked_add(b), a.checked_sub(b), c.checked_mul(d), c.checked_div(d))
}

/// Saturating and overflowing operations.
#[function]
pub fn limited(a: u128, b: u128, c: i128, d: i128) -> (u128, u128, i128, i128, (i128, bool)) {
    (a.saturating_mul(b), a.saturating_sub(b), c.saturating_add(d), c.saturating_mul(d), c.overflowing_sub(d))
}

/// Wrapping operations.
#[function]
pub fn wrapped(a: u128, c: i128, bits: u32) -> (u128, u128, i128, i128) {
    (
        a.wrapping_mul(a).wrapping_add(0x1234_5678_9ABC_DEF0_1234_5678_9ABC_DEF0),
        a.wrapping_shl(bits).rotate_left(bits ^ 5),
        c.wrapping_neg().wrapping_shr(bits) & !2,
        c.wrapping_pow(bits & 7).rotate_right(bits),
    )
}

/// Bits and bytes.
#[function]
pub fn counted(a: u128, c: i128) -> ([u32; 6], [u8; 16], i128) {
    let counts = [
        a.count_ones(),
        a.leading_zeros(),
        c.trailing_zeros(),
        c.leading_ones(),
        a.checked_ilog2().unwrap_or(200),
        c.count_zeros() + u32::from(a.is_power_of_two()),
    ];
    (counts, a.to_be_bytes(), i128::from_le_bytes(c.swap_bytes().to_le_bytes()))
}

/// Conversions to narrower numbers.
#[function]
pub fn narrowed(a: u128, c: i128) -> (Option<u8>, Option<i64>, Option<u64>, Option<i16>, i32, bool) {
    let small = u8::try_from(a).ok();
    let word = i64::try_from(c).ok();
    let other: Option<u64> = c.try_into().ok();
    (small, word, other, i16::try_from(a).ok(), c as i32, u128::try_from(c).is_ok() && i128::try_from(a).is_ok())
}

/// Conversions from and to floats.
#[function]
pub fn floating(a: u128, c: i128, x: f64, y: f32) -> (f64, f32, f64, f32, u128, i128, i128) {
    (a as f64, a as f32, c as f64, c as f32, x as u128, x as i128, y as i128)
}

/// Conversions from all other numbers.
#[function]
pub fn widened(a: u8, b: i8, c: u64, d: i64, e: usize, f: bool, g: char) -> (u128, i128) {
    let sum = a as u128 + u128::from(c) + e as u128 + f as u128 + u128::from(g);
    (sum ^ b as u128 ^ d as u128, b as i128 * i128::from(d) + c as i128 - i128::from(f))
}

/// Products of words of 64 and of 32 bits.
#[function]
pub fn products(a: u64, b: i64, c: i32, d: u32, e: u16) -> (u128, i128, i128, i128, i128) {
    (
        a as u128 * 0xFFFF_FFFF_FFFF,
        b as i128 * d as i128,
        c as i128 * e as i128,
        b as i128 - i128::from(c),
        a as i128 * b as i128,
    )
}

/// Operators with signs, shifts and assignments.
#[function]
pub fn signed(c: i128, d: i128, by: i8) -> i128 {
    let mut value = -(c >> 3) + d % 1_000_003;
    value *= -5;
    value /= d | 1;
    value <<= by;
    value ^= !c;
    value &= i128::MAX;
    value
}

/// Division that rounds down, magnitude and sign.
#[function]
pub fn euclidean(c: i128, d: i128) -> (i128, i128, i128, u128) {
    (c.div_euclid(d), c.rem_euclid(d), c.signum() * d.signum(), c.unsigned_abs().abs_diff(d.unsigned_abs()))
}

/// The magnitude, which the least number has not.
#[function]
pub fn magnitude(c: i128) -> i128 {
    c.abs()
}

/// Powers and roots.
#[function]
pub fn powers(a: u128, c: i128) -> (u128, u128, i128) {
    (a.isqrt(), (a & 0xFFFF).pow(5), (c % 100).pow(9))
}

/// Order and limits.
#[function]
pub fn ordered(a: u128, b: u128, c: i128) -> (u128, i128, core::cmp::Ordering, bool) {
    (a.max(b), c.clamp(-5, 1 << 70), a.cmp(&b), (a, c) < (b, 0) && -3 < c)
}

/// The sum of an array.
#[function]
pub fn total(values: &[u64; 3], wide: &[u128; 2]) -> u128 {
    let mut sum: u128 = values.iter().map(|&x| x as u128).sum();
    for x in wide {
        sum = sum.wrapping_add(*x);
    }
    sum
}

/// A function for each type.
#[function]
pub fn larger<T: Copy + PartialOrd + core::ops::Add<Output = T>>(a: T, b: T) -> T {
    if a < b { b + a } else { a }
}

/// Calls it.
#[function]
pub fn generic(a: u128, b: u128, c: u8, d: u8) -> (u128, u8) {
    (larger(a, b), larger(c, d))
}

/// Patterns of numbers.
#[function]
pub fn matched(a: u128, c: i128) -> u8 {
    const LIMIT: i128 = -(1 << 90);
    match (a, c) {
        (0, _) => 0,
        (1..=0xFFFF_FFFF_FFFF_FFFF_FFFF, 0..) => 1,
        (1_u128 | 2, -7_i128) => 2,
        (_, LIMIT) => 3,
        (_, i128::MIN..=-1) => 4,
        (u128::MAX, _) => 5,
        _ => 6,
    }
}
