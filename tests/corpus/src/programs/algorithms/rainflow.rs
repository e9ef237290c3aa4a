//! Rainflow counting (ASTM E 1049, three points): the number of load cycles for each range of load.

use bessemer::prelude::*;

/// Turning points of the load, and the number of closed cycles.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rainflow {
    turns: List<f32, 16>,
    /// Number of half cycles in each class; a class is 10 % of the largest range.
    classes: [u32; 10],
}

#[component]
impl Rainflow {
    /// Takes a load as a fraction of the largest; returns the number of cycles that it closes.
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
