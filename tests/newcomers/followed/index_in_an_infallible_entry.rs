//! A table that cannot fail.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct IndexInAnInfallibleEntry {
    pub last: f64,
}

#[component]
impl IndexInAnInfallibleEntry {
    #[entry(infallible)]
    pub fn step(&mut self, table: &[f64; 8], index: usize) -> f64 {
        self.last = if index < table.len() { table[index] } else { 0.0 };
        self.last
    }
}
