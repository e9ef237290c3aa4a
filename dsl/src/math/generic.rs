//! The DSL's functions for code that is generic over `Float`, `FloatCore`, `Signed` or `Euclid` of `num_traits`, or
//! nalgebra's `RealField`. Each float has the same bits as in code that names it.
//!
//! The methods have `&self` receivers: if the type is known, rustc finds the methods of the float itself first, which
//! have `self`.
//!
//! Invariant: each float that implements these traits is `f32`, or a number that `f64` represents exactly.

use nalgebra::RealField;
use num_traits::float::FloatCore;
use num_traits::{Euclid, Float, Signed};

use super::methods::elementary;
use super::{ElementaryMethods, FloatMethods, OrderMethods, RoundMethods, SignMethods};

/// Calls a function of `f32` for types of the width of `f32`, and one of `f64` for wider types; `$to` and `$from`
/// convert.
macro_rules! of_either {
    ($self:ident, $name:ident ($($argument:ident),*) [$($other:ident),*], $to:path, $from:path) => {
        match size_of_val($self) {
            4 => $from(f64::from(($to($self) as f32).$name($($to($argument) as f32,)* $($other),*))),
            _ => $from($to($self).$name($($to($argument),)* $($other),*)),
        }
    };
}

macro_rules! generic {
    ($(#[$doc:meta])* $trait:ident: $bound:ident, $to:path, $from:path;
        $($name:ident($($argument:ident),*) [$($other:ident: $ty:ty),*];)*) => {
        $(#[$doc])*
        #[allow(missing_docs)]
        pub trait $trait: Sized {
            $(fn $name(&self, $($argument: Self,)* $($other: $ty),*) -> Self;)*
            fn dsl_sin_cos(&self) -> (Self, Self);
            fn dsl_is_sign_negative(&self) -> bool;
            fn dsl_is_sign_positive(&self) -> bool;
        }

        impl<T: $bound> $trait for T {
            $(fn $name(&self, $($argument: T,)* $($other: $ty),*) -> T {
                $(let $argument = &$argument;)*
                of_either!(self, $name($($argument),*) [$($other),*], $to, $from)
            })*
            fn dsl_sin_cos(&self) -> (T, T) {
                (self.dsl_sin(), self.dsl_cos())
            }
            fn dsl_is_sign_negative(&self) -> bool {
                $to(self).dsl_is_sign_negative()
            }
            fn dsl_is_sign_positive(&self) -> bool {
                $to(self).dsl_is_sign_positive()
            }
        }
    };
}

macro_rules! generics {
    ($($name:ident($($argument:ident),*) [$($other:ident: $ty:ty),*];)*) => {
        generic! {
            /// Methods of a type parameter with the bound `num_traits::Float`.
            AnyFloatMethods: Float, float_as_f64, float_of;
            $($name($($argument),*) [$($other: $ty),*];)*
        }
        generic! {
            /// Methods of a type with the bound `num_traits::float::FloatCore`.
            AnyCoreMethods: FloatCore, core_as_f64, core_of;
            $($name($($argument),*) [$($other: $ty),*];)*
        }
        generic! {
            /// Methods of a type parameter with nalgebra's bound `RealField`.
            AnyRealMethods: RealField, real_as_f64, real_of;
            $($name($($argument),*) [$($other: $ty),*];)*
        }
    };
}

/// Lists all methods: the elementary functions, and the exact ones.
macro_rules! all {
    ($(
        $(#[$doc:meta])*
        $kind:ident: $name:ident $companion:ident($($argument:ident),*) [$($other:ident: $ty:ty),*]
            = $double:path, $single:path;
    )*) => {
        generics! {
            $($name($($argument),*) [$($other: $ty),*];)*
            dsl_sqrt() [];
            dsl_floor() [];
            dsl_copysign(sign) [];
            dsl_ceil() [];
            dsl_trunc() [];
            dsl_round() [];
            dsl_fract() [];
            dsl_to_degrees() [];
            dsl_to_radians() [];
            dsl_abs() [];
            dsl_signum() [];
            dsl_min(other) [];
            dsl_max(other) [];
            dsl_clamp(low, high) [];
        }
    };
}

elementary! { all }

fn float_as_f64<T: Float>(x: &T) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

fn float_of<T: Float>(x: f64) -> T {
    T::from(x).unwrap_or_else(T::nan)
}

fn core_as_f64<T: FloatCore>(x: &T) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

fn core_of<T: FloatCore>(x: f64) -> T {
    T::from(x).unwrap_or_else(T::nan)
}

fn real_as_f64<T: RealField>(x: &T) -> f64 {
    x.to_subset_unchecked()
}

fn real_of<T: RealField>(x: f64) -> T {
    nalgebra::convert(x)
}

/// Methods of a type with the bound `num_traits::Signed`. That trait has them by these names, with the results of the
/// type's own.
#[allow(missing_docs)]
pub trait AnySignedMethods: Sized {
    fn dsl_abs(&self) -> Self;
    fn dsl_signum(&self) -> Self;
}

impl<T: Signed> AnySignedMethods for T {
    fn dsl_abs(&self) -> T {
        self.abs()
    }
    fn dsl_signum(&self) -> T {
        self.signum()
    }
}

/// Methods of a type with the bound `num_traits::Euclid`.
#[allow(missing_docs)]
pub trait AnyEuclidMethods: Sized {
    fn dsl_div_euclid(&self, by: &Self) -> Self;
    fn dsl_rem_euclid(&self, by: &Self) -> Self;
}

impl<T: Euclid> AnyEuclidMethods for T {
    fn dsl_div_euclid(&self, by: &T) -> T {
        self.div_euclid(by)
    }
    fn dsl_rem_euclid(&self, by: &T) -> T {
        self.rem_euclid(by)
    }
}
