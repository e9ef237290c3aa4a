//! Campaigns: a few seeds of each, and what a kill leaves behind.

use sim::campaign::ledger::{Ledger, outcomes};
use sim::campaign::outcome::Outcome;
use sim::campaign::{Kind, fly, tally};
use std::sync::Mutex;

fn flown(kind: Kind, seeds: std::ops::Range<u64>) -> Vec<Outcome> {
    let all = Mutex::new(Vec::new());
    let seeds: Vec<u64> = seeds.collect();
    fly(kind, &seeds, |outcome| all.lock().expect("no thread panicked").push(outcome));
    let mut all = all.into_inner().expect("no thread panicked");
    all.sort_by_key(|outcome| outcome.seed);
    all
}

#[test]
fn no_flight_of_a_few_is_as_it_must_not_be() {
    for (kind, seeds) in [(Kind::Spread, 0..6), (Kind::Failures, 0..6)] {
        for outcome in flown(kind, seeds) {
            assert_eq!(tally::fault(kind, &outcome), None, "{outcome:?}");
        }
    }
}

#[test]
fn a_line_is_an_outcome() {
    for outcome in flown(Kind::Failures, 3..5) {
        let line = outcome.line();
        let back = Outcome::of_line(&line).expect("an outcome");
        assert_eq!(back.line(), line);
    }
    assert_eq!(Outcome::of_line("1,nothing,inf"), None);
}

#[test]
fn what_a_kill_leaves_is_gone_on_with() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flights.csv");
    let all = flown(Kind::Spread, 0..3);
    {
        let mut ledger = Ledger::open(&path).expect("a new file");
        assert!(ledger.known.is_empty());
        for outcome in &all[..2] {
            ledger.add(outcome).expect("it is written");
        }
    }
    // Killed in the middle of the third line.
    let whole = std::fs::read_to_string(&path).expect("the file");
    let cut = format!("{whole}{}", &all[2].line()[..20]);
    std::fs::write(&path, cut).expect("the file");
    let mut ledger = Ledger::open(&path).expect("the file");
    let seeds: Vec<u64> = ledger.known.iter().map(|outcome| outcome.seed).collect();
    assert_eq!(seeds, [0, 1]);
    ledger.add(&all[2]).expect("it is written");
    let text = std::fs::read_to_string(&path).expect("the file");
    let lines: Vec<String> = outcomes(&text).iter().map(Outcome::line).collect();
    assert_eq!(lines, all.iter().map(Outcome::line).collect::<Vec<_>>());
}

#[test]
fn a_file_of_something_else_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("thesis.txt");
    std::fs::write(&path, "chapter 1\n").expect("the file");
    assert!(Ledger::open(&path).is_err());
    assert_eq!(std::fs::read_to_string(&path).expect("the file"), "chapter 1\n");
}
