//! A 64-bit fingerprint of a condition: it skips most deep comparisons in functions with thousands of conditions.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::mem::discriminant;

use bessemer_ir::visit::{Access, Visit, Walk, walk_expr, walk_place};
use bessemer_ir::{Expr, ExprKind, LocalId, LogicOp, Place, Step};

/// Fingerprint of a condition. A condition can follow from another only if the hashes of their comparisons' operands
/// are equal, in either order; of a disjunction the last comparison counts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Glance {
    operands: u64,
    /// Set of roots that are read, one bit for each root modulo 64.
    pub(crate) roots: u64,
}

/// Returns the bit of a root.
pub(crate) fn bit(root: LocalId) -> u64 {
    1 << (root.0 % 64)
}

impl Glance {
    /// Returns the fingerprint of a condition in the normal form of [`relations`](super::relations).
    pub(crate) fn of(condition: &Expr) -> Glance {
        let mut last = condition;
        while let ExprKind::Logic(LogicOp::Or, _, rest) = &last.kind {
            last = rest;
        }
        let operands = match &last.kind {
            ExprKind::Compare(_, a, b) => hashed(a).wrapping_add(hashed(b)),
            _ => hashed(last),
        };
        let mut roots = 0;
        condition.each_place(|place, _| roots |= bit(place.root));
        Glance { operands, roots }
    }

    /// Returns true if one condition may follow from the other.
    pub(crate) fn like(self, other: Glance) -> bool {
        self.operands == other.operands
    }
}

fn hashed(expr: &Expr) -> u64 {
    struct Hash64(DefaultHasher);
    impl Visit for Hash64 {
        fn expr(&mut self, expr: &Expr) {
            discriminant(&expr.kind).hash(&mut self.0);
            if let ExprKind::Literal(word) = expr.kind {
                word.hash(&mut self.0);
            }
            walk_expr(self, expr);
        }
        fn place(&mut self, place: &Place, _: Access) {
            place.root.hash(&mut self.0);
            for step in &place.steps {
                if let Step::Field(field) = step {
                    field.hash(&mut self.0);
                }
            }
            walk_place(self, place);
        }
    }
    let mut hash = Hash64(DefaultHasher::new());
    hash.expr(expr);
    hash.0.finish()
}
