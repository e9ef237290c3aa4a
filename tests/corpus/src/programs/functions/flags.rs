//! A set of flags in a word: the operators of bits, `!` and `%` of an author's own types.

use bessemer::prelude::*;
use core::ops::{BitAnd, BitAndAssign, BitOr, BitOrAssign, BitXor, Not, Rem, RemAssign, Shl, ShrAssign};

/// Faults of a sensor, one bit each.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults(pub u16);

#[data]
impl Faults {
    /// It does not answer.
    pub const SILENT: Faults = Faults(1 << 0);
    /// Its values don't move.
    pub const STUCK: Faults = Faults(1 << 1);
    /// Its values are out of range.
    pub const RANGE: Faults = Faults(1 << 2);

    /// Returns true if all of `others` are there.
    pub fn contains(self, others: Faults) -> bool {
        self & others == others
    }

    /// Notes them, or takes them back.
    pub fn set(&mut self, others: Faults, there: bool) {
        if there {
            *self |= others;
        } else {
            *self &= !others;
        }
    }
}

#[data]
impl BitOr for Faults {
    type Output = Self;

    /// Faults of either.
    fn bitor(self, other: Self) -> Self {
        Faults(self.0 | other.0)
    }
}

#[data]
impl BitAnd for Faults {
    type Output = Self;

    /// Faults of both.
    fn bitand(self, other: Self) -> Self {
        Faults(self.0 & other.0)
    }
}

#[data]
impl BitXor for Faults {
    type Output = Self;

    /// Faults of exactly one.
    fn bitxor(self, other: Self) -> Self {
        Faults(self.0 ^ other.0)
    }
}

#[data]
impl Not for Faults {
    type Output = Self;

    /// All others.
    fn not(self) -> Self {
        Faults(!self.0)
    }
}

#[data]
impl BitOrAssign for Faults {
    /// Adds some.
    fn bitor_assign(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

#[data]
impl BitAndAssign for Faults {
    /// Leaves those that are in both.
    fn bitand_assign(&mut self, other: Self) {
        self.0 &= other.0;
    }
}

#[data]
impl Shl<u32> for Faults {
    type Output = Self;

    /// Makes room for those of another sensor.
    fn shl(self, places: u32) -> Self {
        Faults(self.0 << places)
    }
}

#[data]
impl ShrAssign<u32> for Faults {
    /// Goes on to those of the next sensor.
    fn shr_assign(&mut self, places: u32) {
        self.0 >>= places;
    }
}

/// An angle, a 65536th of a turn each.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Angle(pub i32);

#[data]
impl Rem for Angle {
    type Output = Self;

    /// Remainder.
    fn rem(self, part: Self) -> Self {
        Angle(self.0 % part.0)
    }
}

#[data]
impl RemAssign<i32> for Angle {
    /// Leaves what is left of it.
    fn rem_assign(&mut self, part: i32) {
        self.0 %= part;
    }
}

/// Changes between two samples without masked ones; of two sensors.
#[function]
pub fn changed(before: Faults, now: Faults, asked: Faults) -> Faults {
    let quiet = !asked;
    let changes = (before ^ now) & !quiet;
    changes | changes << 3
}

/// Remaining faults of the second sensor.
#[function]
pub fn second(all: Faults, silent: bool) -> Faults {
    let mut faults = all;
    faults >>= 3;
    faults.set(Faults::SILENT | Faults::STUCK, silent);
    if !faults.contains(Faults::RANGE) && !silent { faults } else { faults | Faults::RANGE }
}

/// Within a sector, and that within its half.
#[function]
pub fn within(angle: Angle, sector: Angle) -> Angle {
    let mut rest = angle % sector;
    rest %= 512;
    rest
}

/// Numbers have these from Rust, also where their type shows late.
#[function]
pub fn mixed(word: u16, places: u8) -> u32 {
    let mut sum = 0;
    for place in 0..4_u8 {
        sum ^= u32::from(!word >> place & 0x0F) << (places % 8);
        sum |= 1 << place;
    }
    !sum % 1000
}
