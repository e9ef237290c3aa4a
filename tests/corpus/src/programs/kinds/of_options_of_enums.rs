//! Options of enums with payloads, and of options.

use bessemer::prelude::*;

/// Packets of a line.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Packet {
    #[default]
    Silence,
    Ack(u8),
    Data([u16; 2]),
}

/// The type of this kind.
pub type It = (Option<Packet>, Option<Option<u8>>);

/// A first value.
#[function]
pub fn one() -> It {
    (Some(Packet::Ack(7)), Some(None))
}

/// A second, different value.
#[function]
pub fn other() -> It {
    (None, Some(Some(7)))
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = (Some(Packet::Data([1, 2])), None);
}

include!("six.in");
