//! An equality that is derived first.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default, PartialEq)]
pub struct Corner {
    pub x: f64,
}

#[component]
#[derive(Default)]
pub struct DeriveAbove {
    pub corner: Corner,
}

#[component]
impl DeriveAbove {
    #[entry]
    pub fn step(&mut self, x: f64) -> bool {
        let other = Corner { x };
        self.corner == other
    }
}
