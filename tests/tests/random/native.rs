//! The native leg of random programs: a program of the same package, as rustc compiles it.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{Read, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::SystemTime;

use bessemer_tests::outcome::{Outcome, fault};
use bessemer_tests::workspace::Workspace;
use bessemer_tests::{store, trees};

use super::writer::Program;

/// Returns the text of a program that calls entries. It reads the index of an entry and words, and writes the number of
/// returned words and these; or `u64::MAX`, the length of a panic's message, and its bytes.
pub fn text(programs: &[&Program]) -> String {
    let (mut cases, mut units) = (String::new(), String::new());
    let entries = programs.iter().flat_map(|it| it.entries.iter().map(|entry| (*it, entry)));
    for (index, (program, entry)) in entries.enumerate() {
        let (mut loads, mut arguments, mut stores) = (String::new(), String::new(), String::new());
        for (at, (passing, ty)) in entry.params.iter().enumerate() {
            let _ = writeln!(loads, "            let mut a{at} = <{ty} as Plain>::load(next);");
            let _ = write!(arguments, "{passing}a{at}, ");
            if *passing == "&mut " {
                let _ = writeln!(stores, "            a{at}.store(out);");
            }
        }
        let call = match &program.unit {
            Some(unit) => {
                let field = format!("units.{}", program.name);
                if entry.name == program.entries[0].name {
                    let _ = writeln!(units, "    {}: {unit},", program.name);
                }
                let kept = if !entry.stops {
                    format!("{field}.clone()")
                } else {
                    format!("{unit}::default()")
                };
                stores.insert_str(0, &format!("            {field}.store(out);\n"));
                format!("kept({kept}, &mut {field}, |it| it.{}({arguments}))", entry.name)
            }
            None => format!("{}({arguments})", entry.name),
        };
        let _ = write!(
            cases,
            "        {index} => {{ // {}\n{loads}            let result = {call};\n            \
             result.store(out);\n{stores}        }}\n",
            program.name
        );
    }
    MAIN.replace("CASES", &cases).replace("UNITS", &units)
}

const MAIN: &str = r#"//! Calls the random programs.
#![allow(warnings)]
use bessemer::Plain;
use bessemer::prelude::*;
use models::*;
use std::io::{Read, Write};

/// The components, each in its life.
#[derive(Default)]
struct Units {
UNITS}

/// Returns the result of a call; if it panics, the component becomes `after`.
fn kept<U, R>(after: U, unit: &mut U, call: impl FnOnce(&mut U) -> R) -> R {
    match std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| call(unit))) {
        Ok(result) => result,
        Err(panic) => {
            *unit = after;
            std::panic::resume_unwind(panic)
        }
    }
}

fn call(units: &mut Units, which: u64, next: &mut dyn FnMut() -> u64, out: &mut dyn FnMut(u64)) {
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
    let mut units = Units::default();
    while let (Some(which), Some(count)) = (words.next(), words.next()) {
        let call_words: Vec<u64> = words.by_ref().take(count as usize).collect();
        let mut given = call_words.iter().copied();
        let mut out: Vec<u64> = Vec::new();
        let called = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            call(&mut units, which, &mut || given.next().expect("a word"), &mut |word| out.push(word));
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

/// The name of the program.
const NAME: &str = "random-native";
/// Its file in the package.
pub const SOURCE: &str = "src/bin/random-native.rs";

/// Builds the program, unless the same was built before; what rustc says if it does not like it.
pub fn build(workspace: &Workspace, programs: &[&Program]) -> Result<String, String> {
    let path = workspace.folder().join(SOURCE);
    std::fs::write(path, text(programs)).expect("a source file");
    let content = trees::content(&workspace.job(), &[workspace.folder()]);
    let place = |kind| content.as_ref().and_then(|content| store::place(kind, content));
    let (built, refused) = (place("native"), place("native-refused"));
    let own = workspace.path(NAME);
    if built.as_ref().is_some_and(|built| store::fetch(built, &own)) {
        return Ok(own.display().to_string());
    }
    if let Some(Ok(said)) = refused.as_ref().map(std::fs::read_to_string) {
        return Err(said);
    }
    let result = build_anew(workspace, &own);
    let said = workspace.path("said");
    std::fs::write(&said, result.as_ref().err().map_or("", String::as_str)).expect("a file");
    let (made, place) = if result.is_ok() { (&own, built) } else { (&said, refused) };
    place.into_iter().for_each(|place| store::store(made, &place).expect("the target folder"));
    result.map(|()| own.display().to_string())
}

/// Builds the program as `own`, alone: cargo takes the models of another workspace, built into the same folder since these
/// were written, for these.
fn build_anew(workspace: &Workspace, own: &Path) -> Result<(), String> {
    let alone = workspace.alone().expect("the target folder");
    for source in ["src/lib.rs", SOURCE] {
        let source = File::options().append(true).open(workspace.folder().join(source));
        let touched = source.and_then(|file| file.set_modified(SystemTime::now()));
        touched.expect("a source file");
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--quiet", "--package", "models", "--bin", NAME])
        .args(["--message-format=json", "--config", "profile.dev.package.models.opt-level=0"])
        .current_dir(workspace.path(""))
        .output()
        .expect("cargo runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let messages: Vec<serde_json::Value> =
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    if output.status.success() {
        let program = messages.iter().rev().find_map(|it| it["executable"].as_str());
        // Another run may build its own to the same place.
        std::fs::copy(program.expect("a program"), own).expect("a copy of it");
        drop(alone);
        return Ok(());
    }
    let said = messages.iter().filter(|it| it["message"]["level"] == "error");
    let said: String = said.filter_map(|it| it["message"]["rendered"].as_str()).collect();
    // Without an error of rustc, cargo was ended, or its own message says why it failed.
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(!said.is_empty(), "cargo: {}: {stderr}", output.status);
    Err(said)
}

/// The name of the program that is called where the native program has this line.
pub fn at(workspace: &Workspace, line: usize) -> Option<String> {
    let text = std::fs::read_to_string(workspace.folder().join(SOURCE)).ok()?;
    let above: Vec<_> = text.lines().take(line).collect();
    above.iter().rev().find_map(|it| Some(it.split_once("=> { // ")?.1.to_owned()))
}

/// Makes calls, each of a program by its place and the words of its arguments.
pub fn run(program: &str, calls: &[(usize, Vec<u64>)]) -> Vec<Outcome> {
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut input = Vec::new();
    for (which, words) in calls {
        let all = [*which as u64, words.len() as u64];
        all.iter().chain(words).for_each(|word| input.extend(word.to_le_bytes()));
    }
    let mut bytes = Vec::new();
    // It reads everything before it writes anything.
    child.stdin.take().expect("a pipe").write_all(&input).expect("it reads");
    child.stdout.take().expect("a pipe").read_to_end(&mut bytes).expect("it writes");
    assert!(child.wait().expect("it ends").success(), "the native program failed");
    let mut rest = bytes.as_slice();
    let mut outcomes = Vec::new();
    while !rest.is_empty() {
        let count = word(&mut rest);
        outcomes.push(if count == u64::MAX {
            let (text, after) = rest[8..].split_at(word(&mut &rest[..8]) as usize);
            rest = after;
            Err(fault(&String::from_utf8_lossy(text)))
        } else {
            Ok((0..count).map(|_| word(&mut rest)).collect())
        });
    }
    assert_eq!(outcomes.len(), calls.len(), "an outcome of each call");
    outcomes
}

fn word(bytes: &mut &[u8]) -> u64 {
    let (first, rest) = bytes.split_at(8);
    *bytes = rest;
    first.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte))
}
