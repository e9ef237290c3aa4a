//! Enums with explicit numbers.

use bessemer::prelude::*;

/// Commands of a memory.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Opcode {
    #[default]
    Read = 3,
    Write = 2,
    Erase = 0xd8,
}

/// The type of this kind.
pub type It = Opcode;

/// A first value.
#[function]
pub fn one() -> It {
    Opcode::Read
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Opcode::Erase
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = if *it == Opcode::Read { Opcode::Write } else { Opcode::Read };
}

include!("six.in");
