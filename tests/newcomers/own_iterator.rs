//! An iterator of one's own.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Countdown {
    pub left: u32,
}

#[data]
impl Iterator for Countdown {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        if self.left == 0 {
            None
        } else {
            self.left -= 1;
            Some(self.left)
        }
    }
}

#[component]
#[derive(Default)]
pub struct OwnIterator {
    pub sum: u32,
}

#[component]
impl OwnIterator {
    #[entry]
    pub fn step(&mut self) -> u32 {
        let counter = Countdown { left: 3 };
        for x in counter {
            self.sum += x;
        }
        self.sum
    }
}
