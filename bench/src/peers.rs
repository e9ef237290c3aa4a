//! Instructions and bytes of emitted C beside code that other generators make of the same model.
//!
//! The model is in the DSL, written as a user writes it; the peers' code comes from a script, in a virtual environment below
//! `target/`. Each contender runs the same inputs, and its results are compared before its instructions count.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_codegen::{compile, generate};
use bessemer_frontend::source::Sources;
use bessemer_tests::toolchain::{self, Toolchain, run as execute};
use bessemer_tests::watch;
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::dsp::page::grouped;

/// A model that the contenders compute.
#[derive(Debug)]
pub struct Subject {
    /// Its part of the command, and the name of its folder and of its results.
    pub name: &'static str,
    /// Its source in the DSL, from the root.
    pub source: &'static str,
    /// Packages of the peers, with their versions.
    pub packages: &'static [(&'static str, &'static str)],
    /// Names of the contenders; the first is the emitted C.
    pub contenders: &'static [&'static str],
    /// Counted parts of a call, in order.
    pub parts: &'static [&'static str],
    /// True if the sines and cosines of a call are counted, too, after the last one.
    pub angles: bool,
    /// Number of reported numbers, the sines and cosines among them.
    pub words: usize,
    /// Largest difference of two contenders' results on each machine, relative to the largest number.
    pub tolerances: [f64; 2],
}

/// Number of calls of a program; the last one counts.
const CALLS: usize = 20;

/// A processor with its type of numbers.
#[derive(Debug)]
pub struct Machine {
    /// Its name in results.
    pub name: &'static str,
    /// True for single precision.
    single: bool,
}

/// The processors.
pub const MACHINES: [Machine; 2] = [
    Machine { name: "Cortex-A9, double precision", single: false },
    Machine { name: "Cortex-M4F, single precision", single: true },
];

/// Counts of a contender on a machine.
#[derive(Clone, Debug)]
pub struct Row {
    /// The machine.
    pub machine: &'static str,
    /// The contender.
    pub contender: &'static str,
    /// Instructions of each part of the last call.
    pub parts: Vec<(&'static str, u64)>,
    /// Instructions of the sines and cosines alone.
    pub angles: Option<u64>,
    /// Code and constants in bytes, without elementary functions.
    pub text: u64,
}

impl Machine {
    fn toolchain(&self) -> Toolchain {
        if self.single { toolchain::CORTEX_M4F } else { toolchain::ARM }
    }
}

/// Measures every contender.
///
/// # Errors
/// The message of a tool, or that a contender's results differ.
pub fn measure(subject: &Subject) -> Result<Vec<Row>, String> {
    let folder = bessemer_tests::root().join("target/bench").join(subject.name);
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    generate_peers(subject, &folder)?;
    let mut rows = Vec::new();
    for (machine, tolerance) in MACHINES.iter().zip(subject.tolerances) {
        let mut reference: Option<Vec<f64>> = None;
        for contender in subject.contenders {
            let (row, numbers) = run(subject, machine, contender, &folder)?;
            match &reference {
                Some(reference) => {
                    let worst = difference(reference, &numbers);
                    if worst.is_none_or(|it| it > tolerance) {
                        let name = machine.name;
                        return Err(format!("{name}: {contender} has other results: {worst:?}"));
                    }
                }
                None => reference = Some(numbers),
            }
            rows.push(row);
        }
    }
    Ok(rows)
}

/// Returns the largest difference of two contenders' numbers, relative to the largest; none if their counts differ.
fn difference(ours: &[f64], theirs: &[f64]) -> Option<f64> {
    let largest = ours.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let each = ours.iter().zip(theirs).map(|(x, y)| (x - y).abs() / largest);
    // NaN is the largest.
    let worst = each.fold(0.0_f64, |most, x| if x <= most { most } else { x });
    (ours.len() == theirs.len()).then_some(worst)
}

/// Installs the peers, unless they are, and generates their code.
fn generate_peers(subject: &Subject, folder: &Path) -> Result<(), String> {
    let python = folder.join("env/bin/python");
    if !python.exists() {
        execute(Command::new("python3").args(["-m", "venv"]).arg(folder.join("env")))?;
    }
    let wanted = subject.packages.iter().map(|(name, version)| format!("{name}=={version}"));
    execute(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(wanted))?;
    let script = bessemer_tests::root().join("bench").join(subject.name).join("peers.py");
    execute(Command::new(&python).arg(script).arg(folder))
}

/// Emits the C of the model; returns its sources, with true for those of elementary functions.
fn emitted(
    subject: &Subject,
    machine: &Machine,
    folder: &Path,
) -> Result<Vec<(PathBuf, bool)>, String> {
    let failed = |error: std::io::Error| error.to_string();
    let source = bessemer_tests::root().join(subject.source);
    let source = std::fs::read_to_string(source).map_err(failed)?;
    let alone = "#![no_std]";
    let source = if source.contains(alone) { source } else { format!("{alone}\n{source}") };
    let text = if machine.single { source.replace("f64", "f32") } else { source };
    let workspace = Workspace::with_source(&text).map_err(failed)?;
    let edit = |path: PathBuf, from: &str, to: &str| {
        let text = std::fs::read_to_string(&path)?;
        std::fs::write(&path, text.replace(from, to))
    };
    if machine.single {
        // Functions of `f32` in `f32` alone, as on any processor without doubles.
        let dsl = "bessemer = { path = \"dsl\"";
        let alone = format!("{dsl}, features = [\"single\"]");
        edit(workspace.path("Cargo.toml"), dsl, &alone).map_err(failed)?;
    }
    let job = workspace.job();
    let tree = generate::renewed(&job).map_err(|error| error.to_string())?;
    let sources = Sources::new(&job.root);
    let compiled = compile::compile(&tree.package, &sources, &job.options)
        .map_err(|errors| bessemer_frontend::diagnostic::render(&errors, &sources, false))?;
    if folder.exists() {
        std::fs::remove_dir_all(folder).map_err(failed)?;
    }
    std::fs::create_dir_all(folder).map_err(failed)?;
    let written = workspace.folder().join("src/lib.rs");
    std::fs::copy(written, folder.join("model.rs")).map_err(failed)?;
    let mut sources = Vec::new();
    for file in &compiled.files {
        let path = folder.join(&file.name);
        std::fs::write(&path, &file.text).map_err(failed)?;
        let elementary = ELEMENTARY.iter().any(|name| file.name.starts_with(name));
        sources.extend(file.name.ends_with(".c").then_some((path, elementary)));
    }
    Ok(sources)
}

/// Beginnings of the names of files with elementary functions.
const ELEMENTARY: [&str; 2] = ["sine", "reduction"];

/// Builds and runs a contender.
fn run(
    subject: &Subject,
    machine: &'static Machine,
    contender: &'static str,
    folder: &Path,
) -> Result<(Row, Vec<f64>), String> {
    let toolchain = machine.toolchain();
    let c = bessemer_tests::root().join("bench/c");
    let own = folder.join(format!("{contender} {}", toolchain.bare).replace(' ', "-"));
    std::fs::create_dir_all(&own).map_err(|error| error.to_string())?;
    let mut includes = vec![c.clone()];
    let of = |rest: &str| c.join(format!("{}_{rest}", subject.name));
    let mut around = vec![of("main.c")];
    let mut counted = Vec::new();
    match contender {
        "emitted C" => {
            around.push(of("ours.c"));
            includes.push(own.join("emitted"));
            for (source, elementary) in emitted(subject, machine, &own.join("emitted"))? {
                if elementary { around.push(source) } else { counted.push(source) }
            }
        }
        // Its code is a template, in a header: the program's own few lines count with it.
        "SymForce" => {
            counted.push(of("symforce.cpp"));
            includes.push(folder.join("symforce"));
            includes.push(bessemer_tests::root().join("bench/ekf/container"));
        }
        _ => {
            around.push(of("casadi.c"));
            let real = if machine.single { "float" } else { "double" };
            counted.push(folder.join("casadi").join(format!("{}_{real}.c", subject.name)));
        }
    }
    around.extend(watch::start(&toolchain, &own)?);
    let mut objects = Vec::new();
    let mut text = 0;
    for (index, source) in counted.iter().chain(&around).enumerate() {
        let object = own.join(format!("{index}.o"));
        let mut command = Command::new(compiler(&toolchain, source));
        command.args(["-O2", "-ffp-contract=off", "-w"]).args(toolchain.machine);
        if machine.single {
            command.args(["-DBENCH_SINGLE", "-DBENCH_BARE"]);
        }
        for include in &includes {
            command.arg("-I").arg(include);
        }
        execute(command.arg("-c").arg(source).arg("-o").arg(&object))?;
        if index < counted.len() {
            text += size(&toolchain, &object)?;
        }
        objects.push(object);
    }
    let program = own.join("program");
    let mut command = Command::new(toolchain.compiler);
    command.arg("-O2").args(toolchain.machine).args(&objects).arg("-o").arg(&program);
    execute(command.arg("-lm"))?;
    let watched = watch::counted(&toolchain, &own, &program, &[])?;
    let (steps, angles) = match watched.counts.as_slice() {
        [steps @ .., angles] if subject.angles => (steps, Some(*angles)),
        steps => (steps, None),
    };
    let parts = subject.parts;
    if steps.len() != CALLS * parts.len() || watched.words.len() != subject.words {
        return Err(format!("{}: {contender} did not run all steps", machine.name));
    }
    let numbers = watched.words.iter().map(|word| f64::from_bits(*word)).collect();
    let last = steps[steps.len() - parts.len()..].iter().copied();
    let parts = parts.iter().copied().zip(last).collect();
    Ok((Row { machine: machine.name, contender, parts, angles, text }, numbers))
}

fn compiler(toolchain: &Toolchain, source: &Path) -> String {
    match source.extension().is_some_and(|extension| extension == "cpp") {
        true => toolchain.compiler.replace("gcc", "g++"),
        false => toolchain.compiler.to_owned(),
    }
}

/// Returns the bytes of code and constants of an object file.
fn size(toolchain: &Toolchain, object: &Path) -> Result<u64, String> {
    let program = toolchain.compiler.replace("gcc", "size");
    let output = Command::new(&program).arg(object).output();
    let output = output.map_err(|error| format!("{program}: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let number = text.lines().nth(1).and_then(|line| line.split_whitespace().next()?.parse().ok());
    number.ok_or_else(|| format!("{program} wrote `{text}`"))
}

/// Formats the rows for machines.
pub fn json(subject: &Subject, rows: &[Row]) -> Value {
    let row = |row: &Row| {
        let mut counts = json!({
            "machine": row.machine,
            "contender": row.contender,
            "instructions": row.parts.iter().map(|(_, count)| count).sum::<u64>(),
            "text": row.text,
        });
        if let Some(angles) = row.angles {
            counts["sines and cosines"] = json!(angles);
        }
        for (part, count) in row.parts.iter().filter(|_| row.parts.len() > 1) {
            counts[*part] = json!(count);
        }
        counts
    };
    let mut versions = serde_json::Map::new();
    let packages = subject.packages.iter();
    versions.extend(packages.map(|(name, version)| ((*name).to_owned(), json!(version))));
    for program in ["arm-none-eabi-gcc", "arm-linux-gnueabihf-gcc"] {
        let line = crate::dsp::first_line(program);
        versions.extend(line.map(|line| (program.to_owned(), json!(line))));
    }
    json!({
        "command": format!("cargo xtask bench --only {}", subject.name),
        "flags": "-O2 -ffp-contract=off",
        "Cortex-M4F flags": toolchain::CORTEX_M4F.machine.join(" "),
        "Cortex-A9 flags": toolchain::CORTEX_A9.join(" "),
        "versions": versions,
        "rows": rows.iter().map(row).collect::<Vec<_>>(),
    })
}

/// Writes a table for each machine, with a row for each of these keys and titles, and the versions.
pub fn tables(text: &mut String, subject: &Subject, json: &Value, keys: &[(&str, &str)]) {
    for machine in &MACHINES {
        let row = |contender: &str| {
            let rows = json["rows"].as_array().into_iter().flatten();
            let mut of = rows.filter(|row| {
                row["machine"].as_str() == Some(machine.name)
                    && row["contender"].as_str() == Some(contender)
            });
            of.next().unwrap_or(&Value::Null)
        };
        let contenders = subject.contenders;
        let _ = writeln!(text, "\n## {}\n\n| | {} |", machine.name, contenders.join(" | "));
        let _ = writeln!(text, "|---|{}", "--:|".repeat(contenders.len()));
        for (key, title) in keys {
            let cell = |name: &&str| row(name)[*key].as_u64().map_or("–".to_owned(), grouped);
            let cells: Vec<String> = contenders.iter().map(cell).collect();
            let _ = writeln!(text, "| {title} | {} |", cells.join(" | "));
        }
    }
    *text += "\n## Versions\n\n";
    for (name, version) in json["versions"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "* {name}: {}", version.as_str().unwrap_or_default());
    }
}
