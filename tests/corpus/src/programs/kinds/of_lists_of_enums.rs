//! Lists of enums with payloads.

use bessemer::prelude::*;

/// Events with and without data.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Event {
    #[default]
    Nothing,
    Level(f64),
    Keys([u8; 2]),
}

/// The type of this kind.
pub type It = List<Event, 3>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut list = List::new();
    list.push(Event::Level(x));
    list
}

/// A first value.
#[function]
pub fn one() -> It {
    let mut list = List::new();
    list.push(Event::Level(2.5));
    list.push(Event::Keys([1, 2]));
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
        it.push(Event::Nothing);
    } else {
        it[0] = Event::Keys([8, 9]);
    }
}

include!("six.in");
include!("floats.in");
