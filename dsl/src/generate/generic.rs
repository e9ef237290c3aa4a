//! The companions of what `num_traits::Float` and nalgebra's `RealField` have: those of the float that a function is
//! built for.
//!
//! As in [`crate::math`], the receiver is taken by reference, so that a known float's own companion is found first.

use core::marker::PhantomData;

use bessemer_ir::tree::{self, Ty};
use bessemer_ir::{Float, Scalar};

use nalgebra::{Const, OPoint, RealField};
use num_traits::Float as Number;

use super::builder::{Builder, Callee};
use super::builtin::{FloatBuiltins, OrderBuiltins, calls};
use super::elementary::ElementaryBuiltins;
use super::numbers::{FloatKindBuiltins, SignBuiltins};
use super::slot::{Called, Companion, DslType};
use crate::linear::norms;
use crate::math::{Real, constants};

fn is_single<T: DslType>(cx: &mut Builder) -> bool {
    T::ty(cx) == Ty::Scalar(Scalar::Float(Float::F32))
}

/// The marker of what each float has of its own.
macro_rules! marker {
    ($marker:ident: |$float:ident| $companion:expr, fn($($parameter:ty),*)) => {
        /// The companion of a known float.
        pub struct $marker<T>(PhantomData<T>);
        impl<T: DslType> Callee for $marker<T> {
            fn callee(cx: &mut Builder) -> tree::Callee {
                match is_single::<T>(cx) {
                    true => {
                        type $float = f32;
                        Companion::callee($companion as fn($($parameter),*) -> _, cx)
                    }
                    false => {
                        type $float = f64;
                        Companion::callee($companion as fn($($parameter),*) -> _, cx)
                    }
                }
            }
        }
    };
}

/// A trait of companions, blanket over what has a bound, and what each calls for either float.
macro_rules! generic {
    ($d:tt
        unary { $($un:ident $un_of:ident $un_name:ident;)* }
        questions { $($ask:ident $ask_of:ident $ask_name:ident;)* }
        binary { $($bi:ident $bi_of:ident $bi_name:ident;)* }
        constants { $($of:ident $function:ident $name:ident;)* }
    ) => {
        $(marker! { $un: |F| <F as $un_of>::$un_name, fn(F) })*
        $(marker! { $ask: |F| <F as $ask_of>::$ask_name, fn(F) })*
        $(marker! { $bi: |F| <F as $bi_of>::$bi_name, fn(F, F) })*
        marker! { Clamp: |F| <F as OrderBuiltins>::__b_clamp, fn(F, F, F) }
        marker! { MulAdd: |F| <F as ElementaryBuiltins>::__b_mul_add, fn(F, F, F) }
        marker! { Powi: |F| <F as ElementaryBuiltins>::__b_powi, fn(F, i32) }
        marker! { SinCos: |F| <F as ElementaryBuiltins>::__b_sin_cos, fn(F) }
        $(marker! { $of: |F| constants::$function::__call::<F>, fn() })*

        macro_rules! companions {
            ($d trait:ident: $d bound:ident) => {
                /// Companions of methods, and of constants that are functions there.
                #[allow(missing_docs)]
                pub trait $d trait: Sized {
                    $(fn $un_name(&self) -> Called<$un<Self>, Self> { unreachable!() })*
                    $(fn $ask_name(&self) -> Called<$ask<Self>, bool> { unreachable!() })*
                    $(fn $bi_name(&self, _other: Self) -> Called<$bi<Self>, Self> { unreachable!() })*
                    fn __b_clamp(&self, _low: Self, _high: Self) -> Called<Clamp<Self>, Self> {
                        unreachable!()
                    }
                    fn __b_mul_add(&self, _a: Self, _b: Self) -> Called<MulAdd<Self>, Self> {
                        unreachable!()
                    }
                    fn __b_powi(&self, _n: i32) -> Called<Powi<Self>, Self> { unreachable!() }
                    fn __b_sin_cos(&self) -> Called<SinCos<Self>, (Self, Self)> { unreachable!() }
                    $(fn $name() -> Called<$of<Self>, Self> { unreachable!() })*
                }
                impl<T: $d bound> $d trait for T {}
            };
        }
    };
}

generic! { $
    unary {
        Sqrt FloatBuiltins __b_sqrt;
        Floor FloatBuiltins __b_floor;
        Ceil FloatKindBuiltins __b_ceil;
        Trunc FloatKindBuiltins __b_trunc;
        Round FloatKindBuiltins __b_round;
        Fract FloatKindBuiltins __b_fract;
        Recip FloatKindBuiltins __b_recip;
        ToDegrees FloatKindBuiltins __b_to_degrees;
        ToRadians FloatKindBuiltins __b_to_radians;
        Abs OrderBuiltins __b_abs;
        Signum SignBuiltins __b_signum;
        Sin ElementaryBuiltins __b_sin;
        Cos ElementaryBuiltins __b_cos;
        Tan ElementaryBuiltins __b_tan;
        Asin ElementaryBuiltins __b_asin;
        Acos ElementaryBuiltins __b_acos;
        Atan ElementaryBuiltins __b_atan;
        Exp ElementaryBuiltins __b_exp;
        Exp2 ElementaryBuiltins __b_exp2;
        ExpM1 ElementaryBuiltins __b_exp_m1;
        Ln ElementaryBuiltins __b_ln;
        Log2 ElementaryBuiltins __b_log2;
        Log10 ElementaryBuiltins __b_log10;
        Ln1p ElementaryBuiltins __b_ln_1p;
        Sinh ElementaryBuiltins __b_sinh;
        Cosh ElementaryBuiltins __b_cosh;
        Tanh ElementaryBuiltins __b_tanh;
        Cbrt ElementaryBuiltins __b_cbrt;
    }
    questions {
        IsNan FloatKindBuiltins __b_is_nan;
        IsFinite FloatKindBuiltins __b_is_finite;
        IsInfinite FloatKindBuiltins __b_is_infinite;
    }
    binary {
        Copysign FloatBuiltins __b_copysign;
        Min OrderBuiltins __b_min;
        Max OrderBuiltins __b_max;
        Atan2 ElementaryBuiltins __b_atan2;
        Powf ElementaryBuiltins __b_powf;
        Hypot ElementaryBuiltins __b_hypot;
    }
    constants {
        Zero zero __b_zero;
        One one __b_one;
        Epsilon epsilon __b_epsilon;
        Infinity infinity __b_infinity;
        NegInfinity neg_infinity __b_neg_infinity;
        Nan nan __b_nan;
        MaxValue max_value __b_max_value;
        MinValue min_value __b_min_value;
        MinPositiveValue min_positive_value __b_min_positive_value;
        Pi pi __b_pi;
        TwoPi two_pi __b_two_pi;
        FracPi2 frac_pi_2 __b_frac_pi_2;
        FracPi3 frac_pi_3 __b_frac_pi_3;
        FracPi4 frac_pi_4 __b_frac_pi_4;
        FracPi6 frac_pi_6 __b_frac_pi_6;
        FracPi8 frac_pi_8 __b_frac_pi_8;
        DefaultEpsilon default_epsilon __b_default_epsilon;
    }
}

companions! { AnyFloatBuiltins: Number }
companions! { AnyRealBuiltins: RealField }

/// Stands for `nalgebra::convert` of a number in double precision: [`real`](crate::math::real).
#[allow(non_camel_case_types)]
pub struct convert;

/// Stands for nalgebra's function of that name.
#[allow(non_camel_case_types)]
pub struct distance;

/// Stands for nalgebra's function of that name.
#[allow(non_camel_case_types)]
pub struct distance_squared;

calls! {
    convert[T: RealField](_: f64) -> T = super::builtin::Real;
    distance[T: Real, const N: usize](_p: &OPoint<T, Const<N>>, _q: &OPoint<T, Const<N>>) -> T
        = norms::__function_distance<T, N>;
    distance_squared[T: Real, const N: usize](_p: &OPoint<T, Const<N>>, _q: &OPoint<T, Const<N>>) -> T
        = norms::__function_distance_squared<T, N>;
}
