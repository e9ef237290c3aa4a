//! Very many runs of a simulation, each from a seed: what happens how often, and in which of them.
//!
//! | module | purpose |
//! |---|---|
//! | [`campaign`] | what you write: the name, the columns, and one run |
//! | [`row`], [`mod@file`] | the result of a run, and the file of all: append-only, locked, with the hash of the models |
//! | [`mod@seeds`], [`mod@run`] | ranges of seeds, shards, and runs on all cores |
//! | [`summary`], [`bounds`], [`page`] | distributions, faults, confidence bounds, worst seeds: as text, JSON and HTML |
//! | [`rare`] | probabilities of failures too rare for plain sampling |
//! | [`program`] | the command line around it all, which `cargo bessemer campaign` calls |
//!
//! A die that must not show a six:
//!
//! ```
//! use bessemer_campaign::*;
//!
//! let die = Simple {
//!     kind: "die",
//!     version: 1,
//!     sources: &[],
//!     columns: vec![Column::number("eyes", "").worst(Worst::Largest)],
//!     run: |seed: u64| Ok(vec![(1.0 + (seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 61) as f64).into()]),
//! };
//! let mut table = Table::default();
//! run(&die, &(0..100).collect::<Vec<_>>(), 0, |row| {
//!     table.rows.insert(row.seed, row);
//!     Ok(())
//! })?;
//! let summary = Summary::of(&die, &table)?;
//! assert_eq!(summary.runs, 100);
//! assert_eq!(summary.columns[0].most, Some(8.0));
//! # Ok::<(), Error>(())
//! ```

#![deny(missing_docs)]

pub mod bounds;
pub mod campaign;
pub mod error;
pub mod file;
pub mod fingerprint;
pub mod page;
#[cfg(feature = "parquet")]
mod parquet;
mod picture;
pub mod program;
pub mod rare;
pub mod row;
pub mod run;
pub mod seeds;
pub mod summary;

pub use bounds::Rate;
pub use campaign::{Campaign, Column, Replay, Simple, Type, Value, Worst};
pub use error::Error;
pub use file::{Header, Ledger, Table, read};
pub use fingerprint::fingerprint;
pub use program::main;
pub use row::Row;
pub use run::run;
pub use seeds::{Shard, seeds, shard};
pub use summary::Summary;
