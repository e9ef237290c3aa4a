//! `unwrap` and `expect` of `None` or `Err` are faults.

use bessemer::prelude::*;

/// The last value that came.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Absent {
    last: Option<f64>,
}

#[component]
impl Absent {
    /// What came before, and keeps what comes.
    #[entry]
    pub fn delayed(&mut self, next: Option<f64>) -> f64 {
        let before = self.last;
        self.last = next;
        before.unwrap()
    }

    /// The same, once.
    #[entry]
    pub fn taken(&mut self) -> f64 {
        self.last.take().expect("a value must be there")
    }
}
