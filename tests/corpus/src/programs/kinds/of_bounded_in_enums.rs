//! Bounded matrices in an array in an enum's payload.

use bessemer::prelude::*;

/// Kinds of a multiplication.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Job {
    Idle,
    Single(BoundedMatrix<f64, 2, 2>),
    Both { parts: [BoundedMatrix<f64, 2, 2>; 2], weight: f32 },
}

/// The type of this kind.
pub type It = Job;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut part = BoundedMatrix::new(1, 1);
    part[(0, 0)] = x;
    Job::Single(part)
}

/// A first value.
#[function]
pub fn one() -> It {
    Job::Both { parts: [BoundedMatrix::new(1, 2), BoundedMatrix::new(2, 1)], weight: 0.5 }
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Job::Idle
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = match *it {
        Job::Idle => one(),
        Job::Single(_) => Job::Idle,
        Job::Both { parts, .. } => Job::Single(parts[1]),
    };
}

include!("six.in");
include!("floats.in");
