//! The predictive control: its text by the budget of code, and its time on the host beside Eigen.
//!
//! Times are medians of alternating calls of the emitted C and of Eigen in one program (`bench/c/dsp_host.c`), so that a busy machine disturbs both;
//! each pair of rounds has a ratio. Must not know: the page.

use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_backend::kernels::Tuning;
use bessemer_codegen::compile::{Compiled, Options};
use bessemer_tests::toolchain::{self, run as execute};
use serde_json::{Value, json};

use super::jobs::Machine;
use super::program::{self, CONTENDERS};

/// Budgets of code, in bytes: the default, and one without written out loops.
const BUDGETS: [u32; 2] = [8 * 1024, 512];

/// Text and instructions with a budget of code.
#[derive(Clone, Copy, Debug)]
pub struct Text {
    /// The budget, `kernels.code_bytes`.
    pub code_bytes: u32,
    /// Bytes of the step with its private functions.
    pub step: u64,
    /// Bytes of its kernels.
    pub kernels: u64,
    /// Instructions of the last call.
    pub instructions: u64,
}

/// Times on the host.
#[derive(Clone, Copy, Debug)]
pub struct Host {
    /// Microseconds of a step: the emitted C, and Eigen.
    pub micros: [f64; 2],
    /// Lower quartile, median and upper quartile of the ratio of two rounds.
    pub ratio: [f64; 3],
}

/// Measures the text for the Cortex-A9.
///
/// # Errors
/// The message of a tool.
pub fn texts(compiled: &Compiled, folder: &Path) -> Result<Vec<Text>, String> {
    BUDGETS.into_iter().map(|code_bytes| text(compiled, folder, code_bytes)).collect()
}

fn text(compiled: &Compiled, folder: &Path, code_bytes: u32) -> Result<Text, String> {
    let folder = folder.join(format!("budget-{code_bytes}"));
    let kernels = Tuning { code_bytes, ..Tuning::default() };
    let small = compiled.anew(&Options { kernels, ..Options::default() });
    let small = small.map_err(|_| "the C of another budget has errors".to_owned())?;
    let sources = program::written(&small, &folder)?;
    let ours = |it: &&program::Contender| it.peer.is_none() && it.machine == Machine::A9;
    let contender = CONTENDERS.iter().find(ours).ok_or("no contender on the Cortex-A9")?;
    let run = program::run(contender, &folder, &sources, None)?;
    let calls = run.counts.first().and_then(|calls| calls.last());
    let instructions = *calls.ok_or("the predictive control did not run")?;
    let (mut step, mut kernels) = (0, 0);
    for source in &sources {
        let name = source.file_name().unwrap_or_default().to_string_lossy();
        let object = folder.join("text.o");
        let is_kernel = name.starts_with("product_") && name.ends_with("x1.c");
        if name == "mpc.c" || is_kernel {
            let mut command = Command::new(toolchain::ARM.compiler);
            command.args(["-std=gnu99", "-O2", "-ffp-contract=off", "-w"]);
            command.args(toolchain::CORTEX_A9).arg("-c").arg(source).arg("-o").arg(&object);
            execute(&mut command)?;
        }
        match &*name {
            "mpc.c" => step = symbol(&object, "mpc_step")?,
            _ if is_kernel => kernels += section(&object)?,
            _ => {}
        }
    }
    Ok(Text { code_bytes, step, kernels, instructions })
}

/// Returns what a program of the toolchain prints about an object.
fn printed(program: &str, arguments: &[&str], object: &Path) -> Result<String, String> {
    let program = toolchain::ARM.compiler.replace("gcc", program);
    let output = Command::new(&program).args(arguments).arg(object).output();
    let output = output.map_err(|error| format!("{program}: {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Returns the bytes of a function.
fn symbol(object: &Path, name: &str) -> Result<u64, String> {
    let text = printed("nm", &["-S"], object)?;
    let line = text.lines().find(|line| line.ends_with(&format!(" {name}")));
    let size = line.and_then(|line| line.split_whitespace().nth(1));
    let size = size.and_then(|size| u64::from_str_radix(size, 16).ok());
    size.ok_or_else(|| format!("`{name}` is not in the object"))
}

/// Returns the bytes of code and constants.
fn section(object: &Path) -> Result<u64, String> {
    let text = printed("size", &[], object)?;
    let number = text.lines().nth(1).and_then(|line| line.split_whitespace().next()?.parse().ok());
    number.ok_or_else(|| format!("size wrote `{text}`"))
}

/// Measures times on the host; `peers` is the folder with `TinyMPC`, which has Eigen.
///
/// # Errors
/// The message of a tool, or that the results differ.
pub fn host(emitted: &[PathBuf], folder: &Path, peers: &Path) -> Result<Host, String> {
    let own = folder.join("host");
    std::fs::create_dir_all(&own).map_err(|error| error.to_string())?;
    let c = bessemer_tests::root().join("bench/c");
    let mut sources = vec![c.join("dsp_host.c"), c.join("dsp_mpc.c"), c.join("dsp_eigen.cpp")];
    sources.extend_from_slice(emitted);
    let includes = [c, folder.join("emitted"), peers.join("TinyMPC/include/Eigen")];
    let mut objects = Vec::new();
    for (index, source) in sources.iter().enumerate() {
        let name = source.file_name().unwrap_or_default().to_string_lossy();
        let (compiler, jobs) = match &*name {
            "dsp_eigen.cpp" => ("g++", "-Drun_jobs=run_eigen"),
            _ => ("gcc", "-Drun_jobs=run_emitted"),
        };
        let object = own.join(format!("{index}.o"));
        let mut command = Command::new(compiler);
        command.args(["-O2", "-ffp-contract=off", "-w", "-DNDEBUG", jobs]);
        command.arg(if compiler == "g++" { "-std=c++17" } else { "-std=gnu99" });
        for include in &includes {
            command.arg("-I").arg(include);
        }
        execute(command.arg("-c").arg(source).arg("-o").arg(&object))?;
        objects.push(object);
    }
    let program = own.join("program");
    execute(Command::new("g++").args(&objects).arg("-o").arg(&program).arg("-lm"))?;
    let output = Command::new(&program).output().map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|it| it.parse().ok()).collect();
    match (output.status.success(), &numbers[..]) {
        (true, &[ours, eigen, low, median, high]) => {
            Ok(Host { micros: [ours, eigen], ratio: [low, median, high] })
        }
        _ => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
    }
}

/// Formats the text for machines.
pub fn texts_json(texts: &[Text]) -> Value {
    let one = |text: &Text| {
        json!({
            "code_bytes": text.code_bytes,
            "step": text.step,
            "kernels": text.kernels,
            "instructions": text.instructions,
        })
    };
    texts.iter().map(one).collect()
}

/// Formats the times for machines.
pub fn host_json(host: Option<&Host>) -> Value {
    host.map_or(Value::Null, |host| {
        json!({
            "flags": "-O2 -ffp-contract=off",
            "emitted C, µs": host.micros[0],
            "Eigen, µs": host.micros[1],
            "ratio": { "lower quartile": host.ratio[0], "median": host.ratio[1], "upper quartile": host.ratio[2] },
        })
    })
}
