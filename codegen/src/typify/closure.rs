//! Methods that take closures and stand for a loop: `array.map(|x| …)`, and what a loop through an iterator gathers.
//!
//! Methods that stand for a `match` are functions of the library ([`rewrite`](super::rewrite)).

use bessemer_ir::tree::{
    self, Block, Builtin, Desugared, Expr, ExprKind, Gather, NO_SLOT, Pattern, Start, Stmt,
};

use super::lowering::Lowering;
use super::rewrite::rewritten;

/// A name that no author can write.
const PAYLOAD: &str = "%value";

impl Lowering<'_, '_> {
    /// What a call stands for; none if `expr` is something else.
    pub(super) fn in_place(&self, expr: &Expr) -> Option<Expr> {
        if let Some((rule, arguments)) = self.rule(expr) {
            return Some(rewritten(rule, arguments, expr));
        }
        let (Builtin::Desugared(method), arguments) = self.builtin_call(expr)? else { return None };
        match method {
            Desugared::Gather(end) => ended(end, arguments.first()?, expr),
            Desugared::ArrayMap => mapped(&arguments[0], arguments.get(1)?, expr),
            // What is lent stands where it stands.
            Desugared::AsRef => arguments.first().cloned(),
        }
    }
}

/// The closure's parameter, and its body.
fn parts(closure: &Expr) -> Option<(Pattern, &Expr)> {
    match &closure.kind {
        ExprKind::Closure(it) => {
            Some((it.parameters.first().cloned().unwrap_or(Pattern::Any), &it.body))
        }
        _ => None,
    }
}

fn named() -> Pattern {
    Pattern::Name { name: PAYLOAD.into(), slot: NO_SLOT, mutable: false, inner: None }
}

/// `array.map(|x| …)`: a loop that assigns each element.
fn mapped(array: &Expr, closure: &Expr, expr: &Expr) -> Option<Expr> {
    let (pattern, value) = parts(closure)?;
    let site = expr.site;
    let plain = |kind| Expr { kind, site, slot: None };
    let local = |name: &str| Box::new(plain(ExprKind::Local(name.into())));
    let (name, index) = ("%mapped", "%i");
    let element = Box::new(plain(ExprKind::Index(local(name), local(index))));
    let assign = plain(ExprKind::Assign(None, element, Box::new(value.clone())));
    let each = plain(ExprKind::Each {
        label: None,
        index: Some(index.into()),
        parts: vec![tree::Part {
            pattern,
            array: array.clone(),
            owned: true,
            group: None,
            reversed: false,
        }],
        order: tree::Order::Up,
        cuts: Vec::new(),
        body: Block { stmts: vec![Stmt::Expr(assign)], tail: None },
    });
    let kind = ExprKind::Fold { name: name.into(), start: Start::Elements, each: Box::new(each) };
    Some(Expr { kind, site, slot: expr.slot })
}

/// `items.next()`, `items.last()`, `items.count()`, `items.sum()` of what a function gives: a loop that keeps, counts or
/// adds up what comes.
fn ended(end: Gather, items: &Expr, expr: &Expr) -> Option<Expr> {
    let (site, slot) = (expr.site, expr.slot);
    let of = |kind, slot| Expr { kind, site, slot };
    let plain = |kind| Expr { kind, site, slot: None };
    let begun = |value| Start::Value(Box::new(value));
    let first = end == Gather::Next;
    let item = plain(ExprKind::Local(PAYLOAD.into()));
    let (name, pattern, start, op, value) = match end {
        Gather::Sum => ("%sum", named(), Start::Sum, Some(tree::BinaryOp::Add), item),
        Gather::Product => ("%product", named(), Start::Product, Some(tree::BinaryOp::Mul), item),
        Gather::Count => {
            let number = |digits: &str| {
                let size = Some(bessemer_ir::Scalar::Int(bessemer_ir::Int::Usize));
                plain(ExprKind::Int(digits.into(), size))
            };
            ("%count", Pattern::Any, begun(number("0")), Some(tree::BinaryOp::Add), number("1"))
        }
        Gather::Next | Gather::Last => {
            let option = |case: &str, parts| of(ExprKind::Constructor(case.into(), parts), slot);
            (
                if first { "%next" } else { "%last" },
                named(),
                begun(option("None", Vec::new())),
                None,
                option("Some", vec![item]),
            )
        }
    };
    let kept = Box::new(plain(ExprKind::Local(name.into())));
    let mut stmts = vec![Stmt::Expr(plain(ExprKind::Assign(op, kept, Box::new(value))))];
    if first {
        stmts.push(Stmt::Expr(plain(ExprKind::Break(None, None))));
    }
    let part =
        tree::Part { pattern, array: items.clone(), owned: false, group: None, reversed: false };
    let each = plain(ExprKind::Each {
        label: None,
        index: None,
        parts: vec![part],
        order: tree::Order::Up,
        cuts: Vec::new(),
        body: Block { stmts, tail: None },
    });
    let kind = ExprKind::Fold { name: name.into(), start, each: Box::new(each) };
    Some(Expr { kind, site, slot })
}
