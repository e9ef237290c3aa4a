//! Adapters that are functions of the library, in any order.

use bessemer::prelude::*;

/// Flattened rows, in a chain and in a loop that stops early.
#[function]
pub fn flattened(rows: &[[i16; 3]; 2], limit: i16) -> (i16, i16) {
    let mut first = 0;
    for x in rows.iter().flatten() {
        if *x > limit {
            break;
        }
        first ^= *x;
    }
    (rows.iter().flatten().fold(0, |sum, x| sum ^ *x), first)
}

/// Enumerated items after `scan`, and `inspect`.
#[function]
pub fn numbered(values: &[i32; 5]) -> (Option<i32>, u32) {
    let mut seen = 0_u32;
    let most = values
        .iter()
        .inspect(|x| {
            if **x > 3 {
                seen += 1;
            }
        })
        .scan(3, |state, x| {
            *state ^= x;
            Some(*state)
        })
        .enumerate()
        .map(|(i, x)| x ^ i as i32)
        .max();
    (most, seen)
}

/// Two closures of one chain that write, each to a different variable.
#[function]
pub fn both_write(values: &[u8; 4]) -> (u32, u32, u32) {
    let (mut even, mut large) = (0_u32, 0_u32);
    let count = values
        .iter()
        .filter(|x| {
            even ^= u32::from(**x % 2);
            **x > 2
        })
        .map(|x| {
            large = large.wrapping_add(u32::from(*x));
            x
        })
        .count() as u32;
    (count, even, large)
}

/// A reversed chain of closures.
#[function]
pub fn backwards(values: &[i32; 6]) -> i32 {
    values.iter().map(|x| x ^ 3).filter(|x| *x > 0).rev().fold(0, |s, x| s.wrapping_mul(3) ^ x)
}

/// The remaining rows after an adapter ends the inner loop: the outer one continues.
#[function]
pub fn leading(rows: &[[i8; 3]; 2], limit: i8) -> i32 {
    rows.iter()
        .flat_map(|row| row.iter().take_while(|x| **x < limit).map(|x| i32::from(*x)))
        .fold(1, |sum, x| sum.wrapping_mul(5) ^ x)
}

/// Skipped and stepped items, and the first result that is large enough.
#[function]
pub fn thinned(values: &[i32; 6], n: usize) -> (i32, i32) {
    let thinned = values.iter().map(|x| x ^ 3).skip(n % 4).step_by(1 + n % 2);
    let sum = thinned.fold(0_i32, |s, x| s.wrapping_mul(3) ^ x);
    let large = values.iter().filter(|x| **x > 1).find_map(|x| x.checked_mul(3)).unwrap_or(n as i32);
    (sum, large)
}

/// An increasing index zipped with reversed items, and a chain after another adapter.
#[function]
pub fn counted_back(values: &[i32; 6], more: &[i32; 3], limit: i32) -> i32 {
    let back = values.iter().filter(|x| **x > limit).rev().enumerate();
    let sum = back.fold(0_i32, |s, (i, x)| s.wrapping_mul(3) ^ x.wrapping_add(i as i32));
    let both = values.iter().filter(|x| **x > limit).chain(more.iter()).copied();
    both.enumerate().fold(sum, |s, (i, x)| s.wrapping_mul(5) ^ x.wrapping_add(i as i32))
}

#[function]
fn good(samples: &[f64; 4]) -> impl Iterator<Item = f64> {
    samples.iter().copied().filter(|x| *x > 0.0)
}

/// A named function result before its iteration, and a chain that begins with a computed value.
#[function]
pub fn later(samples: &[f64; 4], start: f64) -> f64 {
    let good = good(samples);
    let mut sum = start;
    for x in good {
        sum += x;
    }
    sum + samples.iter().scan(sum.abs().sqrt(), |sum, x| Some(*sum + x)).sum::<f64>()
}

/// A type whose methods have the names of adapters.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Curve {
    pub at: [f32; 2],
}

#[data]
impl Curve {
    pub fn map(&self, x: f32) -> f32 {
        self.at[0] + x * self.at[1]
    }

    pub fn fold(&self, start: f32, by: f32) -> f32 {
        self.map(start) * by
    }

    pub fn take_while(&self, limit: f32) -> bool {
        self.at[0] < limit
    }
}

#[function]
pub fn own(curve: &Curve, x: f32) -> (f32, bool) {
    (curve.map(x) + curve.fold(x, 2.0), curve.take_while(x))
}
