//! A Hampel filter: replaces samples that are far from the median of their neighbours by that median.

use bessemer::prelude::*;

/// The median of some numbers.
#[function]
fn median<const N: usize>(mut values: [f64; N]) -> f64 {
    values.sort_unstable_by(|a, b| a.total_cmp(b));
    if N % 2 == 1 { values[N / 2] } else { 0.5 * (values[N / 2 - 1] + values[N / 2]) }
}

/// Replaces the outliers among the samples.
#[function]
pub fn hampel(values: &[f64; 12]) -> [f64; 12] {
    let mut result = *values;
    for (middle, window) in values.windows(5).enumerate() {
        let window = [window[0], window[1], window[2], window[3], window[4]];
        let centre = median(window);
        let spread = 1.4826 * median(window.map(|x| (x - centre).abs()));
        if (window[2] - centre).abs() > 3.0 * spread {
            result[middle + 2] = centre;
        }
    }
    result
}
