//! The companions of nalgebra's `Complex`, a struct of the DSL in the C.

#![allow(missing_docs)]

use bessemer_ir::tree::{self, Parts, Ty};
use nalgebra::Complex;

use super::builder::{Builder, Callee};
use super::builtin::markers;
use super::factored::methods;
use super::matrices::told;
use super::slot::{Called, DslType, Seen};
use super::spatial::PlatformAngles;
use crate::complex;
use crate::math::Real;

markers! {
    ComplexNew: Parts(Parts::Complex);
}

impl<T: Real> DslType for Complex<T> {
    fn ty(cx: &mut Builder) -> Ty {
        complex::ComplexNumber::<T>::ty(cx)
    }
}

impl<T: Real> Seen for Complex<T> {
    type Slot = Self;
}

/// Complex numbers: what needs no function, and what num-complex takes from the platform.
pub trait ComplexBuiltins<T>: Sized {
    fn __b_new(_re: T, _im: T) -> Called<ComplexNew, Self> {
        unreachable!()
    }
    fn __b_norm(self) -> Called<PlatformAngles, T> {
        unreachable!()
    }
}

impl<T: Real> ComplexBuiltins<T> for Complex<T> {}

methods! {
    /// Methods of complex numbers.
    ComplexMethods<> [Self, T] for Complex<T>, [T] {
        fn __b_i() -> Self { complex::i::__call() }
        fn __b_from_polar(r: T, angle: T) -> Self { complex::from_polar::__call(r, angle) }
        fn __b_cis(angle: T) -> Self { complex::cis::__call(angle) }
        fn __b_norm_sqr(&self) -> T { complex::norm_sqr::__call(self) }
        fn __b_l1_norm(&self) -> T { complex::l1_norm::__call(self) }
        fn __b_arg(self) -> T { complex::arg::__call(&self) }
        fn __b_to_polar(self) -> (T, T) { complex::to_polar::__call(&self) }
        fn __b_conj(&self) -> Self { complex::conj::__call(self) }
        fn __b_inv(&self) -> Self { complex::inv::__call(self) }
        fn __b_scale(&self, factor: T) -> Self { complex::scale::__call(self, factor) }
        fn __b_unscale(&self, divisor: T) -> Self { complex::unscale::__call(self, divisor) }
        fn __b_powu(&self, exponent: u32) -> Self { complex::powu::__call(self, exponent) }
        fn __b_powi(&self, exponent: i32) -> Self { complex::powi::__call(self, exponent) }
        fn __b_powf(self, exponent: T) -> Self { complex::powf::__call(&self, exponent) }
        fn __b_exp(self) -> Self { complex::exp::__call(&self) }
        fn __b_ln(self) -> Self { complex::ln::__call(&self) }
        fn __b_sqrt(self) -> Self { complex::sqrt::__call(&self) }
        fn __b_sin(self) -> Self { complex::sin::__call(&self) }
        fn __b_cos(self) -> Self { complex::cos::__call(&self) }
        fn __b_sinh(self) -> Self { complex::sinh::__call(&self) }
        fn __b_cosh(self) -> Self { complex::cosh::__call(&self) }
        fn __b_is_nan(self) -> bool { complex::is_nan::__call(&self) }
        fn __b_is_infinite(self) -> bool { complex::is_infinite::__call(&self) }
        fn __b_is_finite(self) -> bool { complex::is_finite::__call(&self) }
    }
}
