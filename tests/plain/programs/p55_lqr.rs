//! Discrete-time LQR design by a fixed number of Riccati iterations, so that
//! gains can be recomputed on the target with a known run time.

use nalgebra::{RealField, SMatrix, SVector};

/// x[k+1] = A x[k] + B u[k]
#[derive(Debug, Clone, PartialEq)]
pub struct LinearSystem<T, const N: usize, const M: usize> {
    pub a: SMatrix<T, N, N>,
    pub b: SMatrix<T, N, M>,
}

/// Quadratic weights of states and inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Weights<T, const N: usize, const M: usize> {
    pub q: SMatrix<T, N, N>,
    pub r: SMatrix<T, M, M>,
}

impl<T: RealField + Copy, const N: usize, const M: usize> Weights<T, N, M> {
    pub fn diagonal(q: [T; N], r: [T; M]) -> Self {
        Self {
            q: SMatrix::from_diagonal(&SVector::from(q)),
            r: SMatrix::from_diagonal(&SVector::from(r)),
        }
    }
}

/// The input weight was not positive definite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct IllConditioned;

#[derive(Debug, Clone, PartialEq)]
pub struct Lqr<T, const N: usize, const M: usize> {
    gain: SMatrix<T, M, N>,
    cost: SMatrix<T, N, N>,
    /// Largest change of the cost matrix in the last iteration.
    residual: T,
}

impl<T: RealField + Copy, const N: usize, const M: usize> Lqr<T, N, M> {
    pub fn design(
        system: &LinearSystem<T, N, M>,
        weights: &Weights<T, N, M>,
        iterations: usize,
    ) -> Result<Self, IllConditioned> {
        let start = Self {
            gain: SMatrix::zeros(),
            cost: weights.q,
            residual: T::max_value().unwrap_or_else(T::one),
        };
        (0..iterations).try_fold(start, |lqr, _| lqr.refine(system, weights))
    }

    /// One backward step of the Riccati recursion.
    fn refine(
        self,
        LinearSystem { a, b }: &LinearSystem<T, N, M>,
        Weights { q, r }: &Weights<T, N, M>,
    ) -> Result<Self, IllConditioned> {
        let bt_p = b.transpose() * self.cost;
        let gain = (r + bt_p * b).cholesky().ok_or(IllConditioned)?.solve(&(bt_p * a));

        let next = a.transpose() * self.cost * (a - b * gain) + q;
        // Rounding slowly breaks the symmetry; restore it every time.
        let cost = (next + next.transpose()) * nalgebra::convert::<f64, T>(0.5);
        let residual = (cost - self.cost).amax();
        Ok(Self { gain, cost, residual })
    }

    pub fn gain(&self) -> &SMatrix<T, M, N> {
        &self.gain
    }

    pub fn residual(&self) -> T {
        self.residual
    }

    pub fn control(&self, state: &SVector<T, N>, target: &SVector<T, N>) -> SVector<T, M> {
        self.gain * (target - state)
    }

    /// Predicted cost-to-go from the given state.
    pub fn cost_to_go(&self, state: &SVector<T, N>) -> T {
        state.dot(&(self.cost * state))
    }
}

/// Cart on a rail: position and velocity driven by an acceleration.
pub fn double_integrator<T: RealField + Copy>(dt: T) -> LinearSystem<T, 2, 1> {
    let half: T = nalgebra::convert(0.5);
    LinearSystem {
        a: SMatrix::<T, 2, 2>::new(T::one(), dt, T::zero(), T::one()),
        b: SMatrix::<T, 2, 1>::new(half * dt * dt, dt),
    }
}
