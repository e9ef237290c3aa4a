//! `==` of an author's own type: `PartialEq` is Rust's trait, marked as the type is. In the C it is a function, which
//! `==` and `!=` call, also of what the type is part of.

use bessemer::prelude::*;

/// An angle, rad; a turn more is the same.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Bearing {
    /// From north to east.
    pub radians: f32,
}

#[data]
impl PartialEq for Bearing {
    /// Returns true if they point the same way.
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

/// Positions of a lever: all that drive nothing are equal.
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
    /// Returns true if they drive the same way.
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

/// A leg of a voyage, compared part by part: by what each part says.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heading {
    pub to: Bearing,
    pub lever: Lever,
    pub turns: [Bearing; 2],
    pub next: Option<Lever>,
}

/// Returns true if a bearing is another.
#[function]
pub fn is_new(now: Bearing, before: Bearing) -> bool {
    now != before
}

/// Returns true if two levers drive the same way.
#[function]
pub fn same_way(one: Lever, other: &Lever) -> bool {
    one == *other || one == Lever::Neutral && *other != Lever::Back
}

/// Returns true if two headings are the same.
#[function]
pub fn same_heading(one: &Heading, other: &Heading) -> bool {
    one == other
}

/// Index of a bearing that equals the wanted one.
#[function]
pub fn place_of(bearings: &[Bearing; 3], wanted: &Bearing) -> Option<usize> {
    bearings.iter().position(|it| it == wanted)
}
