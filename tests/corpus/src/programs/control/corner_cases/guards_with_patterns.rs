//! Guards of `match` with patterns in them: alone, in chains, with writes, with faults and in loops.

use bessemer::prelude::*;

/// A received telegram.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Telegram {
    /// Nothing.
    Empty,
    /// A number and where it belongs.
    Value(i32, u8),
    /// A share.
    Share {
        /// The share.
        of: Option<i32>,
    },
}

/// Returns the telegram for a number.
#[function]
fn telegram(kind: u8, value: i32) -> Telegram {
    match kind % 4 {
        0 => Telegram::Empty,
        1 => Telegram::Value(value, kind),
        2 => Telegram::Share { of: None },
        _ => Telegram::Share { of: Some(value) },
    }
}

/// Half of an even number.
#[function]
fn half(value: i32) -> Option<i32> {
    if value % 2 == 0 { Some(value / 2) } else { None }
}

/// Patterns in guards, the arms behind each, and one without.
#[function]
pub fn decoded(kind: u8, value: i32) -> i32 {
    match telegram(kind, value) {
        Telegram::Value(value, place) if let Some(half) = half(value) && half > i32::from(place) => half,
        Telegram::Value(value, _) if let 0..=9 = value => value + 100,
        Telegram::Value(..) => -1,
        Telegram::Share { of: Some(of) } if of > 5 && let Some(half) = half(of) => half - 1,
        Telegram::Share { of } if let Some(of) = of => of.wrapping_neg(),
        Telegram::Share { .. } => -2,
        Telegram::Empty => 0,
    }
}

/// A guard that names a part of the subject, which the arm writes.
#[function]
pub fn written(first: Option<i32>, second: Option<i32>) -> (i32, i32) {
    let mut pair = (first, second);
    let found = match pair.0 {
        Some(one) if let Some(other) = pair.1 && one < other => {
            pair.1 = Some(one);
            other
        }
        Some(one) if let None = pair.1 => one.wrapping_add(1),
        _ => 7,
    };
    (found, pair.1.unwrap_or(3))
}

/// A guard that changes a variable, also where its pattern does not match.
#[function]
pub fn counted(value: Option<i32>) -> (i32, u32) {
    let mut count = 0;
    let mut seen = |value: i32| {
        count += 1;
        half(value)
    };
    let found = match value {
        Some(value) if let Some(half) = seen(value) => half,
        Some(value) if let Some(half) = seen(value.wrapping_add(1)) => half,
        _ => 0,
    };
    (found, count)
}

/// A guard that may fault before its pattern is tried.
#[function]
pub fn faulting(value: i32, by: i32) -> i32 {
    match value {
        0 => 0,
        value if let quotient @ 1..=100 = value / by => quotient,
        _ => 1,
    }
}

/// Guards in a loop, which leave it.
#[function]
pub fn in_a_loop(values: [i32; 4]) -> i32 {
    let mut total = 0_i32;
    for value in values {
        match value {
            value if let Some(half) = half(value) && let Some(quarter) = half_of(half) => {
                total = total.wrapping_add(quarter);
            }
            0 => break,
            value if let Some(_) = half(value.wrapping_add(1)) => continue,
            _ => return total,
        }
    }
    total
}

#[function]
fn half_of(value: i32) -> Option<i32> {
    half(value)
}

/// Guards that look at an element by a computed index.
#[function]
pub fn indexed(at: Option<usize>, table: [Option<i32>; 4]) -> i32 {
    match at {
        Some(at) if let Some(found) = table[at % 3 + 1] => found,
        Some(at) if let Some(found) = table[at] && found > 5 => found.wrapping_neg(),
        _ => 5,
    }
}
