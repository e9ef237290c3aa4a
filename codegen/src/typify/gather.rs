//! Loops that gather: sums, products and folds, and arrays that are filled element by element.

use bessemer_ir::tree::{self, Start};
use bessemer_ir::{Expr, ExprKind, Float, LocalId, Scalar, Stmt, StmtKind, Type};

use super::lowering::Lowering;
use super::order::{is_free, is_settled};
use super::value::Value;
use super::words;
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    /// The local that holds what is gathered in the end; called as the author calls it, if he does.
    pub(super) fn fold(&mut self, expr: &tree::Expr, called: Option<&str>) -> Result<LocalId> {
        let tree::ExprKind::Fold { name, start, each } = &expr.kind else {
            return problem(expr.site, "this gathers nothing", OUR_FAULT);
        };
        let (ty, span) = (self.slot_of(expr)?, self.span(expr.site));
        let mark = self.out.len();
        let value = match start {
            Start::Value(value) => {
                let value = self.value(value, Some(&ty))?;
                self.agree(&value.ty, &ty, expr.site)?;
                Some(value)
            }
            Start::Tried(value) => Some(self.goes_on(value, expr)?),
            Start::Sum => Some(self.neutral(0.0, &ty, expr)?),
            Start::Product => Some(self.neutral(1.0, &ty, expr)?),
            // Every element is assigned; that is shown to the validator by a value before.
            Start::Elements => Some(self.zero(&ty, span)),
        };
        let local = self.local(called.unwrap_or(name), ty, span);
        self.emit(StmtKind::Let { local, value }, span);
        let begun = self.later(mark);
        self.naming_scope(|inner| {
            inner.bind(name, Value::Local(local));
            inner.effect(each)
        })?;
        let mut source = self.later(mark);
        let passes = source.iter().position(|stmt| matches!(stmt.kind, StmtKind::For { .. }));
        // Where a block stands around the loop, what begins it may not be parted from it.
        let mut passes = source.split_off(passes.unwrap_or(0));
        self.out.extend(source);
        if !beginning(&begun).is_some_and(is_free) {
            self.settle_bounds(passes.first_mut());
        }
        // Rust looks for what is gathered before it computes what to begin with.
        let source = self.later(mark);
        let is_first = |value: &Expr| is_settled(value, &source);
        match source.is_empty() || beginning(&begun).is_some_and(is_first) {
            true => self.out.extend(begun.into_iter().chain(source)),
            false => self.out.extend(source.into_iter().chain(begun)),
        }
        self.out.extend(passes);
        Ok(local)
    }

    /// `Some(value)`, or `Ok(value)`.
    fn goes_on(&mut self, value: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let case = match self.slot_of(expr)? {
            Type::Struct(id) => self.going_on(id),
            _ => None,
        };
        let Some(case) = case else {
            return problem(
                expr.site,
                "a `try_fold` gives an `Option` or a `Result` in the DSL",
                "let its closure give one",
            );
        };
        let kind = tree::ExprKind::Constructor(case.to_owned(), vec![value.clone()]);
        self.value(&tree::Expr { kind, site: value.site, slot: expr.slot }, None)
    }

    /// Computes the bounds of a loop that may fault.
    fn settle_bounds(&mut self, passes: Option<&mut Stmt>) {
        let Some(Stmt { kind: StmtKind::For { from, to, .. }, .. }) = passes else { return };
        for (bound, role) in [from, to].into_iter().zip(words::BOUNDS) {
            if !is_free(bound) {
                *bound = self.temporary(role, bound.clone());
            }
        }
    }

    /// The number that a sum or a product begins with; nalgebra's sum of matrices with zeros.
    fn neutral(&mut self, number: f64, ty: &Type, expr: &tree::Expr) -> Result<Expr> {
        if matches!(ty, Type::Matrix { .. }) && number == 0.0 {
            let span = self.span(expr.site);
            return Ok(self.zero(ty, span));
        }
        // Rust's empty sum of floats is -0, which adds nothing to anything.
        let float = if number == 0.0 { -0.0 } else { number };
        let word = match ty {
            Type::Scalar(Scalar::Float(Float::F64)) => float.to_bits(),
            Type::Scalar(Scalar::Float(Float::F32)) => u64::from((float as f32).to_bits()),
            Type::Scalar(Scalar::Int(_)) => number as u64,
            _ => {
                return problem(
                    expr.site,
                    "only numbers and matrices are summed up in the DSL",
                    "use `fold`",
                );
            }
        };
        self.node(ExprKind::Literal(word), ty.clone(), expr.site)
    }
}

/// The initial value of a fold, if that is one value.
fn beginning(begun: &[Stmt]) -> Option<&Expr> {
    match begun {
        [Stmt { kind: StmtKind::Let { value: Some(value), .. }, .. }] => Some(value),
        _ => None,
    }
}
