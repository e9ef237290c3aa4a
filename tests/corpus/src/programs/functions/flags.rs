//! A set of flags in a word: bit operators, `!` and `%` of an author's types.

use bessemer::prelude::*;
use core::ops::{BitAnd, BitAndAssign, BitOr, BitOrAssign, BitXor, Not, Rem, RemAssign, Shl, ShrAssign};

/// Faults of a sensor, one bit each.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults(pub u16);

#[data]
impl Faults {
    /// The sensor does not respond.
    pub const SILENT: Faults = Faults(1 << 0);
    /// The sensor's values do not change.
    pub const STUCK: Faults = Faults(1 << 1);
    /// The sensor's values are out of range.
    pub const RANGE: Faults = Faults(1 << 2);

    /// Returns true if all of `others` are set.
    pub fn contains(self, others: Faults) -> bool {
        self & others == others
    }

    /// Sets or clears flags.
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

    /// The flags that are set in at least one of the two.
    fn bitor(self, other: Self) -> Self {
        Faults(self.0 | other.0)
    }
}

#[data]
impl BitAnd for Faults {
    type Output = Self;

    /// The flags that are set in both.
    fn bitand(self, other: Self) -> Self {
        Faults(self.0 & other.0)
    }
}

#[data]
impl BitXor for Faults {
    type Output = Self;

    /// The flags that are set in exactly one of the two.
    fn bitxor(self, other: Self) -> Self {
        Faults(self.0 ^ other.0)
    }
}

#[data]
impl Not for Faults {
    type Output = Self;

    /// The flags that are not set.
    fn not(self) -> Self {
        Faults(!self.0)
    }
}

#[data]
impl BitOrAssign for Faults {
    /// Sets further flags.
    fn bitor_assign(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

#[data]
impl BitAndAssign for Faults {
    /// Clears the flags that `other` does not have.
    fn bitand_assign(&mut self, other: Self) {
        self.0 &= other.0;
    }
}

#[data]
impl Shl<u32> for Faults {
    type Output = Self;

    /// Shifts the flags up to make room for those of another sensor.
    fn shl(self, places: u32) -> Self {
        Faults(self.0 << places)
    }
}

#[data]
impl ShrAssign<u32> for Faults {
    /// Shifts the flags down to those of the next sensor.
    fn shr_assign(&mut self, places: u32) {
        self.0 >>= places;
    }
}

/// An angle in units of 1/65536 turn.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Angle(pub i32);

#[data]
impl Rem for Angle {
    type Output = Self;

    /// The remainder of a division by an angle.
    fn rem(self, part: Self) -> Self {
        Angle(self.0 % part.0)
    }
}

#[data]
impl RemAssign<i32> for Angle {
    /// Replaces the angle by its remainder.
    fn rem_assign(&mut self, part: i32) {
        self.0 %= part;
    }
}

/// The unmasked flags that changed between two samples.
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

/// The angle within a sector, and that within half of it.
#[function]
pub fn within(angle: Angle, sector: Angle) -> Angle {
    let mut rest = angle % sector;
    rest %= 512;
    rest
}

/// Bit operators of numbers remain Rust's, even if rustc infers the type later.
#[function]
pub fn mixed(word: u16, places: u8) -> u32 {
    let mut sum = 0;
    for place in 0..4_u8 {
        sum ^= u32::from(!word >> place & 0x0F) << (places % 8);
        sum |= 1 << place;
    }
    !sum % 1000
}
