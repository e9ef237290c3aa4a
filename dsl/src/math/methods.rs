//! The methods of floats that are elementary functions: what `x.sin()` in an annotated item means.

use super::{
    arctangent, exponential, fused, hyperbolic, logarithm, of_f32, power, roots, sine, tangent,
};

/// Elementary functions that the attributes redirect to the DSL.
pub trait ElementaryMethods: Copy {
    /// Sine of an angle in rad.
    fn dsl_sin(self) -> Self;
    /// Cosine of an angle in rad.
    fn dsl_cos(self) -> Self;
    /// Tangent of an angle in rad.
    fn dsl_tan(self) -> Self;
    /// Arcsine, rad; NaN outside −1 to 1.
    fn dsl_asin(self) -> Self;
    /// Arccosine, rad; NaN outside −1 to 1.
    fn dsl_acos(self) -> Self;
    /// Arctangent, rad.
    fn dsl_atan(self) -> Self;
    /// e^self.
    fn dsl_exp(self) -> Self;
    /// 2^self.
    fn dsl_exp2(self) -> Self;
    /// e^self − 1, without cancellation.
    fn dsl_exp_m1(self) -> Self;
    /// The natural logarithm.
    fn dsl_ln(self) -> Self;
    /// The logarithm to base 2.
    fn dsl_log2(self) -> Self;
    /// The logarithm to base 10.
    fn dsl_log10(self) -> Self;
    /// ln(1 + self), without cancellation.
    fn dsl_ln_1p(self) -> Self;
    /// The hyperbolic sine.
    fn dsl_sinh(self) -> Self;
    /// The hyperbolic cosine.
    fn dsl_cosh(self) -> Self;
    /// The hyperbolic tangent.
    fn dsl_tanh(self) -> Self;
    /// The cube root.
    fn dsl_cbrt(self) -> Self;
    /// The angle of the point (`x`, `self`) in rad, −π to π.
    fn dsl_atan2(self, x: Self) -> Self;
    /// self^y.
    fn dsl_powf(self, y: Self) -> Self;
    /// √(self² + y²), without overflow on the way.
    fn dsl_hypot(self, y: Self) -> Self;
    /// self^n, by squaring in the order of [`power::powi`].
    fn dsl_powi(self, n: i32) -> Self;
    /// self · a + b, rounded once.
    fn dsl_mul_add(self, a: Self, b: Self) -> Self;
    /// Sine and cosine of an angle in rad: the bits of either function.
    fn dsl_sin_cos(self) -> (Self, Self);
}

macro_rules! elementary {
    ($($float:ident: $($unary:ident $function:path),*; $($binary:ident $of_two:path),*; $powi:path, $mul_add:path, $sin_cos:path;)*) => {$(
        impl ElementaryMethods for $float {
            $(fn $unary(self) -> $float {
                $function(self)
            })*
            $(fn $binary(self, other: $float) -> $float {
                $of_two(self, other)
            })*
            fn dsl_powi(self, n: i32) -> $float {
                $powi(self, n)
            }
            fn dsl_mul_add(self, a: $float, b: $float) -> $float {
                $mul_add(self, a, b)
            }
            fn dsl_sin_cos(self) -> ($float, $float) {
                $sin_cos(self)
            }
        }
    )*};
}

elementary! {
    f64:
        dsl_sin sine::sin,
        dsl_cos sine::cos,
        dsl_tan tangent::tan,
        dsl_asin arctangent::asin,
        dsl_acos arctangent::acos,
        dsl_atan arctangent::atan,
        dsl_exp exponential::exp,
        dsl_exp2 exponential::exp2,
        dsl_exp_m1 exponential::exp_m1,
        dsl_ln logarithm::ln,
        dsl_log2 logarithm::log2,
        dsl_log10 logarithm::log10,
        dsl_ln_1p logarithm::ln_1p,
        dsl_sinh hyperbolic::sinh,
        dsl_cosh hyperbolic::cosh,
        dsl_tanh hyperbolic::tanh,
        dsl_cbrt roots::cbrt;
        dsl_atan2 arctangent::atan2,
        dsl_powf power::powf,
        dsl_hypot roots::hypot;
        power::powi, fused::mul_add, sine::sin_cos;
    f32:
        dsl_sin of_f32::sinf,
        dsl_cos of_f32::cosf,
        dsl_tan of_f32::tanf,
        dsl_asin of_f32::asinf,
        dsl_acos of_f32::acosf,
        dsl_atan of_f32::atanf,
        dsl_exp of_f32::expf,
        dsl_exp2 of_f32::exp2f,
        dsl_exp_m1 of_f32::exp_m1f,
        dsl_ln of_f32::lnf,
        dsl_log2 of_f32::log2f,
        dsl_log10 of_f32::log10f,
        dsl_ln_1p of_f32::ln_1pf,
        dsl_sinh of_f32::sinhf,
        dsl_cosh of_f32::coshf,
        dsl_tanh of_f32::tanhf,
        dsl_cbrt of_f32::cbrtf;
        dsl_atan2 of_f32::atan2f,
        dsl_powf of_f32::powff,
        dsl_hypot of_f32::hypotf;
        of_f32::powif, fused::mul_addf, of_f32::sin_cosf;
}

/// Elementary functions that the attributes redirect to the DSL, and that it does not have: rustc says where one is called
/// what to write in its place.
#[allow(missing_docs)]
pub trait AbsentMethods: Copy {
    fn dsl_asinh(self) -> Self
    where
        Self: HasAsinh,
    {
        self
    }
    fn dsl_acosh(self) -> Self
    where
        Self: HasAcosh,
    {
        self
    }
    fn dsl_atanh(self) -> Self
    where
        Self: HasAtanh,
    {
        self
    }
    fn dsl_log(self, _base: Self) -> Self
    where
        Self: HasLog,
    {
        self
    }
}

impl AbsentMethods for f64 {}
impl AbsentMethods for f32 {}

/// A type with `asinh`: none.
#[diagnostic::on_unimplemented(
    message = "`asinh` is not in the DSL yet",
    label = "not in the DSL",
    note = "write `(x + (x * x + 1.0).sqrt()).ln()`"
)]
pub trait HasAsinh {}

/// A type with `acosh`: none.
#[diagnostic::on_unimplemented(
    message = "`acosh` is not in the DSL yet",
    label = "not in the DSL",
    note = "write `(x + (x * x - 1.0).sqrt()).ln()`"
)]
pub trait HasAcosh {}

/// A type with `atanh`: none.
#[diagnostic::on_unimplemented(
    message = "`atanh` is not in the DSL yet",
    label = "not in the DSL",
    note = "write `0.5 * (2.0 * x / (1.0 - x)).ln_1p()`"
)]
pub trait HasAtanh {}

/// A type with `log`: none.
#[diagnostic::on_unimplemented(
    message = "`log` is not in the DSL yet",
    label = "not in the DSL",
    note = "write `x.ln() / base.ln()`"
)]
pub trait HasLog {}
