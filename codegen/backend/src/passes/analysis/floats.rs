//! Bounds of floats, which their conversion to integers needs.
//!
//! Meaning: in every execution, the value is between the bounds or, if it [may be one](Bounds::nan), a NaN. Every
//! operation here is monotone, and so is rounding, so the bounds of its result come from those of its operands.

use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Float, Int, Intrinsic, UnaryOp};

use super::bounds::Bounds;
use super::domain::Interval;
use super::known::Known;
use super::state::{State, key};
use bessemer_ir::used::Rule;

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

    /// Narrows both sides of a comparison of floats that holds; so neither is a NaN.
    pub(super) fn order_floats(&mut self, op: CompareOp, a: &Expr, b: &Expr) {
        let (x, y) = (self.bounds(a), self.bounds(b));
        let (below, above) = match op {
            CompareOp::Lt => (y.high.next_down(), x.low.next_up()),
            CompareOp::Le => (y.high, x.low),
            CompareOp::Gt => return self.order_floats(CompareOp::Lt, b, a),
            CompareOp::Ge => return self.order_floats(CompareOp::Le, b, a),
            CompareOp::Eq => {
                let both = (x.low.max(y.low), x.high.min(y.high));
                self.narrow(a, both);
                return self.narrow(b, both);
            }
            CompareOp::Ne => return,
        };
        self.narrow(a, (x.low, x.high.min(below)));
        self.narrow(b, (y.low.max(above), y.high));
    }

    /// Records that a float is a number from `low` to `high`.
    fn narrow(&mut self, expr: &Expr, (low, high): (f64, f64)) {
        match &expr.kind {
            ExprKind::Load(place) => {
                let Some(key) = key(place).filter(|_| self.float(expr).is_none()) else { return };
                let known = Bounds { low, high, nan: false };
                self.known.insert(key, Known::Between(known));
            }
            ExprKind::Intrinsic(Intrinsic::Abs, of) => {
                let Some(x) = of.first() else { return };
                let of = self.bounds(x);
                self.narrow(x, (of.low.max(-high), of.high.min(high)));
            }
            _ => {}
        }
    }

    /// Returns the bounds of a float.
    pub(super) fn bounds(&self, expr: &Expr) -> Bounds {
        let Some(float) = expr.ty.as_float() else { return Bounds::ANY };
        if let Some(value) = self.float(expr) {
            return Bounds::one(value);
        }
        let single = float == Float::F32;
        let rounded = |value: f64| if single { f64::from(value as f32) } else { value };
        let float = |number: i128| if single { f64::from(number as f32) } else { number as f64 };
        match &expr.kind {
            ExprKind::Load(place) => {
                let known = key(place).and_then(|key| self.known.get(&key));
                known.and_then(|known| known.bounds()).unwrap_or(Bounds::ANY)
            }
            ExprKind::Unary(UnaryOp::Neg, x) => self.bounds(x).opposite(),
            ExprKind::Cast(x) => match self.number(x) {
                Some(Interval { low, high }) => {
                    Bounds { low: float(low), high: float(high), nan: false }
                }
                None if x.ty.as_float().is_some() => self.bounds(x).each(rounded),
                None => Bounds::ANY,
            },
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Mul, by, x)
                if self.float(by).is_some() && self.float(x).is_none() =>
            {
                let kind = match expr.kind {
                    ExprKind::Binary(op, ..) => ExprKind::Binary(op, x.clone(), by.clone()),
                    _ => return Bounds::ANY,
                };
                self.bounds(&Expr { kind, ..expr.clone() })
            }
            ExprKind::Binary(op, x, by) => match self.float(by) {
                Some(by) if by.is_finite() => match op {
                    BinaryOp::Add => self.bounds(x).each(|bound| rounded(bound + by)),
                    BinaryOp::Sub => self.bounds(x).each(|bound| rounded(bound - by)),
                    BinaryOp::Mul if by > 0.0 => self.bounds(x).each(|bound| rounded(bound * by)),
                    BinaryOp::Div if by > 0.0 => self.bounds(x).each(|bound| rounded(bound / by)),
                    _ => Bounds::ANY,
                },
                _ => self.between_corners(*op, (x, by), rounded),
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
                (Intrinsic::Abs, [_]) => Bounds { low: 0.0, ..Bounds::ANY },
                _ => Bounds::ANY,
            },
            _ => Bounds::ANY,
        }
    }

    /// Returns the bounds of an operation on two floats, if those of its operands are finite.
    fn between_corners(
        &self,
        op: BinaryOp,
        (a, b): (&Expr, &Expr),
        rounded: impl Fn(f64) -> f64,
    ) -> Bounds {
        let (x, y) = (self.bounds(a), self.bounds(b));
        let by = match op {
            BinaryOp::Add => |x: f64, y: f64| x + y,
            BinaryOp::Sub => |x: f64, y: f64| x - y,
            BinaryOp::Mul => |x: f64, y: f64| x * y,
            BinaryOp::Div if y.low > 0.0 || y.high < 0.0 => |x: f64, y: f64| x / y,
            _ => return Bounds::ANY,
        };
        if !(x.is_finite() && y.is_finite()) {
            return Bounds::ANY;
        }
        let nan = x.nan || y.nan;
        let corners = [(x.low, y.low), (x.low, y.high), (x.high, y.low), (x.high, y.high)];
        let corners = corners.map(|(x, y)| Bounds { nan, ..Bounds::one(rounded(by(x, y))) });
        corners.into_iter().fold(corners[0], Bounds::join)
    }
}
