//! Measures the gain of threads: large kernels on one thread and on two, alternately. Their results must be equal
//! before times are measured.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_backend::c::{self, Options};
use bessemer_backend::passes;
use bessemer_ir::{Float, Kernel, KernelRoutine, Module};
use serde_json::{Value, json};

use crate::check_cost::{hundredths, spread};

const FLAGS: [&str; 4] = ["-std=c99", "-O3", "-march=native", "-ffp-contract=off"];

/// Number of rounds of a program in each of its turns.
const ROUNDS: usize = 11;

/// A kernel's times in µs: the smallest, the median and the largest, on one thread and on two.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the kernel.
    pub name: String,
    /// Times on one thread, µs.
    pub one: [f64; 3],
    /// Times on two threads, µs.
    pub two: [f64; 3],
}

impl Row {
    /// Returns the median on two threads divided by that on one.
    pub fn ratio(&self) -> f64 {
        self.two[1] / self.one[1]
    }
}

/// Measures every program `turns` times.
///
/// # Errors
///
/// A program does not compile or run, or threads change a result.
pub fn measure(turns: usize, mut tick: impl FnMut()) -> Result<Vec<Row>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let sources = write(folder.path())?;
    let one = compile(folder.path(), &sources, "one", &[])?;
    let two = compile(folder.path(), &sources, "two", &["-DBESSEMER_THREADS=2U", "-pthread"])?;
    let mut times: Vec<(String, [Vec<f64>; 2])> = Vec::new();
    for _ in 0..turns {
        let found = [run(&one)?, run(&two)?];
        for (index, (alone, together)) in found[0].iter().zip(&found[1]).enumerate() {
            if alone.result != together.result {
                return Err(format!("{}: two threads change the result", alone.name));
            }
            if times.len() == index {
                times.push((alone.name.clone(), Default::default()));
            }
            times[index].1[0].extend(&alone.times);
            times[index].1[1].extend(&together.times);
        }
        tick();
    }
    let row = |(name, [one, two]): (String, [Vec<f64>; 2])| Row {
        name,
        one: spread(one),
        two: spread(two),
    };
    Ok(times.into_iter().map(row).collect())
}

/// Writes the sources of the kernels and of the program.
fn write(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let kernels = [
        (KernelRoutine::Inverse, vec![100]),
        (KernelRoutine::Inverse, vec![400]),
        (KernelRoutine::Solve, vec![400, 400]),
        (KernelRoutine::Product, vec![400; 3]),
    ];
    let kernels =
        kernels.iter().filter_map(|(routine, dims)| Kernel::new(*routine, Float::F64, dims));
    let functions = kernels.map(|kernel| kernel.function()).collect();
    let module = Module { name: "bench".into(), functions, ..Module::default() };
    let options = Options::default();
    let mut sources = vec![bessemer_tests::root().join("bench/c/threads.c")];
    for file in c::emit(
        &passes::lend(module, &options.kernels, options.layout != c::Layout::Array),
        &options,
    ) {
        let path = folder.join(&file.name);
        std::fs::write(&path, &file.text).map_err(|error| error.to_string())?;
        if file.name.ends_with(".c") {
            sources.push(path);
        }
    }
    Ok(sources)
}

fn compile(
    folder: &Path,
    sources: &[PathBuf],
    name: &str,
    more: &[&str],
) -> Result<PathBuf, String> {
    let program = folder.join(name);
    let mut command = Command::new("gcc");
    command.args(FLAGS).args(more).arg("-I").arg(folder).args(sources).arg("-o").arg(&program);
    let output = command.output().map_err(|error| format!("gcc: {error}"))?;
    match output.status.success() {
        true => Ok(program),
        false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
    }
}

/// Output of a program for a kernel.
struct Found {
    name: String,
    result: String,
    /// Times, µs.
    times: Vec<f64>,
}

fn run(program: &Path) -> Result<Vec<Found>, String> {
    let output = Command::new(program).arg(ROUNDS.to_string()).output();
    let output = output.map_err(|error| format!("`{}`: {error}", program.display()))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let found = |line: &str| {
        let mut words = line.split(' ').map(str::to_owned);
        let (name, result) = (words.next()?, words.next()?);
        let times = words.map(|word| word.parse::<f64>().map(|time| time / 1_000.0));
        Some(Found { name, result, times: times.collect::<Result<_, _>>().ok()? })
    };
    let list: Option<Vec<Found>> = text.lines().map(found).collect();
    list.filter(|_| output.status.success()).ok_or_else(|| "a program of ours failed".to_owned())
}

/// Formats the results for people.
pub fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "kernels on one thread and on two, µs: median (smallest, largest)\n\n{:<14} {:>24} {:>24} {:>6}\n",
        "", "one thread", "two threads", "ratio"
    );
    let cell = |[low, median, high]: [f64; 3]| format!("{median:.1} ({low:.1}, {high:.1})");
    for row in rows {
        let _ = writeln!(
            text,
            "{:<14} {:>24} {:>24} {:>6.2}",
            row.name,
            cell(row.one),
            cell(row.two),
            row.ratio()
        );
    }
    text
}

/// Formats the results for machines.
pub fn json(rows: &[Row]) -> Value {
    let row = |row: &Row| {
        json!({
            "kernel": row.name,
            "one_microseconds": row.one.map(hundredths),
            "two_microseconds": row.two.map(hundredths),
            "ratio": hundredths(row.ratio()),
        })
    };
    json!({
        "command": "cargo xtask bench --only threads",
        "flags": FLAGS.join(" "),
        "cores": std::thread::available_parallelism().map_or(0, usize::from),
        "kernels": rows.iter().map(row).collect::<Vec<_>>(),
    })
}
