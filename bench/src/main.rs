//! `cargo xtask bench`: runs the measurements and writes their results.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use bench::check_cost::{self, Size};
use bench::kernels::reasons::Reasons;
use bench::kernels::results::Results;
use bench::kernels::{machine, plot, report, run, stored};
use bench::{
    accuracy_points, dsp, ekf, elementary, equality, generation, gradient, long, onboard, peers,
    qp, rebuild, shapes, threads, wasm,
};
use clap::{Parser, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};

/// Measures the generated C against its peers, and what the attributes cost; writes bench/results/.
#[derive(Parser)]
#[command(name = "cargo xtask bench")]
struct Arguments {
    /// A short run; nothing is written
    #[arg(long)]
    quick: bool,
    /// Only this one
    #[arg(long)]
    only: Option<Part>,
    /// The small sizes for `kernels`, such as 2,3,4,6,8: Eigen's alone take a compiler many minutes
    #[arg(long, value_delimiter = ',', value_parser = clap::value_parser!(u8).range(2..=20))]
    sizes: Vec<u8>,
    /// Only these machines of `kernels`, such as a9,host-v3: the others keep what was measured before
    #[arg(long, value_delimiter = ',', value_parser = MACHINES, conflicts_with = "sizes")]
    machines: Vec<String>,
    /// Only the instructions of `kernels`, which a busy machine does not disturb; nothing is written
    #[arg(long)]
    counts: bool,
    /// Points of each function for `equality` and `accuracy-points`
    #[arg(long, default_value_t = 10_000_000)]
    points: u32,
    /// Folder with the repositories `CMSIS-DSP`, `TinyMPC` and `w2c2`, the last one built, for `dsp`, `qp` and `wasm`
    #[arg(long)]
    peers: Option<PathBuf>,
}

/// The measurements.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// The generated linear algebra against handwritten C, libraries and nalgebra
    Kernels,
    /// The elementary functions against glibc and newlib
    Elementary,
    /// Cost of the attributes in a check of a model
    CheckCost,
    /// Cost of the attributes in a rebuild of the corpus
    Rebuild,
    /// Duration of a generation, by number of functions
    Generation,
    /// Duration of the generation of one long function, by number of operations
    Long,
    /// Growth of the tool's own time with the size of a function, by shape
    Shapes,
    /// Instructions of a control period of the onboard software on the Cortex-A9
    Onboard,
    /// Blocks, filters and predictive control beside CMSIS-DSP, Eigen and TinyMPC
    Dsp,
    /// A Kalman filter beside code of SymForce and CasADi, which pip installs
    Ekf,
    /// An autopilot's filter beside code of SymForce, which pip installs
    Autopilot,
    /// The gradient of a rollout beside code of CasADi, which pip installs
    Gradient,
    /// Quadratic programs beside code of OSQP and CVXPYgen, which pip installs, and TinyMPC
    Qp,
    /// The models by wasm2c and w2c2, of WebAssembly, beside their emitted C
    Wasm,
    /// Large kernels on one thread and on two
    Threads,
    /// The elementary functions on ten million points each, on every leg: a quarter of an hour
    Equality,
    /// Equality at the points of the accuracy measurement
    AccuracyPoints,
}

/// The machines' names.
const MACHINES: [&str; machine::ALL.len()] = {
    let mut names = [""; machine::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = machine::ALL[at].name;
        at += 1;
    }
    names
};

/// Name in the results of the command for cases that were measured later.
const AGAIN: &str = "measured again";

/// A measurement: prints its table and, unless it is a short run, writes its results.
type Measurement = fn(&Arguments) -> Result<(), String>;

const PARTS: [(Part, Measurement); 17] = [
    (Part::Kernels, kernels),
    (Part::Elementary, elementary),
    (Part::CheckCost, check_cost),
    (Part::Rebuild, rebuild),
    (Part::Generation, generation),
    (Part::Long, long),
    (Part::Shapes, of_shapes),
    (Part::Onboard, onboard),
    (Part::Dsp, of_dsp),
    (Part::Ekf, of_ekf),
    (Part::Autopilot, of_autopilot),
    (Part::Gradient, of_gradient),
    (Part::Qp, of_qp),
    (Part::Wasm, of_wasm),
    (Part::Threads, on_threads),
    (Part::Equality, equality),
    (Part::AccuracyPoints, on_accuracy_points),
];

impl Arguments {
    fn wants(&self, part: Part) -> bool {
        match self.only {
            Some(only) => only == part,
            // The short run has a minute for everything; these only for those who ask.
            None if self.quick => part == Part::Kernels,
            None => part != Part::Equality && part != Part::AccuracyPoints,
        }
    }

    /// Writes the results of a long run.
    fn write(&self, name: &str, json: &Value) -> Result<(), String> {
        if self.quick { Ok(()) } else { put(&format!("{name}.json"), &format!("{json:#}\n")) }
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    for (_, measure) in PARTS.iter().filter(|(part, _)| arguments.wants(*part)) {
        if let Err(error) = measure(&arguments) {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn kernels(arguments: &Arguments) -> Result<(), String> {
    let reasons = Reasons::committed()?;
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed:.dim} {wide_msg}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    let plain = bar.is_hidden();
    let say = |line: &str| {
        bar.set_message(line.to_owned());
        // Off a terminal, a line for each step but the many cases.
        if plain && !line.contains("timing") {
            eprintln!("{line}");
        }
    };
    let mut plan = if arguments.quick { run::QUICK } else { run::FULL };
    plan.counts = arguments.counts;
    let sizes: Vec<usize> = arguments.sizes.iter().copied().map(usize::from).collect();
    if !sizes.is_empty() {
        plan.sizes = &sizes;
    }
    plan.machines = &arguments.machines;
    let results = run::run(&plan, &say)?;
    bar.finish_and_clear();
    print!("{}", report::terminal(&results, &reasons));
    let about = about(&sizes);
    match (arguments.quick || arguments.counts, arguments.machines.is_empty()) {
        (true, _) => Ok(()),
        (false, true) => report_kernels(&results, &about, &reasons),
        (false, false) => renew_kernels(results, about, &reasons, &arguments.machines),
    }
}

/// Replaces the results of some machines by those of this run, which must have used the same tools.
fn renew_kernels(
    again: Results,
    mut about: BTreeMap<&'static str, String>,
    reasons: &Reasons,
    machines: &[String],
) -> Result<(), String> {
    let path = bessemer_tests::root().join("bench/results/kernels.json");
    let text =
        std::fs::read_to_string(&path).map_err(|error| format!("`{}`: {error}", path.display()))?;
    let json: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let mut results = Results::from_json(&json).ok_or("the results cannot be read again")?;
    for (name, version) in about.iter().filter(|(name, _)| **name != "command") {
        let before = json["about"][*name].as_str();
        if before != Some(version) {
            return Err(format!(
                "`{}` was made with another {name}, {}: measure all machines again",
                path.display(),
                before.unwrap_or("none")
            ));
        }
    }
    results.renew(again);
    let command = about.get("command").cloned().unwrap_or_default();
    let before = json["about"][AGAIN].as_str().unwrap_or_default();
    let before: Vec<&str> = before.rsplit(' ').next().unwrap_or_default().split(',').collect();
    let again = |name: &&str| before.contains(name) || machines.iter().any(|it| it == name);
    let names: Vec<&str> = MACHINES.into_iter().filter(again).collect();
    about.insert(AGAIN, format!("{command} --machines {}", names.join(",")));
    report_kernels(&results, &about, reasons)
}

fn report_kernels(
    results: &Results,
    about: &BTreeMap<&'static str, String>,
    reasons: &Reasons,
) -> Result<(), String> {
    let json = results.json(&json!(about));
    put("kernels.json", &stored::text(&json))?;
    // By what the JSON says, so that a later report of it is the same.
    let results = Results::from_json(&json).ok_or("the results cannot be read again")?;
    put("kernels.md", &report::markdown(&results, &json["about"], reasons))?;
    put("chapter6.svg", &plot::chapter_6(&results))?;
    put("small.svg", &plot::small(&results))
}

/// Returns the versions of the compilers.
fn about(sizes: &[usize]) -> BTreeMap<&'static str, String> {
    let first = |program: &str| {
        let output = Command::new(program).arg("--version").output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).lines().next()?.to_owned())
    };
    let mut command = "cargo xtask bench --only kernels".to_owned();
    if !sizes.is_empty() {
        let sizes: Vec<String> = sizes.iter().map(usize::to_string).collect();
        command += &format!(" --sizes {}", sizes.join(","));
    }
    let mut about = BTreeMap::from([("command", command)]);
    let tools = [
        ("gcc", "gcc"),
        ("ARM gcc", "arm-linux-gnueabihf-gcc"),
        ("rustc", "rustc"),
        ("QEMU", "qemu-arm"),
        ("valgrind", "valgrind"),
    ];
    for (name, program) in tools {
        about.extend(first(program).map(|version| (name, version)));
    }
    about
}

fn check_cost(arguments: &Arguments) -> Result<(), String> {
    let size = Size { functions: 200, runs: if arguments.quick { 3 } else { 15 } };
    let bar = ProgressBar::new(2 * size.runs as u64).with_message("cargo check");
    let cost = check_cost::measure(size, || bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", cost.table());
    arguments.write("check-cost", &cost.json())
}

fn rebuild(arguments: &Arguments) -> Result<(), String> {
    let runs = if arguments.quick { 1 } else { 5 };
    let bar = ProgressBar::new(3 * runs as u64).with_message("cargo build");
    let cost = rebuild::measure(runs, || bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", cost.table());
    arguments.write("rebuild", &cost.json())
}

fn generation(arguments: &Arguments) -> Result<(), String> {
    let bar = ProgressBar::new(4).with_message("generating");
    let found = generation::measure(if arguments.quick { 1 } else { 5 }, || bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", found.table());
    arguments.write("generation", &found.json())
}

fn long(arguments: &Arguments) -> Result<(), String> {
    let runs = if arguments.quick { 1 } else { 5 };
    let bar = ProgressBar::new((long::SIZES.len() * runs) as u64).with_message("generating");
    let found = long::measure(runs, || bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", found.table());
    arguments.write("long", &found.json())
}

fn of_shapes(arguments: &Arguments) -> Result<(), String> {
    let bar = ProgressBar::new(shapes::SHAPES.len() as u64).with_message("compiling");
    let found = shapes::measure(|| bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", shapes::table(&found));
    arguments.write("shapes", &shapes::results(&found))
}

fn elementary(arguments: &Arguments) -> Result<(), String> {
    let rows = elementary::measure(if arguments.quick { 31 } else { 301 })?;
    println!("{}", elementary::table(&rows));
    arguments.write("elementary", &elementary::json(&rows))
}

fn onboard(arguments: &Arguments) -> Result<(), String> {
    let rows = onboard::measure(if arguments.quick { 2.0 } else { f64::INFINITY })?;
    println!("{}", onboard::table(&rows));
    arguments.write("onboard", &onboard::json(&rows))
}

fn of_dsp(arguments: &Arguments) -> Result<(), String> {
    let found = dsp::measure(arguments.peers.as_deref())?;
    let json = dsp::json(&found);
    let page = dsp::page::markdown(&json);
    println!("{page}");
    if arguments.peers.is_none() {
        eprintln!("nothing is written without `--peers FOLDER`");
        return Ok(());
    }
    arguments.write("dsp", &json)?;
    if arguments.quick { Ok(()) } else { put("dsp.md", &page) }
}

fn of_gradient(arguments: &Arguments) -> Result<(), String> {
    let json = peers::json(&gradient::ROLLOUT, &peers::measure(&gradient::ROLLOUT)?);
    let page = gradient::markdown(&json);
    println!("{page}");
    arguments.write("gradient", &json)?;
    if arguments.quick { Ok(()) } else { put("gradient.md", &page) }
}

fn of_autopilot(arguments: &Arguments) -> Result<(), String> {
    let json = peers::json(&ekf::AUTOPILOT, &peers::measure(&ekf::AUTOPILOT)?);
    let page = ekf::page::of_autopilot(&json);
    println!("{page}");
    arguments.write("autopilot", &json)?;
    if arguments.quick { Ok(()) } else { put("autopilot.md", &page) }
}

fn of_ekf(arguments: &Arguments) -> Result<(), String> {
    let json = peers::json(&ekf::FILTER, &peers::measure(&ekf::FILTER)?);
    let page = ekf::page::markdown(&json);
    println!("{page}");
    arguments.write("ekf", &json)?;
    if arguments.quick { Ok(()) } else { put("ekf.md", &page) }
}

fn of_qp(arguments: &Arguments) -> Result<(), String> {
    let json = qp::json(&qp::measure(arguments.peers.as_deref())?);
    let page = qp::page::markdown(&json);
    println!("{page}");
    if arguments.peers.is_none() {
        eprintln!("nothing is written without `--peers FOLDER`");
        return Ok(());
    }
    arguments.write("qp", &json)?;
    if arguments.quick { Ok(()) } else { put("qp.md", &page) }
}

fn of_wasm(arguments: &Arguments) -> Result<(), String> {
    let longest = if arguments.quick { 2.0 } else { f64::INFINITY };
    let rows = wasm::measure(longest, arguments.peers.as_deref())?;
    println!("{}", wasm::table(&rows));
    if arguments.peers.is_none() {
        eprintln!("nothing is written without `--peers FOLDER`");
        return Ok(());
    }
    arguments.write("wasm", &wasm::json(&rows))
}

fn on_threads(arguments: &Arguments) -> Result<(), String> {
    let turns = if arguments.quick { 2 } else { 31 };
    let bar = ProgressBar::new(turns as u64).with_message("threads");
    let rows = threads::measure(turns, || bar.inc(1))?;
    bar.finish_and_clear();
    println!("{}", threads::table(&rows));
    arguments.write("threads", &threads::json(&rows))
}

fn equality(arguments: &Arguments) -> Result<(), String> {
    let calls = if arguments.quick { 100 } else { arguments.points.div_ceil(1_000) };
    let legs = equality::measure(calls)?;
    println!("{}", equality::table(&legs));
    if let Some(leg) = legs.iter().find(|leg| leg.parted.is_some()) {
        return Err(format!("{} differs from the Rust", leg.name));
    }
    arguments.write("equality", &equality::json(&legs, calls))
}

fn on_accuracy_points(arguments: &Arguments) -> Result<(), String> {
    let count = if arguments.quick { 100_000 } else { u64::from(arguments.points) };
    let legs = accuracy_points::measure(count)?;
    println!("{}", accuracy_points::table(&legs));
    if let Some(leg) = legs.iter().find(|leg| leg.folded != legs[0].folded) {
        return Err(format!("{} differs from the Rust", leg.name));
    }
    arguments.write("accuracy_points", &accuracy_points::json(&legs, count))
}

fn put(name: &str, text: &str) -> Result<(), String> {
    let folder = bessemer_tests::root().join("bench/results");
    put_into(&folder, name, text)
        .map_err(|error| format!("`{}`: {error}", folder.join(name).display()))
}

fn put_into(folder: &Path, name: &str, text: &str) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join(name), text)
}
