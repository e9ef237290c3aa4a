//! The native leg: one program that calls the drive functions of the original and of the marked copy by words.

use std::fmt::Write as _;
use std::io::{Read as _, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};

use bessemer_ir::Fault;
use bessemer_tests::outcome::{Outcome, fault};

use super::signature::Signature;

/// Returns the program's text. Function `n` of the original has the number `2 n`, and of the marked copy `2 n + 1`.
pub fn text(functions: &[Signature]) -> String {
    let mut cases = String::new();
    for (index, function) in functions.iter().enumerate() {
        for (which, side) in ["original", "marked"].iter().enumerate() {
            let number = 2 * index + which;
            let load = |ty: &String| format!("<{ty} as Plain>::load(next)");
            let loads: Vec<String> = function.params.iter().map(load).collect();
            let loads = loads.join(", ");
            let name = &function.name;
            let _ =
                writeln!(cases, "        {number} => {side}::drive::{name}({loads}).store(out),");
        }
    }
    MAIN.replace("CASES", &cases)
}

const MAIN: &str = r#"//! Calls a crate and its marked copy.
#![allow(warnings)]
use bessemer::Plain;
use std::io::{Read, Write};

fn call(which: u64, next: &mut dyn FnMut() -> u64, out: &mut dyn FnMut(u64)) {
    match which {
CASES        _ => {}
    }
}

fn main() {
    std::panic::set_hook(Box::new(|_| ()));
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes).expect("words");
    let mut words = bytes.chunks_exact(8).map(|it| u64::from_le_bytes(it.try_into().unwrap()));
    let mut all = Vec::new();
    while let (Some(which), Some(count)) = (words.next(), words.next()) {
        let arguments: Vec<u64> = words.by_ref().take(count as usize).collect();
        let mut arguments = arguments.into_iter();
        let mut out: Vec<u64> = Vec::new();
        let called = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            call(which, &mut || arguments.next().expect("a word"), &mut |word| out.push(word));
        }));
        match called {
            Ok(()) => {
                all.extend((out.len() as u64).to_le_bytes());
                out.iter().for_each(|word| all.extend(word.to_le_bytes()));
            }
            Err(panic) => {
                let text = (panic.downcast_ref::<String>().map(String::as_str))
                    .or(panic.downcast_ref::<&str>().copied())
                    .unwrap_or_default();
                all.extend(u64::MAX.to_le_bytes());
                all.extend((text.len() as u64).to_le_bytes());
                all.extend(text.as_bytes());
            }
        }
    }
    std::io::stdout().write_all(&all).expect("a reader");
}
"#;

/// Builds the package `package` of a workspace and returns the path of its program.
pub fn build(workspace: &Path, package: &str) -> Result<String, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--quiet", "--package", package, "--message-format=json"])
        .current_dir(workspace)
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let messages: Vec<serde_json::Value> =
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    let program = messages.iter().rev().find_map(|it| it["executable"].as_str());
    if let (true, Some(program)) = (output.status.success(), program) {
        return Ok(program.to_owned());
    }
    let said = messages.iter().filter(|it| it["message"]["level"] == "error");
    let said: String = said.filter_map(|it| it["message"]["rendered"].as_str()).collect();
    Err(if said.is_empty() { String::from_utf8_lossy(&output.stderr).into_owned() } else { said })
}

/// Makes calls, each by the number of a function and the words of its arguments. A panic with one of the messages `absent` is
/// from an `expect`.
pub fn run(
    program: &str,
    calls: &[(usize, Vec<u64>)],
    absent: &[String],
) -> Result<Vec<Outcome>, String> {
    let failed = |error: std::io::Error| format!("the native program: {error}");
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(failed)?;
    let mut input = Vec::new();
    for (which, words) in calls {
        let all = [*which as u64, words.len() as u64];
        all.iter().chain(words).for_each(|word| input.extend(word.to_le_bytes()));
    }
    let mut bytes = Vec::new();
    // It reads everything before it writes anything.
    if let Some(mut pipe) = child.stdin.take() {
        pipe.write_all(&input).map_err(failed)?;
    }
    if let Some(mut pipe) = child.stdout.take() {
        pipe.read_to_end(&mut bytes).map_err(failed)?;
    }
    child.wait().map_err(failed)?;
    let mut rest = bytes.as_slice();
    let mut outcomes = Vec::new();
    while let Some(outcome) = read(&mut rest, absent) {
        outcomes.push(outcome);
    }
    if outcomes.len() == calls.len() {
        return Ok(outcomes);
    }
    Err(format!("the native program ended in call {} of {}", outcomes.len(), calls.len()))
}

fn read(rest: &mut &[u8], absent: &[String]) -> Option<Outcome> {
    let count = word(rest)?;
    if count == u64::MAX {
        let length = usize::try_from(word(rest)?).ok()?;
        let (text, after) = rest.split_at_checked(length)?;
        *rest = after;
        let text = String::from_utf8_lossy(text);
        let expected = absent.iter().any(|message| text.starts_with(message.as_str()));
        return Some(Err(if expected { Fault::Absent } else { fault(&text) }));
    }
    (0..count).map(|_| word(rest)).collect::<Option<Vec<u64>>>().map(Ok)
}

fn word(bytes: &mut &[u8]) -> Option<u64> {
    let (first, rest) = bytes.split_first_chunk::<8>()?;
    *bytes = rest;
    Some(u64::from_le_bytes(*first))
}
