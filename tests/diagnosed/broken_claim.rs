//! A case.
#![no_std]
use bessemer::prelude::*;

/// A table.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Its values.
    pub values: [f64; 4],
}

#[component]
impl Table {
    /// Claims too much: the index may be 4, and the sum may overflow.
    #[entry(infallible)]
    pub fn look_up(&self, index: usize, offset: usize) -> f64 {
        self.values[index + offset]
    }
}
