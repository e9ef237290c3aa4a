//! The modules of a crate as files, and circles among them.

#![allow(dead_code, reason = "not every test needs all of it")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A module's path from the root of its crate.
pub type Module = Vec<String>;

pub fn root() -> PathBuf {
    xtask::project::root()
}

pub fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The modules under a folder, by their paths from it; tests in files of their own aside.
pub fn files(folder: &Path) -> BTreeMap<Module, PathBuf> {
    let (mut found, mut open) = (BTreeMap::new(), vec![(Module::new(), folder.to_owned())]);
    while let Some((module, folder)) = open.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of sources").flatten() {
            let path = entry.path();
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let inner = || module.iter().cloned().chain([name.clone()]).collect();
            if name == "tests" {
                continue;
            }
            if path.is_dir() {
                open.push((inner(), path));
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let own = matches!(name.as_str(), "mod" | "lib" | "main");
                found.insert(if own { module.clone() } else { inner() }, path);
            }
        }
    }
    assert!(found.len() > 10, "no sources in {}", folder.display());
    found
}

pub fn joined(path: &[String], word: &str) -> Module {
    path.iter().cloned().chain([word.to_owned()]).collect()
}

pub fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|it| match &it.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        _ => false,
    })
}

/// The sets of files each of which can be reached from each other.
pub fn circles(imports: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<BTreeSet<&Module>> {
    let reached: BTreeMap<&Module, BTreeSet<&Module>> =
        imports.keys().map(|module| (module, reached(imports, module))).collect();
    let mut circles = Vec::new();
    for (module, all) in &reached {
        let circle: BTreeSet<&Module> =
            all.iter().copied().filter(|it| reached[it].contains(module)).collect();
        if circle.first() == Some(module) {
            circles.push(circle);
        }
    }
    circles
}

/// All that a file imports, that those import, and so on.
fn reached<'m>(
    imports: &'m BTreeMap<Module, BTreeSet<Module>>,
    from: &'m Module,
) -> BTreeSet<&'m Module> {
    let (mut all, mut open) = (BTreeSet::new(), vec![from]);
    while let Some(next) = open.pop() {
        open.extend(imports.get(next).into_iter().flatten().filter(|it| all.insert(*it)));
    }
    all
}

pub fn shown(circle: &BTreeSet<&Module>) -> String {
    let names: Vec<String> = circle.iter().map(|module| module.join("::")).collect();
    names.join(", ")
}
