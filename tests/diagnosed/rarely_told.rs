//! Code that few authors write.
use core::cmp::Ordering;

use bessemer::prelude::*;

/// One of a few.
#[data]
#[derive(Clone, Copy, Debug)]
pub enum Command {
    /// So far.
    Move(i32),
    /// So much.
    Turn(i32),
    /// Nothing.
    Stop,
}

/// Equal to all, and in an order.
#[data]
#[derive(Clone, Copy, Debug, PartialOrd)]
pub struct Rank {
    /// The number.
    pub number: i32,
}

#[data]
impl PartialEq for Rank {
    fn eq(&self, other: &Rank) -> bool {
        self.number / 2 == other.number / 2
    }
}

/// Nothing.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Nothing;

/// Follows commands.
#[function]
pub fn follow(commands: [Command; 4]) -> i32 {
    let mut at = 0;
    let mut sum = 0;
    #[bound(4)]
    while let Some(Command::Move(by) | Command::Turn(by)) = commands.get(at) {
        at += 1;
        sum += by;
    }
    sum
}

/// Order of two ranks.
#[function]
pub fn is_before(one: Rank, other: Rank) -> bool {
    one < other
}

/// An order that may be absent.
#[function]
pub fn is_less(count: u32) -> Option<Ordering> {
    let [one, other] = [Nothing; 2];
    if count > 2 { one.partial_cmp(&other) } else { None }
}

/// No elements at a time.
#[function]
pub fn of_none(values: [f64; 4]) -> f64 {
    let mut sum = 0.0;
    for part in values.chunks(0) {
        sum += part[0];
    }
    sum
}

/// A copy between two lengths.
#[function]
pub fn copied(values: [f64; 4]) -> [f64; 2] {
    let mut first = [0.0; 2];
    first.copy_from_slice(&values[..3]);
    first
}

/// Again and again.
#[function]
pub fn again(values: [f64; 4]) -> f64 {
    values.iter().cycle().fold(0.0, |sum, value| sum + value)
}

/// A large array of a slice.
#[function]
pub fn large(values: &[f64]) -> f64 {
    let all: [f64; 2000] = values[..2000].try_into().unwrap();
    all[3]
}

/// Elements of nothing.
#[function]
pub fn nothings(values: &[Nothing]) -> usize {
    values.len()
}

/// A slice within a tuple.
#[function]
pub fn within(values: [f64; 4], at: usize) -> f64 {
    let pair = (&values[..at], 1.0);
    pair.0[0] + pair.1
}

/// Numbered from a number that is computed.
#[function]
pub fn numbered(values: [f64; 4], first: usize) -> usize {
    let mut sum = 0;
    for (value, number) in values.iter().zip(first..) {
        if *value > 0.0 {
            sum += number;
        }
    }
    sum
}
