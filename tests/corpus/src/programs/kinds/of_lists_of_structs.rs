//! Lists of structs with arrays.

use bessemer::prelude::*;

/// A tracked object.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Track {
    pub id: u16,
    pub place: [f32; 2],
}

/// The type of this kind.
pub type It = List<Track, 3>;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut list = List::new();
    list.push(Track { id: 1, place: [0.0, x] });
    list
}

/// A first value.
#[function]
pub fn one() -> It {
    let mut list = List::new();
    list.push(Track { id: 1, place: [0.5, 1.5] });
    list
}

/// A second, different value.
#[function]
pub fn other() -> It {
    List::new()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    if it.is_empty() {
        it.push(Track { id: 2, place: [4.0; 2] });
    } else {
        it[0].place[1] = -3.0;
    }
}

include!("six.in");
include!("floats.in");
