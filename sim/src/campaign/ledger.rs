//! The results of a campaign in a file, one line for each flight, written when it ends.
//!
//! A campaign that is killed loses only the flights in progress. The next one reads the complete lines, cuts off an
//! incomplete one, and flies the missing seeds.

use super::outcome::{HEADER, Outcome};
use std::fs::{File, OpenOptions};
use std::io::{self, Write as _};
use std::path::Path;

/// An open file of results.
#[derive(Debug)]
pub struct Ledger {
    file: File,
    /// Results found in the file.
    pub known: Vec<Outcome>,
}

impl Ledger {
    /// Opens a file, or creates it.
    ///
    /// # Errors
    ///
    /// The message of the file system, or that the file is something else.
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

    /// Appends the result of a flight.
    ///
    /// # Errors
    ///
    /// An error of the file system.
    pub fn add(&mut self, outcome: &Outcome) -> io::Result<()> {
        self.file.write_all(format!("{}\n", outcome.line()).as_bytes())?;
        self.file.flush()
    }
}

/// Parses the results in a text, sorted by seed, without duplicates and incomplete lines.
pub fn outcomes(text: &str) -> Vec<Outcome> {
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    let mut all: Vec<Outcome> = whole.lines().filter_map(Outcome::of_line).collect();
    all.sort_by_key(|outcome| outcome.seed);
    all.dedup_by_key(|outcome| outcome.seed);
    all
}
