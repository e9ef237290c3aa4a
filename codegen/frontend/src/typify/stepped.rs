//! Ranges as sequences, such as `(a..b).step_by(n)`: the number of passes, and the number of each pass.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Fault, Int, Intrinsic, Scalar, Type};

use super::Result;
use super::lengths;
use super::lowering::Lowering;

/// A range with an end: its first number, its step and its passes.
pub(super) struct Steps {
    from: Expr,
    step: Expr,
    passes: Expr,
    /// True if no number can overflow its type.
    constant: bool,
    /// True if the numbers decrease.
    down: bool,
    ty: Type,
}

/// A range without an end.
pub(super) struct Numbers {
    pub site: Site,
    pub first: Expr,
    pub int: Int,
    /// True if no pass can reach the last number of the type.
    pub calm: bool,
}

impl Numbers {
    /// Records that at most `most` numbers are requested.
    pub(super) fn calm(&mut self, most: Option<u64>) {
        let ExprKind::Literal(word) = self.first.kind else { return };
        // No slice is longer than half of all that has an address.
        let most = i128::from(most.unwrap_or(1 << 63));
        self.calm |= self.int.from_word(word) + most < self.int.max();
    }
}

impl Lowering<'_, '_> {
    /// Returns the steps of a range with an end; each has length `step`, or 1. With `down` it begins at the last
    /// number.
    pub(super) fn steps(
        &mut self,
        (range, down): (&tree::Range, bool),
        step: Option<&tree::Expr>,
        (int, ty): (Int, &Type),
    ) -> Result<Steps> {
        let [from, to] = self.ends(range, ty, range.from.site)?;
        if down {
            let to = self.once("end", to);
            let last = match range.inclusive {
                true => to.clone(),
                false => Expr::intrinsic(
                    Intrinsic::WrappingSub,
                    vec![to.clone(), Expr::literal_like(1, &to)],
                ),
            };
            let up = self.steps_up((range.inclusive, step), [from, to], (int, ty))?;
            let from = last.cast(&up.from.ty);
            return Ok(Steps { from, down, constant: false, ..up });
        }
        self.steps_up((range.inclusive, step), [from, to], (int, ty))
    }

    fn steps_up(
        &mut self,
        (inclusive, step): (bool, Option<&tree::Expr>),
        [from, to]: [Expr; 2],
        (int, ty): (Int, &Type),
    ) -> Result<Steps> {
        let one = tree::Expr::plain(tree::ExprKind::Int("1".into(), None), Site::default());
        let step = step.unwrap_or(&one);
        // The ends are read before the step is computed, which may change what they are.
        let [from, to] = match step.kind {
            tree::ExprKind::Int(..) | tree::ExprKind::Path(..) | tree::ExprKind::Local(_) => {
                [from, to]
            }
            _ => [self.once("start", from), self.once("end", to)],
        };
        let step = self.value(step, Some(&Type::USIZE))?;
        let by = self.known(&step).filter(|by| (1..=u64::from(u16::MAX)).contains(by));
        let by = by.filter(|by| i128::from(*by) <= int.max());
        if let (Some(by), Some(first), Some(last)) = (by, self.known(&from), self.known(&to)) {
            let (first, last) = (int.from_word(first), int.from_word(last));
            let end = last + i128::from(inclusive);
            let passes = ((end - first).max(0) + i128::from(by) - 1) / i128::from(by);
            // All numbers of a type are one more than it counts to; those of 64 bits nobody comes to the end of.
            let constant = (int.min() == 0 || passes == 0 || first >= 0) && passes <= int.max();
            let from = if constant { from } else { from.cast(&Type::USIZE) };
            let passes = passes.min(i128::from(u64::MAX)) as u64;
            let [step, passes] = [by, passes].map(|word| Expr::literal_like(word, &from));
            return Ok(Steps { from, step, passes, constant, down: false, ty: ty.clone() });
        }
        let (from, step, passes) = match by.filter(|by| int.min() == 0 && !(inclusive && *by == 1))
        {
            Some(by) => self.unsigned_steps(inclusive, [from, to], by),
            None => self.any_steps(int, inclusive, [from, to], step),
        };
        Ok(Steps { from, step, passes, constant: false, down: false, ty: ty.clone() })
    }

    /// Returns the word of a number that is constant in this generation.
    pub(super) fn known(&self, expr: &Expr) -> Option<u64> {
        match &expr.kind {
            ExprKind::Literal(word) => Some(*word),
            ExprKind::Const(id) => self.cx.module.consts[id.index()].words.first().copied(),
            _ => None,
        }
    }

    /// Evaluates an end once.
    fn once(&mut self, role: &str, end: Expr) -> Expr {
        self.atom(role, end)
    }

    /// Returns first number, step and passes for a constant step through unsigned numbers. The counter has their
    /// type.
    fn unsigned_steps(
        &mut self,
        inclusive: bool,
        [from, to]: [Expr; 2],
        by: u64,
    ) -> (Expr, Expr, Expr) {
        let step = Expr::literal_like(by, &from);
        let held = self.once("start", from);
        let from_zero = held.kind == ExprKind::Literal(0);
        // The last number that there may be is one more than those behind the steps.
        let last = inclusive.then(|| self.atom("last", to.clone()));
        let to = last.clone().unwrap_or(to);
        let length = distance(&held, to);
        let length = if inclusive && from_zero { length } else { self.atom("length", length) };
        // A step of at least 2 leaves room for the last number, and a step of 1 no rest: this cannot leave the type.
        let more = last.map(|last| match from_zero {
            true => Expr::literal_like(1, &held),
            false => Expr::compare(CompareOp::Le, held.clone(), last),
        });
        let passes = self.passes_of(length, &step, more, Intrinsic::WrappingAdd);
        (held, step, passes)
    }

    /// Returns first number, step and passes for any step through any numbers. The counter is a `usize`.
    fn any_steps(
        &mut self,
        int: Int,
        inclusive: bool,
        [from, to]: [Expr; 2],
        step: Expr,
    ) -> (Expr, Expr, Expr) {
        let [from, to] = [self.once("start", from), self.once("end", to)];
        let span = step.span;
        let step = self.once("step", step);
        let there = Expr::compare(CompareOp::Ne, step.clone(), Expr::literal_like(0, &step));
        self.check(there, Fault::Assertion, span);
        let length = match int {
            Int::U64 | Int::Usize => {
                let [first, last] = [&from, &to].map(|end| end.clone().cast(&Type::USIZE));
                distance(&first, last)
            }
            // What lies between two numbers of 64 bits with a sign fits without it.
            Int::I64 | Int::Isize => {
                let last = Expr::intrinsic(Intrinsic::Max, vec![from.clone(), to.clone()]);
                let [first, last] = [from.clone(), last].map(|end| end.cast(&Type::USIZE));
                Expr::intrinsic(Intrinsic::WrappingSub, vec![last, first])
            }
            // Both ends and their difference fit.
            _ => {
                let wide = Type::Scalar(Scalar::Int(Int::I64));
                let [first, last] = [&from, &to].map(|end| end.clone().cast(&wide));
                let length = Expr::binary(BinaryOp::Sub, last, first);
                let none = Expr::literal_like(0, &length);
                Expr::intrinsic(Intrinsic::Max, vec![length, none]).cast(&Type::USIZE)
            }
        };
        let length = self.atom("length", length);
        let more = inclusive.then(|| Expr::compare(CompareOp::Le, from.clone(), to));
        // All numbers of 64 bits are one more than `usize` counts to, and nobody gets that far.
        let add = match int.bits() {
            64 if inclusive => Intrinsic::SaturatingAdd,
            _ => Intrinsic::WrappingAdd,
        };
        let passes = self.passes_of(length, &step, more, add);
        (from.cast(&Type::USIZE), step, passes)
    }

    /// Returns the number of steps in a length, plus `more`; without `more`, plus one if the length leaves a
    /// remainder.
    fn passes_of(&mut self, length: Expr, step: &Expr, more: Option<Expr>, add: Intrinsic) -> Expr {
        let [whole, rest] =
            [BinaryOp::Div, BinaryOp::Rem].map(|op| Expr::binary(op, length.clone(), step.clone()));
        if step.kind == ExprKind::Literal(1) && more.is_none() {
            return length;
        }
        let none = Expr::literal_like(0, &rest);
        let more = more.unwrap_or_else(|| Expr::compare(CompareOp::Ne, rest, none));
        let more = more.cast(&whole.ty);
        self.atom("passes", Expr::intrinsic(add, vec![whole, more]))
    }
}

/// Returns the distance between two numbers, 0 if the second is less.
fn distance(from: &Expr, to: Expr) -> Expr {
    match from.kind {
        ExprKind::Literal(0) => to,
        _ => Expr::intrinsic(Intrinsic::SaturatingSub, vec![to, from.clone()]),
    }
}

impl Steps {
    /// Returns the bounds of the loop's counter.
    pub(super) fn ends(&self) -> [Expr; 2] {
        [Expr::literal_like(0, &self.passes), self.passes.clone()]
    }

    /// Returns the number of items.
    pub(super) fn count(&self) -> Expr {
        match lengths::number(&self.passes) {
            Some(passes) => Expr::usize(passes, self.passes.span),
            None => self.passes.clone().cast(&Type::USIZE),
        }
    }

    /// Returns the number of a pass.
    pub(super) fn number(&self, pass: Expr) -> Expr {
        let (from, step, ty) = (self.from.clone(), self.step.clone(), &self.ty);
        let pass = pass.cast(&self.passes.ty);
        let from_zero = from.kind == ExprKind::Literal(0);
        let way = match step.kind {
            ExprKind::Literal(1) => pass,
            _ if self.constant => Expr::binary(BinaryOp::Mul, pass, step),
            _ => Expr::intrinsic(Intrinsic::WrappingMul, vec![pass, step]),
        };
        let number = match (from_zero, self.constant) {
            _ if self.down => Expr::intrinsic(Intrinsic::WrappingSub, vec![from, way]),
            (true, _) => way,
            (false, true) => Expr::binary(BinaryOp::Add, from, way),
            (false, false) => Expr::intrinsic(Intrinsic::WrappingAdd, vec![from, way]),
        };
        number.cast(ty)
    }
}
