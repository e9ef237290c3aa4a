//! Programs that once differed, made small: a file each in `tests/found`, half of which run beside the random ones of a run.
//!
//! The first line of a file says what of it is called; it is `cargo xtask fuzz` that writes them. One that fails stays: a
//! mend shows by its passing.

use std::path::{Path, PathBuf};

use bessemer_tests::root;
use serde_json::{Value, json};

use super::shrink::named;
use super::writer::{Entry, Program};

/// How a parameter is passed.
const PASSINGS: [&str; 3] = ["", "&", "&mut "];

fn folder() -> PathBuf {
    root().join("tests/found")
}

/// Writes a program down, and says where.
pub fn keep(program: &Program, seed: u64) -> PathBuf {
    let program = named(program, &program.text, &format!("found_{seed}_{}", program.name));
    let path = folder().join(format!("{}.rs", program.name));
    std::fs::create_dir_all(folder()).expect("a folder for what was found");
    std::fs::write(&path, format!("// {}\n{}", head(&program), program.text)).expect("a file");
    path
}

/// All that are kept.
pub fn programs() -> Vec<Program> {
    programs_in(&folder())
}

/// Those of any folder.
pub fn programs_in(folder: &Path) -> Vec<Program> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|it| it == "rs"));
    paths.sort();
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a program that was found");
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        program(&name, &text).unwrap_or_else(|| panic!("{}: its first line", path.display()))
    };
    paths.into_iter().map(read).collect()
}

fn head(program: &Program) -> Value {
    let entry = |entry: &Entry| {
        json!({
            "name": entry.name, "params": entry.params, "atomic": entry.atomic, "stops": entry.stops
        })
    };
    let entries: Vec<Value> = program.entries.iter().map(entry).collect();
    json!({ "unit": program.unit, "entries": entries, "instances": program.instances })
}

fn program(name: &str, text: &str) -> Option<Program> {
    let (first, text) = text.split_once('\n')?;
    let head: Value = serde_json::from_str(first.strip_prefix("// ")?).ok()?;
    let entry = |entry: &Value| {
        let param = |param: &Value| {
            let passing = PASSINGS.into_iter().find(|it| param[0] == *it)?;
            Some((passing, param[1].as_str()?.to_owned()))
        };
        Some(Entry {
            name: entry["name"].as_str()?.to_owned(),
            params: entry["params"].as_array()?.iter().map(param).collect::<Option<_>>()?,
            atomic: entry["atomic"].as_bool()?,
            stops: entry["stops"].as_bool()?,
        })
    };
    Some(Program {
        name: name.to_owned(),
        text: text.to_owned(),
        unit: head["unit"].as_str().map(str::to_owned),
        entries: head["entries"].as_array()?.iter().map(entry).collect::<Option<_>>()?,
        instances: head["instances"].as_u64().map(|it| it as usize),
    })
}

#[test]
fn what_is_kept_is_read_as_it_was() {
    let mut random = bessemer_tests::random::Random(3);
    for index in 0..20 {
        let one = super::writer::program(&mut random, &format!("p{index}"));
        let text = format!("// {}\n{}", head(&one), one.text);
        let read = program(&one.name, &text).expect("its own text");
        assert_eq!((head(&read), &read.text, &read.name), (head(&one), &one.text, &one.name));
    }
}
