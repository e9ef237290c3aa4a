//! Counts the instructions that a program executes on the emulated Cortex-A9.
//!
//! The program calls `bench_begin` and `bench_end` around what is to be counted, empty functions of
//! external linkage; a plugin of QEMU's (`plugin.c`) counts between them. The count is exact and the
//! same in every run. Instructions are not cycles: there is no cache and no pipeline.

use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};

use bessemer_tests::toolchain::run;

/// The plugin's source.
const PLUGIN: &str = include_str!("count/plugin.c");

/// The counts that a run of `program` comes to, in the order of its calls of `bench_end`. `folder` is
/// for the plugin.
///
/// # Errors
/// What the compiler, `nm` or QEMU said.
pub fn count(program: &Path, folder: &Path) -> Result<Vec<u64>, String> {
    Ok(fed(program, folder, Stdio::null())?.0)
}

/// The same for a program that reads: its counts, and what it wrote.
///
/// # Errors
/// What the compiler, `nm` or QEMU said.
pub fn fed(program: &Path, folder: &Path, input: Stdio) -> Result<(Vec<u64>, Vec<u8>), String> {
    let failed = |error: std::io::Error| error.to_string();
    let (source, plugin) = (folder.join("plugin.c"), folder.join("plugin.so"));
    if !plugin.exists() {
        std::fs::write(&source, PLUGIN).map_err(failed)?;
        run(Command::new("gcc")
            .args(["-O2", "-shared", "-fPIC"])
            .arg(&source)
            .arg("-o")
            .arg(&plugin))?;
    }
    let listed = Command::new("arm-linux-gnueabihf-nm").arg(program).output().map_err(failed)?;
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    let address = |name: &str| {
        let line = listed.lines().find(|line| line.split(' ').next_back() == Some(name));
        let number = line.and_then(|line| u64::from_str_radix(line.get(..8)?, 16).ok());
        number.ok_or_else(|| format!("the program has no `{name}`"))
    };
    let plugin = format!(
        "{},begin={:#x},end={:#x}",
        plugin.display(),
        address("bench_begin")?,
        address("bench_end")?
    );
    let mut command = Command::new("qemu-arm");
    // QEMU prints what plugins say to its log.
    let log = folder.join("counts.txt");
    command.args(["-cpu", "cortex-a9", "-d", "plugin", "-D"]).arg(&log);
    let written = folder.join("written");
    command.args(["-plugin", &plugin]).arg(program);
    let output = File::create(&written).map_err(failed)?;
    let status = command.stdin(input).stdout(output).status().map_err(failed)?;
    if !status.success() {
        return Err(format!("{command:?}: {status}"));
    }
    let text = std::fs::read_to_string(&log).map_err(failed)?;
    let number = |line: &str| line.parse().map_err(|_| format!("QEMU said `{line}`"));
    let counts = text.lines().map(number).collect::<Result<_, _>>()?;
    Ok((counts, std::fs::read(&written).map_err(failed)?))
}
