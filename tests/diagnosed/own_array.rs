//! A module of the author's own that is called as Rust's `array` is.

use bessemer::prelude::*;

/// Arrays of another kind.
pub mod array {
    use bessemer::prelude::*;

    /// From the end.
    #[function]
    pub fn from_fn(f: impl Fn(usize) -> f64) -> [f64; 3] {
        [f(2), f(1), f(0)]
    }
}

/// The first.
#[function]
pub fn first(x: f64) -> f64 {
    array::from_fn(|i| x + i as f64)[0]
}
