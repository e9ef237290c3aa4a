//! Companions of nalgebra's complex numbers, rotations and poses, and the meaning of their operators.
//!
//! A `Complex`, a `Quaternion`, a `UnitQuaternion` and an `Isometry3` are structs of the DSL in the C; a `Rotation`,
//! a `Point`, a `Translation` and a `Unit` of a vector are matrices and vectors.

#![allow(missing_docs)]

use alloc::boxed::Box;
use alloc::format;

use bessemer_tree as tree;
use bessemer_tree::number::{Float, Scalar};
use bessemer_tree::operation::Routine;
use bessemer_tree::{Builtin, Parts, SpatialMethod, Ty};
use nalgebra::{
    Complex, Const, Isometry3, OPoint, Point3, Quaternion, Rotation, Rotation2, Rotation3, SMatrix,
    SVector, Translation, Translation3, Unit, UnitQuaternion, UnitVector3, Vector3, Vector4,
};

use super::builder::{Builder, Callee};
use super::companions::companions;
use super::matrices::{AxisX, AxisY, AxisZ, FromArray, Identity, New, TrMul, Transpose, Zeros};
use super::numbers::{FromBuiltin, converts};
use super::slot::{Called, DslType, Seen, dsl_types, stands};
use crate::complex;
use crate::linear::spatial::{isometry, quaternion, unit_quaternion};
use crate::linear::{elementwise, matrix_edit, norms};
use crate::math::Real;

stands! {
    [T: Real] Complex<T> => complex::ComplexNumber<T>;
    [T: Real] Quaternion<T> => quaternion::Quaternion<T>;
    [T: Real] UnitQuaternion<T> => unit_quaternion::UnitQuaternion<T>;
    [T: Real] Isometry3<T> => isometry::Isometry3<T>;
}

/// Defines the types of matrices and vectors with a name of their own.
macro_rules! known {
    ($($native:ty => $rows:ident, $cols:tt, $name:literal;)*) => { dsl_types! {$(
        [T: Real, const N: usize] [T: Real, const N: usize] $native as Self
            => |cx| Ty::Known(format!("{}{N}", $name), Box::new(<SMatrix<T, $rows, $cols>>::ty(cx)));
    )*} };
}

known! {
    Rotation<T, N> => N, N, "Rotation";
    Translation<T, N> => N, 1, "Translation";
    OPoint<T, Const<N>> => N, 1, "Point";
    Unit<SVector<T, N>> => N, 1, "UnitVector";
}

companions! {
    pub mod traits[];
    /// Methods of complex numbers that need no function, and those for which num-complex uses the platform.
    impl[T: Real] ComplexBuiltins<T> for Complex<T> {
        fn __b_new(_re: T, _im: T) -> Self = ComplexNew: Parts(Parts::Complex);
        fn __b_norm(self) -> T = PlatformAngles;
    }
    /// Methods of quaternions that need no function.
    impl[T: Real] QuaternionBuiltins<T> for Quaternion<T> {
        fn __b_new(_w: T, _i: T, _j: T, _k: T) -> Self = QuaternionNew: Parts(Parts::Quaternion);
        fn __b_identity() -> Self = QuaternionIdentity: Spatial(SpatialMethod::QuaternionIdentity);
        fn __b_as_vector(&self) -> &Vector4<T> = QuaternionCoords: Spatial(SpatialMethod::QuaternionCoords);
    }
    /// Methods of `Unit`.
    impl[U: Unitary] UnitBuiltins<U> for Unit<U> {
        fn __b_new_unchecked(_value: U) -> Self = [U::Wrap];
        fn __b_into_inner(self) -> U = [U::Wrap];
        fn __b_as_ref(&self) -> &U = [U::Wrap];
        fn __b_new_normalize(_value: U) -> Self = [U::Normalized];
    }
    /// Methods of unit quaternions that need no function, and constructors from other types.
    impl[T: Real] UnitQuaternionBuiltins<T> for UnitQuaternion<T> {
        fn __b_identity() -> Self = QuaternionIdentity;
        fn __b_new(_axis: Vector3<T>) -> Self = PlatformAngles: Spatial(SpatialMethod::PlatformAngles);
        fn __b_quaternion(&self) -> &Quaternion<T> = SameParts: Spatial(SpatialMethod::SameParts);
        fn __b_angle(&self) -> T = PlatformAngles;
        fn __b_angle_to(&self, _other: &Self) -> T = PlatformAngles;
        fn __b_exp(&self) -> Quaternion<T> = PlatformAngles;
        fn __b_ln(&self) -> Quaternion<T> = PlatformAngles;
        fn __b_try_slerp(&self, _other: &Self, _share: T, _least: T) -> Option<Self> = PlatformAngles;
        fn __b_inverse_transform_unit_vector(&self, _v: &UnitVector3<T>) -> UnitVector3<T>
            = [unit_quaternion::__function_inverse_transform_vector<T>];
        fn __b_transform_point(&self, _p: &Point3<T>) -> Point3<T> = [unit_quaternion::__function_transform_vector<T>];
        fn __b_inverse_transform_point(&self, _p: &Point3<T>) -> Point3<T>
            = [unit_quaternion::__function_inverse_transform_vector<T>];
    }
    /// Companion of `new` for rotations in the plane under another name than nalgebra's: it uses the platform's sine.
    impl[T: Real] NewPlaneRotation<T> for Rotation2<T> {
        fn __b_new(_turn: T) -> Self = PlatformAngles;
    }
    /// Companions of rotations in space.
    impl[T: Real] NewSpaceRotation<T> for Rotation3<T> {
        fn __b_new(_turn: Vector3<T>) -> Self = PlatformAngles;
    }
    /// Methods of rotation matrices.
    impl[T: Real, const N: usize] RotationBuiltins<T, N> for Rotation<T, N> {
        fn __b_identity() -> Self = Identity;
        fn __b_from_matrix_unchecked(_matrix: SMatrix<T, N, N>) -> Self = Same: Owned;
        fn __b_matrix(&self) -> &SMatrix<T, N, N> = Same;
        fn __b_into_inner(self) -> SMatrix<T, N, N> = Same;
        fn __b_transpose(&self) -> Self = Transpose;
        fn __b_inverse(&self) -> Self = Transpose;
        fn __b_transpose_mut(&mut self) -> () = [matrix_edit::__function_transpose_mut<T, N>];
        fn __b_inverse_mut(&mut self) -> () = [matrix_edit::__function_transpose_mut<T, N>];
        fn __b_transform_vector(&self, _v: &SVector<T, N>) -> SVector<T, N> = Times: Linear(Routine::Product);
        fn __b_transform_point(&self, _p: &OPoint<T, Const<N>>) -> OPoint<T, Const<N>> = Times;
        fn __b_inverse_transform_vector(&self, _v: &SVector<T, N>) -> SVector<T, N> = TrMul;
        fn __b_inverse_transform_point(&self, _p: &OPoint<T, Const<N>>) -> OPoint<T, Const<N>> = TrMul;
    }
    /// Methods of translations.
    impl[T: Real, const N: usize] TranslationBuiltins<T, N> for Translation<T, N> {
        fn __b_identity() -> Self = Zeros;
        fn __b_inverse(&self) -> Self = Negative: Linear(Routine::Neg);
        fn __b_inverse_mut(&mut self) -> () = [elementwise::__function_neg_mut<T, N, 1>];
        fn __b_transform_point(&self, _p: &OPoint<T, Const<N>>) -> OPoint<T, Const<N>> = Plus: Linear(Routine::Add);
    }
    /// Methods of points.
    impl[T: Real, const N: usize] PointBuiltins<T, N> for OPoint<T, Const<N>> {
        fn __b_origin() -> Self = Zeros;
    }
    /// Companions of `new` for points and translations in the plane.
    pub trait NewInPlane[T]: Sized {
        fn __b_new(_x: T, _y: T) -> Self = New;
    }
    /// Companions of constructors in space.
    pub trait NewInSpace[T]: Sized {
        fn __b_new(_x: T, _y: T, _z: T) -> Self = New;
    }
    /// Constructors of unit vectors along the axes.
    impl[T: Real, const N: usize] UnitAxisBuiltins<T, N> for SVector<T, N> {
        fn __b_x_axis() -> Unit<Self> = AxisX;
        fn __b_y_axis() -> Unit<Self> = AxisY;
        fn __b_z_axis() -> Unit<Self> = AxisZ;
    }
    /// Methods of poses that need no function, and constructors from other types.
    impl[T: Real] IsometryBuiltins<T> for Isometry3<T> {
        fn __b_from_parts(_by: Translation3<T>, _q: UnitQuaternion<T>) -> Self = IsometryNew: Parts(Parts::Isometry);
        fn __b_new(_by: Vector3<T>, _axis: Vector3<T>) -> Self = PlatformAngles;
        fn __b_lerp_slerp(&self, _other: &Self, _share: T) -> Self = PlatformAngles;
        fn __b_transform_point(&self, _p: &Point3<T>) -> Point3<T> = [isometry::__function_transform_point<T>];
        fn __b_inverse_transform_point(&self, _p: &Point3<T>) -> Point3<T>
            = [isometry::__function_inverse_transform_point<T>];
    }
}

impl<T: Real> NewInPlane<T> for OPoint<T, Const<2>> {}
impl<T: Real> NewInSpace<T> for OPoint<T, Const<3>> {}
impl<T: Real> NewInPlane<T> for Translation<T, 2> {}
impl<T: Real> NewInSpace<T> for Translation<T, 3> {}

/// Types that a `Unit` wraps.
pub trait Unitary: Sized {
    type Wrap: Callee;
    type Normalized: Callee;
}

impl<T: Real> Unitary for Quaternion<T> {
    type Wrap = SameParts;
    type Normalized = unit_quaternion::__function_new_normalize<T>;
}

impl<T: Real, const N: usize> Unitary for SVector<T, N> {
    type Wrap = Same;
    type Normalized = norms::__function_normalize<T, N, 1>;
}

// Conversions that are functions of the DSL.
converts! {
    [] f32 => Complex<f32>: complex::__function_from_real<f32>;
    [] f64 => Complex<f64>: complex::__function_from_real<f64>;
    [T: Real] Vector4<T> => Quaternion<T>: quaternion::__function_from_vector<T>;
    [T: Real] [T; 4] => Quaternion<T>: quaternion::__function_from_array<T>;
    [T: Real, const N: usize] SVector<T, N> => OPoint<T, Const<N>>: Same;
    [T: Real, const N: usize] [T; N] => OPoint<T, Const<N>>: FromArray;
    [T: Real, const N: usize] SVector<T, N> => Translation<T, N>: Same;
    [T: Real, const N: usize] [T; N] => Translation<T, N>: FromArray;
    [T: Real] Translation3<T> => Isometry3<T>: isometry::__function_from_translation<T>;
    [T: Real] Rotation3<T> => UnitQuaternion<T>: unit_quaternion::__function_from_rotation_matrix<T>;
    [T: Real] UnitQuaternion<T> => Rotation3<T>: unit_quaternion::__function_to_rotation_matrix<T>;
}

/// Returns the function of an operator, as far as the types of its operands determine it.
pub(super) fn operator(
    cx: &mut Builder,
    operator: &tree::Operator,
    slots: &[Ty],
) -> Option<tree::Callee> {
    // What has no slot is a literal.
    let mut kinds = operator.operands.iter().map(|slot| match slot {
        Some(slot) => slots.get(*slot as usize).and_then(kind),
        None => Some((Kind::Number, None)),
    });
    let (left, float) = kinds.next()??;
    let (right, of_right) = kinds.next().unwrap_or(Some((Kind::None, None)))?;
    let sign = operator.of.trim_end_matches("Assign");
    match float.or(of_right)? {
        Float::F32 => meaning::<f32>(cx, sign, left, right),
        Float::F64 => meaning::<f64>(cx, sign, left, right),
    }
}

/// Kind of an operand.
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
        Ty::Known(_, inner) if matches!(**inner, Ty::Scalar(_)) => (Kind::Number, None),
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

/// Returns the function or matrix operation of an operator; none if it is an operator of matrices or numbers already.
fn meaning<T: Real>(cx: &mut Builder, sign: &str, left: Kind, right: Kind) -> Option<tree::Callee> {
    use Kind::*;
    let known = |it| Some(tree::Callee::Builtin(it));
    match (left, sign, right) {
        (Complex, "Neg", _) => of::<complex::__function_negative<T>>(cx),
        (Complex, "Add", Complex) => of::<complex::__function_sum<T>>(cx),
        (Complex, "Add", Number) => of::<complex::__function_sum_with_real<T>>(cx),
        (Number, "Add", Complex) => of::<complex::__function_sum_of_real<T>>(cx),
        (Complex, "Sub", Complex) => of::<complex::__function_difference<T>>(cx),
        (Complex, "Sub", Number) => of::<complex::__function_difference_with_real<T>>(cx),
        (Number, "Sub", Complex) => of::<complex::__function_difference_of_real<T>>(cx),
        (Complex, "Mul", Complex) => of::<complex::__function_product<T>>(cx),
        (Complex, "Mul", Number) => of::<complex::__function_scale<T>>(cx),
        (Number, "Mul", Complex) => of::<complex::__function_scaled_by<T>>(cx),
        (Complex, "Div", Complex) => of::<complex::__function_quotient<T>>(cx),
        (Complex, "Div", Number) => of::<complex::__function_unscale<T>>(cx),
        (Number, "Div", Complex) => of::<complex::__function_quotient_of_real<T>>(cx),
        (Quaternion, "Neg", _) => of::<quaternion::__function_negative<T>>(cx),
        (Quaternion, "Add", Quaternion) => of::<quaternion::__function_sum<T>>(cx),
        (Quaternion, "Sub", Quaternion) => of::<quaternion::__function_difference<T>>(cx),
        (Quaternion, "Mul", Quaternion) => of::<quaternion::__function_product<T>>(cx),
        (Quaternion, "Mul", Number) => of::<quaternion::__function_scaled<T>>(cx),
        (Number, "Mul", Quaternion) => of::<quaternion::__function_scaled_by<T>>(cx),
        (Quaternion, "Div", Number) => of::<quaternion::__function_unscaled<T>>(cx),
        (Unit, "Mul", Unit) => of::<unit_quaternion::__function_product<T>>(cx),
        (Unit, "Div", Unit) => of::<unit_quaternion::__function_quotient<T>>(cx),
        (Unit, "Mul", Rotation3) => of::<unit_quaternion::__function_product_with_matrix<T>>(cx),
        (Unit, "Div", Rotation3) => of::<unit_quaternion::__function_quotient_by_matrix<T>>(cx),
        (Rotation3, "Mul", Unit) => of::<unit_quaternion::__function_product_of_matrix<T>>(cx),
        (Rotation3, "Div", Unit) => of::<unit_quaternion::__function_quotient_of_matrix<T>>(cx),
        (Unit, "Mul", Matrix | Point | UnitVector) => {
            of::<unit_quaternion::__function_transform_vector<T>>(cx)
        }
        (Unit, "Mul", Translation) => of::<isometry::__function_rotated_translation<T>>(cx),
        (Translation, "Mul", Unit) => of::<isometry::__function_translated_rotation<T>>(cx),
        (Unit, "Mul", Isometry) => of::<isometry::__function_product_of_rotation<T>>(cx),
        (Unit, "Div", Isometry) => of::<isometry::__function_quotient_of_rotation<T>>(cx),
        (Isometry, "Mul", Unit) => of::<isometry::__function_product_with_rotation<T>>(cx),
        (Isometry, "Div", Unit) => of::<isometry::__function_quotient_by_rotation<T>>(cx),
        (Isometry, "Mul", Isometry) => of::<isometry::__function_product<T>>(cx),
        (Isometry, "Div", Isometry) => of::<isometry::__function_quotient<T>>(cx),
        (Isometry, "Mul", Translation) => {
            of::<isometry::__function_product_with_translation<T>>(cx)
        }
        (Translation, "Mul", Isometry) => of::<isometry::__function_product_of_translation<T>>(cx),
        (Isometry, "Mul", Point) => of::<isometry::__function_transform_point<T>>(cx),
        (Isometry, "Mul", Matrix | UnitVector) => {
            of::<isometry::__function_transform_vector<T>>(cx)
        }
        (Translation, "Mul", Translation | Point) => known(Builtin::Linear(Routine::Add)),
        (Translation, "Div", Translation) => known(Builtin::Linear(Routine::Sub)),
        (Rotation | Rotation3 | Matrix, "Div", Rotation | Rotation3) => {
            known(Builtin::Spatial(SpatialMethod::TimesTransposed))
        }
        _ => Option::None,
    }
}

/// Returns the function of a marker, as the meaning of a sign.
fn of<M: Callee>(cx: &mut Builder) -> Option<tree::Callee> {
    Some(M::callee(cx))
}
