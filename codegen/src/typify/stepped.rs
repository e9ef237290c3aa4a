//! `for i in (a..b).step_by(n)`: a loop over its passes, and the number of each.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Int, Intrinsic, Local, LocalId, Mode, Place, StmtKind,
    Type,
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
        let steps = self.steps(site, int, range, bounds)?;
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
        let step = match &range.step {
            Some(step) => self.value(step, Some(&Type::USIZE))?,
            None => return problem(site, "this range has no step", OUR_FAULT),
        };
        let span = from.span;
        let number = |expr: &Expr| match &expr.kind {
            ExprKind::Literal(word) => Some(*word),
            ExprKind::Const(id) => self.cx.module.consts[id.index()].words.first().copied(),
            _ => None,
        };
        let Some(by) = number(&step).filter(|by| *by > 0 && *by <= u64::from(u16::MAX)) else {
            return problem(
                site,
                "the step of a range is a number in the DSL, from 1 to 65535",
                "write `.step_by(2)`, or the name of a constant",
            );
        };
        let ty = from.ty.clone();
        let literal =
            |word: u64, ty: &Type| Expr { kind: ExprKind::Literal(word), ty: ty.clone(), span };
        let step = literal(by, &ty);
        if by as i128 > int.max() {
            return problem(site, "this step is beyond the type of the range", "use a wider type");
        }
        if let (Some(first), Some(last)) = (number(&from), number(&to)) {
            let (first, last) = (int.from_word(first), int.from_word(last));
            let end = last + i128::from(range.inclusive);
            let passes = ((end - first).max(0) + i128::from(by) - 1) / i128::from(by);
            let passes = literal(passes as u64, &ty);
            if int.min() == 0 || passes.kind == ExprKind::Literal(0) || first >= 0 {
                return Ok(Steps { from, step, passes, constant: true });
            }
        }
        if int.min() < 0 || range.inclusive && by == 1 {
            return problem(
                site,
                "a stepped range has constant ends, or unsigned ones",
                "write `for k in 0..passes`, and compute the number from `k`",
            );
        }
        let held = match from.kind {
            ExprKind::Literal(_) => from,
            _ => self.temporary("start", from),
        };
        let intrinsic = |op, a: Expr, b: Expr| Expr {
            kind: ExprKind::Intrinsic(op, vec![a, b]),
            ty: ty.clone(),
            span,
        };
        let binary = |op, a: Expr, b: Expr| Expr {
            kind: ExprKind::Binary(op, Box::new(a), Box::new(b)),
            ty: ty.clone(),
            span,
        };
        let from_zero = held.kind == ExprKind::Literal(0);
        // The last number that there may be is one more than those behind the steps.
        let last = range.inclusive.then(|| self.temporary("last", to.clone()));
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
        if let Some(last) = last {
            let begins = ExprKind::Compare(CompareOp::Le, Box::new(held.clone()), Box::new(last));
            let begins = Expr { kind: begins, ty: Type::BOOL, span };
            let begins = Expr { kind: ExprKind::Cast(Box::new(begins)), ty: ty.clone(), span };
            let begins = if from_zero { literal(1, &ty) } else { begins };
            // A step of at least 2 leaves room for it.
            let passes = intrinsic(Intrinsic::WrappingAdd, whole, begins);
            let passes = self.temporary("passes", passes);
            return Ok(Steps { from: held, step, passes, constant: false });
        }
        let rest = binary(BinaryOp::Rem, length, step.clone());
        let more = ExprKind::Compare(CompareOp::Ne, Box::new(rest), Box::new(literal(0, &ty)));
        let more = Expr { kind: more, ty: Type::BOOL, span };
        let more = Expr { kind: ExprKind::Cast(Box::new(more)), ty: ty.clone(), span };
        // A step of 1 leaves no rest, so this cannot leave the type.
        let passes = intrinsic(Intrinsic::WrappingAdd, whole, more);
        let passes = self.temporary("passes", passes);
        Ok(Steps { from: held, step, passes, constant: false })
    }
}

/// The number of a pass.
fn number(steps: &Steps, pass: Expr, ty: &Type) -> Expr {
    let span = pass.span;
    let node = |kind| Expr { kind, ty: ty.clone(), span };
    let (from, step) = (steps.from.clone(), steps.step.clone());
    if !steps.constant {
        let way = node(ExprKind::Intrinsic(Intrinsic::WrappingMul, vec![pass, step]));
        return match from.kind {
            ExprKind::Literal(0) => way,
            _ => node(ExprKind::Intrinsic(Intrinsic::WrappingAdd, vec![from, way])),
        };
    }
    let way = match step.kind {
        ExprKind::Literal(1) => pass,
        _ => node(ExprKind::Binary(BinaryOp::Mul, Box::new(pass), Box::new(step))),
    };
    match from.kind {
        ExprKind::Literal(0) => way,
        _ => node(ExprKind::Binary(BinaryOp::Add, Box::new(from), Box::new(way))),
    }
}
