//! Arrays of enums with payloads.

use bessemer::prelude::*;

/// A step of a plan.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Step {
    #[default]
    Done,
    Wait(u32),
    Turn { by: f64, left: bool },
}

/// The type of this kind.
pub type It = [Step; 3];
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    [Step::Done, Step::Turn { by: x, left: false }, Step::Done]
}

/// A first value.
#[function]
pub fn one() -> It {
    [Step::Wait(3), Step::Done, Step::Turn { by: -0.5, left: true }]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [Step::Done; 3]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[0] = it[2];
    it[2] = Step::Wait(1);
}

include!("six.in");
include!("floats.in");
