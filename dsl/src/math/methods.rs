//! The methods of floats that are elementary functions: the meaning of `x.sin()` in an annotated item.

use super::{
    arctangent, exponential, fused, hyperbolic, logarithm, of_f32, power, roots, sine, tangent,
};

/// Passes the list of elementary functions to a macro. Each entry has the companion's type, the names of the method
/// and the companion, operands of the method's own type and of other types, and the functions in double and single
/// precision.
macro_rules! elementary {
    ($then:ident) => {
        $then! {
            /// Sine of an angle in rad.
            Sin: dsl_sin __b_sin() [] = sine::sin, of_f32::sinf;
            /// Cosine of an angle in rad.
            Cos: dsl_cos __b_cos() [] = sine::cos, of_f32::cosf;
            /// Tangent of an angle in rad.
            Tan: dsl_tan __b_tan() [] = tangent::tan, of_f32::tanf;
            /// Arcsine, rad; NaN outside −1 to 1.
            Asin: dsl_asin __b_asin() [] = arctangent::asin, of_f32::asinf;
            /// Arccosine, rad; NaN outside −1 to 1.
            Acos: dsl_acos __b_acos() [] = arctangent::acos, of_f32::acosf;
            /// Arctangent, rad.
            Atan: dsl_atan __b_atan() [] = arctangent::atan, of_f32::atanf;
            /// e^self.
            Exp: dsl_exp __b_exp() [] = exponential::exp, of_f32::expf;
            /// 2^self.
            Exp2: dsl_exp2 __b_exp2() [] = exponential::exp2, of_f32::exp2f;
            /// e^self − 1, without cancellation.
            ExpM1: dsl_exp_m1 __b_exp_m1() [] = exponential::exp_m1, of_f32::exp_m1f;
            /// The natural logarithm.
            Ln: dsl_ln __b_ln() [] = logarithm::ln, of_f32::lnf;
            /// The logarithm to base 2.
            Log2: dsl_log2 __b_log2() [] = logarithm::log2, of_f32::log2f;
            /// The logarithm to base 10.
            Log10: dsl_log10 __b_log10() [] = logarithm::log10, of_f32::log10f;
            /// ln(1 + self), without cancellation.
            Ln1p: dsl_ln_1p __b_ln_1p() [] = logarithm::ln_1p, of_f32::ln_1pf;
            /// The hyperbolic sine.
            Sinh: dsl_sinh __b_sinh() [] = hyperbolic::sinh, of_f32::sinhf;
            /// The hyperbolic cosine.
            Cosh: dsl_cosh __b_cosh() [] = hyperbolic::cosh, of_f32::coshf;
            /// The hyperbolic tangent.
            Tanh: dsl_tanh __b_tanh() [] = hyperbolic::tanh, of_f32::tanhf;
            /// The cube root.
            Cbrt: dsl_cbrt __b_cbrt() [] = roots::cbrt, of_f32::cbrtf;
            /// The angle of the point (`x`, `self`) in rad, −π to π.
            Atan2: dsl_atan2 __b_atan2(x) [] = arctangent::atan2, of_f32::atan2f;
            /// self^y.
            Powf: dsl_powf __b_powf(y) [] = power::powf, of_f32::powff;
            /// √(self² + y²), without intermediate overflow.
            Hypot: dsl_hypot __b_hypot(y) [] = roots::hypot, of_f32::hypotf;
            /// self^n, by squaring in the order of [`power::powi`].
            Powi: dsl_powi __b_powi() [n: i32] = power::powi, of_f32::powif;
            /// self · a + b, rounded once.
            MulAdd: dsl_mul_add __b_mul_add(a, b) [] = fused::mul_add, fused::mul_addf;
        }
    };
}
pub(crate) use elementary;

macro_rules! methods {
    ($(
        $(#[$doc:meta])*
        $kind:ident: $method:ident $companion:ident($($operand:ident),*) [$($other:ident: $ty:ty),*]
            = $double:path, $single:path;
    )*) => {
        /// Elementary functions that the attributes redirect to the DSL.
        pub trait ElementaryMethods: Copy {
            $(
                $(#[$doc])*
                fn $method(self $(, $operand: Self)* $(, $other: $ty)*) -> Self;
            )*
            /// Sine and cosine of an angle in rad, with the bits of the two separate functions.
            fn dsl_sin_cos(self) -> (Self, Self);
        }

        impl ElementaryMethods for f64 {
            $(fn $method(self $(, $operand: f64)* $(, $other: $ty)*) -> f64 {
                $double(self $(, $operand)* $(, $other)*)
            })*
            fn dsl_sin_cos(self) -> (f64, f64) {
                sine::sin_cos(self)
            }
        }

        impl ElementaryMethods for f32 {
            $(fn $method(self $(, $operand: f32)* $(, $other: $ty)*) -> f32 {
                $single(self $(, $operand)* $(, $other)*)
            })*
            fn dsl_sin_cos(self) -> (f32, f32) {
                of_f32::sin_cosf(self)
            }
        }
    };
}

elementary! { methods }

/// Elementary functions that the attributes redirect and the DSL lacks: rustc reports the replacement at each call.
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

/// Implemented by no type, so that a call of `asinh` is an error.
#[diagnostic::on_unimplemented(
    message = "`asinh` is not supported",
    label = "not supported",
    note = "write `(x + (x * x + 1.0).sqrt()).ln()`"
)]
pub trait HasAsinh {}

/// Implemented by no type, so that a call of `acosh` is an error.
#[diagnostic::on_unimplemented(
    message = "`acosh` is not supported",
    label = "not supported",
    note = "write `(x + (x * x - 1.0).sqrt()).ln()`"
)]
pub trait HasAcosh {}

/// Implemented by no type, so that a call of `atanh` is an error.
#[diagnostic::on_unimplemented(
    message = "`atanh` is not supported",
    label = "not supported",
    note = "write `0.5 * (2.0 * x / (1.0 - x)).ln_1p()`"
)]
pub trait HasAtanh {}

/// Implemented by no type, so that a call of `log` is an error.
#[diagnostic::on_unimplemented(
    message = "`log` is not supported",
    label = "not supported",
    note = "write `x.ln()` or `x.log10()`; for another base `x.ln() / base.ln()`"
)]
pub trait HasLog {}
