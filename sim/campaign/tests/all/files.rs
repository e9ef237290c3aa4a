//! Files of results after kills, of other campaigns, and of shards.

use bessemer_campaign::program::{Arguments, perform};
use bessemer_campaign::{
    Campaign, Column, Error, Ledger, Row, Simple, Table, Value, fingerprint, read, run,
};
use clap::Parser as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Runs whose result is a number of the seed. Seed 13 panics, 14 is NaN, 15 has no result.
fn scenario(
    kind: &'static str,
    version: u32,
    source: &'static [&'static str],
) -> Simple<impl Fn(u64) -> Result<Vec<Value>, String> + Sync> {
    Simple {
        kind,
        version,
        sources: source,
        columns: vec![Column::number("root", "m").decimals(3), Column::text("name")],
        run: |seed| match seed {
            13 => panic!("seed {seed}, of all"),
            14 => Ok(vec![f64::NAN.into(), "x".into()]),
            15 => Err("the \"pilot\",\nleft".to_owned()),
            _ => Ok(vec![(seed as f64).sqrt().into(), "x".into()]),
        },
    }
}

fn fly(campaign: &dyn Campaign, path: &Path, seeds: &str) -> Result<bool, Error> {
    let words = ["campaign", "--seeds", seeds, "--file", path.to_str().unwrap_or_default()];
    perform(&[campaign], &Arguments::parse_from(words))
}

fn rows(campaign: &dyn Campaign, paths: &[PathBuf]) -> Result<Table, Error> {
    read(campaign, paths, None)
}

#[test]
fn a_file_of_something_else_is_refused_and_left_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let mine = scenario("mine", 1, &["fn a() {}"]);
    fly(&mine, &path, "0..3").expect("it runs");
    let before = fs::read(&path).expect("the file");
    let others: [(Simple<_>, &str); 3] = [
        (scenario("yours", 1, &["fn a() {}"]), "the kind `mine`"),
        (scenario("mine", 2, &["fn a() {}"]), "the version `1`"),
        (scenario("mine", 1, &["fn b() {}"]), "the models `"),
    ];
    for (other, what) in others {
        let message = fly(&other, &path, "0..5").expect_err("it is refused").to_string();
        assert!(message.contains(what) && message.contains("\nhelp: "), "{message}");
        let message =
            rows(&other, std::slice::from_ref(&path)).expect_err("it is refused").to_string();
        assert!(message.contains(what), "{message}");
    }
    assert_eq!(fs::read(&path).expect("the file"), before);
    let text = folder.path().join("thesis.txt");
    fs::write(&text, "chapter 1\n").expect("a file");
    assert!(matches!(fly(&mine, &text, "0..3"), Err(Error::Foreign { .. })));
    assert_eq!(fs::read_to_string(&text).expect("the file"), "chapter 1\n");
}

#[test]
fn other_models_are_read_only_where_their_hash_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let (old, new) = (scenario("mine", 1, &["fn a() {}"]), scenario("mine", 1, &["fn b() {}"]));
    fly(&old, &path, "0..3").expect("it runs");
    let table =
        read(&new, std::slice::from_ref(&path), Some(&old.models())).expect("it is accepted");
    assert_eq!(table.rows.len(), 3);
    let both = folder.path().join("b.csv");
    fly(&new, &both, "0..3").expect("it runs");
    assert!(read(&new, &[path, both], Some(&old.models())).is_err(), "two versions in one summary");
}

#[test]
fn a_file_is_appended_to_and_a_cut_line_is_counted() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let mine = scenario("mine", 1, &[]);
    fly(&mine, &path, "0..9").expect("it runs");
    let whole = fs::read_to_string(&path).expect("the file");
    // A kill at each byte: what was there stays, and each seed is there once.
    for end in 0..whole.len() {
        fs::write(&path, &whole[..end]).expect("the file");
        fly(&mine, &path, "0..9").expect("it goes on");
        let text = fs::read_to_string(&path).expect("the file");
        assert!(text.starts_with(&whole[..end]), "{end}: {text}");
        let table = rows(&mine, std::slice::from_ref(&path)).expect("it is read");
        assert_eq!(
            table.rows.keys().copied().collect::<Vec<_>>(),
            (0..9).collect::<Vec<_>>(),
            "{end}"
        );
        assert_eq!(table.repeated, 0);
        let is_reported = table.remarks().iter().any(|it| it.contains("cut off"));
        assert_eq!(is_reported, text.contains("#cut"), "{end}");
    }
}

#[test]
fn a_damaged_line_is_an_error_with_its_number() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let mine = scenario("mine", 1, &[]);
    fly(&mine, &path, "0..1").expect("it runs");
    let whole = fs::read_to_string(&path).expect("the file");
    for bad in ["1,nonsense,x,\n", "1,1.000\n", "x,1.000,x,\n", "\n", "1,1.000,x,,\n"] {
        fs::write(&path, format!("{whole}{bad}2,1.414,x,\n")).expect("the file");
        for message in
            [fly(&mine, &path, "0..3").err(), rows(&mine, std::slice::from_ref(&path)).err()]
        {
            let message = message.expect("it is refused").to_string();
            assert!(
                message.contains("line 4:") && message.contains("help: "),
                "{bad:?}: {message}"
            );
        }
    }
}

#[test]
fn one_program_writes_at_a_time() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let mine = scenario("mine", 1, &[]);
    let first = Ledger::open(&path, &mine).expect("a new file");
    assert!(matches!(fly(&mine, &path, "0..3"), Err(Error::Locked { .. })));
    drop(first);
    fly(&mine, &path, "0..3").expect("it is free");
}

#[test]
fn a_run_that_fails_is_a_row_and_can_be_made_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let mine = scenario("mine", 1, &[]);
    assert!(!fly(&mine, &path, "10..20").expect("the campaign goes on"), "three runs are bad");
    let text = fs::read_to_string(&path).expect("the file");
    for line in [
        "13,,,panic: seed 13; of all\n",
        "14,,,not finite: `root` is NaN\n",
        "15,,,the 'pilot'; left\n",
        "16,4.000,x,\n",
    ] {
        assert!(text.contains(line), "{text}");
    }
    let table = rows(&mine, std::slice::from_ref(&path)).expect("it is read");
    assert_eq!(table.rows.values().filter(|row| row.result.is_err()).count(), 3);
    // A row with values takes the place of one without, in either order.
    let good = Row { seed: 13, result: Ok(vec![3.606.into(), "x".into()]) };
    let bad = Row { seed: 13, result: Err("panic".to_owned()) };
    for rows in [[&good, &bad], [&bad, &good]] {
        let mut table = Table::default();
        for row in rows {
            table.add(row.clone(), &mine.columns(), &path).expect("no conflict");
        }
        assert_eq!(table.rows[&13], good);
    }
}

#[test]
fn a_run_is_made_again_as_often_as_wanted() {
    use std::sync::atomic::{AtomicU32, Ordering};
    let tries = AtomicU32::new(0);
    let moody = Simple {
        kind: "moody",
        version: 1,
        sources: &[],
        columns: vec![Column::truth("done")],
        run: |_| match tries.fetch_add(1, Ordering::SeqCst) {
            2 => Ok(vec![true.into()]),
            _ => Err("not now".to_owned()),
        },
    };
    let mut all = Vec::new();
    run(&moody, &[7], 5, |row| {
        all.push(row);
        Ok(())
    })
    .expect("no error");
    assert_eq!(all, [Row { seed: 7, result: Ok(vec![true.into()]) }]);
    assert_eq!(tries.load(Ordering::SeqCst), 3);
}

#[test]
fn shards_are_the_whole_and_a_conflict_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let mine = scenario("mine", 1, &[]);
    let shards: Vec<PathBuf> = (1..=3).map(|n| folder.path().join(format!("{n}.csv"))).collect();
    for (index, path) in shards.iter().enumerate() {
        let path = path.to_str().expect("a path");
        let shard = format!("{}/3", index + 1);
        let words = ["campaign", "--seeds", "16..27", "--file", path, "--shard", &shard];
        perform(&[&mine], &Arguments::parse_from(words)).expect("it runs");
    }
    let whole = folder.path().join("whole.csv");
    fly(&mine, &whole, "16..27").expect("it runs");
    let merged = rows(&mine, &shards).expect("they merge");
    assert_eq!(merged, rows(&mine, std::slice::from_ref(&whole)).expect("it is read"));
    let twice = rows(&mine, &[shards[0].clone(), shards[0].clone()]).expect("equal rows");
    assert_eq!((twice.rows.len(), twice.repeated), (4, 4));
    let text = fs::read_to_string(&shards[0]).expect("the file");
    fs::write(&shards[0], text.replace("16,4.000", "16,4.001")).expect("the file");
    let message = rows(&mine, &[whole, shards[0].clone()]).expect_err("a conflict").to_string();
    assert!(
        message.contains("16,4.000,x,")
            && message.contains("16,4.001,x,")
            && message.contains("help"),
        "{message}"
    );
}

#[test]
fn after_an_error_of_the_caller_no_run_begins() {
    let mine = scenario("mine", 1, &[]);
    let mut count = 0;
    let seeds: Vec<u64> = (100..100_000).collect();
    let failed = run(&mine, &seeds, 0, |_| {
        count += 1;
        Err(Error::Argument("the disk is full".to_owned()))
    });
    assert!(failed.is_err());
    assert!(count < 1000, "{count} runs");
}

#[test]
fn comments_and_requirements_change_no_hash() {
    let plain = fingerprint(&["#[entry]\nfn step() {}\n"]);
    let named = "/// Steps.\n\n  #[requirement(\"A\", \"B\")]\n#[entry]\nfn step() {}\n";
    assert_eq!(fingerprint(&[named]), plain);
    for other in ["#[entry(infallible)]\nfn step() {}", "#[entry]\nfn step() { stop() }"] {
        assert_ne!(fingerprint(&[other]), plain);
    }
}
