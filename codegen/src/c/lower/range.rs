//! Counters in 32 bits: a loop over `usize` whose bounds are known needs no 64-bit arithmetic in C.

use bessemer_ir::{BinaryOp, Expr as Ir, ExprKind, LocalId, Place, Type};

use super::super::tree::Expr;
use super::Lower;

/// The largest value that a narrow expression may have, also on the way.
const LIMIT: i128 = 1 << 31;

impl Lower<'_> {
    /// The range of a `usize` expression that counters and constants bound, if C may compute it in
    /// 32 bits.
    pub(super) fn range(&self, expr: &Ir) -> Option<(i128, i128)> {
        if expr.ty != Type::USIZE {
            return None;
        }
        let range = match &expr.kind {
            ExprKind::Literal(word) => (i128::from(*word), i128::from(*word)),
            ExprKind::Const(id) => {
                let word = i128::from(self.context.module.consts[id.index()].words[0]);
                (word, word)
            }
            ExprKind::Load(place) => self.counter(place)?,
            ExprKind::Binary(op, left, right) => {
                let (a, b) = (self.range(left)?, self.range(right)?);
                match op {
                    BinaryOp::Add => (a.0 + b.0, a.1 + b.1),
                    BinaryOp::Sub => (a.0 - b.1, a.1 - b.0),
                    BinaryOp::Mul => (a.0 * b.0, a.1 * b.1),
                    _ => return None,
                }
            }
            _ => return None,
        };
        (range.0 >= 0 && range.1 <= LIMIT).then_some(range)
    }

    /// The range of a narrow counter.
    pub(super) fn counter(&self, place: &Place) -> Option<(i128, i128)> {
        let LocalId(root) = place.root;
        if place.steps.is_empty() { self.counters[root as usize] } else { None }
    }

    /// Whether an expression counts with a narrow counter.
    pub(super) fn counts(&self, expr: &Ir) -> bool {
        match &expr.kind {
            ExprKind::Load(place) => self.counter(place).is_some(),
            ExprKind::Binary(_, left, right) => self.counts(left) || self.counts(right),
            _ => false,
        }
    }

    /// An expression with a [`Lower::range`], in 32 bits; `bare`: as an index, without suffixes.
    pub(super) fn narrow(&mut self, expr: &Ir, bare: bool) -> Expr {
        match &expr.kind {
            ExprKind::Literal(word) if bare => Expr::name(word.to_string()),
            ExprKind::Literal(word) => Expr::name(format!("{word}U")),
            ExprKind::Load(place) => self.place(place),
            ExprKind::Binary(op, left, right) => {
                let op = match op {
                    BinaryOp::Add => "+",
                    BinaryOp::Sub => "-",
                    _ => "*",
                };
                Expr::binary(op, self.narrow(left, bare), self.narrow(right, bare))
            }
            _ => self.word(expr),
        }
    }

    /// Whether a narrow expression has 64 bits in C all the same, for the constants in it.
    pub(super) fn is_wide(&self, expr: &Ir) -> bool {
        match &expr.kind {
            ExprKind::Const(_) => true,
            ExprKind::Binary(_, left, right) => self.is_wide(left) || self.is_wide(right),
            _ => false,
        }
    }
}
