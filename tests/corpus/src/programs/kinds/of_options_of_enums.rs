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

/// The kind.
pub type It = (Option<Packet>, Option<Option<u8>>);

/// One of them.
#[function]
pub fn one() -> It {
    (Some(Packet::Ack(7)), Some(None))
}

/// Another.
#[function]
pub fn other() -> It {
    (None, Some(Some(7)))
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = (Some(Packet::Data([1, 2])), None);
}

include!("six.in");
