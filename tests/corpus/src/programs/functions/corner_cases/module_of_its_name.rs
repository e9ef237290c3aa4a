//! Functions in modules of their names: a library calls them by the names that it imports from there.

use bessemer::prelude::*;
use filters::turn::turn;

/// Returns the point of the unit circle, and an angle.
#[function]
pub fn on_circle(share: f64) -> (f64, f64, f64) {
    let (x, y) = filters::on_circle(share);
    (x, y, turn(share))
}
