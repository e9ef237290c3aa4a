//! A covariance by its square root, P = L Lᵀ with a lower triangle L: twice the digits, and no negative variance.
//!
//! Sources: Van der Merwe and Wan, The Square-Root Unscented Kalman Filter, 2001; Gill et al., Methods for Modifying
//! Matrix Factorizations, 1974.

use bessemer::prelude::*;

use crate::{Correction, Status, Symmetric};

/// A covariance L Lᵀ.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rooted<T: Real, const N: usize> {
    /// The lower triangle L, zero above its diagonal.
    factor: SMatrix<T, N, N>,
}

#[data]
impl<T: Real, const N: usize> Rooted<T, N> {
    /// Returns independent errors with these standard deviations, 0 or more.
    pub fn diagonal(deviations: &SVector<T, N>) -> Self {
        let mut factor = SMatrix::zeros();
        for n in 0..N {
            factor[(n, n)] = deviations[n];
        }
        Rooted { factor }
    }

    /// Returns the root of a covariance; none unless it is positive definite.
    pub fn of(covariance: &Symmetric<T, N>) -> Option<Self> {
        let factor = covariance.root()?;
        Some(Rooted { factor })
    }

    /// Returns the lower triangle L.
    pub fn factor(&self) -> &SMatrix<T, N, N> {
        &self.factor
    }

    /// Returns the covariance.
    pub fn covariance(&self) -> Symmetric<T, N> {
        let mut covariance = Symmetric::diagonal(&SVector::zeros());
        for row in 0..N {
            for col in 0..=row {
                let mut sum = T::ZERO;
                for k in 0..=col {
                    sum += self.factor[(row, k)] * self.factor[(col, k)];
                }
                covariance.elements[(row, col)] = sum;
                covariance.elements[(col, row)] = sum;
            }
        }
        covariance
    }

    /// Adds v vᵀ to the covariance, by a plane rotation for each column.
    pub fn add(&mut self, vector: &SVector<T, N>) {
        let mut rest = *vector;
        for col in 0..N {
            let (before, added) = (self.factor[(col, col)], rest[col]);
            let length = (before * before + added * added).sqrt();
            if length > T::ZERO {
                let (cosine, sine) = (before / length, added / length);
                self.factor[(col, col)] = length;
                for row in col + 1..N {
                    let old = self.factor[(row, col)];
                    self.factor[(row, col)] = cosine * old + sine * rest[row];
                    rest[row] = cosine * rest[row] - sine * old;
                }
            }
        }
    }

    /// Removes v vᵀ from the covariance. Returns false, and changes nothing, if the covariance would not stay positive.
    pub fn remove(&mut self, vector: &SVector<T, N>) -> bool {
        let mut factor = self.factor;
        let mut rest = *vector;
        for col in 0..N {
            let (before, removed) = (factor[(col, col)], rest[col]);
            let square = (before - removed) * (before + removed);
            if !(square > T::ZERO && square.is_finite()) {
                return false;
            }
            let length = square.sqrt();
            let (scale, slope) = (before / length, removed / length);
            factor[(col, col)] = length;
            for row in col + 1..N {
                let old = factor[(row, col)];
                factor[(row, col)] = scale * old - slope * rest[row];
                rest[row] = scale * rest[row] - slope * old;
            }
        }
        self.factor = factor;
        true
    }

    /// Becomes the covariance behind a step with the Jacobian F and independent noise of these standard deviations.
    pub fn predict(&mut self, jacobian: &SMatrix<T, N, N>, deviations: &SVector<T, N>) {
        let product = jacobian * self.factor;
        self.factor = Rooted::diagonal(deviations).factor;
        for n in 0..N {
            self.add(&product.column(n).into_owned());
        }
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
        // f = Lᵀ h; P h = L f.
        let mut f = SVector::<T, N>::zeros();
        let mut expected = variance;
        for n in 0..N {
            for k in n..N {
                f[n] += self.factor[(k, n)] * row[k];
            }
            expected += f[n] * f[n];
        }
        if !(variance > T::ZERO && expected.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let surprise = innovation * innovation / expected;
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }
        let mut gain = SVector::<T, N>::zeros();
        for n in 0..N {
            for k in 0..=n {
                gain[n] += self.factor[(n, k)] * f[k];
            }
        }
        let length = expected.sqrt();
        let step = gain / length;
        if !self.remove(&step) {
            return Correction { surprise, status: Status::Lost };
        }
        for n in 0..N {
            state[n] += step[n] * (innovation / length);
        }
        Correction { surprise, status: Status::Corrected }
    }

    /// Moves a state and this covariance by a step without a derivative, with the points of
    /// [`unscented`](crate::unscented) and independent noise of these standard deviations. Returns false, and changes
    /// nothing, if `spread` is less than N.
    pub fn predict_unscented(
        &mut self,
        state: &mut SVector<T, N>,
        spread: T,
        deviations: &SVector<T, N>,
        law: impl Fn(&SVector<T, N>) -> SVector<T, N>,
    ) -> bool {
        let size = real::<T>(N as f64);
        if !(spread >= size && spread.is_finite()) {
            return false;
        }
        let width = spread.sqrt();
        let weight = T::ONE / (spread + spread);
        let center = law(state);
        let mut ahead = SMatrix::<T, N, N>::zeros();
        let mut behind = SMatrix::<T, N, N>::zeros();
        let mut offset = SVector::<T, N>::zeros();
        for n in 0..N {
            let step = self.factor.column(n) * width;
            let after = law(&(*state + step));
            let before = law(&(*state - step));
            ahead.set_column(n, &(after - center));
            behind.set_column(n, &(before - center));
            offset += (ahead.column(n) + behind.column(n)) * weight;
        }
        let share = weight.sqrt();
        self.factor = Rooted::diagonal(deviations).factor;
        for n in 0..N {
            let after = (ahead.column(n) - offset) * share;
            let before = (behind.column(n) - offset) * share;
            self.add(&after);
            self.add(&before);
        }
        self.add(&(offset * (T::ONE - size / spread).sqrt()));
        *state = center + offset;
        true
    }

    /// Corrects a state by one number that `law` expects, with the points of [`unscented`](crate::unscented). Several
    /// independent numbers are corrected one by one.
    pub fn correct_unscented(
        &mut self,
        state: &mut SVector<T, N>,
        spread: T,
        measured: T,
        variance: T,
        gate: T,
        law: impl Fn(&SVector<T, N>) -> T,
    ) -> Correction<T> {
        if !(spread > T::ZERO && variance > T::ZERO) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let width = spread.sqrt();
        let weight = T::ONE / (spread + spread);
        let center = law(state);
        let mut offset = T::ZERO;
        let mut squares = T::ZERO;
        let mut slopes = SVector::<T, N>::zeros();
        for n in 0..N {
            let step = self.factor.column(n) * width;
            let ahead = law(&(*state + step)) - center;
            let behind = law(&(*state - step)) - center;
            offset += weight * (ahead + behind);
            squares += weight * (ahead * ahead + behind * behind);
            slopes[n] = weight * width * (ahead - behind);
        }
        let expected = squares - offset * offset + variance;
        if !(expected > T::ZERO && expected.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let innovation = measured - (center + offset);
        let surprise = innovation * innovation / expected;
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }
        let length = expected.sqrt();
        let step = self.factor * slopes / length;
        if !self.remove(&step) {
            return Correction { surprise, status: Status::Lost };
        }
        *state += step * (innovation / length);
        Correction { surprise, status: Status::Corrected }
    }
}
