//! Store of compiled objects and passed checks, keyed by everything on which they depend.
//!
//! A key is a hash of all inputs, so a stored result equals a new one. In a complete run (`BESSEMER_FULL`) nothing is
//! read or stored. `BESSEMER_STORE` names the store of another workspace: a copy of a workspace reads the results of
//! the original. It stores nothing there, since its results may name files of the copy.
//!
//! Invariant: an entry appears completely or not at all.
//!
//! What it must not know: what it stores.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{LazyLock, Mutex};

mod passed;

pub use passed::once;

/// Returns the root of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Returns the path of the entry for this content among others of its kind; none if nothing is to be stored.
pub fn place(kind: &str, content: &impl Hash) -> Option<PathBuf> {
    // Installed from a registry, this package is in nobody's workspace.
    if std::env::var_os("BESSEMER_FULL").is_some() || !root().join("Cargo.toml").exists() {
        return None;
    }
    let folder = lent().unwrap_or_else(|| root().join("target"));
    Some(folder.join(kind).join(name(content)))
}

/// Returns the store of another workspace, if one is configured.
fn lent() -> Option<PathBuf> {
    std::env::var_os("BESSEMER_STORE").map(PathBuf::from)
}

/// Returns a name that depends on the content.
pub fn name(content: &impl Hash) -> String {
    format!("{:016x}{:016x}", hash(content, 0), hash(content, 1))
}

/// Copies a stored entry to `made`; returns false if there is none.
pub fn fetch(stored: &Path, made: &Path) -> bool {
    std::fs::copy(stored, made).is_ok()
}

/// Stores an entry, unless the store is another workspace's.
///
/// # Errors
///
/// An error of the file system.
pub fn store(made: &Path, stored: &Path) -> std::io::Result<()> {
    if lent().is_some() {
        return Ok(());
    }
    let folder = stored.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)?;
    let fresh = tempfile::Builder::new().tempfile_in(folder)?;
    std::fs::copy(made, fresh.path())?;
    fresh.persist(stored).map_err(|error| error.error)?;
    Ok(())
}

/// Returns the version that a compiler reports; it is run once.
pub fn version(compiler: &str) -> Option<String> {
    static VERSIONS: LazyLock<Mutex<BTreeMap<String, Option<String>>>> =
        LazyLock::new(Mutex::default);
    let mut versions = VERSIONS.lock().ok()?;
    let ask = || {
        let output = Command::new(compiler).arg("--version").output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
    };
    versions.entry(compiler.to_owned()).or_insert_with(ask).clone()
}

fn hash(content: &impl Hash, salt: u64) -> u64 {
    let mut hasher = DefaultHasher::new();
    salt.hash(&mut hasher);
    content.hash(&mut hasher);
    hasher.finish()
}
