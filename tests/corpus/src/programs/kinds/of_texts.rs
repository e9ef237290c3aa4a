//! Texts of a bounded length, in a struct.

use bessemer::prelude::*;

/// A channel of a log.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NamedUnit {
    pub number: u8,
    pub name: Text<7>,
    pub unit: Text<3>,
}

/// An empty name.
const NAMELESS: Text<7> = Text::new();

/// The type of this kind.
pub type It = NamedUnit;

/// A first value.
#[function]
pub fn one() -> It {
    NamedUnit { number: 1, name: Text::of(b"height"), unit: Text::of(b"m") }
}

/// A second, different value.
#[function]
pub fn other() -> It {
    NamedUnit { number: 2, name: NAMELESS, unit: Text::of(b"rad") }
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.name.clear();
    it.unit = Text::of(b"%");
}

include!("six.in");
