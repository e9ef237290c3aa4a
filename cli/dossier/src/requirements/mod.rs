//! Requirements: which items of the Rust, which functions of the C and which tests belong to each, and what has none.
//!
//! Must not know: how tests are run, or how the matrix is shown.

mod reqif;
pub mod rust;
pub mod table;

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::trace::Folder;
use rust::Item;
use table::Requirement;

/// Number of identifiers and places that a summary shows.
const SHOWN: usize = 8;

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

/// An item or a test with the requirements that it names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Traced {
    /// Name of the item or the test.
    pub name: String,
    /// Its place.
    pub place: String,
    /// Its functions, types and constants of the C.
    pub c: Vec<Named>,
    /// Result of a test; empty for an item.
    pub result: String,
    /// Identifiers of its requirements.
    pub requirements: Vec<String>,
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
    /// Items that name a requirement, in the order of the sources.
    pub traced: Vec<Traced>,
    /// Tests that name a requirement.
    pub traced_tests: Vec<Traced>,
    /// Identifiers that the sources name and the list does not have, with each place.
    pub unknown: Vec<Named>,
    /// Functions of the models without a requirement.
    pub untraced: Vec<Named>,
    /// Tests without a requirement.
    pub untraced_tests: Vec<Test>,
    /// Path of the list; empty if none was read.
    pub list: String,
}

impl Matrix {
    /// Builds the matrix of a list with its path, if there is one, and the items of all sources.
    pub fn of(
        list: Option<(&str, &[Requirement])>,
        items: &[Item],
        c: &Folder,
        results: &Results,
    ) -> Matrix {
        let (path, list) = list.unwrap_or_default();
        let named: BTreeSet<&String> = items.iter().flat_map(|it| &it.requirements).collect();
        let listed: BTreeSet<&String> = list.iter().map(|it| &it.id).collect();
        let mut ids: Vec<(String, String)> =
            list.iter().map(|it| (it.id.clone(), it.text.clone())).collect();
        let others = named.difference(&listed).copied();
        ids.extend(others.clone().map(|id| (id.clone(), String::new())));
        let places = |id: &String| {
            let own = items.iter().filter(|it| it.requirements.contains(id));
            own.map(|it| Named { name: id.clone(), place: place(it) }).collect::<Vec<_>>()
        };
        let unknown = match path {
            "" => Vec::new(),
            _ => others.flat_map(places).collect(),
        };
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
        let traced = |it: &Item, c: Vec<Named>, result: String| Traced {
            name: it.name.clone(),
            place: place(it),
            c,
            result,
            requirements: it.requirements.clone(),
        };
        let some = |is_test: bool| {
            items.iter().filter(move |it| !it.requirements.is_empty() && it.is_test == is_test)
        };
        let none = |it: &&Item| it.requirements.is_empty();
        let becomes_c = |it: &&Item| it.is_function && !it.is_test && !in_c(it, c).is_empty();
        Matrix {
            rows,
            traced: some(false).map(|it| traced(it, in_c(it, c), String::new())).collect(),
            traced_tests: some(true)
                .map(|it| traced(it, Vec::new(), test(it, results).result))
                .collect(),
            unknown,
            untraced: items.iter().filter(none).filter(becomes_c).map(named_item).collect(),
            untraced_tests: items
                .iter()
                .filter(none)
                .filter(|it| it.is_test)
                .map(|it| test(it, results))
                .collect(),
            list: path.to_owned(),
        }
    }

    /// Returns the count of each verdict with the requirements that have not passed, and what names none: one line each.
    pub fn summary(&self) -> Vec<String> {
        if self.rows.is_empty() && self.list.is_empty() {
            return Vec::new();
        }
        let mut verdicts: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        let is_unknown = |row: &&Row| self.unknown.iter().any(|it| it.name == row.id);
        for row in self.rows.iter().filter(|row| !is_unknown(row)) {
            verdicts.entry(&row.verdict).or_default().push(&row.id);
        }
        let all: usize = verdicts.values().map(Vec::len).sum();
        let counts = verdicts.iter().map(|(verdict, ids)| match ids.len() == all {
            true => format!("{all} {verdict}"),
            false if *verdict == "passed" => format!("{} passed", ids.len()),
            false => format!("{} {verdict}: {}", ids.len(), some(ids)),
        });
        let list = match &*self.list {
            "" => "of no list".to_owned(),
            path => format!("of `{path}`"),
        };
        let counts: Vec<String> = counts.collect();
        let mut lines = vec![format!("{all} {list}; {}", counts.join("; "))];
        for it in self.unknown.iter().take(SHOWN) {
            lines.push(format!("`{}` at {} is not in the list", it.name, it.place));
        }
        if let more @ 1.. = self.unknown.len().saturating_sub(SHOWN) {
            lines.push(format!("{more} more places name requirements that are not in the list"));
        }
        let (items, tests) = (self.untraced.len(), self.untraced_tests.len());
        lines.push(format!("no requirement is named by {items} functions and {tests} tests"));
        lines
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

/// Returns the first identifiers, with the count of the others.
fn some(ids: &[&str]) -> String {
    let first = ids[..ids.len().min(SHOWN)].join(" ");
    match ids.len().saturating_sub(SHOWN) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}

fn place(it: &Item) -> String {
    format!("{}:{}", it.file, it.line)
}

fn named_item(it: &Item) -> Named {
    Named { name: it.name.clone(), place: place(it) }
}

fn test(it: &Item, results: &Results) -> Test {
    let result = match results.get(&format!("{}:{}", it.file, it.name)) {
        Some(true) => "passed",
        Some(false) => "failed",
        None => "not run",
    };
    Test { name: it.name.clone(), place: place(it), result: result.to_owned() }
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
        if item.is_function {
            continue;
        }
        let lines: Vec<&str> = file.text.lines().collect();
        for row in file.rows.iter().filter(|row| row.rust_file == item.file) {
            let within = (item.line..=item.last_line).contains(&row.rust_line);
            let Some(name) = declared(&lines, row.c_line).filter(|_| within) else { continue };
            if !found.iter().any(|it| it.name == name) {
                found.push(Named { name, place: format!("{}:{}", file.name, row.c_line) });
            }
        }
    }
    found
}

/// Returns the name of the type or the constant that is declared at a line; none for anything else.
fn declared(lines: &[&str], line: u32) -> Option<String> {
    let rest = lines.get((line as usize).checked_sub(1)?..)?;
    let first = rest.first()?.trim();
    let is_name = |it: &&str| !it.is_empty() && !it.contains(|c: char| !is_of_name(c));
    if let Some(defined) = first.strip_prefix("#define ") {
        return defined.split(|c| !is_of_name(c)).next().filter(is_name).map(str::to_owned);
    }
    if first.starts_with("typedef ") {
        let last = rest.iter().find_map(|it| it.strip_prefix("} "))?;
        return last.strip_suffix(';').filter(is_name).map(str::to_owned);
    }
    let is_constant = ["static const ", "extern const ", "const "];
    if !is_constant.iter().any(|it| first.starts_with(it)) {
        return None;
    }
    let before = first.split(['=', '[', ';']).next()?.trim_end();
    before.rsplit(|c| !is_of_name(c)).next().filter(is_name).map(str::to_owned)
}

fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
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
        let matrix = Matrix::of(Some(("hlr.csv", &list)), &items, &c(), &results);
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
        let unknown = Named { name: "X".to_owned(), place: "src/lib.rs:8".to_owned() };
        assert_eq!(matrix.unknown, [unknown]);
        assert_eq!(names(&matrix.untraced), ["Motor::stop"]);
        assert_eq!(matrix.untraced_tests.len(), 1);
        // And back: from an item and a test to its requirements.
        let back = |list: &[Traced]| {
            let one = |it: &Traced| {
                let c: Vec<_> = it.c.iter().map(|it| &*it.name).collect();
                [&it.name, &*c.join(" "), &it.result, &*it.requirements.join(" ")].join("|")
            };
            list.iter().map(one).collect::<Vec<_>>()
        };
        assert_eq!(back(&matrix.traced), ["Motor::step|motor_step||A B X"]);
        assert_eq!(back(&matrix.traced_tests), ["holds||passed|A", "falls||failed|B"]);
        assert_eq!(
            matrix.summary(),
            [
                "3 of `hlr.csv`; 1 failed: B; 1 no Rust: C; 1 passed",
                "`X` at src/lib.rs:8 is not in the list",
                "no requirement is named by 1 functions and 1 tests",
            ]
        );
        let without = Matrix::of(None, &items, &c(), &Results::new());
        assert!(without.unknown.is_empty() && without.rows.len() == 3);
        assert_eq!(some(&["A"; 8]), "A A A A A A A A");
        assert_eq!(some(&["A"; 10]), "A A A A A A A A and 2 more");
        assert!(Matrix::of(None, &[], &c(), &Results::new()).summary().is_empty());
        assert_eq!(without.rows[0].verdict, "not run");
    }

    #[test]
    fn types_and_constants_lead_to_their_declarations() {
        let texts = BTreeMap::from([
            (
                "motor.h".to_owned(),
                "#define MOTOR_SPEED 4\ntypedef struct {\n    int a;\n} motor_t;\nextern const double TABLE[2];\n".to_owned(),
            ),
            (
                "motor.h.map".to_owned(),
                "1\tsrc/lib.rs:2\tm::SPEED\n2\tsrc/lib.rs:5\t\n5\tsrc/lib.rs:9\tm::TABLE\n".to_owned(),
            ),
            ("motor.c".to_owned(), "static const double LIMIT = 0.5;\n".to_owned()),
            ("motor.c.map".to_owned(), "1\tsrc/lib.rs:12\tm::LIMIT\n".to_owned()),
        ]);
        let c = Folder::of(&texts, Path::new("x")).expect("a folder");
        let names = |lines: (u32, u32)| {
            let item = Item { is_function: false, ..item("x", lines, false, &[]) };
            in_c(&item, &c).into_iter().map(|it| it.name).collect::<Vec<_>>()
        };
        assert_eq!(names((1, 2)), ["MOTOR_SPEED"]);
        assert_eq!(names((4, 7)), ["motor_t"]);
        assert_eq!(names((8, 9)), ["TABLE"]);
        assert_eq!(names((11, 12)), ["LIMIT"]);
        assert!(names((20, 30)).is_empty());
    }
}
