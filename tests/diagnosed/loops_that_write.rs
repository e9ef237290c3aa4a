//! Loops whose condition, index or branches do something to what is compared.
use bessemer::prelude::*;

/// The condition moves its own limit.
#[function]
pub fn running_limit(n: u8) -> u8 {
    let (mut i, mut end) = (0, n);
    while i < end && grown(&mut end) {
        i += 1;
    }
    i
}

/// An index takes back what was counted.
#[function]
pub fn taken_back(n: u8) -> u8 {
    let (mut i, mut marks) = (0, [0; 4]);
    while i < n {
        i += 1;
        marks[place(&mut i)] = n;
    }
    marks[0]
}

/// A branch passes the condition by.
#[function]
pub fn passed_by(n: u8, k: u8) -> u8 {
    let mut i = 0;
    loop {
        match k {
            7 => continue,
            _ => {}
        }
        if i >= n {
            break;
        }
        i += 1;
    }
    i
}

/// A loop that adds what it subtracted.
#[function]
pub fn put_back(n: u8) -> u8 {
    let mut open: List<u8, 4> = List::new();
    open.push(n);
    while let Some(next) = open.pop() {
        open.push(next);
    }
    n
}

/// Twice nothing is nothing.
#[function]
pub fn doubled(from: u8, n: u8) -> u8 {
    let mut power = from;
    while power < n {
        power *= 2;
    }
    power
}

#[function]
fn grown(x: &mut u8) -> bool {
    *x += 1;
    true
}

#[function]
fn place(x: &mut u8) -> usize {
    *x -= 1;
    0
}
