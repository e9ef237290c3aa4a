//! The tools that the commands need: which, what for, whether they work here, and where they come from.
//!
//! Invariants:
//! - a tool counts as there only if it ran: rustup leaves a `rustfmt` on the path that only says that it is absent,
//!   and Debian's compilers come without the headers of the C library;
//! - nothing here changes the machine.
//!
//! What it must not know: how something is installed (`install`), how it is shown (`doctor`).

use crate::project;
use bessemer_tools::{self as programs, Program};
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The commands that need the tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Need {
    /// All commands, including `gen`.
    Everything,
    /// `test`, with and without `--host`.
    Host,
    /// `test` without `--host`: tools for the emulated target.
    Target,
    /// `test` without `--host`: analysers of the emitted C.
    Analysis,
    /// `test --full`, in addition to the tools of `test`: further emulated machines.
    Full,
    /// `bench`, in addition to the tools of `test`: other contenders, and instruction counters.
    Bench,
}

impl Need {
    /// Returns the text for users.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Everything => "everything",
            Self::Host => "test",
            Self::Target | Self::Analysis => "test (not --host)",
            Self::Full => "test --full",
            Self::Bench => "bench",
        }
    }
}

/// Detection of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Probe {
    /// The program answers `--version`.
    Version(&'static str),
    /// The compiler finds the C library's headers.
    Headers(&'static str),
    /// The compiler comes with the libraries that its sanitizers link.
    Sanitizers(&'static str),
    /// The file exists.
    File(&'static str),
    /// The system's Python finds the module.
    Module(&'static str),
    /// The environment below `target` has the module in the pinned version.
    Environment {
        /// Name of the module for `import`.
        module: &'static str,
        /// Requirement for pip: `name==version`.
        requirement: &'static str,
    },
}

/// Source of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// Rust itself, without which this program would not run.
    Rust,
    /// A component of the Rust toolchain, by rustup.
    Component(&'static str),
    /// A Debian package.
    Package(&'static str),
    /// A Python package, in the project's own environment: [`python`].
    Python(&'static str),
}

/// A tool.
#[derive(Debug, PartialEq, Eq)]
pub struct Tool {
    /// Name of the tool for users.
    pub name: &'static str,
    /// Purpose of the tool.
    pub purpose: &'static str,
    /// The commands that need it.
    pub need: Need,
    /// Detection of the tool.
    pub probe: Probe,
    /// Source of the tool.
    pub source: Source,
}

/// Describes a program from Debian, by its first package.
const fn program(program: Program, purpose: &'static str, need: Need) -> Tool {
    let source = Source::Package(program.packages[0]);
    Tool { name: program.name, purpose, need, probe: Probe::Version(program.name), source }
}

/// Describes the headers that a compiler needs, by its second package.
const fn headers(name: &'static str, compiler: Program, need: Need) -> Tool {
    let source = Source::Package(compiler.packages[1]);
    let purpose = "headers and libraries for the above";
    Tool { name, purpose, need, probe: Probe::Headers(compiler.name), source }
}

/// Describes a Python package of a pinned version.
const fn package(
    name: &'static str,
    purpose: &'static str,
    need: Need,
    module: &'static str,
    requirement: &'static str,
) -> Tool {
    let probe = Probe::Environment { module, requirement };
    Tool { name, purpose, need, probe, source: Source::Python(requirement) }
}

/// Every tool that a command needs, in the order of the list.
pub const TOOLS: &[Tool] = &[
    Tool {
        name: "rustc",
        purpose: "builds the models and these commands",
        need: Need::Everything,
        probe: Probe::Version("rustc"),
        source: Source::Rust,
    },
    Tool {
        name: "rustfmt",
        purpose: "checks the format of the Rust",
        need: Need::Host,
        probe: Probe::Version("rustfmt"),
        source: Source::Component("rustfmt"),
    },
    Tool {
        name: "clippy",
        purpose: "lints the Rust",
        need: Need::Host,
        probe: Probe::Version("cargo-clippy"),
        source: Source::Component("clippy"),
    },
    program(programs::GCC, "compiles the emitted C", Need::Host),
    Tool {
        name: "g++",
        purpose: "compiles the emitted headers as C++",
        need: Need::Host,
        probe: Probe::Version("g++"),
        source: Source::Package("g++"),
    },
    program(programs::CLANG, "compiles the emitted C a second time", Need::Host),
    Tool {
        name: "clang's run time",
        purpose: "the libraries of its sanitizers",
        need: Need::Host,
        probe: Probe::Sanitizers("clang"),
        source: Source::Package("libclang-rt-dev"),
    },
    headers("C library", programs::GCC, Need::Host),
    program(programs::ARM_LINUX_GCC, "compiles the emitted C for a Cortex-A9", Need::Target),
    headers("ARM C library", programs::ARM_LINUX_GCC, Need::Target),
    program(programs::QEMU_ARM, "runs it on an emulated Cortex-A9", Need::Target),
    Tool {
        name: "arm-linux-gnueabihf-g++",
        purpose: "compiles C++ around the emitted C, and Eigen, for a Cortex-A9",
        need: Need::Target,
        probe: Probe::Version("arm-linux-gnueabihf-g++"),
        source: Source::Package("g++-arm-linux-gnueabihf"),
    },
    program(programs::ARM_BARE_GCC, "compiles firmware around the emitted C", Need::Target),
    headers("newlib", programs::ARM_BARE_GCC, Need::Target),
    program(
        programs::QEMU_SYSTEM_ARM,
        "runs it on an emulated Zynq, without an operating system",
        Need::Target,
    ),
    program(programs::MAKE, "builds the emitted C by its Makefile", Need::Target),
    program(programs::CMAKE, "builds the emitted C by its CMakeLists.txt", Need::Target),
    Tool {
        name: "frama-c",
        purpose: "shows anew what was proved of the emitted C",
        need: Need::Analysis,
        probe: Probe::Version("frama-c"),
        source: Source::Package("frama-c-base"),
    },
    Tool {
        name: "cppcheck",
        purpose: "holds the emitted C against MISRA C:2012",
        need: Need::Analysis,
        probe: Probe::Version("cppcheck"),
        source: Source::Package("cppcheck"),
    },
    Tool {
        name: "Python's venv",
        purpose: "installs the next below `target`",
        need: Need::Analysis,
        probe: Probe::Module("ensurepip"),
        source: Source::Package("python3-venv"),
    },
    package(
        "numpy",
        "the arrays of what `cargo bessemer py` makes",
        Need::Analysis,
        "numpy",
        "numpy==2.3.5",
    ),
    package(
        "FMPy",
        "steps what `cargo bessemer fmu` makes",
        Need::Analysis,
        "fmpy",
        "fmpy==0.3.32",
    ),
    package(
        "pya2l",
        "reads what `cargo bessemer a2l` makes",
        Need::Analysis,
        "pya2l",
        "pya2ldb==1.0.355",
    ),
    package(
        "FPP",
        "reads what `cargo bessemer pack fprime` makes",
        Need::Full,
        "fprime_fpp",
        "fprime-fpp==3.4.0",
    ),
    program(programs::AARCH64_GCC, "compiles the emitted C for ARM of 64 bits", Need::Full),
    headers("aarch64 C library", programs::AARCH64_GCC, Need::Full),
    program(programs::QEMU_AARCH64, "runs it", Need::Full),
    program(programs::RISCV64_GCC, "compiles the emitted C for RISC-V", Need::Full),
    headers("riscv64 C library", programs::RISCV64_GCC, Need::Full),
    program(programs::QEMU_RISCV64, "runs it", Need::Full),
    program(
        programs::RISCV_BARE_GCC,
        "compiles the program around the models for RISC-V of 32 bits",
        Need::Full,
    ),
    headers("picolibc", programs::RISCV_BARE_GCC, Need::Full),
    program(programs::QEMU_SYSTEM_RISCV32, "runs it", Need::Full),
    program(
        programs::S390X_GCC,
        "compiles the emitted C for s390x, which is big-endian",
        Need::Full,
    ),
    headers("s390x C library", programs::S390X_GCC, Need::Full),
    program(programs::QEMU_S390X, "runs it", Need::Full),
    program(programs::ALPHA_GCC, "compiles the emitted C for Alpha", Need::Full),
    headers("alpha C library", programs::ALPHA_GCC, Need::Full),
    program(programs::QEMU_ALPHA, "runs it", Need::Full),
    program(programs::HPPA_GCC, "compiles the emitted C for PA-RISC", Need::Full),
    headers("hppa C library", programs::HPPA_GCC, Need::Full),
    program(programs::QEMU_HPPA, "runs it", Need::Full),
    program(programs::SPARC64_GCC, "compiles the emitted C for SPARC of 64 bits", Need::Full),
    headers("sparc64 C library", programs::SPARC64_GCC, Need::Full),
    program(programs::QEMU_SPARC64, "runs it", Need::Full),
    program(programs::MIPS_GCC, "compiles the emitted C for MIPS", Need::Full),
    headers("mips C library", programs::MIPS_GCC, Need::Full),
    program(programs::QEMU_MIPS, "runs it", Need::Full),
    program(programs::PPC_GCC, "compiles the emitted C for PowerPC", Need::Full),
    headers("powerpc C library", programs::PPC_GCC, Need::Full),
    program(programs::QEMU_PPC, "runs it", Need::Full),
    Tool {
        name: "chromium",
        purpose: "shows the page of the ground station",
        need: Need::Full,
        probe: Probe::Version("chromium"),
        source: Source::Package("chromium"),
    },
    package(
        "zig",
        "compiles the emitted C for this processor by a newer clang",
        Need::Full,
        "ziglang",
        "ziglang==0.17.1",
    ),
    package(
        "wasmtime",
        "runs the models as WebAssembly",
        Need::Full,
        "wasmtime",
        "wasmtime==50.0.1",
    ),
    package("pymavlink", "the other end of MAVLink", Need::Full, "pymavlink", "pymavlink==2.4.50"),
    package("natnet", "a client of the motion capture", Need::Full, "natnet", "natnet==0.3.0"),
    Tool {
        name: "valgrind",
        purpose: "counts instructions on the host",
        need: Need::Bench,
        probe: Probe::Version("valgrind"),
        source: Source::Package("valgrind"),
    },
    Tool {
        name: "wasm2c",
        purpose: "a peer: C of WebAssembly",
        need: Need::Bench,
        probe: Probe::Version("wasm2c"),
        source: Source::Package("wabt"),
    },
    Tool {
        name: "Eigen",
        purpose: "a peer",
        need: Need::Bench,
        probe: Probe::File("/usr/include/eigen3/Eigen/Core"),
        source: Source::Package("libeigen3-dev"),
    },
    Tool {
        name: "OpenBLAS",
        purpose: "a peer",
        need: Need::Bench,
        probe: Probe::File("/usr/lib/x86_64-linux-gnu/libopenblas.so"),
        source: Source::Package("libopenblas-dev"),
    },
    Tool {
        name: "LAPACK",
        purpose: "a peer: the reference",
        need: Need::Bench,
        probe: Probe::File("/usr/lib/x86_64-linux-gnu/lapack/liblapack.so"),
        source: Source::Package("liblapack-dev"),
    },
    Tool {
        name: "BLAS",
        purpose: "the reference, under LAPACK",
        need: Need::Bench,
        probe: Probe::File("/usr/lib/x86_64-linux-gnu/blas/libblas.so"),
        source: Source::Package("libblas-dev"),
    },
];

/// Returns every Python package as a requirement for pip.
pub fn requirements() -> impl Iterator<Item = &'static str> {
    TOOLS.iter().filter_map(|tool| match tool.source {
        Source::Python(requirement) => Some(requirement),
        _ => None,
    })
}

/// Returns the folder of the Python packages.
#[must_use]
pub fn python() -> PathBuf {
    project::root().join("target/python")
}

/// Properties of the machine that runs the commands.
pub trait Machine {
    /// Returns the program's answer to `--version`; `None` if it is missing or does not work.
    fn version(&self, program: &str) -> Option<String>;
    /// Returns true if the compiler can preprocess a file that includes headers of the C library.
    fn finds_headers(&self, compiler: &str) -> bool;
    /// Returns true if the compiler, one like clang, has the libraries that its sanitizers link.
    fn has_sanitizers(&self, compiler: &str) -> bool;
    /// Returns true if we have root's rights.
    fn is_root(&self) -> bool;
    /// Returns true if the file exists.
    fn has_file(&self, path: &str) -> bool {
        std::path::Path::new(path).exists()
    }
    /// Returns true if the system's Python finds the module.
    fn has_module(&self, module: &str) -> bool {
        answer(Command::new("python3").args(["-c", &format!("import {module}")])).is_some()
    }
    /// Returns true if the environment below `target` has the module, of the version in `requirement`: `name==version`.
    /// The system's Python does not count, since the tests run the environment's.
    fn has_package(&self, module: &str, requirement: &str) -> bool {
        let (name, version) = requirement.split_once("==").unwrap_or((requirement, ""));
        let script = format!(
            "import {module}, importlib.metadata as it; assert it.version('{name}') == '{version}'"
        );
        answer(Command::new(python().join("bin/python")).args(["-c", &script])).is_some()
    }
}

/// The machine that runs this program.
#[derive(Debug, Clone, Copy)]
pub struct ThisMachine;

impl Machine for ThisMachine {
    fn version(&self, program: &str) -> Option<String> {
        programs::version(program)
    }

    fn finds_headers(&self, compiler: &str) -> bool {
        let mut command = Command::new(compiler);
        command.args(["-x", "c", "-E", "-include", "math.h", "/dev/null"]);
        // It has no C library of its own.
        if compiler == programs::RISCV_BARE_GCC.name {
            command.arg("--specs=picolibc.specs");
        }
        answer(&mut command).is_some()
    }

    fn has_sanitizers(&self, compiler: &str) -> bool {
        let folder = answer(Command::new(compiler).arg("-print-runtime-dir"));
        let files = folder.and_then(|folder| std::fs::read_dir(folder.trim()).ok());
        files
            .into_iter()
            .flatten()
            .flatten()
            .any(|file| file.file_name().to_string_lossy().starts_with("libclang_rt.asan"))
    }

    fn is_root(&self) -> bool {
        answer(Command::new("id").arg("-u")).is_some_and(|user| user.trim() == "0")
    }
}

/// Returns the output of a command, if it succeeds.
fn answer(command: &mut Command) -> Option<String> {
    let output = command.stdin(Stdio::null()).stderr(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Result of looking for a tool.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The tool.
    pub tool: &'static Tool,
    /// Version of the tool, or `found` if it has none; `None` if it is missing.
    pub found: Option<String>,
}

impl Finding {
    /// Returns true if the tool is missing.
    #[must_use]
    pub fn is_missing(&self) -> bool {
        self.found.is_none()
    }
}

/// Looks for every tool.
#[must_use]
pub fn survey(machine: &dyn Machine) -> Vec<Finding> {
    TOOLS.iter().map(|tool| find(tool, machine)).collect()
}

/// Looks for a tool.
#[must_use]
pub fn find(tool: &'static Tool, machine: &dyn Machine) -> Finding {
    let there = |found: bool| found.then(|| "found".to_owned());
    let found = match tool.probe {
        Probe::Version(program) => machine.version(program).map(|answer| number(&answer)),
        Probe::Headers(compiler) => there(machine.finds_headers(compiler)),
        Probe::Sanitizers(compiler) => there(machine.has_sanitizers(compiler)),
        Probe::File(path) => there(machine.has_file(path)),
        Probe::Module(module) => there(machine.has_module(module)),
        Probe::Environment { module, requirement } => {
            there(machine.has_package(module, requirement))
        }
    };
    Finding { tool, found }
}

/// Returns the missing tools for these needs.
#[must_use]
pub fn missing(findings: &[Finding], needs: &[Need]) -> Vec<&'static Tool> {
    let wanted = |finding: &&Finding| finding.is_missing() && needs.contains(&finding.tool.need);
    findings.iter().filter(wanted).map(|finding| finding.tool).collect()
}

/// Returns the version number in a program's output. It is the first word of digits and points, else the first word
/// that begins with a digit, else the line.
fn number(answer: &str) -> String {
    let line = answer.lines().next().unwrap_or_default().trim();
    let starts = |word: &&str| word.starts_with(|letter: char| letter.is_ascii_digit());
    let plain = |word: &&str| {
        starts(word) && word.chars().all(|letter| letter.is_ascii_digit() || letter == '.')
    };
    let words = || line.split_whitespace();
    // `valgrind-3.19.0`
    let joined = || line.split_once('-').map(|(_, number)| number).filter(starts);
    words().find(plain).or_else(|| words().find(starts)).or_else(joined).unwrap_or(line).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_is_found_in_what_real_tools_say() {
        let cases = [
            ("rustc 1.95.0 (f2d3ce0bd 2026-03-21)\n", "1.95.0"),
            ("rustfmt 1.9.0-stable (59807616e1 2026-04-14)", "1.9.0-stable"),
            ("clippy 0.1.95 (59807616e1 2026-04-14)", "0.1.95"),
            ("gcc (Debian 12.2.0-14+deb12u1) 12.2.0\nCopyright (C) 2022", "12.2.0"),
            ("Debian clang version 14.0.6\nTarget: x86_64-pc-linux-gnu", "14.0.6"),
            ("Ubuntu clang version 14.0.0-1ubuntu1.1", "14.0.0-1ubuntu1.1"),
            ("qemu-arm version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)", "7.2.22"),
            ("valgrind-3.19.0", "3.19.0"),
            ("nightly", "nightly"),
        ];
        for (answer, expected) in cases {
            assert_eq!(number(answer), expected, "{answer}");
        }
    }

    #[test]
    fn what_does_not_exist_is_not_there() {
        assert_eq!(ThisMachine.version("no-such-program-anywhere"), None);
        assert!(!ThisMachine.finds_headers("no-such-compiler-anywhere"));
        assert!(!ThisMachine.has_sanitizers("no-such-compiler-anywhere"));
    }

    #[test]
    fn what_started_us_is_there() {
        assert!(ThisMachine.version("rustc").is_some_and(|answer| answer.starts_with("rustc")));
    }
}
