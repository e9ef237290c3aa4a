//! Arrays have their length in the type. They are copied as values; in the C that is a `memcpy`, or nothing
//! where the copy dies at once.

use bessemer::prelude::*;

/// The last four values, newest first.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recent {
    values: [i32; 4],
}

#[component]
impl Recent {
    /// Takes a value in, gives those before it.
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
