//! An instance of a generic struct.

use bessemer::prelude::*;

/// Some values of any type.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<T, const N: usize> {
    pub last: [T; N],
    pub count: u8,
}

/// The type of this kind.
pub type It = Held<f32, 3>;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Held { last: [0.0, 1.0, x], count: 1 }
}

/// A first value.
#[function]
pub fn one() -> It {
    Held { last: [1.0, 2.0, 3.0], count: 3 }
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Held { last: [0.0; 3], count: 0 }
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.last[1] = 8.0;
    it.count = it.count.wrapping_add(1);
}

include!("six.in");
include!("floats.in");
