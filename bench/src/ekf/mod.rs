//! Measures an extended Kalman filter of twelve states and six measured numbers against code that SymForce and CasADi
//! generate for the same model.
//!
//! The filter is `bench/ekf/filter.rs`, written as a user writes it, whose derivatives the generator writes. The peers'
//! code comes from `bench/ekf/peers.py`, in a virtual environment below `target/`. Each contender runs the same inputs
//! (`bench/c/ekf_*`), and its state and covariance are compared before its instructions count.

pub mod page;

use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_codegen::{compile, generate};
use bessemer_frontend::source::Sources;
use bessemer_tests::toolchain::{self, Toolchain, run as execute};
use bessemer_tests::watch;
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

/// Packages of the peers.
const PACKAGES: [(&str, &str); 2] = [("symforce", "0.12.0"), ("casadi", "3.8.2")];

/// A processor with its type of numbers.
#[derive(Debug)]
pub struct Machine {
    /// Its name in results.
    pub name: &'static str,
    /// True for single precision.
    single: bool,
    /// Largest difference of two contenders' results, relative to the largest number.
    tolerance: f64,
}

/// The processors.
pub const MACHINES: [Machine; 2] = [
    Machine { name: "Cortex-A9, double precision", single: false, tolerance: 1e-12 },
    Machine { name: "Cortex-M4F, single precision", single: true, tolerance: 1e-4 },
];

/// Names of the contenders; the first is the emitted C.
pub const CONTENDERS: [&str; 3] = ["emitted C", "SymForce", "CasADi"];

/// Counts of a contender on a machine.
#[derive(Clone, Debug)]
pub struct Row {
    /// The machine.
    pub machine: &'static str,
    /// The contender.
    pub contender: &'static str,
    /// Instructions of the last step.
    pub instructions: u64,
    /// Instructions of the sines and cosines of a step.
    pub angles: u64,
    /// Code and constants of the filter in bytes, without elementary functions.
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
pub fn measure() -> Result<Vec<Row>, String> {
    let folder = bessemer_tests::root().join("target/bench/ekf");
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    generate_peers(&folder)?;
    let mut rows = Vec::new();
    for machine in &MACHINES {
        let mut reference: Option<Vec<f64>> = None;
        for contender in CONTENDERS {
            let (row, numbers) = run(machine, contender, &folder)?;
            match &reference {
                Some(reference) => compare(machine, contender, reference, &numbers)?,
                None => reference = Some(numbers),
            }
            rows.push(row);
        }
    }
    Ok(rows)
}

/// Compares the numbers of a contender with those of the emitted C.
fn compare(machine: &Machine, contender: &str, ours: &[f64], theirs: &[f64]) -> Result<(), String> {
    let largest = ours.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let worst =
        ours.iter().zip(theirs).fold(0.0_f64, |most, (x, y)| most.max((x - y).abs() / largest));
    match ours.len() == theirs.len() && worst <= machine.tolerance {
        true => Ok(()),
        false => Err(format!("{}: {contender} has other results, by {worst:.1e}", machine.name)),
    }
}

/// Installs the peers, unless they are, and generates their code.
fn generate_peers(folder: &Path) -> Result<(), String> {
    let python = folder.join("env/bin/python");
    if !python.exists() {
        execute(Command::new("python3").args(["-m", "venv"]).arg(folder.join("env")))?;
    }
    let wanted = PACKAGES.map(|(name, version)| format!("{name}=={version}"));
    execute(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(wanted))?;
    let script = bessemer_tests::root().join("bench/ekf/peers.py");
    execute(Command::new(&python).arg(script).arg(folder))
}

/// Emits the C of the filter; returns its sources, with true for those of elementary functions.
fn emitted(machine: &Machine, folder: &Path) -> Result<Vec<(PathBuf, bool)>, String> {
    let failed = |error: std::io::Error| error.to_string();
    let source = bessemer_tests::root().join("bench/ekf/filter.rs");
    let source = std::fs::read_to_string(source).map_err(failed)?;
    let text = if machine.single { source.replace("f64", "f32") } else { source };
    let workspace = Workspace::with_source(&text).map_err(failed)?;
    let edit = |path: PathBuf, from: &str, to: &str| {
        let text = std::fs::read_to_string(&path)?;
        std::fs::write(&path, text.replace(from, to))
    };
    let package = "bessemer = { workspace = true }";
    let both = format!("{package}\nbessemer-estimation = {{ workspace = true }}");
    edit(workspace.folder().join("Cargo.toml"), package, &both).map_err(failed)?;
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
    std::fs::copy(written, folder.join("filter.rs")).map_err(failed)?;
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
    machine: &'static Machine,
    contender: &'static str,
    folder: &Path,
) -> Result<(Row, Vec<f64>), String> {
    let toolchain = machine.toolchain();
    let c = bessemer_tests::root().join("bench/c");
    let own = folder.join(format!("{contender} {}", toolchain.bare).replace(' ', "-"));
    std::fs::create_dir_all(&own).map_err(|error| error.to_string())?;
    let mut includes = vec![c.clone()];
    let mut around = vec![c.join("ekf_main.c")];
    let mut counted = Vec::new();
    match contender {
        "emitted C" => {
            around.push(c.join("ekf_ours.c"));
            includes.push(own.join("emitted"));
            for (source, elementary) in emitted(machine, &own.join("emitted"))? {
                if elementary { around.push(source) } else { counted.push(source) }
            }
        }
        // Its code is a template, in a header: the program's own few lines count with it.
        "SymForce" => {
            counted.push(c.join("ekf_symforce.cpp"));
            includes.push(folder.join("symforce"));
            includes.push(bessemer_tests::root().join("bench/ekf/container"));
        }
        _ => {
            around.push(c.join("ekf_casadi.c"));
            let name = if machine.single { "ekf_float.c" } else { "ekf_double.c" };
            counted.push(folder.join("casadi").join(name));
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
            command.args(["-DEKF_SINGLE", "-DEKF_BARE"]);
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
    let [steps @ .., last, angles] = watched.counts.as_slice() else {
        return Err(format!("{}: {contender} did not run", machine.name));
    };
    if steps.len() != 19 || watched.words.len() != 12 + 78 + 6 {
        return Err(format!("{}: {contender} did not run all steps", machine.name));
    }
    let numbers = watched.words.iter().map(|word| f64::from_bits(*word)).collect();
    let (instructions, angles) = (*last, *angles);
    Ok((Row { machine: machine.name, contender, instructions, angles, text }, numbers))
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
pub fn json(rows: &[Row]) -> Value {
    let row = |row: &Row| {
        json!({
            "machine": row.machine,
            "contender": row.contender,
            "instructions": row.instructions,
            "sines and cosines": row.angles,
            "text": row.text,
        })
    };
    let mut versions = serde_json::Map::new();
    versions.extend(PACKAGES.map(|(name, version)| (name.to_owned(), json!(version))));
    for program in ["arm-none-eabi-gcc", "arm-linux-gnueabihf-gcc"] {
        let line = crate::dsp::first_line(program);
        versions.extend(line.map(|line| (program.to_owned(), json!(line))));
    }
    json!({
        "command": "cargo xtask bench --only ekf",
        "flags": "-O2 -ffp-contract=off",
        "Cortex-M4F flags": toolchain::CORTEX_M4F.machine.join(" "),
        "Cortex-A9 flags": toolchain::CORTEX_A9.join(" "),
        "versions": versions,
        "rows": rows.iter().map(row).collect::<Vec<_>>(),
    })
}
