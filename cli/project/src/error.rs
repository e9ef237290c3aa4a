//! The errors of a user's workspace, each with its text and a remedy.
//!
//! Invariant: an error at a line of a file is printed as rustc prints its own.

use std::fmt::Write as _;
use std::path::PathBuf;

use anstyle::{AnsiColor, Style};
use bessemer_codegen::generate;

/// Reason why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The generator failed.
    #[error(transparent)]
    Generate(#[from] generate::Error),
    /// `bessemer.toml` is wrong; the diagnostics.
    #[error("{0}")]
    Settings(String),
    /// An entry point exceeds a limit of `bessemer.toml`; the diagnostics.
    #[error("{0}")]
    Limit(String),
    /// No package of the workspace has models.
    #[error("no package of the workspace at `{root}` depends on `bessemer`")]
    NoModels {
        /// The root of the workspace.
        root: PathBuf,
    },
    /// Several packages have models, and none was chosen.
    #[error("several packages may have models: {}", known.join(", "))]
    WhichPackage {
        /// Names of these packages.
        known: Vec<String>,
    },
    /// A file or folder could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl Error {
    /// A step that resolves the error, if there is one.
    pub fn remedy(&self) -> Option<String> {
        match self {
            Error::Generate(error) => error.remedy(),
            Error::NoModels { .. } => {
                Some("create a package of models: `cargo bessemer new motor`".to_owned())
            }
            Error::WhichPackage { known } => {
                Some(format!("choose one: `--package {}`", known.first().map_or("", |it| it)))
            }
            Error::Settings(_) | Error::Limit(_) | Error::File { .. } => None,
        }
    }

    /// The error and its remedy as text in colours; a stream drops the colours where they are not wanted.
    pub fn text(&self) -> String {
        use generate::Error as Of;
        // Diagnostics and differences stand as they are.
        let (before, title) = match self {
            Error::Generate(Of::Models(said) | Of::Refused(said)) => {
                (said.to_string(), "the models do not compile".to_owned())
            }
            Error::Generate(Of::Stale(difference)) => {
                (difference.clone(), "the C is stale".to_owned())
            }
            Error::Settings(said) => (said.clone(), "bessemer.toml cannot be used".to_owned()),
            Error::Limit(said) => {
                (said.clone(), "the C exceeds the limits of bessemer.toml".to_owned())
            }
            _ => (String::new(), self.to_string()),
        };
        format!("{before}{}", told(&title, self.remedy().as_deref()))
    }

    /// Prints the error on standard error.
    pub fn print(&self) {
        anstream::eprint!("{}", self.text());
    }
}

/// Formats an error and its remedy, in colours.
fn told(title: &str, remedy: Option<&str>) -> String {
    let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
    let cyan = Style::new().bold().fg_color(Some(AnsiColor::Cyan.into()));
    let mut text = format!("{red}error{red:#}: {title}\n");
    if let Some(remedy) = remedy {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{cyan}to do{cyan:#}: {remedy}");
    }
    text
}

/// Prints an error and its remedy on standard error.
pub fn say(title: &str, remedy: Option<&str>) {
    anstream::eprint!("{}", told(title, remedy));
}
