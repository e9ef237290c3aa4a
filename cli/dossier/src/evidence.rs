//! Evidence of the tool: crates, rules of MISRA C with their places, notes for a qualification, and an auditor's
//! questions.
//!
//! The SBOM is written here: the crate for CycloneDX brings a validator and 60 crates for a list of 50 lines.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use serde_json::{Value, json};

use crate::scan::{Function, Kind, tokens::tokens};
use crate::trace::Folder;

/// Rules of MISRA C:2012 that the C deviates from: rule, category, reason. A test holds them to `docs/misra.md`.
const MISRA: &str = include_str!("../templates/misra.tsv");
/// An auditor's questions: source, question, section or a dash, answer.
const QUESTIONS: &str = include_str!("../templates/questions.tsv");
/// Notes for a qualification of the tool: heading, text.
const NOTES: &str = include_str!("../templates/notes.tsv");

/// Results of the project's own tests: test, result, command.
const TESTS: &str = include_str!("../templates/tests.tsv");

/// Evidence of the tool.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Evidence {
    /// Deviations from MISRA C.
    pub misra: Vec<Rule>,
    /// Crates with version, source and hash.
    pub crates: Vec<Crate>,
    /// Notes, by heading.
    pub notes: Vec<Note>,
    /// Results of the project's own tests.
    pub tests: Vec<[&'static str; 3]>,
    /// Questions.
    pub questions: Vec<Question>,
    /// Number of questions that a section answers.
    pub answered: usize,
}

/// Notes under one heading.
#[derive(Clone, Debug, Serialize)]
pub struct Note {
    /// Heading.
    pub heading: &'static str,
    /// Notes.
    pub texts: Vec<&'static str>,
}

/// A deviation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Rule {
    /// Number of the rule.
    pub rule: &'static str,
    /// Its category.
    pub category: &'static str,
    /// Reason of the deviation.
    pub reason: &'static str,
    /// Places in the C; none if the places need a checker.
    pub places: Option<Vec<String>>,
}

/// A crate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Crate {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    /// SHA-256 of its archive; empty for one of the workspace.
    pub hash: String,
}

/// A question of an auditor.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Question {
    /// Objective that it comes from.
    pub source: &'static str,
    /// The question.
    pub question: &'static str,
    /// Section that answers it; empty if that is the user's own work.
    pub section: &'static str,
    /// The answer, or what the user has to do.
    pub answer: &'static str,
}

/// Returns the rows of a table with this number of columns.
fn rows<const N: usize>(text: &'static str) -> impl Iterator<Item = [&'static str; N]> {
    let lines = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    lines.filter_map(|line| line.split('\t').map(str::trim).collect::<Vec<_>>().try_into().ok())
}

impl Evidence {
    /// Returns the evidence for the C in a folder.
    pub fn of(folder: &Folder, lock: &str, package: &str) -> Evidence {
        let misra = rows::<3>(MISRA).map(|[rule, category, reason]| Rule {
            rule,
            category,
            reason,
            places: places(rule, folder),
        });
        let questions: Vec<Question> = rows::<4>(QUESTIONS)
            .map(|[source, question, section, answer]| Question {
                source,
                question,
                section: if section == "-" { "" } else { section },
                answer,
            })
            .collect();
        let mut notes: Vec<Note> = Vec::new();
        for [heading, text] in rows::<2>(NOTES) {
            match notes.iter_mut().find(|it| it.heading == heading) {
                Some(note) => note.texts.push(text),
                None => notes.push(Note { heading, texts: vec![text] }),
            }
        }
        Evidence {
            misra: misra.collect(),
            crates: crates(lock, package).into_iter().map(|it| it.own).collect(),
            answered: questions.iter().filter(|it| !it.section.is_empty()).count(),
            notes,
            tests: rows::<3>(TESTS).collect(),
            questions,
        }
    }
}

/// Returns the places of a deviation that the text itself shows; none for a rule that needs types.
fn places(rule: &str, folder: &Folder) -> Option<Vec<String>> {
    let mut found = Vec::new();
    for file in &folder.files {
        let mut add = |line: u32| found.push(format!("{}:{line}", file.name));
        match rule {
            "15.5" => {
                for function in &file.functions {
                    returns(function, &file.text).into_iter().for_each(&mut add);
                }
            }
            "19.2" | "21.15" => {
                let word = if rule == "19.2" { "union" } else { "memcpy" };
                let all = tokens(&file.text);
                all.iter().filter(|it| it.text(&file.text) == word).for_each(|it| add(it.line));
            }
            "14.2" => {
                let counts_down =
                    |line: &str| line.trim_start().starts_with("for (") && line.contains("-- >");
                let lines = file.text.lines().zip(1..).filter(|(line, _)| counts_down(line));
                lines.for_each(|(_, number)| add(number));
            }
            _ => return None,
        }
    }
    Some(found)
}

/// Returns the lines of returns that are not the last statement.
fn returns(function: &Function, text: &str) -> Vec<u32> {
    let is_return = |start: usize| text.get(start..).is_some_and(|it| it.starts_with("return"));
    let last = function.statements.iter().map(|it| it.line).max();
    let leaves =
        function.statements.iter().filter(|it| it.kind == Kind::Leave && is_return(it.start));
    leaves.map(|it| it.line).filter(|line| Some(*line) != last).collect()
}

struct Locked {
    own: Crate,
    needs: Vec<String>,
    key: String,
}

/// Returns the crates that a package is built of, by `Cargo.lock`.
fn crates(lock: &str, package: &str) -> Vec<Locked> {
    let table = toml::de::DeTable::parse(lock).ok().map(toml::Spanned::into_inner);
    let list = table.as_ref().and_then(|it| it.get("package")?.get_ref().as_array());
    let mut all: BTreeMap<String, Locked> = BTreeMap::new();
    let mut versions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for entry in list.into_iter().flatten() {
        let word = |key: &str| {
            let value = entry.get_ref().get(key).and_then(|it| it.get_ref().as_str());
            value.unwrap_or_default().to_owned()
        };
        let needs = entry.get_ref().get("dependencies").and_then(|it| it.get_ref().as_array());
        let needs = needs.into_iter().flatten().filter_map(|it| it.get_ref().as_str());
        let needs =
            needs.map(|it| it.split_whitespace().take(2).collect::<Vec<_>>().join(" ")).collect();
        let own = Crate { name: word("name"), version: word("version"), hash: word("checksum") };
        let key = format!("{} {}", own.name, own.version);
        versions.entry(own.name.clone()).or_default().push(key.clone());
        all.insert(key.clone(), Locked { own, needs, key });
    }
    let full = |need: &str| match need.contains(' ') {
        true => Some(need.to_owned()),
        false => versions.get(need).and_then(|it| it.first()).cloned(),
    };
    let mut reached: BTreeSet<String> = BTreeSet::new();
    let mut open: Vec<String> = full(package).into_iter().collect();
    while let Some(key) = open.pop() {
        if let Some(locked) = all.get(&key)
            && reached.insert(key)
        {
            open.extend(locked.needs.iter().filter_map(|need| full(need)));
        }
    }
    all.retain(|key, _| reached.contains(key));
    let full: BTreeMap<String, Vec<String>> = all
        .iter()
        .map(|(key, it)| (key.clone(), it.needs.iter().filter_map(|need| full(need)).collect()))
        .collect();
    let mut list: Vec<Locked> = all.into_values().collect();
    for it in &mut list {
        it.needs = full.get(&it.key).cloned().unwrap_or_default();
    }
    list
}

/// Returns the SBOM of a package in the form of CycloneDX 1.6, without a date and a serial number.
pub fn sbom(lock: &str, package: &str, tool: &str, rustc: &str) -> String {
    let crates = crates(lock, package);
    let reference = |key: &str| format!("pkg:cargo/{}", key.replace(' ', "@"));
    let component = |it: &Locked| {
        let mut json = json!({
            "type": "library",
            "bom-ref": reference(&it.key),
            "name": it.own.name,
            "version": it.own.version,
            "purl": reference(&it.key),
        });
        if !it.own.hash.is_empty() {
            json["hashes"] = json!([{ "alg": "SHA-256", "content": it.own.hash }]);
        }
        json
    };
    let (own, others): (Vec<&Locked>, Vec<&Locked>) =
        crates.iter().partition(|it| it.own.name == package);
    let subject = own.first().map_or_else(
        || json!({ "type": "library", "bom-ref": package, "name": package }),
        |it| component(it),
    );
    let depends = crates.iter().map(|it| {
        let needs: Vec<String> = it.needs.iter().map(|need| reference(need)).collect();
        json!({ "ref": reference(&it.key), "dependsOn": needs })
    });
    let json = json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {
            "component": subject,
            "tools": { "components": [
                { "type": "application", "name": "bessemer", "version": tool },
                { "type": "application", "name": "rustc", "version": rustc },
            ] },
        },
        "components": others.into_iter().map(component).collect::<Vec<Value>>(),
        "dependencies": depends.collect::<Vec<Value>>(),
    });
    format!("{json:#}\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn root() -> std::path::PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
    }

    /// The table is the one of the book.
    #[test]
    fn deviations_are_those_of_the_page() {
        let page = std::fs::read_to_string(root().join("docs/misra.md")).expect("the page");
        let of_page: Vec<String> = page
            .lines()
            .filter(|line| line.starts_with("| ") && line.contains(char::is_numeric))
            .map(|line| line.trim_matches(['|', ' ']).replace(" | ", "\t"))
            .collect();
        let own: Vec<String> = rows::<3>(MISRA).map(|row| row.join("\t")).collect();
        assert_eq!(own, of_page);
    }

    /// The figure on the page is the number of patches that there are.
    #[test]
    fn the_page_has_the_number_of_mutants() {
        let patches = std::fs::read_dir(root().join("tests/mutants")).expect("a folder").count();
        let row = rows::<3>(TESTS).find(|row| row[0].contains("tests/mutants")).expect("a row");
        assert!(row[1].contains(&format!(" of {patches} ")), "{patches}: {}", row[1]);
    }

    /// The figures of random programs are those of their tests.
    #[test]
    fn the_page_has_the_numbers_of_random_programs() {
        let found = std::fs::read_dir(root().join("tests/found")).expect("a folder").count();
        let text = std::fs::read_to_string(root().join("tests/tests/random/mod.rs"));
        let text = text.expect("the tests");
        let number = |name: &str| {
            let rest = text.split_once(&format!("const {name}: usize = ")).expect("a constant").1;
            rest.split(';').next().expect("a number").to_owned()
        };
        let row = rows::<3>(TESTS).find(|row| row[0].contains("Random")).expect("a row");
        let (fewer, all) = (number("FEWER"), number("PROGRAMS"));
        for wanted in [
            format!(" {fewer} programs "),
            format!(" full run {all},"),
            format!(" of the {found} "),
        ] {
            assert!(row[1].contains(&wanted), "{wanted}: {}", row[1]);
        }
    }

    #[test]
    fn there_are_forty_questions_and_each_has_an_answer() {
        let rows: Vec<_> = rows::<4>(QUESTIONS).collect();
        let lines = QUESTIONS.lines().filter(|it| !it.is_empty() && !it.starts_with('#')).count();
        assert_eq!((rows.len(), lines), (40, 40));
        for [source, question, section, answer] in rows {
            assert!(question.ends_with('?') && !answer.is_empty(), "{source}: {question}");
            assert!(
                section == "-"
                    || section == "trace"
                    || crate::page::SECTIONS.iter().any(|it| it.0 == section),
                "{section}"
            );
        }
    }

    const LOCK: &str = "\
[[package]]\nname = \"motor\"\nversion = \"0.1.0\"\ndependencies = [\"bessemer\", \"syn 2.0.0\"]\n\
[[package]]\nname = \"bessemer\"\nversion = \"0.1.0\"\n\
[[package]]\nname = \"syn\"\nversion = \"2.0.0\"\nsource = \"registry\"\nchecksum = \"ab12\"\n\
[[package]]\nname = \"syn\"\nversion = \"3.0.0\"\nsource = \"registry\"\nchecksum = \"cd34\"\n\
[[package]]\nname = \"other\"\nversion = \"1.0.0\"\n";

    #[test]
    fn the_sbom_has_what_the_package_is_built_of() {
        let text = sbom(LOCK, "motor", "0.1.0", "1.95.0");
        let json: Value = serde_json::from_str(&text).expect("it is JSON");
        assert_eq!(json["metadata"]["component"]["purl"], "pkg:cargo/motor@0.1.0");
        let names: Vec<_> = json["components"]
            .as_array()
            .into_iter()
            .flatten()
            .map(|it| it["purl"].clone())
            .collect();
        assert_eq!(names, ["pkg:cargo/bessemer@0.1.0", "pkg:cargo/syn@2.0.0"]);
        assert_eq!(json["components"][1]["hashes"][0]["content"], "ab12");
        assert_eq!(json["dependencies"][1]["dependsOn"][1], "pkg:cargo/syn@2.0.0");
        assert!(sbom("", "motor", "", "").contains("CycloneDX"));
    }

    #[test]
    fn early_returns_are_found() {
        let texts = BTreeMap::from([(
            "a.c".to_owned(),
            "int f(int a)\n{\n    if (a) {\n        return 1;\n    }\n    return 2;\n}\n"
                .to_owned(),
        )]);
        let folder = Folder::of(&texts, Path::new("x")).expect("a folder");
        assert_eq!(places("15.5", &folder), Some(vec!["a.c:4".to_owned()]));
        assert_eq!(places("10.5", &folder), None);
    }
}
