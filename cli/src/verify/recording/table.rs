//! Recordings as CSV: a line of names, then a line for each call.
//!
//! Commas, semicolons and tabs separate cells; the separator is the one under which most wanted names are found. A name may carry
//! a unit, as in `speed [rad/s]`. Lines that begin with `#` or `%` are comments, but for one that has the names, as NumPy writes it.
//! A line of units below the names is skipped and reported.
//!
//! Must not know: types of columns, and what the cells mean.

use super::error::Wrong;
use super::{Row, Table, Wanted};

/// The separators, the commonest first.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];

/// Marks of a comment.
const COMMENTS: [char; 2] = ['#', '%'];

/// Reads the wanted columns.
pub(super) fn read(bytes: &[u8], wanted: &Wanted<'_>) -> Result<Table, Wrong> {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.trim_start_matches('\u{feff}'),
        Err(error) => {
            let before = &bytes[..error.valid_up_to()];
            let line = 1 + before.iter().filter(|byte| **byte == b'\n').count();
            return Err(Wrong::Encoding { line });
        }
    };
    let mut lines = Lines { text, number: 0 };
    let (head, separator) = head(&mut lines, wanted)?;
    let place = format!("line {}", lines.number);
    let has = |name: &str| head.iter().any(|it| it == name);
    let present = wanted.present(has, || head.clone())?;
    let position = |name: &str| {
        let mut found = (0..head.len()).filter(|at| head[*at] == name);
        let first = found.next();
        match found.next() {
            None => Ok(first.unwrap_or(head.len())),
            Some(_) => Err(Wrong::Twice { place: place.clone(), column: name.to_owned() }),
        }
    };
    let places =
        wanted.columns(&present).map(|it| position(&it.name)).collect::<Result<Vec<_>, _>>()?;

    let notes = wanted.beside(&head).into_iter().collect();
    let mut table = Table { rows: Vec::new(), present, notes };
    let mut is_first = true;
    let offset = lines.number;
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.has_headers(false).flexible(true).delimiter(separator).trim(csv::Trim::All);
    for line in reader.from_reader(lines.text.as_bytes()).into_records() {
        let line = line?;
        let number = offset + line.position().map_or(0, |at| at.line() as usize);
        let comment = line.get(0).is_some_and(|cell| cell.starts_with(COMMENTS));
        if comment || line.iter().all(str::is_empty) {
            continue;
        }
        if line.len() != head.len() {
            let place = format!("line {number}");
            return Err(Wrong::Row { place, found: line.len(), wanted: head.len() });
        }
        let cells: Vec<String> = places.iter().map(|place| line[*place].to_owned()).collect();
        let is_first = std::mem::take(&mut is_first);
        if is_first && is_of_units(&line) && !wanted.has_value(&table.present, &cells) {
            table.notes.push(format!("line {number} skipped: it has units"));
            continue;
        }
        table.rows.push(Row { place: format!("line {number}"), cells });
    }
    Ok(table)
}

/// Lines of a text that are still to be read, and the number of the last one that was.
struct Lines<'t> {
    text: &'t str,
    number: usize,
}

impl<'t> Iterator for Lines<'t> {
    type Item = &'t str;

    fn next(&mut self) -> Option<&'t str> {
        if self.text.is_empty() {
            return None;
        }
        self.number += 1;
        let (line, rest) = self.text.split_once('\n').unwrap_or((self.text, ""));
        self.text = rest;
        Some(line.trim())
    }
}

/// Reads up to the line of names; the names without units, and the separator.
fn head(lines: &mut Lines<'_>, wanted: &Wanted<'_>) -> Result<(Vec<String>, u8), Wrong> {
    for line in lines.by_ref() {
        let comment = line.starts_with(COMMENTS);
        let names = |separator: u8| names(line.trim_start_matches(COMMENTS), separator);
        let found = |names: &[String]| wanted.found(|name| names.iter().any(|it| it == name));
        let candidates = SEPARATORS.into_iter().rev().map(|it| (names(it), it));
        // Among equal counts, `max_by_key` takes the last: the comma.
        let Some((names, separator)) = candidates.max_by_key(|(names, _)| found(names)) else {
            continue;
        };
        if !line.is_empty() && (!comment || found(&names) > 0) {
            return Ok((names, separator));
        }
    }
    Err(Wrong::Empty)
}

/// The cells of a line of names, without their units.
fn names(line: &str, separator: u8) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.has_headers(false).delimiter(separator).trim(csv::Trim::All);
    let line = reader.from_reader(line.as_bytes()).into_records().next();
    let cells = line.and_then(Result::ok).unwrap_or_default();
    cells.iter().map(|name| without_unit(name).to_owned()).collect()
}

/// The name without a unit in brackets behind it. A number in brackets is an index.
fn without_unit(name: &str) -> &str {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((before, inner)) =
            name.strip_suffix(close).and_then(|inner| inner.rsplit_once(open))
            && inner.parse::<usize>().is_err()
        {
            return before.trim_end();
        }
    }
    name
}

/// Returns true if no cell of a line is a number, and each is as short as a unit.
fn is_of_units(line: &csv::StringRecord) -> bool {
    let is_number = |cell: &str| cell.starts_with(|first: char| first.is_ascii_digit());
    let is_short = |cell: &str| cell.chars().count() <= 8 && cell.parse::<f64>().is_err();
    line.iter().all(|cell| is_short(cell) && !is_number(cell))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_taken_off_names_and_indices_are_not() {
        let cases = [
            ("speed [rad/s]", "speed"),
            ("speed(m/s)", "speed"),
            ("position[2]", "position[2]"),
            ("position[2] [m]", "position[2]"),
            ("a.b", "a.b"),
            ("", ""),
            ("]", "]"),
        ];
        for (name, expected) in cases {
            assert_eq!(without_unit(name), expected, "{name}");
        }
    }
}
