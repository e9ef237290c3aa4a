//! A `BoundedMatrix` has a maximum size; it stores its current size, and loops cover that size.

use bessemer::prelude::*;

/// Measurements of up to four sensors at up to three times.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measured {
    values: BoundedMatrix<f64, 4, 3>,
}

#[component]
impl Measured {
    /// As many sensors and times as there are now; a fault if there is no room.
    #[entry]
    pub fn resize(&mut self, sensors: usize, times: usize) {
        self.values.resize(sensors, times, 0.0);
    }

    /// Keeps a value; a fault if there is no such sensor or time.
    #[entry]
    pub fn keep(&mut self, sensor: usize, time: usize, value: f64) {
        self.values[(sensor, time)] = value;
    }

    /// The products of the sensors with each other, summed over time.
    #[entry]
    pub fn products(&mut self) -> BoundedMatrix<f64, 4, 4> {
        self.values * self.values.transpose()
    }

    /// The largest of all, each limited first; a negative one ends the limiting.
    #[entry]
    pub fn limited(&mut self, most: f64) -> f64 {
        for value in self.values.iter_mut() {
            if *value < 0.0 {
                break;
            }
            *value = value.min(most);
        }
        self.values.iter().fold(0.0, |largest, value| largest.max(*value))
    }
}
