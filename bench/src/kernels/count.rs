//! Counts executed instructions exactly and reproducibly: by callgrind on the host, by QEMU's plugin for the
//! Cortex-A9.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};

use super::machine::Machine;

/// Returns the instructions of each case of a program, without those of the measurement itself.
///
/// # Errors
///
/// The program or the counter failed.
pub fn count(
    machine: &Machine,
    program: &Path,
    cases: &[String],
    folder: &Path,
    environment: &[(&str, &str)],
) -> Result<BTreeMap<String, u64>, String> {
    let (names, counts) = if machine.target {
        with_plugin(program, cases, folder)?
    } else {
        with_callgrind(program, cases, folder, environment)?
    };
    if names.len() != counts.len() || names.first().map(String::as_str) != Some("nothing") {
        return Err(format!("{} names and {} counts", names.len(), counts.len()));
    }
    let bracket = counts[0];
    Ok(names.into_iter().zip(counts.iter().map(|count| count.saturating_sub(bracket))).collect())
}

type Counted = (Vec<String>, Vec<u64>);

fn with_plugin(program: &Path, cases: &[String], folder: &Path) -> Result<Counted, String> {
    let arguments: Vec<String> =
        std::iter::once("count".to_owned()).chain(cases.iter().cloned()).collect();
    let (counts, written) = crate::count::fed(program, folder, &arguments, Stdio::null())?;
    Ok((String::from_utf8_lossy(&written).lines().map(str::to_owned).collect(), counts))
}

fn with_callgrind(
    program: &Path,
    cases: &[String],
    folder: &Path,
    environment: &[(&str, &str)],
) -> Result<Counted, String> {
    let dumps = tempfile::tempdir_in(folder).map_err(|error| error.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--zero-before=*bench_begin*", "--dump-before=*bench_end*"])
        .arg(format!("--callgrind-out-file={}", dumps.path().join("out").display()))
        .arg(program)
        .arg("count")
        .args(cases)
        .envs(environment.iter().copied())
        .stderr(Stdio::null())
        .output()
        .map_err(|error| format!("valgrind: {error}"))?;
    let names = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    let mut counts = Vec::new();
    for part in 1.. {
        let Ok(text) = std::fs::read_to_string(dumps.path().join(format!("out.{part}"))) else {
            break;
        };
        let total = text.lines().find_map(|line| line.strip_prefix("summary: ")?.parse().ok());
        counts.push(total.ok_or("callgrind gave no sum")?);
    }
    Ok((names, counts))
}
