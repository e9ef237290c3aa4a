//! Errors of campaigns: each names the file or the argument, and says what to do.

use std::io;
use std::path::PathBuf;

/// Error of a campaign.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file system refuses.
    #[error("`{}`: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The message of the system.
        source: io::Error,
    },
    /// The file is something else.
    #[error("`{}` is not a file of a campaign: it does not begin with `# bessemer-campaign`\nhelp: name another file; this one is left as it is", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// The file belongs to another campaign.
    #[error("`{}` has {what} `{found}`, and this campaign has `{wanted}`\nhelp: {remedy}", path.display())]
    Other {
        /// The file.
        path: PathBuf,
        /// Property that differs.
        what: &'static str,
        /// Value of the file.
        found: String,
        /// Value of the campaign.
        wanted: String,
        /// Remedy.
        remedy: String,
    },
    /// Another program writes the file.
    #[error("`{}` is written by another program\nhelp: wait until it has ended, or name another file and merge both afterwards", path.display())]
    Locked {
        /// The file.
        path: PathBuf,
    },
    /// A line of the file is damaged.
    #[error("`{}`, line {line}: {wrong}\nhelp: delete that line; its seed is then run again", path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// Number of the line, from 1.
        line: usize,
        /// Its fault.
        wrong: String,
    },
    /// Two rows of a seed differ.
    #[error("seed {seed} has two results: `{first}` and `{second}`, in `{}`\nhelp: a run depends on something besides its seed, or the models changed without a new hash: delete the wrong one", path.display())]
    Conflict {
        /// The seed.
        seed: u64,
        /// Its first line.
        first: String,
        /// Its other line.
        second: String,
        /// The file with the other line.
        path: PathBuf,
    },
    /// The campaign itself is not in order.
    #[error("campaign `{kind}`: {wrong}")]
    Campaign {
        /// Its name.
        kind: String,
        /// The fault and its remedy.
        wrong: String,
    },
    /// An argument is not possible.
    #[error("{0}")]
    Argument(String),
}

impl Error {
    pub(crate) fn file(path: &std::path::Path) -> impl FnOnce(io::Error) -> Self + '_ {
        move |source| Self::File { path: path.to_owned(), source }
    }
}
