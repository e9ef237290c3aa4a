//! `insert`, `get_or_insert` and `as_mut` return a reference to an `Option`'s content: in the C, the place of the
//! content. `mem::take` leaves the default.

use bessemer::prelude::*;

/// A filter that starts at its first input.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Smooth {
    /// Present value.
    pub state: Option<f64>,
}

#[data]
impl Smooth {
    /// Takes an input and returns the smoothed value.
    pub fn update(&mut self, input: f64) -> f64 {
        let state = self.state.get_or_insert(input);
        *state += 0.25 * (input - *state);
        *state
    }

    /// Restarts at an input.
    pub fn restart(&mut self, input: f64) -> f64 {
        *self.state.insert(input) + 1.0
    }
}

/// Increments the counter, if there is one.
#[function]
pub fn count(counter: &mut Option<u8>) -> bool {
    if let Some(count) = counter.as_mut() {
        *count += 1;
        return true;
    }
    false
}

/// The duration of a pulse, which begins with the first high sample.
#[function]
pub fn pulse(start: &mut Option<u32>, now: u32, high: bool) -> u32 {
    if !high {
        return core::mem::take(start).map_or(0, |start| now.wrapping_sub(start));
    }
    now.wrapping_sub(*start.get_or_insert_with(|| now))
}

/// The reading of the one sensor that responds, if the other does not.
#[function]
pub fn only(left: Option<f32>, right: Option<f32>) -> Option<f32> {
    left.xor(right)
}
