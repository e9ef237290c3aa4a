//! Systems of equations and inverses as values: copies, solved in place.

use nalgebra::SMatrix;

use super::{inverse_mut, solve_into};
use crate::math::Real;
use crate::{function, library};

/// The solution of `a x = b` for each column of `b`, with the bits of nalgebra's `a.lu().solve(&b)`; none if
/// `a` is singular. Of any size; natively copies of both lie on the stack: for large ones there is
/// [`solve_into`] and [`super::solve_mut`].
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
    /// The inverse of `a`, with the bits of nalgebra's `a.try_inverse()`; none if `a` is singular. Of any
    /// size; for large ones there is [`inverse_mut`].
    #[method(try_inverse)]
    #[by_value(a)]
    pub fn inverse(a: &Self) -> Option<Self> {
        let mut inverse = *a;
        if inverse_mut(&mut inverse) { Some(inverse) } else { None }
    }
}
