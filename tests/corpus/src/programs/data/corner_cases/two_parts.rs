//! Two slices as arguments of one call: the bounds of the first are evaluated before those of the second.

use bessemer::prelude::*;

/// The sum of products, as far as the shorter slice goes.
#[function]
fn products(x: &[f64], y: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (a, b) in x.iter().zip(y) {
        sum += a * b;
    }
    sum
}

#[function]
pub fn of_run_time_bounds(x: &[f64; 8], y: &[f64; 8], start: usize, end: usize) -> f64 {
    products(&x[start..], &y[..end])
}

/// The start of the first slice is read before the second argument changes it.
#[function]
pub fn of_a_start_that_moves(x: &[f64; 8], y: &[f64; 8], mut start: usize) -> f64 {
    products(
        &x[start..],
        &y[{
            start += 1;
            start
        }..],
    )
}

/// Scales elements by the slice's position.
#[function]
fn scaled(x: &mut [f64], y: &[f64], by: usize) {
    for (a, b) in x.iter_mut().zip(y) {
        *a = b * by as f64;
    }
}

#[function]
pub fn of_a_part_that_is_written(x: &mut [f64; 8], y: &[f64; 8], mut start: usize, end: usize) {
    scaled(&mut x[start..], &y[..end], {
        start += 1;
        y.len() - start
    });
}

/// An arm of a `match` leaves a loop with a value.
#[function]
pub fn left_from_an_arm(x: &[i32; 8], wanted: i32) -> usize {
    let mut i = 0;
    #[bound(30)]
    loop {
        match x[i % 8] {
            v if v == wanted => return i,
            _ if i > 20 => return 99,
            _ => i += 1,
        }
    }
}
