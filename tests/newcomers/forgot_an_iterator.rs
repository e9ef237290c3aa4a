//! An own iterator without an attribute.
use bessemer::prelude::*;

#[data]
pub struct Countdown {
    pub left: u8,
}

impl Iterator for Countdown {
    type Item = u8;
    fn next(&mut self) -> Option<u8> {
        self.left = self.left.checked_sub(1)?;
        Some(self.left)
    }
}

#[component]
#[derive(Default)]
pub struct ForgotAnIterator {
    pub last: f64,
}

#[component]
impl ForgotAnIterator {
    #[entry]
    pub fn step(&mut self, n: u8) -> f64 {
        #[bound(256)]
        for left in (Countdown { left: n }) {
            self.last += f64::from(left);
        }
        self.last
    }
}
