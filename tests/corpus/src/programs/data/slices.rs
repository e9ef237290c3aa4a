//! A function takes any number of elements as `&[T]`: in the C, their address and their number. Within a function, a
//! part of an array is the array itself; an index is checked against the part's length.

use bessemer::prelude::*;

/// The mean of some values; 0 if there are none.
#[function]
pub fn mean(values: &[f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let mut sum = 0.0;
    for value in values {
        sum += value;
    }
    sum / values.len() as f64
}

/// Subtracts the mean from some values.
#[function]
pub fn centre(values: &mut [f64]) {
    let mean = mean(values);
    for value in values.iter_mut() {
        *value -= mean;
    }
}

/// Difference of the means of the later and the earlier half of eight values.
#[function]
pub fn trend(values: &[f64; 8]) -> f64 {
    mean(&values[4..]) - mean(&values[..4])
}

/// The sum of four values from `from` on, minus their mean; a fault if there are fewer.
#[function]
pub fn window(values: &[f64; 8], from: usize) -> f64 {
    let mut part = [0.0; 4];
    part.copy_from_slice(&values[from..from + 4]);
    centre(&mut part);
    part[0].abs().max(part[3].abs())
}

/// The largest of the values before `end`.
#[function]
pub fn peak(values: &List<f64, 6>, end: usize) -> Option<f64> {
    let part = &values[..end];
    let mut peak = *part.first()?;
    for value in &part[1..] {
        peak = peak.max(*value);
    }
    Some(peak)
}
