//! Overlap of the borrows in a call.
//!
//! Distinct parameters never refer to the same memory, since every caller is checked here. So places can overlap only
//! if they have the same root. Two slices of one array do not overlap if one begins at or after the end of the other;
//! the argument after a slice is its length.

use alloc::vec::Vec;

use crate::{Argument, BinaryOp, Expr, ExprKind, Place, Step, Type};

use crate::effects::{self, overlap, same_place};

/// Returns the index of each argument that conflicts with an earlier one.
pub fn conflicts(arguments: &[Argument]) -> Vec<usize> {
    let mut held: Vec<(Lent, bool)> = Vec::new();
    let mut conflicts = Vec::new();
    for (index, argument) in arguments.iter().enumerate() {
        let written = match argument {
            Argument::Value(expr) | Argument::Ref(expr) => effects::lent(expr),
            Argument::RefMut(place) => effects::lent(place),
        };
        let length = match arguments.get(index + 1) {
            Some(Argument::Value(length)) => Some(length),
            _ => None,
        };
        let lent = match argument {
            Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => Some((place, false)),
            Argument::Value(_) | Argument::Ref(_) => None,
            Argument::RefMut(place) => Some((place, true)),
        };
        let lent = lent.map(|(place, mutable)| (Lent { place, length }, mutable));
        let hurt = held.iter().any(|(earlier, mutable)| {
            written.iter().any(|place| overlap(earlier.place, place))
                || lent.as_ref().is_some_and(|(next, also)| {
                    (*mutable || *also)
                        && overlap(earlier.place, next.place)
                        && !apart(earlier, next)
                })
        });
        if hurt {
            conflicts.push(index);
        }
        held.extend(lent);
    }
    conflicts
}

/// Place that an argument borrows, and the next argument, which is the length if the place is a slice.
struct Lent<'a> {
    place: &'a Place,
    length: Option<&'a Expr>,
}

impl<'a> Lent<'a> {
    /// Returns the array of a slice, its first index (none for 0), and its length; none if the place is no slice.
    fn slice(&self) -> Option<(Place, Option<&'a Expr>, &'a Expr)> {
        let Type::Slice(_) = self.place.ty else { return None };
        let (mut base, length) = (self.place.clone(), self.length?);
        let from = match self.place.steps.last() {
            Some(Step::From(from)) => {
                base.steps.pop();
                Some(from)
            }
            _ => None,
        };
        Some((base, from, length))
    }
}

/// Returns true if two slices of one array have no element in common.
fn apart(one: &Lent, other: &Lent) -> bool {
    let (Some((base, from, length)), Some((same, other_from, other_length))) =
        (one.slice(), other.slice())
    else {
        return false;
    };
    same_place(&base, &same)
        && (ends_before(from, length, other_from) || ends_before(other_from, other_length, from))
}

/// Returns true if `from + length` is at most the first index of another slice.
fn ends_before(from: Option<&Expr>, length: &Expr, begin: Option<&Expr>) -> bool {
    let mut between = Sum::default();
    begin.into_iter().for_each(|it| between.add(it, 1));
    from.into_iter().for_each(|it| between.add(it, -1));
    between.add(length, -1);
    between.number >= 0 && between.terms.iter().all(|(_, times)| *times >= 0)
}

/// A constant plus integer multiples of expressions. Lengths and indices are at least zero, and the computed sums do
/// not overflow, which would be a fault before the call.
#[derive(Default)]
struct Sum<'a> {
    number: i128,
    terms: Vec<(&'a Expr, i128)>,
}

impl<'a> Sum<'a> {
    fn add(&mut self, expr: &'a Expr, times: i128) {
        match &expr.kind {
            ExprKind::Literal(word) => self.number += times * i128::from(*word),
            ExprKind::Binary(BinaryOp::Add, one, other) => {
                self.add(one, times);
                self.add(other, times);
            }
            ExprKind::Binary(BinaryOp::Sub, one, other) => {
                self.add(one, times);
                self.add(other, -times);
            }
            _ => match self.terms.iter_mut().find(|(known, _)| alike(known, expr)) {
                Some((_, known)) => *known += times,
                None => self.terms.push((expr, times)),
            },
        }
    }
}

/// Returns true if two expressions are equal except for their spans.
fn alike(one: &Expr, other: &Expr) -> bool {
    match (&one.kind, &other.kind) {
        (ExprKind::Literal(one), ExprKind::Literal(other)) => one == other,
        (ExprKind::Const(one), ExprKind::Const(other)) => one == other,
        (ExprKind::Load(one), ExprKind::Load(other)) => same_place(one, other),
        (ExprKind::Binary(op, one, two), ExprKind::Binary(also, three, four)) => {
            op == also && alike(one, three) && alike(two, four)
        }
        _ => false,
    }
}
