//! Constructors of expressions that no author wrote, for desugaring.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

use super::number::Int;
use super::{
    BinaryOp, Block, Closure, Expr, ExprKind, NO_SLOT, Pattern, Scalar, Site, Source, Stmt, UnaryOp,
};

impl Expr {
    /// Returns an expression whose type follows from its operands.
    pub fn plain(kind: ExprKind, site: Site) -> Expr {
        Expr { kind, site, slot: None }
    }

    /// Builds the expression of a name.
    pub fn local(name: &str, site: Site) -> Expr {
        Expr::plain(ExprKind::Local(name.into()), site)
    }

    /// Builds the number after the `usize` of a name.
    pub fn successor(name: &str, site: Site) -> Expr {
        let one = ExprKind::Int("1".into(), Some(Scalar::Int(Int::Usize)));
        let [number, one] = [Expr::local(name, site), Expr::plain(one, site)].map(Box::new);
        Expr::plain(ExprKind::Binary(BinaryOp::Add, number, one), site)
    }

    /// Replaces the expression by a closure.
    pub fn become_closure(&mut self, closure: Closure) {
        self.kind = ExprKind::Closure(closure);
    }

    /// Returns a block that declares copies of variables, with their names, before the expression.
    pub fn with_copies(self, names: &[String]) -> Expr {
        let site = self.site;
        let copy = |name: &String| {
            let (name, value) = (name.clone(), Some(Expr::local(name, site)));
            Stmt::Let { name, slot: NO_SLOT, value, site, mutable: true }
        };
        let mut stmts: Vec<_> = names.iter().map(copy).collect();
        stmts.push(Stmt::Expr(self));
        Expr::plain(ExprKind::Block(Block { stmts, tail: None }), site)
    }

    /// Returns a block that sets a flag before the expression.
    pub fn after_flag(self, name: &str) -> Expr {
        let (site, set) = (self.site, Expr::plain(ExprKind::Bool(true), self.site));
        let stmts = [Stmt::assigned(name, set, site), Stmt::Expr(self)].into();
        Expr::plain(ExprKind::Block(Block { stmts, tail: None }), site)
    }

    /// Returns the expression under the condition that a flag is not set, which is then set behind it.
    pub fn once(self, flag: &str) -> Expr {
        let site = self.site;
        let mut once = self.without_flag(flag);
        if let ExprKind::If(_, then, _) = &mut once.kind {
            then.stmts.push(Stmt::assigned(flag, Expr::plain(ExprKind::Bool(true), site), site));
        }
        once
    }

    /// Returns a block that assigns the value of another variable, or else zero, to a count behind the expression.
    pub fn with_count_behind(self, count: &str, other: Option<&str>) -> Expr {
        let site = self.site;
        let mut block = Block { stmts: [Stmt::Expr(self)].into(), tail: None };
        block.assign_behind(count, other, site);
        Expr::plain(ExprKind::Block(block), site)
    }

    /// Lets each pass of a loop call a closure without an item.
    pub fn without_items(&mut self, closure: &str) {
        let call = Expr::plain(ExprKind::Apply(closure.into(), Vec::new()), self.site);
        if let ExprKind::Each { pattern, body, .. } = &mut self.kind {
            **pattern = Pattern::Any;
            *body = Block { stmts: [Stmt::Expr(call)].into(), tail: None };
        }
    }

    /// Returns the expression under the condition that a flag is not set.
    pub fn without_flag(self, name: &str) -> Expr {
        let site = self.site;
        let flag = Box::new(Expr::local(name, site));
        let not_yet = Box::new(Expr::plain(ExprKind::Unary(UnaryOp::Not, flag), site));
        let then = Block { stmts: [Stmt::Expr(self)].into(), tail: None };
        Expr::plain(ExprKind::If(not_yet, then, None), site)
    }
}

impl Block {
    /// Adds an assignment of the value of another variable, or else zero, to a count.
    pub fn assign_behind(&mut self, count: &str, other: Option<&str>, site: Site) {
        let zero = || ExprKind::Int("0".into(), Some(Scalar::Int(Int::Usize)));
        let value =
            other.map_or_else(|| Expr::plain(zero(), site), |other| Expr::local(other, site));
        self.stmts.push(Stmt::assigned(count, value, site));
    }
}

impl Source {
    /// Returns the source without as many items as a variable counts.
    pub fn behind(self, count: &str, site: Site) -> Source {
        Source::Skip(Box::new(self), Expr::local(count, site))
    }
}

impl Stmt {
    /// Returns an assignment to a name.
    pub fn assigned(name: &str, value: Expr, site: Site) -> Stmt {
        let to = Box::new(Expr::local(name, site));
        Stmt::Expr(Expr::plain(ExprKind::Assign(None, to, Box::new(value)), site))
    }
}

impl ExprKind {
    /// Returns a loop over a source.
    pub fn each(pattern: Pattern, source: Source, pass: Expr) -> ExprKind {
        let (pattern, source) = (Box::new(pattern), Box::new(source));
        let body = Block { stmts: alloc::vec![Stmt::Expr(pass)], tail: None };
        ExprKind::Each { label: None, pattern, source, bound: None, body }
    }
}

impl Pattern {
    /// Returns a pattern that binds a generated name.
    pub fn name(name: &str) -> Pattern {
        Pattern::Name { name: name.into(), slot: NO_SLOT, mutable: false, inner: None }
    }
}
