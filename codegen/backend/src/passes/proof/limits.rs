//! Limits of a float: two ends, and whether it may be a NaN.
//!
//! Must not know: values, and the operations on them.

use bessemer_ir::{Float, Int, Type};

use super::knowledge::Bounds;

/// Limits of a float.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    pub(super) least: f64,
    pub(super) most: f64,
    pub(super) or_nan: bool,
}

impl Limits {
    pub(super) const UNKNOWN: Limits =
        Limits { least: f64::NEG_INFINITY, most: f64::INFINITY, or_nan: true };

    pub(super) fn of(ends: impl IntoIterator<Item = f64>, or_nan: bool) -> Limits {
        let nothing = (f64::INFINITY, f64::NEG_INFINITY);
        let ends = ends.into_iter();
        let (least, most) = ends.fold(nothing, |(a, b), end| (a.min(end), b.max(end)));
        Limits { least, most, or_nan }
    }

    pub(super) fn ends(self) -> [f64; 2] {
        [self.least, self.most]
    }

    pub(super) fn is_finite(self) -> bool {
        self.least.is_finite() && self.most.is_finite()
    }

    pub(super) fn map(self, f: impl Fn(f64) -> f64) -> Limits {
        Limits::of(self.ends().map(f), self.or_nan)
    }

    /// Returns the numbers to which a conversion leads.
    pub(super) fn numbers(self, int: Int) -> Bounds {
        let zero = self.or_nan.then_some(0.0);
        let all = Limits::of(self.ends().into_iter().chain(zero), false);
        let number = |end: f64| (end.trunc() as i128).max(int.min()).min(int.max());
        (number(all.least), number(all.most))
    }
}

/// Returns a number as a type holds it.
pub(super) fn rounded(value: f64, ty: &Type) -> f64 {
    match ty.as_float() {
        Some(Float::F32) => f64::from(value as f32),
        _ => value,
    }
}
