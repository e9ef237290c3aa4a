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
            let numbers = value.clone().words(self.module);
            whole.push(match self.backwards {
                true => self.aggregate(&ty, numbers.iter().map(|word| word.value.clone())),
                false => self.whole_value(value, &ty),
            });
            words.push(numbers);
        }
        let [first, rest @ ..] = words.as_slice() else {
            return Err(Problem::new(expr.span, "this routine has no operand", "report it"));
        };
        let kind = ExprKind::Routine(routine, whole);
        let value = self.bind(&name, Expr { kind, ty: expr.ty.clone(), span: expr.span });
        if expr.ty.is_word() {
            let tangents = match self.backwards {
                true => Tangents::new(),
                false => self.of_magnitude(&value, first),
            };
            return Ok(Value::Leaf(Word { value, tangents }));
        }
        let ExprKind::Load(place) = &value.kind else { return Ok(Value::Parts(Vec::new())) };
        if self.backwards {
            return Ok(Value::at(place.clone()));
        }
        let place: Place = place.clone();
        let mut elements = Vec::new();
        for (at, (step, ty)) in parts(self.module, &expr.ty, expr.span).into_iter().enumerate() {
            let element = place.inside(step, ty).load();
            let Some(one) = first.get(at) else { break };
            let other = match rest.first().and_then(|other| other.get(at)) {
                Some(other) => other.tangents.clone(),
                None => negative(&one.tangents),
            };
            let tangents = self.of_element(&element, one, other);
            elements.push(Value::Leaf(Word { value: element, tangents }));
        }
        Ok(Value::Parts(elements))
    }

    /// Returns the derivatives of the magnitude of one of these numbers: of the first with that magnitude.
    pub fn of_magnitude(&mut self, value: &Expr, numbers: &[Word]) -> Tangents {
        let mut sides = Vec::new();
        for word in numbers {
            let opposite = Expr::unary(UnaryOp::Neg, word.value.clone());
            sides.push((equal(value, &word.value), word.tangents.clone()));
            sides.push((equal(value, &opposite), negative(&word.tangents)));
        }
        let (_, last) = sides.pop().unwrap_or((value.clone(), Tangents::new()));
        self.by_cases(value, sides, last)
    }

    /// Returns the derivatives of a number that is `one` or another one.
    pub fn of_element(&mut self, value: &Expr, one: &Word, other: Tangents) -> Tangents {
        let sides = vec![(equal(value, &one.value), one.tangents.clone())];
        self.by_cases(value, sides, other)
    }
}

fn equal(value: &Expr, it: &Expr) -> Expr {
    Expr::compare(CompareOp::Eq, value.clone(), it.clone())
}
