//! What a loop gathers: sums, products and folds, and arrays that are filled element by element.

use bessemer_ir::tree::{self, Start};
use bessemer_ir::{Expr, ExprKind, Float, Local, LocalId, Mode, Scalar, StmtKind, Type};

use super::function::{Binding, Lowering};
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    /// The local that holds what is gathered in the end; called as the author calls it, if he does.
    pub(super) fn fold(&mut self, expr: &tree::Expr, called: Option<&str>) -> Result<LocalId> {
        let tree::ExprKind::Fold { name, start, each } = &expr.kind else {
            return problem(expr.site, "this gathers nothing", OUR_FAULT);
        };
        let (ty, span) = (self.slot_of(expr)?, self.span(expr.site));
        let value = match start {
            Start::Value(value) => {
                let value = self.value(value, Some(&ty))?;
                self.agree(&value.ty, &ty, expr.site)?;
                Some(value)
            }
            Start::Sum => Some(self.neutral(0.0, &ty, expr)?),
            Start::Product => Some(self.neutral(1.0, &ty, expr)?),
            // Every element is assigned; that is shown to the validator by a value before.
            Start::Elements => Some(self.zero(&ty, span)),
        };
        let local = LocalId(self.locals.len() as u32);
        let shown = called.unwrap_or(name).to_owned();
        self.locals.push(Local { name: shown, ty, mode: Mode::Value, span });
        self.emit(StmtKind::Let { local, value }, span);
        self.naming_scope(|inner| {
            inner.bind(name, Binding::Local(local));
            inner.effect(each)
        })?;
        Ok(local)
    }

    /// The number that a sum or a product begins with.
    fn neutral(&mut self, number: f64, ty: &Type, expr: &tree::Expr) -> Result<Expr> {
        // Rust's empty sum of floats is -0, which adds nothing to anything.
        let float = if number == 0.0 { -0.0 } else { number };
        let word = match ty {
            Type::Scalar(Scalar::Float(Float::F64)) => float.to_bits(),
            Type::Scalar(Scalar::Float(Float::F32)) => u64::from((float as f32).to_bits()),
            Type::Scalar(Scalar::Int(_)) => number as u64,
            _ => return problem(expr.site, "only numbers are summed up in the DSL", "use `fold`"),
        };
        self.node(ExprKind::Literal(word), ty.clone(), expr.site)
    }
}
