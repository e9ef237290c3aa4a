//! A function takes elements of any number as `&[T]`: in the C their address, and how many there are. Within a
//! function a part of an array is the array itself; an index into it is checked against the part.

use bessemer::prelude::*;

/// The mean of some values; 0 of none.
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

/// Makes the mean of some values zero.
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

/// The values from `from` on, four of them, without their mean: a fault where there are not so many.
#[function]
pub fn window(values: &[f64; 8], from: usize) -> f64 {
    let mut part = [0.0; 4];
    part.copy_from_slice(&values[from..from + 4]);
    centre(&mut part);
    part[0].abs().max(part[3].abs())
}

/// The largest of those before `end`.
#[function]
pub fn peak(values: &List<f64, 6>, end: usize) -> Option<f64> {
    let part = &values[..end];
    let mut peak = *part.first()?;
    for value in &part[1..] {
        peak = peak.max(*value);
    }
    Some(peak)
}
