//! Methods of matrices that have the name of a method of scalars, which the attributes redirect.

use nalgebra::linalg::UDU;
use nalgebra::{Const, Matrix, RawStorage, SMatrix};

use super::Real;
use crate::linear::factored::udu::Udu;

/// `abs`, `min`, `max` and `lp_norm` of a matrix, with nalgebra's meaning.
pub trait MatrixMethods {
    /// The type of an element.
    type Element;
    /// The matrix of the same shape that owns its elements.
    type Owned;
    /// The magnitude of each element.
    #[must_use]
    fn dsl_abs(&self) -> Self::Owned;
    /// The smallest element.
    fn dsl_min(&self) -> Self::Element;
    /// The largest element.
    fn dsl_max(&self) -> Self::Element;
    /// The p-norm: see [`lp_norm`](crate::linear::norms::lp_norm).
    fn dsl_lp_norm(&self, p: i32) -> Self::Element;
}

/// Methods of square matrices that the simulation takes from the DSL, too.
pub trait SquareMethods: Sized {
    /// The type of the factorisation U D Uᵀ.
    type Udu;
    /// The matrix exponential: see [`exp`](crate::linear::matrix_powers::exp).
    #[must_use]
    fn dsl_exp(&self) -> Self;
    /// The factorisation U D Uᵀ. nalgebra's own squares by a product if it has std, and by `pow` without it, which
    /// rounds differently.
    fn dsl_udu(self) -> Option<Self::Udu>;
}

impl<T: Real, const N: usize> SquareMethods for SMatrix<T, N, N> {
    type Udu = UDU<T, Const<N>>;
    fn dsl_exp(&self) -> Self {
        crate::linear::matrix_powers::exp(self)
    }
    fn dsl_udu(self) -> Option<UDU<T, Const<N>>> {
        let Udu { u, d } = crate::linear::factored::udu::factored(&self)?;
        Some(UDU { u, d })
    }
}

/// Methods of matrices, and of their rows, columns and blocks.
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
    fn dsl_lp_norm(&self, p: i32) -> T {
        crate::linear::norms::lp_norm(&self.map(|element| element), p)
    }
}
