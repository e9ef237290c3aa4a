//! Errors of recordings, each with its place: lines and messages count from 1.

/// Error of a recording, with its place.
#[derive(Debug, thiserror::Error)]
pub enum Wrong {
    /// A number has no column.
    #[error("it has no column `{column}`; wanted are {wanted}; found are {found}")]
    Column {
        /// The missing column.
        column: String,
        /// All wanted columns.
        wanted: String,
        /// All columns of the recording.
        found: String,
    },
    /// Two columns have one name.
    #[error("{place}: the column `{column}` occurs twice; rename or remove one")]
    Twice {
        /// The line of the names.
        place: String,
        /// The name.
        column: String,
    },
    /// No topic has all columns.
    #[error("none of its topics has the columns {wanted}; in JSON are {found}")]
    Topic {
        /// All wanted columns.
        wanted: String,
        /// The topics.
        found: String,
    },
    /// A row has another length than the head.
    #[error("{place} has {found} columns, and the first {wanted}")]
    Row {
        /// The row.
        place: String,
        /// Number of columns of the row.
        found: usize,
        /// The first row's number of columns.
        wanted: usize,
    },
    /// A cell is no value of its type.
    #[error("{place}: `{text}` is no {kind}, as `{column}` has to be{remedy}")]
    Cell {
        /// Row of the cell.
        place: String,
        /// Column of the cell.
        column: String,
        /// Text of the cell.
        text: String,
        /// The values of the column.
        kind: String,
        /// The remedy, behind a semicolon; empty where there is no better one.
        remedy: &'static str,
    },
    /// A message of the topic is no JSON.
    #[error("{place} is no JSON: {source}")]
    Json {
        /// The message.
        place: String,
        /// The parser's error.
        source: serde_json::Error,
    },
    /// There is no row.
    #[error("it has no rows")]
    Empty,
    /// The bytes are no text.
    #[error("line {line} is not UTF-8; save the file as UTF-8")]
    Encoding {
        /// The first line that is none.
        line: usize,
    },
    /// The file is a flight log that is damaged, or that is not mapped.
    #[error(transparent)]
    Flight(#[from] super::flight::Wrong),
    /// The text is no CSV.
    #[error("it is no CSV: {0}")]
    Csv(#[from] csv::Error),
    /// The file is an MCAP file that cannot be read.
    #[error("it is no whole MCAP file: {0}")]
    Mcap(&'static str),
    /// A chunk of an MCAP file cannot be decompressed.
    #[error("a chunk of it is no {compression}: {said}")]
    Chunk {
        /// The compression that the file names.
        compression: String,
        /// The decoder's error.
        said: String,
    },
}

impl Wrong {
    /// A step that resolves the error.
    pub fn remedy(&self) -> String {
        match self {
            Wrong::Flight(wrong) => wrong.remedy(),
            _ => {
                "name the columns in the first line as in the Rust: `target`, `gains.p`, `place[2]`"
                    .to_owned()
            }
        }
    }
}
