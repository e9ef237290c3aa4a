//! Writes `docs/crates.md`: the table of the result file, with our notes on each crate.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use bessemer_tests::root;
use serde_json::Value;

use super::source::{Crate, all};

/// The path of the page.
pub fn path() -> PathBuf {
    root().join("docs/crates.md")
}

/// Returns the page with a new table from the result file.
///
/// # Errors
///
/// A file that is missing or damaged.
pub fn text() -> Result<String, String> {
    let read = |path: PathBuf| {
        fs::read_to_string(&path).map_err(|error| format!("`{}`: {error}", path.display()))
    };
    let results: Value =
        serde_json::from_str(&read(super::results())?).map_err(|error| error.to_string())?;
    let page = read(path())?;
    let parts = page.split_once(BEGIN).and_then(|(head, rest)| Some((head, rest.split_once(END)?)));
    let (head, (_, tail)) = parts.ok_or("docs/crates.md has no place for the table")?;
    Ok(format!("{head}{BEGIN}\n\n{}\n{END}{tail}", table(&all()?, &results)))
}

const BEGIN: &str = "<!-- crates -->";
const END: &str = "<!-- end of crates -->";

fn table(crates: &[Crate], results: &Value) -> String {
    let rows = results["crates"].as_array().cloned().unwrap_or_default();
    let row = |of: &Crate| rows.iter().find(|row| row["crate"] == of.name.as_str());
    let passes = |row: &&Value| row["differ_between_legs"] == 0;
    let plain = |row: &&Value| row["changed_lines"] == 0;
    let passed: Vec<&Value> = rows.iter().filter(passes).collect();
    let mut text = format!(
        "{} of {} crates become C of the same bits, {} of them with attributes and imports alone.\n\n{HEAD}",
        passed.len(),
        crates.len(),
        passed.iter().filter(|row| plain(row)).count()
    );
    for of in crates {
        let Some(row) = row(of) else { continue };
        let note = of.ours("note").trim().replace('\n', " ");
        let number = |key: &str| row[key].to_string();
        let _ = write!(
            text,
            "| `{}` {} | {} | {} | {} | {} | {} |",
            of.name,
            of.version,
            of.author,
            of.field,
            number("attributes"),
            number("imports"),
            number("changed_lines")
        );
        let _ = match row.get("calls") {
            Some(calls) => writeln!(
                text,
                " {} | {calls} | {} | {} | {} | {note} |",
                number("entries"),
                number("inputs_of_its_tests"),
                number("differ_between_legs"),
                differs(row)
            ),
            None => writeln!(text, " – | – | – | – | – | **not yet:** {note} |"),
        };
    }
    text
}

/// Returns the number of calls that differ from the original; in brackets those with inputs of its tests.
fn differs(row: &Value) -> String {
    match (&row["differ_from_the_original"], &row["of_its_tests_differ"]) {
        (all, _) if *all == 0 => "0".to_owned(),
        (all, of_tests) => format!("{all} ({of_tests})"),
    }
}

const HEAD: &str = "\
| crate | author | field | attributes | imports | changed lines | functions | calls | inputs of its tests | legs differ | original differs | note |
|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|---|
";
