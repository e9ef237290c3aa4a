//! The companions of the elementary functions, and of the methods of `Float`, `FloatCore` and `RealField`. A function is
//! built for one float, and has the companions of that float.
//!
//! As in [`crate::math`], they take the receiver by reference, so that rustc finds a known float's own companion
//! first.

#![allow(non_camel_case_types)]

use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::Ty;
use bessemer_tree::number::{Float, Scalar};

use nalgebra::{Const, OPoint, RealField};
use num_traits::Float as Number;
use num_traits::float::FloatCore;

use super::builder::{Builder, Callee};
use super::companions::{calls, companions};
use super::numbers;
use super::slot::{Called, DslType};
use crate::linear::norms;
use crate::math::{
    Real, arctangent, constants, elementary, exponential, fused, hyperbolic, logarithm, of_f32,
    power, roots, sine, tangent,
};

/// Marker of a function with separate versions for double and single precision.
pub struct Either<T, D, S>(PhantomData<(T, D, S)>);

impl<T: DslType, D: Callee, S: Callee> Callee for Either<T, D, S> {
    fn callee(cx: &mut Builder) -> tree::Callee {
        match T::ty(cx) == Ty::Scalar(Scalar::Float(Float::F32)) {
            true => S::callee(cx),
            false => D::callee(cx),
        }
    }
}

/// Defines the companions of elementary functions for each float, and for the one that a function is built for.
macro_rules! floats {
    ($(
        $(#[$doc:meta])*
        $kind:ident: $method:ident $companion:ident($($operand:ident),*) [$($other:ident: $ty:ty),*]
            = $double:path, $single:path;
    )*) => {
        companions! {
            /// Elementary functions of floats.
            pub trait ElementaryBuiltins: Sized {
                $(fn $companion(self $(, $operand: Self)* $(, $other: $ty)*) -> Self = <$kind>;)*
                fn __b_sin_cos(self) -> (Self, Self) = <SinCos>;
            }
        }

        impl ElementaryBuiltins for f64 {
            $(type $kind = $double;)*
            type SinCos = sine::sin_cos;
        }

        impl ElementaryBuiltins for f32 {
            $(type $kind = $single;)*
            type SinCos = of_f32::sin_cosf;
        }

        either! {
            methods {
                $($companion($($operand: Self,)* $($other: $ty),*) -> Self = Either<Self, $double, $single>;)*
                __b_sin_cos() -> (Self, Self) = Either<Self, sine::sin_cos, of_f32::sin_cosf>;
                __b_sqrt() -> Self = numbers::Sqrt;
                __b_floor() -> Self = numbers::Floor;
                __b_ceil() -> Self = numbers::Ceil;
                __b_trunc() -> Self = numbers::Trunc;
                __b_round() -> Self = numbers::Round;
                __b_fract() -> Self = numbers::Fract;
                __b_try_sqrt() -> Option<Self> = roots::__function_try_sqrt<Self>;
                __b_recip() -> Self = numbers::Recip;
                __b_to_degrees() -> Self = numbers::ToDegrees;
                __b_to_radians() -> Self = numbers::ToRadians;
                __b_abs() -> Self = numbers::Abs;
                __b_modulus() -> Self = numbers::Modulus;
                __b_signum() -> Self = numbers::Signum;
                __b_is_nan() -> bool = numbers::IsNan;
                __b_is_finite() -> bool = numbers::IsFinite;
                __b_is_infinite() -> bool = numbers::IsInfinite;
                __b_is_sign_negative() -> bool = numbers::IsSignNegative;
                __b_is_sign_positive() -> bool = numbers::IsSignPositive;
                __b_copysign(_sign: Self) -> Self = numbers::Copysign;
                __b_min(_other: Self) -> Self = numbers::Min;
                __b_max(_other: Self) -> Self = numbers::Max;
                __b_clamp(_low: Self, _high: Self) -> Self = numbers::Clamp;
            }
            constants {
                __b_zero __function_zero;
                __b_one __function_one;
                __b_epsilon __function_epsilon;
                __b_infinity __function_infinity;
                __b_neg_infinity __function_neg_infinity;
                __b_nan __function_nan;
                __b_min_positive_value __function_min_positive_value;
                __b_pi __function_pi;
                __b_two_pi __function_two_pi;
                __b_frac_pi_2 __function_frac_pi_2;
                __b_frac_pi_3 __function_frac_pi_3;
                __b_frac_pi_4 __function_frac_pi_4;
                __b_frac_pi_6 __function_frac_pi_6;
                __b_frac_pi_8 __function_frac_pi_8;
                __b_default_epsilon __function_default_epsilon;
            }
        }
    };
}

/// Defines companions of a generic float.
macro_rules! either {
    (
        methods { $($companion:ident($($operand:ident: $ty:ty),* $(,)?) -> $result:ty = $marker:ty;)* }
        constants { $($constant:ident $function:ident;)* }
    ) => {
        companions! {
            /// Companions of a `num_traits::Float`.
            pub trait AnyFloatBuiltins: Sized {
                $(fn $companion(&self $(, $operand: $ty)*) -> $result = [$marker];)*
                $(fn $constant() -> Self = [Either<Self, constants::$function<f64>, constants::$function<f32>>];)*
                fn __b_max_value() -> Self = [Either<Self, constants::__function_max_value<f64>, constants::__function_max_value<f32>>];
                fn __b_min_value() -> Self = [Either<Self, constants::__function_min_value<f64>, constants::__function_min_value<f32>>];
            }
            /// Companions of a `num_traits::float::FloatCore`.
            pub trait AnyCoreBuiltins: Sized {
                $(fn $companion(&self $(, $operand: $ty)*) -> $result = [$marker];)*
                $(fn $constant() -> Self = [Either<Self, constants::$function<f64>, constants::$function<f32>>];)*
                fn __b_max_value() -> Self = [Either<Self, constants::__function_max_value<f64>, constants::__function_max_value<f32>>];
                fn __b_min_value() -> Self = [Either<Self, constants::__function_min_value<f64>, constants::__function_min_value<f32>>];
            }
            /// Companions of nalgebra's `RealField`, whose largest number is optional.
            pub trait AnyRealBuiltins: Sized {
                $(fn $companion(&self $(, $operand: $ty)*) -> $result = [$marker];)*
                $(fn $constant() -> Self = [Either<Self, constants::$function<f64>, constants::$function<f32>>];)*
                fn __b_max_value() -> Option<Self> = [Either<Self, constants::__function_largest<f64>, constants::__function_largest<f32>>];
                fn __b_min_value() -> Option<Self> = [Either<Self, constants::__function_smallest<f64>, constants::__function_smallest<f32>>];
            }
        }
    };
}

elementary! { floats }

impl<T: Number> AnyFloatBuiltins for T {}
impl<T: FloatCore> AnyCoreBuiltins for T {}
impl<T: RealField> AnyRealBuiltins for T {}

/// Carrier of `nalgebra::convert` from double precision, which is [`real`](crate::math::real).
pub struct convert;

/// Carrier of `nalgebra::distance`.
pub struct distance;

/// Carrier of `nalgebra::distance_squared`.
pub struct distance_squared;

calls! {
    convert[T: RealField](_: f64) -> T = [numbers::Real];
    distance[T: Real, const N: usize](_p: &OPoint<T, Const<N>>, _q: &OPoint<T, Const<N>>) -> T
        = [norms::__function_distance<T, N>];
    distance_squared[T: Real, const N: usize](_p: &OPoint<T, Const<N>>, _q: &OPoint<T, Const<N>>) -> T
        = [norms::__function_distance_squared<T, N>];
}
