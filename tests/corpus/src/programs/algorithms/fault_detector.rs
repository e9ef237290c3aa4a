//! Compares redundant sensors: the one farthest from the others is voted out.

use bessemer::prelude::*;

/// The median of three values.
#[function]
pub fn middle(values: &[f64; 3]) -> f64 {
    let [a, b, c] = *values;
    a.max(b).min(a.min(b).max(c))
}

/// The sensor farthest from the median, if it is off by more than `limit`.
#[function]
pub fn outlier(values: &[f64; 3], limit: f64) -> Option<usize> {
    let middle = middle(values);
    let worst = values.iter().map(|value| (value - middle).abs()).fold(0.0, f64::max);
    if worst <= limit {
        return None;
    }
    values.iter().position(|value| (value - middle).abs() >= worst)
}

/// The mean of the sensors that are not outliers.
#[function]
pub fn voted(values: &[f64; 3], limit: f64) -> f64 {
    let out = outlier(values, limit);
    let (mut sum, mut count) = (0.0, 0.0);
    for (i, value) in values.iter().enumerate() {
        if out == Some(i) {
            continue;
        }
        sum += value;
        count += 1.0;
    }
    sum / count
}
