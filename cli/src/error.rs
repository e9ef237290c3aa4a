//! The errors of the commands, in the user's terms, with a remedy where one is known.

use std::path::PathBuf;

use bessemer_legs::{board, serial};
use bessemer_tools::{CLANG, GCC, install};

/// Why a command could not do its work.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// An error of the user's workspace.
    #[error(transparent)]
    Project(#[from] bessemer_project::Error),
    /// A line has no counterpart.
    #[error(transparent)]
    Trace(#[from] bessemer_dossier::trace::Error),
    /// A dossier cannot be made.
    #[error(transparent)]
    Dossier(#[from] crate::dossier::Wrong),
    /// Topics cannot be mapped.
    #[error(transparent)]
    Bridge(#[from] crate::pack::bridge::Wrong),
    /// The name of a new package means something already, or nothing.
    #[error("a package cannot be called `{name}`: {why}")]
    Name {
        /// The name that the user gave.
        name: String,
        /// The reason.
        why: &'static str,
    },
    /// A campaign's program cannot be built or run.
    #[error("{wrong}")]
    Campaign {
        /// The reason.
        wrong: String,
    },
    /// Vectors cannot compute an entry point.
    #[error(transparent)]
    Vectors(#[from] bessemer_vectors::Error),
    /// No package has a campaign.
    #[error("there is no campaign")]
    NoCampaign {
        /// The package that the user named.
        package: Option<String>,
    },
    /// Several packages have a campaign.
    #[error("several packages have a campaign")]
    WhichCampaign {
        /// Their names.
        known: Vec<String>,
    },
    /// The folder of a new package exists already.
    #[error("`{folder}` exists already")]
    Exists {
        /// Path of the folder.
        folder: PathBuf,
    },
    /// No checkout of Bessemer is at the given place.
    #[error("`{folder}` is not a checkout of Bessemer: it has no `dsl/Cargo.toml`")]
    NoCheckout {
        /// The folder.
        folder: PathBuf,
    },
    /// No entry point has the name.
    #[error("there is no entry point `{name}`")]
    NoEntry {
        /// The name that the user gave.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A recording is of one entry point, and there are several.
    #[error("the package has several entry points")]
    WhichEntry {
        /// The entry points of the package.
        known: Vec<String>,
    },
    /// A recording cannot be read.
    #[error("`{path}`: {wrong}")]
    Recording {
        /// Path of the recording.
        path: PathBuf,
        /// The defect.
        wrong: Box<crate::verify::recording::Wrong>,
    },
    /// Inputs are not what an entry point takes.
    #[error("`{name}` takes {wanted} numbers beside its component, and an input has {found}")]
    Words {
        /// The entry point.
        name: String,
        /// Number of words in the input.
        found: usize,
        /// Number of words expected.
        wanted: usize,
    },
    /// There is no compiler of C to compare with.
    #[error("neither gcc nor clang can be run")]
    NoCompiler,
    /// A program that is needed is missing.
    #[error(transparent)]
    Missing(#[from] bessemer_tools::Missing),
    /// A board cannot be asked, or its firmware not be written.
    #[error("`{port}`: {why}")]
    Board {
        /// The port, or the folder for the firmware's sources.
        port: PathBuf,
        /// The failure.
        why: board::Error,
    },
    /// A compiler of C refused what was emitted.
    #[error("{name} cannot compile the C: {said}")]
    Compiler {
        /// Name of the compiler.
        name: String,
        /// The compiler's message.
        said: String,
    },
    /// The instructions of calls could not be counted.
    #[error("calls on {name} cannot be counted: {said}")]
    Uncounted {
        /// Name of the compiler.
        name: String,
        /// Message of the emulator.
        said: String,
    },
    /// The program around the Rust could not be made.
    #[error("the native test program cannot be built: {said}")]
    Native {
        /// rustc's message.
        said: String,
    },
    /// A firmware is no ELF.
    #[error("`{path}`: {why}")]
    Elf {
        /// Path of the firmware.
        path: PathBuf,
        /// The defect.
        why: String,
    },
    /// The time between two calls is none.
    #[error("the period must be greater than 0 s")]
    Period,
    /// Nobody says how often an entry point is called.
    #[error("the time between two calls of `{entry}` is not set")]
    NoPeriod {
        /// Its name in the C.
        entry: String,
    },
    /// Entry points of a unit have periods without a common measure.
    #[error(
        "`{entry}` is called every {period} s, which is no multiple of {shortest} s, the shortest period of the unit"
    )]
    Multiple {
        /// Its name in the C.
        entry: String,
        /// Its period, s.
        period: f64,
        /// Shortest period of the unit, s.
        shortest: f64,
    },
    /// A parameter has a length of its own, which a unit's variables have not.
    #[error(
        "`{entry}` takes `{name}`, a slice, and a variable of a co-simulation unit has a fixed length"
    )]
    Slice {
        /// The entry point.
        entry: String,
        /// The parameter.
        name: String,
    },
    /// A variable of the firmware is not what was said of it.
    #[error("`{said}`: {why}")]
    Variable {
        /// The user's words.
        said: String,
        /// The defect.
        why: String,
        /// The structs that there are, where one was requested.
        known: Vec<String>,
    },
    /// A file or folder could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// Path of the file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl Error {
    /// A step that resolves the error, if there is one.
    pub fn remedy(&self) -> Option<String> {
        Some(match self {
            Error::Project(error) => return error.remedy(),
            Error::Trace(error) => return error.remedy(),
            Error::Dossier(error) => return error.remedy(),
            Error::Bridge(wrong) => wrong.remedy(),
            Error::Name { .. } => "choose another, such as `motor` or `height_loop`".to_owned(),
            Error::Exists { .. } => "choose another name, or remove that folder".to_owned(),
            Error::Vectors(_) => "simulate it one run at a time, or write the function without it; an entry point has to be `#[entry(infallible)]`".to_owned(),
            Error::NoCampaign { package } => format!(
                "write {}examples/campaign.rs, whose main calls `bessemer_campaign::main`, as `cargo bessemer new NAME --template vehicle` does",
                package.as_ref().map_or_else(String::new, |it| format!("`{it}`'s "))
            ),
            Error::WhichCampaign { known } => {
                format!("choose one: `--package {}`", known.join("` or `--package "))
            }
            Error::NoCheckout { .. } => "pass the folder of your clone".to_owned(),
            Error::NoEntry { known, .. } => format!("choose from {}", known.join(", ")),
            Error::WhichEntry { known } => {
                format!("choose one with `--entry`: {}", known.join(", "))
            }
            Error::Recording { wrong, .. } => wrong.remedy(),
            Error::Words { .. } => {
                "pass a tuple of the arguments after `self`, in order".to_owned()
            }
            Error::NoCompiler => install(&[GCC, CLANG]),
            Error::NoPeriod { entry } => format!(
                "pass `--period 0.001`, or write `{entry} = 0.001` below `[periods]` in bessemer.toml"
            ),
            Error::Multiple { .. } => {
                "choose multiples in `[periods]`, or make a unit for each entry point".to_owned()
            }
            Error::Period => "pass seconds: `--period 0.001`".to_owned(),
            Error::Slice { .. } => "write an entry point that takes an array `[f64; N]`".to_owned(),
            Error::Elf { .. } => "pass the linked ELF file, not the binary image".to_owned(),
            Error::Variable { known, .. } if !known.is_empty() => {
                format!("choose from {}", known.join(", "))
            }
            Error::Variable { .. } => {
                "name a variable with static storage and its type: `controller=motor_t`".to_owned()
            }
            Error::Missing(missing) => missing.install.clone(),
            Error::Board { why: board::Error::Other, .. } => {
                "build what `cargo bessemer verify --board FOLDER` writes, and load it".to_owned()
            }
            Error::Board { why: board::Error::Line(serial::Error::Silent), .. } => {
                "is the firmware of `--board FOLDER` loaded, and `--baud` its speed?".to_owned()
            }
            Error::Board { .. }
            | Error::File { .. }
            | Error::Compiler { .. }
            | Error::Campaign { .. }
            | Error::Uncounted { .. }
            | Error::Native { .. } => return None,
        })
    }

    /// Prints the error on standard error.
    pub fn print(&self) {
        match self {
            Error::Project(error) => error.print(),
            other => bessemer_project::say(&other.to_string(), other.remedy().as_deref()),
        }
    }
}
