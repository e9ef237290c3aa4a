//! Constants of a number in the DSL that are functions without parameters in `num_traits` and nalgebra: `T::zero()`; and
//! comparisons with them.

// `==` of floats is none in the C.
#![allow(clippy::double_comparisons)]

use crate::prelude::*;

/// 0.
#[function(expand)]
pub fn zero<T: Real>() -> T {
    T::ZERO
}

/// 1.
#[function(expand)]
pub fn one<T: Real>() -> T {
    T::ONE
}

/// The distance from 1 to the next larger number.
#[function(expand)]
pub fn epsilon<T: Real>() -> T {
    T::EPSILON
}

/// ∞.
#[function(expand)]
pub fn infinity<T: Real>() -> T {
    T::INFINITY
}

/// −∞.
#[function(expand)]
pub fn neg_infinity<T: Real>() -> T {
    T::NEG_INFINITY
}

/// Not a number.
#[function(expand)]
pub fn nan<T: Real>() -> T {
    T::NAN
}

/// The largest finite number.
#[function(expand)]
pub fn max_value<T: Real>() -> T {
    T::MAX
}

/// The lowest finite number.
#[function(expand)]
pub fn min_value<T: Real>() -> T {
    T::MIN
}

/// The largest finite number; an `Option` as in nalgebra, where a field need not have one.
#[function(expand)]
pub fn largest<T: Real>() -> Option<T> {
    Some(T::MAX)
}

/// The lowest finite number; an `Option` as in nalgebra, where a field need not have one.
#[function(expand)]
pub fn smallest<T: Real>() -> Option<T> {
    Some(T::MIN)
}

/// The smallest positive number that is not subnormal.
#[function(expand)]
pub fn min_positive_value<T: Real>() -> T {
    T::MIN_POSITIVE
}

/// π.
#[function(expand)]
pub fn pi<T: Real>() -> T {
    T::PI
}

/// 2π.
#[function(expand)]
pub fn two_pi<T: Real>() -> T {
    T::TAU
}

/// π/2.
#[function(expand)]
pub fn frac_pi_2<T: Real>() -> T {
    T::PI / real(2.0)
}

/// π/4.
#[function(expand)]
pub fn frac_pi_4<T: Real>() -> T {
    T::PI / real(4.0)
}

/// π/6.
#[function(expand)]
pub fn frac_pi_6<T: Real>() -> T {
    real(core::f64::consts::FRAC_PI_6)
}

/// π/8.
#[function(expand)]
pub fn frac_pi_8<T: Real>() -> T {
    T::PI / real(8.0)
}

/// Defines constants, each the number of the type that is nearest to the one in double precision.
macro_rules! nearest {
    ($($name:ident $constant:ident;)*) => {$(
        #[doc = concat!("`", stringify!($constant), "` of `core::f64::consts`.")]
        #[function(expand)]
        pub fn $name<T: Real>() -> T {
            real(core::f64::consts::$constant)
        }
    )*};
}

nearest! {
    euler E;
    frac_1_pi FRAC_1_PI;
    frac_1_sqrt_2 FRAC_1_SQRT_2;
    frac_2_pi FRAC_2_PI;
    frac_2_sqrt_pi FRAC_2_SQRT_PI;
    frac_pi_3 FRAC_PI_3;
    ln_10 LN_10;
    ln_2 LN_2;
    log10_2 LOG10_2;
    log10_e LOG10_E;
    log2_10 LOG2_10;
    log2_e LOG2_E;
    sqrt_2 SQRT_2;
}

/// The distance from 1 to the next larger number.
#[function(expand)]
pub fn default_epsilon<T: Real>() -> T {
    T::EPSILON
}

/// Returns true if a number is 0.
#[function(expand)]
pub fn is_zero<T: Real>(number: &T) -> bool {
    *number <= T::ZERO && *number >= T::ZERO
}

/// Returns true if a number is 1.
#[function(expand)]
pub fn is_one<T: Real>(number: &T) -> bool {
    *number <= T::ONE && *number >= T::ONE
}

/// 0.
#[function(expand)]
pub fn integer_zero<T: Integer>() -> T {
    T::ZERO
}

/// 1.
#[function(expand)]
pub fn integer_one<T: Integer>() -> T {
    T::ONE
}

/// The largest value.
#[function(expand)]
pub fn integer_max_value<T: Integer>() -> T {
    T::MAX
}

/// The smallest value.
#[function(expand)]
pub fn integer_min_value<T: Integer>() -> T {
    T::MIN
}

/// Returns true if an integer is 0.
#[function(expand)]
pub fn integer_is_zero<T: Integer>(number: &T) -> bool {
    *number == T::ZERO
}

/// Returns true if an integer is 1.
#[function(expand)]
pub fn integer_is_one<T: Integer>(number: &T) -> bool {
    *number == T::ONE
}
