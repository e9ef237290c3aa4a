//! Rainflow counting (ASTM E 1049, three points): how often a part was bent how far.

use bessemer::prelude::*;

/// Turning points of a load, and the cycles that they closed.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rainflow {
    turns: List<f32, 16>,
    /// Cycles by range, in halves: a class is 10 % of the largest.
    classes: [u32; 10],
}

#[component]
impl Rainflow {
    /// Takes a load into account, as a share of the largest; how many cycles it closed.
    #[entry]
    pub fn count(&mut self, load: f32) -> u8 {
        if !(0.0..=1.0).contains(&load) {
            return 0;
        }
        let n = self.turns.len();
        if n >= 2 {
            let (before, last) = (self.turns[n - 2], self.turns[n - 1]);
            // Only turning points stay.
            if (last - before) * (load - last) >= 0.0 {
                self.turns.pop();
            }
        }
        if self.turns.len() == self.turns.capacity() {
            self.turns.clear();
        }
        self.turns.push(load);

        let mut closed = 0;
        #[bound(8)]
        while self.turns.len() >= 3 {
            let n = self.turns.len();
            let x = (self.turns[n - 1] - self.turns[n - 2]).abs();
            let y = (self.turns[n - 2] - self.turns[n - 3]).abs();
            if x < y {
                break;
            }
            let class = ((y * 10.0) as usize).min(9);
            self.classes[class] += if n == 3 { 1 } else { 2 };
            let last = self.turns[n - 1];
            self.turns.truncate(n - 3);
            self.turns.push(last);
            closed += 1;
        }
        closed
    }
}
