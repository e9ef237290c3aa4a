//! Store of compiled objects and passed checks, keyed by everything on which they depend.
//!
//! A key is a hash of everything that decides what is made; so what is found is what would be made. Where nothing may be
//! left out (`BESSEMER_FULL`) nothing is found, and nothing stored. `BESSEMER_STORE` names another folder than the workspace's
//! target folder: a copy of the workspace finds there what the workspace made. It stores nothing there, since what it makes
//! may name files of the copy.
//!
//! Invariant: what is stored appears whole or not at all.
//!
//! What it must not know: what it stores.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{LazyLock, Mutex};

mod passed;

pub use passed::once;

/// The root of the workspace.
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

/// The store of another workspace.
fn lent() -> Option<PathBuf> {
    std::env::var_os("BESSEMER_STORE").map(PathBuf::from)
}

/// A name that moves with the content.
pub fn name(content: &impl Hash) -> String {
    format!("{:016x}{:016x}", hash(content, 0), hash(content, 1))
}

/// Copies what is stored to `made`; whether there was something.
pub fn fetch(stored: &Path, made: &Path) -> bool {
    std::fs::copy(stored, made).is_ok()
}

/// Stores what was made, unless the store is another's.
///
/// # Errors
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

/// A compiler's words about itself, asked once.
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
