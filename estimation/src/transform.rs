//! The unscented transform: mean and covariance behind a function, without its derivative (Julier and Uhlmann,
//! Unscented Filtering and Nonlinear Estimation, 2004).
//!
//! The function is evaluated at the mean and at 2 N points around it: the mean plus and minus each column of √s L, with
//! P = L Lᵀ and the `spread` s. The mean has the weight 1 − N/s, each other point 1/(2 s). From s = N on no weight is
//! negative, so no covariance is. A spread of 3 has the fourth moments of a normal distribution along each axis.

use bessemer::prelude::*;

use crate::{Correction, Symmetric};

/// A distribution behind a function of N numbers with M results.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transformed<T: Real, const N: usize, const M: usize> {
    /// Mean of the results.
    pub mean: SVector<T, M>,
    /// Covariance of the results.
    pub covariance: Symmetric<T, M>,
    /// Covariance of the numbers, by rows, with the results, by columns.
    pub cross: SMatrix<T, N, M>,
}

/// Returns the distribution of `law` of numbers with this mean and covariance; none unless the covariance is positive
/// definite and the spread positive.
#[function]
pub fn unscented<T: Real, const N: usize, const M: usize>(
    mean: &SVector<T, N>,
    covariance: &Symmetric<T, N>,
    spread: T,
    law: impl Fn(&SVector<T, N>) -> SVector<T, M>,
) -> Option<Transformed<T, N, M>> {
    let factor = covariance.root()?;
    if !(spread > T::ZERO) {
        return None;
    }
    let width = spread.sqrt();
    let weight = T::ONE / (spread + spread);
    let center = law(mean);

    // Half the sum and half the difference of the results at the two points of each column, the sum less that at the
    // mean.
    let mut even = SMatrix::<T, M, N>::zeros();
    let mut odd = SMatrix::<T, M, N>::zeros();
    let mut offset = SVector::<T, M>::zeros();
    for n in 0..N {
        let step = factor.column(n) * width;
        let ahead = law(&(mean + step)) - center;
        let behind = law(&(mean - step)) - center;
        for m in 0..M {
            even[(m, n)] = ahead[m] + behind[m];
            odd[(m, n)] = ahead[m] - behind[m];
            offset[m] += weight * even[(m, n)];
        }
    }

    // Σ wᵢ (yᵢ − ȳ)(yᵢ − ȳ)ᵀ: the pairs' squares are (e eᵀ + o oᵀ)/2, and the weights' sum is one.
    let half = weight * real(0.5);
    let mut spreads = Symmetric::diagonal(&SVector::zeros());
    for row in 0..M {
        for col in 0..=row {
            let mut sum = T::ZERO;
            for n in 0..N {
                sum += even[(row, n)] * even[(col, n)] + odd[(row, n)] * odd[(col, n)];
            }
            let value = half * sum - offset[row] * offset[col];
            spreads.elements[(row, col)] = value;
            spreads.elements[(col, row)] = value;
        }
    }
    let mut cross = SMatrix::<T, N, M>::zeros();
    for n in 0..N {
        for m in 0..M {
            let slope = weight * width * odd[(m, n)];
            for row in n..N {
                cross[(row, m)] += factor[(row, n)] * slope;
            }
        }
    }
    Some(Transformed { mean: center + offset, covariance: spreads, cross })
}

#[data]
impl<T: Real, const N: usize> Symmetric<T, N> {
    /// Returns the lower triangle L with positive diagonal, of which P is L Lᵀ; none unless P is positive definite.
    pub fn root(&self) -> Option<SMatrix<T, N, N>> {
        if !self.is_plausible() {
            return None;
        }
        let factor = self.elements.cholesky()?;
        Some(factor.l())
    }

    /// Corrects by a measurement whose distribution is `expected`, from [`unscented`], with errors of the covariance
    /// `noise`. The state gains K ν and P loses K S Kᵀ, with S = `expected.covariance` + `noise` = L Lᵀ and K =
    /// `expected.cross` S⁻¹.
    pub fn correct_unscented<const M: usize>(
        &mut self,
        state: &mut SVector<T, N>,
        expected: &Transformed<T, N, M>,
        measured: &SVector<T, M>,
        noise: &Symmetric<T, M>,
        gate: T,
    ) -> Correction<T> {
        let mut total = expected.covariance;
        total.add(noise);
        let innovation = measured - expected.mean;
        self.correct_by(state, &expected.cross, &total.elements, &innovation, gate)
    }
}
