//! Functions of `libm` and `num_traits` that are called by imported names, beside names that a function has of its own.

use bessemer::prelude::*;
use libm::{atan2f, fmax, sqrtf};
use num_traits::{cast, one, zero};

/// Length and angle in the plane, by bare names.
#[function]
pub fn polar(x: f32, y: f32) -> (f32, f32) {
    (sqrtf(x * x + y * y), atan2f(y, x))
}

/// The greater of two in double precision.
#[function]
pub fn greater(x: f64, y: f64) -> f64 {
    fmax(x, y) + libm::fabs(x)
}

/// Passes an imported function by its name.
#[function]
pub fn roots(values: [f32; 3]) -> [f32; 3] {
    values.map(sqrtf)
}

/// Has a variable and a closure of such names.
#[function]
pub fn own_names(x: f32) -> f32 {
    let sqrtf = |x: f32| x + 1.0;
    let fmax = x * 2.0;
    sqrtf(x) + fmax
}

/// Imports inside a module are the module's alone.
pub mod inner {
    use bessemer::prelude::*;

    /// The author's own, of a name that `libm` has.
    #[function]
    pub fn sqrtf(x: f32) -> f32 {
        x + 2.0
    }

    /// Calls the author's own.
    #[function]
    pub fn own(x: f32) -> f32 {
        use libm::sinf;
        sqrtf(x) + sinf(x)
    }
}

/// Methods of an `impl` block do, too.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    x: f32,
    y: f32,
}

#[data]
impl Point {
    /// The angle of the point.
    pub fn angle(&self) -> f32 {
        atan2f(self.y, self.x)
    }
}

/// Free functions of `num_traits`.
#[function]
pub fn numbers(x: f64, n: u16) -> (f64, u16, Option<u8>) {
    let start: f64 = zero();
    (start + x, n / 2 + one::<u16>(), cast(n))
}
