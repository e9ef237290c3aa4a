//! Lowers loops that accumulate: sums, products, folds, and arrays filled element by element, `array.map(|x| …)`.
//! Methods that are such loops become loops of the tree.
//!
//! Methods that are equivalent to a `match` are functions of the library ([`rewrite`](super::rewrite)).

use bessemer_ir::tree::visit::{VisitMut, walk_expr_mut};
use bessemer_ir::tree::{
    self, Builtin, Desugared, EACH, ExprKind as Tree, Pattern, Source, Start, Together,
};
use bessemer_ir::{Expr, LocalId, Scalar, StmtKind, Type};

use super::items::handing;
use super::lowering::Lowering;
use super::numbers::float;
use super::rewrite::rewritten;
use super::value::Value;
use super::{Needed, OUR_FAULT, Result, problem, refusals, refused};

impl Lowering<'_, '_> {
    /// Returns the equivalent expression for a call that has one; none for any other expression.
    pub(super) fn in_place(&mut self, expr: &tree::Expr) -> Option<tree::Expr> {
        if let Some(next) = self.own_next_called(expr) {
            return Some(next);
        }
        if let Some((rule, arguments)) = self.rule(expr) {
            return Some(rewritten(rule, &self.written_out(arguments), expr));
        }
        let (Builtin::Desugared(method), arguments) = self.builtin_call(expr)? else { return None };
        let arguments = self.written_out(arguments);
        let (first, rest) = arguments.split_first()?;
        match method {
            Desugared::Together(Together::Tried) => tried(first, rest, expr),
            Desugared::Together(how) => {
                Some(together(how, first, expr, self.operator(expr.slot).is_some()))
            }
            Desugared::ArrayMap => mapped(first, rest.first()?, expr),
            Desugared::FromFn => from_fn(first, expr),
            // A reference stays in its place.
            Desugared::AsRef | Desugared::ByRef => Some(first.clone()),
        }
    }

    /// Lowers an accumulating loop, and returns the local with the result. The local has the author's name if
    /// `called` is one.
    pub(super) fn lower_fold(
        &mut self,
        expr: &tree::Expr,
        called: Option<&str>,
    ) -> Result<LocalId> {
        let Tree::Fold { name, start, each } = &expr.kind else {
            return problem(expr.site, "this gathers nothing", OUR_FAULT);
        };
        let (ty, span) = (self.slot_of(expr)?, self.span(expr.site));
        let local = self.local(called.unwrap_or(name), ty.clone(), span);
        self.naming_scope(|inner| {
            let mut each = each.clone();
            let value = match start {
                Start::Tried(value) => {
                    // Rust creates the iterator before it computes what to begin with.
                    inner.create_items(&mut each)?;
                    inner.goes_on(value, expr)?
                }
                Start::Sum => inner.neutral(0.0, &ty, expr)?,
                Start::Product => inner.neutral(1.0, &ty, expr)?,
                // Every element is assigned; that is shown to the validator by a value before.
                Start::Elements => inner.zero(&ty, span),
            };
            inner.emit(StmtKind::Let { local, value: Some(value) }, span);
            inner.bind(name, Value::Local(local));
            inner.effect(&each)
        })?;
        Ok(local)
    }

    /// Lowers `Some(value)`, or `Ok(value)`, for the result type of a `try_fold`.
    fn goes_on(&mut self, value: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let case = match self.slot_of(expr)? {
            Type::Struct(id) => self.going_on(id),
            _ => None,
        };
        let case = case.or_refused(expr.site, refusals::TRY_FOLD)?;
        let kind = Tree::Constructor(case.to_owned(), vec![value.clone()]);
        self.value(&tree::Expr { kind, site: value.site, slot: expr.slot }, None)
    }

    /// Returns the neutral element that a sum or a product begins with. A sum of matrices or complex numbers begins
    /// with zeros, as in nalgebra.
    fn neutral(&mut self, number: f64, ty: &Type, expr: &tree::Expr) -> Result<Expr> {
        let of_zeros = matches!(ty, Type::Matrix { .. }) || self.operator(expr.slot).is_some();
        if of_zeros && number == 0.0 {
            let span = self.span(expr.site);
            return Ok(self.zero(ty, span));
        }
        // Rust's empty sum of floats is -0, which adds nothing to anything.
        let double = if number == 0.0 { -0.0 } else { number };
        let span = self.span(expr.site);
        match ty {
            Type::Scalar(Scalar::Float(_)) => Ok(float(double, double as f32, ty, span)),
            Type::Scalar(Scalar::Int(_)) => Ok(Expr::literal(number as u64, ty.clone(), span)),
            _ => refused(expr.site, refusals::SUMMED),
        }
    }
}

/// Rewrites `array.map(|x| …)` as a loop that assigns each element.
fn mapped(array: &tree::Expr, closure: &tree::Expr, expr: &tree::Expr) -> Option<tree::Expr> {
    let Tree::Closure(closure) = &closure.kind else { return None };
    let pattern = closure.parameters.first().cloned().unwrap_or(Pattern::Any);
    let elements = (pattern, Source::Elements(array.clone(), true));
    Some(filled(("%mapped", "%i"), elements, &closure.body, expr))
}

/// Rewrites `core::array::from_fn(|i| …)` as a loop that assigns each element.
fn from_fn(closure: &tree::Expr, expr: &tree::Expr) -> Option<tree::Expr> {
    let Tree::Closure(closure) = &closure.kind else { return None };
    let index = match closure.parameters.as_slice() {
        [Pattern::Name { name, mutable: false, inner: None, .. }] => name,
        [Pattern::Any] => "%i",
        _ => return None,
    };
    let elements = Source::Elements(tree::Expr::local("%elements", expr.site), false);
    Some(filled(("%elements", index), (Pattern::Any, elements), &closure.body, expr))
}

/// Returns a loop that assigns each element of an array; `name` and `index` name the array and the index.
fn filled(
    (name, index): (&str, &str),
    (pattern, elements): (Pattern, Source),
    value: &tree::Expr,
    expr: &tree::Expr,
) -> tree::Expr {
    let plain = |kind| tree::Expr::plain(kind, expr.site);
    let local = |name: &str| Box::new(tree::Expr::local(name, expr.site));
    let element = Box::new(plain(Tree::Index(local(name), local(index))));
    let assign = plain(Tree::Assign(None, element, Box::new(value.clone())));
    let pair = Pattern::Tuple(vec![Pattern::name(index), pattern]);
    let source = Source::Enumerate(Box::new(elements));
    let each = Box::new(plain(Tree::each(pair, source, assign)));
    let kind = Tree::Fold { name: name.into(), start: Start::Elements, each };
    tree::Expr { kind, ..*expr }
}

/// Rewrites `items.sum()` and `items.product()` as a loop. With `by_function`, the operator is an author's function.
fn together(how: Together, items: &tree::Expr, expr: &tree::Expr, by_function: bool) -> tree::Expr {
    let (name, start, op) = match how {
        Together::Product => ("%product", Start::Product, tree::BinaryOp::Mul),
        _ => ("%sum", Start::Sum, tree::BinaryOp::Add),
    };
    gathered(items, (name, start), expr, &|so_far, item| {
        let (so_far, item) = (Box::new(so_far), Box::new(item));
        if !by_function {
            return Tree::Assign(Some(op), so_far, item);
        }
        let kind = Tree::Binary(op, so_far.clone(), item);
        Tree::Assign(None, so_far, Box::new(tree::Expr { kind, ..*expr }))
    })
}

/// Rewrites `items.try_fold(start, |so_far, item| …)` as a loop that ends at the first `None` or `Err`.
fn tried(items: &tree::Expr, rest: &[tree::Expr], expr: &tree::Expr) -> Option<tree::Expr> {
    let [start, tree::Expr { kind: Tree::Closure(closure), .. }] = rest else { return None };
    let [so_far, taken] = closure.parameters.as_slice() else { return None };
    let site = expr.site;
    let plain = |kind| tree::Stmt::Expr(tree::Expr::plain(kind, site));
    let goes_on = |part| Box::new(Pattern::Constructor(tree::GOES_ON.into(), vec![part]));
    let stop = tree::Block { stmts: vec![plain(Tree::Break(None, None))], tail: None };
    let split = |pattern, value, otherwise| tree::Stmt::Apart { pattern, value, otherwise, site };
    let start = ("%tried", Start::Tried(Box::new(start.clone())));
    Some(gathered(items, start, expr, &|gathered, item| {
        let next = Tree::Assign(None, Box::new(gathered.clone()), closure.body.clone());
        let stmts = vec![
            split(goes_on(so_far.clone()), gathered.clone(), None),
            split(Box::new(taken.clone()), item, None),
            plain(next),
            split(goes_on(Pattern::Any), gathered, Some(stop.clone())),
        ];
        Tree::Block(tree::Block { stmts, tail: None })
    }))
}

/// Returns an accumulating loop in place of `expr`: `pass` computes the new value from the accumulator and an item.
fn gathered(
    items: &tree::Expr,
    (name, start): (&str, Start),
    expr: &tree::Expr,
    pass: &dyn Fn(tree::Expr, tree::Expr) -> Tree,
) -> tree::Expr {
    let mut each = handing(items).body;
    Taken(&|item| pass(tree::Expr::local(name, expr.site), item)).expr(&mut each);
    let kind = Tree::Fold { name: name.into(), start, each };
    tree::Expr { kind, ..*expr }
}

/// Replaces the yield of an item by an operation on the item.
struct Taken<'f>(&'f dyn Fn(tree::Expr) -> Tree);

impl VisitMut for Taken<'_> {
    fn expr(&mut self, expr: &mut tree::Expr) {
        match &mut expr.kind {
            Tree::Apply(name, items) if name == EACH => {
                if let Some(item) = items.pop() {
                    expr.kind = (self.0)(item);
                }
            }
            // What another iterator hands on.
            Tree::Closure(_) => {}
            _ => walk_expr_mut(self, expr),
        }
    }
}
