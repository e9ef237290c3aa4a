//! Loops without a declared bound, whose bound follows from something other than a plain counter.

use bessemer::prelude::*;

const STEP: u8 = 3;

/// Number of bits set: each iteration clears the lowest one.
#[function]
pub fn ones(mut n: u16) -> u8 {
    let mut count = 0;
    while n > 0 {
        n &= n - 1;
        count += 1;
    }
    count
}

/// Number of digits, by dividing by two or ten.
#[function]
pub fn digits(n: u32, binary: bool) -> u32 {
    let (mut rest, mut count) = (n, 0);
    while rest != 0 {
        if binary {
            rest >>= 1;
        } else {
            rest /= 10;
        }
        count += 1;
    }
    count
}

/// A `continue` after the step.
#[function]
pub fn odd_sum(n: u8) -> u32 {
    let (mut i, mut sum) = (0, 0);
    while i < n {
        i += 1;
        if i % 2 == 0 {
            continue;
        }
        sum += u32::from(i);
    }
    sum
}

/// Counts down to a signed limit; a step may fault.
#[function]
pub fn fall(from: i8, to: i8) -> u8 {
    let (mut height, mut passes) = (from, 0);
    while height >= to {
        height -= 1;
        passes += 1;
    }
    passes
}

/// Two indices that approach each other, one of them by a constant step.
#[function]
pub fn meeting(from: u8, to: u8) -> (u8, u8) {
    let (mut a, mut b) = (from, to);
    while a < b {
        if a % 2 == 0 {
            a += STEP;
        } else {
            b -= 1;
        }
    }
    (a, b)
}

/// Iterates over the records of a message; the first byte of each is its length.
#[function]
pub fn records(message: &[u8; 12]) -> (u8, usize) {
    let (mut count, mut at) = (0, 0);
    while at < message.len() {
        let length = message[at] as usize;
        at += 1 + length;
        count += 1;
    }
    (count, at)
}

/// A loop that ends at its head with a value.
#[function]
pub fn first_above(values: &[i16; 5], limit: i16) -> Option<usize> {
    let mut i = 0;
    loop {
        if i >= 5 {
            break None;
        }
        if values[i] > limit {
            break Some(i);
        }
        i += 1;
    }
}

/// The compared number is a field that the inner loop need not change.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    first: u8,
    last: u8,
}

#[data]
impl Window {
    /// Narrows the window; returns the number of steps.
    pub fn narrowed(&mut self, by: u8) -> u32 {
        let mut passes = 0;
        while self.first < self.last && passes < 100 {
            let mut inner = 0;
            while inner < by {
                self.last = self.last.min(200);
                inner += 1;
            }
            self.first += 1;
            passes += 1;
        }
        passes
    }
}

/// Leaves two loops at once.
#[function]
pub fn pair(values: &[u8; 6], sum: u8) -> (usize, usize) {
    let mut i = 0;
    let mut found = (6, 6);
    'outer: while i < 6 {
        let mut j = i + 1;
        while j < 6 {
            if values[i].wrapping_add(values[j]) == sum {
                found = (i, j);
                break 'outer;
            }
            j += 1;
        }
        i += 1;
    }
    found
}

/// The condition has a side effect and follows the comparison: it is not evaluated after the last iteration.
#[function]
pub fn drawn(seed: u32, n: u8) -> (u8, u32) {
    let (mut state, mut i) = (seed, 0);
    while i < n && drawing(&mut state) != 0 {
        i += 1;
    }
    (i, state)
}

/// The condition has a side effect and precedes the comparison: it is evaluated once more than there are iterations.
#[function]
pub fn drawn_first(seed: u32, n: u8) -> (u8, u32) {
    let (mut state, mut i) = (seed, 0);
    while drawing(&mut state) != 0 && i < n {
        i += 1;
    }
    (i, state)
}

#[function]
fn drawing(state: &mut u32) -> u32 {
    *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    *state >> 30
}
