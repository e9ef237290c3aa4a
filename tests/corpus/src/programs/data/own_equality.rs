//! `==` of an author's type: an implementation of `PartialEq` with the attribute. In the C it is a function that `==`
//! and `!=` call, also for types that contain it.

use bessemer::prelude::*;

/// An angle, rad; angles that differ by whole turns are equal.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Bearing {
    /// Angle from north towards east.
    pub radians: f32,
}

#[data]
impl PartialEq for Bearing {
    /// Returns true if both have the same direction.
    fn eq(&self, other: &Bearing) -> bool {
        difference(self, other) < 1.0e-3
    }
}

/// Angle between two bearings, from 0 to half a turn.
#[function]
pub fn difference(one: &Bearing, other: &Bearing) -> f32 {
    let turn = core::f32::consts::TAU;
    let apart = (one.radians - other.radians).rem_euclid(turn);
    apart.min(turn - apart)
}

/// Positions of a lever; those that do not drive are equal.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub enum Lever {
    #[default]
    Parked,
    Neutral,
    Forward,
    Back,
}

#[data]
impl PartialEq for Lever {
    /// Returns true if both drive in the same direction.
    fn eq(&self, other: &Self) -> bool {
        self.direction() == other.direction()
    }
}

#[data]
impl Lever {
    /// The sign of the speed.
    fn direction(self) -> i8 {
        match self {
            Lever::Parked | Lever::Neutral => 0,
            Lever::Forward => 1,
            Lever::Back => -1,
        }
    }
}

/// A part of a voyage, compared field by field by each field's own `==`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heading {
    pub to: Bearing,
    pub lever: Lever,
    pub turns: [Bearing; 2],
    pub next: Option<Lever>,
}

/// Returns true if the bearing has changed.
#[function]
pub fn is_new(now: Bearing, before: Bearing) -> bool {
    now != before
}

/// Returns true if two levers drive in the same direction.
#[function]
pub fn same_way(one: Lever, other: &Lever) -> bool {
    one == *other || one == Lever::Neutral && *other != Lever::Back
}

/// Returns true if two headings are equal.
#[function]
pub fn same_heading(one: &Heading, other: &Heading) -> bool {
    one == other
}

/// Index of the first bearing that equals `wanted`.
#[function]
pub fn place_of(bearings: &[Bearing; 3], wanted: &Bearing) -> Option<usize> {
    bearings.iter().position(|it| it == wanted)
}
