//! Gains of state feedback and of observers for x(k+1) = A x(k) + B u(k), y(k) = C x(k).
//!
//! Source: Chu, Fan, Lin and Wang, *Structure-Preserving Algorithms for Periodic Discrete-Time Algebraic Riccati
//! Equations*, International Journal of Control 77 (8), 2004, for the doubling; Ackermann, *Der Entwurf linearer
//! Regelungssysteme im Zustandsraum*, Regelungstechnik 20, 1972.

use nalgebra::{Complex, SMatrix};

/// Doublings until the Riccati equation is solved, at most: each doubles the number of periods.
const DOUBLINGS: usize = 60;

/// Solves the discrete algebraic Riccati equation.
///
/// X = AᵀXA − AᵀXB (R + BᵀXB)⁻¹ BᵀXA + Q. The result is `None` if it has no stabilising solution, or `r` is singular.
pub fn dare<const N: usize, const M: usize>(
    a: &SMatrix<f64, N, N>,
    b: &SMatrix<f64, N, M>,
    q: &SMatrix<f64, N, N>,
    r: &SMatrix<f64, M, M>,
) -> Option<SMatrix<f64, N, N>> {
    let one = SMatrix::<f64, N, N>::identity();
    let (mut a, mut x) = (*a, *q);
    let mut g = b * r.try_inverse()? * b.transpose();
    for _ in 0..DOUBLINGS {
        let inverse = (one + g * x).try_inverse()?;
        let next = x + a.transpose() * x * inverse * a;
        g += a * inverse * g * a.transpose();
        a = a * inverse * a;
        let change = (next - x).amax();
        x = (next + next.transpose()) * 0.5;
        if !x.amax().is_finite() {
            return None;
        }
        if change <= 1e-15 * x.amax() {
            return Some(x);
        }
    }
    None
}

/// Returns the gain K of the linear quadratic regulator u = −K x, which minimises Σ xᵀQx + uᵀRu.
///
/// Weights are in the units of the state and the input: Q is symmetric, not negative; R is symmetric, positive.
pub fn lqr<const N: usize, const M: usize>(
    a: &SMatrix<f64, N, N>,
    b: &SMatrix<f64, N, M>,
    q: &SMatrix<f64, N, N>,
    r: &SMatrix<f64, M, M>,
) -> Option<SMatrix<f64, M, N>> {
    let x = dare(a, b, q, r)?;
    let inverse = (r + b.transpose() * x * b).try_inverse()?;
    Some(inverse * b.transpose() * x * a)
}

/// Returns the gain L of the steady Kalman filter, x̂ += L (y − C x̂) before the next prediction.
///
/// `q` and `r` are the covariances of the state's noise in a period and of the measurement's.
pub fn kalman<const N: usize, const P: usize>(
    a: &SMatrix<f64, N, N>,
    c: &SMatrix<f64, P, N>,
    q: &SMatrix<f64, N, N>,
    r: &SMatrix<f64, P, P>,
) -> Option<SMatrix<f64, N, P>> {
    let covariance = dare(&a.transpose(), &c.transpose(), q, r)?;
    let inverse = (c * covariance * c.transpose() + r).try_inverse()?;
    Some(covariance * c.transpose() * inverse)
}

/// Returns the gain K of u = −K x that gives A − B K these poles, by Ackermann's formula. The result is `None` if the
/// input does not reach each state.
///
/// A complex pole is beside its conjugate. The formula is accurate for a few states.
pub fn place<const N: usize>(
    a: &SMatrix<f64, N, N>,
    b: &SMatrix<f64, N, 1>,
    poles: &[Complex<f64>; N],
) -> Option<SMatrix<f64, 1, N>> {
    let mut reached = SMatrix::<f64, N, N>::zeros();
    let mut column = *b;
    for k in 0..N {
        reached.set_column(k, &column);
        column = a * column;
    }
    // The polynomial of the poles, of A: one factor of first order, or a pair, at a time.
    let one = SMatrix::<f64, N, N>::identity();
    let mut polynomial = one;
    for pole in poles {
        if pole.im > 0.0 {
            polynomial *= a * a - a * (2.0 * pole.re) + one * pole.norm_sqr();
        } else if pole.im == 0.0 {
            polynomial *= a - one * pole.re;
        }
    }
    let inverse = reached.try_inverse()?;
    let last: SMatrix<f64, 1, N> = inverse.fixed_rows::<1>(N - 1).into_owned();
    Some(last * polynomial)
}
