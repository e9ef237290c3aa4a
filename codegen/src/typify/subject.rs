//! The values that patterns are matched against, and the meaning of their names.

use bessemer_ir::tree::Site;
use bessemer_ir::{Expr, Place};

use super::elements::Slice;

/// The subject of a match: a place, or several side by side that are written as a tuple.
#[derive(Clone)]
pub(super) enum Subject {
    /// A value in its place.
    Place(Place),
    /// The parts of a tuple that is never made.
    Parts(Vec<Subject>),
    /// Elements in a row.
    Slice(Box<Slice>),
    /// The place that is lent if the condition holds.
    Maybe(Expr, Box<Subject>),
    /// A zero-sized value.
    Nothing,
}

/// A name of a pattern, and the place that it stands for.
#[derive(Clone)]
pub(super) struct Named {
    pub name: String,
    pub slot: u32,
    pub mutable: bool,
    pub stands: Stands,
    pub site: Site,
}

/// A tuple that is never made.
#[derive(Clone)]
pub(super) struct Unmade {
    /// Its parts, side by side.
    pub parts: Subject,
    /// Its value, if it can be one.
    pub value: Option<Expr>,
}

/// The meaning of a name.
#[derive(Clone)]
pub(super) enum Stands {
    /// A place.
    Place(Place),
    /// Several elements.
    Part(Box<Slice>),
    /// A tuple that is never made.
    Whole(Unmade),
    /// A zero-sized value.
    Nothing,
}
