//! The type of an array includes its length. Arrays are copied as values; in the C that is a `memcpy`, or nothing if
//! the copy is not used further.

use bessemer::prelude::*;

/// The last four values, newest first.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recent {
    values: [i32; 4],
}

#[component]
impl Recent {
    /// Adds a value and returns the four before it.
    #[entry(infallible)]
    pub fn push(&mut self, value: i32) -> [i32; 4] {
        let before = self.values;
        self.values[0] = value;
        for i in 1..4 {
            self.values[i] = before[i - 1];
        }
        before
    }
}
