//! `Ord` is implemented for references too, so Rust compares them and wants another one beside them.
use bessemer::prelude::*;

/// Severity of a fault.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// As it should be.
    #[default]
    Fine,
    /// Not so.
    Odd,
}

/// The sum of what is at least 3.
#[function]
pub fn sum(levels: &[i32; 4]) -> i32 {
    let mut sum = 0;
    for level in levels {
        sum += level.max(3);
    }
    sum
}

/// The lesser of a place and a value.
#[function]
pub fn lesser(seen: &Severity, now: Severity) -> Severity {
    seen.min(now)
}

fn main() {}
