//! Results.

use bessemer::prelude::*;

/// Kinds of damage.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Damage {
    #[default]
    Short,
    Parity(u8),
}

/// The type of this kind.
pub type It = Result<u16, Damage>;

/// A first value.
#[function]
pub fn one() -> It {
    Ok(500)
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Err(Damage::Parity(3))
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = match *it {
        Ok(value) => Err(Damage::Parity((value % 256) as u8)),
        Err(_) => Ok(1),
    };
}

include!("six.in");
