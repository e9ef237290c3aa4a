//! Symmetric matrices, such as covariances, and their corrections by measurements.
//!
//! Both triangles are stored. Each operation computes the lower one and mirrors it, so that the two never differ: a
//! difference would grow by each prediction, until a covariance loses its sign.

use bessemer::prelude::*;

use crate::{Correction, Status};

/// A symmetric matrix.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric<T: Real, const N: usize> {
    /// Elements; symmetric to the last bit. Code that writes one writes the one that mirrors it.
    pub elements: SMatrix<T, N, N>,
}

impl<T: Real, const N: usize> Default for Symmetric<T, N> {
    fn default() -> Self {
        Symmetric { elements: SMatrix::zeros() }
    }
}

#[data]
impl<T: Real, const N: usize> Symmetric<T, N> {
    /// Returns the matrix with these elements on the diagonal, and zeros elsewhere.
    pub fn diagonal(values: &SVector<T, N>) -> Self {
        let mut elements = SMatrix::zeros();
        for n in 0..N {
            elements[(n, n)] = values[n];
        }
        Symmetric { elements }
    }

    /// Returns the matrix with the lower triangle of another matrix.
    pub fn of_lower(matrix: &SMatrix<T, N, N>) -> Self {
        let mut elements = *matrix;
        for col in 1..N {
            for row in 0..col {
                elements[(row, col)] = matrix[(col, row)];
            }
        }
        Symmetric { elements }
    }

    /// Returns the elements.
    pub fn matrix(&self) -> &SMatrix<T, N, N> {
        &self.elements
    }

    /// Returns an element.
    pub fn at(&self, row: usize, col: usize) -> T {
        self.elements[(row, col)]
    }

    /// Sets an element, and the one that mirrors it.
    pub fn set(&mut self, row: usize, col: usize, value: T) {
        self.elements[(row, col)] = value;
        self.elements[(col, row)] = value;
    }

    /// Adds to the diagonal, such as the process noise of independent errors.
    pub fn add_diagonal(&mut self, values: &SVector<T, N>) {
        for n in 0..N {
            self.elements[(n, n)] += values[n];
        }
    }

    /// Adds another symmetric matrix.
    pub fn add(&mut self, other: &Self) {
        for col in 0..N {
            for row in 0..N {
                self.elements[(row, col)] += other.elements[(row, col)];
            }
        }
    }

    /// Becomes F P Fᵀ, the covariance of the errors after a step with the Jacobian F. Elements of F that are zero are
    /// skipped, so a sparse Jacobian costs its other elements.
    pub fn congruence(&mut self, jacobian: &SMatrix<T, N, N>) {
        // The columns of P Fᵀ.
        let mut product = SMatrix::<T, N, N>::zeros();
        for col in 0..N {
            for k in 0..N {
                let factor = jacobian[(col, k)];
                if factor != T::ZERO {
                    for row in 0..N {
                        product[(row, col)] += self.elements[(row, k)] * factor;
                    }
                }
            }
        }
        for row in 0..N {
            let mut sums = SVector::<T, N>::zeros();
            for k in 0..N {
                let factor = jacobian[(row, k)];
                if factor != T::ZERO {
                    for col in 0..=row {
                        sums[col] += factor * product[(k, col)];
                    }
                }
            }
            for col in 0..=row {
                self.elements[(row, col)] = sums[col];
                self.elements[(col, row)] = sums[col];
            }
        }
    }

    /// Returns P h, the covariance of the errors with a measurement of the row h.
    pub fn times(&self, row: &SVector<T, N>) -> SVector<T, N> {
        let mut sums = SVector::zeros();
        for k in 0..N {
            if row[k] != T::ZERO {
                for n in 0..N {
                    sums[n] += self.elements[(n, k)] * row[k];
                }
            }
        }
        sums
    }

    /// Returns true if each element of the diagonal is positive and finite.
    pub fn is_plausible(&self) -> bool {
        let mut plausible = true;
        for n in 0..N {
            let variance = self.elements[(n, n)];
            plausible = plausible && variance > T::ZERO && variance.is_finite();
        }
        plausible
    }

    /// Corrects by one number: the `row` of the measurement's Jacobian, its `innovation` (measured less expected) and
    /// its variance. The state gains the gain times the innovation. A measurement with a surprise above `gate` is
    /// rejected; the largest number is no gate.
    pub fn correct(
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
        self.corrected(state, &spread, expected, innovation, gate)
    }

    /// Corrects by a measurement of one element of the state, as [`Symmetric::correct`] does. An index beyond the state
    /// is `Lost`.
    pub fn correct_element(
        &mut self,
        state: &mut SVector<T, N>,
        index: usize,
        innovation: T,
        variance: T,
        gate: T,
    ) -> Correction<T> {
        if index >= N {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let mut spread = SVector::<T, N>::zeros();
        for n in 0..N {
            spread[n] = self.elements[(n, index)];
        }
        let expected = spread[index] + variance;
        self.corrected(state, &spread, expected, innovation, gate)
    }

    /// Corrects by a measurement of one element, and leaves the `considered` elements of the state as they are: a
    /// Schmidt–Kalman filter. Their covariance with each other does not change, either.
    pub fn correct_considering(
        &mut self,
        state: &mut SVector<T, N>,
        considered: &[bool; N],
        index: usize,
        innovation: T,
        variance: T,
        gate: T,
    ) -> Correction<T> {
        if index >= N {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let mut spread = SVector::<T, N>::zeros();
        for n in 0..N {
            spread[n] = self.elements[(n, index)];
        }
        let expected = spread[index] + variance;
        if !(expected > T::ZERO && expected.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let scale = T::ONE / expected;
        let surprise = innovation * innovation * scale;
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        for n in 0..N {
            if !(considered[n] || self.elements[(n, n)] - spread[n] * scale * spread[n] > T::ZERO) {
                return Correction { surprise, status: Status::Lost };
            }
        }
        for row in 0..N {
            let gain = spread[row] * scale;
            if !considered[row] {
                state[row] += gain * innovation;
            }
            for col in 0..=row {
                if !(considered[row] && considered[col]) {
                    let value = self.elements[(row, col)] - gain * spread[col];
                    self.elements[(row, col)] = value;
                    self.elements[(col, row)] = value;
                }
            }
        }
        Correction { surprise, status: Status::Corrected }
    }

    /// Corrects by an innovation with the variance `expected` and the covariance `spread` with the errors.
    fn corrected(
        &mut self,
        state: &mut SVector<T, N>,
        spread: &SVector<T, N>,
        expected: T,
        innovation: T,
        gate: T,
    ) -> Correction<T> {
        if !(expected > T::ZERO && expected.is_finite()) {
            return Correction { surprise: T::ZERO, status: Status::Lost };
        }
        let scale = T::ONE / expected;
        let surprise = innovation * innovation * scale;
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        for n in 0..N {
            if !(self.elements[(n, n)] - spread[n] * scale * spread[n] > T::ZERO) {
                return Correction { surprise, status: Status::Lost };
            }
        }
        for row in 0..N {
            let gain = spread[row] * scale;
            state[row] += gain * innovation;
            for col in 0..=row {
                let value = self.elements[(row, col)] - gain * spread[col];
                self.elements[(row, col)] = value;
                self.elements[(col, row)] = value;
            }
        }
        Correction { surprise, status: Status::Corrected }
    }

    /// Corrects by `M` elements of the state from `FIRST` on, at most eight, whose errors are independent and have
    /// these variances R. In the C it needs a state of three numbers or more.
    ///
    /// With H P Hᵀ + R = L Lᵀ and Y = L⁻¹ H P, P loses Yᵀ Y and the state gains Yᵀ L⁻¹ ν. The covariance of a measured
    /// element i with another one n is what row i of Y leaves of it: Yᵢₙ Rᵢ / Lᵢᵢ less the products of the rows of Y
    /// below, half as many products, and precise where the measurement is.
    pub fn correct_part<const FIRST: usize, const M: usize>(
        &mut self,
        state: &mut SVector<T, N>,
        innovation: &SVector<T, M>,
        variances: &SVector<T, M>,
        gate: T,
    ) -> Correction<T> {
        // L below its diagonal: row m from m² / 2 on. `scales` has the reciprocals of the diagonal, `left` R times these.
        let mut factor = [T::ZERO; 31];
        let mut scales = *innovation;
        let mut scaled = *innovation;
        let mut left = *innovation;
        let mut surprise = T::ZERO;
        #[unroll(8)]
        for m in 0..M {
            let mut square = self.elements[(FIRST + m, FIRST + m)] + variances[m];
            let mut rest = innovation[m];
            #[unroll(8)]
            for before in 0..m {
                let mut sum = self.elements[(FIRST + before, FIRST + m)];
                #[unroll(8)]
                for k in 0..before {
                    sum -= factor[before * before / 2 + k] * factor[m * m / 2 + k];
                }
                sum *= scales[before];
                factor[m * m / 2 + before] = sum;
                square -= sum * sum;
                rest -= sum * scaled[before];
            }
            if !(square > T::ZERO) {
                return Correction { surprise: T::ZERO, status: Status::Lost };
            }
            // The square is positive; `abs` lets compilers omit the case of a negative one.
            scales[m] = T::ONE / square.abs().sqrt();
            scaled[m] = rest * scales[m];
            left[m] = variances[m] * scales[m];
            surprise += scaled[m] * scaled[m];
        }
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        let mut rows = SMatrix::<T, M, N>::zeros();
        let mut after = *state;
        for n in 0..N {
            let mut variance = self.elements[(n, n)];
            #[unroll(8)]
            for m in 0..M {
                let mut sum = self.elements[(FIRST + m, n)];
                #[unroll(8)]
                for k in 0..m {
                    sum -= factor[m * m / 2 + k] * rows[(k, n)];
                }
                sum *= scales[m];
                rows[(m, n)] = sum;
                variance -= sum * sum;
            }
            if !(variance > T::ZERO) {
                return Correction { surprise, status: Status::Lost };
            }
            after[n] = variance;
        }

        // The other elements of the state. If the first ones are measured, they begin behind these.
        let start = if FIRST == 0 { M } else { 0 };
        for n in start..N {
            if FIRST > 0 && n >= FIRST && n < FIRST + M {
                continue;
            }
            #[unroll(8)]
            for m in 0..M {
                state[n] += rows[(m, n)] * scaled[m];
            }
            #[unroll(8)]
            for i in 0..M {
                let mut value = rows[(i, n)] * left[i];
                #[unroll(8)]
                for m in i + 1..M {
                    value -= rows[(m, n)] * rows[(m, FIRST + i)];
                }
                self.elements[(FIRST + i, n)] = value;
                self.elements[(n, FIRST + i)] = value;
            }
            self.elements[(n, n)] = after[n];
        }
        #[unroll(8)]
        for i in 0..M {
            #[unroll(8)]
            for n in 0..i {
                let mut value = rows[(i, FIRST + n)] * left[i];
                #[unroll(8)]
                for m in i + 1..M {
                    value -= rows[(m, FIRST + n)] * rows[(m, FIRST + i)];
                }
                self.elements[(FIRST + i, FIRST + n)] = value;
                self.elements[(FIRST + n, FIRST + i)] = value;
            }
        }
        for i in 0..M {
            #[unroll(8)]
            for m in 0..M {
                state[FIRST + i] += rows[(m, FIRST + i)] * scaled[m];
            }
            self.elements[(FIRST + i, FIRST + i)] = after[FIRST + i];
        }
        self.lose::<M, FIRST, M>(&rows);
        Correction { surprise, status: Status::Corrected }
    }

    /// Corrects by several numbers at once, whose errors have the covariance `noise`. With S = H P Hᵀ + R = L Lᵀ and
    /// Y = L⁻¹ H P, P loses Yᵀ Y and the state gains Yᵀ L⁻¹ ν.
    pub fn correct_jointly<const M: usize>(
        &mut self,
        state: &mut SVector<T, N>,
        jacobian: &SMatrix<T, M, N>,
        innovation: &SVector<T, M>,
        noise: &Symmetric<T, M>,
        gate: T,
    ) -> Correction<T> {
        // H P, by columns.
        let mut rows = SMatrix::<T, N, M>::zeros();
        for m in 0..M {
            for k in 0..N {
                let factor = jacobian[(m, k)];
                if factor != T::ZERO {
                    for n in 0..N {
                        rows[(n, m)] += factor * self.elements[(n, k)];
                    }
                }
            }
        }
        // S, in its lower triangle.
        let mut spread = SMatrix::<T, M, M>::zeros();
        for m in 0..M {
            for before in 0..=m {
                let mut sum = noise.elements[(m, before)];
                for n in 0..N {
                    sum += jacobian[(before, n)] * rows[(n, m)];
                }
                spread[(m, before)] = sum;
            }
        }
        self.correct_by(state, &rows, &spread, innovation, gate)
    }

    /// Corrects by numbers whose expected values have the covariance S, in the lower triangle of `spread`, and the
    /// covariance `cross` with the state, by columns. With S = L Lᵀ and Y = L⁻¹ `cross`ᵀ, P loses Yᵀ Y and the state
    /// gains Yᵀ L⁻¹ ν.
    pub(crate) fn correct_by<const M: usize>(
        &mut self,
        state: &mut SVector<T, N>,
        cross: &SMatrix<T, N, M>,
        spread: &SMatrix<T, M, M>,
        innovation: &SVector<T, M>,
        gate: T,
    ) -> Correction<T> {
        // L takes the place of S, Y of `cross`, and L⁻¹ ν of ν.
        let mut factor = *spread;
        let mut rows = *cross;
        let mut scaled = *innovation;
        let mut surprise = T::ZERO;
        for m in 0..M {
            for before in 0..m {
                let mut sum = factor[(m, before)];
                for k in 0..before {
                    sum -= factor[(m, k)] * factor[(before, k)];
                }
                factor[(m, before)] = sum / factor[(before, before)];
            }
            let mut square = factor[(m, m)];
            for k in 0..m {
                square -= factor[(m, k)] * factor[(m, k)];
                scaled[m] = scaled[m] - factor[(m, k)] * scaled[k];
            }
            if !(square > T::ZERO && square.is_finite()) {
                return Correction { surprise: T::ZERO, status: Status::Lost };
            }
            let root = square.sqrt();
            factor[(m, m)] = root;
            scaled[m] /= root;
            surprise += scaled[m] * scaled[m];
        }
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        for m in 0..M {
            for k in 0..m {
                for n in 0..N {
                    rows[(n, m)] = rows[(n, m)] - factor[(m, k)] * rows[(n, k)];
                }
            }
            for n in 0..N {
                rows[(n, m)] /= factor[(m, m)];
            }
        }
        for n in 0..N {
            let mut variance = self.elements[(n, n)];
            for m in 0..M {
                variance -= rows[(n, m)] * rows[(n, m)];
            }
            if !(variance > T::ZERO) {
                return Correction { surprise, status: Status::Lost };
            }
        }
        for row in 0..N {
            for m in 0..M {
                state[row] += rows[(row, m)] * scaled[m];
            }
            for col in 0..=row {
                let mut value = self.elements[(row, col)];
                for m in 0..M {
                    value -= rows[(row, m)] * rows[(col, m)];
                }
                self.elements[(row, col)] = value;
                self.elements[(col, row)] = value;
            }
        }
        Correction { surprise, status: Status::Corrected }
    }
}
