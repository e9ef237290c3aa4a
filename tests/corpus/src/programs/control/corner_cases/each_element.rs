//! Loops over the elements of arrays.

use bessemer::prelude::*;

/// A filter with tables.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Each {
    /// Coefficients of the filter.
    pub taps: [f64; 4],
    /// Rows of numbers.
    pub rows: [[i32; 3]; 2],
    /// A point.
    pub point: Vector3<f64>,
}

impl Default for Each {
    fn default() -> Self {
        Each {
            taps: [0.5, 0.25, -0.125, 0.0],
            rows: [[1, 2, 3], [4, -5, 6]],
            point: Vector3::new(1.0, 2.0, 3.0),
        }
    }
}

#[component]
impl Each {
    /// Iterates over all fields.
    #[entry]
    pub fn run(&mut self, gain: f64, row: usize, limit: i32) -> f64 {
        let weights = [gain, 2.0, 3.0];
        let mut sum = 0.0;
        for tap in &self.taps {
            sum += *tap * gain;
        }
        for (tap, weight) in self.taps.iter().zip(&weights) {
            sum += tap * weight;
        }
        for (i, &weight) in weights.iter().enumerate() {
            sum += weight * i as f64;
        }
        for tap in self.taps.iter_mut() {
            *tap *= 0.5;
        }
        // The copy does not change with the original.
        for tap in self.taps {
            self.taps[3] += tap;
            self.taps[1] = 0.0;
        }
        let mut at = row;
        'rows: for value in self.rows[at] {
            at = 0;
            for (i, (other, mut weight)) in self.rows[at].iter().zip(weights).enumerate() {
                if *other + value > limit {
                    continue 'rows;
                }
                weight *= f64::from_bits(weight.to_bits());
                sum += weight + i as f64;
            }
            sum += value as f64;
        }
        for axis in self.point.iter().rev() {
            sum = sum * 0.5 + axis;
        }
        for mut axis in [sum, gain] {
            axis += 1.0;
            self.point.x += axis;
        }
        sum
    }
}
