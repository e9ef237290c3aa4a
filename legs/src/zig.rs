//! The C compiler of zig: a newer clang than the system's, for this processor with all its instructions.
//!
//! pip installs it below `target/python`. A [`Toolchain`] needs a program without arguments, so a script calls `zig cc`.

use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::OnceLock;

use crate::root;
use crate::toolchain::{CLANG, Toolchain};

/// Returns the compiler at `-O3`, if it is installed.
pub fn zig() -> Option<Toolchain> {
    static SCRIPT: OnceLock<Option<String>> = OnceLock::new();
    let compiler = SCRIPT.get_or_init(|| script().ok().flatten()).as_deref()?;
    // Without optimisation, as the program around the C is compiled, zig adds calls of a run-time library.
    Some(Toolchain { compiler, level: 3, more: &["-fno-sanitize=undefined"], ..CLANG })
}

/// Writes the script; returns its path, if there is a zig.
fn script() -> io::Result<Option<String>> {
    let zig: PathBuf = root().canonicalize()?.join("target/python/bin/python-zig");
    if !zig.exists() {
        return Ok(None);
    }
    let folder = root().canonicalize()?.join("target/zig");
    fs::create_dir_all(&folder)?;
    let script = folder.join("zig-cc");
    // Processes that start at once each write their own, and rename it.
    let own = folder.join(format!("zig-cc-{}", std::process::id()));
    fs::write(&own, format!("#!/bin/sh\nexec \"{}\" cc \"$@\"\n", zig.display()))?;
    make_executable(&own)?;
    fs::rename(own, &script)?;
    Ok(Some(script.display().to_string()))
}

#[cfg(unix)]
fn make_executable(script: &std::path::Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    fs::set_permissions(script, fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn make_executable(_: &std::path::Path) -> io::Result<()> {
    Ok(())
}
