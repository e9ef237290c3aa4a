//! Tables with separators, as spreadsheets of any locale write them.
//!
//! The separator is the one of `,`, `;` and tab that the first line has most; a mark of the byte order is skipped.

/// Lengths of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rows {
    /// Each row has as many cells as the first.
    Even,
    /// A row may be shorter or longer.
    Ragged,
}

/// Returns a text without a mark of the byte order.
pub(crate) fn unmarked(text: &str) -> &str {
    text.trim_start_matches('\u{feff}')
}

/// Returns a reader of a table, whose cells are trimmed.
pub(crate) fn reader(text: &str, rows: Rows) -> csv::Reader<&[u8]> {
    let text = unmarked(text);
    csv::ReaderBuilder::new()
        .delimiter(separator(text))
        .trim(csv::Trim::All)
        .flexible(rows == Rows::Ragged)
        .from_reader(text.as_bytes())
}

/// Returns the line of a record, from 1. Its position may be at an empty line above it.
pub(crate) fn line(text: &str, record: &csv::StringRecord) -> u64 {
    let text = unmarked(text).as_bytes();
    let at = record.position().map_or(0, csv::Position::byte) as usize;
    let empty = text.iter().skip(at).take_while(|byte| matches!(byte, b'\r' | b'\n')).count();
    let before = text.iter().take(at + empty);
    before.filter(|byte| **byte == b'\n').count() as u64 + 1
}

fn separator(text: &str) -> u8 {
    let first = text.lines().next().unwrap_or_default();
    let count = |it: &u8| first.bytes().filter(|byte| byte == it).count();
    [b'\t', b';', b','].into_iter().max_by_key(count).unwrap_or(b',')
}
