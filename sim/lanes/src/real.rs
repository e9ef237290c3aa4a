//! Numbers of double precision.

use std::ops::{Add, Div, Mul, Neg, Sub};

use bytemuck::cast;
use wide::{f64x8, i64x8};

use crate::{LANES, Mask, Single, Whole};

/// An `f64` in each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Real(pub(crate) f64x8);

/// The bit of the sign.
const SIGN: i64 = i64::MIN;

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Real {
            type Output = Real;

            #[inline(always)]
            fn $method(self, other: Real) -> Real {
                Real($trait::$method(self.0, other.0))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Real {
    type Output = Real;

    #[inline(always)]
    fn neg(self) -> Real {
        Real(cast(self.bits() ^ i64x8::new([SIGN; LANES])))
    }
}

impl Real {
    /// Returns a number in each lane.
    #[inline(always)]
    pub fn of(value: f64) -> Real {
        Real(f64x8::new([value; LANES]))
    }

    /// Returns the numbers of the lanes.
    #[inline(always)]
    pub fn new(values: [f64; LANES]) -> Real {
        Real(f64x8::new(values))
    }

    /// Returns the number of each lane.
    #[inline(always)]
    pub fn to_array(self) -> [f64; LANES] {
        self.0.to_array()
    }

    /// Returns the number of a lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> f64 {
        self.0.as_array()[lane % LANES]
    }

    /// Replaces the number of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: f64) {
        let mut all = self.to_array();
        all[lane % LANES] = value;
        *self = Real::new(all);
    }

    #[inline(always)]
    fn bits(self) -> i64x8 {
        cast(self.0)
    }

    #[inline(always)]
    fn map(self, each: impl Fn(f64) -> f64) -> Real {
        Real::new(self.to_array().map(each))
    }

    #[inline(always)]
    fn zip(self, other: Real, each: impl Fn(f64, f64) -> f64) -> Real {
        let (one, other) = (self.to_array(), other.to_array());
        Real::new(std::array::from_fn(|lane| each(one[lane], other[lane])))
    }

    /// Returns `self` in the lanes of a mask, and `other` elsewhere.
    #[inline(always)]
    pub fn or(self, mask: Mask, other: Real) -> Real {
        let mask: f64x8 = cast(mask.0);
        Real(mask.select(self.0, other.0))
    }

    /// Compares, `<`.
    #[inline(always)]
    pub fn lt(self, other: Real) -> Mask {
        Mask(cast(self.0.simd_lt(other.0)))
    }

    /// Compares, `<=`.
    #[inline(always)]
    pub fn le(self, other: Real) -> Mask {
        Mask(cast(self.0.simd_le(other.0)))
    }

    /// Compares, `>`.
    #[inline(always)]
    pub fn gt(self, other: Real) -> Mask {
        Mask(cast(self.0.simd_gt(other.0)))
    }

    /// Compares, `>=`.
    #[inline(always)]
    pub fn ge(self, other: Real) -> Mask {
        Mask(cast(self.0.simd_ge(other.0)))
    }

    /// Compares, `==`.
    #[inline(always)]
    pub fn equals(self, other: Real) -> Mask {
        Mask(cast(self.0.simd_eq(other.0)))
    }

    /// Compares, `!=`.
    #[inline(always)]
    pub fn differs(self, other: Real) -> Mask {
        !self.equals(other)
    }

    /// Returns the remainder of a division towards zero, `%`.
    #[inline(always)]
    pub fn remainder(self, other: Real) -> Real {
        self.zip(other, |one, other| one % other)
    }

    /// Returns the root.
    #[inline(always)]
    pub fn sqrt(self) -> Real {
        Real(self.0.sqrt())
    }

    /// Returns the magnitude.
    #[inline(always)]
    pub fn abs(self) -> Real {
        Real(cast(self.bits() & i64x8::new([!SIGN; LANES])))
    }

    /// Returns the largest whole number that is not above.
    #[inline(always)]
    pub fn floor(self) -> Real {
        Real(self.0.floor())
    }

    /// Returns the smallest whole number that is not below.
    #[inline(always)]
    pub fn ceil(self) -> Real {
        // Without SSE 4.1, `wide` loses the sign of a zero.
        Real(self.0.ceil()).copysign(self)
    }

    /// Returns the whole part, towards zero.
    #[inline(always)]
    pub fn trunc(self) -> Real {
        Real(self.0.trunc())
    }

    /// Returns the nearest whole number; a half goes away from zero.
    #[inline(always)]
    pub fn round(self) -> Real {
        let whole = self.trunc();
        let half = (self - whole).abs().ge(Real::of(0.5));
        let away = whole + Real::of(1.0).copysign(self);
        away.or(half, whole).copysign(self)
    }

    /// Returns the smaller number, where −0 < +0; a NaN is ignored.
    #[inline(always)]
    pub fn min(self, other: Real) -> Real {
        let first = self.lt(other) | (self.equals(other) & other.plus()) | other.is_nan();
        self.or(first & !self.is_nan(), other)
    }

    /// Returns the larger number, where −0 < +0; a NaN is ignored.
    #[inline(always)]
    pub fn max(self, other: Real) -> Real {
        let first = self.gt(other) | (self.equals(other) & !other.plus()) | other.is_nan();
        self.or(first & !self.is_nan(), other)
    }

    /// Returns true where the sign bit is not set.
    #[inline(always)]
    fn plus(self) -> Mask {
        Whole(self.bits()).ge(Whole::of(0))
    }

    /// Returns the number, moved into the range from `low` to `high`; a NaN stays.
    #[inline(always)]
    pub fn clamp(self, low: Real, high: Real) -> Real {
        let above = high.or(self.gt(high), self);
        low.or(self.lt(low), above)
    }

    /// Returns the magnitude with the sign of another number; a NaN has a positive sign.
    #[inline(always)]
    pub fn copysign(self, sign: Real) -> Real {
        let signs = Whole(sign.bits() & i64x8::new([SIGN; LANES]));
        let signs = Whole::of(0).or(sign.is_nan(), signs);
        Real(cast(self.abs().bits() | signs.0))
    }

    /// Returns 1 with the sign of the number, and NaN for a NaN.
    #[inline(always)]
    pub fn signum(self) -> Real {
        self.or(self.is_nan(), Real::of(1.0).copysign(self))
    }

    /// Returns the quotient whose remainder is not negative.
    #[inline(always)]
    pub fn div_euclid(self, other: Real) -> Real {
        self.zip(other, f64::div_euclid)
    }

    /// Returns the remainder that is not negative.
    #[inline(always)]
    pub fn rem_euclid(self, other: Real) -> Real {
        self.zip(other, f64::rem_euclid)
    }

    /// Returns true for a NaN.
    #[inline(always)]
    pub fn is_nan(self) -> Mask {
        self.differs(self)
    }

    /// Returns true for a number that is neither infinite nor NaN.
    #[inline(always)]
    pub fn is_finite(self) -> Mask {
        self.abs().lt(Real::of(f64::INFINITY))
    }

    /// Returns true for an infinite number.
    #[inline(always)]
    pub fn is_infinite(self) -> Mask {
        self.abs().equals(Real::of(f64::INFINITY))
    }

    /// Returns the bits; each NaN has the canonical ones.
    #[inline(always)]
    pub fn to_bits(self) -> Whole {
        Whole::of(0x7ff8_0000_0000_0000).or(self.is_nan(), Whole(self.bits()))
    }

    /// Returns the bits.
    #[inline(always)]
    pub fn raw_bits(self) -> Whole {
        Whole(self.bits())
    }

    /// Converts to single precision.
    #[inline(always)]
    pub fn single(self) -> Single {
        Single(self.to_array().map(|value| value as f32))
    }

    /// Converts as Rust's `as` does, by the conversion of one number to a word.
    #[inline(always)]
    pub fn convert(self, each: impl Fn(f64) -> i64) -> Whole {
        Whole::new(self.to_array().map(each))
    }

    /// Computes a function of one number in each lane.
    #[inline(always)]
    pub fn apply(self, each: impl Fn(f64) -> f64) -> Real {
        self.map(each)
    }
}
