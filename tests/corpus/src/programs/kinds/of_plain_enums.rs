//! Enums without payloads.

use bessemer::prelude::*;

/// Positions of the lever.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gear {
    #[default]
    Park,
    Reverse,
    Drive,
}

/// The kind.
pub type It = Gear;

/// One of them.
#[function]
pub fn one() -> It {
    Gear::Reverse
}

/// Another.
#[function]
pub fn other() -> It {
    Gear::Drive
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = match *it {
        Gear::Park => Gear::Reverse,
        Gear::Reverse => Gear::Drive,
        Gear::Drive => Gear::Park,
    };
}

include!("six.in");
