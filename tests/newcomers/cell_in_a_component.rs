//! State that a `&self` method changes.
use bessemer::prelude::*;
use core::cell::Cell;

#[component]
#[derive(Default)]
pub struct CellState {
    pub last: Cell<f64>,
}

#[component]
impl CellState {
    #[entry]
    pub fn step(&self, x: f64) -> f64 {
        self.last.set(x);
        self.last.get()
    }
}
