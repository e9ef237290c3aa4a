//! Counts the bytes that emitted C copies or clears: those of `memcpy`, `memmove` and `memset`.
//!
//! clang's optimiser recognises loops that copy or clear, and removes what nothing reads. Its thread sanitizer then leaves
//! each remaining copy and clearing as a call, whatever its size. Its run-time library is not linked: `c/moved.c` counts
//! instead. Values that are assigned element by element do not count.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use bessemer_tests::toolchain::{CLANG, Toolchain};

/// Definitions of `bench_begin` and `bench_end`, for [`marked_by`](bessemer_tests::harness::marked_by).
pub const MARKS: &str = include_str!("../c/moved.c");

const FLAGS: [&str; 10] = [
    "-fsanitize=thread",
    "-fno-sanitize-link-runtime",
    "-Qunused-arguments",
    "-mllvm",
    "-tsan-instrument-memory-accesses=0",
    "-mllvm",
    "-tsan-instrument-func-entry-exit=0",
    "-mllvm",
    "-tsan-instrument-atomics=0",
    "-Wl,--wrap=memcpy,--wrap=memmove,--wrap=memset",
];

/// Builds a program with [`MARKS`].
///
/// # Errors
/// The message of the compiler.
pub fn build(main: &Path, sources: &[PathBuf], program: &Path) -> Result<(), String> {
    let toolchain = Toolchain { level: 1, ..CLANG };
    toolchain.around(main, sources, program, &FLAGS).map(drop)
}

/// Runs a program on an input; returns the bytes that it copied or cleared between its marks.
///
/// # Errors
/// The message of the program or the system.
pub fn count(program: &Path, input: Stdio) -> Result<u64, String> {
    let mut command = Command::new(program);
    let output = command.stdin(input).output().map_err(|error| format!("{command:?}: {error}"))?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("{command:?}: {}\n{said}", output.status));
    }
    said.trim().parse().map_err(|_| format!("{command:?} reported `{said}`"))
}
