//! Counts the instructions that a program executes on the emulated Cortex-A9.
//!
//! The program calls `bench_begin` and `bench_end`, which are not inlined, around the measured code; a plugin of QEMU
//! (`watch`) counts between them. The count is exact and the same in every run. Instructions are not cycles: there is
//! no cache and no pipeline.

use std::path::Path;
use std::process::{Command, Stdio};

use bessemer_tests::watch::plugin;

/// Runs `program` and returns its instruction counts, in the order of its calls of `bench_end`. The plugin is built
/// in `folder`.
///
/// # Errors
///
/// The message of the compiler, `nm` or QEMU.
pub fn count(program: &Path, folder: &Path) -> Result<Vec<u64>, String> {
    Ok(fed(program, folder, &[], Stdio::null())?.0)
}

/// Counts the instructions of a program with arguments or input; returns the counts and its output.
///
/// # Errors
/// What the compiler or QEMU said.
pub fn fed(
    program: &Path,
    folder: &Path,
    arguments: &[String],
    input: Stdio,
) -> Result<(Vec<u64>, Vec<u8>), String> {
    let plugin = plugin(folder)?;
    let mut command = Command::new("qemu-arm");
    command.args(["-cpu", "cortex-a9", "-plugin"]).arg(plugin).arg(program).args(arguments);
    let output = command.stdin(input).output().map_err(|error| format!("{command:?}: {error}"))?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("{command:?}: {}\n{said}", output.status));
    }
    let number = |line: &str| line.parse().map_err(|_| format!("QEMU said `{line}`"));
    let counts = said.lines().map(number).collect::<Result<_, _>>()?;
    Ok((counts, output.stdout))
}
