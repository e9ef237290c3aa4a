//! Linear forms over symbols, with integer coefficients.
//!
//! Invariant: no factor is 0, and symbols are in order, so equal forms look equal. Numbers are limited ([`LARGEST`],
//! [`STEEPEST`], and the bounds of symbols), so that no bound of a form overflows `i128`.

/// Largest constant.
const LARGEST: i128 = 1 << 100;
/// Largest factor.
const STEEPEST: i128 = 1 << 40;
/// Largest absolute value of a symbol.
pub(super) const FURTHEST: i128 = 1 << 70;

/// A number in an execution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Symbol(pub(super) u32);

/// The form `constant + Σ factor · symbol`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Linear {
    pub(super) constant: i128,
    pub(super) parts: Vec<(Symbol, i128)>,
}

impl Linear {
    pub(super) fn number(constant: i128) -> Linear {
        Linear { constant, parts: Vec::new() }
    }

    pub(super) fn symbol(symbol: Symbol) -> Linear {
        Linear { constant: 0, parts: vec![(symbol, 1)] }
    }

    /// Returns the number of a form without symbols.
    pub(super) fn as_number(&self) -> Option<i128> {
        self.parts.is_empty().then_some(self.constant)
    }

    pub(super) fn factor(&self, symbol: Symbol) -> i128 {
        self.parts.iter().find(|(it, _)| *it == symbol).map_or(0, |(_, factor)| *factor)
    }

    /// Returns `self + by · other`; none if a limit is exceeded.
    pub(super) fn plus(&self, by: i128, other: &Linear) -> Option<Linear> {
        let constant = self.constant.checked_add(by.checked_mul(other.constant)?)?;
        let mut parts = self.parts.clone();
        for (symbol, factor) in &other.parts {
            let more = by.checked_mul(*factor)?;
            match parts.iter_mut().find(|(it, _)| it == symbol) {
                Some((_, factor)) => *factor = factor.checked_add(more)?,
                None => parts.push((*symbol, more)),
            }
        }
        parts.retain(|(_, factor)| *factor != 0);
        parts.sort_unstable();
        // Whoever sums more than that is not asking for a bound.
        let small = parts.iter().all(|(_, factor)| factor.abs() <= STEEPEST);
        let form = Linear { constant, parts };
        (form.parts.len() <= 8 && small && constant.abs() <= LARGEST).then_some(form)
    }

    pub(super) fn shifted(&self, by: i128) -> Option<Linear> {
        self.plus(1, &Linear::number(by))
    }

    pub(super) fn times(&self, by: i128) -> Option<Linear> {
        Linear::number(0).plus(by, self)
    }

    /// Returns the negation: a form that is at least 0 where this one is below 0.
    pub(super) fn below(&self) -> Linear {
        let parts = self.parts.iter().map(|(symbol, factor)| (*symbol, -factor)).collect();
        Linear { constant: -self.constant - 1, parts }
    }

    pub(super) fn minus(&self, other: &Linear) -> Option<Linear> {
        self.plus(-1, other)
    }
}
