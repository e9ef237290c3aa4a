//! Closures with early exits, closures that move their captures, and functions in place of closures.

use bessemer::prelude::*;

/// The square root; `None` for a negative number.
#[function]
pub fn root(x: f64) -> Option<f64> {
    let root = |x: f64| {
        if x.is_nan() {
            return None;
        }
        (x >= 0.0).then(|| x.sqrt())
    };
    root(x)
}

/// The sum of two roots: `?` leaves the closure, and not the function.
#[function]
pub fn roots(x: f64, y: f64) -> f64 {
    let both = || Some(root(x)? + root(y)?);
    both().unwrap_or(-1.0)
}

/// A closure in a chain that returns early for an item.
#[function]
pub fn known(readings: &[i32; 6], scale: i32) -> i32 {
    let scaled = readings.iter().filter_map(|x| {
        let x = x.checked_mul(scale)?;
        if x % 2 == 0 {
            return None;
        }
        x.checked_add(1)
    });
    scaled.fold(0, i32::wrapping_add)
}

/// The item at which a loop in a closure ends.
#[function]
pub fn first_above(rows: &[[u8; 3]; 2], least: u8) -> u32 {
    let found = |row: &[u8; 3]| {
        for (at, x) in row.iter().enumerate() {
            if *x > least {
                return at as u32;
            }
        }
        9
    };
    10 * found(&rows[0]) + found(&rows[1])
}


/// Functions and closures by their names, and moved copies.
#[function]
pub fn by_name(values: &[f32; 4], k: f32) -> f32 {
    let scaled = |x: f32| k * x;
    let halves: f32 = values.iter().copied().map(halved).map(scaled).sum();
    let most = values.iter().copied().fold(f32::MIN, f32::max);
    let shifted = values.map(move |x| x + k);
    debug_assert!(k != 7.0, "never so");
    halves + most + shifted[0]
}

/// Half of a number.
#[function]
pub fn halved(x: f32) -> f32 {
    x / 2.0
}
