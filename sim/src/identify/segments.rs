//! A cost with one minimum near the truth: the flight in short segments, each restarted from the log.
//!
//! A replay of the whole flight loses the aircraft within seconds, whatever the coefficients; over a fifth
//! of a second it does not. Differences at the end of each segment are scaled by the real flight's
//! ranges, and a weak prior holds what the flight does not show near the data sheet.

use super::logged::{Logged, State, motion, state};
use super::with_coefficients;
use models::{Airframe, Wrench};
use nalgebra::Vector3;
use rayon::prelude::*;

/// Length of a segment, s.
const LENGTH: f64 = 0.2;

/// Standard deviation of the prior, as a fraction of the data sheet's coefficient.
const PRIOR: f64 = 0.3;

/// The mean square of a scaled difference that noise alone leaves: the weight of the prior against one.
const PRIOR_WEIGHT: f64 = 1e-4;

/// Smallest range by which an output is scaled, since a smaller one consists of noise. For position, angle, velocity
/// and rate; m, rad, m/s, rad/s.
const LEAST_RANGES: [f64; 4] = [0.1, 0.1, 0.3, 0.3];

/// The segments of a flight.
#[derive(Clone, Debug)]
pub struct Segments<'a> {
    logged: &'a Logged,
    airframe: &'a Airframe,
    steps: usize,
    starts: Vec<usize>,
    ranges: State,
}

impl<'a> Segments<'a> {
    /// Cuts the airborne part of a flight; `airframe` is the data sheet's.
    pub fn of(logged: &'a Logged, airframe: &'a Airframe) -> Self {
        let steps = (LENGTH / logged.period).round().max(1.0) as usize;
        let (first, last) = logged.airborne;
        let starts = (first..last.saturating_sub(steps)).step_by(steps).collect();
        let real = logged.ranges();
        let ranges = State::from_fn(|n, _| real[n].max(LEAST_RANGES[n / 3]));
        Self { logged, airframe, steps, starts, ranges }
    }

    /// Returns the number of segments.
    pub fn count(&self) -> usize {
        self.starts.len()
    }

    /// Simulates the model, restarted from the log at the beginning of each segment.
    pub fn flown(&self, coefficients: &[f64]) -> Vec<State> {
        let airframe = with_coefficients(self.airframe, coefficients);
        let effect = airframe.effectiveness();
        let mut states = Vec::new();
        for start in &self.starts {
            let mut now = motion(&self.logged.states[*start]);
            for squares in &self.logged.squares[*start..start + self.steps] {
                states.push(state(&now));
                let loads = effect * squares;
                let torque = Vector3::new(loads[1], loads[2], loads[3]);
                let wrench = Wrench { thrust: loads[0], torque };
                now = now.after(&airframe, &wrench, self.logged.period);
            }
        }
        states
    }

    /// Returns the scaled difference at the end of each segment.
    pub fn residuals(&self, coefficients: &[f64]) -> Vec<State> {
        let airframe = with_coefficients(self.airframe, coefficients);
        let effect = airframe.effectiveness();
        let difference = |start: &usize| {
            let mut now = motion(&self.logged.states[*start]);
            for squares in &self.logged.squares[*start..start + self.steps] {
                let loads = effect * squares;
                let torque = Vector3::new(loads[1], loads[2], loads[3]);
                now =
                    now.after(&airframe, &Wrench { thrust: loads[0], torque }, self.logged.period);
            }
            (state(&now) - self.logged.states[start + self.steps]).component_div(&self.ranges)
        };
        self.starts.par_iter().map(difference).collect()
    }

    /// Returns the sum of the squared deviations from the data sheet, in standard deviations of the prior.
    fn prior(&self, coefficients: &[f64]) -> f64 {
        let sheet = self.airframe.thrust_coefficients;
        let apart = |(n, c): (usize, &f64)| ((c / sheet[n] - 1.0) / PRIOR).powi(2);
        coefficients.iter().enumerate().map(apart).sum()
    }

    /// Returns the cost: the mean square of the differences, plus the prior.
    pub fn cost(&self, coefficients: &[f64]) -> f64 {
        let sum: f64 = self.residuals(coefficients).iter().map(State::norm_squared).sum();
        let scale = 12.0 * self.count().max(1) as f64;
        (sum + PRIOR_WEIGHT * self.prior(coefficients)) / scale
    }
}
