//! Visitors of the author's syntax.
//!
//! Implement [`Visit`] (to read) or [`VisitMut`] (to rewrite) and override the methods that matter. An override
//! visits the children by calling the `walk_…` function of the same name. If a closure suffices, use [`Walk`].
//!
//! Invariant: every expression, statement, arm and pattern is visited exactly once, in the order of the source.

use alloc::collections::BTreeSet;
use alloc::string::String;

use super::{Arm, Block, Expr, ExprKind, Pattern, Source, Start, Stmt};

macro_rules! visitor {
    (
        $(#[$doc:meta])* $visitor:ident($($mutable:tt)?) =>
        $walk_block:ident $walk_stmt:ident $walk_arm:ident $walk_pattern:ident $walk_expr:ident
        $walk_source:ident
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
            /// Visits an arm of a `match`.
            fn arm(&mut self, arm: &$($mutable)? Arm) {
                $walk_arm(self, arm);
            }
            /// Visits a pattern.
            fn pattern(&mut self, pattern: &$($mutable)? Pattern) {
                $walk_pattern(self, pattern);
            }
            /// Visits the sequence that a loop iterates over.
            fn source(&mut self, source: &$($mutable)? Source) {
                $walk_source(self, source);
            }
            /// Visits an expression.
            fn expr(&mut self, expr: &$($mutable)? Expr) {
                $walk_expr(self, expr);
            }
        }

        /// Visits the statements of a block, and its value.
        pub fn $walk_block<V: $visitor + ?Sized>(visitor: &mut V, block: &$($mutable)? Block) {
            for stmt in &$($mutable)? block.stmts {
                visitor.stmt(stmt);
            }
            if let Some(tail) = &$($mutable)? block.tail {
                visitor.expr(tail);
            }
        }

        /// Visits the parts of a statement.
        pub fn $walk_stmt<V: $visitor + ?Sized>(visitor: &mut V, stmt: &$($mutable)? Stmt) {
            match stmt {
                Stmt::Let { value, .. } => {
                    if let Some(value) = value {
                        visitor.expr(value);
                    }
                }
                Stmt::Apart { pattern, value, otherwise, .. } => {
                    visitor.pattern(pattern);
                    visitor.expr(value);
                    if let Some(otherwise) = otherwise {
                        visitor.block(otherwise);
                    }
                }
                Stmt::Expr(expr) => visitor.expr(expr),
            }
        }

        /// Visits the parts of an arm.
        pub fn $walk_arm<V: $visitor + ?Sized>(visitor: &mut V, arm: &$($mutable)? Arm) {
            visitor.pattern(&$($mutable)? arm.pattern);
            if let Some(guard) = &$($mutable)? arm.guard {
                visitor.expr(guard);
            }
            visitor.expr(&$($mutable)? arm.body);
        }

        /// Visits the parts of a pattern.
        pub fn $walk_pattern<V: $visitor + ?Sized>(visitor: &mut V, pattern: &$($mutable)? Pattern) {
            match pattern {
                Pattern::Any | Pattern::Rest => {}
                Pattern::Name { inner, .. } => {
                    if let Some(inner) = inner {
                        visitor.pattern(inner);
                    }
                }
                Pattern::Value(value) => visitor.expr(value),
                Pattern::Range { from, to, .. } => {
                    for end in [from, to] {
                        if let Some(end) = end {
                            visitor.expr(end);
                        }
                    }
                }
                Pattern::Or(patterns)
                | Pattern::Tuple(patterns)
                | Pattern::Array(patterns)
                | Pattern::Constructor(_, patterns) => {
                    for pattern in patterns {
                        visitor.pattern(pattern);
                    }
                }
                Pattern::Fields(_, fields) => {
                    for (_, pattern) in fields {
                        visitor.pattern(pattern);
                    }
                }
            }
        }

        /// Visits the parts of an expression.
        pub fn $walk_expr<V: $visitor + ?Sized>(visitor: &mut V, expr: &$($mutable)? Expr) {
            match &$($mutable)? expr.kind {
                ExprKind::Bool(_)
                | ExprKind::Int(..)
                | ExprKind::Float(..)
                | ExprKind::Bytes(_)
                | ExprKind::Local(_)
                | ExprKind::Path(..)
                | ExprKind::Continue(_) => {}
                ExprKind::Unary(_, x)
                | ExprKind::Field(x, _)
                | ExprKind::Repeat(x)
                | ExprKind::Ref(_, x)
                | ExprKind::Deref(x)
                | ExprKind::Cast(x)
                | ExprKind::Try(_, x)
                | ExprKind::Unroll(_, x)
                | ExprKind::Assert(x, _) => visitor.expr(x),
                ExprKind::Binary(_, a, b)
                | ExprKind::Assign(_, a, b)
                | ExprKind::Index(a, b) => {
                    visitor.expr(a);
                    visitor.expr(b);
                }
                ExprKind::Call(_, items)
                | ExprKind::Apply(_, items)
                | ExprKind::Tuple(items)
                | ExprKind::Constructor(_, items)
                | ExprKind::Array(items) => {
                    for item in items {
                        visitor.expr(item);
                    }
                }
                ExprKind::Closure(closure) => {
                    for parameter in &$($mutable)? closure.parameters {
                        visitor.pattern(parameter);
                    }
                    visitor.expr(&$($mutable)? closure.body);
                }
                ExprKind::Slice(base, from, to, _) => {
                    visitor.expr(base);
                    for end in [from, to] {
                        if let Some(end) = end {
                            visitor.expr(end);
                        }
                    }
                }
                ExprKind::Struct(_, fields, base) => {
                    for (_, value) in fields {
                        visitor.expr(value);
                    }
                    if let Some(base) = base {
                        visitor.expr(base);
                    }
                }
                ExprKind::Let(pattern, value) => {
                    visitor.pattern(pattern);
                    visitor.expr(value);
                }
                ExprKind::If(condition, then, otherwise) => {
                    visitor.expr(condition);
                    visitor.block(then);
                    if let Some(otherwise) = otherwise {
                        visitor.expr(otherwise);
                    }
                }
                ExprKind::Match(value, arms) => {
                    visitor.expr(value);
                    for arm in arms {
                        visitor.arm(arm);
                    }
                }
                ExprKind::Block(block) | ExprKind::Labelled(_, block) => visitor.block(block),
                ExprKind::Each { pattern, source, bound, body, .. } => {
                    visitor.pattern(pattern);
                    visitor.source(source);
                    if let Some(bound) = bound {
                        visitor.expr(bound);
                    }
                    visitor.block(body);
                }
                ExprKind::Fold { start, each, .. } => {
                    if let Start::Tried(value) = start {
                        visitor.expr(value);
                    }
                    visitor.expr(each);
                }
                ExprKind::While { condition, bound, body, .. } => {
                    for expr in [condition, bound] {
                        if let Some(expr) = expr {
                            visitor.expr(expr);
                        }
                    }
                    visitor.block(body);
                }
                ExprKind::Return(value) | ExprKind::Break(_, value) => {
                    if let Some(value) = value {
                        visitor.expr(value);
                    }
                }
            }
        }

        /// Visits the parts of a source.
        pub fn $walk_source<V: $visitor + ?Sized>(visitor: &mut V, source: &$($mutable)? Source) {
            match source {
                Source::Elements(array, _) => visitor.expr(array),
                Source::Numbers(range) => {
                    visitor.expr(&$($mutable)? range.from);
                    if let Some(to) = &$($mutable)? range.to {
                        visitor.expr(to);
                    }
                }
                Source::Groups(_, array, size) => {
                    visitor.expr(array);
                    visitor.expr(size);
                }
                Source::Zip(one, other, _) | Source::Chain(one, other) => {
                    visitor.source(one);
                    visitor.source(other);
                }
                Source::Enumerate(of) | Source::Rev(of) | Source::Cycle(of) => visitor.source(of),
                Source::Skip(of, count) | Source::Take(of, count) | Source::StepBy(of, count) => {
                    visitor.source(of);
                    visitor.expr(count);
                }
            }
        }
    };
}

visitor! {
    /// Visitor that reads every node.
    Visit() => walk_block walk_stmt walk_arm walk_pattern walk_expr walk_source
}

visitor! {
    /// Visitor that rewrites every node in place.
    VisitMut(mut) =>
    walk_block_mut walk_stmt_mut walk_arm_mut walk_pattern_mut walk_expr_mut walk_source_mut
}

/// A node that can be searched by a closure, without a visitor type.
///
/// The order is [`Visit`]'s, including the node itself.
pub trait Walk {
    /// Runs a visitor on the node.
    fn walk<V: Visit>(&self, visitor: &mut V);

    /// Calls `see` for each expression, outer before inner.
    fn each_expr(&self, see: impl FnMut(&Expr)) {
        self.walk(&mut Exprs(see));
    }

    /// Returns true if the test holds for any expression.
    fn any_expr(&self, mut test: impl FnMut(&Expr) -> bool) -> bool {
        let mut found = false;
        self.each_expr(|expr| found = found || test(expr));
        found
    }

    /// Calls `see` for each name that a pattern or a `let` binds, with its slot.
    fn each_name(&self, see: impl FnMut(&str, u32)) {
        self.walk(&mut Names(see));
    }

    /// Returns the names that are bound.
    fn bound(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        self.each_name(|name, _| {
            names.insert(name.into());
        });
        names
    }

    /// Returns the names of all locals that are used.
    fn locals(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        self.each_expr(|expr| {
            if let ExprKind::Local(name) = &expr.kind {
                names.insert(name.clone());
            }
        });
        names
    }
}

impl Walk for Block {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        visitor.block(self);
    }
}

impl Walk for Pattern {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        visitor.pattern(self);
    }
}

impl Walk for Expr {
    fn walk<V: Visit>(&self, visitor: &mut V) {
        visitor.expr(self);
    }
}

struct Exprs<F>(F);

impl<F: FnMut(&Expr)> Visit for Exprs<F> {
    fn expr(&mut self, expr: &Expr) {
        (self.0)(expr);
        walk_expr(self, expr);
    }
}

struct Names<F>(F);

impl<F: FnMut(&str, u32)> Visit for Names<F> {
    fn stmt(&mut self, stmt: &Stmt) {
        if let Stmt::Let { name, slot, .. } = stmt {
            (self.0)(name, *slot);
        }
        walk_stmt(self, stmt);
    }

    fn pattern(&mut self, pattern: &Pattern) {
        if let Pattern::Name { name, slot, .. } = pattern {
            (self.0)(name, *slot);
        }
        walk_pattern(self, pattern);
    }
}
