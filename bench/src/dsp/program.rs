//! The programs of the contenders: how each is built and run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_codegen::compile::Compiled;
use bessemer_codegen::estimate;
use bessemer_ir::Owner;
use bessemer_tests::toolchain::{self, Toolchain, run as execute};
use bessemer_tests::watch;
use bessemer_tests::workspace::Workspace;

use super::jobs::{JOBS, Machine};

/// A contender on one machine.
#[derive(Debug)]
pub struct Contender {
    /// Its name in results.
    pub name: &'static str,
    /// Machine on which it runs.
    pub machine: Machine,
    /// Its jobs, in `bench/c/`.
    jobs: &'static str,
    /// The folder that it needs, below the one that the caller names.
    pub peer: Option<&'static str>,
    /// Sources of that folder.
    sources: &'static [&'static str],
    /// Additional flags.
    flags: &'static [&'static str],
}

/// Sources of CMSIS-DSP that the jobs need.
const CMSIS: &[&str] = &[
    "Source/CommonTables/arm_common_tables.c",
    "Source/FastMathFunctions/arm_atan2_f32.c",
    "Source/FastMathFunctions/arm_cos_f32.c",
    "Source/FastMathFunctions/arm_sin_f32.c",
    "Source/FastMathFunctions/arm_vexp_f32.c",
    "Source/FilteringFunctions/arm_biquad_cascade_df1_f32.c",
    "Source/FilteringFunctions/arm_biquad_cascade_df1_init_f32.c",
    "Source/FilteringFunctions/arm_biquad_cascade_df2T_f32.c",
    "Source/FilteringFunctions/arm_biquad_cascade_df2T_init_f32.c",
    "Source/FilteringFunctions/arm_fir_f32.c",
    "Source/FilteringFunctions/arm_fir_init_f32.c",
    "Source/MatrixFunctions/arm_mat_cholesky_f32.c",
    "Source/MatrixFunctions/arm_mat_mult_f32.c",
    "Source/MatrixFunctions/arm_mat_solve_lower_triangular_f32.c",
    "Source/MatrixFunctions/arm_mat_solve_upper_triangular_f32.c",
    "Source/MatrixFunctions/arm_mat_trans_f32.c",
];

/// The contenders; the first of each machine is the emitted C.
pub const CONTENDERS: &[Contender] = &[
    Contender {
        name: "emitted C",
        machine: Machine::M4f,
        jobs: "dsp_ours.c",
        peer: None,
        sources: &[],
        flags: &[],
    },
    Contender {
        name: "CMSIS-DSP",
        machine: Machine::M4f,
        jobs: "dsp_cmsis.c",
        peer: Some("CMSIS-DSP"),
        sources: CMSIS,
        // Without CMSIS-Core, of which no job has need.
        flags: &["-D__GNUC_PYTHON__"],
    },
    Contender {
        name: "CMSIS-DSP, unrolled",
        machine: Machine::M4f,
        jobs: "dsp_cmsis.c",
        peer: Some("CMSIS-DSP"),
        sources: CMSIS,
        flags: &["-D__GNUC_PYTHON__", "-DARM_MATH_LOOPUNROLL"],
    },
    Contender {
        name: "emitted C",
        machine: Machine::A9,
        jobs: "dsp_mpc.c",
        peer: None,
        sources: &[],
        flags: &[],
    },
    Contender {
        name: "Eigen, fixed sizes",
        machine: Machine::A9,
        jobs: "dsp_eigen.cpp",
        peer: Some("TinyMPC"),
        sources: &[],
        flags: &["-DNDEBUG"],
    },
    Contender {
        name: "TinyMPC",
        machine: Machine::A9,
        jobs: "dsp_tinympc.cpp",
        peer: Some("TinyMPC"),
        sources: &["src/tinympc/admm.cpp", "src/tinympc/rho_benchmark.cpp"],
        flags: &["-DNDEBUG"],
    },
];

impl Machine {
    fn toolchain(self) -> Toolchain {
        match self {
            Machine::M4f => toolchain::CORTEX_M4F,
            Machine::A9 => toolchain::ARM,
        }
    }
}

/// Counts and results of a program.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Instructions of each call of each job.
    pub counts: Vec<Vec<u64>>,
    /// Numbers of all calls of each job.
    pub results: Vec<Vec<f32>>,
}

/// Instructions of each function on its longest path, by its name with its type.
pub type Estimates = BTreeMap<String, Option<u64>>;

/// Compiles `bench/dsp/controllers.rs`.
///
/// # Errors
/// The message of the generator or of the system.
pub fn compiled() -> Result<Compiled, String> {
    let failed = |error: std::io::Error| error.to_string();
    let workspace =
        Workspace::with_source(include_str!("../../dsp/controllers.rs")).map_err(failed)?;
    // Functions of `f32` in `f32` alone, as on any processor without doubles; in each package, since cargo builds `bessemer`
    // once.
    let manifest = workspace.path("Cargo.toml");
    let text = std::fs::read_to_string(&manifest).map_err(failed)?;
    let alone = "bessemer = { features = [\"single\"], path = \"dsl\"";
    let text = text.replace("bessemer = { path = \"dsl\"", alone);
    std::fs::write(&manifest, text).map_err(failed)?;
    workspace.compiled()
}

/// Writes the C into `emitted` in a folder; returns its sources.
///
/// # Errors
/// The message of the system.
pub fn written(compiled: &Compiled, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let failed = |error: std::io::Error| error.to_string();
    let folder = folder.join("emitted");
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(failed)?;
    }
    std::fs::create_dir_all(&folder).map_err(failed)?;
    let mut sources = Vec::new();
    for file in &compiled.files {
        let path = folder.join(&file.name);
        std::fs::write(&path, &file.text).map_err(failed)?;
        sources.extend(file.name.ends_with(".c").then_some(path));
    }
    Ok(sources)
}

/// Returns the estimates of the functions.
pub fn estimates(compiled: &Compiled) -> Estimates {
    let explicit = &compiled.explicit;
    let found = explicit.functions.iter().zip(estimate::estimates(explicit));
    let named = found.map(|(function, it)| {
        let name = match function.owner {
            Some(Owner::Struct(id)) => {
                format!("{}::{}", explicit.structs[id.index()].name, function.name)
            }
            _ => function.name.clone(),
        };
        (name, it.cost.map(|cost| cost.instructions))
    });
    named.collect()
}

/// Builds and runs a contender.
///
/// # Errors
/// The message of a tool, or that the program did not run every job.
pub fn run(
    contender: &Contender,
    folder: &Path,
    emitted: &[PathBuf],
    peers: Option<&Path>,
) -> Result<Run, String> {
    let failed = |error: std::io::Error| error.to_string();
    let toolchain = contender.machine.toolchain();
    let own =
        folder.join(format!("{} {:?}", contender.name, contender.machine).replace([' ', ','], "-"));
    std::fs::create_dir_all(&own).map_err(failed)?;
    let c = bessemer_tests::root().join("bench/c");
    let peer = contender.peer.and_then(|peer| Some(peers?.join(peer)));
    let mut sources = vec![c.join("dsp_main.c"), c.join(contender.jobs)];
    sources.extend(watch::start(&toolchain, &own)?);
    let mut includes = vec![own.clone(), c, folder.join("emitted")];
    match &peer {
        None => sources.extend_from_slice(emitted),
        Some(peer) => {
            if contender.jobs == "dsp_tinympc.cpp" {
                in_single_precision(peer, &own)?;
                let of = |source: &&str| own.join(source.trim_start_matches("src/"));
                sources.extend(contender.sources.iter().map(of));
                includes.push(own.join("tinympc"));
            } else {
                sources.extend(contender.sources.iter().map(|source| peer.join(source)));
            }
            let below = ["Include", "PrivateInclude", "include/Eigen"];
            includes.extend(below.iter().map(|name| peer.join(name)));
        }
    }
    let mut objects = Vec::new();
    for (index, source) in sources.iter().enumerate() {
        let object = own.join(format!("{index}.o"));
        let mut command = Command::new(compiler(&toolchain, source));
        command.args(["-O2", "-ffp-contract=off", "-w"]).args(toolchain.machine);
        command.args(standard(source)).args(contender.flags);
        command.args(toolchain.bare.then_some("-DDSP_BARE"));
        for include in &includes {
            command.arg("-I").arg(include);
        }
        execute(command.arg("-c").arg(source).arg("-o").arg(&object))?;
        objects.push(object);
    }
    let program = own.join("program");
    let last = sources.iter().find(|source| is_cpp(source)).unwrap_or(&sources[0]);
    let mut command = Command::new(compiler(&toolchain, last));
    command.arg("-O2").args(toolchain.machine).args(&objects).arg("-o").arg(&program);
    execute(command.arg("-lm"))?;
    let watched = watch::counted(&toolchain, &own, &program, &[])?;
    parts(contender, &watched)
}

/// Splits the counts and words of a program by its jobs. A peer may lack the last jobs.
fn parts(contender: &Contender, watched: &watch::Watched) -> Result<Run, String> {
    let mut counts = watched.counts.iter().copied();
    let mut words = watched.words.iter().map(|word| f32::from_bits(*word as u32));
    let mut run = Run::default();
    for job in JOBS.iter().filter(|job| job.machine == contender.machine) {
        let calls: Vec<u64> = counts.by_ref().take(job.calls).collect();
        let results: Vec<f32> = words.by_ref().take(job.calls * job.numbers).collect();
        if calls.is_empty() && contender.peer.is_some() {
            break;
        }
        if calls.len() < job.calls || results.len() < job.calls * job.numbers {
            return Err(format!("{}: {} did not run", job.name, contender.name));
        }
        run.counts.push(calls);
        run.results.push(results);
    }
    match (counts.next(), words.next()) {
        (None, None) => Ok(run),
        _ => Err(format!("{} ran more than the jobs", contender.name)),
    }
}

/// Copies TinyMPC's sources with single precision as its type of numbers, which is a line of them.
fn in_single_precision(peer: &Path, folder: &Path) -> Result<(), String> {
    let (from, to) = (peer.join("src/tinympc"), folder.join("tinympc"));
    let failed = |error: std::io::Error| format!("`{}`: {error}", from.display());
    std::fs::create_dir_all(&to).map_err(failed)?;
    let mut found = false;
    for entry in std::fs::read_dir(&from).map_err(failed)?.flatten() {
        let text = std::fs::read_to_string(entry.path()).map_err(failed)?;
        found |= text.contains("typedef double tinytype;");
        let text = text.replace("typedef double tinytype;", "typedef float tinytype;");
        std::fs::write(to.join(entry.file_name()), text).map_err(failed)?;
    }
    match found {
        true => Ok(()),
        false => Err(format!("`{}` has no type of numbers to replace", from.display())),
    }
}

fn is_cpp(source: &Path) -> bool {
    source.extension().is_some_and(|extension| extension == "cpp")
}

fn compiler(toolchain: &Toolchain, source: &Path) -> String {
    match is_cpp(source) {
        true => toolchain.compiler.replace("gcc", "g++"),
        false => toolchain.compiler.to_owned(),
    }
}

/// Returns the language's flag; CMSIS-DSP uses GNU's extensions.
fn standard(source: &Path) -> &'static [&'static str] {
    if is_cpp(source) { &["-std=c++17"] } else { &["-std=gnu99"] }
}

/// Returns the first line of a compiler's version.
pub fn first_line(program: &str) -> Option<String> {
    let output = Command::new(program).arg("--version").output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).lines().next()?.to_owned())
}
