//! State of a function's lowering from valid IR to explicit IR.
//!
//! [`statements`](super::statements) lowers statements, [`flatten`](super::flatten) their expressions.

use bessemer_ir::{Expr, Function, Module, Place, Span, Stmt};

use super::analysis::{Results, State};
use super::positions::Callee;
use super::remaining::{Doubted, Remaining};

/// A function that is being made explicit.
pub(super) struct Lowering<'m> {
    pub(super) module: &'m Module,
    /// Summaries of the functions before this one.
    pub(super) callees: &'m [Callee],
    pub(super) function: Function,
    pub(super) facts: State<'m>,
    /// Statements of the current block so far.
    pub(super) out: Vec<Stmt>,
    /// Destination of the statement, as the first part of names.
    pub(super) base: String,
    /// True if an enum that may be invalid is normalised where it is read.
    pub(super) brings: bool,
    /// Operations whose proof is doubted.
    pub(super) doubted: &'m Doubted,
    /// Places that the value of the present statement writes; it is not yet in `out`.
    pub(super) pending: Vec<Place>,
    /// Conditions of checks that later operations need.
    pub(super) needed: Vec<Expr>,
    /// Span of the operation whose check is being lowered.
    pub(super) asked: Option<Span>,
    /// True if proved checks are kept.
    pub(super) keeps: bool,
    pub(super) remaining: Vec<Remaining>,
    /// Intervals of the returned numbers so far.
    pub(super) returned: Option<Results>,
}
