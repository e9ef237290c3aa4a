//! Prints pairs of statements or of conditions as one, as an author writes them, and numbers by their names.

use bessemer_ir::{Argument, CompareOp, Expr, ExprKind, LocalId, StmtKind, Type};

use super::{CAST, LOWEST, Printer};
use crate::rules::MATH;
use crate::run::placeless;

/// Constants of Rust that Clippy wants by their names.
pub(super) const CONSTANTS: [(f64, &str); 8] = [
    (core::f64::consts::PI, "PI"),
    (core::f64::consts::TAU, "TAU"),
    (core::f64::consts::FRAC_PI_2, "FRAC_PI_2"),
    (core::f64::consts::LN_2, "LN_2"),
    (core::f64::consts::LN_10, "LN_10"),
    (core::f64::consts::E, "E"),
    (core::f64::consts::SQRT_2, "SQRT_2"),
    (core::f64::consts::FRAC_1_SQRT_2, "FRAC_1_SQRT_2"),
];

impl Printer<'_> {
    /// Returns the declaration of the sine and the cosine of one angle together. Both have the bits of each alone, and need one
    /// reduction of the angle.
    pub(super) fn sine_and_cosine(&mut self, one: &StmtKind, other: &StmtKind) -> Option<String> {
        let (first, of_first, angle) = self.sine_or_cosine(one)?;
        let (second, of_second, same) = self.sine_or_cosine(other)?;
        let (sine, cosine) = match (of_first, of_second) {
            ("sin", "cos") => (first, second),
            ("cos", "sin") => (second, first),
            _ => return None,
        };
        let is_changed = |local: &LocalId| {
            self.assigned.whole.contains(local) || self.assigned.parts.contains(local)
        };
        if placeless(angle.clone()) != placeless(same.clone())
            || is_changed(&first)
            || is_changed(&second)
        {
            return None;
        }
        // `sin_roll` and `cos_roll` are `sin_cos_roll.0` and `.1`, so that the C has a name for them, too.
        let name = |local: LocalId| self.function.local(local).name.as_str();
        let both = format!("sin_cos{}", name(sine).strip_prefix("sin")?);
        if self.function.locals.iter().any(|local| local.name == both) {
            return None;
        }
        let text = format!("let {both} = {}.sin_cos();", self.receiver(angle));
        self.parts.insert(sine, format!("{both}.0"));
        self.parts.insert(cosine, format!("{both}.1"));
        Some(text)
    }

    /// Returns the local that a statement declares as a sine or a cosine, the name of the function and the angle.
    fn sine_or_cosine<'s>(&self, kind: &'s StmtKind) -> Option<(LocalId, &'static str, &'s Expr)> {
        let StmtKind::Let { local, value: Some(value) } = kind else { return None };
        let ExprKind::Call(callee, arguments) = &value.kind else { return None };
        let [Argument::Value(angle)] = arguments.as_slice() else { return None };
        let callee = &self.module.functions[callee.index()];
        let name = match (callee.name.as_str(), &callee.result) {
            ("sin", &Type::F64) | ("sinf", &Type::F32) => "sin",
            ("cos", &Type::F64) | ("cosf", &Type::F32) => "cos",
            _ => return None,
        };
        (callee.module == MATH).then_some((*local, name, angle))
    }

    /// Returns the test of a number by a range, if these are its two conditions.
    pub(super) fn within(&self, a: &Expr, b: &Expr) -> Option<String> {
        let (
            ExprKind::Compare(CompareOp::Le, start, number),
            ExprKind::Compare(CompareOp::Lt, same, end),
        ) = (&a.kind, &b.kind)
        else {
            return None;
        };
        let is_one = placeless((**number).clone()) == placeless((**same).clone());
        (is_one && matches!(number.kind, ExprKind::Load(_))).then(|| {
            let (start, end) = (self.expr(start, CAST), self.expr(end, CAST));
            format!("({start}..{end}).contains(&{})", self.expr(number, LOWEST))
        })
    }
}

/// Returns the name of a number that has no literal.
pub(super) fn special(value: f64, ty: &str) -> String {
    match (value.is_nan(), value > 0.0) {
        (true, _) => format!("{ty}::NAN"),
        (false, true) => format!("{ty}::INFINITY"),
        (false, false) => format!("{ty}::NEG_INFINITY"),
    }
}
