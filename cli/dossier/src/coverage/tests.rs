//! Tests of the measures, with evaluations as C would write them.

use std::collections::BTreeMap;
use std::path::Path;

use super::instrument::{HEADER, instrument, writing};
use super::*;

const TEXT: &str = "int f(int a, int b, int c)\n{\n    if (a > 0 && (b || !(c == 2))) {\n        return 1;\n    } else if (a) {\n        return 2;\n    }\n    return a ? 3 : 4;\n}\n";

fn instrumented() -> Instrumented {
    instrument([("f.c", TEXT)].into_iter(), |_| true)
}

fn folder() -> Folder {
    let texts = BTreeMap::from([
        ("f.c".to_owned(), TEXT.to_owned()),
        ("f.c.map".to_owned(), "1\ts.rs:7\tm::f\n".to_owned()),
    ]);
    Folder::of(&texts, Path::new("x")).expect("a folder")
}

/// Marks evaluations of the first decision: `T`, `F` or `-` for each condition, then the outcome.
fn seen(of: &Instrumented, evaluations: &[&str]) -> Seen {
    let mut seen = Seen { ran: vec![true; of.points.len()], combinations: vec![false; of.bytes] };
    for evaluation in evaluations {
        let (states, outcome) = evaluation.split_at(3);
        let digit = |state: char| "-FT".find(state).expect("a state");
        let trail = states.chars().rev().fold(0, |trail, state| 3 * trail + digit(state));
        seen.combinations[of.decisions[0].offset + 2 * trail + usize::from(outcome == "T")] = true;
    }
    seen
}

#[test]
fn the_text_is_kept_and_probes_are_added() {
    let done = instrumented();
    let text = &done.files[0].1;
    assert!(text.starts_with(&format!("#include \"{HEADER}\"\n")));
    assert!(text.contains("bessemer_probe_at(0U); if (bessemer_probe_end(0U, 0U, (bessemer_probe_begin(0U), (bessemer_probe(0U, 1U, (a > 0)) && (bessemer_probe(0U, 3U, (b)) || !(bessemer_probe(0U, 9U, (c == 2)))))))) {"), "{text}");
    assert!(text.contains("} else if (bessemer_probe_end(1U, 54U, "), "{text}");
    let names: Vec<&str> = done.files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["f.c", "bessemer_probes.h", "bessemer_probes.c"]);
    assert_eq!((done.points.len(), done.decisions.len()), (5, 3));
    // Without the probes the text is the author's.
    let mut plain = text.split_once('\n').expect("a line").1.to_owned();
    for open in
        ["bessemer_probe_at(", "bessemer_probe_begin(", "bessemer_probe_end(", "bessemer_probe("]
    {
        plain = plain.replace(open, "@(");
    }
    assert_eq!(plain.matches('\n').count(), TEXT.matches('\n').count());
}

#[test]
fn a_condition_is_covered_by_a_pair_that_differs_in_it_alone() {
    let of = instrumented();
    let missing = |evaluations: &[&str]| {
        let report = report(&of, &seen(&of, evaluations), &folder(), Vec::new());
        let own = report.conditions.iter().filter(|it| it.place == "f.c:3");
        own.map(|it| it.why.clone()).collect::<Vec<_>>()
    };
    assert_eq!(missing(&["F--F", "TT-T", "TFTF", "TFFT"]), [""; 0]);
    // The short circuit hides the other conditions: they need not be equal.
    assert_eq!(missing(&["F--F", "TT-T"]).len(), 2);
    assert_eq!(
        missing(&["F--F", "TT-T", "TFTF"]),
        [
            "`c == 2` is never false: lacks an input with `a > 0`, not `b`, not `c == 2` that makes it true"
        ]
    );
    // The outcome has to differ.
    assert_eq!(missing(&["TFFT", "TT-T"]).len(), 3);
    assert_eq!(missing(&[]), ["never evaluated"; 3]);
}

#[test]
fn counts_are_of_all_files() {
    let of = instrumented();
    let report = report(&of, &seen(&of, &["F--F", "TT-T"]), &folder(), vec!["a run".to_owned()]);
    let counts = report.counts;
    // The `else if` ran if its decision was evaluated, and it was not.
    assert_eq!((counts.statements.covered, counts.statements.all), (4, 5));
    assert_eq!((counts.branches.covered, counts.branches.all), (3, 10));
    assert_eq!(
        (counts.conditions.covered, counts.conditions.all, counts.conditions.percent),
        (1, 5, 20)
    );
    assert_eq!(report.files.len(), 1);
    assert_eq!(report.conditions[0].rust, "s.rs:7");
}

#[test]
fn arrays_of_another_size_are_refused() {
    let of = instrumented();
    let whole = vec![1; of.points.len() + of.bytes];
    assert!(Seen::read(&whole, &of).is_some());
    assert!(Seen::read(&whole[1..], &of).is_none());
    assert!(Seen::read(&[], &of).is_none());
}

#[test]
fn runs_add_up() {
    let of = instrumented();
    let mut sum = Seen::default();
    for one in ["F--F", "TT-T", "TFTF", "TFFT"] {
        sum.add(&seen(&of, &[one]));
    }
    assert_eq!(sum, seen(&of, &["F--F", "TT-T", "TFTF", "TFFT"]));
}

#[test]
fn a_program_without_main_is_no_program() {
    assert!(writing("int other(void)").is_none());
    assert!(writing("int main(void)\n{\n}\n").is_some_and(|it| it.contains("int main(int count")));
}
