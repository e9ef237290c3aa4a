//! A `List` has a fixed capacity, and stores its memory and its length.

use bessemer::prelude::*;

/// The values of the last periods.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lists {
    values: List<f64, 4>,
}

#[component]
impl Lists {
    /// Appends a value; a fault if the list is full.
    #[entry]
    pub fn keep(&mut self, value: f64) {
        self.values.push(value);
    }

    /// The mean of the values; `None` if there are none.
    #[entry(infallible)]
    pub fn mean(&mut self) -> Option<f64> {
        let mut sum = 0.0;
        for value in &self.values {
            sum += value;
        }
        if self.values.is_empty() { None } else { Some(sum / self.values.len() as f64) }
    }

    /// Removes and returns the last value.
    #[entry(infallible)]
    pub fn last(&mut self) -> Option<f64> {
        self.values.pop()
    }
}
