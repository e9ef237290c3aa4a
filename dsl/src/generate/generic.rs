//! The companions of the elementary functions, and of what `num_traits::Float` and nalgebra's `RealField` have: those of
//! the float that a function is built for.
//!
//! As in [`crate::math`], these take the receiver by reference, so that a known float's own companion is found first.

#![allow(non_camel_case_types)]

use core::marker::PhantomData;

use bessemer_ir::tree::{self, Ty};
use bessemer_ir::{Float, Scalar};

use nalgebra::{Const, OPoint, RealField};
use num_traits::Float as Number;

use super::builder::{Builder, Callee};
use super::companions::{calls, companions};
use super::numbers;
use super::slot::{Called, DslType};
use crate::linear::norms;
use crate::math::{
    Real, arctangent, constants, exponential, fused, hyperbolic, logarithm, of_f32, power, roots,
    sine, tangent,
};

/// The marker of what each float has a function of its own for: in double and in single precision.
pub struct Either<T, D, S>(PhantomData<(T, D, S)>);

impl<T: DslType, D: Callee, S: Callee> Callee for Either<T, D, S> {
    fn callee(cx: &mut Builder) -> tree::Callee {
        match T::ty(cx) == Ty::Scalar(Scalar::Float(Float::F32)) {
            true => S::callee(cx),
            false => D::callee(cx),
        }
    }
}

/// Elementary functions, and which one each is in double and in single precision; what is an operation of either float;
/// and constants.
macro_rules! floats {
    (
        elementary { $($kind:ident $companion:ident($($operand:ident: $ty:ty),*) -> $result:ty: $double:ty, $single:ty;)* }
        operations { $($operation:ident($($other:ident),*) -> $gives:ty: $marker:ty;)* }
        constants { $($constant:ident $function:ident;)* }
    ) => {
        companions! {
            /// Elementary functions of floats.
            pub trait ElementaryBuiltins: Sized {
                $(fn $companion(self $(, $operand: $ty)*) -> $result = <$kind>;)*
            }
            /// What is known to be a `num_traits::Float` has.
            pub trait AnyFloatBuiltins: Sized {
                $(fn $companion(&self $(, $operand: $ty)*) -> $result = [Either<Self, $double, $single>];)*
                $(fn $operation(&self $(, $other: Self)*) -> $gives = [$marker];)*
                $(fn $constant() -> Self = [Either<Self, constants::$function<f64>, constants::$function<f32>>];)*
            }
            /// What is known to be nalgebra's `RealField` has.
            pub trait AnyRealBuiltins: Sized {
                $(fn $companion(&self $(, $operand: $ty)*) -> $result = [Either<Self, $double, $single>];)*
                $(fn $operation(&self $(, $other: Self)*) -> $gives = [$marker];)*
                $(fn $constant() -> Self = [Either<Self, constants::$function<f64>, constants::$function<f32>>];)*
            }
        }

        impl ElementaryBuiltins for f64 {
            $(type $kind = $double;)*
        }

        impl ElementaryBuiltins for f32 {
            $(type $kind = $single;)*
        }
    };
}

floats! {
    elementary {
        Sin __b_sin() -> Self: sine::sin, of_f32::sinf;
        Cos __b_cos() -> Self: sine::cos, of_f32::cosf;
        Tan __b_tan() -> Self: tangent::tan, of_f32::tanf;
        Asin __b_asin() -> Self: arctangent::asin, of_f32::asinf;
        Acos __b_acos() -> Self: arctangent::acos, of_f32::acosf;
        Atan __b_atan() -> Self: arctangent::atan, of_f32::atanf;
        Exp __b_exp() -> Self: exponential::exp, of_f32::expf;
        Exp2 __b_exp2() -> Self: exponential::exp2, of_f32::exp2f;
        ExpM1 __b_exp_m1() -> Self: exponential::exp_m1, of_f32::exp_m1f;
        Ln __b_ln() -> Self: logarithm::ln, of_f32::lnf;
        Log2 __b_log2() -> Self: logarithm::log2, of_f32::log2f;
        Log10 __b_log10() -> Self: logarithm::log10, of_f32::log10f;
        Ln1p __b_ln_1p() -> Self: logarithm::ln_1p, of_f32::ln_1pf;
        Sinh __b_sinh() -> Self: hyperbolic::sinh, of_f32::sinhf;
        Cosh __b_cosh() -> Self: hyperbolic::cosh, of_f32::coshf;
        Tanh __b_tanh() -> Self: hyperbolic::tanh, of_f32::tanhf;
        Cbrt __b_cbrt() -> Self: roots::cbrt, of_f32::cbrtf;
        Atan2 __b_atan2(_x: Self) -> Self: arctangent::atan2, of_f32::atan2f;
        Powf __b_powf(_y: Self) -> Self: power::powf, of_f32::powff;
        Hypot __b_hypot(_y: Self) -> Self: roots::hypot, of_f32::hypotf;
        Powi __b_powi(_n: i32) -> Self: power::powi, of_f32::powif;
        MulAdd __b_mul_add(_a: Self, _b: Self) -> Self: fused::mul_add, fused::mul_addf;
        SinCos __b_sin_cos() -> (Self, Self): sine::sin_cos, of_f32::sin_cosf;
    }
    operations {
        __b_sqrt() -> Self: numbers::Sqrt;
        __b_floor() -> Self: numbers::Floor;
        __b_ceil() -> Self: numbers::Ceil;
        __b_trunc() -> Self: numbers::Trunc;
        __b_round() -> Self: numbers::Round;
        __b_fract() -> Self: numbers::Fract;
        __b_recip() -> Self: numbers::Recip;
        __b_to_degrees() -> Self: numbers::ToDegrees;
        __b_to_radians() -> Self: numbers::ToRadians;
        __b_abs() -> Self: numbers::Abs;
        __b_signum() -> Self: numbers::Signum;
        __b_is_nan() -> bool: numbers::IsNan;
        __b_is_finite() -> bool: numbers::IsFinite;
        __b_is_infinite() -> bool: numbers::IsInfinite;
        __b_copysign(_sign) -> Self: numbers::Copysign;
        __b_min(_other) -> Self: numbers::Min;
        __b_max(_other) -> Self: numbers::Max;
        __b_clamp(_low, _high) -> Self: numbers::Clamp;
    }
    constants {
        __b_zero __function_zero;
        __b_one __function_one;
        __b_epsilon __function_epsilon;
        __b_infinity __function_infinity;
        __b_neg_infinity __function_neg_infinity;
        __b_nan __function_nan;
        __b_max_value __function_max_value;
        __b_min_value __function_min_value;
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

impl<T: Number> AnyFloatBuiltins for T {}
impl<T: RealField> AnyRealBuiltins for T {}

/// Stands for `nalgebra::convert` of a number in double precision: [`real`](crate::math::real).
pub struct convert;

/// Stands for nalgebra's function of that name.
pub struct distance;

/// Stands for nalgebra's function of that name.
pub struct distance_squared;

calls! {
    convert[T: RealField](_: f64) -> T = [numbers::Real];
    distance[T: Real, const N: usize](_p: &OPoint<T, Const<N>>, _q: &OPoint<T, Const<N>>) -> T
        = [norms::__function_distance<T, N>];
    distance_squared[T: Real, const N: usize](_p: &OPoint<T, Const<N>>, _q: &OPoint<T, Const<N>>) -> T
        = [norms::__function_distance_squared<T, N>];
}
