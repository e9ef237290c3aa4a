//! Checks that have passed, which are not repeated while everything on which they depend is unchanged.
//!
//! A check of emitted C depends on the C, which the caller provides, and on everything except the compiler: the model
//! as rustc compiles it, the test, the interpreter, the compilers and emulators, the processor, and the settings of
//! the run. A change of the compiler leaves the C of most programs unchanged, and so their checks remain valid.
//!
//! Invariants: only passed checks are stored; none is stored in a complete run, or if a source is newer than the test
//! program.
//!
//! What it must not know: the subject of a check.

use std::collections::BTreeMap;
use std::hash::Hash;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::SystemTime;

use crate::{lent, name, place, root, version};

/// Makes a check, unless it has passed with the same content. `content` is all that the compiler produced for it;
/// `title` distinguishes it from other checks of that content.
///
/// # Panics
///
/// If the check panics.
pub fn once(title: &str, content: &impl Hash, check: impl FnOnce()) {
    let stored = SURROUNDINGS.as_ref().and_then(|it| place("passed", &(title, content, it)));
    if stored.as_ref().is_some_and(|it| it.exists()) {
        println!("{title}: has passed before, and nothing that decides it has changed");
        return;
    }
    check();
    // That it cannot be stored costs the next run its time, and nothing else.
    if let Some(stored) = stored.filter(|_| lent().is_none()) {
        let _ = stored.parent().map(std::fs::create_dir_all);
        let _ = std::fs::write(stored, title);
    }
}

/// Hash of everything besides the compiler's output on which a check depends. `None` if the sources of the test
/// program are unknown.
static SURROUNDINGS: LazyLock<Option<String>> = LazyLock::new(|| {
    let program = std::env::current_exe().ok()?;
    let built = program.metadata().and_then(|it| it.modified()).ok()?;
    let texts = texts(&root(), built)?;
    // Debug or release, each in its folder.
    let profile = program.parent()?.to_owned();
    let settings: BTreeMap<_, _> = std::env::vars()
        .filter(|(name, _)| name.starts_with("BESSEMER_") || SETTINGS.contains(&name.as_str()))
        .collect();
    let versions: Vec<_> = PROGRAMS.iter().map(|program| version(program)).collect();
    // `-march=native` is another machine's on another machine.
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor: Vec<_> = processor
        .lines()
        .filter(|line| ["model name", "flags"].iter().any(|it| line.starts_with(it)))
        .take(2)
        .map(str::to_owned)
        .collect();
    Some(name(&(profile, settings, versions, processor, texts)))
});

/// Environment variables that decide which programs are found, and rustc's flags.
const SETTINGS: [&str; 3] = ["PATH", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"];

/// The programs that checks run, and rustc, which compiles the models.
const PROGRAMS: [&str; 14] = [
    "rustc",
    "gcc",
    "clang",
    "g++",
    "clang++",
    "arm-linux-gnueabihf-gcc",
    "arm-none-eabi-gcc",
    "riscv64-unknown-elf-gcc",
    "qemu-arm",
    "qemu-system-arm",
    "qemu-system-riscv32",
    "cppcheck",
    "frama-c",
    "python3",
];

/// Folders without influence on checks: the sources of the compiler, whose output is part of the key, and pages.
/// Snapshots have none either.
const LEFT_OUT: [&str; 10] = [
    "target",
    "docs",
    "generated",
    "codegen/src",
    "codegen/frontend/src",
    "codegen/backend/src",
    "bench/results",
    "tests/corpus/golden",
    "tests/mutants",
    "xtask",
];

/// Returns the files of a folder with their contents, without those that are left out. `None` if a Rust source is
/// newer than `built`.
fn texts(root: &Path, built: SystemTime) -> Option<BTreeMap<PathBuf, Vec<u8>>> {
    let mut texts = BTreeMap::new();
    let mut open = vec![PathBuf::new()];
    while let Some(folder) = open.pop() {
        let Ok(entries) = std::fs::read_dir(root.join(&folder)) else { continue };
        for entry in entries.flatten() {
            let path = folder.join(entry.file_name());
            let file = entry.file_name();
            let is_hidden = file.to_string_lossy().starts_with('.');
            let is_snapshot = path.extension().is_some_and(|it| it == "snap");
            if is_hidden || is_snapshot || LEFT_OUT.iter().any(|it| path == Path::new(it)) {
                continue;
            }
            match entry.file_type() {
                Ok(kind) if kind.is_dir() => open.push(path),
                _ => {
                    let is_rust = path.extension().is_some_and(|it| it == "rs");
                    let written = entry.metadata().and_then(|it| it.modified());
                    if is_rust && written.is_ok_and(|it| it > built) {
                        return None;
                    }
                    texts.insert(path, std::fs::read(entry.path()).unwrap_or_default());
                }
            }
        }
    }
    Some(texts)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn what_passed_is_not_asked_again_and_what_failed_is() {
        if place("passed", &()).is_none() || lent().is_some() || SURROUNDINGS.is_none() {
            return;
        }
        // Another content in each run: what is stored stays.
        let content = (std::process::id(), SystemTime::now());
        let mut asked = 0;
        let failed = std::panic::catch_unwind(|| once("it fails", &content, || panic!("it does")));
        assert!(failed.is_err());
        once("it fails", &content, || asked += 1);
        once("it fails", &content, || asked += 1);
        assert_eq!(asked, 1);
        once("another check", &content, || asked += 1);
        once("it fails", &(content, "more"), || asked += 1);
        assert_eq!(asked, 3);
    }

    #[test]
    fn a_file_beside_the_compiler_counts_and_one_of_it_does_not() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let write = |path: &str| {
            let path = folder.path().join(path);
            std::fs::create_dir_all(path.parent().unwrap_or(folder.path()))?;
            std::fs::write(path, "text")
        };
        for path in ["dsl/src/lib.rs", "codegen/backend/src/c/files.rs", "codegen/interpret/lib.rs"]
        {
            write(path)?;
        }
        write("tests/tests/.lib.rs.swp")?;
        let now = SystemTime::now();
        let found = texts(folder.path(), now).map(|texts| texts.into_keys().collect::<Vec<_>>());
        let expected = ["codegen/interpret/lib.rs", "dsl/src/lib.rs"].map(PathBuf::from);
        assert_eq!(found, Some(expected.to_vec()));
        let before = now - Duration::from_secs(60);
        assert_eq!(texts(folder.path(), before), None, "they are younger than the program");
        Ok(())
    }
}
