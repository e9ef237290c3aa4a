//! The smoother of Rauch, Tung and Striebel (Maximum Likelihood Estimates of Linear Dynamic Systems, 1965): a recorded
//! filter, corrected by what came after.

use bessemer::prelude::*;

use crate::Symmetric;

/// A state and the covariance of its errors.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate<T: Real, const N: usize> {
    /// State.
    pub state: SVector<T, N>,
    /// Covariance of its errors.
    pub covariance: Symmetric<T, N>,
}

/// Returns the smoothed estimate of a step; none unless the predicted covariance is positive definite.
///
/// `filtered` is the estimate after the step's corrections, `predicted` the one that the Jacobian F leads to for the
/// next step, and `next` the next step's smoothed estimate.
///
/// From the last step, whose filtered estimate is smoothed, backwards: x + G (x⁺ − x⁻) and P + G (P⁺ − P⁻) Gᵀ with G =
/// P Fᵀ (P⁻)⁻¹.
#[function]
pub fn smoothed<T: Real, const N: usize>(
    filtered: &Estimate<T, N>,
    jacobian: &SMatrix<T, N, N>,
    predicted: &Estimate<T, N>,
    next: &Estimate<T, N>,
) -> Option<Estimate<T, N>> {
    // Gᵀ = (P⁻)⁻¹ F P.
    let factor = predicted.covariance.elements.cholesky()?;
    let gain = factor.solve(&(jacobian * filtered.covariance.matrix())).transpose();
    let state = filtered.state + gain * (next.state - predicted.state);
    let mut change = next.covariance;
    for row in 0..N {
        for col in 0..=row {
            let value = change.elements[(row, col)] - predicted.covariance.elements[(row, col)];
            change.elements[(row, col)] = value;
            change.elements[(col, row)] = value;
        }
    }
    change.congruence(&gain);
    change.add(&filtered.covariance);
    Some(Estimate { state, covariance: change })
}
