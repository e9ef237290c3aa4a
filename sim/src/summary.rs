//! The verdict on a flight, as a table.

use crate::checks::Check;
use std::fmt::Write as _;

/// Formats a Markdown table of checks; its columns are padded for reading in a terminal.
pub fn table(checks: &[Check]) -> String {
    let rows: Vec<[String; 4]> =
        std::iter::once(["figure", "value", "limit", ""].map(str::to_owned))
            .chain(checks.iter().map(|check| {
                let mark = if check.passes() { "" } else { "✗" };
                [check.what.clone(), check.value_text(), check.limit_text(), mark.to_owned()]
            }))
            .collect();
    let width = |column: usize| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
    };
    let (what, value, limit) = (width(0), width(1), width(2));
    let mut text = String::new();
    for (index, [a, b, c, d]) in rows.iter().enumerate() {
        let _ = writeln!(text, "| {a:<what$} | {b:>value$} | {c:<limit$} | {d:<1} |");
        if index == 0 {
            let dash = |count: usize| "-".repeat(count);
            let _ = writeln!(text, "|:{}-|-{}:|:{}-|:-:|", dash(what), dash(value), dash(limit));
        }
    }
    text
}
