//! A name that a macro makes, and that it is given as well; a raw one that hides another.

use bessemer::prelude::*;

macro_rules! offset {
    ($name:ident, $x:ident, $by:expr) => {
        /// With an offset.
        #[function]
        pub fn $name($x: f64) -> f64 {
            let x = 5.0;
            x + $by
        }
    };
}

offset!(lifted, x, x * 2.0);

/// A closure whose name is another's later.
#[function]
pub fn hidden(x: f64) -> f64 {
    let gain = x;
    let scaled = |y: f64| y * r#gain;
    let r#gain = 2.0;
    scaled(x) + gain
}
