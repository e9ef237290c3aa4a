//! Writes: every place against every other, of a few fields. What is known of one goes if the other is it, holds it, or
//! is a part of it.

use bessemer_ir::{Expr, ExprKind, Int, LocalId, Module, Place, Scalar, Span, Step, Type};

use crate::passes::analysis::{Interval, State};

const U8: Type = Type::Scalar(Scalar::Int(Int::U8));

/// Two locals, and their fields to the second level.
fn places() -> Vec<Place> {
    let paths: [&[u32]; 7] = [&[], &[0], &[1], &[0, 0], &[0, 1], &[1, 0], &[1, 1]];
    let place = |root: u32, path: &[u32]| Place {
        root: LocalId(root),
        steps: path.iter().map(|field| Step::Field(*field)).collect(),
        ty: U8,
        span: Span::default(),
    };
    (0..2).flat_map(|root| paths.map(|path| place(root, path))).collect()
}

fn word(place: &Place) -> Expr {
    Expr { kind: ExprKind::Load(place.clone()), ty: U8, span: Span::default() }
}

#[test]
fn what_is_written_is_not_known() {
    let module = Module::default();
    let known = Interval::new(3, 4);
    for place in places() {
        for written in places() {
            // An element of it, too: whatever the index is.
            let mut element = written.clone();
            element.steps.push(Step::Index(Expr::local(LocalId(9), &Type::USIZE, Span::default())));
            let shared = place.steps.iter().zip(&written.steps).all(|(one, other)| one == other);
            let touched = place.root == written.root && shared;
            for write in [&written, &element] {
                let mut state = State::new(&module);
                state.bound(&word(&place), known);
                state.forget(std::slice::from_ref(write));
                let is_known = state.range(&word(&place)) == known;
                assert_eq!(is_known, !touched, "{place:?} and {write:?}");
            }
        }
    }
}
