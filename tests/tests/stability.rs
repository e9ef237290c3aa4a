//! Which bytes move when something changes: only those that must.
//!
//! A firmware team pays for every changed line with a retest. A copy of the flight models is changed
//! as an author would change it, generated again, and the two folders are compared.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use bessemer_codegen::generate::{self, Job};
use bessemer_tests::root;
use tempfile::TempDir;

type Files = BTreeMap<String, String>;

/// A workspace of its own that holds a copy of the flight models.
struct Copy(TempDir);

impl Copy {
    fn new() -> Copy {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let (root, copy) = (root().canonicalize().expect("the workspace"), Copy(folder));
        copy_folder(&root.join("models"), &copy.path("models"));
        let lock = fs::read_to_string(root.join("Cargo.lock")).expect("the lock file");
        fs::write(copy.path("Cargo.lock"), lock).expect("a lock file");
        let workspace = fs::read_to_string(root.join("Cargo.toml")).expect("the manifest");
        let start = workspace.find("members").expect("members");
        let end = start + workspace[start..].find('\n').expect("a line");
        let workspace = workspace
            .replace(&workspace[start..end], "members = [\"models\"]")
            .replace("path = \"", &format!("path = \"{}/", root.display()))
            .replace(&format!("path = \"{}/models\"", root.display()), "path = \"models\"");
        fs::write(copy.path("Cargo.toml"), workspace).expect("a manifest");
        // One target folder for all, so that only the models are built anew.
        fs::create_dir(copy.path(".cargo")).expect("a folder");
        let config = format!("[build]\ntarget-dir = \"{}\"\n", root.join("target").display());
        fs::write(copy.path(".cargo/config.toml"), config).expect("a configuration");
        copy
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    /// Replaces `old` by `new` in each source file that has it.
    fn replace(&self, old: &str, new: &str) {
        let mut found = false;
        for entry in fs::read_dir(self.path("models/src")).expect("the sources").flatten() {
            let Ok(text) = fs::read_to_string(entry.path()) else { continue };
            found |= text.contains(old);
            fs::write(entry.path(), text.replace(old, new)).expect("a source file");
        }
        assert!(found, "`{old}` is not in the models");
    }

    fn generate(&self, version: &str) -> Files {
        let mut job = Job::new(self.0.path(), "models");
        job.version = version.to_owned();
        generate::generate(&job).unwrap_or_else(|error| panic!("{error}"));
        let entries = fs::read_dir(&job.output).expect("the output").flatten();
        entries
            .map(|entry| {
                let text = fs::read_to_string(entry.path()).expect("a generated file");
                (entry.file_name().to_string_lossy().into_owned(), text)
            })
            .collect()
    }
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder").flatten() {
        let (path, target) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() {
            copy_folder(&path, &target);
        } else {
            fs::copy(&path, &target).expect("a file");
        }
    }
}

/// The names of the files that differ.
fn moved(before: &Files, after: &Files) -> Vec<String> {
    let names: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
    names.into_iter().filter(|name| before.get(*name) != after.get(*name)).cloned().collect()
}

/// One test, since all of it is one package built again and again.
#[test]
fn only_what_must_move_moves() {
    let copy = Copy::new();
    let version = env!("CARGO_PKG_VERSION");
    let before = copy.generate(version);

    let committed = fs::read_to_string(root().join("generated/height.c")).expect("committed C");
    assert_eq!(before["height.c"], committed, "the place of the workspace does not matter");
    assert_eq!(moved(&before, &copy.generate(version)), [""; 0], "generating twice");

    // The tool's version: the manifest alone.
    assert_eq!(moved(&before, &copy.generate("99.0.0")), ["manifest.json"]);

    // A comment on top of a model: the map of its lines, no C.
    copy.replace("//! How hard to push: the height loop", "// A comment.\n//! How hard to push: the height loop");
    let commented = copy.generate(version);
    assert_eq!(moved(&before, &commented), ["height.c.map", "height.h.map"]);

    // A constant: the one C file that uses it, and there one line.
    copy.replace("GRAVITY: f64 = 9.81;", "GRAVITY: f64 = 9.80665;");
    let heavier = copy.generate(version);
    assert_eq!(moved(&commented, &heavier), ["height.c"]);
    let lines = commented["height.c"].lines().zip(heavier["height.c"].lines());
    assert_eq!(lines.filter(|(one, other)| one != other).count(), 1);

    // A shared type: the files that name it, and there the lines that name it.
    copy.replace("Target", "Goal");
    let renamed = copy.generate(version);
    let naming: Vec<String> = heavier
        .iter()
        .filter(|(name, text)| !name.ends_with(".map") && text.contains("target_t"))
        .map(|(name, _)| name.clone())
        .collect();
    let mut sources = moved(&heavier, &renamed);
    sources.retain(|name| !name.ends_with(".map"));
    assert_eq!(sources, naming);
    for name in &naming {
        let back = renamed[name].replace("goal_t", "target_t");
        // A shorter name may let two lines be joined; nothing else may change.
        let joined = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(joined(&back), joined(&heavier[name]), "{name}");
    }

    // A new model that uses what is there: its own files, and the manifest that lists them.
    let model = "//! Counts.\nuse crate::signals::Goal;\nuse bessemer::prelude::*;\n\n\
        /// Counts landings.\n#[component]\n#[derive(Clone, Debug, Default, PartialEq)]\n\
        pub struct Counter {\n    /// How many.\n    pub landings: f64,\n}\n\n#[component]\n\
        impl Counter {\n    /// One period.\n    #[entry(infallible)]\n    \
        pub fn step(&mut self, goal: &Goal) {\n        if goal.land {\n            \
        self.landings += 1.0;\n        }\n    }\n}\n";
    fs::write(copy.path("models/src/counter.rs"), model).expect("a source file");
    copy.replace("pub mod height;", "pub mod counter;\npub mod height;");
    let added = copy.generate(version);
    let new = ["counter.c", "counter.c.map", "counter.h", "counter.h.map", "manifest.json"];
    assert_eq!(moved(&renamed, &added), new);
}
