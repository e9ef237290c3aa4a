//! Writes: every place against every other, of a few fields. What is known of one goes if the other is it, holds it, or
//! is a part of it.

use bessemer_ir::effects::whole;
use bessemer_ir::{Expr, ExprKind, Float, Int, LocalId, Module, Place, Scalar, Span, Step, Type};

use crate::passes::analysis::known::{Known, the_whole};
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

#[test]
fn facts_of_one_path_do_not_hold_where_two_meet() {
    let module = Module::default();
    let nothing = State::new(&module);
    for place in places() {
        let mut known = State::new(&module);
        known.bound(&word(&place), Interval::new(3, 4));
        let mut none = nothing.clone();
        none.join(&known);
        known.join(&nothing);
        for state in [known, none] {
            assert_eq!(state.range(&word(&place)), Interval::of(Int::U8), "{place:?}");
        }
    }
}

/// `1.0 / x` tells the zeros apart, so neither is known where the paths with both meet, and each stays where both have it.
#[test]
fn zeros_of_either_sign_are_distinct_facts() {
    let module = Module::default();
    let place = Place { ty: Type::Scalar(Scalar::Float(Float::F64)), ..whole(LocalId(0)) };
    let behind = |value: f64| {
        let mut state = State::new(&module);
        state.assign(&place, vec![(Vec::new(), Known::Float(value))]);
        state
    };
    for one in [0.0, -0.0] {
        for other in [0.0, -0.0] {
            let mut state = behind(one);
            state.join(&behind(other));
            let known = the_whole(&state.parts(&place.load()));
            let same = one.is_sign_negative() == other.is_sign_negative();
            assert_eq!(known == Some(Known::Float(one)), same, "{one} or {other}: {known:?}");
        }
    }
}
