//! A Savitzky-Golay filter of five points: the slope of a signal.

use bessemer::prelude::*;

/// Weights of five samples for the slope of their parabola.
static WEIGHTS: [f64; 5] = [-0.2, -0.1, 0.0, 0.1, 0.2];

/// Slopes per `period` at the points with two neighbours on each side.
#[function]
pub fn slopes(samples: &[f64; 12], period: f64) -> List<f64, 8> {
    let mut slopes = List::new();
    for window in samples.windows(5) {
        slopes.push(window.iter().zip(&WEIGHTS).map(|(x, w)| x * w).sum::<f64>() / period);
    }
    slopes
}

/// Number of zero crossings of the signal.
#[function]
pub fn crossings(samples: &[f64; 12]) -> usize {
    samples.windows(2).filter(|pair| (pair[0] < 0.0) != (pair[1] < 0.0)).count()
}
