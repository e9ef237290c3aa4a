//! `contains` of a range becomes two comparisons. `then` returns a value if a condition holds.

use bessemer::prelude::*;

/// The argument, if it is from 0 to 1.
#[function]
pub fn share(x: f32) -> Option<f32> {
    (0.0..=1.0).contains(&x).then_some(x)
}

/// Distance of a value from the middle of a band, if it is inside.
#[function]
pub fn inside(low: i32, width: i32, x: i32) -> Option<i32> {
    let high = low.saturating_add(width);
    (low..high).contains(&x).then(|| x.wrapping_sub(low / 2 + high / 2))
}
