//! Corrections by measurements that depend on a few elements of a large state.

use bessemer::prelude::*;

use crate::{Correction, Selection, Status, Symmetric};

#[data]
impl<T: Real, const N: usize> Symmetric<T, N> {
    /// Corrects by `M` numbers, at most eight, that depend on the selected elements of the state alone: `jacobian` has
    /// their derivatives. Their errors are independent and have these variances.
    ///
    /// An index of N or more selects the last element. With S = H P Hᵀ + R = L Lᵀ and Y = L⁻¹ H P, P loses Yᵀ Y and the
    /// state gains Yᵀ L⁻¹ ν.
    pub fn correct_selected<const K: usize, const M: usize>(
        &mut self,
        state: &mut SVector<T, N>,
        selection: &Selection<K, N>,
        jacobian: &SMatrix<T, M, K>,
        innovation: &SVector<T, M>,
        variances: &SVector<T, M>,
        gate: T,
    ) -> Correction<T> {
        // H P, of three columns at once, since each number of H then serves three.
        let mut rows = SMatrix::<T, M, N>::zeros();
        for n in 0..N % 3 {
            for k in 0..K {
                let covariance = self.elements[(n, selection.indices[k].min(N - 1))];
                for m in 0..M {
                    rows[(m, n)] += jacobian[(m, k)] * covariance;
                }
            }
        }
        for block in 0..N / 3 {
            let first = N % 3 + 3 * block;
            let mut sums = SMatrix::<T, M, 3>::zeros();
            for k in 0..K {
                let column = selection.indices[k].min(N - 1);
                #[unroll(3)]
                for n in 0..3 {
                    let covariance = self.elements[(first + n, column)];
                    #[unroll(8)]
                    for m in 0..M {
                        sums[(m, n)] += jacobian[(m, k)] * covariance;
                    }
                }
            }
            #[unroll(3)]
            for n in 0..3 {
                #[unroll(8)]
                for m in 0..M {
                    rows[(m, first + n)] = sums[(m, n)];
                }
            }
        }
        // S below its diagonal and on it, row m from m (m + 1) / 2 on.
        let mut factor = [T::ZERO; 36];
        for k in 0..K {
            let column = selection.indices[k].min(N - 1);
            #[unroll(8)]
            for m in 0..M {
                #[unroll(8)]
                for before in 0..m + 1 {
                    factor[m * (m + 1) / 2 + before] += jacobian[(m, k)] * rows[(before, column)];
                }
            }
        }

        // L in the place of S, except for its diagonal, of which `scales` has the reciprocals.
        let mut scales = *innovation;
        let mut scaled = *innovation;
        let mut surprise = T::ZERO;
        #[unroll(8)]
        for m in 0..M {
            let mut square = factor[m * (m + 1) / 2 + m] + variances[m];
            let mut rest = innovation[m];
            #[unroll(8)]
            for before in 0..m {
                let mut sum = factor[m * (m + 1) / 2 + before];
                #[unroll(8)]
                for k in 0..before {
                    sum -= factor[before * (before + 1) / 2 + k] * factor[m * (m + 1) / 2 + k];
                }
                sum *= scales[before];
                factor[m * (m + 1) / 2 + before] = sum;
                square -= sum * sum;
                rest -= sum * scaled[before];
            }
            if !(square > T::ZERO) {
                return Correction { surprise: T::ZERO, status: Status::Lost };
            }
            // The square is positive; `abs` lets compilers omit the case of a negative one.
            scales[m] = T::ONE / square.abs().sqrt();
            scaled[m] = rest * scales[m];
            surprise += scaled[m] * scaled[m];
        }
        if !(surprise <= gate) {
            return Correction { surprise, status: Status::Rejected };
        }

        let mut after = *state;
        for n in 0..N {
            let mut variance = self.elements[(n, n)];
            #[unroll(8)]
            for m in 0..M {
                let mut sum = rows[(m, n)];
                #[unroll(8)]
                for k in 0..m {
                    sum -= factor[m * (m + 1) / 2 + k] * rows[(k, n)];
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
        self.lose::<M, 0, 0>(&rows);
        for n in 0..N {
            #[unroll(8)]
            for m in 0..M {
                state[n] += rows[(m, n)] * scaled[m];
            }
            self.elements[(n, n)] = after[n];
        }
        Correction { surprise, status: Status::Corrected }
    }

    /// Subtracts the elements of Yᵀ Y beside its diagonal from the covariance, except for the rows and columns of the
    /// `COUNT` elements from `FIRST` on.
    ///
    /// Three rows at once, since each number of Y then serves three. Both triangles have the same products in the same
    /// order.
    #[inline]
    pub(crate) fn lose<const M: usize, const FIRST: usize, const COUNT: usize>(
        &mut self,
        rows: &SMatrix<T, M, N>,
    ) {
        // The first column, if the first ones are left out.
        let start = if FIRST == 0 { COUNT } else { 0 };
        // Rows that are no multiple of three, above and below the elements that are left out.
        for at in 0..FIRST % 3 + (N - FIRST - COUNT) % 3 {
            let row = if (N - FIRST - COUNT) % 3 < 1 || FIRST % 3 >= 1 && at < FIRST % 3 {
                at
            } else {
                FIRST + COUNT + (at - FIRST % 3)
            };
            for col in start..row {
                if FIRST > 0 && col >= FIRST && col < FIRST + COUNT {
                    continue;
                }
                let mut value = self.elements[(row, col)];
                #[unroll(8)]
                for m in 0..M {
                    value -= rows[(m, row)] * rows[(m, col)];
                }
                self.elements[(row, col)] = value;
                self.elements[(col, row)] = value;
            }
        }
        for block in 0..FIRST / 3 + (N - FIRST - COUNT) / 3 {
            let row = if N - FIRST - COUNT < 3 || FIRST >= 3 && block < FIRST / 3 {
                FIRST % 3 + 3 * block
            } else {
                FIRST + COUNT + (N - FIRST - COUNT) % 3 + 3 * (block - FIRST / 3)
            };
            for col in start..row {
                if FIRST > 0 && col >= FIRST && col < FIRST + COUNT {
                    continue;
                }
                let mut one = self.elements[(row, col)];
                let mut two = self.elements[(row + 1, col)];
                let mut three = self.elements[(row + 2, col)];
                #[unroll(8)]
                for m in 0..M {
                    one -= rows[(m, row)] * rows[(m, col)];
                    two -= rows[(m, row + 1)] * rows[(m, col)];
                    three -= rows[(m, row + 2)] * rows[(m, col)];
                }
                self.elements[(row, col)] = one;
                self.elements[(row + 1, col)] = two;
                self.elements[(row + 2, col)] = three;
                self.elements[(col, row)] = one;
                self.elements[(col, row + 1)] = two;
                self.elements[(col, row + 2)] = three;
            }
            // The three rows with each other.
            let mut one = self.elements[(row + 1, row)];
            let mut two = self.elements[(row + 2, row)];
            let mut three = self.elements[(row + 2, row + 1)];
            #[unroll(8)]
            for m in 0..M {
                one -= rows[(m, row + 1)] * rows[(m, row)];
                two -= rows[(m, row + 2)] * rows[(m, row)];
                three -= rows[(m, row + 2)] * rows[(m, row + 1)];
            }
            self.elements[(row + 1, row)] = one;
            self.elements[(row, row + 1)] = one;
            self.elements[(row + 2, row)] = two;
            self.elements[(row, row + 2)] = two;
            self.elements[(row + 2, row + 1)] = three;
            self.elements[(row + 1, row + 2)] = three;
        }
    }
}
