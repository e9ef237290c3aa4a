//! Sources of a dossier: those of the package, their hashes, and an earlier version by git.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_dossier::manifest::{self, Hashes, Manifest};
use bessemer_dossier::requirements::rust::{self, Item};
use bessemer_dossier::trace::Folder;
use bessemer_project::Project;

use super::Wrong;
use crate::error::Error;

/// Returns true for files and folders of a package that belong to its sources.
fn is_source(project: &Project, path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if path.is_dir() {
        let output = project.job(false).output;
        let is_dossier = path.join(manifest::NAME).exists();
        return !name.starts_with('.') && name != "target" && path != output && !is_dossier;
    }
    [".rs", ".toml", ".csv", ".reqif"].iter().any(|end| name.ends_with(end))
}

fn failed((path, source): (PathBuf, std::io::Error)) -> Error {
    Error::File { path, source }
}

/// Returns the hashes of sources and C. `others` are files that the dossier has besides.
pub fn manifest(
    project: &Project,
    c: &Folder,
    tool: &str,
    rustc: &str,
    others: &[PathBuf],
) -> Result<Manifest, Error> {
    let root = &project.workspace.root;
    let mut sources = Hashes::new();
    let wanted = |path: &Path| is_source(project, path);
    manifest::add_folder(root, &project.package.folder, &wanted, &mut sources).map_err(failed)?;
    // Sources of other crates that become C, where they are in the workspace; the versions of all others.
    let rows = c.files.iter().flat_map(|file| &file.rows);
    let files: BTreeSet<&String> = rows.map(|row| &row.rust_file).collect();
    let more = files.into_iter().map(|file| root.join(file));
    let settings = project.file.clone().into_iter().chain([root.join("Cargo.lock")]);
    let all = more.chain(settings).chain(others.iter().cloned());
    for path in all.filter(|path| path.is_file()) {
        manifest::add_file(root, &path, &mut sources).map_err(failed)?;
    }
    let output = project.job(false).output;
    let mut files = Hashes::new();
    manifest::add_folder(&output, &output, &|path: &Path| !path.ends_with(".DS_Store"), &mut files)
        .map_err(failed)?;
    // It has the day of the generation.
    files.remove(manifest::NAME);
    Ok(Manifest {
        package: project.package.name.clone(),
        tool: tool.to_owned(),
        rustc: rustc.to_owned(),
        c_folder: relative(root, &output),
        sources,
        c: files,
        outputs: Hashes::new(),
    })
}

/// Returns one hash of many.
pub fn digest(hashes: &Hashes) -> String {
    let all: String = hashes.iter().map(|(path, hash)| format!("{path} {hash}\n")).collect();
    format!("{} ({} files)", manifest::hash(all.as_bytes()), hashes.len())
}

/// Returns a path from the workspace.
pub fn relative(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/")
}

/// Returns the items of all Rust sources of the package, also of its tests, and the tests of other packages.
pub fn items(project: &Project, others: &[String]) -> Result<Vec<Item>, Error> {
    let mut items = items_in(project, &project.package.folder)?;
    for name in others.iter().filter(|it| **it != project.package.name) {
        let member = project.workspace.member(name).map_err(bessemer_project::Error::from)?;
        let found = items_in(project, &member.folder)?;
        let known: BTreeSet<String> = items.iter().map(|it| it.file.clone()).collect();
        items.extend(found.into_iter().filter(|it| it.is_test && !known.contains(&it.file)));
    }
    Ok(items)
}

/// Returns the items of a package without those of the packages in its folders.
fn items_in(project: &Project, folder: &Path) -> Result<Vec<Item>, Error> {
    let root = &project.workspace.root;
    let mut names = Hashes::new();
    let wanted = |path: &Path| {
        let is_own = path == folder || !path.join("Cargo.toml").is_file();
        let is_rust = path.extension().is_some_and(|it| it == "rs");
        is_source(project, path) && is_own && (path.is_dir() || is_rust)
    };
    manifest::add_folder(root, folder, &wanted, &mut names).map_err(failed)?;
    let mut items = Vec::new();
    for name in names.into_keys() {
        let path = root.join(&name);
        let text = std::fs::read_to_string(&path).map_err(|source| failed((path, source)))?;
        let found = rust::items(&name, &text).map_err(|wrong| {
            let first = wrong.into_iter().next();
            first.map_or(Wrong::Source { file: name.clone(), line: 1, why: String::new() }, |it| {
                Wrong::Source { file: it.file, line: it.line, why: it.why }
            })
        })?;
        items.extend(found);
    }
    Ok(items)
}

/// Returns the texts of the Rust that becomes C.
pub fn rust_texts(root: &Path, c: &Folder) -> BTreeMap<String, String> {
    let rows = c.files.iter().flat_map(|file| &file.rows);
    let files: BTreeSet<&String> = rows.map(|row| &row.rust_file).collect();
    let text = |file: &String| Some((file.clone(), std::fs::read_to_string(root.join(file)).ok()?));
    files.into_iter().filter_map(text).collect()
}

/// Returns the text of `bessemer.toml`.
pub fn options(project: &Project) -> Option<String> {
    project.file.as_ref().and_then(|path| std::fs::read_to_string(path).ok())
}

/// An earlier version.
pub struct Earlier {
    /// Its name.
    pub tag: String,
    /// Its C.
    pub folder: Folder,
    /// The manifest of the C.
    pub manifest: String,
    /// Its Rust.
    pub rust: BTreeMap<String, String>,
    /// Its `bessemer.toml`.
    pub options: Option<String>,
}

/// Reads an earlier version by git.
pub fn earlier(project: &Project, tag: &str, colour: bool) -> Result<Earlier, Error> {
    let root = &project.workspace.root;
    let output = project.job(colour).output;
    let folder = relative(root, &output);
    let commit = format!("{tag}^{{commit}}");
    let commit = git(root, &["rev-parse", "--verify", "--quiet", "--end-of-options", &commit]);
    let commit = commit.map_err(|said| Wrong::Tag { tag: tag.to_owned(), said })?;
    let commit = commit.trim().to_owned();
    let below = format!("./{folder}");
    let names = git(root, &["ls-tree", "-r", "--name-only", &commit, "--", &below]);
    let names = names.map_err(|said| Wrong::Tag { tag: tag.to_owned(), said })?;
    let show = |path: &str| git(root, &["show", &format!("{commit}:./{path}")]).ok();
    let mut texts = BTreeMap::new();
    for name in names.lines().filter(|it| [".c", ".h", ".map"].iter().any(|end| it.ends_with(end)))
    {
        let short = name.strip_prefix(&format!("{folder}/")).unwrap_or(name);
        texts.extend(show(name).map(|text| (short.to_owned(), text)));
    }
    let c = Folder::of(&texts, &output)?;
    if !c.files.iter().any(|file| !file.rows.is_empty()) {
        return Err(Wrong::NoC { tag: tag.to_owned(), folder }.into());
    }
    let rows = c.files.iter().flat_map(|file| &file.rows);
    let files: BTreeSet<String> = rows.map(|row| row.rust_file.clone()).collect();
    let rust = files.into_iter().filter_map(|file| Some((file.clone(), show(&file)?))).collect();
    let options = project.file.as_ref().and_then(|path| show(&relative(root, path)));
    let manifest = show(&format!("{folder}/{}", manifest::NAME)).unwrap_or_default();
    Ok(Earlier { tag: tag.to_owned(), folder: c, manifest, rust, options })
}

/// Runs git; its output, or its message.
fn git(root: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("git").args(arguments).current_dir(root).output();
    let output = output.map_err(|error| error.to_string())?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => {
            let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
            Err(if said.is_empty() { "it is no tag, branch or commit".to_owned() } else { said })
        }
    }
}
