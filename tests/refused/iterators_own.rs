//! Iterators of one's own that a loop of the C could not go through.
use bessemer::prelude::*;

#[data]
#[derive(Clone)]
pub struct Countdown {
    pub left: u32,
}

#[data]
impl Iterator for Countdown {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.left = self.left.checked_sub(1)?;
        Some(self.left)
    }

    fn count(self) -> usize {
        self.left as usize
    }
}

fn main() {}
