//! Files of results: a header, then one line for each run, appended when it ends.
//!
//! Invariants: a file is never rewritten and never shortened. One program at a time writes it. Nothing that is in it is
//! dropped without a word: a line that a kill cut off is counted, and any other damaged line is an error.
//!
//! | line | content |
//! |---|---|
//! | 1 | `# bessemer-campaign` and a JSON object: format, kind, version, options, hash of the models, columns |
//! | 2 | names of the columns: `seed`, those of the campaign, `failed` |
//! | others | a row; one that ends in `#cut` was not written to its end |

use crate::campaign::{Campaign, Column, Type};
use crate::error::Error;
use crate::row::{FAILED, Row};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};

const MARK: &str = "# bessemer-campaign ";
const FORMAT: u32 = 1;
const CUT: &str = "#cut";

/// First line of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Header {
    format: u32,
    /// Name of the campaign.
    pub kind: String,
    /// Version of the scenario.
    pub version: u32,
    /// Options of the scenario.
    pub options: String,
    /// Hash of the models.
    pub models: String,
    columns: Vec<Head>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Head {
    name: String,
    values: Type,
    unit: String,
}

impl Header {
    /// Returns the header of a campaign's files.
    ///
    /// # Errors
    ///
    /// The kind or a column has a name that a file cannot have.
    pub fn of(campaign: &dyn Campaign) -> Result<Self, Error> {
        let kind = campaign.kind().to_owned();
        let wrong = |wrong: String| Error::Campaign { kind: kind.clone(), wrong };
        let is_name = |text: &str| {
            !text.is_empty()
                && text
                    .chars()
                    .all(|it| it.is_ascii_lowercase() || it.is_ascii_digit() || "-_".contains(it))
        };
        if !is_name(&kind) {
            let how = "its kind is a name of lower-case letters, digits, `-` and `_`";
            return Err(wrong(how.to_owned()));
        }
        let all = campaign.columns();
        let mut columns: Vec<Head> = Vec::with_capacity(all.len());
        for Column { name, values, unit, .. } in all {
            let is_taken = ["seed", FAILED].contains(&name.as_str());
            if !is_name(&name) || is_taken || columns.iter().any(|it| it.name == name) {
                return Err(wrong(format!(
                    "the column `{name}` needs another name: lower-case letters, digits, `-` and `_`, once, not `seed` or `{FAILED}`"
                )));
            }
            columns.push(Head { name, values, unit });
        }
        let (version, options) = (campaign.version(), campaign.options());
        Ok(Self {
            format: FORMAT,
            kind: kind.clone(),
            version,
            options,
            models: campaign.models(),
            columns,
        })
    }

    /// Returns the first two lines of a file.
    pub fn lines(&self) -> String {
        // A struct of texts and numbers is always JSON.
        let json = serde_json::to_string(self).unwrap_or_default();
        let names: Vec<&str> = self.columns.iter().map(|it| it.name.as_str()).collect();
        format!(
            "{MARK}{json}\nseed,{}{FAILED}\n",
            names.iter().map(|it| format!("{it},")).collect::<String>()
        )
    }

    /// Compares this header, of the file at `path`, with a campaign's. `accepted` is a hash of other models.
    fn check(&self, wanted: &Self, path: &Path, accepted: Option<&str>) -> Result<(), Error> {
        let other =
            |what, found: &dyn ToString, wanted: &dyn ToString, remedy: String| Error::Other {
                path: path.to_owned(),
                what,
                found: found.to_string(),
                wanted: wanted.to_string(),
                remedy,
            };
        let anew = || "name another file for this campaign, or run it anew into one".to_owned();
        if self.kind != wanted.kind {
            let remedy = format!("name the campaign `{}`, or another file", self.kind);
            return Err(other("the kind", &self.kind, &wanted.kind, remedy));
        }
        if self.format != wanted.format {
            return Err(other("the format", &self.format, &wanted.format, anew()));
        }
        if self.version != wanted.version {
            return Err(other("the version", &self.version, &wanted.version, anew()));
        }
        if self.options != wanted.options {
            return Err(other("the options", &self.options, &wanted.options, anew()));
        }
        if self.columns != wanted.columns {
            let names = |it: &Self| {
                let each =
                    it.columns.iter().map(|it| format!("{}:{:?}:{}", it.name, it.values, it.unit));
                each.collect::<Vec<_>>().join(" ")
            };
            return Err(other("the columns", &names(self), &names(wanted), anew()));
        }
        if self.models != wanted.models && accepted != Some(&self.models) {
            let remedy = format!(
                "run these models into another file; to read this one, without running, add `--accept {}`",
                self.models
            );
            return Err(other("the models", &self.models, &wanted.models, remedy));
        }
        Ok(())
    }
}

/// Rows of a campaign, by seed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The rows. Of a row without values and one with values of the same seed, the latter is here.
    pub rows: BTreeMap<u64, Row>,
    /// Number of lines that a kill cut off.
    pub cut: usize,
    /// Number of lines that repeat a row.
    pub repeated: usize,
}

impl Table {
    /// Adds a row of the file at `path`.
    ///
    /// # Errors
    ///
    /// The seed has other values already.
    pub fn add(&mut self, row: Row, columns: &[Column], path: &Path) -> Result<(), Error> {
        let Some(known) = self.rows.get_mut(&row.seed) else {
            self.rows.insert(row.seed, row);
            return Ok(());
        };
        match (&known.result, &row.result) {
            (Err(_), _) => *known = row,
            (Ok(_), Err(_)) => {}
            (Ok(_), Ok(_)) => {
                let (first, second) = (known.line(columns), row.line(columns));
                if first != second {
                    return Err(Error::Conflict {
                        seed: row.seed,
                        first,
                        second,
                        path: path.to_owned(),
                    });
                }
                self.repeated += 1;
            }
        }
        Ok(())
    }

    /// Returns what a reader of the rows should know about the file, a line each; empty if all is well.
    pub fn remarks(&self) -> Vec<String> {
        let mut all = Vec::new();
        if self.cut > 0 {
            all.push(format!("{} lines were cut off by a kill, and are not counted", self.cut));
        }
        if self.repeated > 0 {
            all.push(format!(
                "{} rows are there twice, equal, and are counted once",
                self.repeated
            ));
        }
        all
    }
}

/// Reads files of a campaign. All have the campaign's models, or all have those with the hash `accepted`.
///
/// # Errors
///
/// A file cannot be read, is damaged or of something else, or two rows of a seed differ.
pub fn read(
    campaign: &dyn Campaign,
    paths: &[PathBuf],
    accepted: Option<&str>,
) -> Result<Table, Error> {
    let mut wanted = Header::of(campaign)?;
    if let Some(models) = accepted {
        wanted.models = models.to_owned();
    }
    let mut table = Table::default();
    for path in paths {
        let bytes = std::fs::read(path).map_err(Error::file(path))?;
        let text = String::from_utf8_lossy(&bytes);
        parse(&text, path, &wanted, accepted, &campaign.columns(), &mut table)?;
    }
    Ok(table)
}

/// Adds the rows of a file's text to a table.
fn parse(
    text: &str,
    path: &Path,
    wanted: &Header,
    accepted: Option<&str>,
    columns: &[Column],
    table: &mut Table,
) -> Result<(), Error> {
    let foreign = || Error::Foreign { path: path.to_owned() };
    let (head, rest) = text.split_once('\n').ok_or_else(foreign)?;
    let json = head.strip_prefix(MARK).ok_or_else(foreign)?;
    let line = |line, wrong: String| Error::Line { path: path.to_owned(), line, wrong };
    let header: Header = serde_json::from_str(json).map_err(|error| line(1, error.to_string()))?;
    header.check(wanted, path, accepted)?;
    let mut rest = rest.split_inclusive('\n').enumerate();
    let names = header.lines();
    match rest.next() {
        Some((_, found)) if names.ends_with(&format!("\n{found}")) => {}
        Some((_, found)) if found.ends_with('\n') => {
            return Err(line(2, "it has other names than line 1".to_owned()));
        }
        _ => {
            table.cut += 1;
            return Ok(());
        }
    }
    for (index, whole) in rest {
        match whole.strip_suffix('\n') {
            None => table.cut += 1,
            Some(text) if text.ends_with(CUT) => table.cut += 1,
            Some(text) => {
                let row = Row::of_line(text.trim_end_matches('\r'), columns);
                table.add(row.map_err(|wrong| line(index + 2, wrong))?, columns, path)?;
            }
        }
    }
    Ok(())
}

/// An open file of results, which no other program writes.
#[derive(Debug)]
pub struct Ledger {
    file: File,
    path: PathBuf,
    columns: Vec<Column>,
    /// The rows that the file had when it was opened.
    pub known: Table,
}

impl Ledger {
    /// Opens a campaign's file and locks it, or creates it.
    ///
    /// # Errors
    ///
    /// The file cannot be written, another program writes it, it is damaged, or it is of something else.
    pub fn open(path: &Path, campaign: &dyn Campaign) -> Result<Self, Error> {
        let header = Header::of(campaign)?;
        let columns = campaign.columns();
        let mut options = OpenOptions::new();
        let mut file =
            options.read(true).append(true).create(true).open(path).map_err(Error::file(path))?;
        file.try_lock().map_err(|error| match error {
            TryLockError::WouldBlock => Error::Locked { path: path.to_owned() },
            TryLockError::Error(source) => Error::File { path: path.to_owned(), source },
        })?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(Error::file(path))?;
        let text = String::from_utf8_lossy(&bytes);
        let lines = header.lines();
        let mut known = Table::default();
        // A kill may have cut off the header, too.
        let missing = match lines.strip_prefix(&*text) {
            Some(missing) => missing.to_owned(),
            None => {
                parse(&text, path, &header, None, &columns, &mut known)?;
                let is_whole = text.ends_with('\n');
                if is_whole { String::new() } else { format!("{CUT}\n") }
            }
        };
        file.write_all(missing.as_bytes()).map_err(Error::file(path))?;
        Ok(Self { file, path: path.to_owned(), columns, known })
    }

    /// Appends a row.
    ///
    /// # Errors
    ///
    /// An error of the file system.
    pub fn add(&mut self, row: &Row) -> Result<(), Error> {
        let line = row.line(&self.columns) + "\n";
        self.file.write_all(line.as_bytes()).map_err(Error::file(&self.path))
    }
}
