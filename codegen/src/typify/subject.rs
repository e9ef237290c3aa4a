//! The values that patterns are matched against, and the meaning of their names.

use bessemer_ir::tree::Site;
use bessemer_ir::{Expr, Place};

use super::elements::Slice;

/// What is matched: a place, or several side by side that are written as a tuple.
#[derive(Clone)]
pub(super) enum Subject {
    /// A value in its place.
    Place(Place),
    /// The parts of a tuple that is never made.
    Parts(Vec<Subject>),
    /// Elements in a row.
    Slice(Box<Slice>),
    /// What is lent if the condition holds.
    Maybe(Expr, Box<Subject>),
    /// What holds nothing.
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

/// What a name stands for.
#[derive(Clone)]
pub(super) enum Stands {
    /// A place.
    Place(Place),
    /// Several elements.
    Part(Box<Slice>),
    /// What holds nothing.
    Nothing,
}
