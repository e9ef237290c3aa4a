//! A chain of iterators on its way to a loop: what it goes through, what each pass does, and what flows out.

use bessemer_ir::tree::{self, ALONE, ExprKind, Order, Site, UnaryOp};

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
    /// Where it stands.
    pub site: Site,
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
    /// What the second goes through in each pass of the first: `.flat_map(…)`.
    Nested(Box<Flow>, Box<Flow>),
    /// What the first goes through, then what the second does: `.chain(…)`.
    Both(Box<Flow>, Box<Flow>),
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
    /// What goes through two, as one, with the items that come of both.
    pub(super) fn of_two(over: fn(Box<Flow>, Box<Flow>) -> Over, [one, other]: [Flow; 2]) -> Flow {
        let site = one.site;
        let over = over(Box::new(one), Box::new(other));
        Flow { over, before: Vec::new(), steps: Vec::new(), item: Item::Taken, site }
    }

    /// Whether it can be a part of another: what ends one of two loops that are a part says which.
    pub(super) fn is_part(&self) -> bool {
        let ends = |step: &Step| matches!(step, Step::While(_) | Step::WhileLet(_));
        let two = matches!(self.over, Over::Nested(..) | Over::Both(..));
        !(two && self.steps.iter().any(ends))
    }

    pub(super) fn into_loop(self, last: tree::Stmt, label: Option<String>) -> ExprKind {
        self.looped(vec![last], label.as_ref(), false)
    }

    /// The loop, of which `last` is what is done with each item; `part`: its author wrote it as one with what stands around it.
    fn looped(self, last: Vec<tree::Stmt>, label: Option<&String>, part: bool) -> ExprKind {
        let (mut stmts, mut before, whole) = (last, self.before, self.site);
        let stop = || ExprKind::Break(part.then(|| ALONE.to_owned()), None);
        for step in self.steps.into_iter().rev() {
            match step {
                Step::Do(stmt) => stmts.insert(0, stmt),
                Step::While(condition) => {
                    let site = condition.site;
                    let of = |kind| tree::Expr { kind, site, slot: None };
                    let then =
                        tree::Block { stmts: vec![tree::Stmt::Expr(of(stop()))], tail: None };
                    let ended = of(ExprKind::Unary(UnaryOp::Not, Box::new(condition)));
                    let kind = ExprKind::If(Box::new(ended), then, None);
                    stmts.insert(0, tree::Stmt::Expr(of(kind)));
                }
                Step::WhileLet(condition) => {
                    let site = condition.site;
                    let of = |kind| tree::Expr { kind, site, slot: None };
                    let stop =
                        tree::Block { stmts: vec![tree::Stmt::Expr(of(stop()))], tail: None };
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
        let of = |kind| tree::Expr { kind, site: whole, slot: None };
        let joined = |kind| match part {
            true => ExprKind::Joined(Box::new(of(kind))),
            false => kind,
        };
        let kind = match self.over {
            Over::Range(range, variable) => {
                let (name, slot) = variable.unwrap_or_default();
                let body = tree::Block { stmts, tail: None };
                joined(ExprKind::For { label: label.cloned(), name, slot, range, body })
            }
            Over::Each { index, parts, order, cuts, .. } => {
                let body = tree::Block { stmts, tail: None };
                joined(ExprKind::Each { label: label.cloned(), index, parts, order, cuts, body })
            }
            Over::Nested(outer, inner) => {
                let inner = of(inner.looped(stmts, label, true));
                outer.looped(vec![tree::Stmt::Expr(inner)], label, part)
            }
            Over::Both(one, other) => {
                let parts = [(one, stmts.clone()), (other, stmts)];
                let parts = parts.map(|(flow, stmts)| of(flow.looped(stmts, label, true)));
                let stmts = parts.map(tree::Stmt::Expr).into();
                let block = tree::Block { stmts, tail: None };
                match part {
                    true => ExprKind::Block(block),
                    false => ExprKind::Labelled(CHAIN.to_owned(), block),
                }
            }
        };
        if before.is_empty() {
            return kind;
        }
        before.push(tree::Stmt::Expr(of(kind)));
        ExprKind::Block(tree::Block { stmts: before, tail: None })
    }
}

/// The label of two loops that are one.
const CHAIN: &str = "chain%";

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
