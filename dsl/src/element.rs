//! Element types of a bounded matrix: scalars, and numbers for some operations.

use core::ops::{Add, AddAssign, Mul, MulAssign, Sub, SubAssign};

use nalgebra::Scalar;

use crate::Plain;

/// A scalar of the DSL: a number, or `bool`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a scalar of the DSL",
    label = "not an integer, a float or `bool`"
)]
pub trait Element: Scalar + Copy + Default + Plain + generated::Generated {
    /// The value 0, or `false`.
    const ZERO: Self;
}

/// An integer or a float.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number of the DSL",
    label = "not an integer or a float"
)]
pub trait Number:
    Element
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + PartialOrd
{
}

macro_rules! elements {
    ($($ty:ty: $zero:expr),*) => {$(
        impl Element for $ty {
            const ZERO: $ty = $zero;
        }
    )*};
}

macro_rules! numbers {
    ($($ty:ty),*) => {$(
        impl Number for $ty {}
    )*};
}

elements! {
    bool: false, f32: 0.0, f64: 0.0,
    i8: 0, i16: 0, i32: 0, i64: 0, isize: 0, u8: 0, u16: 0, u32: 0, u64: 0, usize: 0
}
numbers!(f32, f64, i8, i16, i32, i64, isize, u8, u16, u32, u64, usize);

/// Additional bounds of a scalar in a generation build.
#[cfg(feature = "generate")]
mod generated {
    use crate::generate::{ScalarType, Value};

    /// Bounds of a scalar that a generation build adds.
    pub trait Generated: Value + ScalarType {}

    impl<T: Value + ScalarType> Generated for T {}
}

/// No additional bounds, outside generation builds.
#[cfg(not(feature = "generate"))]
mod generated {
    /// No additional bounds.
    pub trait Generated {}

    impl<T> Generated for T {}
}
