//! Runs the generation build of a package, and the program that prints its tree.
//!
//! The build is cargo's own, of the binary `<package>-tree` with the feature `generate`; what rustc
//! says about the builders is told in the author's terms.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use bessemer_ir::tree::Package;
use serde_json::Value;

use super::{Error, Job};
use crate::diagnostic::{self, Diagnostic};
use crate::source::Sources;

/// The tree of the job's package.
pub(super) fn tree(job: &Job, sources: &Sources) -> Result<Package, Error> {
    let program = build(job, sources)?;
    let output = Command::new(&program)
        .output()
        .map_err(|source| Error::Run { program: program.display().to_string(), source })?;
    let text = String::from_utf8_lossy(&output.stdout);
    serde_json::from_str(&text).map_err(|error| Error::Tree {
        package: job.package.clone(),
        reason: if output.status.success() {
            error.to_string()
        } else {
            String::from_utf8_lossy(&output.stderr).trim().to_owned()
        },
    })
}

/// Builds the program that prints the tree.
fn build(job: &Job, sources: &Sources) -> Result<PathBuf, Error> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let binary = format!("{}-tree", job.package);
    let mut command = Command::new(&cargo);
    command
        .args(["build", "--quiet", "--message-format=json-diagnostic-rendered-ansi"])
        .args(["--package", &job.package, "--features", "generate", "--bin", &binary])
        .current_dir(&job.root)
        .stderr(Stdio::piped());
    for (name, _) in std::env::vars() {
        // Set by `cargo run` for the caller; they would make cargo rebuild.
        if name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_") {
            command.env_remove(name);
        }
    }
    let output = command
        .output()
        .map_err(|source| Error::Run { program: cargo.to_string_lossy().into_owned(), source })?;
    let text = String::from_utf8_lossy(&output.stdout);
    let messages: Vec<Value> =
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    if output.status.success()
        && let Some(program) = messages.iter().find_map(|message| executable(message, &binary))
    {
        return Ok(program);
    }
    let mut said = errors(&messages, job, sources);
    if said.is_empty() {
        said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    }
    Err(Error::Models(said))
}

fn executable(message: &Value, binary: &str) -> Option<PathBuf> {
    let target = message.get("target")?.get("name")?.as_str()?;
    let program = message.get("executable")?.as_str()?;
    (target == binary).then(|| PathBuf::from(program))
}

/// What rustc said: each thing once, ours in the author's terms.
fn errors(messages: &[Value], job: &Job, sources: &Sources) -> String {
    let mut seen = BTreeSet::new();
    let mut text = String::new();
    for message in messages {
        let Some(message) = message.get("message").filter(|message| message.is_object()) else {
            continue;
        };
        let level = message["level"].as_str().unwrap_or_default();
        let title = message["message"].as_str().unwrap_or_default();
        let primary = message["spans"].as_array().into_iter().flatten();
        let primary = primary.into_iter().find(|span| span["is_primary"] == true);
        if level != "error" || (primary.is_none() && title.starts_with("aborting")) {
            continue;
        }
        let place = primary.map(|span| {
            let number = |key: &str| span[key].as_u64().unwrap_or_default() as u32;
            let file = span["file_name"].as_str().unwrap_or_default().to_owned();
            (file, number("line_start"), number("column_start"))
        });
        // The witness copy repeats what is wrong in the original.
        if !seen.insert((place.clone(), reworded(title).0)) {
            continue;
        }
        match (place, reworded(title)) {
            (Some((file, line, column)), (message, Some(help))) => {
                let one = Diagnostic { file, line, column, message, help: help.to_owned() };
                text.push_str(&diagnostic::render(&[one], sources, job.colour));
            }
            _ => {
                let rendered = message["rendered"].as_str().unwrap_or(title);
                text.push_str(&plain(rendered, job.colour));
                text.push('\n');
            }
        }
    }
    text
}

fn plain(rendered: &str, colour: bool) -> String {
    if colour {
        return rendered.to_owned();
    }
    // SGR sequences: ESC [ … m.
    let mut text = String::new();
    let mut rest = rendered;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        text.push_str(before);
        rest = after.split_once('m').map_or("", |(_, rest)| rest);
    }
    text + rest
}

/// What rustc says of the builders' own names, in the author's terms, and a remedy.
fn reworded(title: &str) -> (String, Option<&'static str>) {
    let quoted: Vec<&str> = title.split('`').skip(1).step_by(2).collect();
    let method = quoted.iter().find_map(|name| name.strip_prefix("__b_"));
    let owner = quoted.last().copied().unwrap_or_default();
    if let Some(method) = method {
        return (
            format!("`{method}` of `{owner}` is not part of the DSL"),
            Some("mark the `impl` block that has it `#[data]` or `#[component]`; see docs/language.md for what the DSL knows"),
        );
    }
    if title.contains("`__call`") {
        return (
            format!("`{owner}` is not part of the DSL"),
            Some("mark the function `#[function]`"),
        );
    }
    (title.to_owned(), None)
}
