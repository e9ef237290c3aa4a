//! Model predictive control as a quadratic program in the inputs of its horizon, for the solvers of `bessemer-blocks`.

use nalgebra::SMatrix;

/// A program whose unknowns z are the inputs u(0), u(1), … of a horizon; the states follow from the measured one, x.
///
/// The gradient is `gradient` x. The first rows are the inputs, whose limits are their own. The others are the outputs
/// y(1), y(2), … less those without inputs: from the limits of each, `offset` x is subtracted, which is 0 for inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Condensed<const X: usize, const N: usize, const M: usize> {
    /// H, the second derivative of the cost.
    pub hessian: SMatrix<f64, N, N>,
    /// The gradient of the cost for each state.
    pub gradient: SMatrix<f64, N, X>,
    /// Inputs and outputs for each unknown.
    pub rows: SMatrix<f64, M, N>,
    /// Inputs and outputs for each state.
    pub offset: SMatrix<f64, M, X>,
}

/// Condenses a horizon of x(k+1) = A x(k) + B u(k), y(k) = C x(k). The cost is half of Σ x(k)ᵀQx(k) + u(k)ᵀRu(k), with P
/// in the place of Q for the last state.
///
/// `N` is the number of inputs times the periods, `M` is `N` and the number of outputs times the periods; with other
/// sizes the result is `None`. With P of [`dare`](crate::dare) and no active limit, u(0) is the input
/// of [`lqr`](crate::lqr).
pub fn condensed<const X: usize, const U: usize, const Y: usize, const N: usize, const M: usize>(
    (a, b, c): (&SMatrix<f64, X, X>, &SMatrix<f64, X, U>, &SMatrix<f64, Y, X>),
    (q, r, p): (&SMatrix<f64, X, X>, &SMatrix<f64, U, U>, &SMatrix<f64, X, X>),
) -> Option<Condensed<X, N, M>> {
    let periods = N.checked_div(U)?;
    if periods == 0 || periods * U != N || N + periods * Y != M {
        return None;
    }
    let mut found = Condensed {
        hessian: SMatrix::<f64, N, N>::zeros(),
        gradient: SMatrix::<f64, N, X>::zeros(),
        rows: SMatrix::<f64, M, N>::identity(),
        offset: SMatrix::<f64, M, X>::zeros(),
    };
    let (mut free, mut forced) = (SMatrix::<f64, X, X>::identity(), SMatrix::<f64, X, N>::zeros());
    for k in 0..periods {
        free = a * free;
        forced = a * forced;
        let mut present = forced.view_mut((0, k * U), (X, U));
        present += b;
        let weight = if k + 1 == periods { p } else { q };
        found.hessian += forced.transpose() * weight * forced;
        found.gradient += forced.transpose() * weight * free;
        let mut inputs = found.hessian.view_mut((k * U, k * U), (U, U));
        inputs += r;
        found.rows.view_mut((N + k * Y, 0), (Y, N)).copy_from(&(c * forced));
        found.offset.view_mut((N + k * Y, 0), (Y, X)).copy_from(&(c * free));
    }
    Some(found)
}
