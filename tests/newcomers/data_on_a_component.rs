//! `#[data]` on what has an entry.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct DataComponent {
    pub last: f64,
}

#[data]
impl DataComponent {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
