//! `while` and `loop` with a declared bound.

use bessemer::prelude::*;

/// Counts how often a value is halved.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Halving {
    /// Number of repetitions.
    pub times: u32,
}

/// Largest number of halvings in a run.
const MOST: u32 = 8;

#[component]
impl Halving {
    /// Halves a value until it is below `limit`; more than eight halvings are a fault.
    #[entry]
    pub fn run(&mut self, value: f64, limit: f64) -> f64 {
        let mut rest = value;
        #[bound(MOST)]
        while rest > limit {
            self.times += 1;
            if rest == 100.0 {
                rest = 99.0;
                continue;
            }
            rest /= 2.0;
        }
        rest
    }
}

/// Newton's square root of an integer.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Root {
    /// Number of iterations in the last run.
    pub passes: u32,
}

#[component]
impl Root {
    /// The square root, rounded down.
    #[entry]
    pub fn run(&mut self, value: u32) -> u32 {
        self.passes = 0;
        if value < 2 {
            return value;
        }
        let mut guess = value / 2;
        #[bound(32)]
        loop {
            self.passes += 1;
            let next = (guess + value / guess) / 2;
            if next >= guess {
                return guess;
            }
            guess = next;
        }
    }
}

/// A loop with a value, and nested loops.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Collatz {
    /// The longest sequence so far.
    pub longest: u32,
}

#[component]
impl Collatz {
    /// Number of steps until the value is 1; 1000 more if the value exceeds `roof`.
    #[entry]
    pub fn run(&mut self, start: u32, roof: u32) -> u32 {
        let mut value = start;
        let mut steps = 0;
        #[bound(20)]
        let length = loop {
            if value <= 1 {
                break steps;
            }
            if value > roof {
                break 1000 + steps;
            }
            value = if value % 2 == 0 { value / 2 } else { 3 * value + 1 };
            steps += 1;
        };
        let mut left = length;
        #[bound(40)]
        'count: while left > 0 {
            #[bound(5)]
            loop {
                if left > 500 {
                    left = 3;
                    break 'count;
                }
                if left % 2 == 0 {
                    left /= 2;
                    continue 'count;
                }
                left -= 1;
                if left == 0 {
                    break;
                }
            }
        }
        self.longest = self.longest.max(length);
        length + left
    }
}
