//! Arrays of arrays of structs.

use bessemer::prelude::*;

/// A square of a map.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    pub seen: bool,
    pub height: f32,
}

/// The type of this kind.
pub type It = [[Cell; 3]; 2];
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut map = other();
    map[1][0].height = x;
    map
}

/// A first value.
#[function]
pub fn one() -> It {
    [[Cell { height: 0.5, seen: true }; 3], [Cell::default(); 3]]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [[Cell::default(); 3]; 2]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    let last = it[1][2];
    it[1][2] = it[0][0];
    it[0][0].seen = last.seen;
    it[0][1].height = -1.0;
}

include!("six.in");
include!("floats.in");
