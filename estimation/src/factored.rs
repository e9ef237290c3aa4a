//! A covariance as U D Uᵀ, with a unit upper triangle U and a diagonal D (Bierman, Factorization Methods for Discrete
//! Sequential Estimation, 1977). Its variances cannot become negative by rounding.

use bessemer::prelude::*;

use crate::{Correction, Status, Symmetric};

/// A covariance U D Uᵀ.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factored<T: Real, const N: usize> {
    /// The factor U above its diagonal of ones, and D on the diagonal. The others are zero.
    factor: SMatrix<T, N, N>,
}

#[data]
impl<T: Real, const N: usize> Factored<T, N> {
    /// Returns the factors of a covariance; none unless it is positive definite.
    pub fn of(covariance: &Symmetric<T, N>) -> Option<Self> {
        let mut factor = SMatrix::<T, N, N>::zeros();
        for step in 0..N {
            let col = N - 1 - step;
            for above in 0..=col {
                let row = col - above;
                let mut sum = covariance.elements[(row, col)];
                for k in col + 1..N {
                    sum -= factor[(row, k)] * factor[(k, k)] * factor[(col, k)];
                }
                if row == col {
                    if !(sum > T::ZERO && sum.is_finite()) {
                        return None;
                    }
                    factor[(col, col)] = sum;
                } else {
                    factor[(row, col)] = sum / factor[(col, col)];
                }
            }
        }
        Some(Factored { factor })
    }

    /// Returns the covariance.
    pub fn covariance(&self) -> Symmetric<T, N> {
        let mut covariance = Symmetric::diagonal(&SVector::zeros());
        for row in 0..N {
            for col in 0..=row {
                let mut sum = T::ZERO;
                for k in row..N {
                    let left = if k == row { T::ONE } else { self.factor[(row, k)] };
                    let right = if k == col { T::ONE } else { self.factor[(col, k)] };
                    sum += left * self.factor[(k, k)] * right;
                }
                covariance.elements[(row, col)] = sum;
                covariance.elements[(col, row)] = sum;
            }
        }
        covariance
    }

    /// Corrects by one number, as [`Symmetric::correct`] does.
    pub fn correct(
        &mut self,
        state: &mut SVector<T, N>,
        row: &SVector<T, N>,
        innovation: T,
        variance: T,
        gate: T,
    ) -> Correction<T> {
        // f = Uᵀ h, g = D f.
        let mut f = *row;
        let mut g = *row;
        let mut expected = variance;
        for n in 0..N {
            for k in 0..n {
                f[n] += self.factor[(k, n)] * row[k];
            }
            g[n] = self.factor[(n, n)] * f[n];
            expected += f[n] * g[n];
        }
        if !(variance > T::ZERO && expected > T::ZERO && expected.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let surprise = innovation * innovation / expected;
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        let mut sum = variance;
        let mut gain = SVector::<T, N>::zeros();
        for n in 0..N {
            let before = sum;
            sum += f[n] * g[n];
            self.factor[(n, n)] *= before / sum;
            gain[n] = g[n];
            let slope = -f[n] / before;
            for k in 0..n {
                let old = self.factor[(k, n)];
                self.factor[(k, n)] = old + gain[k] * slope;
                gain[k] += old * g[n];
            }
        }
        for n in 0..N {
            state[n] += gain[n] / sum * innovation;
        }
        Correction { surprise, status: Status::Corrected }
    }
}
