//! An own iterator is a struct with a `next`, which a loop calls until it returns `None`. The
//! loop's bound is `#[bound]` above it, `.take(n)`, or the length of an iterator zipped with it.

use bessemer::prelude::*;

/// The steps of a ramp: each changes by at most the slope, and the last is the goal.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    at: i32,
    goal: i32,
    slope: i32,
}

#[data]
impl Ramp {
    /// A ramp from one value to another.
    pub fn new(from: i32, to: i32, slope: i32) -> Ramp {
        Ramp { at: from, goal: to, slope: slope.saturating_abs().max(1) }
    }
}

#[data]
impl Iterator for Ramp {
    type Item = i32;

    fn next(&mut self) -> Option<Self::Item> {
        if self.at == self.goal {
            return None;
        }
        let left = self.goal.saturating_sub(self.at);
        self.at = if left.saturating_abs() <= self.slope {
            self.goal
        } else {
            self.at.saturating_add(if left < 0 { -self.slope } else { self.slope })
        };
        Some(self.at)
    }
}

/// Largest number of steps of a ramp.
pub const LIMIT: usize = 12;

/// Length and sum of a ramp.
#[function]
pub fn through(from: i32, to: i32) -> (u32, i32) {
    let (mut steps, mut sum) = (0, 0_i32);
    #[bound(LIMIT)]
    for value in Ramp::new(from, to, 1000) {
        steps += 1;
        sum = sum.wrapping_add(value);
    }
    (steps, sum)
}

/// The sum of the first `n` steps.
#[function]
pub fn taken(from: i32, to: i32, n: usize) -> i32 {
    Ramp::new(from, to, 10).take(n & 7).map(|x| x.wrapping_mul(3)).filter(|x| x % 2 == 0).fold(0, |sum, x| sum ^ x)
}

/// Elements zipped with the steps of a ramp.
#[function]
pub fn followed(values: &[i32; 5], to: i32) -> i32 {
    let mut sum = 0_i32;
    for (value, step) in values.iter().zip(Ramp::new(0, to, 3)) {
        sum = sum.wrapping_add(value.wrapping_mul(step));
    }
    sum
}
