//! The companions of the elementary functions.

use super::builder::Callee;
use super::builtin::companions;
use super::slot::Called;
use crate::math::{
    arctangent, exponential, fused, hyperbolic, logarithm, of_f32, power, roots, sine, tangent,
};

/// The companions, and which function each is in double and in single precision.
macro_rules! elementary {
    ($(
        $kind:ident $companion:ident($($operand:ident: $ty:ty),*) -> $result:ty: $double:ty, $single:ty;
    )*) => {
        companions! {
            /// Elementary functions of floats.
            pub trait ElementaryBuiltins: Sized {
                $(type $kind: Callee;)*
                $(fn $companion(self $(, $operand: $ty)*) -> $result = [Self::$kind];)*
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

elementary! {
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
