//! Whether what a call lends overlaps.
//!
//! Distinct parameters never refer to the same memory (this check, in every caller, sees to that), so
//! places overlap only under one root.

use bessemer_ir::visit::{Access, Visit, walk_place};
use bessemer_ir::{Argument, Expr, ExprKind, Place, Step};

/// Whether two places may share memory: they do not where they part at different fields, or at
/// indices that are different literals.
pub(super) fn overlap(a: &Place, b: &Place) -> bool {
    a.root == b.root && !a.steps.iter().zip(&b.steps).any(|(a, b)| parts(a, b))
}

fn parts(a: &Step, b: &Step) -> bool {
    match (a, b) {
        (Step::Field(a), Step::Field(b)) => a != b,
        (Step::Index(a), Step::Index(b)) => differ(a, b),
        (Step::Element(row_a, col_a), Step::Element(row_b, col_b)) => {
            differ(row_a, row_b) || differ(col_a, col_b)
        }
        _ => false,
    }
}

/// Whether two indices are known to differ.
fn differ(a: &Expr, b: &Expr) -> bool {
    match (&a.kind, &b.kind) {
        (ExprKind::Literal(word_a), ExprKind::Literal(word_b)) => {
            let value = |expr: &Expr, word: u64| expr.ty.as_int().map(|int| int.from_word(word));
            value(a, *word_a) != value(b, *word_b)
        }
        _ => false,
    }
}

/// The index of each argument that conflicts with an earlier one.
pub(super) fn conflicts(arguments: &[Argument]) -> Vec<usize> {
    let mut held: Vec<(&Place, bool)> = Vec::new();
    let mut conflicts = Vec::new();
    for (index, argument) in arguments.iter().enumerate() {
        let mut written = Lent(Vec::new());
        let lent = match argument {
            Argument::Value(expr) => {
                written.expr(expr);
                None
            }
            Argument::Ref(expr) => {
                written.expr(expr);
                match &expr.kind {
                    ExprKind::Load(place) => Some((place, false)),
                    _ => None,
                }
            }
            Argument::RefMut(place) => {
                walk_place(&mut written, place);
                Some((place, true))
            }
        };
        let hurt = held.iter().any(|(earlier, mutable)| {
            written.0.iter().any(|place| overlap(earlier, place))
                || lent.is_some_and(|(place, also)| (*mutable || also) && overlap(earlier, place))
        });
        if hurt {
            conflicts.push(index);
        }
        held.extend(lent);
    }
    conflicts
}

/// The places that calls inside an argument may write.
struct Lent(Vec<Place>);

impl Visit for Lent {
    fn place(&mut self, place: &Place, access: Access) {
        if access == Access::Lend {
            self.0.push(place.clone());
        }
        walk_place(self, place);
    }
}
