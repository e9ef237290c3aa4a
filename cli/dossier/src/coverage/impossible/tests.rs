//! The proof against execution: each decision of a family, over all values of its variables.

use super::*;
use crate::coverage::instrument::instrument;

fn observed(decision: &str) -> Observed {
    let text = format!(
        "int f(double a, double b)\n{{\n    if ({decision}) {{\n        return 1;\n    }}\n    return 0;\n}}\n"
    );
    instrument([("f.c", &*text)].into_iter(), |_| true).decisions.remove(0)
}

/// Values at which an order with the constants 0 and 1 changes, and NaN.
const VALUES: [f64; 8] = [f64::NAN, f64::NEG_INFINITY, -1.0, -0.0, 0.5, 1.0, 2.0, f64::INFINITY];
const OPERANDS: [&str; 4] = ["a", "b", "0.0", "1.0"];
const OPERATORS: [&str; 6] = ["<", "<=", ">", ">=", "==", "!="];

type Comparison = (usize, usize, usize);

fn text((left, operator, right): Comparison) -> String {
    format!("{} {} {}", OPERANDS[left], OPERATORS[operator], OPERANDS[right])
}

fn holds((left, operator, right): Comparison, a: f64, b: f64) -> bool {
    let of = |operand: usize| [a, b, 0.0, 1.0][operand];
    let (left, right) = (of(left), of(right));
    match operator {
        0 => left < right,
        1 => left <= right,
        2 => left > right,
        3 => left >= right,
        4 => left == right,
        _ => left != right,
    }
}

/// Evaluations that execution reaches, over all values of both variables.
fn executed(shape: &Shape, conditions: &[Comparison]) -> Vec<Evaluation> {
    let mut found = Vec::new();
    for a in VALUES {
        for b in VALUES {
            let values =
                conditions.iter().rev().fold(0, |bits, it| bits << 1 | u32::from(holds(*it, a, b)));
            let mut states = vec![State::NotEvaluated; conditions.len()];
            let outcome = shape.evaluate(values, &mut states);
            let evaluation = Evaluation { states, outcome };
            if !found.contains(&evaluation) {
                found.push(evaluation);
            }
        }
    }
    found
}

/// Returns the numbers of conditions that are proved impossible to show, and of those that execution never shows.
fn compared(decision: &str, conditions: &[Comparison]) -> (usize, usize) {
    let of = observed(decision);
    let shape = of.shape.as_ref().expect("it has a form");
    let executed = executed(shape, conditions);
    let mut counts = (0, 0);
    for at in 0..conditions.len() {
        let shown = executed.iter().any(|one| executed.iter().any(|other| shows(one, other, at)));
        let proved = is_impossible(&of, at);
        assert!(!(shown && proved), "{decision}: condition {at} is shown by execution");
        counts.0 += usize::from(proved);
        counts.1 += usize::from(!shown);
    }
    counts
}

fn comparisons() -> Vec<Comparison> {
    let sides = (0..4).flat_map(|left| (0..4).map(move |right| (left, right)));
    let sides = sides.filter(|(left, right)| left != right && (*left < 2 || *right < 2));
    sides.flat_map(|(left, right)| (0..6).map(move |operator| (left, operator, right))).collect()
}

/// All decisions of two comparisons: a condition is proved impossible exactly if execution never shows it.
#[test]
fn two_comparisons_are_proved_as_execution_has_them() {
    let all = comparisons();
    let mut counts = (0, 0);
    for one in &all {
        for other in &all {
            for form in ["&&", "||"] {
                let decision = format!("{} {form} {}", text(*one), text(*other));
                let of_one = compared(&decision, &[*one, *other]);
                counts = (counts.0 + of_one.0, counts.1 + of_one.1);
            }
        }
    }
    assert_eq!(counts.0, counts.1, "some are not proved");
    assert!(counts.0 > 1000);
}

/// Decisions of three comparisons with both operators and a negation, for a third of all pairs of the first two.
#[test]
fn three_comparisons_are_never_proved_against_execution() {
    let all = comparisons();
    let mut number = 0_usize;
    for one in &all {
        for other in &all {
            number += 1;
            if !number.is_multiple_of(3) {
                continue;
            }
            let third = all[number * 97 % all.len()];
            let (one_text, other_text, third_text) = (text(*one), text(*other), text(third));
            for decision in [
                format!("{one_text} && ({other_text} || !({third_text}))"),
                format!("!({one_text} || {other_text}) || {third_text}"),
            ] {
                compared(&decision, &[*one, *other, third]);
            }
        }
    }
}

#[test]
fn terms_are_compared_as_texts_and_constants_as_values() {
    let proved = |decision: &str, at: usize| is_impossible(&observed(decision), at);
    assert!(proved("self->x[2U] > 5U && self->x[2U] != 3U", 1));
    assert!(!proved("self->x[2U] > 5U && self->x[1U] != 3U", 1));
    assert!(proved("g(a) < 1.5 && g(a) < 2U", 1));
    assert!(!proved("g(a) < 1.5 && g(a) < 0x2", 1), "hexadecimal numbers are not read");
    assert!(proved("is_on(self) && !is_on(self)", 0));
    assert!(proved("a > UINT64_C(7) && a > 6U", 1));
    assert!(!proved("a > UINT64_C(7) || a < 8U", 1), "a may be NaN, for all that the text says");
    // Their doubles are equal.
    assert!(!proved("a > 9007199254740993U && a > 9007199254740992U", 1));
    // In single precision 0.1 is above 0.1.
    assert!(proved("a == 0.1F && a > 0.1", 1), "it is always true");
    assert!(!proved("a ? b : 0.0", 0), "a choice has no form");
}
