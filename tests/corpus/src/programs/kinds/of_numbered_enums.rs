//! Enums with numbers of their own.

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

/// The kind.
pub type It = Opcode;

/// One of them.
#[function]
pub fn one() -> It {
    Opcode::Read
}

/// Another.
#[function]
pub fn other() -> It {
    Opcode::Erase
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = if *it == Opcode::Read { Opcode::Write } else { Opcode::Read };
}

include!("six.in");
