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

/// No name.
const NAMELESS: Text<7> = Text::new();

/// The kind.
pub type It = NamedUnit;

/// One of them.
#[function]
pub fn one() -> It {
    NamedUnit { number: 1, name: Text::of(b"height"), unit: Text::of(b"m") }
}

/// Another.
#[function]
pub fn other() -> It {
    NamedUnit { number: 2, name: NAMELESS, unit: Text::of(b"rad") }
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.name.clear();
    it.unit = Text::of(b"%");
}

include!("six.in");
