//! The scalar functions, defined by the DSL so that every target computes the same bits.
//!
//! In an annotated item `x.sin()` is rewritten to `x.dsl_sin()`, a method of the traits here. Functions that hardware
//! computes exactly (`sqrt`, `abs`, `floor`, …) are operations of the IR. The elementary functions are written in the
//! DSL itself, so that a target's C is generated from the Rust that the simulation runs.
//!
//! Where Rust does not define a result, it is defined here: `min` and `max` treat −0 as less than +0, and return the
//! other operand for a NaN; a NaN has a positive sign and canonical bits for `copysign` and `to_bits`.
//!
//! Floats are not compared by `==`, here or in the C, because some compilers report that as an error
//! (`-Wfloat-equal`). For a number that is not negative, `x <= 0.0` has the same meaning.
//!
//! Accuracy: `docs/mathematics.md` lists the largest error found for each function.

pub mod arctangent;
pub mod ascii;
pub mod checked;
#[doc(hidden)]
pub mod constants;
pub mod exponential;
pub mod extremes;
mod float;
pub mod fused;
mod generic;
pub mod hyperbolic;
pub mod integer;
mod integral;
pub mod logarithm;
mod matrix;
mod methods;
pub mod narrow;
mod number;
pub mod pair;
pub mod power;
pub mod reduction;
pub mod roots;
pub mod sine;
pub mod single;
pub mod tables;
pub mod tangent;
pub mod whole;

/// The functions of `f32`, as chosen by the feature `single`: computed in double precision, or in `f32` alone.
#[cfg(feature = "single")]
pub(crate) use narrow as of_f32;
#[cfg(not(feature = "single"))]
pub(crate) use single as of_f32;

use core::cmp::Ordering;

#[doc(hidden)]
pub use crate::complex::{ComplexMethods, RealMethods};
#[doc(hidden)]
pub use crate::rotation::{
    AngleMethods, BetweenMethods, EulerMethods, RotationMethods, TurnMethods,
};
use crate::{comparison, search, sort};
pub use float::{Real, real};
#[doc(hidden)]
pub use generic::{
    AnyCoreMethods, AnyEuclidMethods, AnyFloatMethods, AnyRealMethods, AnySignedMethods,
};
pub use integral::Integer;
pub use matrix::{MatrixMethods, SquareMethods};
#[doc(hidden)]
pub use methods::AbsentMethods;
pub use methods::ElementaryMethods;
#[cfg(feature = "generate")]
pub(crate) use methods::elementary;
pub use number::{DivisionMethods, RoundMethods, SignMethods};

/// Methods of floats that the attributes redirect to the DSL.
pub trait FloatMethods: Copy {
    /// The unsigned integer of the same width.
    type Bits;
    /// The square root, correctly rounded.
    fn dsl_sqrt(self) -> Self;
    /// The largest integer that is not above the number.
    fn dsl_floor(self) -> Self;
    /// The number's magnitude with the sign of `sign`.
    fn dsl_copysign(self, sign: Self) -> Self;
    /// The bits; every NaN has the same bits.
    fn dsl_to_bits(self) -> Self::Bits;
}

/// The bits of a float without a test for NaN, for the functions of this module.
#[doc(hidden)]
pub trait RawBits {
    /// The unsigned integer of the same width.
    type Bits;
    /// The bits of a number that is not a NaN; the bits of a NaN differ between machines.
    fn raw_bits(self) -> Self::Bits;
}

impl RawBits for f64 {
    type Bits = u64;
    fn raw_bits(self) -> u64 {
        self.to_bits()
    }
}

impl RawBits for f32 {
    type Bits = u32;
    fn raw_bits(self) -> u32 {
        self.to_bits()
    }
}

/// Minimum, maximum and limits of floats, which the attributes redirect to the DSL.
pub trait OrderMethods: Copy {
    /// The smaller of two numbers: −0 is less than +0, and a NaN gives the other number.
    fn dsl_min(self, other: Self) -> Self;
    /// The larger of two numbers: −0 is less than +0, and a NaN gives the other number.
    fn dsl_max(self, other: Self) -> Self;
    /// The nearest value from `low` to `high`; NaN stays NaN.
    ///
    /// # Panics
    /// Unless `low <= high`: a fault of the entry point.
    fn dsl_clamp(self, low: Self, high: Self) -> Self;
}

/// Methods of all types with a total order by `Ord`: integers, plain enums, and references to them.
///
/// They are implemented for every type with `Ord`, so that rustc finds these methods exactly where it finds those of
/// `Ord`.
pub trait RankMethods: Copy + Ord {
    /// The lesser of two values; the first if they are equal.
    fn dsl_min(self, other: Self) -> Self;
    /// The greater of two values; the second if they are equal.
    fn dsl_max(self, other: Self) -> Self;
    /// The nearest value from `low` to `high`.
    ///
    /// # Panics
    /// Unless `low <= high`: a fault of the entry point.
    fn dsl_clamp(self, low: Self, high: Self) -> Self;
}

impl<T: Copy + Ord> RankMethods for T {
    fn dsl_min(self, other: T) -> T {
        comparison::lesser(self, other)
    }
    fn dsl_max(self, other: T) -> T {
        comparison::greater(self, other)
    }
    fn dsl_clamp(self, low: T, high: T) -> T {
        comparison::limited(self, low, high)
    }
}

/// Binary search in a sorted slice: among equal elements, the simulation and the C find the same one.
pub trait SearchMethods<T> {
    /// The index of an element equal to `wanted`.
    ///
    /// # Errors
    ///
    /// The index at which it could be inserted, if no element is equal.
    fn dsl_binary_search(&self, wanted: &T) -> Result<usize, usize>
    where
        T: Ord;
    /// The index of an element for which `order` returns `Equal`.
    ///
    /// # Errors
    ///
    /// The index at which one could be inserted, if there is no such element.
    fn dsl_binary_search_by(&self, order: impl Fn(&T) -> Ordering) -> Result<usize, usize>;
    /// The index of an element with this key.
    ///
    /// # Errors
    ///
    /// The index at which one could be inserted, if there is no such element.
    fn dsl_binary_search_by_key<B: Copy + Ord>(
        &self,
        wanted: &B,
        key: impl Fn(&T) -> B,
    ) -> Result<usize, usize>;
    /// The index of the first element for which `is_first` does not hold.
    fn dsl_partition_point(&self, is_first: impl Fn(&T) -> bool) -> usize;
}

impl<T: Copy> SearchMethods<T> for [T] {
    fn dsl_binary_search(&self, wanted: &T) -> Result<usize, usize>
    where
        T: Ord,
    {
        search::binary_search(self, *wanted)
    }
    fn dsl_binary_search_by(&self, order: impl Fn(&T) -> Ordering) -> Result<usize, usize> {
        search::binary_search_by(self, order)
    }
    fn dsl_binary_search_by_key<B: Copy + Ord>(
        &self,
        wanted: &B,
        key: impl Fn(&T) -> B,
    ) -> Result<usize, usize> {
        search::binary_search_by_key(self, *wanted, key)
    }
    fn dsl_partition_point(&self, is_first: impl Fn(&T) -> bool) -> usize {
        search::partition_point(self, is_first)
    }
}

/// The total order of floats.
pub trait TotalMethods {
    /// As core's `total_cmp`, except that any NaN is greater than all numbers: the sign of a NaN differs between
    /// machines.
    fn dsl_total_cmp(&self, other: &Self) -> Ordering;
}

impl<T: Real> TotalMethods for T {
    fn dsl_total_cmp(&self, other: &T) -> Ordering {
        match (sort::below(*self, *other), sort::below(*other, *self)) {
            (true, _) => Ordering::Less,
            (_, true) => Ordering::Greater,
            _ => Ordering::Equal,
        }
    }
}

macro_rules! floats {
    ($($float:ident, $bits:ident, $sqrt:ident, $floor:ident, $nan:literal;)*) => {$(
        impl FloatMethods for $float {
            type Bits = $bits;
            fn dsl_sqrt(self) -> $float {
                libm::$sqrt(self)
            }
            fn dsl_floor(self) -> $float {
                libm::$floor(self)
            }
            fn dsl_copysign(self, sign: $float) -> $float {
                // The sign of a NaN differs between machines.
                let sign = if sign.is_nan() { 0.0 } else { sign };
                self.copysign(sign)
            }
            fn dsl_to_bits(self) -> $bits {
                if self.is_nan() { $nan } else { self.to_bits() }
            }
        }

        impl OrderMethods for $float {
            fn dsl_min(self, other: $float) -> $float {
                let first = self < other
                    || other.is_nan()
                    || (self == other && self.is_sign_negative());
                if first { self } else { other }
            }
            fn dsl_max(self, other: $float) -> $float {
                let first = self > other
                    || other.is_nan()
                    || (self == other && self.is_sign_positive());
                if first { self } else { other }
            }
            fn dsl_clamp(self, low: $float, high: $float) -> $float {
                self.clamp(low, high)
            }
        }
    )*};
}

floats! {
    f64, u64, sqrt, floor, 0x7ff8_0000_0000_0000;
    f32, u32, sqrtf, floorf, 0x7fc0_0000;
}

/// The bytes of numbers, which the attributes redirect to the DSL: every NaN has the same bytes.
pub trait ByteMethods: Copy {
    /// An array with one `u8` for each byte of the number.
    type Bytes;
    /// The bytes, the least significant first.
    fn dsl_to_le_bytes(self) -> Self::Bytes;
    /// The bytes, the most significant first.
    fn dsl_to_be_bytes(self) -> Self::Bytes;
}

macro_rules! bytes {
    ($($number:ty, $bits:ident;)*) => {$(
        impl ByteMethods for $number {
            type Bytes = [u8; size_of::<$number>()];
            fn dsl_to_le_bytes(self) -> Self::Bytes {
                $bits(self).to_le_bytes()
            }
            fn dsl_to_be_bytes(self) -> Self::Bytes {
                $bits(self).to_be_bytes()
            }
        }
    )*};
}

fn same<T>(number: T) -> T {
    number
}

fn bits<T: FloatMethods>(number: T) -> T::Bits {
    number.dsl_to_bits()
}

bytes! {
    u8, same; i8, same; u16, same; i16, same; u32, same; i32, same; u64, same; i64, same; u128, same; i128, same;
    usize, same; isize, same; f32, bits; f64, bits;
}
