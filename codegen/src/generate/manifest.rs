//! The files beside the C: the manifest of the folder, and a map for each file.
//!
//! Versions, dates and line numbers live here, so that they need not live in the C.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::files::Files;
use crate::compile::Compiled;
use bessemer_backend::c::{CFile, Measured};

/// The name of the manifest.
pub const NAME: &str = "manifest.json";

/// The contents of the folder, and what made it.
pub struct Manifest {
    content: Value,
}

impl Manifest {
    /// The manifest of `files` by the tool's `version`, without a date.
    pub fn new(compiled: &Compiled, files: &Files, version: &str) -> Manifest {
        let entries: Vec<Value> = compiled
            .entries
            .iter()
            .map(|entry| {
                let mut said = json!({
                    "component": entry.component,
                    "state": entry.state,
                    "entry": entry.entry,
                    "header": entry.header,
                    "state_bytes": entry.state_bytes,
                    "stack_bytes": entry.stack_bytes,
                    "checks": entry.checks,
                    "doubles": entry.doubles,
                    "longs": entry.longs,
                });
                if !entry.units.is_empty() {
                    said["units"] = entry.units.iter().map(measured).collect();
                }
                said
            })
            .collect();
        let names: Vec<&str> = files.names().collect();
        let mut content = json!({
            "tool": "bessemer",
            "version": version,
            "package": compiled.module.name,
            "entries": entries,
            "files": names,
        });
        if !compiled.replaced.is_empty() {
            let replaced = compiled.replaced.iter();
            let replaced = replaced.map(|(name, library)| (name.clone(), json!(library)));
            content["replaced"] = Value::Object(replaced.collect());
        }
        if !compiled.fast.is_empty() {
            let fast = compiled.fast.iter();
            let fast = fast.map(|(name, bound)| (name.clone(), json!(bound)));
            content["fast"] = Value::Object(fast.collect());
        }
        if !compiled.library.is_empty() {
            content["target_math"] = json!(compiled.library);
        }
        Manifest { content }
    }

    /// The package that the folder is made of.
    pub fn package(&self) -> &str {
        self.content["package"].as_str().unwrap_or_default()
    }

    /// The manifest as JSON, made on `date`.
    pub fn text(&self, date: &str) -> String {
        let mut content = self.content.clone();
        content["date"] = json!(date);
        // Plain JSON values: writing them cannot fail.
        serde_json::to_string_pretty(&content).unwrap_or_default() + "\n"
    }

    /// The date of an earlier manifest that says the same, if it does.
    pub fn date_if_same(&self, earlier: &str) -> Option<String> {
        let earlier: Value = serde_json::from_str(earlier).ok()?;
        let date = earlier.get("date")?.as_str()?.to_owned();
        (self.text(&date) == serde_json::to_string_pretty(&earlier).ok()? + "\n").then_some(date)
    }
}

fn measured(it: &Measured) -> Value {
    json!({ "port": it.port.word(), "place": it.place, "unit": it.unit })
}

/// The package that a manifest names.
pub fn package_of(manifest: &str) -> Option<String> {
    let manifest = serde_json::from_str::<Value>(manifest).ok()?;
    manifest["package"].as_str().map(str::to_owned)
}

/// The files that a manifest names.
pub fn files_of(manifest: &str) -> Vec<String> {
    let Ok(manifest) = serde_json::from_str::<Value>(manifest) else { return Vec::new() };
    let names = manifest["files"].as_array().into_iter().flatten();
    names.filter_map(|name| name.as_str().map(str::to_owned)).collect()
}

/// The map of a C file, Rust line ↔ C line: its name and its text; none for a file without code.
pub fn map(file: &CFile) -> Option<(String, String)> {
    if file.map.is_empty() {
        return None;
    }
    let mut text = String::from("# C line\tRust file:line\tfunction\n");
    for line in &file.map {
        let _ = writeln!(
            text,
            "{}\t{}:{}\t{}",
            line.c_line, line.rust_file, line.rust_line, line.function
        );
    }
    Some((format!("{}.map", file.name), text))
}
