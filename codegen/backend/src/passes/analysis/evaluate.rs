//! Evaluates expressions to intervals, or to constant floats.
//!
//! Meaning: in every execution of the state in which the expression does not fault, its value is in the interval.

use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Intrinsic, LogicOp, Scalar, Type, UnaryOp,
};

use super::domain::Interval;
use super::known::{BROUGHT, Known};
use super::state::{Key, State, key};

impl State<'_> {
    /// Returns the range of an integer, `bool` or enum; meaningless for other types.
    pub(crate) fn range(&self, expr: &Expr) -> Interval {
        let all = self.all(&expr.ty).unwrap_or(Interval::new(i128::MIN, i128::MAX));
        self.result(expr, all)
    }

    fn result(&self, expr: &Expr, all: Interval) -> Interval {
        match &expr.kind {
            ExprKind::Literal(word) => self.word(&expr.ty, *word).unwrap_or(all),
            ExprKind::Const(id) => {
                let word = self.module.consts.get(id.index()).and_then(|c| c.words.first());
                word.and_then(|word| self.word(&expr.ty, *word)).unwrap_or(all)
            }
            ExprKind::Compare(op, a, b) => self.compare(*op, a, b),
            ExprKind::Logic(op, a, b) => {
                let (a, b) = (self.range(a), self.range(b));
                if *op == LogicOp::And { a.min(b) } else { a.max(b) }
            }
            _ if self.blind => all,
            ExprKind::Load(place) => {
                key(place).and_then(|key| self.at(&key)).map_or(all, |known| all.meet(known))
            }
            ExprKind::Call(callee, _) => {
                let number = self.returned(*callee).and_then(|it| it.at(&[]));
                number.map_or(all, |known| all.meet(known))
            }
            ExprKind::Unary(UnaryOp::Not, x) => self.range(x).not(all),
            ExprKind::Unary(UnaryOp::Neg, x) => all.meet(Interval::one(0).sub(self.range(x))),
            ExprKind::Binary(BinaryOp::Sub, a, b)
                if let Some(difference) = self.difference(a, b) =>
            {
                all.meet(Interval::one(difference))
            }
            ExprKind::Binary(op, a, b) => {
                let found = self.range(a).binary(*op, self.range(b), all);
                self.halved(expr).map_or(found, |halved| found.meet(halved))
            }
            ExprKind::Cast(x) if let (Some(_), Some(to)) = (x.ty.as_float(), expr.ty.as_int()) => {
                self.converted(x, to)
            }
            ExprKind::Cast(x) => self.number(x).filter(|from| from.within(all)).unwrap_or(all),
            ExprKind::Intrinsic(Intrinsic::Variant, args) => {
                let from = args.first().map_or(all, |x| self.brought(x));
                self.meant(&expr.ty).map_or(all, |meant| meant.meet(from))
            }
            ExprKind::Intrinsic(
                Intrinsic::CountOnes | Intrinsic::LeadingZeros | Intrinsic::TrailingZeros,
                args,
            ) => {
                let bits = args.first().and_then(|x| x.ty.as_int()).map_or(64, |int| int.bits());
                all.meet(Interval::new(0, bits.into()))
            }
            ExprKind::Intrinsic(which, args) => {
                let args: Vec<Interval> = args.iter().map(|arg| self.range(arg)).collect();
                Interval::intrinsic(*which, &args, all)
            }
            _ => all,
        }
    }

    /// Returns the interval at a key.
    fn at(&self, key: &Key) -> Option<Interval> {
        match self.known.get(key)? {
            Known::Within(interval) => Some(*interval),
            Known::Float(_) | Known::Between(_) => None,
        }
    }

    /// Returns the interval of an enum after its normalisation: its own variant, or the one that replaces an invalid
    /// one.
    fn brought(&self, x: &Expr) -> Interval {
        let range = self.range(x);
        brought_key(x).and_then(|key| self.at(&key)).map_or(range, |known| range.meet(known))
    }

    /// Returns the numbers of a word type; for an enum, the numbers of its variants if it is one of them.
    pub(super) fn number(&self, expr: &Expr) -> Option<Interval> {
        self.all(&expr.ty)?;
        let range = self.range(expr);
        let Type::Enum(id) = expr.ty else { return Some(range) };
        let words = usize::try_from(range.low).ok()?..=usize::try_from(range.high).ok()?;
        let (low, high) = self.module.enums.get(id.index())?.values(words)?;
        Some(Interval::new(low.into(), high.into()))
    }

    fn word(&self, ty: &Type, word: u64) -> Option<Interval> {
        match ty {
            Type::Scalar(Scalar::Int(int)) => Some(Interval::one(int.from_word(word))),
            Type::Scalar(Scalar::Bool) | Type::Enum(_) => Some(Interval::one(i128::from(word))),
            _ => None,
        }
    }

    fn compare(&self, op: CompareOp, a: &Expr, b: &Expr) -> Interval {
        if a.ty.as_float().is_none() {
            // Two that are no variants may be the same or not.
            let decided = !(self.may_stray(a) && self.may_stray(b)) && is_ordered(op, &a.ty);
            let (a, b) = (self.range(a), self.range(b));
            return if decided { a.compare(op, b) } else { Interval::BOOL };
        }
        let (Some(a), Some(b)) = (self.float(a), self.float(b)) else { return Interval::BOOL };
        Interval::one(i128::from(match op {
            CompareOp::Eq => a == b,
            CompareOp::Ne => a != b,
            CompareOp::Lt => a < b,
            CompareOp::Le => a <= b,
            CompareOp::Gt => a > b,
            CompareOp::Ge => a >= b,
        }))
    }

    /// Returns the value of a constant float expression; never a NaN.
    pub(super) fn float(&self, expr: &Expr) -> Option<f64> {
        let float = expr.ty.as_float()?;
        let value = match &expr.kind {
            ExprKind::Literal(word) => float_of(float, *word),
            ExprKind::Const(id) => {
                float_of(float, *self.module.consts.get(id.index())?.words.first()?)
            }
            ExprKind::Load(place) => match self.known.get(&key(place)?)? {
                Known::Float(value) => *value,
                Known::Within(_) | Known::Between(_) => return None,
            },
            ExprKind::Unary(UnaryOp::Neg, x) => -self.float(x)?,
            ExprKind::Binary(op, a, b) => {
                round(float, operate(*op, self.float(a)?, self.float(b)?)?)
            }
            ExprKind::Cast(x) => round(float, self.float(x)?),
            _ => return None,
        };
        (!value.is_nan()).then_some(value)
    }

    /// Returns the interval or the float of a value.
    pub(crate) fn value(&self, expr: &Expr) -> Option<Known> {
        match self.all(&expr.ty) {
            Some(_) => Some(Known::Within(self.range(expr))),
            None => {
                let number = self.float(expr).map(Known::Float);
                number.or_else(|| Known::between(self.bounds(expr)))
            }
        }
    }
}

/// Returns the key of the normalised enum at a place.
pub(super) fn brought_key(x: &Expr) -> Option<Key> {
    let ExprKind::Load(place) = &x.kind else { return None };
    let (root, mut fields) = key(place)?;
    fields.push(BROUGHT);
    Some((root, fields))
}

/// Returns true if intervals of a type decide a comparison. Indices of variants decide equality, but not order.
pub(super) fn is_ordered(op: CompareOp, ty: &Type) -> bool {
    !matches!(ty, Type::Enum(_)) || matches!(op, CompareOp::Eq | CompareOp::Ne)
}

fn float_of(float: Float, word: u64) -> f64 {
    match float {
        Float::F32 => f64::from(f32::from_bits(word as u32)),
        Float::F64 => f64::from_bits(word),
    }
}

fn round(float: Float, value: f64) -> f64 {
    match float {
        Float::F32 => f64::from(value as f32),
        Float::F64 => value,
    }
}

/// Computes in double precision; rounding the result to single gives the single-precision result.
fn operate(op: BinaryOp, a: f64, b: f64) -> Option<f64> {
    match op {
        BinaryOp::Add => Some(a + b),
        BinaryOp::Sub => Some(a - b),
        BinaryOp::Mul => Some(a * b),
        BinaryOp::Div => Some(a / b),
        _ => None,
    }
}
