//! Identity of operations in a function.
//!
//! A span may have several operations, so a site is the address of the node in memory. Invariant: a site is compared
//! only with sites of the same function, which is borrowed meanwhile.

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
    /// Returns the site of the operation at the root of an expression.
    pub(super) fn of_expr(expr: &Expr) -> Site {
        Site { at: At::Expr(expr), span: expr.span }
    }

    /// Returns the site of a step of a place at `span`.
    pub(super) fn of_step(step: &Step, span: Span) -> Site {
        Site { at: At::Step(step), span }
    }

    /// Returns the site of an author's check that was removed.
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
