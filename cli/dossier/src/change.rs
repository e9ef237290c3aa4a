//! Changes of the C between two versions: functions, constants and types, the entry points that reach them, and the
//! reasons.
//!
//! Both versions are folders of C with their maps and manifests. Must not know: where the earlier version comes from.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use serde_json::Value;

use crate::calls::Calls;
use crate::requirements::Named;
use crate::requirements::rust::Item;
use crate::trace::Folder;

/// A version: its C, with the manifest, and its sources.
pub struct Version<'a> {
    /// The C.
    pub folder: &'a Folder,
    /// Text of the manifest of the C.
    pub manifest: &'a str,
    /// Rust sources by name.
    pub rust: &'a BTreeMap<String, String>,
    /// Text of `bessemer.toml`, if there is one.
    pub options: Option<&'a str>,
}

/// A part of the C that changed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// `function`, `constant or type`.
    pub kind: &'static str,
    /// Its name.
    pub name: String,
    /// Its file.
    pub file: String,
    /// `new`, `changed` or `removed`.
    pub what: &'static str,
    /// Reasons: the Rust, the options, the tool.
    pub why: String,
    /// Entry points that reach it.
    pub entries: Vec<String>,
}

/// A figure of an entry point that changed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Figure {
    /// The entry point.
    pub entry: String,
    /// Name of the figure.
    pub what: &'static str,
    /// Value before, or a dash.
    pub before: String,
    /// Value now, or a dash.
    pub now: String,
}

/// The changes.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Change {
    /// Name of the earlier version.
    pub since: String,
    /// Parts that changed.
    pub parts: Vec<Part>,
    /// Figures that changed.
    pub figures: Vec<Figure>,
    /// Entry points that reach a change.
    pub entries: Vec<String>,
    /// Requirements of changed functions.
    pub requirements: Vec<String>,
    /// Tests of these requirements, and tests that name a component whose entry points reach a change.
    pub tests: Vec<Named>,
    /// Numbers of functions that are equal to the byte, and of all.
    pub equal: (usize, usize),
    /// Files that are equal to the byte, with the hash of both.
    pub files: Vec<[String; 2]>,
}

/// Compares two versions; `since` is the name of the earlier one.
pub fn change(since: &str, before: &Version<'_>, now: &Version<'_>, items: &[Item]) -> Change {
    let (old, new) = (parts(before.folder), parts(now.folder));
    let calls = Calls::of(now.folder);
    let entries = entries(now.manifest);
    let reach = |names: &BTreeSet<String>| {
        let reaches = |entry: &&String| !calls.reached(entry).is_disjoint(names);
        entries.keys().filter(reaches).cloned().collect::<Vec<String>>()
    };
    let tool = tool_of(before.manifest) != tool_of(now.manifest);
    let options = before.options != now.options;
    let mut found = Change { since: since.to_owned(), ..Change::default() };
    let names: BTreeSet<&(&str, String)> = old.keys().chain(new.keys()).collect();
    for key in names {
        let (kind, name) = (key.0, &key.1);
        let (one, other) = (old.get(key), new.get(key));
        if kind == FUNCTION {
            found.equal.1 += usize::from(other.is_some());
        }
        let what = match (one, other) {
            (Some(one), Some(other)) if one.text == other.text => {
                found.equal.0 += usize::from(kind == FUNCTION);
                continue;
            }
            (Some(_), Some(_)) => "changed",
            (None, _) => "new",
            (_, None) => "removed",
        };
        let (Some(part), users) = (other.or(one), users(now.folder, kind, name)) else { continue };
        let rust = changed_rust(part, before, now);
        let mut why: Vec<String> = rust.into_iter().collect();
        why.extend(options.then(|| "bessemer.toml".to_owned()));
        why.extend(tool.then(|| "the version of bessemer".to_owned()));
        if why.is_empty() {
            why.push("a type, a constant or a callee of it".to_owned());
        }
        found.parts.push(Part {
            kind,
            name: name.clone(),
            file: part.file.clone(),
            what,
            why: why.join(", "),
            entries: reach(&users),
        });
    }
    let reached: BTreeSet<String> = found.parts.iter().flat_map(|it| it.entries.clone()).collect();
    found.entries = reached.into_iter().collect();
    found.figures = figures(before.manifest, now.manifest);
    let of_parts = |it: &&Item| {
        found.parts.iter().any(|part| {
            new.get(&(part.kind, part.name.clone())).is_some_and(|new| {
                let (file, line) = &new.rust;
                *file == it.file && (it.line..=it.last_line).contains(line)
            })
        })
    };
    let touched: BTreeSet<&String> =
        items.iter().filter(of_parts).flat_map(|it| &it.requirements).collect();
    let component = |entry: &String| entries.get(entry)?["component"].as_str();
    let components: BTreeSet<&str> = found.entries.iter().filter_map(component).collect();
    let again = |it: &&Item| {
        it.is_test
            && (it.requirements.iter().any(|id| touched.contains(id))
                || named(it, items).iter().any(|name| components.contains(name)))
    };
    found.tests = items
        .iter()
        .filter(again)
        .map(|it| Named { name: it.name.clone(), place: format!("{}:{}", it.file, it.line) })
        .collect();
    found.requirements = touched.into_iter().cloned().collect();
    for file in &now.folder.files {
        let same =
            before.folder.files.iter().any(|it| it.name == file.name && it.text == file.text);
        if same {
            let hash = crate::manifest::hash(file.text.as_bytes());
            found.files.push([file.name.clone(), hash]);
        }
    }
    found
}

/// Returns the names in a test, and in the functions of its file that it calls.
fn named<'i>(test: &'i Item, items: &'i [Item]) -> BTreeSet<&'i str> {
    let mut names: BTreeSet<&str> = BTreeSet::new();
    let mut open = vec![test];
    while let Some(item) = open.pop() {
        for word in &item.words {
            if names.insert(word) {
                let is_it = |it: &&Item| {
                    it.is_function
                        && it.file == test.file
                        && it.name.rsplit("::").next() == Some(word)
                };
                open.extend(items.iter().filter(is_it));
            }
        }
    }
    names
}

const FUNCTION: &str = "function";
const OTHER: &str = "constant or type";

/// A function, a type or a constant.
struct Text {
    text: String,
    file: String,
    rust: (String, u32),
    /// Lines of the Rust that it comes from.
    lines: Vec<(String, u32)>,
}

/// Returns the functions of a folder, and its other items: each with its text.
fn parts(folder: &Folder) -> BTreeMap<(&'static str, String), Text> {
    let mut parts = BTreeMap::new();
    for file in &folder.files {
        let lines: Vec<&str> = file.text.lines().collect();
        let mut add = |kind, name: String, first: u32, last: u32| {
            let text = lines[first as usize - 1..(last as usize).min(lines.len())].join("\n");
            let rows = file.rows.iter().filter(|row| (first..=last).contains(&row.c_line));
            let rust: Vec<(String, u32)> =
                rows.map(|row| (row.rust_file.clone(), row.rust_line)).collect();
            let own =
                file.counterpart(first).map(|(_, _, row)| (row.rust_file.clone(), row.rust_line));
            let own = own.or_else(|| rust.first().cloned()).unwrap_or_default();
            parts.insert(
                (kind, name),
                Text { text, file: file.name.clone(), rust: own, lines: rust },
            );
        };
        for function in &file.functions {
            add(FUNCTION, function.name.clone(), function.line, function.last_line);
        }
        // Other rows of the map: types, constants, prototypes are in headers.
        let in_function = |line: u32| {
            file.functions.iter().any(|it| file.head(it) <= line && line <= it.last_line)
        };
        for row in file.rows.iter().filter(|row| !in_function(row.c_line)) {
            let first = row.c_line;
            let mut last = first;
            while let Some(line) = lines.get(last as usize)
                && !line.trim().is_empty()
                && !lines[last as usize - 1].starts_with('}')
                && (!lines[last as usize - 1].ends_with(';')
                    || lines[last as usize - 1].starts_with(' '))
            {
                last += 1;
            }
            let head = lines[first as usize - 1];
            let name = match row.function.is_empty() || head.starts_with("typedef") {
                true => lines[last as usize - 1]
                    .trim_matches(|c: char| !c.is_ascii_alphanumeric())
                    .to_owned(),
                false => row.function.rsplit("::").next().unwrap_or_default().to_owned(),
            };
            // A prototype changes with its function.
            if !head.contains('(') || head.starts_with("#define") || head.starts_with("typedef") {
                add(OTHER, name, first, last);
            }
        }
    }
    parts
}

/// Returns the functions that a part concerns: itself, or those that mention its name.
fn users(folder: &Folder, kind: &str, name: &str) -> BTreeSet<String> {
    if kind == FUNCTION {
        return BTreeSet::from([name.to_owned()]);
    }
    let mut users = BTreeSet::new();
    for file in &folder.files {
        let lines: Vec<&str> = file.text.lines().collect();
        for function in &file.functions {
            let own = lines.get(function.line as usize - 1..function.last_line as usize);
            let mentions = |line: &&str| {
                line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                    .any(|word| word.eq_ignore_ascii_case(name))
            };
            if own.unwrap_or_default().iter().any(mentions) {
                users.insert(function.name.clone());
            }
        }
    }
    users
}

/// Returns the place of the Rust of a part whose text is another than before.
fn changed_rust(part: &Text, before: &Version<'_>, now: &Version<'_>) -> Option<String> {
    let (file, line) = &part.rust;
    let (old, new) = (before.rust.get(file), now.rust.get(file));
    if old == new {
        return None;
    }
    let old: BTreeSet<&str> = old.map(|it| it.lines().map(str::trim).collect()).unwrap_or_default();
    let new: Vec<&str> = new.map(|it| it.lines().collect()).unwrap_or_default();
    let changed = part.lines.iter().find(|(of, line)| {
        let text = new.get(line.saturating_sub(1) as usize).map(|it| it.trim());
        of == file && text.is_some_and(|text| !old.contains(text))
    });
    Some(changed.map_or_else(|| format!("{file}:{line}"), |(file, line)| format!("{file}:{line}")))
}

fn tool_of(manifest: &str) -> Option<String> {
    let manifest: Value = serde_json::from_str(manifest).ok()?;
    manifest["version"].as_str().map(str::to_owned)
}

/// Figures of entry points in the manifest of the C.
const FIGURES: [(&str, &str); 6] = [
    ("estimated_instructions", "estimated instructions of the longest path"),
    ("stack_bytes", "bytes of stack"),
    ("state_bytes", "bytes of state"),
    ("checks", "checks"),
    ("doubles", "operations in double"),
    ("longs", "operations in 64 bits"),
];

fn entries(manifest: &str) -> BTreeMap<String, Value> {
    let manifest: Value = serde_json::from_str(manifest).unwrap_or_default();
    let list = manifest["entries"].as_array().cloned().unwrap_or_default();
    let named = list.into_iter().filter_map(|it| Some((it["entry"].as_str()?.to_owned(), it)));
    named.collect()
}

fn figures(before: &str, now: &str) -> Vec<Figure> {
    let (before, now) = (entries(before), entries(now));
    let names: BTreeSet<&String> = before.keys().chain(now.keys()).collect();
    let value = |of: Option<&Value>, key: &str| {
        of.and_then(|it| it[key].as_u64()).map_or("–".to_owned(), |it| it.to_string())
    };
    // An earlier manifest may lack a figure altogether.
    let has = |key: &str| before.values().any(|it| !it[key].is_null());
    let mut figures = Vec::new();
    for name in names {
        for (key, what) in FIGURES.iter().copied().filter(|it| has(it.0)) {
            let (before, now) = (value(before.get(name), key), value(now.get(name), key));
            if before != now {
                figures.push(Figure { entry: name.clone(), what, before, now });
            }
        }
    }
    figures
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn folder(gain: &str, limit: &str) -> Folder {
        let c = format!(
            "static const double LIMIT = {limit};\n\nstatic double inner(double x)\n{{\n    return x * {gain};\n}}\n\n\
double motor_step(double x)\n{{\n    return inner(x);\n}}\n\ndouble motor_stop(double x)\n{{\n    return LIMIT;\n}}\n"
        );
        let map = "1\tsrc/lib.rs:1\tm::LIMIT\n3\tsrc/lib.rs:2\tm::inner\n5\tsrc/lib.rs:3\tm::inner\n\
8\tsrc/lib.rs:6\tm::Motor::step\n13\tsrc/lib.rs:9\tm::Motor::stop\n";
        let texts = BTreeMap::from([("m.c".to_owned(), c), ("m.c.map".to_owned(), map.to_owned())]);
        Folder::of(&texts, Path::new("x")).expect("a folder")
    }

    fn manifest(stack: u32, version: &str) -> String {
        format!(
            "{{\"version\": \"{version}\", \"entries\": [{{\"entry\": \"motor_step\", \"component\": \"Motor\", \"stack_bytes\": {stack}}}, {{\"entry\": \"motor_stop\"}}]}}"
        )
    }

    fn found(gain: &str, limit: &str, stack: u32, version: &str) -> Change {
        let rust = |gain: &str| {
            BTreeMap::from([("src/lib.rs".to_owned(), format!("LIMIT\nfn inner\nx * {gain}\n"))])
        };
        let (old, new) = (folder("2.0", "1.0"), folder(gain, limit));
        let (old_manifest, new_manifest) = (manifest(8, "1"), manifest(stack, version));
        let before =
            Version { folder: &old, manifest: &old_manifest, rust: &rust("2.0"), options: None };
        let now =
            Version { folder: &new, manifest: &new_manifest, rust: &rust(gain), options: None };
        let item =
            |name: &str, lines: (u32, u32), is_test, requirements: &[&str], words: &[&str]| Item {
                name: name.to_owned(),
                file: "src/lib.rs".to_owned(),
                line: lines.0,
                last_line: lines.1,
                is_test,
                is_function: true,
                requirements: requirements.iter().map(|it| (*it).to_owned()).collect(),
                words: words.iter().map(|it| (*it).to_owned()).collect(),
            };
        let items = [
            item("inner", (2, 4), false, &["A"], &[]),
            item("holds", (20, 21), true, &["A"], &[]),
            item("motor", (22, 23), false, &[], &["Motor"]),
            item("settles", (24, 25), true, &[], &["motor"]),
            item("adds", (26, 27), true, &[], &["Sum"]),
        ];
        change("v1", &before, &now, &items)
    }

    #[test]
    fn nothing_moves_without_a_change() {
        let same = found("2.0", "1.0", 8, "1");
        assert!(same.parts.is_empty() && same.figures.is_empty() && same.entries.is_empty());
        assert_eq!((same.equal, same.files.len()), ((3, 3), 1));
    }

    #[test]
    fn a_changed_function_leads_to_its_entries_requirements_and_tests() {
        let change = found("3.0", "1.0", 16, "1");
        let [part] = &change.parts[..] else { panic!("one part") };
        assert_eq!((&*part.name, part.what, &*part.why), ("inner", "changed", "src/lib.rs:3"));
        assert_eq!(change.entries, ["motor_step"]);
        assert_eq!(change.requirements, ["A"]);
        let tests: Vec<&str> = change.tests.iter().map(|it| &*it.name).collect();
        assert_eq!(tests, ["holds", "settles"]);
        assert_eq!(change.equal, (2, 3));
        let [figure] = &change.figures[..] else { panic!("one figure") };
        assert_eq!((&*figure.before, &*figure.now), ("8", "16"));
    }

    #[test]
    fn a_changed_constant_leads_to_what_uses_it() {
        let change = found("2.0", "5.0", 8, "2");
        let [part] = &change.parts[..] else { panic!("one part: {:?}", change.parts) };
        assert_eq!((part.kind, &*part.name), (OTHER, "LIMIT"));
        assert_eq!(part.why, "the version of bessemer");
        assert_eq!(change.entries, ["motor_stop"]);
    }
}
