//! The flights of a campaign in a file, a line each, written as they end.
//!
//! A campaign that is killed has lost the flights in the air, no other: the next one reads the lines that
//! are whole, cuts off one that is not, and flies the seeds that are missing.

use super::outcome::{HEADER, Outcome};
use std::fs::{File, OpenOptions};
use std::io::{self, Write as _};
use std::path::Path;

/// An open file of outcomes.
#[derive(Debug)]
pub struct Ledger {
    file: File,
    /// Outcomes found in the file.
    pub known: Vec<Outcome>,
}

impl Ledger {
    /// Opens a file, or begins it.
    ///
    /// # Errors
    /// What the file system said, or that the file is something else.
    pub fn open(path: &Path) -> io::Result<Self> {
        let text = match std::fs::read_to_string(path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        if !text.is_empty() && !text.starts_with(HEADER) && !HEADER.starts_with(text.trim_end()) {
            return Err(io::Error::other("it holds no flights; name another file"));
        }
        let known = outcomes(&text);
        // Written anew, so that a line that was cut off is gone.
        let mut file = OpenOptions::new().create(true).write(true).truncate(true).open(path)?;
        writeln!(file, "{HEADER}")?;
        for outcome in &known {
            writeln!(file, "{}", outcome.line())?;
        }
        file.flush()?;
        Ok(Self { file, known })
    }

    /// Writes a flight down.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn add(&mut self, outcome: &Outcome) -> io::Result<()> {
        self.file.write_all(format!("{}\n", outcome.line()).as_bytes())?;
        self.file.flush()
    }
}

/// The flights in a text, in the order of their seeds, each once; lines that are not whole left out.
pub fn outcomes(text: &str) -> Vec<Outcome> {
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    let mut all: Vec<Outcome> = whole.lines().filter_map(Outcome::of_line).collect();
    all.sort_by_key(|outcome| outcome.seed);
    all.dedup_by_key(|outcome| outcome.seed);
    all
}
