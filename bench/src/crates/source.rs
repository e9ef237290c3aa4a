//! The crates' sources: taken from the registry by version, copied, and marked.
//!
//! A file `marks` has sections `[src/lib.rs]`; a line below is the number of a line of that file, and an attribute or an import that comes before it. A file
//! `edits` has the same sections; a line below is a number, and `old => new`: what becomes of the one place of `old` in that line. Both count the lines of
//! the file as it came. `features` has the features that replace the default ones of the marked copy; the original keeps its own, with which its
//! `cargo test` runs. `note` has what a reader of the table should know: the reason why a crate does not pass, or differs from the original.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_tests::root;

use super::native;
use super::signature::{self, Signature};

/// A crate of the list.
#[derive(Clone)]
pub struct Crate {
    /// Name of the crate.
    pub name: String,
    /// Exact version of the crate.
    pub version: String,
    /// The author's name.
    pub author: String,
    /// The field of application.
    pub field: String,
}

impl Crate {
    fn folder(&self) -> PathBuf {
        root().join("bench/crates").join(format!("{}-{}", self.name, self.version))
    }

    /// The text of one of our files about the crate; empty if there is no such file.
    pub fn ours(&self, file: &str) -> String {
        fs::read_to_string(self.folder().join(file)).unwrap_or_default()
    }
}

/// A crate's workspace: the original, the marked copy, and the program that calls both.
pub struct LaidOut {
    /// Folder of the workspace.
    pub workspace: PathBuf,
    /// The functions of `drive.rs`.
    pub functions: Vec<Signature>,
    /// Numbers of attributes, of imports and of changed lines.
    pub marks: [usize; 3],
}

/// Returns the crates of the list, in its order.
///
/// # Errors
/// An error of the file system.
pub fn all() -> Result<Vec<Crate>, String> {
    let path = root().join("bench/crates/README.md");
    let text = fs::read_to_string(&path).map_err(|it| format!("`{}`: {it}", path.display()))?;
    let rows = text.lines().filter_map(|line| line.strip_prefix("| `"));
    let read = |row: &str| {
        let mut cells = row.split('|').map(str::trim);
        let name = cells.next()?.trim_end_matches('`').to_owned();
        let mut cell = || cells.next().map(str::to_owned);
        Some(Crate { name, version: cell()?, author: cell()?, field: cell()? })
    };
    Ok(rows.filter_map(read).collect())
}

/// Returns the folder of the sources; cargo fetches missing ones.
///
/// # Errors
///
/// An error of the file system, or the message of cargo.
pub fn vendored(crates: &[Crate]) -> Result<PathBuf, String> {
    let folder = root().join("target/crates/sources");
    let vendor = folder.join("vendor");
    let is_there = |it: &Crate| vendor.join(format!("{}-{}", it.name, it.version)).exists();
    if crates.iter().all(is_there) {
        return Ok(vendor);
    }
    let dependencies = crates.iter().map(|it| format!("{} = \"={}\"\n", it.name, it.version));
    let manifest = format!(
        "[package]\nname = \"sources\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n{}",
        dependencies.collect::<String>()
    );
    write(&folder.join("Cargo.toml"), &manifest)?;
    write(&folder.join("src/lib.rs"), "")?;
    let output = Command::new("cargo")
        .args(["vendor", "--quiet", "--versioned-dirs", "vendor"])
        .current_dir(&folder)
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    match output.status.success() {
        true => Ok(vendor),
        false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
    }
}

/// Creates the workspace of a crate.
///
/// # Errors
///
/// An error of the file system, or of our files about the crate.
pub fn lay_out(of: &Crate, sources: &Path) -> Result<LaidOut, String> {
    let from = sources.join(format!("{}-{}", of.name, of.version));
    let workspace = root().canonicalize().map_err(|error| error.to_string())?;
    let workspace = workspace.join("target/crates").join(&of.name);
    let drive = of.ours("drive.rs");
    let functions = signature::of(&drive)?;
    if functions.is_empty() {
        return Err("no function of `drive.rs` calls it".to_owned());
    }
    for side in ["original", "marked"] {
        let _ = fs::remove_dir_all(workspace.join(side).join("src"));
        copy(&from, &workspace.join(side))?;
    }
    let (attributes, imports, changed) = mark(of, &from, &workspace.join("marked"))?;
    for side in ["original", "marked"] {
        let folder = workspace.join(side);
        let library = folder.join("src/lib.rs");
        let text = read(&library)?;
        let named = |line: &&str| side == "original" && line.starts_with("#![crate_name");
        let text: Vec<&str> = text.lines().filter(|line| !named(line)).collect();
        write(&library, &format!("{}\n#[allow(missing_docs)]\npub mod drive;\n", text.join("\n")))?;
        let drive = if side == "marked" { driven(&drive) } else { drive.clone() };
        write(&folder.join("src/drive.rs"), &drive)?;
        let manifest = manifest(of, &read(&folder.join("Cargo.toml"))?, side);
        write(&folder.join("Cargo.toml"), &manifest)?;
    }
    let name = &of.name;
    let packages = ["original", "marked"]
        .map(|side| format!("{side} = {{ path = \"../{side}\", package = \"{side}-{name}\" }}\n"));
    let native = format!(
        "[package]\nname = \"native-{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\nbessemer = {{ workspace = true }}\n{}",
        packages.concat()
    );
    write(&workspace.join("native/Cargo.toml"), &native)?;
    write(&workspace.join("native/src/main.rs"), &native::text(&functions))?;
    settle(&workspace, name)?;
    Ok(LaidOut { workspace, functions, marks: [attributes, imports, changed] })
}

/// Writes the workspace's own files: this repository's settings, lock file and target folder.
fn settle(workspace: &Path, name: &str) -> Result<(), String> {
    let root = root().canonicalize().map_err(|error| error.to_string())?;
    let text = read(&root.join("Cargo.toml"))?;
    let members = text.lines().find(|line| line.starts_with("members")).unwrap_or_default();
    let text = text.replace(members, "members = [\"original\", \"marked\", \"native\"]");
    let lint = "unsafe_code = \"forbid\"\n";
    // As its tests run: a `debug_assert!` is a fault in the C.
    let asserted = format!("\n[profile.dev.package.original-{name}]\ndebug-assertions = true\n");
    write(&workspace.join("Cargo.toml"), &(text.replace(lint, "") + &asserted))?;
    write(&workspace.join("Cargo.lock"), &read(&root.join("Cargo.lock"))?)?;
    let target = root.join("target");
    let config = format!("[build]\ntarget-dir = \"{}\"\n", target.display());
    write(&workspace.join(".cargo/config.toml"), &config)?;
    let dsl = workspace.join("dsl");
    match dsl.exists() {
        true => Ok(()),
        false => symlink(root.join("dsl"), &dsl).map_err(|error| error.to_string()),
    }
}

/// Returns the version that the marked copy has of a dependency, by a line of `versions`; none for the crate's own choice.
fn version_of<'v>(versions: &'v str, section: &str) -> Option<&'v str> {
    let name = section.strip_prefix("[dependencies.")?.strip_suffix(']')?;
    let of = |line: &'v str| line.split_once(' ').filter(|(it, _)| *it == name);
    versions.lines().find_map(of).map(|(_, version)| version)
}

/// The manifest of a copy: the crate's own, renamed and without the dependencies of its tests.
fn manifest(of: &Crate, text: &str, side: &str) -> String {
    let features = of.ours("features");
    let features: Vec<String> = features.split_whitespace().map(|it| format!("\"{it}\"")).collect();
    let chosen = side == "marked" && of.folder().join("features").exists();
    let versions = if side == "marked" { of.ours("versions") } else { String::new() };
    let mut kept = String::new();
    let mut section = String::new();
    let mut skipped = false;
    for line in text.lines() {
        if line.starts_with('[') {
            section = line.trim().to_owned();
            let dropped = [
                "[dev-dependencies",
                "[[",
                "[package.metadata",
                "[badges",
                "[profile",
                "[lints",
                "[target",
            ];
            skipped = dropped.iter().any(|it| section.starts_with(it));
        }
        let key = line.split(" = ").next().unwrap_or_default();
        let named = section == "[package]" && key == "name";
        // cargo puts libraries of one name in one place.
        let library = section == "[lib]" && key == "name" && side == "original";
        let read =
            section == "[package]" && (key == "readme" || key == "autolib" || key == "build");
        let default = section == "[features]" && key == "default" && chosen;
        let license = section == "[package]" && key == "license";
        let version = version_of(&versions, &section).filter(|_| key == "version");
        match () {
            () if skipped || read || line.starts_with('#') => {}
            () if library => {
                kept.push_str(&format!("name = \"original_{}\"\n", of.name.replace('-', "_")))
            }
            () if named => kept.push_str(&format!("name = \"{side}-{}\"\n", of.name)),
            () if let Some(version) = version => {
                kept.push_str(&format!("version = \"{version}\"\n"))
            }
            () if license => kept.push_str("license = \"MIT\"\n"),
            () if default => kept.push_str(&format!("default = [{}]\n", features.join(", "))),
            () => kept.push_str(&format!("{line}\n")),
        }
    }
    let bessemer = "\n[dependencies.bessemer]\nworkspace = true\n";
    if side == "marked" { kept + bessemer } else { kept }
}

/// Our functions for a crate, each marked as a `#[function]`.
fn driven(text: &str) -> String {
    let mut marked = String::new();
    let mut imported = false;
    for line in text.lines() {
        if !imported && !line.starts_with("//!") {
            marked.push_str("#[allow(unused_imports)]\nuse bessemer::prelude::*;\n");
            imported = true;
        }
        if line.starts_with("pub fn ") || line.starts_with("fn ") {
            marked.push_str("#[bessemer::function]\n");
        }
        marked.push_str(line);
        marked.push('\n');
    }
    marked
}

/// A line of the files `marks` and `edits`: the file, the line number, and the text.
struct Note {
    file: String,
    line: usize,
    text: String,
}

fn notes(text: &str, name: &str) -> Result<Vec<Note>, String> {
    let mut notes = Vec::new();
    let mut file = String::new();
    for line in text.lines().filter(|line| !line.trim().is_empty()) {
        if let Some(named) = line.strip_prefix('[').and_then(|it| it.strip_suffix(']')) {
            file = named.to_owned();
            continue;
        }
        let wrong = || format!("{name}: `{line}` is no line of it");
        let (number, text) = line.split_once(' ').ok_or_else(wrong)?;
        let number = number.parse().map_err(|_| wrong())?;
        notes.push(Note { file: file.clone(), line: number, text: text.to_owned() });
    }
    Ok(notes)
}

/// Applies the marks and the edits; returns the numbers of attributes, imports and changed lines.
fn mark(of: &Crate, from: &Path, to: &Path) -> Result<(usize, usize, usize), String> {
    let (mut attributes, mut imports) = (0, 0);
    let marks = notes(&of.ours("marks"), "marks")?;
    let edits = notes(&of.ours("edits"), "edits")?;
    let mut files: Vec<&String> = marks.iter().chain(&edits).map(|it| &it.file).collect();
    files.sort();
    files.dedup();
    let mut changed: Vec<(&String, usize)> = edits.iter().map(|it| (&it.file, it.line)).collect();
    changed.sort();
    changed.dedup();
    for file in files {
        let text = read(&from.join(file))?;
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for edit in edits.iter().filter(|it| &it.file == file) {
            let wrong = || format!("edits: {file}:{}: `{}` has no place", edit.line, edit.text);
            let (old, new) = edit.text.split_once(" =>").ok_or_else(wrong)?;
            let line = edit.line.checked_sub(1).and_then(|at| lines.get_mut(at));
            let line = line.filter(|it| it.matches(old).count() == 1).ok_or_else(wrong)?;
            *line = line.replace(old, new.strip_prefix(' ').unwrap_or(new));
        }
        for mark in marks.iter().filter(|it| &it.file == file).rev() {
            let attribute = mark.text.starts_with("#[") || mark.text.starts_with("#![");
            let import = mark.text.ends_with(';')
                && (mark.text.starts_with("use ") || mark.text == "extern crate bessemer;");
            if !(attribute && mark.text.ends_with(']') || import)
                || mark.line == 0
                || mark.line > lines.len()
            {
                return Err(format!("marks: {file}:{}: `{}` is no mark", mark.line, mark.text));
            }
            (attributes, imports) =
                (attributes + usize::from(attribute), imports + usize::from(import));
            lines.insert(mark.line - 1, mark.text.clone());
        }
        write(&to.join(file), &(lines.join("\n") + "\n"))?;
    }
    Ok((attributes, imports, changed.len()))
}

/// Copies the manifest, the README (which some include) and the sources.
fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("`{}`: {error}", from.display());
    fs::create_dir_all(to).map_err(failed)?;
    for entry in fs::read_dir(from).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.file_name().unwrap_or_default();
        let target = to.join(name);
        let extension = path.extension().unwrap_or_default();
        if path.is_dir() {
            if !["tests", "examples", "benches"].iter().any(|it| name == *it) {
                copy(&path, &target)?;
            }
        } else if extension == "rs" || extension == "md" || name == "Cargo.toml" {
            fs::copy(&path, &target).map_err(failed)?;
        }
    }
    Ok(())
}

/// Returns the messages of the `expect`s in the sources of a folder, each a literal.
///
/// # Errors
///
/// An error of the file system.
pub fn expected(folder: &Path) -> Result<Vec<String>, String> {
    let failed = |error: std::io::Error| format!("`{}`: {error}", folder.display());
    let mut messages = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_dir() {
            messages.extend(expected(&path)?);
        } else if path.extension().is_some_and(|it| it == "rs") {
            let text = read(&path)?;
            let calls = text.split(".expect(\"").skip(1);
            messages.extend(calls.filter_map(|it| Some(it.split_once('"')?.0.to_owned())));
        }
    }
    Ok(messages)
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("`{}`: {error}", path.display()))
}

/// Writes a file only if its text changed, so that cargo does not rebuild without need.
fn write(path: &Path, text: &str) -> Result<(), String> {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(|error| format!("`{}`: {error}", folder.display()))?;
    fs::write(path, text).map_err(|error| format!("`{}`: {error}", path.display()))
}
