//! Visitors of statements, expressions and places; children are visited in the order of evaluation.
//!
//! Implement [`Visit`] (to read) or [`VisitMut`] (to rewrite), and override the methods that matter. An override
//! visits the children by calling the `walk_…` function of the same name. If a closure suffices, use [`Walk`].
//!
//! Invariants: every node is visited exactly once; a written place is visited after the value that is written to it;
//! a declaration is visited after its value (or its bounds).
//!
//! Must not know: types, or the tables of handles. A visit never leaves the node at which it began.

use crate::ir::{Argument, Block, Expr, ExprKind, LocalId, Place, Step, Stmt, StmtKind};

/// The access to a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// The value is loaded.
    Read,
    /// An assignment replaces the value.
    Write,
    /// A call borrows the place mutably.
    Lend,
}

macro_rules! visitor {
    (
        $(#[$doc:meta])* $visitor:ident($($mutable:tt)?) =>
        $walk_block:ident $walk_stmt:ident $walk_expr:ident $walk_place:ident
    ) => {
        $(#[$doc])*
        pub trait $visitor {
            /// Visits a block.
            fn block(&mut self, block: &$($mutable)? Block) {
                $walk_block(self, block);
            }
            /// Visits a statement.
            fn stmt(&mut self, stmt: &$($mutable)? Stmt) {
                $walk_stmt(self, stmt);
            }
            /// Visits an expression.
            fn expr(&mut self, expr: &$($mutable)? Expr) {
                $walk_expr(self, expr);
            }
            /// Visits a place with its access.
            fn place(&mut self, place: &$($mutable)? Place, access: Access) {
                let _ = access;
                $walk_place(self, place);
            }
            /// Visits the local that a `let` or a `for` declares.
            fn declaration(&mut self, local: &$($mutable)? LocalId) {
                let _ = local;
            }
        }

        /// Visits the statements of a block.
        pub fn $walk_block<V: $visitor + ?Sized>(visitor: &mut V, block: &$($mutable)? Block) {
            for stmt in &$($mutable)? block.0 {
                visitor.stmt(stmt);
            }
        }

        /// Visits the parts of a statement.
        pub fn $walk_stmt<V: $visitor + ?Sized>(visitor: &mut V, stmt: &$($mutable)? Stmt) {
            match &$($mutable)? stmt.kind {
                StmtKind::Let { local, value } => {
                    if let Some(value) = value {
                        visitor.expr(value);
                    }
                    visitor.declaration(local);
                }
                StmtKind::Assign { place, value } => {
                    visitor.expr(value);
                    visitor.place(place, Access::Write);
                }
                StmtKind::Expr(expr) | StmtKind::Return(Some(expr)) => visitor.expr(expr),
                StmtKind::If { condition, then, otherwise } => {
                    visitor.expr(condition);
                    visitor.block(then);
                    visitor.block(otherwise);
                }
                StmtKind::Match { scrutinee, arms, otherwise } => {
                    visitor.expr(scrutinee);
                    for arm in arms {
                        visitor.block(&$($mutable)? arm.body);
                    }
                    if let Some(otherwise) = otherwise {
                        visitor.block(otherwise);
                    }
                }
                StmtKind::For { variable, from, to, body, .. } => {
                    visitor.expr(from);
                    visitor.expr(to);
                    visitor.declaration(variable);
                    visitor.block(body);
                }
                StmtKind::Check { condition, .. } => visitor.expr(condition),
                StmtKind::Return(None) | StmtKind::Break | StmtKind::Continue => {}
            }
        }

        /// Visits the operands of an expression.
        pub fn $walk_expr<V: $visitor + ?Sized>(visitor: &mut V, expr: &$($mutable)? Expr) {
            match &$($mutable)? expr.kind {
                ExprKind::Literal(_) | ExprKind::Const(_) => {}
                ExprKind::Load(place) => visitor.place(place, Access::Read),
                ExprKind::Unary(_, operand) | ExprKind::Cast(operand) | ExprKind::Splat(operand) => {
                    visitor.expr(operand);
                }
                ExprKind::Binary(_, left, right)
                | ExprKind::Compare(_, left, right)
                | ExprKind::Logic(_, left, right) => {
                    visitor.expr(left);
                    visitor.expr(right);
                }
                ExprKind::Call(_, arguments) => {
                    for argument in arguments {
                        match argument {
                            Argument::Value(expr) | Argument::Ref(expr) => visitor.expr(expr),
                            Argument::RefMut(place) => visitor.place(place, Access::Lend),
                        }
                    }
                }
                ExprKind::Intrinsic(_, operands)
                | ExprKind::Struct(operands)
                | ExprKind::Array(operands)
                | ExprKind::Matrix(operands)
                | ExprKind::Routine(_, operands) => {
                    for operand in operands {
                        visitor.expr(operand);
                    }
                }
            }
        }

        /// Visits the indices of a place.
        pub fn $walk_place<V: $visitor + ?Sized>(visitor: &mut V, place: &$($mutable)? Place) {
            for step in &$($mutable)? place.steps {
                match step {
                    Step::Field(_) => {}
                    Step::Index(index) | Step::From(index) => visitor.expr(index),
                    Step::Element(row, column) => {
                        visitor.expr(row);
                        visitor.expr(column);
                    }
                }
            }
        }
    };
}

visitor! {
    /// Visitor that reads every node.
    Visit() => walk_block walk_stmt walk_expr walk_place
}

visitor! {
    /// Visitor that rewrites every node in place.
    VisitMut(mut) => walk_block_mut walk_stmt_mut walk_expr_mut walk_place_mut
}

impl Stmt {
    /// Returns the branches of a statement, including a missing `else`; the body of a loop is none.
    pub fn branches(&self) -> impl Iterator<Item = &Block> {
        let (pair, arms, otherwise) = match &self.kind {
            StmtKind::If { then, otherwise, .. } => (Some([then, otherwise]), &[][..], &None),
            StmtKind::Match { arms, otherwise, .. } => (None, &arms[..], otherwise),
            _ => (None, &[][..], &None),
        };
        pair.into_iter().flatten().chain(arms.iter().map(|arm| &arm.body)).chain(otherwise)
    }

    /// Returns true if the test holds for the statement, or for one in its branches.
    pub fn any_branch(&self, test: &impl Fn(&StmtKind) -> bool) -> bool {
        let any = |block: &Block| block.0.iter().any(|stmt| stmt.any_branch(test));
        test(&self.kind) || self.branches().any(any)
    }
}

impl Step {
    /// Returns the indices of a step, in order.
    pub fn indices(&self) -> impl Iterator<Item = &Expr> {
        let (first, second) = match self {
            Step::Field(_) => (None, None),
            Step::Index(index) | Step::From(index) => (Some(index), None),
            Step::Element(row, column) => (Some(row), Some(column)),
        };
        first.into_iter().chain(second)
    }

    /// Returns the indices, mutably.
    pub fn indices_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let (first, second) = match self {
            Step::Field(_) => (None, None),
            Step::Index(index) | Step::From(index) => (Some(index), None),
            Step::Element(row, column) => (Some(row), Some(column)),
        };
        first.into_iter().chain(second)
    }
}

/// A node that can be searched by a closure, without a visitor type.
///
/// The order is [`Visit`]'s, including the node itself; of a place, its indices are visited.
pub trait Walk {
    /// Runs a visitor on the node.
    fn walk<V: Visit>(&self, visitor: &mut V);

    /// Calls `see` for each statement, outer before inner.
    fn each_stmt(&self, see: impl FnMut(&Stmt)) {
        self.walk(&mut Stmts(see));
    }

    /// Calls `see` for each expression, outer before inner.
    fn each_expr(&self, see: impl FnMut(&Expr)) {
        self.walk(&mut Exprs(see));
    }

    /// Calls `see` for each place with its access.
    fn each_place(&self, see: impl FnMut(&Place, Access)) {
        self.walk(&mut Places(see));
    }

    /// Returns true if the test holds for any statement.
    fn any_stmt(&self, mut test: impl FnMut(&Stmt) -> bool) -> bool {
        let mut found = false;
        self.each_stmt(|stmt| found = found || test(stmt));
        found
    }

    /// Returns true if the test holds for any expression.
    fn any_expr(&self, mut test: impl FnMut(&Expr) -> bool) -> bool {
        let mut found = false;
        self.each_expr(|expr| found = found || test(expr));
        found
    }

    /// Returns true if the test holds for any place.
    fn any_place(&self, mut test: impl FnMut(&Place, Access) -> bool) -> bool {
        let mut found = false;
        self.each_place(|place, access| found = found || test(place, access));
        found
    }
}

impl Walk for Block {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        visitor.block(self);
    }
}

impl Walk for [Stmt] {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        self.iter().for_each(|stmt| visitor.stmt(stmt));
    }
}

impl Walk for Stmt {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        visitor.stmt(self);
    }
}

impl Walk for Expr {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        visitor.expr(self);
    }
}

impl Walk for Place {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        walk_place(visitor, self);
    }
}

struct Stmts<F>(F);

impl<F: FnMut(&Stmt)> Visit for Stmts<F> {
    fn stmt(&mut self, stmt: &Stmt) {
        (self.0)(stmt);
        walk_stmt(self, stmt);
    }
    // No statement is in one.
    fn expr(&mut self, _: &Expr) {}
    fn place(&mut self, _: &Place, _: Access) {}
}

struct Exprs<F>(F);

impl<F: FnMut(&Expr)> Visit for Exprs<F> {
    fn expr(&mut self, expr: &Expr) {
        (self.0)(expr);
        walk_expr(self, expr);
    }
}

struct Places<F>(F);

impl<F: FnMut(&Place, Access)> Visit for Places<F> {
    fn place(&mut self, place: &Place, access: Access) {
        (self.0)(place, access);
        walk_place(self, place);
    }
}
