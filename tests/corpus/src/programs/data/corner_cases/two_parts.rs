//! Two parts of slices in one call: where the first begins is settled before the second is looked at.

use bessemer::prelude::*;

/// The sum of products, as far as both go.
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

/// The start of the first is the one before the second changed it.
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

/// Scales by the place of the part.
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

/// Leaves a loop by a value of its own in an arm.
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
