//! Numbers of single precision. Few components compute with them, so each lane is computed by itself.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::{LANES, Mask, Real, Whole};

/// An `f32` in each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Single(pub(crate) [f32; LANES]);

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Single {
            type Output = Single;

            #[inline(always)]
            fn $method(self, other: Single) -> Single {
                self.zip(other, $trait::$method)
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Single {
    type Output = Single;

    #[inline(always)]
    fn neg(self) -> Single {
        self.map(|value| -value)
    }
}

macro_rules! comparisons {
    ($($(#[$doc:meta])* $name:ident $op:tt),*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $name(self, other: Single) -> Mask {
            Mask::new(std::array::from_fn(|lane| self.0[lane] $op other.0[lane]))
        }
    )*};
}

impl Single {
    /// Returns a number in each lane.
    #[inline(always)]
    pub fn of(value: f32) -> Single {
        Single([value; LANES])
    }

    #[inline(always)]
    fn map(self, each: impl Fn(f32) -> f32) -> Single {
        Single(self.0.map(each))
    }

    #[inline(always)]
    fn zip(self, other: Single, each: impl Fn(f32, f32) -> f32) -> Single {
        Single(std::array::from_fn(|lane| each(self.0[lane], other.0[lane])))
    }

    /// Returns `self` in the lanes of a mask, and `other` elsewhere.
    #[inline(always)]
    pub fn or(self, mask: Mask, other: Single) -> Single {
        let mask = mask.to_array();
        let lane = |lane: usize| if mask[lane] { self.0[lane] } else { other.0[lane] };
        Single(std::array::from_fn(lane))
    }

    comparisons! {
        /// Compares, `<`.
        lt <,
        /// Compares, `<=`.
        le <=,
        /// Compares, `>`.
        gt >,
        /// Compares, `>=`.
        ge >=,
        /// Compares, `==`.
        equals ==,
        /// Compares, `!=`.
        differs !=
    }

    /// Returns the root.
    #[inline(always)]
    pub fn sqrt(self) -> Single {
        self.map(f32::sqrt)
    }

    /// Returns the magnitude.
    #[inline(always)]
    pub fn abs(self) -> Single {
        self.map(f32::abs)
    }

    /// Returns true for a NaN.
    #[inline(always)]
    pub fn is_nan(self) -> Mask {
        self.differs(self)
    }

    /// Returns true for a number that is neither infinite nor NaN.
    #[inline(always)]
    pub fn is_finite(self) -> Mask {
        Mask::new(self.0.map(f32::is_finite))
    }

    /// Returns the bits; each NaN has the canonical ones.
    #[inline(always)]
    pub fn to_bits(self) -> Whole {
        let bits = |value: f32| if value.is_nan() { 0x7fc0_0000 } else { value.to_bits() };
        Whole::new(self.0.map(|value| i64::from(bits(value))))
    }

    /// Returns the bits.
    #[inline(always)]
    pub fn raw_bits(self) -> Whole {
        Whole::new(self.0.map(|value| i64::from(value.to_bits())))
    }

    /// Converts to double precision.
    #[inline(always)]
    pub fn real(self) -> Real {
        Real::new(self.0.map(f64::from))
    }

    /// Returns the number of each lane.
    #[inline(always)]
    pub fn to_array(self) -> [f32; LANES] {
        self.0
    }

    /// Replaces the number of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: f32) {
        self.0[lane % LANES] = value;
    }
}
