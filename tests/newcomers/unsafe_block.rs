//! An access without its check.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UnsafeBlock {
    pub last: f64,
}

#[component]
impl UnsafeBlock {
    #[entry]
    pub fn step(&mut self, table: &[f64; 8], index: usize) -> f64 {
        self.last = unsafe { *table.get_unchecked(index) };
        self.last
    }
}
