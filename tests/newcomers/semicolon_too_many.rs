//! The result thrown away.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SemicolonTooMany {
    pub last: f64,
}

#[component]
impl SemicolonTooMany {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last * 2.0;
    }
}
