//! Requirements: which items of the Rust, which functions of the C and which tests belong to each, and what has none.
//!
//! Must not know: how tests are run, or how the matrix is shown.

pub mod rust;
pub mod table;

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::trace::Folder;
use rust::Item;
use table::Requirement;

/// Results of tests by file and name.
pub type Results = BTreeMap<String, bool>;

/// A place with a name, for a page.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Named {
    /// Name of the item.
    pub name: String,
    /// Its place: `models/src/height.rs:26`.
    pub place: String,
}

/// A test, with its result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Test {
    /// Name of the test.
    pub name: String,
    /// Its place.
    pub place: String,
    /// `passed`, `failed` or `not run`.
    pub result: String,
}

/// A row of the matrix.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Row {
    /// Identifier of the requirement.
    pub id: String,
    /// Its text, if a list has one.
    pub text: String,
    /// Items of the Rust.
    pub rust: Vec<Named>,
    /// Functions, types and constants of the C.
    pub c: Vec<Named>,
    /// Tests.
    pub tests: Vec<Test>,
    /// `passed` if it has a test and each passed; else the reason why not.
    pub verdict: String,
}

/// The matrix.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Matrix {
    /// Rows in the order of the list, then those that only the sources name.
    pub rows: Vec<Row>,
    /// Identifiers that the sources name and the list does not have.
    pub unknown: Vec<String>,
    /// Functions of the models without a requirement.
    pub untraced: Vec<Named>,
    /// Tests without a requirement.
    pub untraced_tests: Vec<Test>,
    /// True if a list was read.
    pub listed: bool,
}

impl Matrix {
    /// Builds the matrix of a list, if there is one, and the items of all sources.
    pub fn of(
        list: Option<&[Requirement]>,
        items: &[Item],
        c: &Folder,
        results: &Results,
    ) -> Matrix {
        let named: BTreeSet<&String> = items.iter().flat_map(|it| &it.requirements).collect();
        let mut ids: Vec<(String, String)> = Vec::new();
        for it in list.unwrap_or_default() {
            ids.push((it.id.clone(), it.text.clone()));
        }
        let mut unknown = Vec::new();
        for id in named {
            if !ids.iter().any(|(known, _)| known == id) {
                ids.push((id.clone(), String::new()));
                unknown.extend(list.is_some().then(|| id.clone()));
            }
        }
        let has = |it: &&Item, id: &str| it.requirements.iter().any(|own| own == id);
        let rows = ids.into_iter().map(|(id, text)| {
            let own = || items.iter().filter(|it| has(it, &id));
            let rust: Vec<&Item> = own().filter(|it| !it.is_test).collect();
            let tests: Vec<Test> =
                own().filter(|it| it.is_test).map(|it| test(it, results)).collect();
            let verdict = verdict(&rust, &tests);
            let c = rust.iter().flat_map(|it| in_c(it, c)).collect();
            Row { rust: rust.into_iter().map(named_item).collect(), c, tests, verdict, id, text }
        });
        let rows = rows.collect();
        let none = |it: &&Item| it.requirements.is_empty();
        let becomes_c = |it: &&Item| it.is_function && !it.is_test && !in_c(it, c).is_empty();
        Matrix {
            rows,
            unknown,
            untraced: items.iter().filter(none).filter(becomes_c).map(named_item).collect(),
            untraced_tests: items
                .iter()
                .filter(none)
                .filter(|it| it.is_test)
                .map(|it| test(it, results))
                .collect(),
            listed: list.is_some(),
        }
    }

    /// Returns the rows as tables and other tools take them.
    pub fn cells(&self) -> Vec<[String; 6]> {
        let joined =
            |list: &[Named]| list.iter().map(|it| it.name.clone()).collect::<Vec<_>>().join(" ");
        let tests =
            |row: &Row| row.tests.iter().map(|it| it.name.clone()).collect::<Vec<_>>().join(" ");
        let cells = |row: &Row| {
            [
                row.id.clone(),
                row.text.clone(),
                joined(&row.rust),
                joined(&row.c),
                tests(row),
                row.verdict.clone(),
            ]
        };
        self.rows.iter().map(cells).collect()
    }
}

fn named_item(it: &Item) -> Named {
    Named { name: it.name.clone(), place: format!("{}:{}", it.file, it.line) }
}

fn test(it: &Item, results: &Results) -> Test {
    let result = match results.get(&format!("{}:{}", it.file, it.name)) {
        Some(true) => "passed",
        Some(false) => "failed",
        None => "not run",
    };
    Test {
        name: it.name.clone(),
        place: format!("{}:{}", it.file, it.line),
        result: result.to_owned(),
    }
}

fn verdict(rust: &[&Item], tests: &[Test]) -> String {
    let any = |result: &str| tests.iter().any(|it| it.result == result);
    match () {
        () if rust.is_empty() => "no Rust",
        () if tests.is_empty() => "no test",
        () if any("failed") => "failed",
        () if any("not run") => "not run",
        () => "passed",
    }
    .to_owned()
}

/// Returns the functions, types and constants of the C whose line of Rust is in an item.
fn in_c(item: &Item, c: &Folder) -> Vec<Named> {
    let mut found: Vec<Named> = Vec::new();
    for file in &c.files {
        for function in &file.functions {
            let row = file.counterpart(function.line).map(|(_, _, row)| row);
            let own = row.is_some_and(|row| {
                row.rust_file == item.file && (item.line..=item.last_line).contains(&row.rust_line)
            });
            if own && !found.iter().any(|it| it.name == function.name) {
                let place = format!("{}:{}", file.name, function.line);
                found.push(Named { name: function.name.clone(), place });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn c() -> Folder {
        let texts = BTreeMap::from([
            (
                "motor.c".to_owned(),
                "void motor_step(void)\n{\n    x = 1;\n}\nvoid motor_stop(void)\n{\n}\n".to_owned(),
            ),
            (
                "motor.c.map".to_owned(),
                "1\tsrc/lib.rs:9\tm::Motor::step\n5\tsrc/lib.rs:20\tm::Motor::stop\n".to_owned(),
            ),
        ]);
        Folder::of(&texts, Path::new("x")).expect("a folder")
    }

    fn item(name: &str, lines: (u32, u32), is_test: bool, requirements: &[&str]) -> Item {
        Item {
            name: name.to_owned(),
            file: if is_test { "tests/a.rs" } else { "src/lib.rs" }.to_owned(),
            line: lines.0,
            last_line: lines.1,
            is_test,
            is_function: true,
            requirements: requirements.iter().map(|it| (*it).to_owned()).collect(),
            words: BTreeSet::new(),
        }
    }

    #[test]
    fn the_matrix_has_both_ways_and_what_has_none() {
        let items = [
            item("Motor::step", (8, 12), false, &["A", "B", "X"]),
            item("Motor::stop", (19, 21), false, &[]),
            item("host", (30, 31), false, &[]),
            item("holds", (1, 3), true, &["A"]),
            item("falls", (5, 6), true, &["B"]),
            item("other", (7, 8), true, &[]),
        ];
        let list = ["A", "B", "C"]
            .map(|id| Requirement { id: id.to_owned(), text: format!("text of {id}") });
        let results = Results::from([
            ("tests/a.rs:holds".to_owned(), true),
            ("tests/a.rs:falls".to_owned(), false),
        ]);
        let matrix = Matrix::of(Some(&list), &items, &c(), &results);
        let rows: Vec<_> = matrix.cells().iter().map(|row| row.join("|")).collect();
        assert_eq!(
            rows,
            [
                "A|text of A|Motor::step|motor_step|holds|passed",
                "B|text of B|Motor::step|motor_step|falls|failed",
                "C|text of C||||no Rust",
                "X||Motor::step|motor_step||no test",
            ]
        );
        let names = |list: &[Named]| list.iter().map(|it| it.name.clone()).collect::<Vec<_>>();
        assert_eq!(matrix.unknown, ["X"]);
        assert_eq!(names(&matrix.untraced), ["Motor::stop"]);
        assert_eq!(matrix.untraced_tests.len(), 1);
        let without = Matrix::of(None, &items, &c(), &Results::new());
        assert!(without.unknown.is_empty() && without.rows.len() == 3);
        assert_eq!(without.rows[0].verdict, "not run");
    }
}
