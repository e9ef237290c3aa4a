//! Options of a struct with an array.

use bessemer::prelude::*;

/// A path along points.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passage {
    pub length: u8,
    pub points: [f32; 3],
}

/// The type of this kind.
pub type It = Option<Passage>;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Some(Passage { length: 1, points: [0.0, x, 1.0] })
}

/// A first value.
#[function]
pub fn one() -> It {
    Some(Passage { length: 2, points: [0.5, -0.5, 1.0] })
}

/// A second, different value.
#[function]
pub fn other() -> It {
    None
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    if let Some(route) = it {
        route.points[route.length as usize % 3] = 9.0;
    } else {
        *it = one();
    }
}

include!("six.in");
include!("floats.in");
