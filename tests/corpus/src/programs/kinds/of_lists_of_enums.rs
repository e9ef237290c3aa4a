//! Lists of enums with payloads.

use bessemer::prelude::*;

/// Events.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Event {
    #[default]
    Nothing,
    Level(f64),
    Keys([u8; 2]),
}

/// The kind.
pub type It = List<Event, 3>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut list = List::new();
    list.push(Event::Level(x));
    list
}

/// One of them.
#[function]
pub fn one() -> It {
    let mut list = List::new();
    list.push(Event::Level(2.5));
    list.push(Event::Keys([1, 2]));
    list
}

/// Another.
#[function]
pub fn other() -> It {
    List::new()
}

/// Makes it a third.
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
