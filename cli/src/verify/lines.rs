//! The lines of an entry point that no call executed. They show where the legs could not differ, because inputs were
//! missing.
//!
//! Invariant: only lines of authors are reported, and only those of which no statement was executed.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{FunctionId, Module, Span};
use bessemer_legs::reached::reached;

/// Largest number of groups of lines reported per file.
const TOLD: usize = 8;

/// `src/lib.rs: 108, 117-119`, for each file with lines that never ran; nothing if all did.
pub fn never(module: &Module, entry: FunctionId, ran: &BTreeSet<Span>) -> String {
    let line = |span: &Span| (span.file, span.line);
    let ran: BTreeSet<_> = ran.iter().map(line).collect();
    let mut never = BTreeSet::new();
    for id in reached(module, entry) {
        module.functions[id.index()].body.each_stmt(|stmt| {
            if stmt.span.line > 0 && !ran.contains(&line(&stmt.span)) {
                never.insert(line(&stmt.span));
            }
        });
    }
    let files: BTreeSet<u32> = never.iter().map(|(file, _)| *file).collect();
    let mut told = Vec::new();
    for file in files {
        let lines: Vec<u32> = never.iter().filter(|it| it.0 == file).map(|it| it.1).collect();
        let name = module.files.get(file as usize).map_or("", String::as_str);
        told.push(format!("{name}: {}", grouped(&lines)));
    }
    told.join("; ")
}

/// `3, 5-7`: lines in order, those in a row as one.
fn grouped(lines: &[u32]) -> String {
    let mut groups: Vec<(u32, u32)> = Vec::new();
    for line in lines {
        match groups.last_mut() {
            Some((_, last)) if *last + 1 == *line => *last = *line,
            _ => groups.push((*line, *line)),
        }
    }
    let mut text = String::new();
    for (index, (first, last)) in groups.iter().take(TOLD).enumerate() {
        let comma = if index > 0 { ", " } else { "" };
        // Writing to a string cannot fail.
        let _ = match first == last {
            true => write!(text, "{comma}{first}"),
            false => write!(text, "{comma}{first}-{last}"),
        };
    }
    if groups.len() > TOLD {
        text += ", …";
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn lines_in_a_row_are_one_group() {
        for (lines, told) in
            [(&[7][..], "7"), (&[1, 2, 3, 5], "1-3, 5"), (&[1, 3, 4], "1, 3-4"), (&[], "")]
        {
            assert_eq!(grouped(lines), told);
        }
        let many: Vec<u32> = (0..20).map(|it| 2 * it).collect();
        assert_eq!(grouped(&many), "0, 2, 4, 6, 8, 10, 12, 14, …");
    }
}
