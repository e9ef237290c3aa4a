//! Transfer functions: the interval of an operation's result, from the intervals of its operands.
//!
//! Meaning: for any operands in the intervals, the result is in the returned interval, unless the operation faults.
//! `all` is the range of the type. Bounds beyond `i128` saturate, which makes no difference for types of 64 bits.

use bessemer_ir::{BinaryOp, CompareOp, Intrinsic};

use super::domain::Interval;

impl Interval {
    fn magnitude(self) -> i128 {
        self.low.saturating_abs().max(self.high.saturating_abs())
    }

    fn corners(self, other: Interval, f: impl Fn(i128, i128) -> i128) -> Interval {
        let all = [
            f(self.low, other.low),
            f(self.low, other.high),
            f(self.high, other.low),
            f(self.high, other.high),
        ];
        all.into_iter().map(Interval::one).fold(Interval::one(all[0]), Interval::join)
    }

    pub(crate) fn add(self, other: Interval) -> Interval {
        Interval {
            low: self.low.saturating_add(other.low),
            high: self.high.saturating_add(other.high),
        }
    }

    pub(crate) fn sub(self, other: Interval) -> Interval {
        Interval {
            low: self.low.saturating_sub(other.high),
            high: self.high.saturating_sub(other.low),
        }
    }

    fn div(self, by: Interval) -> Interval {
        if by.low > 0 || by.high < 0 {
            self.corners(by, i128::saturating_div)
        } else {
            let magnitude = self.magnitude();
            Interval { low: -magnitude, high: magnitude }
        }
    }

    fn rem(self, by: Interval) -> Interval {
        let largest = (by.magnitude() - 1).max(0);
        Interval {
            low: if self.low < 0 { -largest.min(self.low.saturating_neg()) } else { 0 },
            high: if self.high > 0 { largest.min(self.high) } else { 0 },
        }
    }

    fn and(self, other: Interval, all: Interval) -> Interval {
        match (self.low >= 0, other.low >= 0) {
            (true, true) => Interval { low: 0, high: self.high.min(other.high) },
            (true, false) => Interval { low: 0, high: self.high },
            (false, true) => Interval { low: 0, high: other.high },
            (false, false) => all,
        }
    }

    fn or(self, other: Interval, all: Interval) -> Interval {
        if self.low < 0 || other.low < 0 {
            return all;
        }
        let bits = 128 - self.high.max(other.high).leading_zeros();
        Interval { low: 0, high: ((1i128 << bits.min(126)) - 1).min(all.high) }
    }

    fn shl(self, by: Interval, all: Interval) -> Interval {
        let by = by.meet(Interval::new(0, 63));
        let largest = 1i128 << by.high.clamp(0, 63);
        let smallest = 1i128 << by.low.clamp(0, 63);
        let exact = self.corners(Interval::new(smallest, largest), i128::saturating_mul);
        if exact.within(all) { exact } else { all }
    }

    fn shr(self, by: Interval) -> Interval {
        let by = by.meet(Interval::new(0, 63));
        self.corners(by, |value, bits| value >> bits.clamp(0, 63))
    }

    pub(crate) fn min(self, other: Interval) -> Interval {
        Interval { low: self.low.min(other.low), high: self.high.min(other.high) }
    }

    pub(crate) fn max(self, other: Interval) -> Interval {
        Interval { low: self.low.max(other.low), high: self.high.max(other.high) }
    }

    pub(crate) fn abs(self) -> Interval {
        let low = if self.low > 0 { self.low } else { (-self.high).max(0) };
        Interval { low, high: self.magnitude() }
    }

    /// Returns the interval of `!x` in a type with range `all`.
    pub(crate) fn not(self, all: Interval) -> Interval {
        let total = all.low + all.high;
        Interval { low: total - self.high, high: total - self.low }
    }

    /// Returns the interval of the mathematical sum, difference or product; for other operators, everything.
    pub(crate) fn exact(self, op: BinaryOp, other: Interval) -> Interval {
        match op {
            BinaryOp::Add => self.add(other),
            BinaryOp::Sub => self.sub(other),
            BinaryOp::Mul => self.corners(other, i128::saturating_mul),
            _ => Interval { low: i128::MIN, high: i128::MAX },
        }
    }

    /// Returns the interval of an operator's result in a type with range `all`.
    pub(crate) fn binary(self, op: BinaryOp, other: Interval, all: Interval) -> Interval {
        let result = match op {
            BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul => self.exact(op, other),
            BinaryOp::Div => self.div(other),
            BinaryOp::Rem => self.rem(other),
            BinaryOp::And => self.and(other, all),
            BinaryOp::Or | BinaryOp::Xor => self.or(other, all),
            BinaryOp::Shl => self.shl(other, all),
            BinaryOp::Shr => self.shr(other),
        };
        all.meet(result)
    }

    /// Returns the interval of a comparison.
    pub(crate) fn compare(self, op: CompareOp, other: Interval) -> Interval {
        let known = match op {
            CompareOp::Lt if self.high < other.low => Some(true),
            CompareOp::Lt if self.low >= other.high => Some(false),
            CompareOp::Le if self.high <= other.low => Some(true),
            CompareOp::Le if self.low > other.high => Some(false),
            CompareOp::Gt => return other.compare(CompareOp::Lt, self),
            CompareOp::Ge => return other.compare(CompareOp::Le, self),
            CompareOp::Eq | CompareOp::Ne => {
                self.equal(other).map(|is| is == (op == CompareOp::Eq))
            }
            CompareOp::Lt | CompareOp::Le => None,
        };
        known.map_or(Interval::BOOL, |known| Interval::one(i128::from(known)))
    }

    fn equal(self, other: Interval) -> Option<bool> {
        if self.high < other.low || other.high < self.low {
            Some(false)
        } else {
            (self.single().is_some() && self == other).then_some(true)
        }
    }

    /// Returns the interval of an integer intrinsic in a type with range `all`.
    pub(crate) fn intrinsic(which: Intrinsic, args: &[Interval], all: Interval) -> Interval {
        let wrapped = |exact: Interval| if exact.within(all) { exact } else { all };
        match (which, args) {
            (Intrinsic::Abs, [x]) => all.meet(x.abs()),
            (Intrinsic::Min, [x, y]) => x.min(*y),
            (Intrinsic::Max, [x, y]) => x.max(*y),
            (Intrinsic::Clamp, [x, low, high]) => x.max(*low).min(*high),
            (Intrinsic::WrappingAdd, [x, y]) => wrapped(x.add(*y)),
            (Intrinsic::WrappingSub, [x, y]) => wrapped(x.sub(*y)),
            (Intrinsic::WrappingMul, [x, y]) => wrapped(x.corners(*y, i128::saturating_mul)),
            (Intrinsic::SaturatingAdd, [x, y]) => all.meet(x.add(*y)),
            (Intrinsic::SaturatingSub, [x, y]) => all.meet(x.sub(*y)),
            (Intrinsic::SaturatingMul, [x, y]) => all.meet(x.corners(*y, i128::saturating_mul)),
            (Intrinsic::UnsignedAbs, [x]) => all.meet(x.abs()),
            (Intrinsic::AbsDiff, [x, y]) => all.meet(x.sub(*y).abs()),
            (Intrinsic::RemEuclid, [_, by]) => {
                all.meet(Interval { low: 0, high: (by.magnitude() - 1).max(0) })
            }
            _ => all,
        }
    }
}
