//! Truth values, and the lanes that a statement is for.

use std::ops::{BitAnd, BitAndAssign, BitOr, BitXor, Not};

use wide::i64x8;

use crate::{LANES, Whole};

/// A `bool` in each lane: all bits set, or none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mask(pub(crate) i64x8);

impl Mask {
    /// No lane.
    pub const NONE: Mask = Mask(i64x8::new([0; LANES]));
    /// Each lane.
    pub const ALL: Mask = Mask(i64x8::new([-1; LANES]));

    /// Returns the value `value` in each lane.
    #[inline(always)]
    pub fn of(value: bool) -> Mask {
        if value { Mask::ALL } else { Mask::NONE }
    }

    /// Returns the mask of these values.
    #[inline(always)]
    pub fn new(values: [bool; LANES]) -> Mask {
        Mask(i64x8::new(values.map(|value| -i64::from(value))))
    }

    /// Returns the mask of one lane.
    #[inline(always)]
    pub fn only(lane: usize) -> Mask {
        Mask::new(std::array::from_fn(|it| it == lane))
    }

    /// Returns the value of each lane.
    #[inline(always)]
    pub fn to_array(self) -> [bool; LANES] {
        self.0.to_array().map(|word| word != 0)
    }

    /// Returns the value of a lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> bool {
        self.0.as_array()[lane % LANES] != 0
    }

    /// Returns true if the value is true in some lane.
    #[inline(always)]
    pub fn any(self) -> bool {
        self.0.any()
    }

    /// Returns the lanes with true as the bits of a number.
    #[inline(always)]
    pub(crate) fn set(self) -> usize {
        self.0.to_bitmask() as usize
    }

    /// Returns the values as whole numbers, 0 or 1.
    #[inline(always)]
    pub fn whole(self) -> Whole {
        Whole(self.0 & i64x8::new([1; LANES]))
    }

    /// Returns, in each lane, whether both values are equal.
    #[inline(always)]
    pub fn equals(self, other: Mask) -> Mask {
        !(self ^ other)
    }
}

impl BitAnd for Mask {
    type Output = Mask;

    #[inline(always)]
    fn bitand(self, other: Mask) -> Mask {
        Mask(self.0 & other.0)
    }
}

impl BitAndAssign for Mask {
    #[inline(always)]
    fn bitand_assign(&mut self, other: Mask) {
        *self = *self & other;
    }
}

impl BitOr for Mask {
    type Output = Mask;

    #[inline(always)]
    fn bitor(self, other: Mask) -> Mask {
        Mask(self.0 | other.0)
    }
}

impl BitXor for Mask {
    type Output = Mask;

    #[inline(always)]
    fn bitxor(self, other: Mask) -> Mask {
        Mask(self.0 ^ other.0)
    }
}

impl Not for Mask {
    type Output = Mask;

    #[inline(always)]
    fn not(self) -> Mask {
        self ^ Mask::ALL
    }
}
