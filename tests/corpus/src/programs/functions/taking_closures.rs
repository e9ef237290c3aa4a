//! A function that takes a closure has a copy in the C for each closure passed to it.

use bessemer::prelude::*;

/// A zero of `f` between `low` and `high`, by bisection.
#[function]
pub fn root<F: Fn(f64) -> f64>(f: F, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..20 {
        let middle = (low + high) / 2.0;
        let value = f(middle);
        if value == 0.0 {
            return middle;
        }
        if value > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    (low + high) / 2.0
}

/// The speed at which drag balances thrust, m/s.
#[function]
pub fn top_speed(thrust: f64, drag: f64) -> f64 {
    let surplus = |speed: f64| drag * speed * speed - thrust;
    root(surplus, 0.0, 100.0)
}

/// The square root, by bisection.
#[function]
pub fn square_root(of: f64) -> f64 {
    root(|x| x * x - of, 0.0, 1024.0)
}

/// Calls `visit` with each angle of a circle, rad.
#[function]
fn around(steps: u8, mut visit: impl FnMut(f64)) {
    for i in 0..16 {
        if i < steps {
            visit(f64::from(i) * 0.4);
        }
    }
}

/// The sum of the angles, and their number.
#[function]
pub fn swept(steps: u8, scale: f64) -> (f64, u32) {
    let mut sum = 0.0;
    let mut count = 0;
    around(steps, |angle| {
        sum += scale * angle;
        count += 1;
    });
    (sum, count)
}
