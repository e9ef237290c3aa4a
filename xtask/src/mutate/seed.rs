//! Reuses the builds of the work tree for the copy of the work tree.
//!
//! Cargo identifies a package by its name, version, features, profile and position in the workspace, and a build is
//! up to date by the time stamps of its sources, independently of the workspace's path. So builds of packages from
//! the registry can be hard links: a rebuild would write the same content. Builds of the workspace's packages are
//! copied, since mutants change them. Builds that contain the path of the work tree are not reused.
//!
//! What it must not know: mutants.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;

/// Folders of a target folder that contain cargo's build results and their metadata.
const FOLDERS: [&str; 3] = [".fingerprint", "build", "deps"];

/// Endings of libraries, and of rustc's lists of their sources.
const LIBRARIES: [&str; 4] = ["rlib", "rmeta", "so", "d"];

/// Copies what was built for the work tree at `root` to `target`, unless `target` already has content. Returns false
/// in that case.
///
/// # Errors
///
/// An error of the file system.
pub fn seed(root: &Path, target: &Path) -> io::Result<bool> {
    let (built, target) = (root.join("target/debug"), target.join("debug"));
    if target.exists() || !built.exists() {
        return Ok(false);
    }
    let packages = registry(&fs::read_to_string(root.join("Cargo.lock"))?);
    for folder in FOLDERS {
        fs::create_dir_all(target.join(folder))?;
        for entry in fs::read_dir(built.join(folder))? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let to = target.join(folder).join(&name);
            if package(&name).any(|package| packages.contains(&package)) {
                each(&path, &to, &|from, to| fs::hard_link(from, to))?;
            } else if path.is_dir() || is_movable(&path, root)? {
                each(&path, &to, &|from, to| fs::copy(from, to).and_then(|_| age(from, to)))?;
            }
        }
    }
    Ok(true)
}

/// Gives a copy of a file or folder the time stamp of the original.
///
/// # Errors
///
/// An error of the file system.
pub fn age(from: &Path, to: &Path) -> io::Result<()> {
    fs::File::open(to)?.set_modified(fs::metadata(from)?.modified()?)
}

/// Returns true if a build result of the workspace is independent of its folder. rustc lists the environment
/// variables on which a result depends; cargo itself finds a build script's folder again.
fn is_movable(path: &Path, root: &Path) -> io::Result<bool> {
    if !path.extension().is_some_and(|ending| LIBRARIES.iter().any(|it| ending == *it)) {
        return Ok(false);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let own = path.with_file_name(format!("{}.d", name.strip_prefix("lib").unwrap_or(&name)));
    let said = if own.exists() { fs::read_to_string(own)? } else { String::new() };
    let variables = said.lines().filter_map(|line| line.strip_prefix("# env-dep:"));
    let mut places = variables.filter(|it| it.contains(&*root.to_string_lossy()));
    Ok(places.all(|it| it.starts_with("OUT_DIR=")))
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

/// Returns the packages that a file or folder in the target folder may belong to: `libm-0123456789abcdef`,
/// `liblibm-….rlib`.
fn package(name: &str) -> impl Iterator<Item = String> {
    let stem = name.split_once('.').map_or(name, |(stem, _)| stem);
    let name = stem.rsplit_once('-').map(|(name, _)| plain(name));
    let library = name.as_deref().and_then(|name| name.strip_prefix("lib")).map(str::to_owned);
    name.into_iter().chain(library)
}

fn plain(name: &str) -> String {
    name.replace('-', "_")
}

/// Calls `put` with each file of a folder, or with the single file, and the corresponding path in another place.
fn each(from: &Path, to: &Path, put: &dyn Fn(&Path, &Path) -> io::Result<()>) -> io::Result<()> {
    if !from.is_dir() {
        return put(from, to);
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        each(&entry.path(), &to.join(entry.file_name()), put)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_knows_no_place_is_taken() -> io::Result<()> {
        let root = tempfile::tempdir()?;
        let place = |name: &str| root.path().join("target/debug").join(name);
        let write = |name: &str, text: &str| {
            fs::create_dir_all(place(name).parent().unwrap_or(root.path()))?;
            fs::write(place(name), text)
        };
        let lock = "version = 4\n\n[[package]]\nname = \"models\"\nversion = \"0.1.0\"\n\n[[package]]\nname = \"proc-macro2\"\n\
                    version = \"1.0.0\"\nsource = \"registry+https://example.org/index\"\n\n[[package]]\nname = \"libm\"\n\
                    source = \"registry+https://example.org/index\"\n";
        fs::write(root.path().join("Cargo.lock"), lock)?;
        let linked = [
            ".fingerprint/proc-macro2-0123456789abcdef/lib-proc_macro2",
            "build/libm-0123456789abcdef/out/a",
            "deps/libproc_macro2-0123456789abcdef.rlib",
            "deps/liblibm-0123456789abcdef.rmeta",
            "deps/libm-0123456789abcdef.d",
        ];
        let copied = [
            "deps/libmodels-0123456789abcdef.rlib",
            "deps/libcorpus-0123456789abcdef.rlib",
            ".fingerprint/models-0123456789abcdef/a",
        ];
        let left = ["deps/models-0123456789abcdef", "deps/liblegs-0123456789abcdef.rlib"];
        linked.iter().chain(&copied).chain(&left).try_for_each(|name| write(name, name))?;
        let knows = |name: &str| format!("# env-dep:{name}={}\n", root.path().display());
        write("deps/corpus-0123456789abcdef.d", &knows("OUT_DIR"))?;
        write("deps/legs-0123456789abcdef.d", &knows("CARGO_MANIFEST_DIR"))?;
        let target = root.path().join("target/mutants/target");
        assert!(seed(root.path(), &target)?);
        let there = |name: &&str| target.join("debug").join(name).exists();
        assert!(linked.iter().all(there));
        assert!(copied.iter().all(there));
        assert!(!left.iter().any(there));
        let written = |path: &Path| fs::metadata(path)?.modified();
        for name in copied {
            assert_eq!(written(&target.join("debug").join(name))?, written(&place(name))?);
            fs::write(target.join("debug").join(name), "a mutant's")?;
            assert_eq!(fs::read_to_string(place(name))?, name);
        }
        // What is there stays: cargo has gone on from it.
        fs::remove_file(target.join("debug").join(linked[2]))?;
        assert!(!seed(root.path(), &target)?);
        assert!(!there(&linked[2]));
        Ok(())
    }
}
