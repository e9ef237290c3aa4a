//! `Real`: the operations of a model that is generic over its float type.

use nalgebra::RealField;

use super::{
    DivisionMethods, ElementaryMethods, FloatMethods, OrderMethods, RoundMethods, SignMethods,
};
use crate::element::Number;

/// `f32` or `f64`.
///
/// A function, a type or a component that is generic over `T: Real` becomes C for each float that it is
/// used with, all of it in that float: [`real`] gives it its literals, and `x.sin()` is its own `sin`.
///
/// ```
/// use bessemer::prelude::*;
///
/// /// Half of the way from `a` to `b`.
/// #[function]
/// fn middle<T: Real>(a: T, b: T) -> T {
///     (a + b) * real(0.5)
/// }
///
/// assert_eq!(middle(1.0_f32, 2.0), 1.5);
/// assert_eq!(middle(1.0_f64, 2.0), 1.5);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a float of the DSL",
    label = "not `f32` or `f64`"
)]
pub trait Real:
    RealField
    + Number
    + FloatMethods
    + OrderMethods
    + RoundMethods
    + SignMethods
    + DivisionMethods
    + ElementaryMethods
    + generated::Generated
{
    /// 1.
    const ONE: Self;
    /// π.
    const PI: Self;
    /// 2π.
    const TAU: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The largest finite number.
    const MAX: Self;
    /// The lowest finite number.
    const MIN: Self;
    /// The smallest positive number that is not subnormal.
    const MIN_POSITIVE: Self;
    /// ∞.
    const INFINITY: Self;
    /// −∞.
    const NEG_INFINITY: Self;
    /// Not a number.
    const NAN: Self;

    /// The nearest number of the type: [`real`].
    #[doc(hidden)]
    fn dsl_from_f64(value: f64) -> Self;
    /// The number in double precision, which represents every `f32` exactly.
    fn as_f64(self) -> f64;
    /// Returns true if it is not a number.
    fn is_nan(self) -> bool;
    /// Returns true if it is neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// Returns true if it is ∞ or −∞.
    fn is_infinite(self) -> bool;
}

/// A number in the float of the model: `real(0.5)` is the literal 0.5 of whatever type is wanted.
///
/// It means `0.5 as T`: the number in double precision, rounded to the type.
pub fn real<T: Real>(value: f64) -> T {
    T::dsl_from_f64(value)
}

/// Contains the companion of [`real`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub struct real {}

#[cfg(feature = "generate")]
#[doc(hidden)]
impl real {
    pub fn __call<T: Real>(_: f64) -> crate::generate::Called<crate::generate::numbers::Real, T> {
        unreachable!()
    }
}

macro_rules! floats {
    ($($float:ident)*) => {$(
        impl Real for $float {
            const ONE: $float = 1.0;
            const PI: $float = core::$float::consts::PI;
            const TAU: $float = core::$float::consts::TAU;
            const EPSILON: $float = $float::EPSILON;
            const MAX: $float = $float::MAX;
            const MIN: $float = $float::MIN;
            const MIN_POSITIVE: $float = $float::MIN_POSITIVE;
            const INFINITY: $float = $float::INFINITY;
            const NEG_INFINITY: $float = $float::NEG_INFINITY;
            const NAN: $float = $float::NAN;

            fn dsl_from_f64(value: f64) -> $float {
                value as $float
            }
            fn as_f64(self) -> f64 {
                self as f64
            }
            fn is_nan(self) -> bool {
                $float::is_nan(self)
            }
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
            fn is_infinite(self) -> bool {
                $float::is_infinite(self)
            }
        }
    )*};
}

floats! { f32 f64 }

/// Additional supertraits of `Real` in a generation build.
#[cfg(feature = "generate")]
mod generated {
    use crate::generate::generic::ElementaryBuiltins;
    use crate::generate::numbers::{DivisionBuiltins, FloatBuiltins, OrderBuiltins, SignBuiltins};
    use crate::generate::{ScalarType, Value};

    pub trait Generated:
        Value
        + ScalarType
        + FloatBuiltins
        + OrderBuiltins
        + ElementaryBuiltins
        + DivisionBuiltins
        + SignBuiltins
    {
    }

    impl Generated for f32 {}
    impl Generated for f64 {}
}

#[cfg(not(feature = "generate"))]
mod generated {
    pub trait Generated {}
    impl Generated for f32 {}
    impl Generated for f64 {}
}
