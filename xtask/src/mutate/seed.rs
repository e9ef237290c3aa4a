//! Saves the copy of the work tree some builds: those of packages of the registry that the work tree has built.
//!
//! Cargo knows a package of the registry by its name, version, features and profile, wherever it is built. So its files
//! may be hard links: whoever builds it anew writes the same again. Packages of the workspace are never linked, for
//! mutants change these.
//!
//! What it must not know: mutants.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;

/// The folders of a target folder in which cargo keeps what it built, and what it knows about that.
const FOLDERS: [&str; 3] = [".fingerprint", "build", "deps"];

/// Links what was built of the registry's packages for the work tree at `root` into `target`, if nothing is there yet.
///
/// # Errors
/// An error of the file system.
pub fn seed(root: &Path, target: &Path) -> io::Result<()> {
    let (built, target) = (root.join("target/debug"), target.join("debug"));
    if target.exists() || !built.exists() {
        return Ok(());
    }
    let packages = registry(&fs::read_to_string(root.join("Cargo.lock"))?);
    for folder in FOLDERS {
        fs::create_dir_all(target.join(folder))?;
        for entry in fs::read_dir(built.join(folder))? {
            let entry = entry?;
            let name = entry.file_name().to_string_lossy().into_owned();
            if package(&name).any(|package| packages.contains(&package)) {
                link(&entry.path(), &target.join(folder).join(&name))?;
            }
        }
    }
    Ok(())
}

/// The packages of the registry that a lock file names, with `_` for `-`.
fn registry(lock: &str) -> BTreeSet<String> {
    let of = |package: &str| {
        let field = |key: &str| {
            let value = |line: &str| Some(line.strip_prefix(key)?.trim_matches('"').to_owned());
            package.lines().find_map(value)
        };
        let name = field("name = ")?;
        field("source = ").is_some_and(|it| it.starts_with("registry")).then(|| plain(&name))
    };
    lock.split("[[package]]").filter_map(of).collect()
}

/// The packages that a file or a folder of cargo's may belong to: `libm-0123456789abcdef`, `liblibm-….rlib`.
fn package(name: &str) -> impl Iterator<Item = String> {
    let stem = name.split_once('.').map_or(name, |(stem, _)| stem);
    let name = stem.rsplit_once('-').map(|(name, _)| plain(name));
    let library = name.as_deref().and_then(|name| name.strip_prefix("lib")).map(str::to_owned);
    name.into_iter().chain(library)
}

fn plain(name: &str) -> String {
    name.replace('-', "_")
}

fn link(from: &Path, to: &Path) -> io::Result<()> {
    if !from.is_dir() {
        return fs::hard_link(from, to);
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        link(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_registry_has_is_linked_and_nothing_else() -> io::Result<()> {
        let root = tempfile::tempdir()?;
        let write = |name: &str| {
            let path = root.path().join("target/debug").join(name);
            fs::create_dir_all(path.parent().unwrap_or(root.path()))?;
            fs::write(path, name)
        };
        let lock = "version = 4\n\n[[package]]\nname = \"models\"\nversion = \"0.1.0\"\n\n[[package]]\nname = \"proc-macro2\"\n\
                    version = \"1.0.0\"\nsource = \"registry+https://example.org/index\"\n\n[[package]]\nname = \"libm\"\n\
                    source = \"registry+https://example.org/index\"\n";
        fs::write(root.path().join("Cargo.lock"), lock)?;
        let foreign = [
            ".fingerprint/proc-macro2-0123456789abcdef/lib-proc_macro2",
            "build/libm-0123456789abcdef/out/a",
            "deps/libproc_macro2-0123456789abcdef.rlib",
            "deps/liblibm-0123456789abcdef.rmeta",
            "deps/libm-0123456789abcdef.d",
        ];
        let own =
            ["deps/libmodels-0123456789abcdef.rlib", ".fingerprint/models-0123456789abcdef/a"];
        foreign.iter().chain(&own).try_for_each(|name| write(name))?;
        let target = root.path().join("target/mutants/target");
        seed(root.path(), &target)?;
        let there = |name: &&str| target.join("debug").join(name).exists();
        assert!(foreign.iter().all(there));
        assert!(!own.iter().any(there));
        // What is there stays: cargo has gone on from it.
        fs::remove_file(target.join("debug").join(foreign[2]))?;
        seed(root.path(), &target)?;
        assert!(!there(&foreign[2]));
        Ok(())
    }
}
