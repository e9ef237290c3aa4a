//! An iterator of one's own, of which nothing says how often it gives something.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Debug)]
pub struct Halves {
    pub left: u32,
}

#[data]
impl Iterator for Halves {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.left /= 2;
        (self.left > 0).then_some(self.left)
    }
}

#[component]
#[derive(Default)]
pub struct IteratorWithoutEnd {
    pub sum: u32,
}

#[component]
impl IteratorWithoutEnd {
    #[entry]
    pub fn step(&mut self, x: u32) -> u32 {
        for half in (Halves { left: x }) {
            self.sum = self.sum.wrapping_add(half);
        }
        let most = Halves { left: x }.max().unwrap_or(0);
        self.sum.max(most)
    }
}
