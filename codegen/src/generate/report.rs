//! What a generation made, as an aligned table.

use std::fmt::Write as _;

use crate::compile::Compiled;

/// Component, entry point, lines of C, bytes of state, estimated stack, checks left.
pub fn table(compiled: &Compiled) -> String {
    let titles = ["component", "entry point", "C lines", "state", "stack", "checks"];
    let mut rows: Vec<[String; 6]> = vec![titles.map(str::to_owned)];
    rows.extend(compiled.entries.iter().map(|entry| {
        [
            entry.component.clone(),
            entry.entry.clone(),
            entry.lines.to_string(),
            format!("{} B", entry.state_bytes),
            format!("{} B", entry.stack_bytes),
            entry.checks.to_string(),
        ]
    }));
    let width = |column: usize| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
    };
    let widths: Vec<usize> = (0..titles.len()).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let cells: Vec<String> = row
            .iter()
            .zip(&widths)
            .enumerate()
            .map(|(column, (cell, width))| {
                // Names to the left, numbers to the right.
                if column < 2 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            })
            .collect();
        let _ = writeln!(text, "{}", cells.join("  ").trim_end());
    }
    if !compiled.library.is_empty() {
        let _ = writeln!(
            text,
            "\nThe C calls the target's math.h ({}): there its results need not be the Rust's to the bit.",
            compiled.library.join(", ")
        );
    }
    text
}
