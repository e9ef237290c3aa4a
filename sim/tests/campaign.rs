//! Campaigns: a few seeds of each, and the committed flights.

use bessemer::requirement;
use bessemer_campaign::{Campaign, Row, Summary, read};
use rayon::prelude::*;
use sim::campaign::{Kind, MODELS, outcome, rare, tally};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The first flights of each committed file, flown again, have their lines. So the files are results of these models and of
/// this world: a change of the world that changes a flight needs a new version and new files.
#[test]
#[requirement("HLR-16", "HLR-38")]
fn the_committed_flights_are_those_of_these_models() {
    for (kind, file, seeds) in [(Kind::Spread, "spread", 0..6), (Kind::Failures, "failures", 0..6)]
    {
        let path = root().join(format!("docs/results/{file}.csv"));
        let table = read(&kind, &[path], None).unwrap_or_else(|error| {
            panic!("{error}\nfly them again by the commands in docs/results.md, or change the hash if no flight changed")
        });
        let flown: Vec<Row> = seeds.into_par_iter().map(|seed| Row::of(&kind, seed)).collect();
        for row in flown {
            assert_eq!(row.line(&kind.columns()), table.rows[&row.seed].line(&kind.columns()));
            assert_eq!(tally::verdict(kind, &row), None);
        }
        assert_eq!(Summary::of(&kind, &table).expect("names are in order").bad.events, 0);
    }
}

/// The severity says whether a flight left the envelope. An airframe with twenty times the inertia that the software assumes
/// leaves it.
#[test]
fn a_flight_that_leaves_the_envelope_is_severe() {
    let envelope = Kind::Spread.rare().expect("a severity");
    // No scenario has more numbers than a run, and the one with all outages has as many.
    let numbers = |normal: f64| rare::scenario(&vec![normal; envelope.dimensions()]).1;
    assert_eq!([numbers(-9.0), numbers(9.0)], [envelope.dimensions() - 6, envelope.dimensions()]);
    let severity = envelope.severity(&vec![0.0; envelope.dimensions()]);
    assert!((-1.0..0.0).contains(&severity), "{severity}");
    let mut scenario = Kind::Spread.scenario(1);
    assert!(outcome::severity(&scenario) < 0.0);
    scenario.airframe.inertia *= 20.0;
    assert!(outcome::severity(&scenario) >= 0.0);
    assert!(Kind::Failures.rare().is_none());
}

#[test]
fn committed_summaries_are_those_of_the_committed_flights() {
    let files = [
        (Kind::Spread, "spread"),
        (Kind::Spread, "spread-fresh"),
        (Kind::Failures, "failures"),
        (Kind::Failures, "failures-fresh"),
    ];
    for (kind, name) in files {
        let results = root().join("docs/results");
        let table = read(&kind, &[results.join(format!("{name}.csv"))], None).expect("flights");
        let page = fs::read_to_string(results.join(format!("{name}.md"))).expect("a summary");
        assert_eq!(page.trim_end(), tally::page(kind, &table).trim_end(), "{name}");
    }
}

#[test]
fn the_hash_has_every_file_of_the_models() {
    let files = fs::read_dir(root().join("models/src")).expect("the models").flatten();
    let mut files: Vec<String> =
        files.map(|file| file.file_name().to_string_lossy().into_owned()).collect();
    files.sort();
    assert_eq!(files, MODELS.map(|(name, _)| name));
}
