//! The table of newcomers' mistakes in the book, read off the snapshots of `tests/newcomers/`.

use std::fmt::Write as _;
use std::fs;

use bessemer_tests::root;

const FOLDER: &str = "tests/newcomers";

/// A row for each mistake: what its author wanted, the first error or warning, the first thing to write instead.
pub fn table(up: &str) -> String {
    let entries = fs::read_dir(root().join(FOLDER)).expect("the mistakes are there").flatten();
    let mut paths: Vec<_> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|it| it == "snap"));
    paths.sort();
    let mut text = "\n| task | error | remedy |\n|---|---|---|\n".to_owned();
    for path in paths {
        let read = |ending| fs::read_to_string(path.with_extension(ending)).unwrap_or_default();
        let (source, told) = (read("rs"), read("snap"));
        let wanted = source.lines().next().unwrap_or_default();
        let title = told.lines().find(|it| it.starts_with("error") || it.starts_with("warning"));
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let _ = writeln!(
            text,
            "| [{}]({up}{FOLDER}/{name}.rs) | {} | {} |",
            cell(wanted.trim_start_matches("//! ").trim_end_matches('.')),
            cell(title.unwrap_or_default()),
            cell(&help(&told)),
        );
    }
    text.push('\n');
    text
}

/// The first remedy. Where it changes a line it is that line, as it then is.
fn help(told: &str) -> String {
    let mut lines = told.lines().skip_while(|line| !line.contains("help: "));
    let first = lines.next().and_then(|line| line.split_once("help: ")).map_or("", |(_, it)| it);
    let mut text = first.trim().to_owned();
    for line in lines.take_while(|line| line.starts_with("          ") && !line.trim().is_empty()) {
        text = format!("{text} {}", line.trim());
    }
    text
}

/// Words in a cell of a table: what Markdown would read is code already, or is escaped.
fn cell(words: &str) -> String {
    let mut text = String::new();
    let mut is_code = false;
    for letter in words.chars() {
        is_code ^= letter == '`';
        match letter {
            '|' => text.push_str("\\|"),
            '<' | '*' | '_' if !is_code => text.extend(['\\', letter]),
            _ => text.push(letter),
        }
    }
    text
}
