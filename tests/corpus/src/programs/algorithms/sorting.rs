//! Insertion sort, binary search and a trimmed mean, on slices.

use bessemer::prelude::*;

/// Sorts values in ascending order, by insertion.
#[function]
pub fn sort(values: &mut [f64]) {
    for end in 1..values.len() {
        for at in (1..=end).rev() {
            if values[at - 1] <= values[at] {
                break;
            }
            values.swap(at - 1, at);
        }
    }
}

/// Index at which a value could be inserted into sorted values.
#[function]
pub fn insertion_point(sorted: &[f64], value: f64) -> usize {
    let (mut low, mut high) = (0, sorted.len());
    #[bound(64)]
    while low < high {
        let middle = low + (high - low) / 2;
        if sorted[middle] < value {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}

/// The mean of nine readings without the two lowest and the two highest.
#[function]
pub fn trimmed_mean(readings: &[f64; 9]) -> f64 {
    let mut sorted = *readings;
    sort(&mut sorted);
    sorted[2..7].iter().sum::<f64>() / 5.0
}

/// Index of the class that a value falls into.
#[function]
pub fn class_of(limits: &List<f64, 6>, value: f64) -> usize {
    insertion_point(limits, value)
}
