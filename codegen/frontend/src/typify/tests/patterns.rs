//! Patterns: which parts they take, which cases they have, and which arms can be reached.

use bessemer_ir::tree::{Arm, Expr, ExprKind, Pattern, Site};

use super::super::choice::{reachable, takes_all};
use super::super::pattern::aligned;
use super::super::syntax::{alternatives, is_rest, names_by_case};

fn name(name: &str) -> Pattern {
    Pattern::name(name)
}

fn some(of: Pattern) -> Pattern {
    Pattern::Constructor("Some".into(), vec![of])
}

fn none() -> Pattern {
    Pattern::Constructor("None".into(), Vec::new())
}

fn number(digits: &str) -> Pattern {
    let kind = ExprKind::Int(digits.into(), None);
    Pattern::Value(Expr::plain(kind, Site(1, 1)))
}

#[test]
fn parts_are_aligned_around_the_rest() {
    let of = |patterns: &[Pattern], count| {
        aligned(patterns, count).iter().map(|(_, index)| *index).collect::<Vec<_>>()
    };
    let (a, b, rest) = (name("a"), name("b"), Pattern::Rest);
    assert_eq!(of(&[a.clone(), b.clone()], 2), [0, 1]);
    assert_eq!(of(&[a.clone(), rest.clone()], 4), [0]);
    assert_eq!(of(&[rest.clone(), a.clone()], 4), [3]);
    assert_eq!(of(&[a.clone(), rest.clone(), b.clone()], 4), [0, 3]);
    assert_eq!(of(&[a.clone(), rest, b.clone()], 2), [0, 1]);
    assert_eq!(of(&[a, b], 1), [0]);
}

#[test]
fn a_pattern_takes_all_values_or_some() {
    let both = |of: &[Pattern]| Pattern::Tuple(of.to_vec());
    for (pattern, expected) in [
        (Pattern::Any, true),
        (name("a"), true),
        (number("3"), false),
        (some(Pattern::Any), false),
        (both(&[Pattern::Any, name("a")]), true),
        (both(&[Pattern::Any, number("3")]), false),
        (Pattern::Or(vec![number("3"), Pattern::Any]), true),
        (Pattern::Or(vec![number("3"), number("4")]), false),
    ] {
        assert_eq!(takes_all(&pattern), expected, "{pattern:?}");
    }
}

#[test]
fn arms_behind_one_that_takes_all_are_not_reached() {
    let arms = |of: &[(Pattern, bool)]| -> Vec<Arm> {
        let unit = || Expr::plain(ExprKind::Tuple(Vec::new()), Site(1, 1));
        let arm = |(pattern, guarded): &(Pattern, bool)| Arm {
            pattern: pattern.clone(),
            guard: guarded.then(unit),
            body: unit(),
            site: Site(1, 1),
        };
        of.iter().map(arm).collect()
    };
    for (of, reached) in [
        (vec![(number("1"), false), (Pattern::Any, false)], 2),
        (vec![(Pattern::Any, false), (number("1"), false)], 1),
        (vec![(Pattern::Any, true), (number("1"), false)], 2),
        (vec![(some(Pattern::Any), false), (none(), false), (none(), true)], 2),
        (Vec::new(), 0),
    ] {
        assert_eq!(reachable(&arms(&of)).len(), reached, "{of:?}");
    }
}

#[test]
fn each_case_of_a_pattern_is_a_pattern() {
    let or = |of: &[Pattern]| Pattern::Or(of.to_vec());
    let pair = |one, other| Pattern::Tuple(vec![one, other]);
    let (one, two) = (number("1"), number("2"));
    // Without names the cases stay together.
    let plain = or(&[one.clone(), two.clone()]);
    assert!(!names_by_case(&plain));
    let named = or(&[pair(one.clone(), name("a")), pair(name("a"), two.clone())]);
    assert!(names_by_case(&named));
    assert_eq!(alternatives(&named), [pair(one.clone(), name("a")), pair(name("a"), two.clone())]);
    let within = some(or(&[some(name("a")), name("a")]));
    assert_eq!(alternatives(&within), [some(some(name("a"))), some(name("a"))]);
    assert_eq!(alternatives(&name("a")), [name("a")]);
    assert!(is_rest(&Pattern::Rest) && !is_rest(&name("a")));
}
