//! Runs programs on an emulated processor; returns their output, and the number of instructions of each call.
//!
//! A plugin of QEMU (`c/count.c`) counts between `bench_begin` and `bench_end`, which are not inlined. The count is
//! exact and the same in every run; instructions are not cycles. On a machine without an operating system the program
//! reads and writes files by semihosting (`c/semihosting.c`).
//!
//! What it must not know: the meaning of the words.

use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use wait_timeout::ChildExt as _;

use crate::toolchain::{Toolchain, line, run};

/// Source of the plugin.
const PLUGIN: &str = include_str!("../c/count.c");

/// Startup of a program without an operating system.
const SEMIHOSTING: &str = include_str!("../c/semihosting.c");

/// Timeout of a program's run.
const PATIENCE: Duration = Duration::from_secs(300);

/// Output and counts of a program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Watched {
    /// The words that it wrote.
    pub words: Vec<u64>,
    /// Instructions of each call, in order.
    pub counts: Vec<u64>,
}

/// Compiles the plugin into a folder, unless it exists.
///
/// # Errors
///
/// The message of the compiler or the system.
pub fn plugin(folder: &Path) -> Result<PathBuf, String> {
    let failed = |error: io::Error| error.to_string();
    let (source, plugin) = (folder.join("count.c"), folder.join("count.so"));
    let known = std::fs::read_to_string(&source).is_ok_and(|text| text == PLUGIN);
    if !known || !plugin.exists() {
        std::fs::write(&source, PLUGIN).map_err(failed)?;
        let mut command = Command::new("gcc");
        run(command.args(["-O2", "-shared", "-fPIC"]).arg(&source).arg("-o").arg(&plugin))?;
    }
    Ok(plugin)
}

/// Compiles `sources` and the program `main` in `folder`, runs it on these input bytes, and counts its instructions.
///
/// # Errors
///
/// The message of the compiler, the emulator or the system, or a timeout.
pub fn watched(
    toolchain: &Toolchain,
    folder: &Path,
    main: &Path,
    sources: &[PathBuf],
    input: &[u8],
) -> Result<Watched, String> {
    let program = built(toolchain, folder, main, sources, &[])?;
    counted(toolchain, &folder.join(FOLDER), &program, input)
}

/// Name of the folder in which a program is built and runs, since emitted files can be called anything.
pub const FOLDER: &str = "watch";

/// Compiles `sources` and the program `main` in a folder of `folder`, with more flags if there are any. Returns the path of
/// the program.
///
/// # Errors
///
/// The message of the compiler or the system.
pub fn built(
    toolchain: &Toolchain,
    folder: &Path,
    main: &Path,
    sources: &[PathBuf],
    flags: &[&str],
) -> Result<PathBuf, String> {
    let own = folder.join(FOLDER);
    std::fs::create_dir_all(&own).map_err(|error| error.to_string())?;
    let mut sources = sources.to_vec();
    sources.extend(start(toolchain, &own)?);
    let program = own.join(main.file_stem().unwrap_or_default());
    toolchain.around(main, &sources, &program, flags)?;
    Ok(program)
}

/// Writes the startup code of a program without an operating system into a folder; none if the toolchain needs none.
///
/// # Errors
///
/// The message of the system.
pub fn start(toolchain: &Toolchain, folder: &Path) -> Result<Option<PathBuf>, String> {
    let start = folder.join("semihosting.c");
    match toolchain.bare {
        true => std::fs::write(&start, SEMIHOSTING).map_err(|error| error.to_string())?,
        false => return Ok(None),
    }
    Ok(Some(start))
}

/// Runs a program in `folder` on these input bytes, and counts its instructions.
///
/// # Errors
///
/// The message of the compiler, the emulator or the system, or a timeout.
pub fn counted(
    toolchain: &Toolchain,
    folder: &Path,
    program: &Path,
    input: &[u8],
) -> Result<Watched, String> {
    let failed = |error: io::Error| error.to_string();
    let file = |name: &str| folder.join(name);
    std::fs::write(file("words.in"), input).map_err(failed)?;
    let plugin = plugin(folder)?.display().to_string();
    let mut command = toolchain.runner_with(program, &["-plugin", &plugin]);
    command.current_dir(folder);
    if toolchain.bare {
        command.stdin(Stdio::null()).stdout(Stdio::null());
    } else {
        command.stdin(std::fs::File::open(file("words.in")).map_err(failed)?);
        command.stdout(std::fs::File::create(file("words.out")).map_err(failed)?);
    }
    command.stderr(std::fs::File::create(file("said")).map_err(failed)?);
    let ended = ended(&mut command);
    let said = std::fs::read_to_string(file("said")).map_err(failed)?;
    ended.map_err(|why| {
        let last: Vec<&str> = said.lines().rev().take(3).collect();
        format!("{why}\n{}", last.join("\n"))
    })?;
    let bytes = std::fs::read(file("words.out")).map_err(failed)?;
    let word = |bytes: &[u8]| bytes.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte));
    let words = bytes.chunks_exact(8).map(word).collect();
    let counts = said.lines().filter_map(|line| line.parse().ok()).collect();
    Ok(Watched { words, counts })
}

/// Waits for the end of a command, with a timeout.
fn ended(command: &mut Command) -> Result<(), String> {
    let mut child = command.spawn().map_err(|error| format!("{}: {error}", line(command)))?;
    match child.wait_timeout(PATIENCE) {
        Ok(Some(status)) if status.success() => Ok(()),
        Ok(Some(status)) => Err(format!("{}: {status}", line(command))),
        Ok(None) => {
            let _ = child.kill();
            let _ = child.wait();
            Err(format!("{} does not end", line(command)))
        }
        Err(error) => Err(format!("{}: {error}", line(command))),
    }
}
