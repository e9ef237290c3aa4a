//! Cost of the elementary functions against C libraries. It compares time with glibc on this machine, instructions with
//! glibc and newlib on the emulated Cortex-A9, and code size.
//!
//! Same compiler, same flags, same arguments, in turn within one run. newlib's `libm` is linked under
//! names of its own beside glibc's.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_backend::c;
use bessemer_backend::c::names::Names;
use bessemer_codegen::compile::Compiled;
use bessemer_tests::process::Folder;
use bessemer_tests::toolchain::{CORTEX_A9, run};
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::count;

/// A function, its name in C, and its arguments in the measurement.
struct Subject {
    rust: &'static str,
    c: &'static str,
    x: [f64; 2],
    y: Option<[f64; 2]>,
    /// Number of arguments; the third is equal to the first.
    takes: usize,
}

const fn one(rust: &'static str, c: &'static str, x: [f64; 2]) -> Subject {
    Subject { rust, c, x, y: None, takes: 1 }
}

const fn two(rust: &'static str, c: &'static str, x: [f64; 2], y: [f64; 2]) -> Subject {
    Subject { rust, c, x, y: Some(y), takes: 2 }
}

const fn three(rust: &'static str, c: &'static str, x: [f64; 2], y: [f64; 2]) -> Subject {
    Subject { rust, c, x, y: Some(y), takes: 3 }
}

/// Functions with typical arguments of models: angles of a few turns, exponents of small size.
const SUBJECTS: &[Subject] = &[
    one("sin", "sin", [-10.0, 10.0]),
    one("cos", "cos", [-10.0, 10.0]),
    one("tan", "tan", [-10.0, 10.0]),
    one("asin", "asin", [-1.0, 1.0]),
    one("acos", "acos", [-1.0, 1.0]),
    one("atan", "atan", [-10.0, 10.0]),
    two("atan2", "atan2", [-10.0, 10.0], [-10.0, 10.0]),
    one("exp", "exp", [-10.0, 10.0]),
    one("exp2", "exp2", [-10.0, 10.0]),
    one("exp_m1", "expm1", [-5.0, 5.0]),
    one("ln", "log", [0.01, 100.0]),
    one("log2", "log2", [0.01, 100.0]),
    one("log10", "log10", [0.01, 100.0]),
    one("ln_1p", "log1p", [-0.9, 10.0]),
    one("sinh", "sinh", [-5.0, 5.0]),
    one("cosh", "cosh", [-5.0, 5.0]),
    one("tanh", "tanh", [-5.0, 5.0]),
    two("powf", "pow", [0.01, 100.0], [-10.0, 10.0]),
    one("cbrt", "cbrt", [-100.0, 100.0]),
    two("hypot", "hypot", [-10.0, 10.0], [-10.0, 10.0]),
    three("mul_add", "fma", [-10.0, 10.0], [-10.0, 10.0]),
];

/// Implementations of a function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Form {
    /// In double precision.
    #[default]
    Double,
    /// For `f32`, computed in double precision.
    Single,
    /// For `f32`, computed in single precision alone.
    Alone,
}

impl Form {
    const ALL: [Form; 3] = [Form::Double, Form::Single, Form::Alone];

    fn suffix(self) -> &'static str {
        if self == Form::Double { "" } else { "f" }
    }

    /// Returns the C type of arguments and result.
    fn c_type(self) -> &'static str {
        if self == Form::Double { "double" } else { "float" }
    }

    /// Returns true if `module` has the functions in this form.
    fn is_of(self, module: &str) -> bool {
        module.contains("::math::") && module.contains("::math::narrow") == (self == Form::Alone)
    }
}

/// The measurements of one function in one form.
#[derive(Clone, Debug, Default)]
pub struct Row {
    form: Form,
    /// Name of the function in C, such as `sin` or `sinf`.
    pub name: String,
    /// Our time divided by glibc's on this machine, for each round.
    pub ratios: Vec<f64>,
    /// Median times of ours and of glibc's, ns.
    pub nanoseconds: [f64; 2],
    /// Instructions of a call on the Cortex-A9: ours, glibc's, newlib's.
    pub instructions: [f64; 3],
    /// Bytes of code and tables on the Cortex-A9, callees included: ours, glibc's, newlib's.
    pub bytes: [u64; 3],
}

impl Row {
    /// Returns the median of the ratios.
    pub fn ratio(&self) -> f64 {
        self.ratios.get(self.ratios.len() / 2).copied().unwrap_or(f64::NAN)
    }

    fn json(&self) -> Value {
        let hundredths = |value: f64| (100.0 * value).round() / 100.0;
        let spread = [0, self.ratios.len() / 2, self.ratios.len().saturating_sub(1)];
        json!({
            "function": self.name,
            "host_ratio": spread.map(|index| hundredths(self.ratios[index])),
            "host_nanoseconds": self.nanoseconds.map(hundredths),
            "a9_instructions": self.instructions.map(hundredths),
            "a9_bytes": self.bytes,
        })
    }
}

/// Formats the results for machines.
pub fn json(rows: &[Row]) -> Value {
    let of = |wanted: &dyn Fn(Form) -> bool| -> Vec<Value> {
        rows.iter().filter(|row| wanted(row.form)).map(Row::json).collect()
    };
    json!({
        "command": "cargo xtask bench",
        "host_flags": HOST_FLAGS.join(" "),
        "a9_flags": format!("{} {}", FLAGS.join(" "), CORTEX_A9.join(" ")),
        "host_ratio": "smallest, median, largest of the rounds: ours / glibc's",
        "host_nanoseconds": "ours, glibc",
        "a9_instructions": "a call: ours, glibc, newlib",
        "a9_bytes": "code and tables with callees: ours, glibc, newlib",
        "functions": of(&|form| form != Form::Alone),
        "f32_alone": of(&|form| form == Form::Alone),
    })
}

/// Formats the results for people.
pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "| function | host: ours / glibc | ns, ns | A9 instructions: ours, glibc, newlib | A9 bytes: ours, glibc, newlib |\n\
         |---|---|---|---|---|\n",
    );
    for row in rows {
        let ([ours, theirs], [a, b, c], [d, e, f]) = (row.nanoseconds, row.instructions, row.bytes);
        let _ = writeln!(
            text,
            "| `{}`{} | {:.2} | {ours:.1}, {theirs:.1} | {a:.0}, {b:.0}, {c:.0} | {d}, {e}, {f} |",
            row.name,
            if row.form == Form::Alone { " alone" } else { "" },
            row.ratio()
        );
    }
    text
}

/// Compiler flags for our C and for the libraries' callers.
const FLAGS: &[&str] = &["-O2", "-ffp-contract=off", "-std=gnu99"];
/// Flags of this machine's compiler: glibc selects fused instructions by itself.
const HOST_FLAGS: &[&str] = if cfg!(target_arch = "x86_64") {
    &["-O2", "-ffp-contract=off", "-std=gnu99", "-mfma"]
} else {
    FLAGS
};
/// Flags for the calling program: the compiler must not evaluate calls itself.
const DRIVER_FLAGS: &[&str] = &["-fno-builtin"];
/// newlib's libm for the A9's instruction set.
const NEWLIB: &str = "/usr/lib/arm-none-eabi/newlib/thumb/v7-a+fp/hard/libm.a";

/// Measures all functions in `rounds` rounds.
///
/// # Errors
///
/// The message of a tool.
pub fn measure(rounds: u32) -> Result<Vec<Row>, String> {
    let failed = |error: std::io::Error| error.to_string();
    let emission = emission()?;
    let here = emission.folder();
    let driver = here.join("bench_driver.c");
    fs::write(&driver, include_str!("elementary/driver.c")).map_err(failed)?;
    let headers = emission.headers() + &newlib_prototypes();
    fs::write(here.join("subjects.h"), headers).map_err(failed)?;
    let mut lines = String::new();
    let mut rows = Vec::new();
    for (subject, form) in formats() {
        let ours = emission.of_form(&rust_name(subject, form), form)?;
        let theirs = c_name(subject, form);
        let kind = ["U", "B", "T"][subject.takes - 1];
        let ty = form.c_type();
        let [low, high] = subject.x;
        let ranges = subject.y.map_or(String::new(), |[low, high]| format!(", {low:?}, {high:?}"));
        let _ = writeln!(
            lines,
            "{kind}(\"{theirs}\", {ty}, {ours}, {theirs}, newlib_{theirs}, {low:?}, {high:?}{ranges})"
        );
        rows.push(Row { form, name: rust_name(subject, form), ..Row::default() });
    }
    fs::write(here.join("functions.inc"), lines).map_err(failed)?;

    time(here, emission.sources(), &driver, rounds, &mut rows)?;
    let objects = Objects::new(here, emission.sources())?;
    instructions(here, &objects, &driver, &mut rows)?;
    for ((subject, form), row) in formats().zip(&mut rows) {
        let ours = emission.of_form(&rust_name(subject, form), form)?;
        let theirs = c_name(subject, form);
        row.bytes = [
            objects.bytes(&ours, &[])?,
            objects.bytes(&theirs, &["-lm"])?,
            objects.bytes(&format!("newlib_{theirs}"), &[&objects.newlib])?,
        ];
    }
    Ok(rows)
}

fn formats() -> impl Iterator<Item = (&'static Subject, Form)> {
    let all = Form::ALL.into_iter();
    let all = all.flat_map(|form| SUBJECTS.iter().map(move |subject| (subject, form)));
    // A fused multiply-add has one form on `f32`.
    all.filter(|(subject, form)| *form != Form::Alone || subject.takes < 3)
}

fn rust_name(subject: &Subject, form: Form) -> String {
    format!("{}{}", subject.rust, form.suffix())
}

fn c_name(subject: &Subject, form: Form) -> String {
    format!("{}{}", subject.c, form.suffix())
}

/// A model that calls all functions.
fn model() -> String {
    let mut text = String::from("//! Everything.\n#![no_std]\nuse bessemer::prelude::*;\n");
    for (subject, form) in formats() {
        let (ty, name) = (if form == Form::Double { "f64" } else { "f32" }, subject.rust);
        let called = match (form, subject.takes) {
            (Form::Alone, 1) => format!("bessemer::math::narrow::{name}f(x)"),
            (Form::Alone, _) => format!("bessemer::math::narrow::{name}f(x, y)"),
            (_, takes) => format!("x.{name}({})", ["", "y", "y, x"][takes - 1]),
        };
        let _ = writeln!(
            text,
            "\n/// Calls it.\n#[function]\npub fn call_{name}_{form:?}(x: {ty}, y: {ty}) -> {ty} {{\n    {called} + y\n}}",
        );
    }
    text
}

/// The C of all functions, in a temporary folder.
pub struct Emission {
    compiled: Compiled,
    names: Names,
    folder: Folder,
}

/// Emits the C of all functions.
///
/// # Errors
///
/// The message of a tool or the system.
pub fn emission() -> Result<Emission, String> {
    let workspace = Workspace::with_source(&model()).map_err(|error| error.to_string())?;
    let compiled = workspace.compiled()?;
    let names = Names::new(&compiled.explicit, &c::Options::default());
    let folder = bessemer_tests::process::lay_out(&compiled).map_err(|error| error.to_string())?;
    Ok(Emission { compiled, names, folder })
}

impl Emission {
    /// Returns the folder of the C.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The C files.
    pub fn sources(&self) -> &[PathBuf] {
        self.folder.sources()
    }

    /// Returns the `#include` lines of all headers.
    pub fn headers(&self) -> String {
        let headers = self.compiled.files.iter().filter(|file| file.name.ends_with(".h"));
        headers.map(|file| format!("#include \"{}\"\n", file.name)).collect()
    }

    /// The C name of a function of the DSL's mathematics.
    ///
    /// # Errors
    /// For a function that was not emitted.
    pub fn name(&self, name: &str) -> Result<String, String> {
        self.of_form(name, Form::Double)
    }

    fn of_form(&self, name: &str, form: Form) -> Result<String, String> {
        let functions = self.compiled.explicit.functions.iter();
        let index = functions
            .zip(&self.names.functions)
            .find(|(function, _)| form.is_of(&function.module) && function.name == name);
        index.map(|(_, signature)| signature.name.clone()).ok_or(format!("no `{name}` was emitted"))
    }
}

fn newlib_prototypes() -> String {
    let mut text = String::new();
    for (subject, form) in formats() {
        let ty = form.c_type();
        let arguments = vec![ty; subject.takes].join(", ");
        let _ = writeln!(text, "{ty} newlib_{}({arguments});", c_name(subject, form));
    }
    text
}

fn time(
    here: &Path,
    sources: &[PathBuf],
    driver: &Path,
    rounds: u32,
    rows: &mut [Row],
) -> Result<(), String> {
    let (program, object) = (here.join("bench_host"), here.join("bench_driver.o"));
    let gcc = || {
        let mut command = Command::new("gcc");
        command.args(HOST_FLAGS);
        command
    };
    let rounds = format!("-DROUNDS={rounds}");
    run(gcc().args(DRIVER_FLAGS).arg(rounds).arg("-c").arg(driver).arg("-o").arg(&object))?;
    run(gcc().args(sources).arg(&object).arg("-o").arg(&program).arg("-lm"))?;
    let output = Command::new(&program).output().map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout);
    for (row, line) in rows.iter_mut().zip(text.lines()) {
        let times: Vec<f64> =
            line.split(' ').skip(1).filter_map(|number| number.parse().ok()).collect();
        row.ratios = times.chunks_exact(2).map(|pair| pair[0] / pair[1]).collect();
        row.ratios.sort_by(f64::total_cmp);
        row.nanoseconds = [0, 1].map(|side| {
            let mut one: Vec<f64> = times.iter().skip(side).step_by(2).copied().collect();
            one.sort_by(f64::total_cmp);
            one.get(one.len() / 2).copied().unwrap_or(f64::NAN)
        });
    }
    Ok(())
}

/// Our C and newlib's libm, compiled for the Cortex-A9.
struct Objects {
    folder: PathBuf,
    ours: Vec<PathBuf>,
    newlib: String,
}

impl Objects {
    fn new(here: &Path, sources: &[PathBuf]) -> Result<Objects, String> {
        let newlib = here.join("newlib_libm.a");
        run(Command::new("arm-none-eabi-objcopy")
            .args(["--prefix-symbols=newlib_", NEWLIB])
            .arg(&newlib))?;
        let mut ours = Vec::new();
        for source in sources {
            let object = source.with_extension("o");
            let mut command = target();
            command.args(["-ffunction-sections", "-fdata-sections", "-c"]);
            run(command.arg(source).arg("-o").arg(&object))?;
            ours.push(object);
        }
        let newlib = newlib.display().to_string();
        Ok(Objects { folder: here.to_owned(), ours, newlib })
    }

    /// Size of the code and tables that `name` needs, from our objects or from `library`, bytes.
    fn bytes(&self, name: &str, library: &[&str]) -> Result<u64, String> {
        let program = self.folder.join("bench_bytes");
        let entry =
            format!("-Wl,--gc-sections,--unresolved-symbols=ignore-all,-e,{name},-u,{name}");
        let mut command = target();
        command.args(["-nostdlib", &entry]);
        if library.is_empty() {
            command.args(&self.ours);
        }
        run(command.args(library).arg("-o").arg(&program))?;
        let output = Command::new("arm-linux-gnueabihf-size")
            .arg("-A")
            .arg(&program)
            .output()
            .map_err(|error| error.to_string())?;
        let text = String::from_utf8_lossy(&output.stdout);
        let sections = text.lines().filter_map(|line| {
            let mut words = line.split_whitespace();
            let name = words.next()?;
            let kept = [".text", ".rodata", ".data"].iter().any(|kept| name.starts_with(kept));
            kept.then(|| words.next()?.parse::<u64>().ok()).flatten()
        });
        Ok(sections.sum())
    }
}

fn target() -> Command {
    let mut command = Command::new("arm-linux-gnueabihf-gcc");
    command.args(FLAGS).args(CORTEX_A9);
    // newlib's objects were compiled for another ABI's enums, which none of these functions uses.
    command.arg("-Wl,--no-enum-size-warning");
    command
}

fn instructions(
    here: &Path,
    objects: &Objects,
    driver: &Path,
    rows: &mut [Row],
) -> Result<(), String> {
    const POINTS: f64 = 2048.0;
    let (program, object) = (here.join("bench_target"), here.join("bench_driver_target.o"));
    run(target().args(DRIVER_FLAGS).args(["-DCOUNT", "-c"]).arg(driver).arg("-o").arg(&object))?;
    run(target()
        .arg(&object)
        .args(&objects.ours)
        .arg(&objects.newlib)
        .args(["-lm", "-Wl,--defsym=newlib___aeabi_l2d=__aeabi_l2d", "-o"])
        .arg(&program))?;
    let counts = count::count(&program, here)?;
    for (row, counts) in rows.iter_mut().zip(counts.chunks_exact(4)) {
        let [nothing, ours, glibc, newlib] = [0, 1, 2, 3].map(|index| counts[index] as f64);
        row.instructions = [ours, glibc, newlib].map(|count| (count - nothing) / POINTS);
    }
    Ok(())
}
