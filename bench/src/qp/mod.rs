//! Measures the solvers of quadratic programs against OSQP's and CVXPYgen's code and TinyMPC, on a predictive control.
//!
//! Twelve states, four inputs with limits, ten periods, double precision, on the Cortex-A9. The emitted C comes from
//! `bench/qp/controllers.rs`; the problem and the peers' code from `bench/qp/peers.py`, in a virtual environment below
//! `target/`. TinyMPC is in a folder that the caller names; without it the others are measured alone. Each contender
//! gets the same states, and its inputs are compared before its instructions count.

pub mod page;

use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_tests::toolchain::{self, Toolchain, run as execute};
use bessemer_tests::watch;
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

/// Packages of the peers.
const PACKAGES: [(&str, &str); 3] = [("osqp", "1.1.3"), ("cvxpygen", "1.0.2"), ("cvxpy", "1.9.3")];
/// Largest difference of an input from the first contender's, relative to the largest input.
const TOLERANCE: f64 = 1e-6;
/// States of the problem.
const STEPS: usize = 20;
/// The machine.
const MACHINE: Toolchain = toolchain::ARM;

/// Names of the contenders; the first two are the emitted C.
pub const CONTENDERS: [&str; 5] = ["active set", "ADMM", "OSQP", "CVXPYgen", "TinyMPC"];

/// Counts of a contender.
#[derive(Clone, Debug)]
pub struct Row {
    /// The contender.
    pub contender: &'static str,
    /// Mean and most instructions of a step.
    pub instructions: [u64; 2],
    /// Code and constants, in bytes.
    pub text: u64,
    /// Variables, in bytes.
    pub ram: u64,
    /// Largest difference of an input from the first contender's, relative to the largest input.
    pub error: f64,
}

/// Measures every contender; `peers` is the folder with `TinyMPC`.
///
/// # Errors
/// The message of a tool, or that a contender's results differ.
pub fn measure(peers: Option<&Path>) -> Result<Vec<Row>, String> {
    let folder = bessemer_tests::root().join("target/bench/qp");
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    generate_peers(&folder)?;
    let mut rows: Vec<Row> = Vec::new();
    let mut reference: Vec<f64> = Vec::new();
    for contender in CONTENDERS {
        if contender == "TinyMPC" && peers.is_none() {
            continue;
        }
        let (mut row, inputs) = run(contender, &folder, peers)?;
        if reference.is_empty() {
            reference.clone_from(&inputs);
        }
        let largest = reference.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let pairs = reference.iter().zip(&inputs);
        row.error = pairs.fold(0.0_f64, |most, (x, y)| most.max((x - y).abs() / largest));
        if reference.len() != inputs.len() || row.error.is_nan() || row.error > TOLERANCE {
            return Err(format!("{contender} has other inputs, by {:.1e}", row.error));
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Installs the peers, unless they are, and generates their code and the problem.
fn generate_peers(folder: &Path) -> Result<(), String> {
    let python = folder.join("env/bin/python");
    if !python.exists() {
        execute(Command::new("python3").args(["-m", "venv"]).arg(folder.join("env")))?;
    }
    let wanted = PACKAGES.map(|(name, version)| format!("{name}=={version}"));
    execute(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(wanted))?;
    let script = bessemer_tests::root().join("bench/qp/peers.py");
    execute(Command::new(&python).arg(script).arg(folder))
}

/// Emits the C of the solvers; returns its sources but those of the other solver.
fn emitted(folder: &Path, other: &str) -> Result<Vec<PathBuf>, String> {
    let failed = |error: std::io::Error| error.to_string();
    let source = bessemer_tests::root().join("bench/qp/controllers.rs");
    let source = std::fs::read_to_string(source).map_err(failed)?;
    let workspace = Workspace::with_source(&source).map_err(failed)?;
    let manifest = workspace.folder().join("Cargo.toml");
    let text = std::fs::read_to_string(&manifest).map_err(failed)?;
    let package = "bessemer = { workspace = true }";
    let both = format!("{package}\nbessemer-blocks = {{ workspace = true }}");
    std::fs::write(&manifest, text.replace(package, &both)).map_err(failed)?;
    let compiled = workspace.compiled()?;
    if folder.exists() {
        std::fs::remove_dir_all(folder).map_err(failed)?;
    }
    std::fs::create_dir_all(folder).map_err(failed)?;
    let mut sources = Vec::new();
    for file in &compiled.files {
        let path = folder.join(&file.name);
        std::fs::write(&path, &file.text).map_err(failed)?;
        let own = file.name.ends_with(".c") && file.name != other;
        sources.extend(own.then_some(path));
    }
    Ok(sources)
}

/// Returns the sources of C in a folder.
fn sources(folder: &Path, but: &[&str]) -> Result<Vec<PathBuf>, String> {
    let entries =
        std::fs::read_dir(folder).map_err(|why| format!("{}: {why}", folder.display()))?;
    let mut all: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    let is_one = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        name.ends_with(".c") && !but.contains(&&*name)
    };
    all.retain(is_one);
    all.sort();
    Ok(all)
}

/// Builds and runs a contender.
fn run(
    contender: &'static str,
    folder: &Path,
    peers: Option<&Path>,
) -> Result<(Row, Vec<f64>), String> {
    let c = bessemer_tests::root().join("bench/c");
    let own = folder.join(contender.replace(' ', "-"));
    std::fs::create_dir_all(&own).map_err(|error| error.to_string())?;
    let mut around = vec![c.join("qp_main.c")];
    let mut includes = vec![c.clone(), folder.to_owned(), own.join("emitted")];
    let mut counted = Vec::new();
    match contender {
        "active set" => {
            around.push(c.join("qp_exact.c"));
            counted = emitted(&own.join("emitted"), "split.c")?;
        }
        "ADMM" => {
            around.push(c.join("qp_split.c"));
            counted = emitted(&own.join("emitted"), "exact.c")?;
        }
        "OSQP" => {
            around.push(c.join("qp_osqp.c"));
            let code = folder.join("osqp");
            counted.push(code.join("workspace.c"));
            counted.extend(sources(&code.join("src"), &[])?);
            includes.extend(["inc/public", "inc/private", ""].map(|below| code.join(below)));
        }
        "CVXPYgen" => {
            around.push(c.join("qp_cvxpygen.c"));
            let code = folder.join("cvxpygen/c");
            counted.push(code.join("solver_code/workspace.c"));
            counted.extend(sources(&code.join("src"), &["cpg_example.c"])?);
            counted.extend(sources(&code.join("solver_code/src"), &[])?);
            let below =
                ["include", "solver_code", "solver_code/inc/public", "solver_code/inc/private"];
            includes.extend(below.map(|below| code.join(below)));
        }
        _ => {
            around.push(c.join("qp_tinympc.cpp"));
            let code = peers.unwrap_or(folder).join("TinyMPC");
            let names = ["admm.cpp", "rho_benchmark.cpp", "tiny_api.cpp"];
            counted.extend(names.map(|name| code.join("src/tinympc").join(name)));
            includes.extend([code.join("src"), code.join("include/Eigen")]);
        }
    }
    around.extend(watch::start(&MACHINE, &own)?);
    let mut objects = Vec::new();
    let (mut text, mut ram) = (0, 0);
    for (index, source) in counted.iter().chain(&around).enumerate() {
        let object = own.join(format!("{index}.o"));
        let mut command = Command::new(compiler(source));
        command.args(["-O2", "-ffp-contract=off", "-w", "-DNDEBUG"]).args(MACHINE.machine);
        for include in &includes {
            command.arg("-I").arg(include);
        }
        execute(command.arg("-c").arg(source).arg("-o").arg(&object))?;
        // The data of the contender's own program counts as well, without the tables of the problem.
        let [code, data] = sizes(&object)?;
        text += if index < counted.len() { code } else { 0 };
        ram += if index <= counted.len() + 1 { data } else { 0 };
        objects.push(object);
    }
    let program = own.join("program");
    let last = counted.iter().find(|it| is_cpp(it)).unwrap_or(&around[0]);
    let mut command = Command::new(compiler(last));
    command.arg("-O2").args(MACHINE.machine).args(&objects).arg("-o").arg(&program);
    execute(command.arg("-lm"))?;
    let watched = watch::counted(&MACHINE, &own, &program, &[])?;
    if watched.counts.len() != STEPS || watched.words.len() != 4 * STEPS {
        return Err(format!("{contender} did not run all steps"));
    }
    let sum: u64 = watched.counts.iter().sum();
    let most = watched.counts.iter().copied().max().unwrap_or_default();
    let instructions = [sum / STEPS as u64, most];
    let inputs = watched.words.iter().map(|word| f64::from_bits(*word)).collect();
    Ok((Row { contender, instructions, text, ram, error: 0.0 }, inputs))
}

fn is_cpp(source: &Path) -> bool {
    source.extension().is_some_and(|extension| extension == "cpp")
}

fn compiler(source: &Path) -> String {
    match is_cpp(source) {
        true => MACHINE.compiler.replace("gcc", "g++"),
        false => MACHINE.compiler.to_owned(),
    }
}

/// Returns the bytes of an object file: code with constants, and variables.
fn sizes(object: &Path) -> Result<[u64; 2], String> {
    let program = MACHINE.compiler.replace("gcc", "size");
    let output = Command::new(&program).arg(object).output();
    let output = output.map_err(|error| format!("{program}: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let words = text.lines().nth(1).into_iter().flat_map(str::split_whitespace);
    let numbers: Vec<u64> = words.map_while(|word| word.parse().ok()).collect();
    match numbers[..] {
        [code, data, zeros, ..] => Ok([code, data + zeros]),
        _ => Err(format!("{program} wrote `{text}`")),
    }
}

/// Formats the rows for machines.
pub fn json(rows: &[Row]) -> Value {
    let row = |row: &Row| {
        json!({
            "contender": row.contender,
            "mean": row.instructions[0],
            "most": row.instructions[1],
            "text": row.text,
            "ram": row.ram,
            "error": format!("{:.1e}", row.error),
        })
    };
    let mut versions = serde_json::Map::new();
    versions.extend(PACKAGES.map(|(name, version)| (name.to_owned(), json!(version))));
    let line = crate::dsp::first_line(MACHINE.compiler);
    versions.extend(line.map(|line| (MACHINE.compiler.to_owned(), json!(line))));
    json!({
        "command": "cargo xtask bench --only qp --peers FOLDER",
        "flags": "-O2 -ffp-contract=off",
        "Cortex-A9 flags": toolchain::CORTEX_A9.join(" "),
        "versions": versions,
        "rows": rows.iter().map(row).collect::<Vec<_>>(),
    })
}
