//! Equal names of items in several modules.

use bessemer::prelude::*;

pub mod left;
pub mod right;

use left::Reading;

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clash {
    pub left: left::Reading,
    pub right: right::Reading,
    pub mode: right::Mode,
}

#[component]
impl Clash {
    #[entry]
    pub fn step(&mut self, a: i32) -> i32 {
        self.left = Reading { value: left::scale(a) };
        self.right = right::Reading { value: right::scale(a) };
        self.mode = if self.left.value() > self.right.value() {
            right::Mode::High
        } else {
            right::Mode::Low
        };
        let mode = if a > 0 { left::Mode::High } else { left::Mode::Low };
        let extra = match mode {
            left::Mode::High => left::LIMIT,
            left::Mode::Low => right::LIMIT,
        };
        self.left.value()
            + self.right.value()
            + extra
            + left::clash_step(a)
            + right::reading_value(a)
    }
}
