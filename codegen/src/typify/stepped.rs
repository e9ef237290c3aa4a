//! `for i in (a..b).step_by(n)`: a loop over its passes, and the number of each.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Fault, Int, Intrinsic, Local, LocalId, Mode, Place,
    Scalar, StmtKind, Type,
};

use super::function::Lowering;
use super::{OUR_FAULT, Result, problem};

/// Where a stepped range begins, and what it takes to get on.
struct Steps {
    from: Expr,
    step: Expr,
    passes: Expr,
    /// Whether no number can leave its type.
    constant: bool,
}

impl Lowering<'_, '_> {
    pub(super) fn stepped(
        &mut self,
        site: Site,
        label: Option<&str>,
        (name, ty): (&str, Type),
        range: &tree::Range,
        bounds: [Expr; 2],
        body: &tree::Block,
    ) -> Result<()> {
        let span = self.span(site);
        let Some(int) = ty.as_int() else {
            return problem(site, "only integers are stepped through", OUR_FAULT);
        };
        // What it takes to get on is named for the number.
        let naming = std::mem::replace(&mut self.naming, name.into());
        let steps = self.steps(site, int, range, bounds);
        self.naming = naming;
        let steps = steps?;
        self.repeated(label, None, span, |inner| {
            let pass = LocalId(inner.locals.len() as u32);
            let passes = steps.passes.clone();
            let counted = passes.ty.clone();
            let local = Local { name: "pass".into(), ty: counted, mode: Mode::Value, span };
            inner.locals.push(local);
            let body = inner.scoped(|inner| {
                let place = Place { root: pass, steps: Vec::new(), ty: passes.ty.clone(), span };
                let pass = Expr { kind: ExprKind::Load(place), ty: passes.ty.clone(), span };
                let variable = inner.declare(name, ty.clone(), Mode::Value, span);
                let value = Some(number(&steps, pass, &ty));
                inner.emit(StmtKind::Let { local: variable, value }, span);
                inner.statements(body)
            })?;
            let from = Expr { kind: ExprKind::Literal(0), ..passes.clone() };
            let reversed = range.reversed;
            Ok(StmtKind::For {
                variable: pass,
                from,
                to: passes,
                inclusive: false,
                reversed,
                unroll: None,
                ended: false,
                body,
            })
        })
    }

    fn steps(
        &mut self,
        site: Site,
        int: Int,
        range: &tree::Range,
        [from, to]: [Expr; 2],
    ) -> Result<Steps> {
        let Some(step) = &range.step else {
            return problem(site, "this range has no step", OUR_FAULT);
        };
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
        let Some(by) = by else {
            return Ok(self.any_steps(int, range.inclusive, [from, to], step));
        };
        if let (Some(first), Some(last)) = (self.known(&from), self.known(&to)) {
            let (first, last) = (int.from_word(first), int.from_word(last));
            let end = last + i128::from(range.inclusive);
            let passes = ((end - first).max(0) + i128::from(by) - 1) / i128::from(by);
            if int.min() == 0 || passes == 0 || first >= 0 {
                let [step, passes] = [by, passes as u64].map(|word| literal(word, &from));
                return Ok(Steps { from, step, passes, constant: true });
            }
            let from = as_number(from, &Type::USIZE);
            let [step, passes] = [by, passes as u64].map(|word| literal(word, &from));
            return Ok(Steps { from, step, passes, constant: false });
        }
        if int.min() < 0 || range.inclusive && by == 1 {
            return Ok(self.any_steps(int, range.inclusive, [from, to], step));
        }
        Ok(self.unsigned_steps(range.inclusive, [from, to], by))
    }

    /// The word of a number that generation knows.
    fn known(&self, expr: &Expr) -> Option<u64> {
        match &expr.kind {
            ExprKind::Literal(word) => Some(*word),
            ExprKind::Const(id) => self.cx.module.consts[id.index()].words.first().copied(),
            _ => None,
        }
    }

    /// An end that is computed once.
    fn once(&mut self, role: &str, end: Expr) -> Expr {
        match end.kind {
            ExprKind::Literal(_) => end,
            _ => self.temporary(role, end),
        }
    }

    /// Steps of a constant through unsigned numbers, which count the passes, too.
    fn unsigned_steps(&mut self, inclusive: bool, [from, to]: [Expr; 2], by: u64) -> Steps {
        let step = literal(by, &from);
        let held = self.once("start", from);
        let from_zero = held.kind == ExprKind::Literal(0);
        // The last number that there may be is one more than those behind the steps.
        let last = inclusive.then(|| self.temporary("last", to.clone()));
        let to = last.clone().unwrap_or(to);
        let length = match from_zero {
            true => to,
            false => intrinsic(Intrinsic::SaturatingSub, to, held.clone()),
        };
        let length = match (&last, from_zero) {
            (Some(_), true) => length,
            _ => self.temporary("length", length),
        };
        let whole = binary(BinaryOp::Div, length.clone(), step.clone());
        let more = match last {
            // A step of at least 2 leaves room for it.
            Some(_) if from_zero => literal(1, &held),
            Some(last) => as_number(compare(CompareOp::Le, held.clone(), last), &held.ty),
            // A step of 1 leaves no rest, so this cannot leave the type.
            None => {
                let rest = binary(BinaryOp::Rem, length, step.clone());
                let none = literal(0, &rest);
                as_number(compare(CompareOp::Ne, rest, none), &held.ty)
            }
        };
        let passes = self.temporary("passes", intrinsic(Intrinsic::WrappingAdd, whole, more));
        Steps { from: held, step, passes, constant: false }
    }

    /// Any steps through any numbers: `usize` counts the passes.
    fn any_steps(&mut self, int: Int, inclusive: bool, [from, to]: [Expr; 2], step: Expr) -> Steps {
        let [from, to] = [self.once("start", from), self.once("end", to)];
        let span = step.span;
        let step = self.once("step", step);
        let there = compare(CompareOp::Ne, step.clone(), literal(0, &step));
        self.emit(StmtKind::Check { condition: there, fault: Fault::Assertion }, span);
        let wide = int.bits() == 64;
        let length = match int {
            Int::U64 | Int::Usize => {
                let [first, last] = [&from, &to].map(|end| as_number(end.clone(), &Type::USIZE));
                match first.kind {
                    ExprKind::Literal(0) => last,
                    _ => intrinsic(Intrinsic::SaturatingSub, last, first),
                }
            }
            // What lies between two numbers of 64 bits with a sign fits without it.
            Int::I64 | Int::Isize => {
                let last = intrinsic(Intrinsic::Max, from.clone(), to.clone());
                let [first, last] = [from.clone(), last].map(|end| as_number(end, &Type::USIZE));
                intrinsic(Intrinsic::WrappingSub, last, first)
            }
            // Both ends and their difference fit.
            _ => {
                let wide = Type::Scalar(Scalar::Int(Int::I64));
                let [first, last] = [&from, &to].map(|end| as_number(end.clone(), &wide));
                let length = binary(BinaryOp::Sub, last, first);
                let none = literal(0, &length);
                as_number(intrinsic(Intrinsic::Max, length, none), &Type::USIZE)
            }
        };
        let length = match length.kind {
            ExprKind::Load(_) => length,
            _ => self.temporary("length", length),
        };
        let whole = binary(BinaryOp::Div, length.clone(), step.clone());
        let more = match inclusive {
            true => compare(CompareOp::Le, from.clone(), to),
            false => {
                let rest = binary(BinaryOp::Rem, length, step.clone());
                let none = literal(0, &rest);
                compare(CompareOp::Ne, rest, none)
            }
        };
        let more = as_number(more, &Type::USIZE);
        // All numbers of 64 bits are one more than `usize` counts to, and nobody gets that far.
        let add = if wide && inclusive { Intrinsic::SaturatingAdd } else { Intrinsic::WrappingAdd };
        let passes = self.temporary("passes", intrinsic(add, whole, more));
        Steps { from: as_number(from, &Type::USIZE), step, passes, constant: false }
    }
}

fn literal(word: u64, like: &Expr) -> Expr {
    Expr { kind: ExprKind::Literal(word), ty: like.ty.clone(), span: like.span }
}

fn intrinsic(op: Intrinsic, left: Expr, right: Expr) -> Expr {
    let (ty, span) = (left.ty.clone(), left.span);
    Expr { kind: ExprKind::Intrinsic(op, vec![left, right]), ty, span }
}

fn binary(op: BinaryOp, left: Expr, right: Expr) -> Expr {
    let (ty, span) = (left.ty.clone(), left.span);
    Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), ty, span }
}

fn compare(op: CompareOp, left: Expr, right: Expr) -> Expr {
    let span = left.span;
    Expr { kind: ExprKind::Compare(op, Box::new(left), Box::new(right)), ty: Type::BOOL, span }
}

/// A number, or a condition, as a number of another type.
fn as_number(expr: Expr, ty: &Type) -> Expr {
    if expr.ty == *ty {
        return expr;
    }
    let span = expr.span;
    Expr { kind: ExprKind::Cast(Box::new(expr)), ty: ty.clone(), span }
}

/// The number of a pass.
fn number(steps: &Steps, pass: Expr, ty: &Type) -> Expr {
    let (from, step) = (steps.from.clone(), steps.step.clone());
    let from_zero = from.kind == ExprKind::Literal(0);
    if !steps.constant {
        let way = intrinsic(Intrinsic::WrappingMul, pass, step);
        let number = if from_zero { way } else { intrinsic(Intrinsic::WrappingAdd, from, way) };
        return as_number(number, ty);
    }
    let way = match step.kind {
        ExprKind::Literal(1) => pass,
        _ => binary(BinaryOp::Mul, pass, step),
    };
    if from_zero { way } else { binary(BinaryOp::Add, from, way) }
}
