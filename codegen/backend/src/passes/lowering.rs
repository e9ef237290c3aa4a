//! A function on its way from valid IR to explicit IR.
//!
//! [`statements`](super::statements) lowers its statements, [`flatten`](super::flatten) their expressions.

use bessemer_ir::{Expr, Function, Module, Place, Span, Stmt};

use super::analysis::{Results, State};
use super::names::Names;
use super::positions::Callee;
use super::remaining::{Doubted, Remaining};

/// A function on its way.
pub(super) struct Lowering<'m> {
    pub(super) module: &'m Module,
    /// Summaries of the functions before this one.
    pub(super) callees: &'m [Callee],
    pub(super) function: Function,
    pub(super) facts: State<'m>,
    /// The statements of the block so far.
    pub(super) out: Vec<Stmt>,
    /// The destination of the statement, as the stem of names.
    pub(super) base: String,
    pub(super) names: Names,
    /// True if an enum that may be none of its variants is brought to one where it is read.
    pub(super) brings: bool,
    /// Operations whose proof is not believed.
    pub(super) doubted: &'m Doubted,
    /// The places that the value of the statement writes, before what is emitted meanwhile; it is not in `out`.
    pub(super) pending: Vec<Place>,
    /// The conditions of checks that operations behind them need.
    pub(super) needed: Vec<Expr>,
    /// Span of the operation whose check is being lowered.
    pub(super) asked: Option<Span>,
    /// True if checks that are proved stand all the same.
    pub(super) keeps: bool,
    pub(super) remaining: Vec<Remaining>,
    /// The numbers in what is returned so far.
    pub(super) returned: Option<Results>,
}
