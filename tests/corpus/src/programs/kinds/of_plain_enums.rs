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

/// The type of this kind.
pub type It = Gear;

/// A first value.
#[function]
pub fn one() -> It {
    Gear::Reverse
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Gear::Drive
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = match *it {
        Gear::Park => Gear::Reverse,
        Gear::Reverse => Gear::Drive,
        Gear::Drive => Gear::Park,
    };
}

include!("six.in");
