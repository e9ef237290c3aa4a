//! Discrete LQR: iterates the Riccati equation to the optimal gain and runs the
//! state feedback with input limits.

use nalgebra::{SMatrix, SVector};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LqrError {
    /// `R + BᵀPB` lost positive definiteness (is `R` positive?).
    NotPositiveDefinite,
    /// Gain still moving after the allowed iterations.
    NotConverged { iterations: u32 },
}

/// The plant `x⁺ = A x + B u` and the quadratic cost.
#[derive(Clone, Debug)]
pub struct Problem<const N: usize, const M: usize> {
    pub a: SMatrix<f64, N, N>,
    pub b: SMatrix<f64, N, M>,
    pub q: SMatrix<f64, N, N>,
    pub r: SMatrix<f64, M, M>,
}

/// Gain and cost-to-go of the infinite-horizon problem.
#[derive(Clone, Debug)]
pub struct Solution<const N: usize, const M: usize> {
    pub k: SMatrix<f64, M, N>,
    pub p: SMatrix<f64, N, N>,
    pub iterations: u32,
}

impl<const N: usize, const M: usize> Problem<N, M> {
    pub const MAX_ITERATIONS: u32 = 2000;

    fn gain(&self, p: &SMatrix<f64, N, N>) -> Result<SMatrix<f64, M, N>, LqrError> {
        let bt_p = self.b.transpose() * p;
        let s = self.r + bt_p * self.b;
        s.cholesky()
            .map(|chol| chol.solve(&(bt_p * self.a)))
            .ok_or(LqrError::NotPositiveDefinite)
    }

    pub fn solve(&self, tolerance: f64) -> Result<Solution<N, M>, LqrError> {
        let mut p = self.q;
        let mut k = self.gain(&p)?;
        for iterations in 1..=Self::MAX_ITERATIONS {
            let closed = self.a - self.b * k;
            p = self.q + k.transpose() * self.r * k + closed.transpose() * p * closed;
            let next = self.gain(&p)?;
            let change = (next - k).abs().max();
            k = next;
            if change < tolerance {
                return Ok(Solution { k, p, iterations });
            }
        }
        Err(LqrError::NotConverged { iterations: Self::MAX_ITERATIONS })
    }
}

/// State feedback around a reference, with symmetric input limits.
#[derive(Clone, Debug)]
pub struct StateFeedback<const N: usize, const M: usize> {
    k: SMatrix<f64, M, N>,
    limit: SVector<f64, M>,
    saturated_steps: u32,
}

impl<const N: usize, const M: usize> StateFeedback<N, M> {
    pub fn new(solution: &Solution<N, M>, limit: SVector<f64, M>) -> Self {
        Self { k: solution.k, limit, saturated_steps: 0 }
    }

    pub fn step(&mut self, x: &SVector<f64, N>, reference: &SVector<f64, N>) -> SVector<f64, M> {
        let wanted = self.k * (reference - x);
        let u = wanted.zip_map(&self.limit, |u, lim| u.clamp(-lim, lim));
        if u != wanted {
            self.saturated_steps = self.saturated_steps.saturating_add(1);
        }
        u
    }

    pub fn saturated_steps(&self) -> u32 {
        self.saturated_steps
    }
}

/// A cart on rails, driven by force, as a double integrator.
pub fn cart(mass: f64, dt: f64) -> Problem<2, 1> {
    Problem {
        a: SMatrix::<f64, 2, 2>::new(1.0, dt, 0.0, 1.0),
        b: SMatrix::<f64, 2, 1>::new(0.5 * dt * dt / mass, dt / mass),
        q: SMatrix::<f64, 2, 2>::from_diagonal(&SVector::<f64, 2>::new(10.0, 1.0)),
        r: SMatrix::<f64, 1, 1>::new(0.1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gain_satisfies_riccati() {
        let problem = cart(2.0, 0.05);
        let sol = problem.solve(1e-10).unwrap();
        let Problem { a, b, q, r } = &problem;
        let again = q + a.transpose() * sol.p * a - a.transpose() * sol.p * b * sol.k;
        assert!((again - sol.p).norm() < 1e-4);
        assert!(r[0] > 0.0 && sol.k.iter().all(|&g| g > 0.0));
    }

    #[test]
    fn drives_the_cart_home() {
        let problem = cart(2.0, 0.05);
        let mut ctl = StateFeedback::new(&problem.solve(1e-9).unwrap(), SVector::<f64, 1>::new(5.0));
        let target = SVector::<f64, 2>::new(1.0, 0.0);
        let mut x = SVector::<f64, 2>::zeros();
        for _ in 0..400 {
            x = problem.a * x + problem.b * ctl.step(&x, &target);
        }
        assert!((x - target).norm() < 1e-3, "{x}");
        assert!(ctl.saturated_steps() > 0);
    }

    #[test]
    fn negative_input_cost_is_reported() {
        let bad = Problem { r: SMatrix::<f64, 1, 1>::new(-100.0), ..cart(1.0, 0.1) };
        assert_eq!(bad.solve(1e-6).unwrap_err(), LqrError::NotPositiveDefinite);
    }
}
