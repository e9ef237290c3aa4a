//! Bytes of the C that change with the source: only those that must.
//!
//! A firmware team pays for every changed line with a retest. A copy of the flight models is changed
//! as an author would change it, generated again, and the two folders are compared.

use std::collections::BTreeSet;
use std::fs;

use bessemer_tests::root;
use bessemer_tests::workspace::{Files, Workspace};

/// The names of the files that differ.
fn moved(before: &Files, after: &Files) -> Vec<String> {
    let names: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
    names.into_iter().filter(|name| before.get(*name) != after.get(*name)).cloned().collect()
}

/// One test, since all of it is one package built again and again.
#[test]
fn only_what_must_move_moves() {
    let copy = Workspace::with_flight_models().expect("a workspace");
    let generate = |version: &str| copy.generate(version).unwrap_or_else(|error| panic!("{error}"));
    let replace = |old: &str, new: &str| copy.replace(old, new).expect("the sources");
    let version = env!("CARGO_PKG_VERSION");
    let before = generate(version);

    let committed = fs::read_to_string(root().join("generated/height.c")).expect("committed C");
    assert_eq!(before["height.c"], committed, "the place of the workspace does not matter");
    assert_eq!(moved(&before, &generate(version)), [""; 0], "generating twice");

    // The tool's version: the manifest alone.
    assert_eq!(moved(&before, &generate("99.0.0")), ["manifest.json"]);

    // A comment on top of a model: the map of its lines, no C. A constant: the one C file that uses it, and there one line.
    // A new model that uses what is there, and a name of a constant that is there, too: its own files, and the manifest
    // that lists them. All three in one build, since they are seen apart.
    replace(
        "//! Height control: commanded thrust",
        "// A comment.\n//! Height control: commanded thrust",
    );
    replace("const CONTACT_HEIGHT: f64 = 0.1;", "const CONTACT_HEIGHT: f64 = 0.15;");
    let model = "//! Counts.\nuse crate::signals::Target;\nuse bessemer::prelude::*;\n\n\
        /// On the moon, m/s².\nconst GRAVITY: f64 = 1.62;\n\n\
        /// Counts landings.\n#[component]\n#[derive(Clone, Debug, Default, PartialEq)]\n\
        pub struct Counter {\n    /// How many.\n    pub landings: f64,\n}\n\n#[component]\n\
        impl Counter {\n    /// One period.\n    #[entry(infallible)]\n    \
        pub fn step(&mut self, target: &Target) {\n        if target.land {\n            \
        self.landings += GRAVITY;\n        }\n    }\n}\n";
    fs::write(copy.folder().join("src/counter.rs"), model).expect("a source file");
    replace("pub mod height;", "pub mod counter;\npub mod height;");
    let changed = generate(version);
    let files = [
        "counter.c",
        "counter.c.map",
        "counter.h",
        "counter.h.map",
        "height.c.map",
        "height.h.map",
        "manifest.json",
        "touch_down.c",
    ];
    assert_eq!(moved(&before, &changed), files);
    let lines = before["touch_down.c"].lines().zip(changed["touch_down.c"].lines());
    assert_eq!(lines.filter(|(one, other)| one != other).count(), 1);

    // A shared type: the files that name it, and there the lines that name it.
    replace("Target", "Goal");
    let renamed = generate(version);
    let naming: Vec<String> = changed
        .iter()
        .filter(|(name, text)| !name.ends_with(".map") && text.contains("target_t"))
        .map(|(name, _)| name.clone())
        .collect();
    let mut sources = moved(&changed, &renamed);
    sources.retain(|name| !name.ends_with(".map"));
    assert_eq!(sources, naming);
    for name in &naming {
        let back = renamed[name].replace("goal", "target").replace("Goal", "Target");
        // A shorter name may let two lines be joined; nothing else may change.
        let joined = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(joined(&back), joined(&changed[name]), "{name}");
    }
}
