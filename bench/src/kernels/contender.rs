//! Who takes part, and how each becomes a program.
//!
//! A program is compiled anew only if its sources or its command changed.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::case::{Case, Routine};
use super::generated;
use super::machine::{Machine, RUST_TARGET};

/// Someone whose C, C++ or Rust is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contender {
    /// Our C.
    Generated,
    /// The handwritten C of the thesis.
    Thesis,
    /// Careful handwritten C.
    Careful,
    /// Loops over constant bounds.
    Naive,
    /// Eigen.
    Eigen,
    /// OpenBLAS, one thread.
    OpenBlas,
    /// The reference LAPACK with the reference BLAS.
    Lapack,
    /// The model itself, nalgebra, as rustc compiles it.
    Native,
}

const LAPACK: &str = "/usr/lib/x86_64-linux-gnu/lapack:/usr/lib/x86_64-linux-gnu/blas";

impl Contender {
    /// As a result names it.
    pub fn name(self) -> &'static str {
        match self {
            Contender::Generated => "generated",
            Contender::Thesis => "thesis",
            Contender::Careful => "careful",
            Contender::Naive => "naive",
            Contender::Eigen => "eigen",
            Contender::OpenBlas => "openblas",
            Contender::Lapack => "lapack",
            Contender::Native => "nalgebra",
        }
    }

    /// As a table names it.
    pub fn title(self) -> &'static str {
        match self {
            Contender::Generated => "generated C",
            Contender::Thesis => "handwritten, as in the thesis",
            Contender::Careful => "handwritten, careful",
            Contender::Naive => "naive C",
            Contender::Eigen => "Eigen",
            Contender::OpenBlas => "OpenBLAS, one thread",
            Contender::Lapack => "reference LAPACK",
            Contender::Native => "nalgebra (the model, by rustc)",
        }
    }

    /// Those of the Chapter 6 job.
    pub fn of_chapter_6(machine: &Machine) -> Vec<Contender> {
        use Contender::{Careful, Eigen, Generated, Lapack, Native, OpenBlas, Thesis};
        match machine.target {
            true => vec![Generated, Thesis, Careful, Eigen, Native],
            false => vec![Generated, Thesis, Careful, Eigen, OpenBlas, Lapack, Native],
        }
    }

    /// Those of the small sizes.
    pub const SMALL: [Contender; 4] =
        [Contender::Generated, Contender::Naive, Contender::Eigen, Contender::Native];

    /// What its process needs around it.
    pub fn environment(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Contender::OpenBlas => &[("OPENBLAS_NUM_THREADS", "1")],
            Contender::Lapack => &[("LD_LIBRARY_PATH", LAPACK)],
            _ => &[],
        }
    }

    /// Builds its program for these cases.
    ///
    /// # Errors
    /// What the compiler said.
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
            (Contender::Generated, _) => sources.extend(generated::write(cases, &folder)?),
            (Contender::Thesis, _) => sources.push(c.join("thesis.c")),
            (Contender::Careful, _) => sources.push(c.join("careful.c")),
            (Contender::OpenBlas | Contender::Lapack, _) => sources.push(c.join("lapack.c")),
            (Contender::Eigen, "chapter6") => sources.push(c.join("eigen_chapter6.cpp")),
            (Contender::Eigen, _) => {
                let text = table("eigen.hpp", cases, eigen, "");
                sources.push(put(&folder, "cases.cpp", &text)?);
            }
            _ => {
                let text = naive(cases);
                sources.push(put(&folder, "cases.c", &text)?);
            }
        }
        link(self, machine, &sources, &folder)
    }
}

/// Compiles the sources, each by itself, and links them with the harness.
fn link(
    contender: Contender,
    machine: &Machine,
    sources: &[PathBuf],
    folder: &Path,
) -> Result<PathBuf, String> {
    let c = bessemer_tests::root().join("bench/c");
    let mut objects = Vec::new();
    let mut fresh = true;
    for source in sources.iter().chain([&c.join("harness.c")]) {
        let cpp = source.extension().is_some_and(|extension| extension == "cpp");
        let stem = source.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let object = folder.join(format!("{stem}.o"));
        let mut command = Command::new(machine.compiler(cpp));
        command.args(machine.flags).arg("-c").arg(source).arg("-o").arg(&object);
        command.arg("-I").arg(&c).arg("-I").arg(folder);
        if !cpp {
            command.arg("-std=c99");
        } else {
            command.args(["-std=c++17", "-DNDEBUG", "-I/usr/include/eigen3"]);
        }
        if contender == Contender::Generated && !stem.starts_with("harness") {
            command.arg("-fstack-usage");
        }
        fresh &= once(&mut command, source, &object)?;
        objects.push(object);
    }
    let program = folder.join("program");
    if fresh && program.exists() {
        return Ok(program);
    }
    let cpp = contender == Contender::Eigen;
    let mut command = Command::new(machine.compiler(cpp));
    command.args(machine.flags).args(&objects).arg("-o").arg(&program);
    match contender {
        Contender::OpenBlas => drop(command.arg("-lopenblas")),
        Contender::Lapack => {
            let folders = LAPACK.split(':').map(|folder| format!("-L{folder}"));
            command.args(folders).args(["-llapack", "-lblas"]);
        }
        _ => {}
    }
    run(command.arg("-lm"))?;
    Ok(program)
}

/// Runs a compiler unless the object is there and was made by the same command of the same text.
fn once(command: &mut Command, source: &Path, object: &Path) -> Result<bool, String> {
    let text = fs::read_to_string(source).map_err(|error| error.to_string())?;
    let c = bessemer_tests::root().join("bench/c");
    let mut headers: Vec<PathBuf> =
        ["case.h", "eigen.hpp", "naive.h"].iter().map(|name| c.join(name)).collect();
    let folder = object.parent().unwrap_or(Path::new("."));
    for entry in fs::read_dir(folder).map_err(|error| error.to_string())?.flatten() {
        headers.extend((entry.path().extension() == Some("h".as_ref())).then(|| entry.path()));
    }
    headers.sort();
    let shared: String = headers.iter().filter_map(|path| fs::read_to_string(path).ok()).collect();
    let stamp = object.with_extension("stamp");
    let key = format!("{command:?}\n{shared}{text}");
    if object.exists() && fs::read_to_string(&stamp).is_ok_and(|known| known == key) {
        return Ok(true);
    }
    run(command)?;
    fs::write(&stamp, key).map_err(|error| error.to_string())?;
    Ok(false)
}

/// The Rust program.
fn native(machine: &Machine) -> Result<PathBuf, String> {
    let root = bessemer_tests::root();
    let folder = root.join(format!("target/bench/native-{}", machine.name));
    let mut command = Command::new("cargo");
    command
        .current_dir(&root)
        .args(["build", "--quiet", "--release", "--package", "native", "--target-dir"])
        .arg(&folder)
        .env("RUSTFLAGS", machine.rust_flags)
        // Only arithmetic on indices would be checked; the peers check nothing.
        .env("CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS", "false");
    let mut program = folder.clone();
    if machine.target {
        command
            .args(["--target", RUST_TARGET])
            .env("CARGO_TARGET_ARMV7_UNKNOWN_LINUX_GNUEABIHF_LINKER", "arm-linux-gnueabihf-gcc");
        program.push(RUST_TARGET);
    }
    run(&mut command)?;
    Ok(program.join("release/native"))
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

/// `double` and nothing, `float` and `f`.
pub fn real(case: &Case) -> (&'static str, &'static str) {
    match case.element {
        super::case::Element::F64 => ("double", ""),
        super::case::Element::F32 => ("float", "f"),
    }
}

/// A source with a function for each case and the list of them.
pub fn table(
    include: &str,
    cases: &[Case],
    function: impl Fn(&Case) -> String,
    before: &str,
) -> String {
    let mut text = format!("#include \"case.h\"\n#include \"{include}\"\n{before}\n");
    let mut list = String::new();
    for case in cases {
        let (name, field) = (case.name(), case.element.name());
        let operand = match case.routine {
            Routine::LuSolve | Routine::CholeskySolve => format!("vector.{field}, "),
            Routine::Product => format!("second.{field}, "),
            Routine::Inverse => String::new(),
        };
        let _ = writeln!(
            text,
            "__attribute__((noinline)) static void case_{name}(void)\n{{\n    \
             {}(matrix.{field}, {operand}result.{field});\n}}\n",
            function(case)
        );
        let single = u8::from(field == "f32");
        let routine = case.routine.name().to_uppercase();
        let _ = writeln!(
            list,
            "    {{\"{name}\", {routine}, {}, {single}, NULL, case_{name}, NULL}},",
            case.size
        );
    }
    let _ = write!(
        text,
        "#ifdef __cplusplus\nextern \"C\" {{\nextern const case_t CASES[];\nextern const size_t CASE_COUNT;\n}}\n#endif\n\
         const case_t CASES[] = {{\n{list}}};\nconst size_t CASE_COUNT = sizeof CASES / sizeof CASES[0];\n"
    );
    text
}

/// Writes a file if its text is new, and gives its path.
pub fn put(folder: &Path, name: &str, text: &str) -> Result<PathBuf, String> {
    let path = folder.join(name);
    if fs::read_to_string(&path).is_ok_and(|known| known == text) {
        return Ok(path);
    }
    fs::write(&path, text).map_err(|error| format!("`{}`: {error}", path.display()))?;
    Ok(path)
}

/// Runs a command; what it said if it failed.
pub fn run(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(format!("{command:?}\n{}", said.lines().take(40).collect::<Vec<_>>().join("\n")))
}
