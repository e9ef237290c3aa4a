//! Fits the thrust coefficients to a flight, and estimates their uncertainty.
//!
//! The minimum is found by the method of Nelder and Mead in the crate `argmin`, which needs no derivatives. The
//! confidence intervals are computed from the curvature at the minimum; errors within a segment may be correlated,
//! those of different segments are not (a clustered sandwich estimate).
//!
//! For quadcopters: there is a coefficient for each of four motors.

use super::segments::Segments;
use argmin::core::{CostFunction, Error, Executor, State as _};
use argmin::solver::neldermead::NelderMead;
use nalgebra::{Matrix4, Vector4};
use std::cell::Cell;

/// Result of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Fitted coefficients.
    pub coefficients: Vec<f64>,
    /// Half the width of the 95 % confidence interval of each coefficient.
    pub confidence: Vec<f64>,
    /// Cost at the minimum.
    pub cost: f64,
    /// The best cost after each iteration.
    pub history: Vec<f64>,
    /// Number of evaluations of the cost.
    pub evaluations: u64,
}

/// The fit in terms of coefficients relative to the data sheet's: numbers near 1, so that all steps are of similar
/// size.
struct Problem<'a> {
    segments: &'a Segments<'a>,
    sheet: &'a [f64],
    /// Number of evaluations of the cost.
    evaluations: &'a Cell<u64>,
}

impl Problem<'_> {
    fn coefficients(&self, relative: &[f64]) -> Vec<f64> {
        relative.iter().zip(self.sheet).map(|(r, sheet)| r * sheet).collect()
    }
}

impl CostFunction for Problem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, relative: &Self::Param) -> Result<f64, Error> {
        self.evaluations.set(self.evaluations.get() + 1);
        let cost = self.segments.cost(&self.coefficients(relative));
        Ok(if cost.is_finite() { cost } else { f64::MAX })
    }
}

/// Fits a coefficient for each motor, starting from the data sheet's; calls `told` after each iteration.
///
/// # Errors
///
/// The message of the optimiser.
pub fn fit(
    segments: &Segments<'_>,
    sheet: &[f64; 4],
    mut told: impl FnMut(u64, f64),
) -> Result<Fit, Error> {
    let count = sheet.len();
    let corner = |moved: Option<usize>| {
        (0..count).map(|n| if moved == Some(n) { 1.1 } else { 1.0 }).collect::<Vec<f64>>()
    };
    let corners = std::iter::once(None).chain((0..count).map(Some)).map(corner).collect();
    let mut history = Vec::new();
    let evaluations = Cell::new(0);
    let mut simplex: Vec<Vec<f64>> = corners;
    let mut best = (f64::INFINITY, vec![1.0; count]);
    // Twice: a simplex that has collapsed in one direction is opened again where it ended.
    for size in [1e-2, 1e-3] {
        let problem = Problem { segments, sheet, evaluations: &evaluations };
        let solver = NelderMead::new(std::mem::take(&mut simplex)).with_sd_tolerance(1e-13)?;
        let outcome =
            Executor::new(problem, solver).configure(|state| state.max_iters(150)).run()?;
        let state = outcome.state();
        let place = state.get_best_param().cloned().unwrap_or_else(|| best.1.clone());
        if state.get_best_cost() < best.0 {
            best = (state.get_best_cost(), place);
        }
        history.push(best.0);
        told(state.get_iter(), best.0);
        simplex = std::iter::once(best.1.clone())
            .chain((0..count).map(|n| {
                let mut moved = best.1.clone();
                moved[n] += size;
                moved
            }))
            .collect();
    }
    let problem = Problem { segments, sheet, evaluations: &evaluations };
    let coefficients = problem.coefficients(&best.1);
    let confidence = confidence(&problem, &best.1);
    Ok(Fit { coefficients, confidence, cost: best.0, history, evaluations: evaluations.get() })
}

/// Half the widths of the 95 % confidence intervals at a minimum.
fn confidence(problem: &Problem<'_>, relative: &[f64]) -> Vec<f64> {
    let count = relative.len();
    let at = |place: &[f64]| problem.segments.residuals(&problem.coefficients(place));
    let here = at(relative);
    let step = 1e-5;
    let slopes: Vec<Vec<_>> = (0..count)
        .map(|n| {
            let mut moved = relative.to_vec();
            moved[n] += step;
            at(&moved).iter().zip(&here).map(|(there, here)| (there - here) / step).collect()
        })
        .collect();
    let mut curvature = Matrix4::zeros();
    let mut spread = Matrix4::zeros();
    for segment in 0..here.len() {
        let slope = |n: usize| &slopes[n][segment];
        let pull = Vector4::from_fn(|n, _| slope(n).dot(&here[segment]));
        curvature += Matrix4::from_fn(|i, j| slope(i).dot(slope(j)));
        spread += pull * pull.transpose();
    }
    let Some(inverse) = curvature.try_inverse() else { return vec![f64::INFINITY; count] };
    let covariance = inverse * spread * inverse;
    (0..count).map(|n| 1.96 * covariance[(n, n)].max(0.0).sqrt() * problem.sheet[n]).collect()
}
