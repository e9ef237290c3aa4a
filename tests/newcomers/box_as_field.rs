//! A large table, boxed as it is in programs.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BoxField {
    pub table: Box<[f64; 4]>,
}

#[component]
impl BoxField {
    #[entry]
    pub fn step(&mut self, index: usize) -> f64 {
        self.table[index % 4]
    }
}
