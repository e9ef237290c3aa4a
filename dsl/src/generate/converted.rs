//! Conversions between types of nalgebra that are functions of the DSL.

use core::marker::PhantomData;

use bessemer_ir::tree;
use nalgebra::{Complex, Quaternion, Rotation3, UnitQuaternion, Vector4};

use super::builder::{Builder, Callee};
use super::numbers::FromBuiltin;
use super::spatial::of;
use crate::complex;
use crate::linear::spatial::{quaternion, unit_quaternion};
use crate::math::Real;

/// The marker of a conversion that is a function of the DSL.
pub struct Converted<A, B>(PhantomData<fn(A) -> B>);

macro_rules! converts {
    ($($from:ty => $to:ty: $($function:ident)::+;)*) => {$(
        impl<T: Real> Callee for Converted<$from, $to> {
            fn callee(cx: &mut Builder) -> tree::Callee {
                of(cx, $($function)::+::__call::<T>)
            }
        }
        impl<T: Real> FromBuiltin<$from> for $to {
            type Marker = Converted<$from, $to>;
        }
    )*};
}

converts! {
    Vector4<T> => Quaternion<T>: quaternion::from_vector;
    [T; 4] => Quaternion<T>: quaternion::from_array;
    Rotation3<T> => UnitQuaternion<T>: unit_quaternion::from_rotation_matrix;
    UnitQuaternion<T> => Rotation3<T>: unit_quaternion::to_rotation_matrix;
}

macro_rules! complex_numbers {
    ($($float:ident)*) => {$(
        impl FromBuiltin<$float> for Complex<$float> {
            type Marker = Converted<$float, Complex<$float>>;
        }
    )*};
}

complex_numbers! { f32 f64 }

impl<T: Real> Callee for Converted<T, Complex<T>> {
    fn callee(cx: &mut Builder) -> tree::Callee {
        of(cx, complex::from_real::__call::<T>)
    }
}
