//! A chain of iterators on its way to a loop: what it goes through, what each pass does, and what flows out.

use bessemer_ir::tree::{self, ExprKind, Order, UnaryOp};

/// The sequence of a loop.
pub(super) enum Source {
    One { array: Box<tree::Expr>, owned: bool, group: Option<tree::Group>, reversed: bool },
    Zip(Box<Source>, Box<Source>),
}

/// A chain so far.
pub(super) struct Flow {
    /// The sequence of the loop.
    pub over: Over,
    /// The declarations before it.
    pub before: Vec<tree::Stmt>,
    /// The work of each pass before the end, in order.
    pub steps: Vec<Step>,
    /// Its items.
    pub item: Item,
}

/// How a closure takes the items of a chain.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Takes {
    Items,
    /// By reference: `filter`, `find`.
    References,
}

pub(super) enum Over {
    Range(Box<tree::Range>, Option<(String, u32)>),
    Each {
        index: Option<String>,
        parts: Vec<tree::Part>,
        indexed: bool,
        order: Order,
        cuts: Vec<tree::Cut>,
    },
}

pub(super) enum Step {
    Do(tree::Stmt),
    If(tree::Expr),
    /// The loop ends where this does not hold.
    While(tree::Expr),
    /// The same of what names something.
    WhileLet(tree::Expr),
}

pub(super) enum Item {
    /// Elements that have no name yet.
    Source(Source),
    /// The number of a range.
    Number,
    /// A local.
    Named(String),
    /// Two that have names.
    Pair(Box<Item>, Box<Item>),
    /// A value.
    Value(tree::Expr),
    /// The content, if there is one.
    Optional(tree::Expr),
    /// The same, up to the first in which nothing is.
    Leading(tree::Expr),
    /// Nothing that could be named again.
    Taken,
}

impl Flow {
    pub(super) fn into_loop(self, last: tree::Stmt, label: Option<String>) -> ExprKind {
        let mut stmts = vec![last];
        let mut before = self.before;
        for step in self.steps.into_iter().rev() {
            match step {
                Step::Do(stmt) => stmts.insert(0, stmt),
                Step::While(condition) => {
                    let site = condition.site;
                    let of = |kind| tree::Expr { kind, site, slot: None };
                    let stop = tree::Stmt::Expr(of(ExprKind::Break(None, None)));
                    let then = tree::Block { stmts: vec![stop], tail: None };
                    let ended = of(ExprKind::Unary(UnaryOp::Not, Box::new(condition)));
                    let kind = ExprKind::If(Box::new(ended), then, None);
                    stmts.insert(0, tree::Stmt::Expr(of(kind)));
                }
                Step::WhileLet(condition) => {
                    let site = condition.site;
                    let of = |kind| tree::Expr { kind, site, slot: None };
                    let stop = tree::Stmt::Expr(of(ExprKind::Break(None, None)));
                    let stop = tree::Block { stmts: vec![stop], tail: None };
                    let (then, stop) = (tree::Block { stmts, tail: None }, ExprKind::Block(stop));
                    let kind = ExprKind::If(Box::new(condition), then, Some(Box::new(of(stop))));
                    stmts = vec![tree::Stmt::Expr(of(kind))];
                }
                Step::If(condition) => {
                    let (site, then) = (condition.site, tree::Block { stmts, tail: None });
                    let kind = ExprKind::If(Box::new(condition), then, None);
                    stmts = vec![tree::Stmt::Expr(tree::Expr { kind, site, slot: None })];
                }
            }
        }
        let body = tree::Block { stmts, tail: None };
        let kind = match self.over {
            Over::Range(range, variable) => {
                let (name, slot) = variable.unwrap_or_default();
                ExprKind::For { label, name, slot, range, body }
            }
            Over::Each { index, parts, order, cuts, .. } => {
                ExprKind::Each { label, index, parts, order, cuts, body }
            }
        };
        let Some(tree::Stmt::Let { site, .. }) = before.last() else { return kind };
        let whole = tree::Expr { kind, site: *site, slot: None };
        before.push(tree::Stmt::Expr(whole));
        ExprKind::Block(tree::Block { stmts: before, tail: None })
    }
}

/// `let Some(pattern) = value`, as a condition.
pub(super) fn there(pattern: tree::Pattern, value: tree::Expr) -> tree::Expr {
    let (site, pattern) = (value.site, tree::Pattern::Constructor("Some".into(), vec![pattern]));
    let kind = ExprKind::Let(Box::new(pattern), Box::new(value));
    tree::Expr { kind, site, slot: None }
}

/// The name of the elements, and the slot of their type.
pub(super) fn named_by(part: &tree::Part) -> Option<(&String, u32)> {
    match &part.pattern {
        tree::Pattern::Name { name, slot, inner: None, .. } => Some((name, *slot)),
        _ => None,
    }
}
