//! Whether what a call lends overlaps.
//!
//! Distinct parameters never refer to the same memory (this check, in every caller, sees to that), so
//! places overlap only under one root.

use bessemer_ir::{Argument, Expr, ExprKind, Place};

use crate::effects::{self, overlap};

/// The index of each argument that conflicts with an earlier one.
pub(super) fn conflicts(arguments: &[Argument]) -> Vec<usize> {
    let mut held: Vec<(&Place, bool)> = Vec::new();
    let mut conflicts = Vec::new();
    for (index, argument) in arguments.iter().enumerate() {
        let written = match argument {
            Argument::Value(expr) | Argument::Ref(expr) => effects::lent(expr),
            Argument::RefMut(place) => effects::lent(place),
        };
        let lent = match argument {
            Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => Some((place, false)),
            Argument::Value(_) | Argument::Ref(_) => None,
            Argument::RefMut(place) => Some((place, true)),
        };
        let hurt = held.iter().any(|(earlier, mutable)| {
            written.iter().any(|place| overlap(earlier, place))
                || lent.is_some_and(|(place, also)| (*mutable || also) && overlap(earlier, place))
        });
        if hurt {
            conflicts.push(index);
        }
        held.extend(lent);
    }
    conflicts
}
