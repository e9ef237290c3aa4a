//! Limits of float values, for the integers that they are converted to.
//!
//! Meaning: a value with limits is no NaN and between them; one with [`Limits::or_nan`] may also be a NaN. Limits of a
//! symbol are true wherever it is known, since its value never changes. Sums, products and quotients have limits if
//! those of their operands are finite, so that a NaN comes of a NaN alone; their ends are rounded as the operation is.

use bessemer_ir::{BinaryOp, CompareOp, Float, Intrinsic, Type, UnaryOp};

use super::knowledge::Bounds;
use super::limits::{Limits, rounded};
use super::linear::Symbol;
use super::values::{Point, Value, Values};

impl Values<'_> {
    pub(super) fn limits(&self, value: &Value) -> Limits {
        match value {
            Value::Float(_, Some(bits)) => Limits::of([f64::from_bits(*bits)], false),
            Value::Float(symbol, None) => {
                self.limits.get(symbol).copied().unwrap_or(Limits::UNKNOWN)
            }
            _ => Limits::UNKNOWN,
        }
    }

    /// Returns the limits of a float at a point, also by the comparisons with it that hold there.
    pub(super) fn limits_here(&self, point: &Point, value: &Value) -> Limits {
        let mut limits = self.limits(value);
        let Value::Float(symbol, None) = value else { return limits };
        for (is, (op, a, b)) in &self.compared {
            let about = a != b && [a, b].contains(&symbol);
            if !about || point.knowledge.of(*is, &self.all) != (1, 1) {
                continue;
            }
            // A comparison that holds has no NaN.
            limits.or_nan = false;
            let other = |of: &Symbol| self.limits.get(of).copied().unwrap_or(Limits::UNKNOWN);
            match op {
                CompareOp::Lt if a == symbol => {
                    limits.most = limits.most.min(other(b).most.next_down())
                }
                CompareOp::Lt => limits.least = limits.least.max(other(a).least.next_up()),
                CompareOp::Le if a == symbol => limits.most = limits.most.min(other(b).most),
                CompareOp::Le => limits.least = limits.least.max(other(a).least),
                _ => {}
            }
        }
        limits
    }

    /// Adds limits to a value, if it is an unknown float.
    pub(super) fn limited(
        &mut self,
        value: Option<Value>,
        limits: Option<Limits>,
    ) -> Option<Value> {
        if let (Some(Value::Float(symbol, None)), Some(limits)) = (&value, limits) {
            self.limits.insert(*symbol, limits);
        }
        value
    }

    pub(super) fn limits_of_unary(&self, op: UnaryOp, of: &Value) -> Option<Limits> {
        (op == UnaryOp::Neg).then(|| self.limits(of).map(|end| -end))
    }

    pub(super) fn limits_of_binary(
        &self,
        op: BinaryOp,
        of: [&Value; 2],
        ty: &Type,
    ) -> Option<Limits> {
        let [a, b] = of.map(|it| self.limits(it));
        if !(a.is_finite() && b.is_finite()) {
            return None;
        }
        let by = |f: fn(f64, f64) -> f64| {
            let all = a.ends().into_iter().flat_map(|x| b.ends().map(|y| rounded(f(x, y), ty)));
            Limits::of(all, a.or_nan || b.or_nan)
        };
        match op {
            BinaryOp::Add => Some(by(|x, y| x + y)),
            BinaryOp::Sub => Some(by(|x, y| x - y)),
            BinaryOp::Mul => Some(by(|x, y| x * y)),
            BinaryOp::Div if b.least > 0.0 || b.most < 0.0 => Some(by(|x, y| x / y)),
            _ => None,
        }
    }

    pub(super) fn limits_of_intrinsic(&self, which: Intrinsic, of: &[Value]) -> Option<Limits> {
        let all: Vec<Limits> = of.iter().map(|it| self.limits(it)).collect();
        match (which, all.as_slice()) {
            // One of the two. A number is no more than any other number; a NaN leaves the choice to the other.
            (Intrinsic::Min, [a, b]) => {
                let most = match (a.or_nan, b.or_nan) {
                    (false, false) => a.most.min(b.most),
                    (false, true) => a.most,
                    (true, false) => b.most,
                    (true, true) => a.most.max(b.most),
                };
                Some(Limits { least: a.least.min(b.least), most, or_nan: a.or_nan && b.or_nan })
            }
            (Intrinsic::Max, [a, b]) => {
                let least = match (a.or_nan, b.or_nan) {
                    (false, false) => a.least.max(b.least),
                    (false, true) => a.least,
                    (true, false) => b.least,
                    (true, true) => a.least.min(b.least),
                };
                Some(Limits { least, most: a.most.max(b.most), or_nan: a.or_nan && b.or_nan })
            }
            (Intrinsic::Clamp, [x, low, high]) => {
                Some(Limits { least: low.least, most: high.most, or_nan: x.or_nan })
            }
            (Intrinsic::Floor, [x]) => Some(x.map(f64::floor)),
            (Intrinsic::Ceil, [x]) => Some(x.map(f64::ceil)),
            (Intrinsic::Trunc, [x]) => Some(x.map(f64::trunc)),
            (Intrinsic::Round, [x]) => Some(x.map(f64::round)),
            (Intrinsic::Abs, [x]) => Some(Limits { least: 0.0, ..x.map(f64::abs) }),
            _ => None,
        }
    }

    /// Returns the limits of an integer that becomes a float.
    pub(super) fn limits_of_number(bounds: Bounds, ty: &Type) -> Limits {
        let end = |number: i128| match ty.as_float() {
            Some(Float::F32) => f64::from(number as f32),
            _ => number as f64,
        };
        Limits::of([end(bounds.0), end(bounds.1)], false)
    }

    pub(super) fn limits_of_float(&self, value: &Value, ty: &Type) -> Limits {
        self.limits(value).map(|end| rounded(end, ty))
    }
}
