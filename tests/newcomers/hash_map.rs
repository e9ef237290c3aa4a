//! Values by their keys.
use bessemer::prelude::*;
use std::collections::HashMap;

#[component]
#[derive(Default)]
pub struct Mapping {
    pub values: HashMap<u16, f64>,
}

#[component]
impl Mapping {
    #[entry]
    pub fn step(&mut self, key: u16, value: f64) -> usize {
        self.values.insert(key, value);
        self.values.len()
    }
}
