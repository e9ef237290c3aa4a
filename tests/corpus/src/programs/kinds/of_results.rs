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

/// The kind.
pub type It = Result<u16, Damage>;

/// One of them.
#[function]
pub fn one() -> It {
    Ok(500)
}

/// Another.
#[function]
pub fn other() -> It {
    Err(Damage::Parity(3))
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = match *it {
        Ok(value) => Err(Damage::Parity((value % 256) as u8)),
        Err(_) => Ok(1),
    };
}

include!("six.in");
