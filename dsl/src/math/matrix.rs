//! Methods of matrices that go by the name of one of a scalar, which the attributes redirect.

use nalgebra::{Const, Matrix, RawStorage, SMatrix};

use super::Real;

/// What `abs`, `min` and `max` of a matrix mean: what they mean in nalgebra.
pub trait MatrixMethods {
    /// The type of an element.
    type Element;
    /// A matrix of the same shape that is nobody's part.
    type Owned;
    /// The magnitude of each element.
    #[must_use]
    fn dsl_abs(&self) -> Self::Owned;
    /// The smallest element.
    fn dsl_min(&self) -> Self::Element;
    /// The largest element.
    fn dsl_max(&self) -> Self::Element;
}

/// What `exp` of a square matrix means: its exponential, in the DSL's own order.
pub trait SquareMethods {
    /// The exponential: see [`exp`](crate::linear::matrix_powers::exp).
    #[must_use]
    fn dsl_exp(&self) -> Self;
}

impl<T: Real, const N: usize> SquareMethods for SMatrix<T, N, N> {
    fn dsl_exp(&self) -> Self {
        crate::linear::matrix_powers::exp(self)
    }
}

/// Of matrices, and of their rows, columns and blocks.
impl<T: Real, const R: usize, const C: usize, S: RawStorage<T, Const<R>, Const<C>>> MatrixMethods
    for Matrix<T, Const<R>, Const<C>, S>
{
    type Element = T;
    type Owned = SMatrix<T, R, C>;
    fn dsl_abs(&self) -> SMatrix<T, R, C> {
        self.map(|element| element.dsl_abs())
    }
    fn dsl_min(&self) -> T {
        self.min()
    }
    fn dsl_max(&self) -> T {
        self.max()
    }
}
