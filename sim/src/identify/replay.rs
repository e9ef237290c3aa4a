//! The thesis' cost (eqs. (5.3)–(5.8)): the flight is replayed in open loop from its take-off, every output is scaled
//! by its range, and the difference of the flights' lengths is added.
//!
//! Implemented exactly as in the thesis, to show its properties: see docs/identification.md.

use super::logged::{Logged, State, motion, state};
use super::with_coefficients;
use models::{Airframe, Wrench};
use nalgebra::Vector3;

/// Range of heights in which a replay continues, m.
const HEIGHTS: (f64, f64) = (0.0, 10.0);

/// The weight of the lengths' difference (thesis, eq. (5.8)).
const TIME_WEIGHT: f64 = 3.0;

/// Simulates the flight with the logged motor speeds, from the first row in flight until the model leaves the range of
/// heights.
pub fn flown(logged: &Logged, airframe: &Airframe) -> Vec<State> {
    let (first, last) = logged.airborne;
    let effect = airframe.effectiveness();
    let mut now = motion(&logged.states[first]);
    let mut states = Vec::with_capacity(last - first);
    for squares in &logged.squares[first..last] {
        let height = now.position.z;
        if !(HEIGHTS.0..=HEIGHTS.1).contains(&height) || !state(&now).iter().all(|v| v.is_finite())
        {
            break;
        }
        states.push(state(&now));
        let loads = effect * squares;
        let torque = Vector3::new(loads[1], loads[2], loads[3]);
        now = now.after(airframe, &Wrench { thrust: loads[0], torque }, logged.period);
    }
    states
}

/// The cost of coefficients: one for each motor, or one for all.
pub fn cost(logged: &Logged, airframe: &Airframe, coefficients: &[f64]) -> f64 {
    let (first, last) = logged.airborne;
    let model = flown(logged, &with_coefficients(airframe, coefficients));
    if model.is_empty() {
        return f64::INFINITY;
    }
    let real = &logged.states[first..first + model.len()];
    let missing = (last - first - model.len()) as f64 * logged.period;
    output_cost(&model, real) + TIME_WEIGHT * missing
}

/// Mean difference of the outputs, each scaled by its own range (thesis, eqs. (5.3)–(5.6)). A flat output
/// has no range: it counts as 0, where the thesis' formula gives 0/0.
fn output_cost(model: &[State], real: &[State]) -> f64 {
    let mut sum = 0.0;
    for output in 0..12 {
        let (own, other) = (scale(model, output), scale(real, output));
        let pairs = model.iter().zip(real);
        sum += pairs.map(|(a, b)| (own(a[output]) - other(b[output])).abs()).sum::<f64>();
    }
    sum / (12 * model.len()) as f64
}

/// (s − min)/(max − min) of one output of a flight.
fn scale(states: &[State], output: usize) -> impl Fn(f64) -> f64 + use<> {
    let (low, high) = states
        .iter()
        .map(|state| state[output])
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    move |value| if high > low { (value - low) / (high - low) } else { 0.0 }
}
