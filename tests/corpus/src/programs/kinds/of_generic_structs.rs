//! An instance of a generic struct.

use bessemer::prelude::*;

/// The last values.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<T, const N: usize> {
    pub last: [T; N],
    pub count: u8,
}

/// The kind.
pub type It = Held<f32, 3>;
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Held { last: [0.0, 1.0, x], count: 1 }
}

/// One of them.
#[function]
pub fn one() -> It {
    Held { last: [1.0, 2.0, 3.0], count: 3 }
}

/// Another.
#[function]
pub fn other() -> It {
    Held { last: [0.0; 3], count: 0 }
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.last[1] = 8.0;
    it.count = it.count.wrapping_add(1);
}

include!("six.in");
include!("floats.in");
