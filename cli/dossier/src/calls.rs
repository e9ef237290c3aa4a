//! Calls between the functions of the C.
//!
//! Must not know: what the functions compute.

use std::collections::{BTreeMap, BTreeSet};

use crate::scan::tokens::tokens;
use crate::trace::{File, Folder};

/// Functions by their name, each with the functions that it calls.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Calls(pub BTreeMap<String, BTreeSet<String>>);

impl Calls {
    /// Returns the calls of the C in a folder.
    pub fn of(folder: &Folder) -> Calls {
        let names: BTreeSet<&str> = folder
            .files
            .iter()
            .flat_map(|file| file.functions.iter().map(|it| &*it.name))
            .collect();
        let mut calls = BTreeMap::new();
        for file in &folder.files {
            add(file, &names, &mut calls);
        }
        Calls(calls)
    }

    /// Returns a function and everything that it calls, directly or not.
    pub fn reached(&self, function: &str) -> BTreeSet<String> {
        let mut reached = BTreeSet::from([function.to_owned()]);
        let mut open = vec![function.to_owned()];
        while let Some(next) = open.pop() {
            for callee in self.0.get(&next).into_iter().flatten() {
                if reached.insert(callee.clone()) {
                    open.push(callee.clone());
                }
            }
        }
        reached
    }
}

fn add(file: &File, names: &BTreeSet<&str>, calls: &mut BTreeMap<String, BTreeSet<String>>) {
    let all = tokens(&file.text);
    for function in &file.functions {
        let own = calls.entry(function.name.clone()).or_default();
        let inside = |line: u32| (function.line..=function.last_line).contains(&line);
        for pair in all.windows(2).filter(|pair| inside(pair[0].line)) {
            let name = pair[0].text(&file.text);
            if pair[1].text(&file.text) == "(" && names.contains(name) && name != function.name {
                own.insert(name.to_owned());
            }
        }
    }
}
