//! `cargo xtask campaign`: flies very many flights on all cores, and summarises their results.

use super::Outcome;
use bessemer_campaign::program::{Arguments, rows_of};
use bessemer_campaign::{Campaign as _, Summary};
use clap::Parser as _;
use sim::campaign::{Kind, tally};
use sim_args::{Campaign, Subject};
use std::ffi::OsString;

/// Flies the missing flights, and prints a summary of all.
pub fn run(wanted: &Campaign) -> Outcome {
    let kind = match wanted.kind {
        Subject::Spread => Kind::Spread,
        Subject::Failures => Kind::Failures,
    };
    let mut words: Vec<OsString> =
        ["campaign", kind.kind(), "--seeds", &wanted.seeds].map(Into::into).into();
    for (name, value) in [("--shard", &wanted.shard), ("--accept", &wanted.accept)] {
        words.extend(value.iter().flat_map(|value| [name.into(), value.into()]));
    }
    words.extend(wanted.file.iter().flat_map(|file| ["--file".into(), file.into()]));
    for file in &wanted.merge {
        words.extend(["--merge".into(), file.into()]);
    }
    let table = rows_of(&kind, &Arguments::try_parse_from(words)?)?;
    if let Some(path) = &wanted.summary {
        super::write(path, Summary::of(&kind, &table)?.page())?;
    }
    for remark in table.remarks() {
        eprintln!("{remark}");
    }
    println!("{}", tally::page(kind, &table));
    Ok(table.rows.values().all(|row| tally::verdict(kind, row).is_none()))
}
