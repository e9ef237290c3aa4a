//! Structs nested in two levels.

use bessemer::prelude::*;

/// A joint.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joint {
    pub locked: bool,
    pub angle: f64,
}

/// An arm with its joint.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limb {
    pub length: f32,
    pub joint: Joint,
}

/// A body with its arm.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Body {
    pub mass: u8,
    pub arm: Limb,
    pub id: u16,
}

/// The type of this kind.
pub type It = Body;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut body = Body::default();
    body.arm.joint.angle = x;
    body
}

/// A first value.
#[function]
pub fn one() -> It {
    Body { mass: 1, arm: Limb { length: 2.0, joint: Joint { angle: 3.0, locked: true } }, id: 4 }
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Body::default()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.arm.joint = Joint { angle: -1.0, locked: false };
}

include!("six.in");
include!("floats.in");
