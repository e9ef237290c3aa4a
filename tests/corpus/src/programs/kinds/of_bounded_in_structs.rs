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

/// The kind.
pub type It = Window;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut made = other();
    made.data.resize(1, 1, x);
    made
}

/// One of them.
#[function]
pub fn one() -> It {
    let mut made = Window { seen: List::new(), data: BoundedMatrix::new(1, 2), full: true };
    made.seen.push(3);
    made.data[(0, 1)] = 0.5;
    made
}

/// Another.
#[function]
pub fn other() -> It {
    Window { seen: List::new(), data: BoundedMatrix::new(0, 0), full: false }
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.data.resize(2, 1, 6.0);
    it.seen.clear();
}

include!("six.in");
include!("floats.in");
