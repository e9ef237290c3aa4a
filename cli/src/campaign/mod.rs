//! `cargo bessemer campaign`: builds the campaign's program of a package and runs it, or packs it for an engine.
//!
//! The program is the example or the binary called `campaign`, whose `main` calls `bessemer_campaign::main`. This module knows
//! of it only that: all of the campaign's work is the program's.

mod wheel;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::args::Campaign;
use crate::error::Error;

/// Name of the example or the binary.
const TARGET: &str = "campaign";

/// Scripts for schedulers: name and text.
const JOBS: [(&str, &str); 2] = [
    ("slurm.sh", include_str!("../../templates/campaign/slurm.sh")),
    ("kubernetes.yaml", include_str!("../../templates/campaign/kubernetes.yaml")),
];

/// A campaign's program, before it is built.
struct Program {
    package: String,
    version: String,
    /// `--example` or `--bin`.
    flag: &'static str,
}

/// Builds the program and runs it; returns a text and true if all is well.
///
/// # Errors
/// There is no such program, it does not build or run, or its arguments are wrong.
pub fn run(here: &Path, wanted: &Campaign) -> Result<(String, bool), Error> {
    if let Some(folder) = &wanted.jobs {
        return jobs(&here.join(folder), folder);
    }
    let program = find(here, wanted.package.name())?;
    let built = build(here, &program, wanted)?;
    if let Some(folder) = &wanted.wheel {
        let file = wheel::write(&here.join(folder), &program.package, &program.version, &built)?;
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let place = folder.join(&name);
        return Ok((
            format!(
                "{}: a wheel with the compiled campaign\n  pip install {0}\n  python3 -m {} --engine ray --seeds 0..1000 --file results.csv\n",
                place.display(),
                wheel::module(&program.package)
            ),
            true,
        ));
    }
    let mut command = Command::new(&built);
    let status = command.args(words(wanted)).current_dir(here).status();
    let status = status.map_err(|source| Error::File { path: built, source })?;
    match status.code() {
        Some(0) => Ok((String::new(), true)),
        Some(1) => Ok((String::new(), false)),
        _ => Err(Error::Campaign { wrong: format!("the program ended early ({status})") }),
    }
}

/// Writes the scripts for schedulers.
fn jobs(folder: &Path, shown: &Path) -> Result<(String, bool), Error> {
    let failed = |source| Error::File { path: folder.to_owned(), source };
    std::fs::create_dir_all(folder).map_err(failed)?;
    let mut text = String::new();
    for (name, script) in JOBS {
        std::fs::write(folder.join(name), script).map_err(failed)?;
        text += &format!("{}\n", shown.join(name).display());
    }
    Ok((text + "Their first lines say what to adapt.\n", true))
}

/// Returns the arguments of the program.
fn words(wanted: &Campaign) -> Vec<OsString> {
    let mut words: Vec<OsString> = wanted.kind.iter().map(Into::into).collect();
    let texts = [
        ("--seeds", &wanted.seeds),
        ("--shard", &wanted.shard),
        ("--accept", &wanted.accept),
        ("--retries", &wanted.retries),
        ("--rare", &wanted.rare),
    ];
    for (name, value) in texts {
        words.extend(value.iter().flat_map(|value| [name.into(), value.into()]));
    }
    let paths = [
        ("--file", &wanted.file),
        ("--into", &wanted.into),
        ("--summary", &wanted.summary),
        ("--parquet", &wanted.parquet),
    ];
    for (name, value) in paths {
        words.extend(value.iter().flat_map(|value| [name.into(), value.into()]));
    }
    words.extend(wanted.merge.iter().flat_map(|value| ["--merge".into(), value.into()]));
    for (name, is_set) in [("--again", wanted.again), ("--json", wanted.json)] {
        words.extend(is_set.then(|| name.into()));
    }
    words
}

/// Finds the program among the packages of the workspace.
fn find(here: &Path, package: Option<&str>) -> Result<Program, Error> {
    let mut cargo = cargo(here);
    cargo.args(["metadata", "--no-deps", "--format-version", "1"]).stdout(Stdio::piped());
    let output = cargo.output().map_err(|source| Error::File { path: "cargo".into(), source })?;
    if !output.status.success() {
        let wrong = String::from_utf8_lossy(&output.stderr).trim().to_owned();
        return Err(Error::Campaign { wrong });
    }
    let metadata: Value = serde_json::from_slice(&output.stdout)
        .map_err(|error| Error::Campaign { wrong: format!("`cargo metadata`: {error}") })?;
    chosen(&metadata, package)
}

/// Returns the program that cargo's description of a workspace has.
fn chosen(metadata: &Value, package: Option<&str>) -> Result<Program, Error> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let mut found = Vec::new();
    for it in list(&metadata["packages"]) {
        let name = it["name"].as_str().unwrap_or_default();
        if package.is_some_and(|package| package != name) {
            continue;
        }
        for target in list(&it["targets"]) {
            let is = |kind: &str| list(&target["kind"]).iter().any(|it| it == kind);
            let flag = if is("example") { "--example" } else { "--bin" };
            if target["name"] == TARGET && (is("example") || is("bin")) {
                let version = it["version"].as_str().unwrap_or_default().to_owned();
                found.push(Program { package: name.to_owned(), version, flag });
            }
        }
    }
    match found.len() {
        1 => Ok(found.remove(0)),
        0 => Err(Error::NoCampaign { package: package.map(str::to_owned) }),
        _ => {
            let known = found.into_iter().map(|it| it.package).collect();
            Err(Error::WhichCampaign { known })
        }
    }
}

fn cargo(here: &Path) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(here);
    cargo
}

/// Builds the program; returns its path.
fn build(here: &Path, program: &Program, wanted: &Campaign) -> Result<PathBuf, Error> {
    let mut cargo = cargo(here);
    cargo.args(["build", "--package", &program.package, program.flag, TARGET]);
    cargo.args(["--profile", wanted.profile.as_deref().unwrap_or("release")]);
    cargo.args(["--message-format", "json-render-diagnostics"]);
    if wanted.native {
        // In a folder of its own: cargo would build each crate again at every change of the flags.
        cargo.args(["--target-dir", "target/native"]);
        match std::env::var("RUSTFLAGS") {
            Ok(own) => cargo.env("RUSTFLAGS", format!("{own} -C target-cpu=native")),
            Err(_) => cargo.args(["--config", "build.rustflags=['-C', 'target-cpu=native']"]),
        };
    }
    if wanted.parquet.is_some() || wanted.wheel.is_some() {
        cargo.args(["--features", "bessemer-campaign/parquet"]);
    }
    // Cargo shows its progress on standard error.
    let output = cargo.stderr(Stdio::inherit()).output();
    let output = output.map_err(|source| Error::File { path: "cargo".into(), source })?;
    let text = String::from_utf8_lossy(&output.stdout);
    let messages = text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let mut built = messages.filter_map(|it| Some(PathBuf::from(it["executable"].as_str()?)));
    let built = built.next_back().filter(|_| output.status.success());
    built.ok_or_else(|| Error::Campaign { wrong: "the program does not build".to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn metadata(targets: &[(&str, &str, &str)]) -> Value {
        let packages = targets.iter().map(|(package, target, kind)| {
            json!({ "name": package, "version": "0.1.0", "targets": [{ "name": target, "kind": [kind] }] })
        });
        json!({ "packages": packages.collect::<Vec<_>>() })
    }

    #[test]
    fn the_program_is_the_only_example_or_binary_of_the_name() {
        let all = [("a", "campaign", "lib"), ("b", "campaign", "example"), ("c", "main", "bin")];
        let found = chosen(&metadata(&all), None).expect("b has one");
        assert_eq!((found.package.as_str(), found.flag), ("b", "--example"));
        assert!(matches!(chosen(&metadata(&all), Some("c")), Err(Error::NoCampaign { .. })));
        let both = [("a", "campaign", "bin"), ("b", "campaign", "example")];
        let found = chosen(&metadata(&both), None);
        assert!(matches!(found, Err(Error::WhichCampaign { known }) if known == ["a", "b"]));
        let found = chosen(&metadata(&both), Some("a")).expect("a has one");
        assert_eq!(found.flag, "--bin");
    }

    #[test]
    fn scripts_are_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let (text, _) = jobs(folder.path(), Path::new("jobs")).expect("they are written");
        assert!(text.starts_with("jobs/slurm.sh\njobs/kubernetes.yaml\n"), "{text}");
        assert!(folder.path().join("kubernetes.yaml").is_file());
    }
}
