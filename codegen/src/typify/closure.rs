//! Methods that take closures and stand for a loop: `array.map(|x| …)`, and what a loop through an iterator gathers.
//!
//! Methods that stand for a `match` are functions of the library ([`rewrite`](super::rewrite)).

use bessemer_ir::tree::visit::{VisitMut, walk_expr_mut};
use bessemer_ir::tree::{
    self, Block, Builtin, Desugared, EACH, Expr, ExprKind, Pattern, Start, Stmt, Together,
};

use super::items::handing;
use super::lowering::Lowering;
use super::rewrite::rewritten;

impl Lowering<'_, '_> {
    /// What a call stands for; none if `expr` is something else.
    pub(super) fn in_place(&self, expr: &Expr) -> Option<Expr> {
        if let Some((rule, arguments)) = self.rule(expr) {
            return Some(rewritten(rule, arguments, expr));
        }
        let (Builtin::Desugared(method), arguments) = self.builtin_call(expr)? else { return None };
        match method {
            Desugared::Together(Together::Tried) => tried(arguments, expr),
            Desugared::Together(how) => Some(together(how, arguments.first()?, expr)),
            Desugared::ArrayMap => mapped(&arguments[0], arguments.get(1)?, expr),
            // What is lent stands where it stands.
            Desugared::AsRef | Desugared::ByRef => arguments.first().cloned(),
        }
    }
}

/// `array.map(|x| …)`: a loop that assigns each element.
fn mapped(array: &Expr, closure: &Expr, expr: &Expr) -> Option<Expr> {
    let ExprKind::Closure(closure) = &closure.kind else { return None };
    let pattern = closure.parameters.first().cloned().unwrap_or(Pattern::Any);
    let site = expr.site;
    let plain = |kind| Expr::plain(kind, site);
    let local = |name: &str| Box::new(Expr::local(name, site));
    let (name, index) = ("%mapped", "%i");
    let element = Box::new(plain(ExprKind::Index(local(name), local(index))));
    let assign = plain(ExprKind::Assign(None, element, closure.body.clone()));
    let part = tree::Part::of(pattern, array.clone(), true);
    let each = plain(ExprKind::each(Some(index), part, assign));
    Some(fold(name, Start::Elements, Box::new(each), expr))
}

/// A loop that gathers under a name, in the place of `expr`.
fn fold(name: &str, start: Start, each: Box<Expr>, expr: &Expr) -> Expr {
    let kind = ExprKind::Fold { name: name.into(), start, each };
    Expr { kind, site: expr.site, slot: expr.slot }
}

/// `items.sum()`, `items.product()`: a loop that adds each item to what it has so far, or multiplies by it.
fn together(how: Together, items: &Expr, expr: &Expr) -> Expr {
    let (name, start, op) = match how {
        Together::Product => ("%product", Start::Product, tree::BinaryOp::Mul),
        _ => ("%sum", Start::Sum, tree::BinaryOp::Add),
    };
    let mut each = handing(items).body;
    Taken(&|item| {
        let so_far = Box::new(Expr::local(name, expr.site));
        ExprKind::Assign(Some(op), so_far, Box::new(item))
    })
    .expr(&mut each);
    fold(name, start, each, expr)
}

/// `items.try_fold(start, |so_far, item| …)`: what comes of what was gathered so far and of the item, until nothing does.
fn tried(arguments: &[Expr], expr: &Expr) -> Option<Expr> {
    let [items, start, Expr { kind: ExprKind::Closure(closure), .. }] = arguments else {
        return None;
    };
    let [so_far, taken] = closure.parameters.as_slice() else { return None };
    let site = expr.site;
    let plain = |kind| Expr::plain(kind, site);
    let name = "%tried";
    let gathered = || Expr::local(name, site);
    let goes_on = |part| Box::new(Pattern::Constructor(tree::GOES_ON.into(), vec![part]));
    let stop = Stmt::Expr(plain(ExprKind::Break(None, None)));
    let stop = Block { stmts: vec![stop], tail: None };
    let apart = |pattern, value, otherwise| Stmt::Apart { pattern, value, otherwise, site };
    let mut each = handing(items).body;
    Taken(&|item| {
        let next = ExprKind::Assign(None, Box::new(gathered()), closure.body.clone());
        let stmts = vec![
            apart(goes_on(so_far.clone()), gathered(), None),
            apart(Box::new(taken.clone()), item, None),
            Stmt::Expr(plain(next)),
            apart(goes_on(Pattern::Any), gathered(), Some(stop.clone())),
        ];
        ExprKind::Block(Block { stmts, tail: None })
    })
    .expr(&mut each);
    Some(fold(name, Start::Tried(Box::new(start.clone())), each, expr))
}

/// Puts what is done with an item in the place of handing it on.
struct Taken<'f>(&'f dyn Fn(Expr) -> ExprKind);

impl VisitMut for Taken<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        match &mut expr.kind {
            ExprKind::Apply(name, items) if name == EACH => {
                if let Some(item) = items.pop() {
                    expr.kind = (self.0)(item);
                }
            }
            // What another iterator hands on.
            ExprKind::Closure(_) => {}
            _ => walk_expr_mut(self, expr),
        }
    }
}
