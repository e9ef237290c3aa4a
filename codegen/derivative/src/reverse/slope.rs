//! Slopes of operations: a bar goes to the operands, times the slope by each.

use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, FunctionId, Intrinsic, Place, Routine, UnaryOp, effects,
};

use super::{Back, Bars};
use crate::run::Run;
use crate::value::{Tangents, Value, Word};
use crate::{Problem, Result, float, fold, rules};

fn mul(a: Expr, b: Expr) -> Expr {
    Expr::binary(BinaryOp::Mul, a, b)
}

fn div(a: Expr, b: Expr) -> Expr {
    Expr::binary(BinaryOp::Div, a, b)
}

/// Returns a bar times a slope; none if it is zero.
fn scaled(bar: Expr, slope: &Expr) -> Option<Expr> {
    fold::scaled(Tangents::from([(0, bar)]), slope).remove(&0)
}

impl Run<'_> {
    /// Gives a bar of a number to its operands; `own` is the local that has the number.
    pub(super) fn push(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        expr: &Expr,
        bar: Expr,
        own: Option<&Expr>,
    ) -> Result<()> {
        if !back.active.is(expr) {
            return Ok(());
        }
        let opaque = || rules::opaque(expr);
        if expr.ty.as_float().is_none() {
            return Err(opaque());
        }
        match &expr.kind {
            ExprKind::Load(place) => {
                self.add_bar(back, bars, place, bar);
                Ok(())
            }
            ExprKind::Unary(UnaryOp::Neg, a) => self.push(back, bars, a, fold::neg(bar), None),
            ExprKind::Cast(a) => {
                let bar = bar.cast(&a.ty);
                self.push(back, bars, a, bar, None)
            }
            ExprKind::Binary(op, a, b) => {
                let same = match (&a.kind, &b.kind) {
                    (ExprKind::Load(a), ExprKind::Load(b)) => effects::same_place(a, b),
                    _ => false,
                };
                if *op == BinaryOp::Mul && same {
                    let twice = scaled(bar, &float(2.0, &expr.ty, expr.span));
                    let bar = twice.and_then(|twice| scaled(twice, a));
                    return match bar {
                        Some(bar) => self.push(back, bars, a, bar, None),
                        None => Ok(()),
                    };
                }
                let both = back.active.is(a) && back.active.is(b);
                let bar = if both { self.atom(bar, "bar") } else { bar };
                let (left, right) = match op {
                    BinaryOp::Add => (Some(bar.clone()), Some(bar)),
                    BinaryOp::Sub => (Some(bar.clone()), Some(fold::neg(bar))),
                    BinaryOp::Mul => (scaled(bar.clone(), b), scaled(bar, a)),
                    BinaryOp::Div => {
                        let part = div(bar, (**b).clone());
                        let part = if both { self.atom(part, "bar") } else { part };
                        let of = own.filter(|_| back.active.is(b));
                        let right = of.map(|own| fold::neg(mul(own.clone(), part.clone())));
                        (Some(part), right)
                    }
                    BinaryOp::Rem => {
                        let quotient = div((**a).clone(), (**b).clone());
                        let whole = Expr::intrinsic(Intrinsic::Trunc, vec![quotient]);
                        (Some(bar.clone()), Some(fold::neg(mul(whole, bar))))
                    }
                    _ => return Err(opaque()),
                };
                for (operand, bar) in [(a, left), (b, right)] {
                    if let Some(bar) = bar {
                        self.push(back, bars, operand, bar, None)?;
                    }
                }
                Ok(())
            }
            ExprKind::Intrinsic(Intrinsic::Sqrt, all) => {
                let (Some(own), [a]) = (own, all.as_slice()) else { return Err(opaque()) };
                let two = float(2.0, &expr.ty, expr.span);
                let bar = div(bar, mul(two, own.clone()));
                self.push(back, bars, a, bar, None)
            }
            ExprKind::Intrinsic(op, all) => {
                use Intrinsic::*;
                let operands = self.units(back, all);
                let slopes = match (op, own) {
                    (Abs | Min | Max | Clamp | Copysign, Some(own)) => {
                        self.name = "slope".to_owned();
                        self.selected(*op, own, &operands)
                    }
                    (RemEuclid, _) if operands[1].tangents.is_empty() => {
                        operands[0].tangents.clone()
                    }
                    _ => return Err(opaque()),
                };
                self.along_slopes(back, bars, all, bar, slopes)
            }
            ExprKind::Routine(Routine::Amax | Routine::Amin, operands) => {
                let (Some(own), [operand]) = (own, operands.as_slice()) else {
                    return Err(opaque());
                };
                let all = self.elements_of(operand);
                let units = self.units(back, &all);
                self.name = "slope".to_owned();
                let slopes = self.of_magnitude(own, &units);
                self.along_slopes(back, bars, &all, bar, slopes)
            }
            ExprKind::Call(callee, arguments) => {
                self.call_backwards(back, bars, (*callee, arguments), bar, expr)
            }
            _ => Err(opaque()),
        }
    }

    /// Returns the elements of a matrix.
    pub(super) fn elements_of(&self, matrix: &Expr) -> Vec<Expr> {
        match &matrix.kind {
            ExprKind::Matrix(all) => all.clone(),
            ExprKind::Load(place) => {
                let words = Value::Place(place.clone()).words(self.module);
                words.into_iter().map(|word| word.value).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Gives bars of the elements of a matrix to the chosen elements: each is an element of `one` or of `other`.
    pub(super) fn elements_backwards(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        place: &Place,
        [one, other]: [&Expr; 2],
        each: Vec<Option<Expr>>,
    ) -> Result<()> {
        let own = Value::Place(place.clone()).words(self.module);
        let pairs = self.elements_of(one).into_iter().zip(self.elements_of(other));
        for ((own, bar), (one, other)) in own.into_iter().zip(each).zip(pairs) {
            let Some(bar) = bar else { continue };
            let both = [one, other];
            let units = self.units(back, &both);
            self.name = "slope".to_owned();
            let slopes = self.of_element(&own.value, &units[0], units[1].tangents.clone());
            self.along_slopes(back, bars, &both, bar, slopes)?;
        }
        Ok(())
    }

    /// Returns operands whose derivatives are those by themselves.
    fn units(&self, back: &Back, all: &[Expr]) -> Vec<Word> {
        let unit = |(index, value): (usize, &Expr)| {
            let one = float(1.0, &value.ty, value.span);
            let tangents = match back.active.is(value) {
                true => Tangents::from([(index as u32, one)]),
                false => Tangents::new(),
            };
            Word { value: value.clone(), tangents }
        };
        all.iter().enumerate().map(unit).collect()
    }

    /// Gives a bar to operands, times their slopes.
    fn along_slopes(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        all: &[Expr],
        bar: Expr,
        slopes: Tangents,
    ) -> Result<()> {
        let bar = if slopes.len() > 1 { self.atom(bar, "bar") } else { bar };
        for (index, slope) in slopes {
            if let (Some(operand), Some(bar)) =
                (all.get(index as usize), scaled(bar.clone(), &slope))
            {
                self.push(back, bars, operand, bar, None)?;
            }
        }
        Ok(())
    }

    /// Gives a bar of a value of an elementary function to its operands.
    fn call_backwards(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        (callee, arguments): (FunctionId, &[Argument]),
        bar: Expr,
        expr: &Expr,
    ) -> Result<()> {
        let values = arguments.iter().filter_map(|it| match it {
            Argument::Value(value) | Argument::Ref(value) => Some(value.clone()),
            Argument::RefMut(_) => None,
        });
        let values: Vec<Expr> = values.collect();
        let name = self.function_of(callee).name.clone();
        let operands = self.units(back, &values);
        self.name = "slope".to_owned();
        match self.elementary_function(&name, operands, expr)? {
            Some(Value::Leaf(word)) => self.along_slopes(back, bars, &values, bar, word.tangents),
            _ => Err(Problem::new(
                expr.span,
                format!("`{name}` has no gradient"),
                "differentiate a function that computes without it",
            )),
        }
    }
}
