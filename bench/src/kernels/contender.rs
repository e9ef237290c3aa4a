//! The contenders, and how the program of each is built.
//!
//! A program is recompiled only if its sources or its command changed.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use bessemer_backend::kernels::{Mode, Tuning};

use super::case::{Case, Routine};
use super::generated;
use super::machine::{Machine, RUST_TARGET};

/// A contender: code in C, C++ or Rust that is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contender {
    /// The generated C.
    Generated,
    /// The generated C in the fast mode.
    Fast,
    /// The handwritten C of the thesis.
    Thesis,
    /// Optimised handwritten C.
    Careful,
    /// Simple loops with constant bounds.
    Naive,
    /// The C++ library Eigen.
    Eigen,
    /// OpenBLAS with one thread.
    OpenBlas,
    /// The reference LAPACK with the reference BLAS.
    Lapack,
    /// The model itself with nalgebra, compiled by rustc.
    Native,
}

const LAPACK: &str = "/usr/lib/x86_64-linux-gnu/lapack:/usr/lib/x86_64-linux-gnu/blas";

impl Contender {
    /// Returns the name in results.
    pub fn name(self) -> &'static str {
        match self {
            Contender::Generated => "generated",
            Contender::Fast => "fast",
            Contender::Thesis => "thesis",
            Contender::Careful => "careful",
            Contender::Naive => "naive",
            Contender::Eigen => "eigen",
            Contender::OpenBlas => "openblas",
            Contender::Lapack => "lapack",
            Contender::Native => "nalgebra",
        }
    }

    /// Returns the title in tables.
    pub fn title(self) -> &'static str {
        match self {
            Contender::Generated => "generated C",
            Contender::Fast => "generated C, fast mode",
            Contender::Thesis => "handwritten, as in the thesis",
            Contender::Careful => "handwritten, careful",
            Contender::Naive => "naive C",
            Contender::Eigen => "Eigen",
            Contender::OpenBlas => "OpenBLAS, one thread",
            Contender::Lapack => "reference LAPACK",
            Contender::Native => "nalgebra (the model, by rustc)",
        }
    }

    /// Returns the contenders for the computation of Chapter 6.
    pub fn of_chapter_6(machine: &Machine) -> Vec<Contender> {
        use Contender::{Careful, Eigen, Fast, Generated, Lapack, Native, OpenBlas, Thesis};
        match machine.target {
            true => vec![Generated, Thesis, Careful, Eigen, Native],
            false => vec![Generated, Fast, Thesis, Careful, Eigen, OpenBlas, Lapack, Native],
        }
    }

    /// Contenders for the small sizes.
    pub const SMALL: [Contender; 4] =
        [Contender::Generated, Contender::Naive, Contender::Eigen, Contender::Native];

    /// Returns the environment variables that its process needs.
    pub fn environment(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Contender::OpenBlas => &[("OPENBLAS_NUM_THREADS", "1")],
            Contender::Lapack => &[("LD_LIBRARY_PATH", LAPACK)],
            _ => &[],
        }
    }

    /// Builds the program of a contender for these cases.
    ///
    /// # Errors
    ///
    /// The compiler's message.
    pub fn build(
        self,
        machine: &Machine,
        cases: &[Case],
        folder: &Path,
    ) -> Result<PathBuf, String> {
        if self == Contender::Native {
            return native(machine);
        }
        let kind = if cases.iter().any(|case| case.size > 20) { "chapter6" } else { "small" };
        let folder = folder.join(format!("{}-{}-{kind}", machine.name, self.name()));
        fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
        let c = bessemer_tests::root().join("bench/c");
        let mut sources: Vec<PathBuf> = Vec::new();
        match (self, kind) {
            (Contender::Generated, _) => {
                sources.extend(generated::write(cases, &folder, Tuning::default())?);
            }
            (Contender::Fast, _) => {
                let tuning = Tuning { mode: Mode::Fast, ..Tuning::default() };
                sources.extend(generated::write(cases, &folder, tuning)?);
            }
            (Contender::Thesis, _) => sources.push(c.join("thesis.c")),
            (Contender::Careful, _) => sources.push(c.join("careful.c")),
            (Contender::OpenBlas | Contender::Lapack, _) => sources.push(c.join("lapack.c")),
            (Contender::Eigen, "chapter6") => sources.push(c.join("eigen_chapter6.cpp")),
            (Contender::Eigen, _) => {
                // A source for each size: they compile side by side, and one of another run serves again.
                let of = |size: usize| cases.iter().copied().filter(move |case| case.size == size);
                let sizes: BTreeSet<usize> = cases.iter().map(|case| case.size).collect();
                for size in sizes {
                    let cases: Vec<Case> = of(size).collect();
                    let text = functions("eigen.hpp", &cases, eigen, "extern \"C\"");
                    sources.push(put(&folder, &format!("cases_{size}.cpp"), &text)?);
                }
                sources.push(put(&folder, "cases.c", &list(cases))?);
            }
            _ => {
                let text = naive(cases);
                sources.push(put(&folder, "cases.c", &text)?);
            }
        }
        link(self, machine, &sources, &folder)
    }
}

/// Compiles the sources in parallel, one process for each processor, and links them with the harness.
fn link(
    contender: Contender,
    machine: &Machine,
    sources: &[PathBuf],
    folder: &Path,
) -> Result<PathBuf, String> {
    let harness = bessemer_tests::root().join("bench/c/harness.c");
    let sources: Vec<&PathBuf> = sources.iter().chain([&harness]).collect();
    let shared = shared(folder)?;
    let next = AtomicUsize::new(0);
    let compile = || {
        let mut done = Vec::new();
        while let Some(source) = sources.get(next.fetch_add(1, Ordering::Relaxed)) {
            done.push(object(contender, machine, source, folder, &shared)?);
        }
        Ok::<_, String>(done)
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let compiled: Vec<Result<Vec<(PathBuf, bool)>, String>> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(compile)).collect();
        let join = |worker: std::thread::ScopedJoinHandle<'_, _>| {
            worker.join().unwrap_or_else(|_| Err("a compiling thread ended".into()))
        };
        workers.into_iter().map(join).collect()
    });
    let mut objects = Vec::new();
    for list in compiled {
        objects.extend(list?);
    }
    objects.sort();
    let fresh = objects.iter().all(|(_, fresh)| *fresh);
    let program = folder.join("program");
    let linked = folder.join("program.objects");
    let list = format!("{objects:?}").replace("false", "true");
    if fresh && program.exists() && fs::read_to_string(&linked).is_ok_and(|known| known == list) {
        return Ok(program);
    }
    let mut command = Command::new(machine.compiler(contender == Contender::Eigen));
    command.args(machine.flags).args(objects.iter().map(|(object, _)| object));
    command.arg("-o").arg(&program);
    match contender {
        Contender::OpenBlas => drop(command.arg("-lopenblas")),
        Contender::Lapack => {
            let folders = LAPACK.split(':').map(|folder| format!("-L{folder}"));
            command.args(folders).args(["-llapack", "-lblas"]);
        }
        _ => {}
    }
    run(command.arg("-lm"))?;
    fs::write(&linked, list).map_err(|error| error.to_string())?;
    Ok(program)
}

/// Compiles a source; returns its object, and whether it was reused.
fn object(
    contender: Contender,
    machine: &Machine,
    source: &Path,
    folder: &Path,
    shared: &str,
) -> Result<(PathBuf, bool), String> {
    let cpp = source.extension().is_some_and(|extension| extension == "cpp");
    let stem = source.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let object = folder.join(format!("{stem}.o"));
    let mut command = Command::new(machine.compiler(cpp));
    command.args(machine.flags).arg("-c").arg(source).arg("-o").arg(&object);
    command.arg("-I").arg(bessemer_tests::root().join("bench/c")).arg("-I").arg(folder);
    match cpp {
        false => command.arg("-std=c99"),
        true => command.args(["-std=c++17", "-DNDEBUG", "-w", "-I/usr/include/eigen3"]),
    };
    if contender == Contender::Generated && !stem.starts_with("harness") {
        command.arg("-fstack-usage");
    }
    let fresh = once(&mut command, source, &object, shared)?;
    Ok((object, fresh))
}

/// Returns the text of all headers that a source of this folder may include.
fn shared(folder: &Path) -> Result<String, String> {
    let c = bessemer_tests::root().join("bench/c");
    let mut headers: Vec<PathBuf> =
        ["case.h", "eigen.hpp", "naive.h"].iter().map(|name| c.join(name)).collect();
    for entry in fs::read_dir(folder).map_err(|error| error.to_string())?.flatten() {
        headers.extend((entry.path().extension() == Some("h".as_ref())).then(|| entry.path()));
    }
    headers.sort();
    Ok(headers.iter().filter_map(|path| fs::read_to_string(path).ok()).collect())
}

/// Runs a compiler unless an object exists that was built by the same command from the same text.
fn once(command: &mut Command, source: &Path, object: &Path, shared: &str) -> Result<bool, String> {
    let text = fs::read_to_string(source).map_err(|error| error.to_string())?;
    let stamp = object.with_extension("stamp");
    let key = format!("{command:?}\n{shared}{text}");
    if object.exists() && fs::read_to_string(&stamp).is_ok_and(|known| known == key) {
        return Ok(true);
    }
    run(command)?;
    fs::write(&stamp, key).map_err(|error| error.to_string())?;
    Ok(false)
}

/// Builds the program with the model itself.
fn native(machine: &Machine) -> Result<PathBuf, String> {
    let root = bessemer_tests::root();
    let folder = root.join(format!("target/bench/native-{}", machine.name));
    let mut command = Command::new("cargo");
    command
        .current_dir(&root)
        .args(["build", "--quiet", "--profile", "fast", "--package", "native", "--target-dir"])
        .arg(&folder)
        .env("RUSTFLAGS", machine.rust_flags)
        // Only arithmetic on indices would be checked; the peers check nothing.
        .env("CARGO_PROFILE_FAST_OVERFLOW_CHECKS", "false");
    let mut program = folder.clone();
    if machine.target {
        command
            .args(["--target", RUST_TARGET])
            .env("CARGO_TARGET_ARMV7_UNKNOWN_LINUX_GNUEABIHF_LINKER", "arm-linux-gnueabihf-gcc");
        program.push(RUST_TARGET);
    }
    run(&mut command)?;
    Ok(program.join("fast/native"))
}

fn naive(cases: &[Case]) -> String {
    let mut text = String::from("#include <math.h>\n\n");
    let mut known = Vec::new();
    for case in cases {
        let key = (case.element, case.size);
        if !known.contains(&key) {
            known.push(key);
            let (real, suffix) = real(case);
            let _ = writeln!(
                text,
                "#define N {n}\n#define REAL {real}\n#define SQRT sqrt{suffix}\n#define ABS fabs{suffix}\n\
                 #define NAME(routine) routine##_{element}_{n}\n#include \"naive.h\"\n\
                 #undef N\n#undef REAL\n#undef SQRT\n#undef ABS\n#undef NAME\n",
                n = case.size,
                element = case.element.name(),
            );
        }
    }
    table("case.h", cases, |case| case.name(), &text)
}

fn eigen(case: &Case) -> String {
    format!("Small<{}, {}>::{}", real(case).0, case.size, case.routine.name())
}

/// Returns the C type, and the suffix of C functions for it: `double` and nothing, or `float` and `f`.
pub fn real(case: &Case) -> (&'static str, &'static str) {
    match case.element {
        super::case::Element::F64 => ("double", ""),
        super::case::Element::F32 => ("float", "f"),
    }
}

/// Returns a source with a function for each case, and their table.
pub fn table(
    include: &str,
    cases: &[Case],
    function: impl Fn(&Case) -> String,
    before: &str,
) -> String {
    let head = format!("#include \"case.h\"\n{before}\n");
    head + &functions(include, cases, function, "") + &list(cases)
}

/// Returns the functions of the cases with this linkage.
fn functions(
    include: &str,
    cases: &[Case],
    function: impl Fn(&Case) -> String,
    linkage: &str,
) -> String {
    let mut text = format!("#include \"{include}\"\n\n");
    for case in cases {
        let (name, field) = (case.name(), case.element.name());
        let operand = match case.routine {
            Routine::LuSolve | Routine::CholeskySolve => format!("vector.{field}, "),
            Routine::Product => format!("second.{field}, "),
            Routine::Inverse => String::new(),
        };
        let _ = writeln!(
            text,
            "{linkage} void case_{name}(void);\n{linkage} __attribute__((noinline)) void case_{name}(void)\n{{\n    \
             {}(matrix.{field}, {operand}result.{field});\n}}\n",
            function(case)
        );
    }
    text
}

/// Returns the table of the cases, whose functions may be in another source.
fn list(cases: &[Case]) -> String {
    let mut text = String::from("#include \"case.h\"\n\n");
    let mut entries = String::new();
    for case in cases {
        let name = case.name();
        let single = u8::from(case.element.name() == "f32");
        let routine = case.routine.name().to_uppercase();
        let _ = writeln!(text, "void case_{name}(void);");
        let _ = writeln!(
            entries,
            "    {{\"{name}\", {routine}, {}, {single}, NULL, case_{name}, NULL}},",
            case.size
        );
    }
    text + &format!(
        "const case_t CASES[] = {{\n{entries}}};\nconst size_t CASE_COUNT = sizeof CASES / sizeof CASES[0];\n"
    )
}

/// Writes a file if its text changed; returns its path.
pub fn put(folder: &Path, name: &str, text: &str) -> Result<PathBuf, String> {
    let path = folder.join(name);
    if fs::read_to_string(&path).is_ok_and(|known| known == text) {
        return Ok(path);
    }
    fs::write(&path, text).map_err(|error| format!("`{}`: {error}", path.display()))?;
    Ok(path)
}

/// Runs a command; the error is its output.
pub fn run(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(format!("{command:?}\n{}", said.lines().take(40).collect::<Vec<_>>().join("\n")))
}
