//! Sites of operations in a function.
//!
//! Several operations may come from one place of the source, so a span does not tell them apart: what does is where they
//! are in memory. Invariant: a site is compared only with others of the same function, borrowed all the while.

use std::hash::{Hash, Hasher};

use bessemer_ir::{Expr, Span, Step, Stmt};

/// An operation of a function.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site {
    at: At,
    /// Source position.
    pub(super) span: Span,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum At {
    Expr(*const Expr),
    Step(*const Step),
    Check(*const Stmt),
}

impl Site {
    /// The operation at the root of an expression.
    pub(super) fn of_expr(expr: &Expr) -> Site {
        Site { at: At::Expr(expr), span: expr.span }
    }

    /// A step into the place that comes from `span`.
    pub(super) fn of_step(step: &Step, span: Span) -> Site {
        Site { at: At::Step(step), span }
    }

    /// A check of the author's that went.
    pub(super) fn of_check(stmt: &Stmt) -> Site {
        Site { at: At::Check(stmt), span: stmt.span }
    }
}

impl PartialEq for Site {
    fn eq(&self, other: &Site) -> bool {
        self.at == other.at
    }
}

impl Eq for Site {}

impl Hash for Site {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.at.hash(state);
    }
}
