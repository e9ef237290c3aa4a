//! `unwrap` and `expect` of `None` or `Err` are faults.

use bessemer::prelude::*;

/// Stores the last value.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Absent {
    last: Option<f64>,
}

#[component]
impl Absent {
    /// Returns the previous value and stores the next one; a fault if there is none.
    #[entry]
    pub fn delayed(&mut self, next: Option<f64>) -> f64 {
        let before = self.last;
        self.last = next;
        before.unwrap()
    }

    /// Returns the stored value once.
    #[entry]
    pub fn taken(&mut self) -> f64 {
        self.last.take().expect("a value must be there")
    }
}
