//! Arguments of `campaign`: those of the campaign's program, which is not built yet when they are read, and of its build.

use std::path::PathBuf;

use clap::Args;

use super::Package;

/// Arguments of `campaign`.
#[derive(Args, Debug, Default)]
#[command(after_help = "\
Examples:
  cargo bessemer campaign --seeds 0..1000                 Run what target/campaign/KIND.csv lacks
  cargo bessemer campaign --seeds 0..1000 --summary a.html --parquet a.parquet
                                                          Also a page, and all rows for DuckDB and pandas
  cargo bessemer campaign --shard 2/4 --file shard-2.csv  One of four shards, for a scheduler
  cargo bessemer campaign --merge shard-1.csv shard-2.csv What shards come to
  cargo bessemer campaign --wheel dist                    The compiled campaign for Python: Ray, Dask, processes
  cargo bessemer campaign --jobs jobs                     Scripts for Slurm and Kubernetes

The campaign is the package's example or binary `campaign`, whose main calls `bessemer_campaign::main`; `cargo bessemer new
--template vehicle` writes one. Exit code 1 if a run is not as it must be.")]
pub struct Campaign {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// Name of the campaign, where the program has several
    pub kind: Option<String>,
    /// The seeds, from .. to (without the last) [default: 0..1000]
    #[arg(long, value_name = "FROM..TO")]
    pub seeds: Option<String>,
    /// Run one of several shards of the seeds: 1/4 … 4/4
    #[arg(long, value_name = "I/N")]
    pub shard: Option<String>,
    /// File of the results, which a campaign goes on with [default: target/campaign/KIND.csv, or KIND-I-of-N.csv of a shard]
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
    #[arg(long, value_name = "TIMES")]
    pub retries: Option<String>,
    /// Also make the runs again that have no result in the file
    #[arg(long)]
    pub again: bool,
    /// Write the summary as a page
    #[arg(long, value_name = "FILE.html")]
    pub summary: Option<PathBuf>,
    /// Write all rows as Parquet
    #[arg(long, value_name = "FILE.parquet")]
    pub parquet: Option<PathBuf>,
    /// Print the summary as JSON
    #[arg(long)]
    pub json: bool,
    /// Estimate the probability of rare failures, with this many runs a level (a multiple of 10), instead of seeds
    #[arg(long, value_name = "RUNS", conflicts_with_all = ["file", "shard", "merge"])]
    pub rare: Option<String>,
    /// Pack the compiled campaign into a Python wheel in this folder, and run nothing
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["seeds", "shard", "file", "merge", "rare"])]
    pub wheel: Option<PathBuf>,
    /// Write scripts for Slurm and Kubernetes into this folder, and do nothing else
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["seeds", "shard", "file", "merge", "rare", "wheel"])]
    pub jobs: Option<PathBuf>,
    /// Profile of cargo that the program is built with [default: release]
    #[arg(long, value_name = "NAME")]
    pub profile: Option<String>,
    /// Build for this machine's processor alone, with its vectors, in target/native
    #[arg(long)]
    pub native: bool,
}
