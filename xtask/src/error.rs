//! The errors of the commands, in the user's terms, with a remedy where one is known.
//!
//! Invariant: every failure of a command is an [`Error`]; the remedy is one line that can be pasted into a shell, or
//! a sentence when no such line exists.

use anstyle::{AnsiColor, Style};
use std::path::PathBuf;
use std::process::ExitStatus;

/// Outcome of a command that ran to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Success: exit code 0.
    Good,
    /// Failure: exit code 1; all messages have been printed.
    Bad,
}

/// Reason why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The command is planned but does not exist yet.
    #[error("`cargo xtask {command}` is not built yet; it comes with {with}")]
    NotYet {
        /// The command, as typed.
        command: &'static str,
        /// The work that will add the command.
        with: &'static str,
    },
    /// Tools are missing, and installing was not requested.
    #[error("missing: {}", tools.join(", "))]
    Missing {
        /// Names of the missing tools.
        tools: Vec<&'static str>,
        /// The line that installs them; none if this system has no apt-get.
        line: Option<String>,
    },
    /// Tools are still missing although the installation went through.
    #[error("installed, but still not usable: {}", tools.join(", "))]
    StillMissing {
        /// Names of the tools that are still missing.
        tools: Vec<&'static str>,
    },
    /// Installing needs rights that we have no way to get.
    #[error("cannot install {}: not root, and there is no sudo", tools.join(", "))]
    NoRights {
        /// Names of the missing tools.
        tools: Vec<&'static str>,
        /// The line to run as root.
        line: String,
    },
    /// A step of the installation failed; its output has been printed.
    #[error("`{step}` failed ({status})")]
    Install {
        /// The command that was run.
        step: String,
        /// Exit status.
        status: ExitStatus,
    },
    /// The compiler or its lints reported warnings, which have been printed.
    #[error("{count} {} of the compiler or its lints: each is an error here", if *count == 1 { "warning" } else { "warnings" })]
    Lints {
        /// Number of failures.
        count: usize,
    },
    /// A stage of `test` failed; its output has been printed.
    #[error("{stage} failed ({status})")]
    Stage {
        /// The stage's name.
        stage: &'static str,
        /// Exit status of its program.
        status: ExitStatus,
        /// A line that puts it right, if there is one.
        remedy: Option<&'static str>,
    },
    /// The generator could not do its work.
    #[error(transparent)]
    Generate(#[from] bessemer_project::Error),
    /// A mutant's patch has no valid header.
    #[error("{}: {problem}", file.display())]
    Mutant {
        /// The patch.
        file: PathBuf,
        /// The mistake, and a remedy.
        problem: String,
    },
    /// There is no mutant of this name.
    #[error("there is no mutant `{name}`")]
    NoMutant {
        /// The requested name.
        name: String,
        /// The existing names.
        known: Vec<String>,
    },
    /// The requested turn is out of range.
    #[error("there is no turn {turn} of {of}")]
    NoTurn {
        /// The requested turn.
        turn: usize,
        /// Total number.
        of: usize,
    },
    /// Another run uses a folder that this one needs exclusively.
    #[error("another run is at work in {}", folder.display())]
    Busy {
        /// The folder in use.
        folder: PathBuf,
    },
    /// The command needs the work tree of a git repository, and there is none.
    #[error("this is no checkout of git: {said}")]
    NoCheckout {
        /// git's message.
        said: String,
    },
    /// A file or folder could not be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// The book was requested without mdBook, which builds it.
    #[error("mdBook is missing, which makes the pages")]
    NoBookTool,
    /// A program could not be started, or its output not read.
    #[error("cannot run `{program}`: {source}")]
    Spawn {
        /// The program.
        program: String,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl Error {
    /// A step that resolves the error, if there is one.
    #[must_use]
    pub fn remedy(&self) -> Option<String> {
        match self {
            Self::Missing { line: Some(line), .. } | Self::NoRights { line, .. } => {
                Some(line.clone())
            }
            Self::Missing { line: None, .. } => Some(
                "there is no apt-get here: install them with this system's own package manager"
                    .to_owned(),
            ),
            Self::Stage { remedy, .. } => remedy.map(str::to_owned),
            Self::Generate(error) => error.remedy(),
            Self::StillMissing { .. } => Some("cargo xtask doctor".to_owned()),
            Self::NoMutant { known, .. } => Some(format!("choose from {}", known.join(", "))),
            Self::NoTurn { of, .. } => Some(format!("turns go from 1 to {of}")),
            Self::Busy { .. } => Some("wait until it has ended".to_owned()),
            Self::NoBookTool => Some(crate::book::INSTALL.to_owned()),
            Self::NoCheckout { .. } => {
                Some("run it in a clone of the repository, with at least one commit".to_owned())
            }
            Self::NotYet { .. }
            | Self::Install { .. }
            | Self::Spawn { .. }
            | Self::Mutant { .. }
            | Self::Lints { .. }
            | Self::File { .. } => None,
        }
    }

    /// Returns the exit code: 2 for a command that does not exist (as for a mistyped one), 1 otherwise.
    #[must_use]
    pub fn code(&self) -> u8 {
        match self {
            Self::NotYet { .. } => 2,
            _ => 1,
        }
    }

    /// Prints the error on standard error, in colour on a terminal.
    pub fn print(&self) {
        let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
        let cyan = Style::new().bold().fg_color(Some(AnsiColor::Cyan.into()));
        if let Self::Generate(error) = self {
            return error.print();
        }
        anstream::eprintln!("{red}error{red:#}: {self}");
        if let Some(remedy) = self.remedy() {
            anstream::eprintln!("{cyan}to do{cyan:#}: {remedy}");
        }
    }
}
