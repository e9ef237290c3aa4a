//! The companions of nalgebra's rotations and poses, and what their operators and those of complex numbers mean.
//!
//! A `Quaternion`, a `UnitQuaternion` and an `Isometry3` are structs of the DSL in the C; a `Rotation`, a
//! `Point`, a `Translation` and a `Unit` of a vector are matrices and vectors.

#![allow(missing_docs)]

use alloc::boxed::Box;
use alloc::format;
use alloc::vec::Vec;

use bessemer_ir::tree::{self, Parts, SpatialMethod, Ty};
use bessemer_ir::{Float, Scalar};
use nalgebra::{
    Const, Isometry3, Matrix4, OPoint, Point3, Quaternion, Rotation, Rotation2, Rotation3, SMatrix,
    SVector, Translation, Translation3, Unit, UnitQuaternion, UnitVector3, Vector3, Vector4,
};

use super::builder::{Builder, Callee};
use super::builtin::{
    AxisX, AxisY, AxisZ, Identity, New, TrMul, Transpose, Zeros, markers, signatures,
};
use super::factored::{gives, held_mut, methods};
use super::matrices::told;
use super::slot::{Called, DslType, Seen};
use crate::linear::spatial::{isometry, quaternion, unit_quaternion};
use crate::linear::{elementwise, matrix_edit, norms};
use crate::math::Real;
use crate::{complex, rotation};

markers! {
    QuaternionNew: Parts(Parts::Quaternion);
    QuaternionIdentity: Spatial(SpatialMethod::QuaternionIdentity);
    QuaternionCoords: Spatial(SpatialMethod::QuaternionCoords);
    IsometryNew: Parts(Parts::Isometry);
    SameParts: Spatial(SpatialMethod::SameParts);
    Same: Owned;
    Times: Spatial(SpatialMethod::Times); Plus: Spatial(SpatialMethod::Plus); Minus: Spatial(SpatialMethod::Minus); Negative: Spatial(SpatialMethod::Negative);
    PlatformAngles: Spatial(SpatialMethod::PlatformAngles);
}

macro_rules! stands {
    ($($native:ty => $data:ty;)*) => {$(
        impl<T: Real> DslType for $native {
            fn ty(cx: &mut Builder) -> Ty {
                <$data>::ty(cx)
            }
        }
        impl<T: Real> Seen for $native {
            type Slot = Self;
        }
    )*};
}

stands! {
    Quaternion<T> => quaternion::Quaternion<T>;
    UnitQuaternion<T> => unit_quaternion::UnitQuaternion<T>;
    Isometry3<T> => isometry::Isometry3<T>;
}

macro_rules! known {
    ($($native:ty => $rows:ident, $cols:tt, $name:literal;)*) => {$(
        impl<T: Real, const N: usize> DslType for $native {
            fn ty(cx: &mut Builder) -> Ty {
                Ty::Known(format!("{}{N}", $name), Box::new(<SMatrix<T, $rows, $cols>>::ty(cx)))
            }
        }
        impl<T: Real, const N: usize> Seen for $native {
            type Slot = Self;
        }
    )*};
}

known! {
    Rotation<T, N> => N, N, "Rotation";
    Translation<T, N> => N, 1, "Translation";
    OPoint<T, Const<N>> => N, 1, "Point";
    Unit<SVector<T, N>> => N, 1, "UnitVector";
}

/// Companions whose meaning is the typifier's business.
macro_rules! builtins {
    (
        $(#[$doc:meta])*
        $trait:ident<$($n:ident)?> for $native:ty {$(
            fn $name:ident($($parameters:tt)*) -> $result:ty = $marker:ty;
        )*}
    ) => {
        $(#[$doc])*
        pub trait $trait<T: Real, $(const $n: usize)?>: Sized {$(
            fn $name($($parameters)*) -> Called<$marker, $result> {
                unreachable!()
            }
        )*}
        impl<T: Real, $(const $n: usize)?> $trait<T, $($n)?> for $native {}
    };
}

builtins! {
    /// Quaternions: what needs no function.
    QuaternionBuiltins<> for Quaternion<T> {
        fn __b_new(_w: T, _i: T, _j: T, _k: T) -> Self = QuaternionNew;
        fn __b_identity() -> Self = QuaternionIdentity;
        fn __b_as_vector(&self) -> &Vector4<T> = QuaternionCoords;
    }
}

methods! {
    /// Methods of quaternions.
    QuaternionMethods<> [Self, T] for Quaternion<T>, [T] {
        fn __b_from_parts(scalar: T, vector: Vector3<T>) -> Self {
            quaternion::from_parts::__call(scalar, &vector)
        }
        fn __b_from_imag(vector: Vector3<T>) -> Self { quaternion::from_imag::__call(&vector) }
        fn __b_from_real(number: T) -> Self { quaternion::from_real::__call(number) }
        fn __b_conjugate(&self) -> Self { quaternion::conjugate::__call(self) }
        fn __b_conjugate_mut(&mut self) -> () { quaternion::conjugate_mut::__call(self) }
        fn __b_scalar(&self) -> T { quaternion::scalar::__call(self) }
        fn __b_imag(&self) -> Vector3<T> { quaternion::imag::__call(self) }
        fn __b_dot(&self, other: &Self) -> T { quaternion::dot::__call(self, other) }
        fn __b_norm(&self) -> T { quaternion::norm::__call(self) }
        fn __b_magnitude(&self) -> T { quaternion::norm::__call(self) }
        fn __b_norm_squared(&self) -> T { quaternion::norm_squared::__call(self) }
        fn __b_magnitude_squared(&self) -> T { quaternion::norm_squared::__call(self) }
        fn __b_normalize(&self) -> Self { quaternion::normalize::__call(self) }
        fn __b_normalize_mut(&mut self) -> T { quaternion::normalize_mut::__call(self) }
        fn __b_try_inverse(&self) -> Option<Self> { quaternion::try_inverse::__call(self) }
        fn __b_lerp(&self, other: &Self, share: T) -> Self {
            quaternion::lerp::__call(self, other, share)
        }
        fn __b_squared(&self) -> Self { quaternion::squared::__call(self) }
        fn __b_half(&self) -> Self { quaternion::half::__call(self) }
    }
}

/// What a `Unit` is made of.
pub trait Unitary: Sized {
    type Wrap: Callee;
    fn __normalized(self) -> Called<impl Callee + use<Self>, Unit<Self>>;
}

impl<T: Real> Unitary for Quaternion<T> {
    type Wrap = SameParts;
    fn __normalized(self) -> Called<impl Callee + use<T>, Unit<Self>> {
        unit_quaternion::new_normalize::__call(&self)
    }
}

impl<T: Real, const N: usize> Unitary for SVector<T, N> {
    type Wrap = Same;
    fn __normalized(self) -> Called<impl Callee + use<T, N>, Unit<Self>> {
        gives(norms::normalize::__call(&self))
    }
}

/// Methods of `Unit`.
pub trait UnitBuiltins<U: Unitary>: Sized {
    signatures! {
        fn __b_new_unchecked(_value: U) -> Called<U::Wrap, Self>;
        fn __b_into_inner(self) -> Called<U::Wrap, U>;
        fn __b_as_ref(&self) -> Called<U::Wrap, &U>;
    }
    fn __b_new_normalize(value: U) -> Called<impl Callee + use<Self, U>, Self>;
}

impl<U: Unitary> UnitBuiltins<U> for Unit<U> {
    fn __b_new_normalize(value: U) -> Called<impl Callee + use<U>, Self> {
        value.__normalized()
    }
}

builtins! {
    /// Unit quaternions: what needs no function.
    UnitQuaternionBuiltins<> for UnitQuaternion<T> {
        fn __b_identity() -> Self = QuaternionIdentity;
        fn __b_new(_axis: Vector3<T>) -> Self = PlatformAngles;
        fn __b_quaternion(&self) -> &Quaternion<T> = SameParts;
        fn __b_angle(&self) -> T = PlatformAngles;
        fn __b_angle_to(&self, _other: &Self) -> T = PlatformAngles;
        fn __b_exp(&self) -> Quaternion<T> = PlatformAngles;
        fn __b_ln(&self) -> Quaternion<T> = PlatformAngles;
        fn __b_try_slerp(&self, _other: &Self, _share: T, _least: T) -> Option<Self> = PlatformAngles;
    }
}

methods! {
    /// Methods of unit quaternions.
    UnitQuaternionMethods<> [Self, T] for UnitQuaternion<T>, [T] {
        fn __b_dsl_new(axis: Vector3<T>) -> Self { rotation::from_scaled_axis::__call(axis) }
        fn __b_from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self {
            rotation::from_axis_angle::__call(axis, angle)
        }
        fn __b_from_euler_angles(roll: T, pitch: T, yaw: T) -> Self {
            rotation::from_euler_angles::__call(roll, pitch, yaw)
        }
        fn __b_from_scaled_axis(axis: Vector3<T>) -> Self {
            rotation::from_scaled_axis::__call(axis)
        }
        fn __b_rotation_between_axis(a: &UnitVector3<T>, b: &UnitVector3<T>) -> Option<Self> {
            rotation::rotation_between_axis::__call(a, b)
        }
        fn __b_from_quaternion(q: Quaternion<T>) -> Self {
            unit_quaternion::new_normalize::__call(&q)
        }
        fn __b_from_rotation_matrix(matrix: &Rotation3<T>) -> Self {
            unit_quaternion::from_rotation_matrix::__call(matrix)
        }
        fn __b_inverse(&self) -> Self { unit_quaternion::inverse::__call(self) }
        fn __b_conjugate(&self) -> Self { unit_quaternion::inverse::__call(self) }
        fn __b_inverse_mut(&mut self) -> () { unit_quaternion::inverse_mut::__call(self) }
        fn __b_conjugate_mut(&mut self) -> () { unit_quaternion::inverse_mut::__call(self) }
        fn __b_rotation_to(&self, other: &Self) -> Self {
            unit_quaternion::rotation_to::__call(self, other)
        }
        fn __b_transform_vector(&self, v: &Vector3<T>) -> Vector3<T> {
            unit_quaternion::transform_vector::__call(self, v)
        }
        fn __b_inverse_transform_vector(&self, v: &Vector3<T>) -> Vector3<T> {
            unit_quaternion::inverse_transform_vector::__call(self, v)
        }
        fn __b_inverse_transform_unit_vector(&self, v: &UnitVector3<T>) -> UnitVector3<T> {
            gives(unit_quaternion::inverse_transform_vector::__call(self, v))
        }
        fn __b_transform_point(&self, p: &Point3<T>) -> Point3<T> {
            gives(unit_quaternion::transform_vector::__call(self, &p.coords))
        }
        fn __b_inverse_transform_point(&self, p: &Point3<T>) -> Point3<T> {
            gives(unit_quaternion::inverse_transform_vector::__call(self, &p.coords))
        }
        fn __b_to_rotation_matrix(self) -> Rotation3<T> {
            unit_quaternion::to_rotation_matrix::__call(&self)
        }
        fn __b_to_homogeneous(self) -> Matrix4<T> {
            unit_quaternion::to_homogeneous::__call(&self)
        }
        fn __b_nlerp(&self, other: &Self, share: T) -> Self {
            unit_quaternion::nlerp::__call(self, other, share)
        }
        fn __b_powf(&self, share: T) -> Self { rotation::powf::__call(self, share) }
        fn __b_slerp(&self, other: &Self, share: T) -> Self {
            rotation::slerp::__call(self, other, share)
        }
        fn __b_axis_angle(&self) -> Option<(UnitVector3<T>, T)> { rotation::axis_angle::__call(self) }
        fn __b_scaled_axis(&self) -> Vector3<T> { rotation::scaled_axis::__call(self) }
        fn __b_euler_angles(&self) -> (T, T, T) { rotation::euler_angles::__call(self) }
        fn __b_axis(&self) -> Option<UnitVector3<T>> { unit_quaternion::axis::__call(self) }
        fn __b_append_axisangle_linearized(&self, axis: &Vector3<T>) -> Self {
            unit_quaternion::append_axisangle_linearized::__call(self, axis)
        }
        fn __b_renormalize(&mut self) -> T { unit_quaternion::renormalize::__call(self) }
        fn __b_renormalize_fast(&mut self) -> () { unit_quaternion::renormalize_fast::__call(self) }
    }
}

methods! {
    /// Methods of rotation matrices in space.
    SpaceRotationMethods<> [Self, T] for Rotation3<T>, [T] {
        fn __b_dsl_new(axis: Vector3<T>) -> Self { rotation::matrix_from_scaled_axis::__call(axis) }
        fn __b_from_axis_angle(axis: &UnitVector3<T>, angle: T) -> Self {
            rotation::matrix_from_axis_angle::__call(axis, angle)
        }
        fn __b_from_euler_angles(roll: T, pitch: T, yaw: T) -> Self {
            rotation::matrix_from_euler_angles::__call(roll, pitch, yaw)
        }
        fn __b_from_scaled_axis(axis: Vector3<T>) -> Self {
            rotation::matrix_from_scaled_axis::__call(axis)
        }
        fn __b_euler_angles(&self) -> (T, T, T) { rotation::matrix_euler_angles::__call(self) }
    }
}

methods! {
    /// Methods of rotation matrices in the plane.
    PlaneRotationMethods<> [Self, T] for Rotation2<T>, [T] {
        fn __b_dsl_new(angle: T) -> Self { rotation::matrix_from_angle::__call(angle) }
    }
}

/// `new` of rotations that are called by another name than nalgebra's.
macro_rules! turns {
    ($($trait:ident for $native:ty, $turn:ty;)*) => {$(builtins! {
        /// From an angle, over the platform's sine.
        $trait<> for $native {
            fn __b_new(_turn: $turn) -> Self = PlatformAngles;
        }
    })*};
}

turns! {
    NewPlaneRotation for Rotation2<T>, T;
    NewSpaceRotation for Rotation3<T>, Vector3<T>;
}

methods! {
    /// Directions.
    DirectionMethods<N> [Self, T, N] for Unit<SVector<T, N>>, [T, N] {
        fn __b_try_new(v: SVector<T, N>, least: T) -> Option<Self> {
            norms::try_direction::__call(&v, least)
        }
        fn __b_try_new_and_get(v: SVector<T, N>, least: T) -> Option<(Self, T)> {
            norms::try_direction_and_norm::__call(&v, least)
        }
    }
}

builtins! {
    /// Methods of rotation matrices.
    RotationBuiltins<N> for Rotation<T, N> {
        fn __b_identity() -> Self = Identity;
        fn __b_from_matrix_unchecked(_matrix: SMatrix<T, N, N>) -> Self = Same;
        fn __b_matrix(&self) -> &SMatrix<T, N, N> = Same;
        fn __b_into_inner(self) -> SMatrix<T, N, N> = Same;
        fn __b_transpose(&self) -> Self = Transpose;
        fn __b_inverse(&self) -> Self = Transpose;
        fn __b_transform_vector(&self, _v: &SVector<T, N>) -> SVector<T, N> = Times;
        fn __b_transform_point(&self, _p: &OPoint<T, Const<N>>) -> OPoint<T, Const<N>> = Times;
        fn __b_inverse_transform_vector(&self, _v: &SVector<T, N>) -> SVector<T, N> = TrMul;
        fn __b_inverse_transform_point(&self, _p: &OPoint<T, Const<N>>) -> OPoint<T, Const<N>> = TrMul;
    }
}

methods! {
    /// Methods of rotation matrices that change them.
    RotationMethods<N> [Self, T, N] for Rotation<T, N>, [T, N] {
        fn __b_transpose_mut(&mut self) -> () { matrix_edit::transpose_mut::__call::<T, N>(held_mut(self)) }
        fn __b_inverse_mut(&mut self) -> () { matrix_edit::transpose_mut::__call::<T, N>(held_mut(self)) }
    }
}

builtins! {
    /// Methods of translations.
    TranslationBuiltins<N> for Translation<T, N> {
        fn __b_identity() -> Self = Zeros;
        fn __b_inverse(&self) -> Self = Negative;
        fn __b_from(_vector: SVector<T, N>) -> Self = Same;
        fn __b_transform_point(&self, _p: &OPoint<T, Const<N>>) -> OPoint<T, Const<N>> = Plus;
    }
}

methods! {
    /// Methods of translations that change them.
    TranslationMethods<N> [Self, T, N] for Translation<T, N>, [T, N] {
        fn __b_inverse_mut(&mut self) -> () {
            elementwise::neg_mut::__call::<T, N, 1>(held_mut(self))
        }
    }
}

builtins! {
    /// Methods of points.
    PointBuiltins<N> for OPoint<T, Const<N>> {
        fn __b_origin() -> Self = Zeros;
        fn __b_from(_vector: SVector<T, N>) -> Self = Same;
    }
}

macro_rules! constructors {
    ($($trait:ident for $native:ty, ($($argument:ident),*);)*) => {$(builtins! {
        /// From its parts.
        $trait<> for $native {
            fn __b_new($($argument: T),*) -> Self = New;
        }
    })*};
}

constructors! {
    NewPoint2 for OPoint<T, Const<2>>, (_x, _y);
    NewPoint3 for OPoint<T, Const<3>>, (_x, _y, _z);
    NewTranslation2 for Translation<T, 2>, (_x, _y);
    NewTranslation3 for Translation<T, 3>, (_x, _y, _z);
}

builtins! {
    /// Unit vectors along the axes.
    UnitAxisBuiltins<N> for SVector<T, N> {
        fn __b_x_axis() -> Unit<Self> = AxisX;
        fn __b_y_axis() -> Unit<Self> = AxisY;
        fn __b_z_axis() -> Unit<Self> = AxisZ;
    }
}

builtins! {
    /// Poses: what needs no function.
    IsometryBuiltins<> for Isometry3<T> {
        fn __b_from_parts(_by: Translation3<T>, _q: UnitQuaternion<T>) -> Self = IsometryNew;
        fn __b_new(_by: Vector3<T>, _axis: Vector3<T>) -> Self = PlatformAngles;
        fn __b_lerp_slerp(&self, _other: &Self, _share: T) -> Self = PlatformAngles;
    }
}

methods! {
    /// Methods of poses.
    IsometryMethods<> [Self, T] for Isometry3<T>, [T] {
        fn __b_identity() -> Self { isometry::identity::__call() }
        fn __b_translation(x: T, y: T, z: T) -> Self { isometry::translation::__call(x, y, z) }
        fn __b_inverse(&self) -> Self { isometry::inverse::__call(self) }
        fn __b_inverse_mut(&mut self) -> () { isometry::inverse_mut::__call(self) }
        fn __b_inv_mul(&self, other: &Self) -> Self { isometry::inv_mul::__call(self, other) }
        fn __b_transform_point(&self, p: &Point3<T>) -> Point3<T> {
            gives(isometry::transform_point::__call(self, &p.coords))
        }
        fn __b_inverse_transform_point(&self, p: &Point3<T>) -> Point3<T> {
            gives(isometry::inverse_transform_point::__call(self, &p.coords))
        }
        fn __b_transform_vector(&self, v: &Vector3<T>) -> Vector3<T> {
            isometry::transform_vector::__call(self, v)
        }
        fn __b_inverse_transform_vector(&self, v: &Vector3<T>) -> Vector3<T> {
            isometry::inverse_transform_vector::__call(self, v)
        }
        fn __b_to_homogeneous(&self) -> Matrix4<T> { isometry::to_homogeneous::__call(self) }
        fn __b_to_matrix(&self) -> Matrix4<T> { isometry::to_homogeneous::__call(self) }
        fn __b_append_translation_mut(&mut self, by: &Translation3<T>) -> () {
            isometry::append_translation_mut::__call(self, by)
        }
        fn __b_append_rotation_mut(&mut self, q: &UnitQuaternion<T>) -> () {
            isometry::append_rotation_mut::__call(self, q)
        }
    }
}

/// What the operators of a function mean, as far as the types of their operands say.
pub(super) fn operators(
    cx: &mut Builder,
    operators: &[tree::Operator],
    slots: &[Ty],
) -> Vec<(u32, tree::Callee)> {
    let found = operators.iter().filter_map(|operator| {
        let kinds: Vec<_> = operator
            .operands
            .iter()
            .map(|slot| {
                slot.map_or(Some((Kind::Number, None)), |slot| kind(slots.get(slot as usize)?))
            })
            .collect();
        let (left, right) = match kinds.as_slice() {
            [Some(left)] => (*left, (Kind::None, None)),
            [Some(left), Some(right)] => (*left, *right),
            _ => return None,
        };
        let sign = operator.of.trim_end_matches("Assign");
        let callee = match left.1.or(right.1)? {
            Float::F32 => meaning::<f32>(cx, sign, left.0, right.0),
            Float::F64 => meaning::<f64>(cx, sign, left.0, right.0),
        };
        Some((operator.at, callee?))
    });
    found.collect()
}

/// What a type is to an operator.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    None,
    Number,
    Matrix,
    Complex,
    Quaternion,
    Unit,
    Rotation,
    Rotation3,
    Translation,
    Point,
    UnitVector,
    Isometry,
}

fn kind(ty: &Ty) -> Option<(Kind, Option<Float>)> {
    let float = |scalar: &Scalar| match scalar {
        Scalar::Float(float) => Some(*float),
        _ => None,
    };
    Some(match ty {
        Ty::Ref(inner, _) => return kind(inner),
        Ty::Scalar(_) => (Kind::Number, None),
        Ty::Matrix(scalar, ..) => (Kind::Matrix, float(scalar)),
        Ty::Known(name, inner) => {
            let kind = match name.trim_end_matches(|digit: char| digit.is_ascii_digit()) {
                "Rotation" if name == "Rotation3" => Kind::Rotation3,
                "Rotation" => Kind::Rotation,
                "Translation" => Kind::Translation,
                "Point" => Kind::Point,
                _ => Kind::UnitVector,
            };
            (kind, self::kind(inner)?.1)
        }
        Ty::Named(path) => {
            let (path, float) = match path.strip_suffix("<f32>") {
                Some(path) => (path, Float::F32),
                None => (path.strip_suffix("<f64>")?, Float::F64),
            };
            let kind = match path.strip_prefix("bessemer::")? {
                "complex::ComplexNumber" => Kind::Complex,
                "linear::spatial::quaternion::Quaternion" => Kind::Quaternion,
                "linear::spatial::unit_quaternion::UnitQuaternion" => Kind::Unit,
                "linear::spatial::isometry::Isometry3" => Kind::Isometry,
                _ => return None,
            };
            (kind, Some(float))
        }
        _ => return None,
    })
}

/// The function, or the operation of matrices, that an operator is; none where it is the operator of
/// matrices or numbers itself.
fn meaning<T: Real>(cx: &mut Builder, sign: &str, left: Kind, right: Kind) -> Option<tree::Callee> {
    use Kind::*;
    let known = |it| Some(tree::Callee::Builtin(tree::Builtin::Spatial(it)));
    match (left, sign, right) {
        (Complex, "Neg", _) => one(cx, complex::negative::__call::<T>),
        (Complex, "Add", Complex) => two(cx, complex::sum::__call::<T>),
        (Complex, "Add", Number) => two(cx, complex::sum_with_real::__call::<T>),
        (Number, "Add", Complex) => two(cx, complex::sum_of_real::__call::<T>),
        (Complex, "Sub", Complex) => two(cx, complex::difference::__call::<T>),
        (Complex, "Sub", Number) => two(cx, complex::difference_with_real::__call::<T>),
        (Number, "Sub", Complex) => two(cx, complex::difference_of_real::__call::<T>),
        (Complex, "Mul", Complex) => two(cx, complex::product::__call::<T>),
        (Complex, "Mul", Number) => two(cx, complex::scale::__call::<T>),
        (Number, "Mul", Complex) => two(cx, complex::scaled_by::__call::<T>),
        (Complex, "Div", Complex) => two(cx, complex::quotient::__call::<T>),
        (Complex, "Div", Number) => two(cx, complex::unscale::__call::<T>),
        (Number, "Div", Complex) => two(cx, complex::quotient_of_real::__call::<T>),
        (Quaternion, "Neg", _) => one(cx, quaternion::negative::__call::<T>),
        (Quaternion, "Add", Quaternion) => two(cx, quaternion::sum::__call::<T>),
        (Quaternion, "Sub", Quaternion) => two(cx, quaternion::difference::__call::<T>),
        (Quaternion, "Mul", Quaternion) => two(cx, quaternion::product::__call::<T>),
        (Quaternion, "Mul", Number) => two(cx, quaternion::scaled::__call::<T>),
        (Number, "Mul", Quaternion) => two(cx, quaternion::scaled_by::__call::<T>),
        (Quaternion, "Div", Number) => two(cx, quaternion::unscaled::__call::<T>),
        (Unit, "Mul", Unit) => two(cx, unit_quaternion::product::__call::<T>),
        (Unit, "Div", Unit) => two(cx, unit_quaternion::quotient::__call::<T>),
        (Unit, "Mul", Rotation3) => two(cx, unit_quaternion::product_with_matrix::__call::<T>),
        (Unit, "Div", Rotation3) => two(cx, unit_quaternion::quotient_by_matrix::__call::<T>),
        (Rotation3, "Mul", Unit) => two(cx, unit_quaternion::product_of_matrix::__call::<T>),
        (Rotation3, "Div", Unit) => two(cx, unit_quaternion::quotient_of_matrix::__call::<T>),
        (Unit, "Mul", Matrix | Point | UnitVector) => {
            two(cx, unit_quaternion::transform_vector::__call::<T>)
        }
        (Unit, "Mul", Translation) => two(cx, isometry::rotated_translation::__call::<T>),
        (Translation, "Mul", Unit) => two(cx, isometry::translated_rotation::__call::<T>),
        (Unit, "Mul", Isometry) => two(cx, isometry::product_of_rotation::__call::<T>),
        (Unit, "Div", Isometry) => two(cx, isometry::quotient_of_rotation::__call::<T>),
        (Isometry, "Mul", Unit) => two(cx, isometry::product_with_rotation::__call::<T>),
        (Isometry, "Div", Unit) => two(cx, isometry::quotient_by_rotation::__call::<T>),
        (Isometry, "Mul", Isometry) => two(cx, isometry::product::__call::<T>),
        (Isometry, "Div", Isometry) => two(cx, isometry::quotient::__call::<T>),
        (Isometry, "Mul", Translation) => two(cx, isometry::product_with_translation::__call::<T>),
        (Translation, "Mul", Isometry) => two(cx, isometry::product_of_translation::__call::<T>),
        (Isometry, "Mul", Point) => two(cx, isometry::transform_point::__call::<T>),
        (Isometry, "Mul", Matrix | UnitVector) => two(cx, isometry::transform_vector::__call::<T>),
        (Translation, "Mul", Translation | Point) => known(SpatialMethod::Plus),
        (Translation, "Div", Translation) => known(SpatialMethod::Minus),
        (Rotation | Rotation3 | Matrix, "Div", Rotation | Rotation3) => {
            known(SpatialMethod::TimesTransposed)
        }
        _ => Option::None,
    }
}

/// The function whose companion takes one argument.
pub(super) fn of<A, M: Callee, R>(cx: &mut Builder, _: fn(A) -> Called<M, R>) -> tree::Callee {
    M::callee(cx)
}

/// The same as the meaning of a sign.
fn one<A, M: Callee, R>(cx: &mut Builder, call: fn(A) -> Called<M, R>) -> Option<tree::Callee> {
    Some(of(cx, call))
}

/// The function whose companion takes two.
fn two<A, B, M: Callee, R>(cx: &mut Builder, _: fn(A, B) -> Called<M, R>) -> Option<tree::Callee> {
    Some(M::callee(cx))
}
