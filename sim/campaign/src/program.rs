//! The command line of a campaign's program: what `cargo bessemer campaign` calls.
//!
//! Three commands for other programs, which run shards on engines: `--missing` prints the seeds that a file lacks, `--rows`
//! runs seeds and prints their lines, and `--add` appends such lines to the file.

use crate::campaign::Campaign;
use crate::error::Error;
use crate::file::{Header, Ledger, Table, read};
use crate::rare::{Effort, estimate};
use crate::row::Row;
use crate::run::run;
use crate::seeds::{Shard, seeds, shard};
use crate::summary::{Summary, fault};
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{BufRead as _, IsTerminal as _, Write as _};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Runs a simulation very many times, each with a seed of its own.
#[derive(Debug, Parser)]
pub struct Arguments {
    /// Name of the campaign, where the program has several
    pub kind: Option<String>,
    /// The seeds, from .. to (without the last)
    #[arg(long, default_value = "0..1000", value_parser = seeds)]
    pub seeds: Range<u64>,
    /// Run one of several shards of the seeds: 1/4 … 4/4
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub shard: Option<Shard>,
    /// File of the results; a campaign that was stopped goes on with what it does not have [default:
    /// target/campaign/KIND.csv, or KIND-I-of-N.csv of a shard]
    #[arg(long)]
    pub file: Option<PathBuf>,
    /// Run nothing: read these files, such as those of all shards
    #[arg(long, num_args = 1.., value_name = "FILE", conflicts_with_all = ["file", "shard"])]
    pub merge: Vec<PathBuf>,
    /// With --merge: read files of other models, with this hash
    #[arg(long, value_name = "HASH", requires = "merge")]
    pub accept: Option<String>,
    /// With --merge: also write all rows into this new file
    #[arg(long, value_name = "FILE", requires = "merge")]
    pub into: Option<PathBuf>,
    /// Make a run without a result again, up to this many times
    #[arg(long, value_name = "TIMES", default_value_t = 0)]
    pub retries: u32,
    /// Also make the runs again that have no result in the file
    #[arg(long)]
    pub again: bool,
    /// Write the summary as a page
    #[arg(long, value_name = "FILE.html")]
    pub summary: Option<PathBuf>,
    /// Write all rows as Parquet, for DuckDB and pandas
    #[arg(long, value_name = "FILE.parquet")]
    pub parquet: Option<PathBuf>,
    /// Print the summary as JSON
    #[arg(long)]
    pub json: bool,
    /// Estimate the probability of rare failures, with this many runs a level (a multiple of 10), instead of seeds
    #[arg(long, value_name = "RUNS", conflicts_with_all = ["file", "shard", "merge"])]
    pub rare: Option<usize>,
    /// Print the ranges of seeds that the file lacks, each at most so long, one a line
    #[arg(long, value_name = "LENGTH", requires = "file", hide = true)]
    pub missing: Option<u64>,
    /// Run the seeds without a file: print the lines of a file
    #[arg(long, hide = true, conflicts_with_all = ["file", "merge"])]
    pub rows: bool,
    /// Append lines from standard input, as `--rows` prints them, to the file
    #[arg(long, requires = "file", hide = true)]
    pub add: bool,
    /// End when standard input ends, so that a program that is killed takes its runs with it
    #[arg(long, hide = true)]
    pub leashed: bool,
}

/// Runs the command line of a program with these campaigns.
///
/// The exit code is 0 if all runs are as they must be, 1 if some are not, and 2 after an error.
pub fn main(campaigns: &[&dyn Campaign]) -> ExitCode {
    let arguments = Arguments::parse();
    if arguments.leashed {
        // The input ends when the parent does.
        std::thread::spawn(|| {
            let _ = std::io::copy(&mut std::io::stdin(), &mut std::io::sink());
            std::process::exit(3);
        });
    }
    match perform(campaigns, &arguments) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Carries out the arguments; returns true if all runs are as they must be.
///
/// # Errors
///
/// Errors of files and arguments.
pub fn perform(campaigns: &[&dyn Campaign], wanted: &Arguments) -> Result<bool, Error> {
    let campaign = chosen(campaigns, wanted.kind.as_deref())?;
    if let Some(level) = wanted.rare {
        return rare(campaign, level, wanted.json);
    }
    if wanted.rows {
        return rows(campaign, wanted);
    }
    if let (Some(path), Some(length)) = (&wanted.file, wanted.missing) {
        return missing(campaign, path, wanted, length);
    }
    if let (Some(path), true) = (&wanted.file, wanted.add) {
        return add(campaign, path);
    }
    #[cfg(not(feature = "parquet"))]
    if wanted.parquet.is_some() {
        return Err(Error::Argument(
            "this program cannot write Parquet\nhelp: build it with the feature `bessemer-campaign/parquet`, as `cargo bessemer campaign --parquet` does".to_owned(),
        ));
    }
    let table = rows_of(campaign, wanted)?;
    let mut summary = Summary::of(campaign, &table)?;
    if let Some(models) = &wanted.accept {
        summary.models.clone_from(models);
    }
    if let Some(path) = &wanted.summary {
        std::fs::write(path, summary.page()).map_err(Error::file(path))?;
    }
    #[cfg(feature = "parquet")]
    if let Some(path) = &wanted.parquet {
        crate::parquet::write(campaign, &table, path)?;
    }
    if wanted.json {
        let json = serde_json::to_string_pretty(&summary);
        println!("{}", json.map_err(|error| Error::Argument(error.to_string()))?);
    } else {
        println!("{}", summary.text());
    }
    Ok(summary.bad.events == 0)
}

/// Runs what the file lacks and returns its rows of the wanted seeds, or merges files.
///
/// # Errors
///
/// Errors of files and arguments.
pub fn rows_of(campaign: &dyn Campaign, wanted: &Arguments) -> Result<Table, Error> {
    if wanted.merge.is_empty() {
        return complete(campaign, &file(campaign.kind(), wanted)?, wanted);
    }
    let table = read(campaign, &wanted.merge, wanted.accept.as_deref())?;
    if let Some(path) = &wanted.into {
        merge_into(campaign, path, &table, wanted)?;
    }
    Ok(table)
}

/// Returns the campaign of a name.
fn chosen<'a>(
    campaigns: &[&'a dyn Campaign],
    kind: Option<&str>,
) -> Result<&'a dyn Campaign, Error> {
    let known = || campaigns.iter().map(|it| it.kind()).collect::<Vec<_>>().join(", ");
    match (kind, campaigns) {
        (None, [one]) => Ok(*one),
        (None, _) => {
            Err(Error::Argument(format!("which campaign?\nhelp: name one of {}", known())))
        }
        (Some(kind), all) => all.iter().find(|it| it.kind() == kind).copied().ok_or_else(|| {
            Error::Argument(format!("there is no campaign `{kind}`\nhelp: name one of {}", known()))
        }),
    }
}

/// Returns the path of the file, in a folder that is there.
fn file(kind: &str, wanted: &Arguments) -> Result<PathBuf, Error> {
    if let Some(path) = &wanted.file {
        return Ok(path.clone());
    }
    let folder = Path::new("target/campaign");
    std::fs::create_dir_all(folder).map_err(Error::file(folder))?;
    Ok(folder.join(match wanted.shard {
        Some(Shard { number, count }) => format!("{kind}-{number}-of-{count}.csv"),
        None => format!("{kind}.csv"),
    }))
}

/// Runs what the file lacks; returns the rows of the wanted seeds.
fn complete(campaign: &dyn Campaign, path: &Path, wanted: &Arguments) -> Result<Table, Error> {
    let mut ledger = Ledger::open(path, campaign)?;
    let mut table = std::mem::take(&mut ledger.known);
    for remark in table.remarks() {
        eprintln!("`{}`: {remark}", path.display());
    }
    let shard = wanted.shard.unwrap_or(Shard::WHOLE);
    let missing: Vec<u64> =
        shard.of(&wanted.seeds).filter(|seed| lacks(&table, *seed, wanted.again)).collect();
    let mut progress = Progress::new(shard.of(&wanted.seeds).count() as u64, missing.len() as u64);
    let columns = campaign.columns();
    run(campaign, &missing, wanted.retries, |row| {
        ledger.add(&row)?;
        progress.next(fault(campaign, &row).is_some());
        table.add(row, &columns, path)
    })?;
    progress.end();
    table.rows.retain(|seed, _| shard.has(&wanted.seeds, *seed));
    eprintln!("the rows are in {}", path.display());
    Ok(table)
}

fn lacks(table: &Table, seed: u64, again: bool) -> bool {
    table.rows.get(&seed).is_none_or(|row| again && row.result.is_err())
}

/// Writes the rows into a file.
fn merge_into(
    campaign: &dyn Campaign,
    path: &Path,
    table: &Table,
    wanted: &Arguments,
) -> Result<(), Error> {
    if wanted.accept.is_some() {
        let what = "`--into` cannot write rows of other models\nhelp: leave `--accept` out, or merge without `--into`";
        return Err(Error::Argument(what.to_owned()));
    }
    let mut ledger = Ledger::open(path, campaign)?;
    let columns = campaign.columns();
    let mut known = std::mem::take(&mut ledger.known);
    for row in table.rows.values() {
        let before = known.rows.get(&row.seed).cloned();
        known.add(row.clone(), &columns, path)?;
        if before.as_ref() != known.rows.get(&row.seed) {
            ledger.add(row)?;
        }
    }
    Ok(())
}

/// Prints the lines of the seeds.
fn rows(campaign: &dyn Campaign, wanted: &Arguments) -> Result<bool, Error> {
    let columns = campaign.columns();
    let out = |text: &str| {
        let mut out = std::io::stdout().lock();
        out.write_all(text.as_bytes())
            .and_then(|()| out.flush())
            .map_err(Error::file(Path::new("standard output")))
    };
    out(&Header::of(campaign)?.lines())?;
    let all: Vec<u64> = wanted.shard.unwrap_or(Shard::WHOLE).of(&wanted.seeds).collect();
    run(campaign, &all, wanted.retries, |row| out(&(row.line(&columns) + "\n")))?;
    Ok(true)
}

/// Prints the ranges of seeds that the file lacks.
fn missing(
    campaign: &dyn Campaign,
    path: &Path,
    wanted: &Arguments,
    length: u64,
) -> Result<bool, Error> {
    let known = Ledger::open(path, campaign)?.known;
    let mut ranges: Vec<Range<u64>> = Vec::new();
    for seed in wanted.seeds.clone().filter(|seed| lacks(&known, *seed, wanted.again)) {
        match ranges.last_mut() {
            Some(last) if last.end == seed && last.end - last.start < length.max(1) => {
                last.end = seed + 1
            }
            _ => ranges.push(seed..seed + 1),
        }
    }
    for range in ranges {
        println!("{}..{}", range.start, range.end);
    }
    Ok(true)
}

/// Appends the rows of standard input: any number of headers, each with its lines. Says `ok COUNT` after each empty line,
/// when the rows before it are in the file.
fn add(campaign: &dyn Campaign, path: &Path) -> Result<bool, Error> {
    let mut ledger = Ledger::open(path, campaign)?;
    let columns = campaign.columns();
    let mut table = std::mem::take(&mut ledger.known);
    let header = Header::of(campaign)?.lines();
    let from = Path::new("standard input");
    let mut count = 0;
    for (index, line) in std::io::stdin().lock().lines().enumerate() {
        let line = line.map_err(Error::file(from))?;
        if line.is_empty() {
            println!("ok {count}");
            count = 0;
            continue;
        }
        if header.lines().any(|it| it == line) {
            continue;
        }
        if line.starts_with('#') {
            return Err(Error::Argument("the rows are those of another campaign or of other models\nhelp: install the same wheel on every machine".to_owned()));
        }
        let row = Row::of_line(&line, &columns);
        let row =
            row.map_err(|wrong| Error::Line { path: from.to_owned(), line: index + 1, wrong })?;
        let before = table.rows.get(&row.seed).cloned();
        table.add(row.clone(), &columns, from)?;
        if before.as_ref() != table.rows.get(&row.seed) {
            ledger.add(&row)?;
        }
        count += 1;
    }
    Ok(true)
}

fn rare(campaign: &dyn Campaign, level: usize, json: bool) -> Result<bool, Error> {
    let effort = Effort { level, ..Effort::default() };
    let found = estimate(campaign, effort)?;
    if json {
        let json = serde_json::to_string_pretty(&found);
        println!("{}", json.map_err(|error| Error::Argument(error.to_string()))?);
    } else if found.probability == 0.0 {
        // Each level has one tenth of the probability of the one before it, and the last found none.
        let tenths = effort.levels.saturating_sub(1) as i32;
        println!(
            "no failure in {} runs: its probability is below about {:.0e}, and the worst severity is {:.3}",
            found.runs,
            0.1_f64.powi(tenths),
            found.severity
        );
    } else {
        println!(
            "probability of a failure: {:.3e} ± {:.1e} (standard error of {} repetitions), {} runs",
            found.probability,
            found.error,
            found.repetitions.len(),
            found.runs
        );
    }
    Ok(true)
}

/// Progress on a terminal, or lines in a log.
struct Progress {
    bar: Option<ProgressBar>,
    done: u64,
    total: u64,
    bad: u64,
    shown: u64,
}

impl Progress {
    /// Begins with `left` runs of `total`.
    fn new(total: u64, left: u64) -> Self {
        let done = total - left;
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(total);
            if let Ok(style) =
                ProgressStyle::with_template("{bar:40} {pos}/{len} runs, {msg}{eta} left")
            {
                bar.set_style(style);
            }
            bar.set_position(done);
            bar.reset_eta();
            bar
        });
        if done > 0 {
            eprintln!("{done} of {total} runs are there already");
        }
        Self { bar, done, total, bad: 0, shown: done }
    }

    fn next(&mut self, is_bad: bool) {
        self.done += 1;
        self.bad += u64::from(is_bad);
        if let Some(bar) = &self.bar {
            if is_bad {
                bar.set_message(format!("{} bad, ", self.bad));
            }
            bar.inc(1);
        } else if self.done - self.shown >= (self.total / 20).max(1) && self.total >= 200 {
            self.shown = self.done;
            eprintln!("{} of {} runs, {} bad", self.done, self.total, self.bad);
        }
    }

    fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
