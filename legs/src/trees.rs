//! Stores trees by their inputs, so that a package is not built twice for its tree.
//!
//! The key of a tree consists of everything on which it depends: rustc's version, the sources of the DSL and of the
//! generation build, the lock file, and the settings and sources of the package and its dependencies. So a change of
//! a pass or of the printer needs no build of the tests' models.
//!
//! Invariant: messages of rustc and the builders about the author's source are stored with the tree; other errors are
//! not stored.
//!
//! What it must not know: the purpose of the package.

use std::collections::BTreeMap;
use std::hash::Hash;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use bessemer_codegen::deep::deep;
use bessemer_codegen::generate::{self, Error, Job, Tree};
use bessemer_frontend::diagnostic::{Diagnostic, Told};
use bessemer_frontend::source::Sources;
use bessemer_ir::tree::Package;
use serde::{Deserialize, Serialize};

use crate::{root, store};

/// Paths, relative to the root, on which every tree depends besides the package's sources.
const EVERY: [&str; 7] = [
    "dsl",
    "blocks/src",
    "estimation/src",
    "codegen/src/generate",
    "codegen/frontend/src/source",
    "codegen/frontend/src/source.rs",
    "codegen/frontend/src/diagnostic",
];

/// Result of a build. It is borrowed for writing, since trees are nested too deeply to be copied on a stack.
#[derive(Serialize, Deserialize)]
enum Outcome<P, D> {
    Built { package: P, warnings: D },
    Refused(D),
}

/// Returns the tree of the job's package; `folders` contain its sources and those of its dependencies.
///
/// # Errors
///
/// Those of [`generate::tree`].
pub fn tree(job: &Job, folders: &[PathBuf]) -> Result<Tree, Error> {
    let stored = content(job, folders).and_then(|content| store::place("trees", &content));
    match stored.as_deref().and_then(read) {
        Some(Outcome::Built { package, warnings }) => return Ok(Tree { package, warnings }),
        Some(Outcome::Refused(diagnostics)) => {
            let sources = Sources::new(&job.root);
            return Err(Error::Models(Told::new(diagnostics, &sources, job.colour)));
        }
        None => {}
    }
    let made = generate::tree(job);
    let outcome = match &made {
        Ok(Tree { package, warnings }) => Some(Outcome::Built { package, warnings }),
        Err(Error::Models(told)) if is_about_source(&told.diagnostics) => {
            Some(Outcome::Refused(&told.diagnostics))
        }
        Err(_) => None,
    };
    if let (Some(outcome), Some(stored)) = (outcome, stored) {
        write(&outcome, &stored).map_err(|source| Error::File { path: stored, source })?;
    }
    made
}

/// Returns true if each message is about a place in a source. One without a place may be about the machine, such as a full
/// disk, and another build may succeed.
fn is_about_source(diagnostics: &[Diagnostic]) -> bool {
    !diagnostics.is_empty() && diagnostics.iter().all(|it| it.line > 0 && !it.file.is_empty())
}

/// Returns the folders of this workspace's packages of models; those of tests depend on each other.
pub fn folders() -> Vec<PathBuf> {
    let tests = std::fs::read_dir(root().join("tests")).into_iter().flatten().flatten();
    let tests = tests.map(|entry| entry.path()).filter(|path| path.join("Cargo.toml").exists());
    let mut all: Vec<PathBuf> =
        tests.chain(["models", "estimation"].map(|it| root().join(it))).collect();
    all.sort();
    all
}

/// Returns everything on which the results for the sources in `folders` depend, in the workspace at `workspace`.
pub fn content(job: &Job, folders: &[PathBuf]) -> Option<impl Hash + use<>> {
    static SHARED: LazyLock<Option<Texts>> = LazyLock::new(|| {
        let mut texts = Texts::new();
        EVERY.iter().try_for_each(|name| gather(&root(), &root().join(name), &mut texts).ok())?;
        Some(texts)
    });
    // Hashed once for a process, not once for a package.
    static HASHED: LazyLock<Option<String>> = LazyLock::new(|| Some(store::name(SHARED.as_ref()?)));
    let mut own = Texts::new();
    for folder in folders {
        gather(&job.root, folder, &mut own).ok()?;
    }
    for name in ["Cargo.toml", "Cargo.lock"] {
        own.insert(name.into(), std::fs::read(job.root.join(name)).ok()?);
    }
    Some((
        store::version("rustc")?,
        HASHED.as_ref()?,
        job.package.clone(),
        job.license.clone(),
        own,
    ))
}

/// Files by their paths.
type Texts = BTreeMap<PathBuf, Vec<u8>>;

/// Adds a file, or the files below a folder, by their paths from `root`.
fn gather(root: &Path, path: &Path, texts: &mut Texts) -> std::io::Result<()> {
    if path.is_dir() {
        for entry in std::fs::read_dir(path)? {
            gather(root, &entry?.path(), texts)?;
        }
    } else {
        let name = path.strip_prefix(root).unwrap_or(path).to_owned();
        texts.insert(name, std::fs::read(path)?);
    }
    Ok(())
}

fn read(stored: &Path) -> Option<Outcome<Package, Vec<Diagnostic>>> {
    let text = std::fs::read_to_string(stored).ok()?;
    deep(|| bessemer_ir::tree::read(&text)).ok()
}

fn write(outcome: &(impl Serialize + Sync), stored: &Path) -> std::io::Result<()> {
    let made = tempfile::NamedTempFile::new()?;
    std::fs::write(made.path(), deep(|| serde_json::to_string(outcome))?)?;
    store::store(made.path(), stored)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_without_a_place_is_not_stored() {
        let at =
            |file: &str, line| Diagnostic { file: file.to_owned(), line, ..Diagnostic::default() };
        let (placed, full_disk) = (at("models/src/pid.rs", 3), at("", 0));
        assert!(is_about_source(std::slice::from_ref(&placed)));
        assert!(!is_about_source(&[placed, full_disk]));
        assert!(!is_about_source(&[]));
    }

    #[test]
    fn a_tree_moves_with_all_that_decides_it() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let package = folder.path().join("models");
        std::fs::create_dir_all(package.join("src/deep"))?;
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text);
        write("Cargo.toml", "[workspace]\n")?;
        write("Cargo.lock", "version = 4\n")?;
        write("other.rs", "//! Beside the package.\n")?;
        let mut job = Job::new(folder.path(), "models");
        let name =
            |job: &Job| content(job, std::slice::from_ref(&package)).map(|it| store::name(&it));
        let mut seen = vec![name(&job)];
        assert!(seen[0].is_some());
        write("other.rs", "//! Changed.\n")?;
        assert_eq!(seen[0], name(&job), "nothing rests on it");
        for changed in ["models/src/lib.rs", "models/src/deep/a.rs", "Cargo.toml", "Cargo.lock"] {
            write(changed, "# Changed.\n")?;
            let now = name(&job);
            assert!(!seen.contains(&now), "{changed}");
            seen.push(now);
        }
        job.license = Some("MIT".to_owned());
        assert!(!seen.contains(&name(&job)), "the licence stands in the tree");
        std::fs::remove_file(folder.path().join("Cargo.lock"))?;
        assert_eq!(name(&job), None, "what cannot be read decides nothing");
        Ok(())
    }
}
