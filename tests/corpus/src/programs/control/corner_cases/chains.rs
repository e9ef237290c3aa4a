//! Chains and closures whose parameters hide other names, and whose parts write and fault.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    pub x: f64,
    pub n: i16,
}

#[function]
pub fn shadowed(xs: &[f64; 4], x: f64, sum: f64, i: usize, found: bool) -> f64 {
    let total: f64 = xs.iter().map(|x| x * sum).map(|y| y + x).sum();
    let any = xs.iter().map(|x| x + sum).any(|sum| (sum > x) == found);
    let mapped = xs.map(|x| x + i as f64);
    let f = |x: f64| {
        let sum = x * 2.0;
        sum + x
    };
    let nested = f(f(x) + sum);
    let x = if any { mapped[3] } else { nested };
    total + x + xs.iter().rev().fold(sum, |sum, x| x - sum)
}

#[function]
pub fn empty(xs: &[f64; 3], limit: f64) -> f64 {
    let sum: f64 = xs.iter().filter(|x| **x > limit).sum();
    let product = xs.iter().copied().filter(|x| *x > limit).map(|x| x + 1.0).product::<f64>();
    let whole = xs.iter().sum::<f64>();
    sum + 0.0 * product + (1.0 / sum).signum() + whole
}

#[function]
pub fn points(points: &[Point; 3], limit: i16) -> i16 {
    let last = points.iter().map(|p| p.n).fold(0, |_most, n| n);
    let most = points.iter().map(|p| p.n).fold(limit, |most, n| most.max(n));
    let steps: i16 = points.iter().enumerate().map(|(i, p)| p.n / (i as i16 - 1 + limit)).sum();
    let count = points.iter().filter(|p| p.x > 0.5).count() as i16;
    last.wrapping_add(most) / 2 + steps + count
}

#[function]
pub fn in_pairs(xs: &[i32; 6], ys: &[i32; 5], ends: &mut [i32; 3], limit: i32) -> usize {
    let above = xs.windows(2).zip(ys).position(|(pair, y)| pair[1] > *y).unwrap_or(9);
    ends.iter_mut().enumerate().for_each(|(i, end)| *end = limit ^ i as i32);
    let all = xs.chunks(4).enumerate().all(|(i, chunk)| chunk.len() > 2 || i > 0);
    let named = xs.iter().zip(ys).any(|pair| *pair.0 > *pair.1);
    above + usize::from(all) + usize::from(named)
}

#[function]
pub fn counted(xs: &mut [i32; 5], by: i32) -> i32 {
    let mut calls = 0;
    let mut next = |x: i32| {
        calls += 1;
        x.wrapping_mul(by) ^ calls
    };
    let first = next(xs[0]);
    xs[1] = next(first);
    let second = next(2);
    xs[2] = next(second);
    let late = xs.iter().map(|&x| if x > by { 1 } else { -1 }).sum::<i32>();
    for x in xs.iter_mut() {
        *x = x.wrapping_add(late);
    }
    calls + (0..5).map(|i| xs[i] / 3).filter(|x| x % 2 == 0).fold(0, |mut all: i32, x| {
        all = all.wrapping_add(x);
        all
    })
}

#[function]
pub fn stepped(xs: &[u8; 12], from: usize, to: usize) -> u8 {
    let mut sum = 0;
    for i in (from..to).step_by(5) {
        if i == 10 {
            continue;
        }
        sum += xs[i];
    }
    for i in (3..10).step_by(3).rev() {
        if xs[i] == 0 {
            break;
        }
        sum ^= xs[i];
    }
    let all = (0..12).step_by(4).all(|i| xs[i] < 100);
    if all { sum } else { !sum }
}

#[function]
fn means<T: Real, const N: usize>(rows: &[[T; N]; 2]) -> [T; 2] {
    rows.map(|row| row.iter().copied().fold(T::ZERO, |sum, x| sum + x) / real(N as f64))
}

#[function]
pub fn generic(rows: &[[f32; 3]; 2], others: &[[f64; 2]; 2]) -> f64 {
    let squares: [u16; 4] = core::array::from_fn(|i| (i * i) as u16);
    let [a, b] = means(rows);
    let [c, d] = means(others);
    (a - b).as_f64() + c * d + squares.iter().sum::<u16>() as f64
}

#[function]
pub fn left(xs: &[i32; 5], limit: i32) -> i32 {
    let mut sum = 0_i32;
    xs.iter().for_each(|x| {
        if *x < limit {
            return;
        }
        sum ^= x;
    });
    sum
}
