//! A step of an integrator as a polynomial between its ends.
//!
//! With θ from 0 at the start to 1 at the end, and coefficients r0 … r4:
//!
//! ```text
//! y(θ) = r0 + θ (r1 + (1 − θ) (r2 + θ (r3 + (1 − θ) r4)))
//! ```
//!
//! Without r4 this is the cubic of Hermite, of order 3. With the r4 of Dormand and Prince it has order 4. Source: Hairer, Nørsett and
//! Wanner, *Solving Ordinary Differential Equations I*, 2nd edition, 1993, section II.6.

use crate::system::State;

/// The states within one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dense<const N: usize> {
    coefficients: [State<N>; 5],
}

impl<const N: usize> Dense<N> {
    /// Creates the polynomial with states and derivatives of both ends, a step in s, and the coefficient r4.
    pub(crate) fn new(
        [start, end]: [State<N>; 2],
        [first, last]: [State<N>; 2],
        step: f64,
        fourth: State<N>,
    ) -> Self {
        let change = end - start;
        let second = first * step - change;
        Self { coefficients: [start, change, second, change - last * step - second, fourth] }
    }

    /// Returns the state at θ from 0 to 1.
    pub(crate) fn at(&self, theta: f64) -> State<N> {
        let [r0, r1, r2, r3, r4] = self.coefficients;
        let back = 1.0 - theta;
        r0 + (r1 + (r2 + (r3 + r4 * back) * theta) * back) * theta
    }
}
