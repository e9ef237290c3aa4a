//! Whole numbers of every width: the words of Rust's integers and of enums, extended to 64 bits by their sign or by zeros.

use std::ops::{Add, BitAnd, BitOr, BitXor, Mul, Not, Sub};

use bytemuck::cast;
use wide::{f64x8, i64x8};

use crate::{LANES, Mask, Real, Single};

/// A whole number in each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whole(pub(crate) i64x8);

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Whole {
            type Output = Whole;

            #[inline(always)]
            fn $method(self, other: Whole) -> Whole {
                Whole($trait::$method(self.0, other.0))
            }
        }
    )*};
}

// Modulo 2^64.
operators!(Add add, Sub sub, Mul mul, BitAnd bitand, BitOr bitor, BitXor bitxor);

impl Not for Whole {
    type Output = Whole;

    #[inline(always)]
    fn not(self) -> Whole {
        self ^ Whole::of(-1)
    }
}

macro_rules! comparisons {
    ($($(#[$doc:meta])* $name:ident $method:ident),*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $name(self, other: Whole) -> Mask {
            Mask(self.0.$method(other.0))
        }
    )*};
}

impl Whole {
    /// Returns a number in each lane.
    #[inline(always)]
    pub fn of(value: i64) -> Whole {
        Whole(i64x8::new([value; LANES]))
    }

    /// Returns the numbers of the lanes.
    #[inline(always)]
    pub fn new(values: [i64; LANES]) -> Whole {
        Whole(i64x8::new(values))
    }

    /// Returns the number of each lane.
    #[inline(always)]
    pub fn to_array(self) -> [i64; LANES] {
        self.0.to_array()
    }

    /// Returns the number of a lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> i64 {
        self.0.as_array()[lane % LANES]
    }

    /// Replaces the number of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: i64) {
        let mut all = self.to_array();
        all[lane % LANES] = value;
        *self = Whole::new(all);
    }

    /// Computes a function of two numbers in each lane.
    #[inline(always)]
    pub fn zip(self, other: Whole, each: impl Fn(i64, i64) -> i64) -> Whole {
        let (one, other) = (self.to_array(), other.to_array());
        Whole::new(std::array::from_fn(|lane| each(one[lane], other[lane])))
    }

    /// Computes a function of one number in each lane.
    #[inline(always)]
    pub fn apply(self, each: impl Fn(i64) -> i64) -> Whole {
        Whole::new(self.to_array().map(each))
    }

    /// Returns `self` in the lanes of a mask, and `other` elsewhere.
    #[inline(always)]
    pub fn or(self, mask: Mask, other: Whole) -> Whole {
        let (mask, one, other): (f64x8, f64x8, f64x8) = (cast(mask.0), cast(self.0), cast(other.0));
        Whole(cast(mask.select(one, other)))
    }

    /// Returns the number modulo 2^bits, extended by its sign if it is signed.
    #[inline(always)]
    pub fn wrapped(self, bits: u32, signed: bool) -> Whole {
        match (64_u32.saturating_sub(bits), signed) {
            (0, _) => self,
            (_, false) => self & Whole::of((1 << bits) - 1),
            (unused, true) => self.apply(|value| (value << unused) >> unused),
        }
    }

    comparisons! {
        /// Compares signed numbers, `<`.
        lt simd_lt,
        /// Compares signed numbers, `<=`.
        le simd_le,
        /// Compares signed numbers, `>`.
        gt simd_gt,
        /// Compares signed numbers, `>=`.
        ge simd_ge,
        /// Compares, `==`.
        equals simd_eq
    }

    /// Compares, `!=`.
    #[inline(always)]
    pub fn differs(self, other: Whole) -> Mask {
        !self.equals(other)
    }

    /// Returns the number with the order of unsigned numbers under the comparisons of signed ones.
    #[inline(always)]
    pub fn unsigned(self) -> Whole {
        self ^ Whole::of(i64::MIN)
    }

    /// Returns the quotient of signed numbers, towards zero; anything for the divisor 0.
    #[inline(always)]
    pub fn quotient(self, other: Whole) -> Whole {
        self.zip(other, |one, other| if other == 0 { 0 } else { one.wrapping_div(other) })
    }

    /// Returns the remainder of signed numbers; anything for the divisor 0.
    #[inline(always)]
    pub fn remainder(self, other: Whole) -> Whole {
        self.zip(other, |one, other| if other == 0 { 0 } else { one.wrapping_rem(other) })
    }

    /// Returns the quotient of numbers of at most 32 bits, towards zero; anything for the divisor 0.
    ///
    /// Their quotient in double precision is exact to less than its distance from the next whole number.
    #[inline(always)]
    pub fn narrow_quotient(self, other: Whole) -> Whole {
        (self.real() / other.real()).convert(|value| value as i64)
    }

    /// Returns the remainder of numbers of at most 32 bits; anything for the divisor 0.
    #[inline(always)]
    pub fn narrow_remainder(self, other: Whole) -> Whole {
        self - self.narrow_quotient(other) * other
    }

    /// Returns true if each lane is below another unsigned number.
    #[inline(always)]
    fn all_below(self, other: Whole) -> bool {
        !(!self.unsigned().lt(other.unsigned())).any()
    }

    /// Returns the quotient of unsigned numbers; anything for the divisor 0.
    #[inline(always)]
    pub fn unsigned_quotient(self, other: Whole) -> Whole {
        if self.all_below(other) {
            return Whole::of(0);
        }
        self.zip(other, |one, other| {
            (one as u64).checked_div(other as u64).unwrap_or_default() as i64
        })
    }

    /// Returns the remainder of unsigned numbers; anything for the divisor 0.
    #[inline(always)]
    pub fn unsigned_remainder(self, other: Whole) -> Whole {
        if self.all_below(other) {
            return self;
        }
        self.zip(other, |one, other| {
            (one as u64).checked_rem(other as u64).unwrap_or_default() as i64
        })
    }

    /// Returns the bits shifted to the left; 0 for 64 and more.
    #[inline(always)]
    pub fn shift_left(self, by: Whole) -> Whole {
        self.zip(by, |one, by| if (by as u64) < 64 { one << by } else { 0 })
    }

    /// Returns the bits shifted to the right, with zeros above; 0 for 64 and more.
    #[inline(always)]
    pub fn shift_right(self, by: Whole) -> Whole {
        self.zip(by, |one, by| if (by as u64) < 64 { ((one as u64) >> by) as i64 } else { 0 })
    }

    /// Returns the bits shifted to the right, with copies of the sign above.
    #[inline(always)]
    pub fn signed_shift_right(self, by: Whole) -> Whole {
        self.zip(by, |one, by| one >> (by as u64).min(63))
    }

    /// Returns the smaller of signed numbers.
    #[inline(always)]
    pub fn min(self, other: Whole) -> Whole {
        self.or(self.lt(other), other)
    }

    /// Returns the larger of signed numbers.
    #[inline(always)]
    pub fn max(self, other: Whole) -> Whole {
        self.or(self.gt(other), other)
    }

    /// Returns the smaller of unsigned numbers.
    #[inline(always)]
    pub fn unsigned_min(self, other: Whole) -> Whole {
        self.or(self.unsigned().lt(other.unsigned()), other)
    }

    /// Returns the larger of unsigned numbers.
    #[inline(always)]
    pub fn unsigned_max(self, other: Whole) -> Whole {
        self.or(self.unsigned().gt(other.unsigned()), other)
    }

    /// Returns the magnitude of a signed number, modulo 2^64.
    #[inline(always)]
    pub fn magnitude(self) -> Whole {
        (Whole::of(0) - self).or(self.lt(Whole::of(0)), self)
    }

    /// Converts a signed number, or an unsigned one below 2^63.
    #[inline(always)]
    pub fn real(self) -> Real {
        Real::new(self.to_array().map(|value| value as f64))
    }

    /// Converts an unsigned number.
    #[inline(always)]
    pub fn unsigned_real(self) -> Real {
        Real::new(self.to_array().map(|value| value as u64 as f64))
    }

    /// Converts a signed number, or an unsigned one below 2^63, to single precision.
    #[inline(always)]
    pub fn single(self) -> Single {
        Single(self.to_array().map(|value| value as f32))
    }

    /// Converts an unsigned number to single precision.
    #[inline(always)]
    pub fn unsigned_single(self) -> Single {
        Single(self.to_array().map(|value| value as u64 as f32))
    }

    /// Returns the number of double precision with these bits.
    #[inline(always)]
    pub fn real_of_bits(self) -> Real {
        Real(cast(self.0))
    }

    /// Returns the number of single precision with these bits.
    #[inline(always)]
    pub fn single_of_bits(self) -> Single {
        Single(self.to_array().map(|bits| f32::from_bits(bits as u32)))
    }
}
