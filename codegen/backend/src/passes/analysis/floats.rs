//! Bounds of a float expression, which its conversion to an integer needs.
//!
//! Meaning: in every execution, the value is between the bounds or, if it [may be one](Bounds::nan), a NaN. Every
//! operation here is monotone, and so is rounding, so the bounds of its result come from those of its operands.
//! Places have no bounds: only what one expression says counts.

use bessemer_ir::{BinaryOp, Expr, ExprKind, Int, Intrinsic, Type, UnaryOp};

use super::domain::Interval;
use super::state::State;
use bessemer_ir::used::Rule;

/// The bounds of a float.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: f64,
    high: f64,
    /// True if it may be a NaN.
    nan: bool,
}

const ANY: Bounds = Bounds { low: f64::NEG_INFINITY, high: f64::INFINITY, nan: true };

impl Bounds {
    fn each(self, of: impl Fn(f64) -> f64) -> Bounds {
        Bounds { low: of(self.low), high: of(self.high), ..self }
    }

    /// Returns the bounds of the smaller of two numbers; a NaN is ignored.
    fn smaller(self, other: Bounds) -> Bounds {
        let (a, b) = (self, other);
        let alone = |one: Bounds, is: bool| if is { one.high } else { f64::NEG_INFINITY };
        let high = a.high.min(b.high).max(alone(a, b.nan)).max(alone(b, a.nan));
        Bounds { low: a.low.min(b.low), high, nan: a.nan && b.nan }
    }

    /// Returns the bounds of the larger of two numbers.
    fn larger(self, other: Bounds) -> Bounds {
        self.opposite().smaller(other.opposite()).opposite()
    }

    fn opposite(self) -> Bounds {
        Bounds { low: -self.high, high: -self.low, nan: self.nan }
    }
}

impl State<'_> {
    /// Returns the bounds of a float that is converted to an integer: outside of its range the nearest integer, for a
    /// NaN 0.
    pub(super) fn converted(&self, x: &Expr, to: Int) -> Interval {
        let all = self.bounds(x);
        // The conversion saturates, and so does the one of a bound.
        let whole = |bound: f64| (bound as i128).clamp(to.min(), to.max());
        let (low, high) = (whole(all.low), whole(all.high));
        let range = Interval::new(low, high);
        let range = if all.nan { range.join(Interval::one(0)) } else { range };
        if range != Interval::of(to) {
            Rule::Float.used();
        }
        range
    }

    fn bounds(&self, expr: &Expr) -> Bounds {
        let Type::Scalar(_) = expr.ty else { return ANY };
        if let Some(value) = self.float(expr) {
            return Bounds { low: value, high: value, nan: false };
        }
        let single = expr.ty.as_float() == Some(bessemer_ir::Float::F32);
        let rounded = |value: f64| if single { f64::from(value as f32) } else { value };
        let float = |number: i128| if single { f64::from(number as f32) } else { number as f64 };
        match &expr.kind {
            ExprKind::Unary(UnaryOp::Neg, x) => self.bounds(x).opposite(),
            ExprKind::Cast(x) => match self.number(x) {
                Some(Interval { low, high }) => {
                    Bounds { low: float(low), high: float(high), nan: false }
                }
                None if x.ty.as_float().is_some() => self.bounds(x).each(rounded),
                None => ANY,
            },
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Mul, by, x)
                if self.float(by).is_some() && self.float(x).is_none() =>
            {
                let kind = match expr.kind {
                    ExprKind::Binary(op, ..) => ExprKind::Binary(op, x.clone(), by.clone()),
                    _ => return ANY,
                };
                self.bounds(&Expr { kind, ..expr.clone() })
            }
            ExprKind::Binary(op, x, by) => match self.float(by) {
                Some(by) if by.is_finite() => match op {
                    BinaryOp::Add => self.bounds(x).each(|bound| rounded(bound + by)),
                    BinaryOp::Sub => self.bounds(x).each(|bound| rounded(bound - by)),
                    BinaryOp::Mul if by > 0.0 => self.bounds(x).each(|bound| rounded(bound * by)),
                    BinaryOp::Div if by > 0.0 => self.bounds(x).each(|bound| rounded(bound / by)),
                    _ => ANY,
                },
                _ => ANY,
            },
            ExprKind::Intrinsic(which, of) => match (which, of.as_slice()) {
                (Intrinsic::Min, [a, b]) => self.bounds(a).smaller(self.bounds(b)),
                (Intrinsic::Max, [a, b]) => self.bounds(a).larger(self.bounds(b)),
                (Intrinsic::Clamp, [x, low, high]) => {
                    let (low, high) = (self.bounds(low), self.bounds(high));
                    Bounds { low: low.low, high: high.high, nan: self.bounds(x).nan }
                }
                (Intrinsic::Floor, [x]) => self.bounds(x).each(f64::floor),
                (Intrinsic::Ceil, [x]) => self.bounds(x).each(f64::ceil),
                (Intrinsic::Trunc, [x]) => self.bounds(x).each(f64::trunc),
                (Intrinsic::Round, [x]) => self.bounds(x).each(f64::round),
                (Intrinsic::Abs, [_]) => Bounds { low: 0.0, ..ANY },
                _ => ANY,
            },
            _ => ANY,
        }
    }
}
