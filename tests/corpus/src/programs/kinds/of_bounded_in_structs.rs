//! Bounded matrices and lists as fields.

use bessemer::prelude::*;

/// Recent samples.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    pub seen: List<u16, 3>,
    pub data: BoundedMatrix<f64, 2, 2>,
    pub full: bool,
}

/// The type of this kind.
pub type It = Window;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut made = other();
    made.data.resize(1, 1, x);
    made
}

/// A first value.
#[function]
pub fn one() -> It {
    let mut made = Window { seen: List::new(), data: BoundedMatrix::new(1, 2), full: true };
    made.seen.push(3);
    made.data[(0, 1)] = 0.5;
    made
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Window { seen: List::new(), data: BoundedMatrix::new(0, 0), full: false }
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.data.resize(2, 1, 6.0);
    it.seen.clear();
}

include!("six.in");
include!("floats.in");
