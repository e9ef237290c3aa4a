//! Systems of linear equations and inverses, as functions that return a new matrix: they solve a copy in place.

use nalgebra::SMatrix;

use super::{inverse_mut, solve_into};
use crate::math::Real;
use crate::{function, library};

/// The solution of `a x = b` for each column of `b`, with the bits of nalgebra's `a.lu().solve(&b)`; `None` if `a` is
/// singular.
///
/// For any size. In the simulation the copies of both matrices are on the stack; [`solve_into`] and
/// [`super::solve_mut`] need no copies of large ones.
#[function]
pub fn solve<T: Real, const N: usize, const K: usize>(
    a: &SMatrix<T, N, N>,
    b: &SMatrix<T, N, K>,
) -> Option<SMatrix<T, N, K>> {
    let mut x = *b;
    if solve_into(a, &mut x) { Some(x) } else { None }
}

#[library(InverseCompanion)]
impl<T: Real, const N: usize> SMatrix<T, N, N> {
    /// The inverse of `a`, with the bits of nalgebra's `a.try_inverse()`; `None` if `a` is singular. For any size;
    /// [`inverse_mut`] needs no copy of a large one.
    #[method(try_inverse)]
    #[by_value(a)]
    pub fn inverse(a: &Self) -> Option<Self> {
        let mut inverse = *a;
        if inverse_mut(&mut inverse) { Some(inverse) } else { None }
    }
}
