//! Magnitudes and extremes of matrices: the routine computes the value, and comparisons with it choose the derivatives.

use bessemer_ir::{CompareOp, Expr, ExprKind, Place, Routine, Type, UnaryOp};

use crate::fold;
use crate::run::Run;
use crate::value::{Tangents, Value, Word, parts};
use crate::{Problem, Result};

/// Returns the negatives of derivatives.
pub fn negative(tangents: &Tangents) -> Tangents {
    tangents.iter().map(|(variable, it)| (*variable, fold::neg(it.clone()))).collect()
}

impl Run<'_> {
    /// Returns the value of a routine whose numbers are operands, or their magnitudes.
    pub fn extreme(
        &mut self,
        routine: Routine,
        operands: Vec<(Value, Type)>,
        expr: &Expr,
    ) -> Result<Value> {
        let name = self.name.clone();
        let (mut whole, mut words) = (Vec::new(), Vec::new());
        for (value, ty) in operands {
            let value = self.held(value, &name);
            whole.push(self.whole_value(value.clone(), &ty));
            words.push(value.words(self.module));
        }
        let [first, rest @ ..] = words.as_slice() else {
            return Err(Problem::new(expr.span, "this routine has no operand", "report it"));
        };
        let kind = ExprKind::Routine(routine, whole);
        let value = self.bind(&name, Expr { kind, ty: expr.ty.clone(), span: expr.span });
        let equal =
            |value: &Expr, it: &Expr| Expr::compare(CompareOp::Eq, value.clone(), it.clone());
        if expr.ty.is_word() {
            // The first element with that magnitude.
            let mut sides = Vec::new();
            for word in first {
                let opposite = Expr::unary(UnaryOp::Neg, word.value.clone());
                sides.push((equal(&value, &word.value), word.tangents.clone()));
                sides.push((equal(&value, &opposite), negative(&word.tangents)));
            }
            let (_, last) = sides.pop().unwrap_or((value.clone(), Tangents::new()));
            let tangents = self.by_cases(&value, sides, last);
            return Ok(Value::Leaf(Word { value, tangents }));
        }
        let ExprKind::Load(place) = &value.kind else { return Ok(Value::Parts(Vec::new())) };
        let place: Place = place.clone();
        let mut elements = Vec::new();
        for (at, (step, ty)) in parts(self.module, &expr.ty, expr.span).into_iter().enumerate() {
            let element = place.inside(step, ty).load();
            let Some(one) = first.get(at) else { break };
            let other = match rest.first().and_then(|other| other.get(at)) {
                Some(other) => other.tangents.clone(),
                None => negative(&one.tangents),
            };
            let sides = vec![(equal(&element, &one.value), one.tangents.clone())];
            let tangents = self.by_cases(&element, sides, other);
            elements.push(Value::Leaf(Word { value: element, tangents }));
        }
        Ok(Value::Parts(elements))
    }
}
