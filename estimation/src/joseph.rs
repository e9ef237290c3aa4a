//! Corrections in Joseph's form, which keeps small variances exact.
//!
//! Source: Bierman, Factorization Methods for Discrete Sequential Estimation, 1977; his stabilised form of two changes
//! of rank one.

use bessemer::prelude::*;

use crate::{Correction, Status, Symmetric};

#[data]
impl<T: Real, const N: usize> Symmetric<T, N> {
    /// Corrects as [`Symmetric::correct`] does, in Joseph's form: (I − K h) P (I − K h)ᵀ + K r Kᵀ. It takes twice the
    /// time, and a measurement that is far more certain than the state leaves the variance of the measurement.
    pub fn correct_joseph(
        &mut self,
        state: &mut SVector<T, N>,
        row: &SVector<T, N>,
        innovation: T,
        variance: T,
        gate: T,
    ) -> Correction<T> {
        let spread = self.times(row);
        let mut expected = variance;
        for n in 0..N {
            expected += row[n] * spread[n];
        }
        if !(expected > T::ZERO && expected.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let scale = T::ONE / expected;
        let surprise = innovation * innovation * scale;
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        // With A = (I − K h) P the covariance becomes A + (K r − A hᵀ) Kᵀ.
        let gain = spread * scale;
        let mut rest = SVector::<T, N>::zeros();
        for n in 0..N {
            let mut sum = gain[n] * variance;
            for k in 0..N {
                if row[k] != T::ZERO {
                    sum -= (self.elements[(n, k)] - gain[n] * spread[k]) * row[k];
                }
            }
            rest[n] = sum;
            let left = self.elements[(n, n)] - gain[n] * spread[n] + rest[n] * gain[n];
            if !(left > T::ZERO) {
                return Correction { surprise, status: Status::Lost };
            }
        }
        for n in 0..N {
            state[n] += gain[n] * innovation;
            for col in 0..=n {
                let value = self.elements[(n, col)] - gain[n] * spread[col] + rest[n] * gain[col];
                self.elements[(n, col)] = value;
                self.elements[(col, n)] = value;
            }
        }
        Correction { surprise, status: Status::Corrected }
    }
}
