//! A name that a macro makes, and that it is given as well.

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
