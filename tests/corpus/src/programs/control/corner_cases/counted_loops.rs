//! Counters that only increase, in loops with few iterations, cannot overflow: their checks are removed as far as
//! possible.

use bessemer::prelude::*;

/// Counts of samples by different criteria.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counter {
    samples: [[i16; 6]; 4],
}

#[component]
impl Counter {
    /// Stores a sample; a row or column out of range is a fault.
    #[entry]
    pub fn keep(&mut self, row: usize, column: usize, value: i16) {
        self.samples[row][column] = value;
    }

    /// Number of positive samples; and, in a narrow type, twice the number of negative ones.
    #[entry(infallible)]
    pub fn signs(&mut self) -> (usize, i8) {
        let positive = self.samples[1].iter().filter(|sample| **sample > 0).count();
        let mut negative = 0i8;
        for row in &self.samples {
            for sample in row {
                if *sample < 0 {
                    negative += 2;
                } else if *sample > 100 {
                    break;
                }
            }
            negative += 1;
        }
        (positive, negative)
    }

    /// Counts every third of up to nine elements.
    #[entry(infallible)]
    pub fn every_third(&mut self, among: &List<u8, 9>) -> usize {
        let mut count = 0;
        for (i, byte) in among.iter().enumerate() {
            if i % 3 == 0 && *byte != 0 {
                count += 1;
            }
        }
        count
    }
}

/// A counter that overflows its type: a fault at that iteration and not before.
#[function]
pub fn too_many(times: u8, from: u8) -> u8 {
    let mut count = from;
    for _ in 0..times {
        count += 3;
    }
    count
}

/// A counter that exceeds its type by one.
#[function]
pub fn just_too_many(flags: &[bool; 16]) -> i8 {
    let mut count = 0i8;
    for flag in flags {
        for other in flags {
            if *flag && *other {
                count += 1;
            }
        }
    }
    count
}

/// A counter that also decreases.
#[function]
pub fn both_ways(flags: &[bool; 8]) -> u8 {
    let mut level = 0u8;
    for flag in flags {
        if *flag {
            level += 1;
        } else {
            level -= 1;
        }
    }
    level
}

/// A counter that is assigned inside the loop.
#[function]
pub fn set_between(flags: &[bool; 8], to: u8) -> u8 {
    let mut level = 0u8;
    for flag in flags {
        if *flag {
            level += 1;
        } else {
            level = to;
        }
    }
    level
}

/// The bound of an inner loop depends on a variable that the outer one changes.
#[function]
pub fn growing(start: u8) -> u8 {
    let (mut count, mut end) = (0u8, start % 40);
    for _ in 0..4 {
        for _ in 0..end {
            count += 1;
        }
        end = end.wrapping_mul(3);
    }
    count
}
