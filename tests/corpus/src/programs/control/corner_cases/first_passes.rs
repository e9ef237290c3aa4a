//! A condition with side effects is evaluated even if the loop has no iteration.

use bessemer::prelude::*;

#[function]
fn told(calls: &mut u8) -> bool {
    *calls = calls.wrapping_add(1);
    true
}

#[function]
pub fn counted(from: u8, to: u8, calls: &mut u8) -> u8 {
    let mut i = from;
    while told(calls) && i < to {
        i += 1;
    }
    i
}

/// The index faults before the comparison is evaluated.
#[function]
pub fn indexed(table: &[u8; 4], at: usize, from: u8, to: u8) -> u8 {
    let mut i = from;
    while table[at] < 200 && i < to {
        i += 1;
    }
    i
}

/// Statements inside a condition are executed at least once.
#[function]
pub fn before(from: u8, to: u8) -> (u8, u8) {
    let (mut i, mut passes) = (from, 0u8);
    loop {
        passes = passes.wrapping_add(1);
        i = i.saturating_sub(1);
        if i <= to {
            break;
        }
        i -= 1;
    }
    (i, passes)
}
