//! The companions of the elementary functions.

use super::builder::Callee;
use super::builtin::signatures;
use super::slot::Called;
use crate::math::{
    arctangent, exponential, fused, hyperbolic, logarithm, of_f32, power, roots, sine, tangent,
};

/// Elementary functions of floats.
#[allow(missing_docs)]
pub trait ElementaryBuiltins: Sized {
    type Sin: Callee;
    type Cos: Callee;
    type Tan: Callee;
    type Asin: Callee;
    type Acos: Callee;
    type Atan: Callee;
    type Exp: Callee;
    type Exp2: Callee;
    type ExpM1: Callee;
    type Ln: Callee;
    type Log2: Callee;
    type Log10: Callee;
    type Ln1p: Callee;
    type Sinh: Callee;
    type Cosh: Callee;
    type Tanh: Callee;
    type Cbrt: Callee;
    type Atan2: Callee;
    type Powf: Callee;
    type Hypot: Callee;
    type Powi: Callee;
    type MulAdd: Callee;
    type SinCos: Callee;
    signatures! {
        fn __b_sin(self) -> Called<Self::Sin, Self>;
        fn __b_cos(self) -> Called<Self::Cos, Self>;
        fn __b_tan(self) -> Called<Self::Tan, Self>;
        fn __b_asin(self) -> Called<Self::Asin, Self>;
        fn __b_acos(self) -> Called<Self::Acos, Self>;
        fn __b_atan(self) -> Called<Self::Atan, Self>;
        fn __b_exp(self) -> Called<Self::Exp, Self>;
        fn __b_exp2(self) -> Called<Self::Exp2, Self>;
        fn __b_exp_m1(self) -> Called<Self::ExpM1, Self>;
        fn __b_ln(self) -> Called<Self::Ln, Self>;
        fn __b_log2(self) -> Called<Self::Log2, Self>;
        fn __b_log10(self) -> Called<Self::Log10, Self>;
        fn __b_ln_1p(self) -> Called<Self::Ln1p, Self>;
        fn __b_sinh(self) -> Called<Self::Sinh, Self>;
        fn __b_cosh(self) -> Called<Self::Cosh, Self>;
        fn __b_tanh(self) -> Called<Self::Tanh, Self>;
        fn __b_cbrt(self) -> Called<Self::Cbrt, Self>;
        fn __b_atan2(self, _x: Self) -> Called<Self::Atan2, Self>;
        fn __b_powf(self, _y: Self) -> Called<Self::Powf, Self>;
        fn __b_hypot(self, _y: Self) -> Called<Self::Hypot, Self>;
        fn __b_powi(self, _n: i32) -> Called<Self::Powi, Self>;
        fn __b_mul_add(self, _a: Self, _b: Self) -> Called<Self::MulAdd, Self>;
        fn __b_sin_cos(self) -> Called<Self::SinCos, (Self, Self)>;
    }
}

impl ElementaryBuiltins for f64 {
    type Sin = sine::sin;
    type Cos = sine::cos;
    type Tan = tangent::tan;
    type Asin = arctangent::asin;
    type Acos = arctangent::acos;
    type Atan = arctangent::atan;
    type Exp = exponential::exp;
    type Exp2 = exponential::exp2;
    type ExpM1 = exponential::exp_m1;
    type Ln = logarithm::ln;
    type Log2 = logarithm::log2;
    type Log10 = logarithm::log10;
    type Ln1p = logarithm::ln_1p;
    type Sinh = hyperbolic::sinh;
    type Cosh = hyperbolic::cosh;
    type Tanh = hyperbolic::tanh;
    type Cbrt = roots::cbrt;
    type Atan2 = arctangent::atan2;
    type Powf = power::powf;
    type Hypot = roots::hypot;
    type Powi = power::powi;
    type MulAdd = fused::mul_add;
    type SinCos = sine::sin_cos;
}

impl ElementaryBuiltins for f32 {
    type Sin = of_f32::sinf;
    type Cos = of_f32::cosf;
    type Tan = of_f32::tanf;
    type Asin = of_f32::asinf;
    type Acos = of_f32::acosf;
    type Atan = of_f32::atanf;
    type Exp = of_f32::expf;
    type Exp2 = of_f32::exp2f;
    type ExpM1 = of_f32::exp_m1f;
    type Ln = of_f32::lnf;
    type Log2 = of_f32::log2f;
    type Log10 = of_f32::log10f;
    type Ln1p = of_f32::ln_1pf;
    type Sinh = of_f32::sinhf;
    type Cosh = of_f32::coshf;
    type Tanh = of_f32::tanhf;
    type Cbrt = of_f32::cbrtf;
    type Atan2 = of_f32::atan2f;
    type Powf = of_f32::powff;
    type Hypot = of_f32::hypotf;
    type Powi = of_f32::powif;
    type MulAdd = fused::mul_addf;
    type SinCos = of_f32::sin_cosf;
}
