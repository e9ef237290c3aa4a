//! Arithmetic of lengths: shorter, and of the same value.

use super::super::lengths::{divided, greatest, least, minus, plus, same};
use super::{shown, values};

type Operation = fn(bessemer_ir::Expr, bessemer_ir::Expr) -> bessemer_ir::Expr;

/// Holds an operation of two values to its short form, and to the value of its long form.
#[track_caller]
fn hold(operation: Operation, operands: &str, long: &str, short: &str) {
    let (module, values) = values(&format!("{operands}; {long}"));
    let [one, other, long] = &values[..] else { panic!("two operands and a long form") };
    let (text, computed) = shown(&module, &operation(one.clone(), other.clone()));
    assert_eq!(text, short);
    let (_, expected) = shown(&module, long);
    for (computed, expected) in computed.into_iter().zip(expected) {
        assert!(expected.is_none() || computed == expected, "{text}: {computed:?}, {expected:?}");
    }
}

#[test]
fn sums_are_short() {
    hold(plus, "0; n", "0 + n", "n");
    hold(plus, "n; 0", "n + 0", "n");
    hold(plus, "2; 3", "2 + 3", "5");
    hold(plus, "2; n", "2 + n", "n + 2");
    hold(plus, "n; m", "n + m", "n + m");
}

#[test]
fn differences_are_short() {
    hold(minus, "n; 0", "n - 0", "n");
    hold(minus, "5; 3", "5 - 3", "2");
    hold(minus, "n + m; n", "n + m - n", "m");
    hold(minus, "n + m; m", "n + m - m", "n + m - m");
    hold(minus, "n; m", "n - m", "n - m");
}

#[test]
fn extremes_and_quotients_are_short() {
    hold(least, "4; 3", "(4).min(3)", "3");
    hold(least, "n; 3", "n.min(3)", "n.min(3)");
    hold(greatest, "4; 3", "(4).max(3)", "4");
    hold(greatest, "n; m", "n.max(m)", "n.max(m)");
    hold(divided, "7; 2", "7 / 2", "3");
    hold(divided, "n; 2", "n / 2", "n / 2");
    hold(divided, "7; 0", "7 / 0", "7 / 0");
}

#[test]
fn lengths_are_the_same_wherever_they_are_written() {
    let (_, values) = values("n; m; n.min(m); n.min(m); n.max(m); 3; 3; 4");
    let equal: Vec<(usize, usize)> = (0..values.len())
        .flat_map(|one| (0..one).map(move |other| (other, one)))
        .filter(|(one, other)| same(&values[*one], &values[*other]))
        .collect();
    assert_eq!(equal, [(2, 3), (5, 6)]);
}
