//! A loop consumes what it runs over: an own iterator and an array, used again behind it.
#![no_std]
use bessemer::prelude::*;

/// Counts up.
#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Count {
    at: u32,
    end: u32,
}

#[data]
impl Iterator for Count {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        if self.at >= self.end {
            return None;
        }
        self.at += 1;
        Some(self.at)
    }
}

/// An iterator.
#[function]
pub fn counted(end: u32) -> u32 {
    let count = Count { at: 0, end };
    let mut sum = 0u32;
    for k in count {
        sum = sum.wrapping_add(k);
    }
    sum ^ count.at
}

/// An array whose elements are not `Copy`.
#[function]
pub fn listed(counts: [Count; 2]) -> u32 {
    let mut sum = 0u32;
    for count in counts {
        sum = sum.wrapping_add(count.end);
    }
    sum ^ counts[0].at
}
