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
    /// Sets the number of sensors and times; a fault if the capacity is exceeded.
    #[entry]
    pub fn resize(&mut self, sensors: usize, times: usize) {
        self.values.resize(sensors, times, 0.0);
    }

    /// Stores a value; a fault if the sensor or time is out of range.
    #[entry]
    pub fn keep(&mut self, sensor: usize, time: usize, value: f64) {
        self.values[(sensor, time)] = value;
    }

    /// The products of the sensors with each other, summed over time.
    #[entry]
    pub fn products(&mut self) -> BoundedMatrix<f64, 4, 4> {
        self.values * self.values.transpose()
    }

    /// Limits the values up to the first negative one, and returns the largest.
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
