//! Discrete models of continuous ones: x' = A x + B u, y = C x + D u.
//!
//! Source: Van Loan, *Computing Integrals Involving the Matrix Exponential*, IEEE Transactions on Automatic Control 23
//! (3), 1978; Franklin, Powell and Workman, *Digital Control of Dynamic Systems*, 3rd edition, sections 4.3 and 6.1.

use nalgebra::SMatrix;

/// Terms of the series: enough for double precision at the largest norm that is left after scaling.
const TERMS: usize = 16;

/// Returns the discrete A and B for an input that is held in each period: exact at the samples.
///
/// `period` is in s, above 0.
pub fn zero_order_hold<const N: usize, const M: usize>(
    a: &SMatrix<f64, N, N>,
    b: &SMatrix<f64, N, M>,
    period: f64,
) -> (SMatrix<f64, N, N>, SMatrix<f64, N, M>) {
    let one = SMatrix::<f64, N, N>::identity();
    let size = a.abs().row_sum().max() * period;
    let doublings = if size > 0.25 { (size / 0.25).log2().ceil() as i32 } else { 0 };
    let step = period / 2_f64.powi(doublings);
    // The integral of the exponential, by its series; the exponential is 1 + A times it.
    let mut series = one;
    for k in (2..=TERMS).rev() {
        series = one + a * series * (step / k as f64);
    }
    let mut integral = series * step;
    let mut transition = one + a * integral;
    for _ in 0..doublings {
        integral += transition * integral;
        transition *= transition;
    }
    (transition, integral * b)
}

/// Continuous or discrete model of a system with one input and one output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateSpace<const N: usize> {
    /// Matrix of the state.
    pub a: SMatrix<f64, N, N>,
    /// Column of the input.
    pub b: SMatrix<f64, N, 1>,
    /// Row of the output.
    pub c: SMatrix<f64, 1, N>,
    /// Direct part of the output.
    pub d: f64,
}

impl<const N: usize> StateSpace<N> {
    /// Returns the discrete model by Tustin's rule, s = (2/h) (z − 1)/(z + 1); none if 2/h is a pole.
    ///
    /// `period` h is in s, above 0. With a frequency `prewarped` in rad/s, below π/h, the response there is exact.
    pub fn tustin(&self, period: f64, prewarped: Option<f64>) -> Option<StateSpace<N>> {
        let step = prewarped.map_or(period, |w| 2.0 * (w * period / 2.0).tan() / w);
        let one = SMatrix::<f64, N, N>::identity();
        let inverse = (one - self.a * (step / 2.0)).try_inverse()?;
        let b = inverse * self.b * step;
        let c = self.c * inverse;
        Some(StateSpace {
            a: inverse * (one + self.a * (step / 2.0)),
            b,
            c,
            d: self.d + (self.c * b)[(0, 0)] / 2.0,
        })
    }
}
