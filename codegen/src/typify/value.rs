//! What an expression denotes while it is lowered; so, too, what a name means and what a pattern is matched against.

use bessemer_ir::tree::Site;
use bessemer_ir::{Expr, LocalId, Place, Type};

use super::elements::{Slice, Submatrix};

/// The meaning of an expression or a name.
#[derive(Clone)]
pub(super) enum Value {
    /// A local of its own.
    Local(LocalId),
    /// A place: that of a value, or the one that a reference refers to.
    Place(Place),
    /// A literal or a constant.
    Word(Box<Expr>),
    /// Elements in a row.
    Slice(Box<Slice>),
    /// A part of a matrix that is written where it is.
    Submatrix(Box<Submatrix>),
    /// A tuple that is never made: its parts, side by side, and its type, if a value of it can be.
    Tuple(Vec<Value>, Option<Type>),
    /// What is lent if the condition holds.
    Maybe(Expr, Box<Value>),
    /// A closure, by its place among those of the function that is being lowered.
    Closure(usize),
    /// A zero-sized value.
    Nothing,
}

/// A name of a pattern, and what it stands for.
#[derive(Clone)]
pub(super) struct Named {
    pub name: String,
    pub slot: u32,
    pub mutable: bool,
    pub stands: Value,
    pub site: Site,
}

impl Named {
    /// A name of several elements, of a part of a matrix, or of a zero-sized value.
    pub(super) fn of(name: &str, slot: u32, stands: Value, site: Site) -> Named {
        Named { name: name.to_owned(), slot, mutable: false, stands, site }
    }
}
