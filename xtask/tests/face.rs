//! The decisions of the command-line face, on made-up machines: what is missing, what is printed, what is refused.

use std::collections::{BTreeMap, BTreeSet};
use xtask::args::Test;
use xtask::doctor;
use xtask::error::Error;
use xtask::install::Plan;
use xtask::stages::Progress;
use xtask::test::prepare;
use xtask::tools::{self, Machine, Need, Tool, missing, survey};

/// A machine that has what the test says.
#[derive(Default)]
struct Fake {
    programs: BTreeMap<&'static str, &'static str>,
    headers: BTreeSet<&'static str>,
    root: bool,
    /// True if clang lacks the libraries of its sanitizers, as apt leaves it by default.
    bare: bool,
}

impl Machine for Fake {
    fn version(&self, program: &str) -> Option<String> {
        self.programs.get(program).map(|&answer| answer.to_owned())
    }

    fn finds_headers(&self, compiler: &str) -> bool {
        self.headers.contains(compiler)
    }

    fn has_sanitizers(&self, compiler: &str) -> bool {
        self.programs.contains_key(compiler) && !self.bare
    }

    fn is_root(&self) -> bool {
        self.root
    }

    fn has_file(&self, _: &str) -> bool {
        true
    }

    fn has_module(&self, _: &str) -> bool {
        true
    }

    fn has_package(&self, _: &str, _: &str) -> bool {
        true
    }
}

impl Fake {
    /// A fresh Debian with Rust and a C compiler, as a user without rights.
    fn fresh() -> Self {
        let programs = [
            ("rustc", "rustc 1.95.0 (f2d3ce0bd 2026-03-21)"),
            ("rustfmt", "rustfmt 1.9.0-stable (59807616e1 2026-04-14)"),
            ("cargo-clippy", "clippy 0.1.95 (59807616e1 2026-04-14)"),
            ("gcc", "gcc (Debian 12.2.0-14+deb12u1) 12.2.0"),
            ("apt-get", "apt 2.6.1 (amd64)"),
        ];
        Self { programs: programs.into(), headers: ["gcc"].into(), root: false, bare: false }
    }

    /// Returns a machine with the host compilers.
    fn host() -> Self {
        Self::fresh()
            .with("g++", "g++ (Debian 12.2.0-14+deb12u1) 12.2.0")
            .with("clang", "Debian clang version 14.0.6")
    }

    /// Returns a machine with everything.
    fn full() -> Self {
        let mut fake = Self::host()
            .with("arm-linux-gnueabihf-gcc", "arm-linux-gnueabihf-gcc (Debian 12.2.0-14) 12.2.0")
            .with("qemu-arm", "qemu-arm version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)")
            .with("arm-none-eabi-gcc", "arm-none-eabi-gcc (15:12.2.rel1-1) 12.2.1 20221205")
            .with("qemu-system-arm", "QEMU emulator version 7.2.22 (Debian 1:7.2+dfsg-7)")
            .with("valgrind", "valgrind-3.19.0")
            .with("wasm2c", "1.0.32")
            .with("arm-linux-gnueabihf-g++", "arm-linux-gnueabihf-g++ (Debian 12.2.0-14) 12.2.0");
        for (compiler, answer) in [
            ("aarch64-linux-gnu-gcc", "aarch64-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
            ("riscv64-linux-gnu-gcc", "riscv64-linux-gnu-gcc (Debian 12.2.0-13) 12.2.0"),
            ("riscv64-unknown-elf-gcc", "riscv64-unknown-elf-gcc () 12.2.0"),
            ("s390x-linux-gnu-gcc", "s390x-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
            ("alpha-linux-gnu-gcc", "alpha-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
            ("hppa-linux-gnu-gcc", "hppa-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
            ("sparc64-linux-gnu-gcc", "sparc64-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
            ("mips-linux-gnu-gcc", "mips-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
            ("powerpc-linux-gnu-gcc", "powerpc-linux-gnu-gcc (Debian 12.2.0-14) 12.2.0"),
        ] {
            fake = fake.with(compiler, answer);
            fake.headers.insert(compiler);
        }
        for (emulator, answer) in [
            ("qemu-aarch64", "qemu-aarch64 version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("qemu-riscv64", "qemu-riscv64 version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("make", "GNU Make 4.3"),
            ("cmake", "cmake version 3.25.1"),
            ("frama-c", "25.0-beta (Manganese)"),
            ("cppcheck", "Cppcheck 2.10"),
            ("chromium", "Chromium 150.0.1 built on Debian GNU/Linux 12 (bookworm)"),
            ("qemu-system-riscv32", "QEMU emulator version 7.2.22 (Debian 1:7.2+dfsg-7)"),
            ("qemu-s390x", "qemu-s390x version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("qemu-alpha", "qemu-alpha version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("qemu-hppa", "qemu-hppa version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("qemu-sparc64", "qemu-sparc64 version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("qemu-mips", "qemu-mips version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
            ("qemu-ppc", "qemu-ppc version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18+b3)"),
        ] {
            fake = fake.with(emulator, answer);
        }
        fake.headers.insert("arm-linux-gnueabihf-gcc");
        fake.headers.insert("arm-none-eabi-gcc");
        fake
    }

    fn with(mut self, program: &'static str, answer: &'static str) -> Self {
        self.programs.insert(program, answer);
        self
    }

    fn without(mut self, program: &str) -> Self {
        self.programs.remove(program);
        self
    }

    fn rooted(mut self) -> Self {
        self.root = true;
        self
    }
}

const ALL: &[Need] = &[Need::Everything, Need::Host, Need::Target, Need::Analysis];

fn lacking(machine: &Fake) -> Vec<&'static Tool> {
    missing(&survey(machine), ALL)
}

fn line(machine: &Fake) -> Option<String> {
    Plan::of(&lacking(machine), machine).map(|plan| plan.line())
}

fn table(machine: &Fake) -> String {
    let plan = Plan::of(&lacking(machine), machine);
    anstream::adapter::strip_str(&doctor::table(&survey(machine), plan.as_ref())).to_string()
}

#[track_caller]
fn same(actual: &str, expected: &str) {
    assert!(actual == expected, "expected:\n{expected}\nactual:\n{actual}");
}

#[test]
fn root_installs_with_apt_alone() {
    let machine = Fake::host().rooted();
    assert_eq!(
        line(&machine).as_deref(),
        Some(
            "apt-get update -o DPkg::Lock::Timeout=900 && \
             env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
             -o DPkg::Lock::Timeout=900 gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user \
             g++-arm-linux-gnueabihf gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm make cmake frama-c-base cppcheck"
        )
    );
}

#[test]
fn packages_of_pythons_come_last_and_below_target() {
    let wanted: Vec<_> =
        tools::TOOLS.iter().filter(|tool| tool.name.to_lowercase().starts_with("py")).collect();
    let plan = Plan::of(&wanted, &Fake::host().rooted()).expect("there is something to install");
    let own = tools::python().display().to_string();
    let line = plan.line();
    let (_, last) = line.split_once("python3-venv && ").expect("apt comes first");
    assert_eq!(
        last,
        format!(
            "python3 -m venv --clear {own} && {own}/bin/pip install --quiet --no-compile \
             numpy==2.3.5 fmpy==0.3.32 pya2ldb==1.0.355 fprime-fpp==3.4.0 ziglang==0.17.1 wasmtime==50.0.1 pymavlink==2.4.50 natnet==0.3.0"
        )
    );
}

#[test]
fn clang_without_its_run_time_is_not_enough() {
    let machine = Fake { bare: true, ..Fake::full().rooted() };
    assert!(line(&machine).is_some_and(|line| line.ends_with("=900 libclang-rt-dev")));
}

#[test]
fn others_install_through_sudo() {
    let machine = Fake::full().without("clang").with("sudo", "Sudo version 1.9.13p3");
    assert_eq!(
        line(&machine).as_deref(),
        Some(
            "sudo apt-get update -o DPkg::Lock::Timeout=900 && \
             sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
             -o DPkg::Lock::Timeout=900 clang libclang-rt-dev"
        )
    );
}

#[test]
fn without_sudo_the_line_becomes_root_by_itself() {
    let machine = Fake::full().without("clang").without("rustfmt");
    assert_eq!(
        line(&machine).as_deref(),
        Some(
            "rustup component add rustfmt && \
             su -c 'apt-get update -o DPkg::Lock::Timeout=900 && \
             env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
             -o DPkg::Lock::Timeout=900 clang libclang-rt-dev'"
        )
    );
}

#[test]
fn components_of_rust_need_no_rights() {
    let machine = Fake::full().without("rustfmt").without("cargo-clippy").without("apt-get");
    assert_eq!(line(&machine).as_deref(), Some("rustup component add rustfmt clippy"));
}

#[test]
fn there_is_no_line_without_apt_or_without_need() {
    assert_eq!(line(&Fake::fresh().without("apt-get")), None);
    assert_eq!(line(&Fake::full()), None);
}

#[test]
fn a_compiler_without_headers_is_not_enough() {
    let mut machine = Fake::full().rooted();
    machine.headers.remove("arm-linux-gnueabihf-gcc");
    let names: Vec<_> = lacking(&machine).iter().map(|tool| tool.name).collect();
    assert_eq!(names, ["ARM C library"]);
    assert!(line(&machine).is_some_and(|line| line.ends_with(" libc6-dev-armhf-cross")));
}

#[test]
fn the_table_of_a_machine_with_everything() {
    same(
        &table(&Fake::full()),
        "\
tool                     version       needed for         what for
rustc                    1.95.0        everything         builds the models and these commands
rustfmt                  1.9.0-stable  test               checks the format of the Rust
clippy                   0.1.95        test               lints the Rust
gcc                      12.2.0        test               compiles the emitted C
g++                      12.2.0        test               compiles the emitted headers as C++
clang                    14.0.6        test               compiles the emitted C a second time
clang's run time         found         test               the libraries of its sanitizers
C library                found         test               headers and libraries for the above
arm-linux-gnueabihf-gcc  12.2.0        test (not --host)  compiles the emitted C for a Cortex-A9
ARM C library            found         test (not --host)  headers and libraries for the above
qemu-arm                 7.2.22        test (not --host)  runs it on an emulated Cortex-A9
arm-linux-gnueabihf-g++  12.2.0        test (not --host)  compiles C++ around the emitted C, and Eigen, for a Cortex-A9
arm-none-eabi-gcc        12.2.1        test (not --host)  compiles firmware around the emitted C
newlib                   found         test (not --host)  headers and libraries for the above
qemu-system-arm          7.2.22        test (not --host)  runs it on an emulated Zynq, without an operating system
make                     4.3           test (not --host)  builds the emitted C by its Makefile
cmake                    3.25.1        test (not --host)  builds the emitted C by its CMakeLists.txt
frama-c                  25.0-beta     test (not --host)  shows anew what was proved of the emitted C
cppcheck                 2.10          test (not --host)  holds the emitted C against MISRA C:2012
Python's venv            found         test (not --host)  installs the next below `target`
numpy                    found         test (not --host)  the arrays of what `cargo bessemer py` makes
FMPy                     found         test (not --host)  steps what `cargo bessemer fmu` makes
pya2l                    found         test (not --host)  reads what `cargo bessemer a2l` makes
FPP                      found         test --full        reads what `cargo bessemer pack fprime` makes
aarch64-linux-gnu-gcc    12.2.0        test --full        compiles the emitted C for ARM of 64 bits
aarch64 C library        found         test --full        headers and libraries for the above
qemu-aarch64             7.2.22        test --full        runs it
riscv64-linux-gnu-gcc    12.2.0        test --full        compiles the emitted C for RISC-V
riscv64 C library        found         test --full        headers and libraries for the above
qemu-riscv64             7.2.22        test --full        runs it
riscv64-unknown-elf-gcc  12.2.0        test --full        compiles the program around the models for RISC-V of 32 bits
picolibc                 found         test --full        headers and libraries for the above
qemu-system-riscv32      7.2.22        test --full        runs it
s390x-linux-gnu-gcc      12.2.0        test --full        compiles the emitted C for s390x, which is big-endian
s390x C library          found         test --full        headers and libraries for the above
qemu-s390x               7.2.22        test --full        runs it
alpha-linux-gnu-gcc      12.2.0        test --full        compiles the emitted C for Alpha
alpha C library          found         test --full        headers and libraries for the above
qemu-alpha               7.2.22        test --full        runs it
hppa-linux-gnu-gcc       12.2.0        test --full        compiles the emitted C for PA-RISC
hppa C library           found         test --full        headers and libraries for the above
qemu-hppa                7.2.22        test --full        runs it
sparc64-linux-gnu-gcc    12.2.0        test --full        compiles the emitted C for SPARC of 64 bits
sparc64 C library        found         test --full        headers and libraries for the above
qemu-sparc64             7.2.22        test --full        runs it
mips-linux-gnu-gcc       12.2.0        test --full        compiles the emitted C for MIPS
mips C library           found         test --full        headers and libraries for the above
qemu-mips                7.2.22        test --full        runs it
powerpc-linux-gnu-gcc    12.2.0        test --full        compiles the emitted C for PowerPC
powerpc C library        found         test --full        headers and libraries for the above
qemu-ppc                 7.2.22        test --full        runs it
chromium                 150.0.1       test --full        shows the page of the ground station
zig                      found         test --full        compiles the emitted C for this processor by a newer clang
wasmtime                 found         test --full        runs the models as WebAssembly
pymavlink                found         test --full        the other end of MAVLink
natnet                   found         test --full        a client of the motion capture
valgrind                 3.19.0        bench              counts instructions on the host
wasm2c                   1.0.32        bench              a peer: C of WebAssembly
Eigen                    found         bench              a peer
OpenBLAS                 found         bench              a peer
LAPACK                   found         bench              a peer: the reference
BLAS                     found         bench              the reference, under LAPACK

Everything is there: `cargo xtask test` can run.
",
    );
}

#[test]
fn the_conclusion_says_what_can_run_and_what_to_do() {
    let conclusion =
        |machine: &Fake| table(machine).split_once("\n\n").map(|parts| parts.1.to_owned());
    assert_eq!(
        conclusion(&Fake::host().rooted()).as_deref(),
        Some(
            "Missing: arm-linux-gnueabihf-gcc, ARM C library, qemu-arm, arm-linux-gnueabihf-g++, \
             arm-none-eabi-gcc, newlib, \
             qemu-system-arm, make, cmake, frama-c, cppcheck. `cargo xtask test --host` can run.\n\
             To install, run this line, or `cargo xtask test --install`:\n  \
             apt-get update -o DPkg::Lock::Timeout=900 && env DEBIAN_FRONTEND=noninteractive apt-get install -y \
             --no-install-recommends -o DPkg::Lock::Timeout=900 \
             gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user \
             g++-arm-linux-gnueabihf gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm make cmake frama-c-base cppcheck\n"
        )
    );
    assert_eq!(
        conclusion(&Fake::full().without("clang").without("apt-get")).as_deref(),
        Some(
            "Missing: clang, clang's run time.\n\
             There is no apt-get here: install them with this system's own package manager.\n"
        )
    );
}

#[test]
fn the_json_says_the_same() {
    let machine = Fake::host().rooted();
    let plan = Plan::of(&lacking(&machine), &machine);
    let value = doctor::json(&survey(&machine), plan.as_ref());
    assert_eq!(value["ready"]["gen"], true);
    assert_eq!(value["ready"]["test --host"], true);
    assert_eq!(value["ready"]["test"], false);
    assert_eq!(value["install"].as_str(), line(&machine).as_deref());
    assert_eq!(value["tools"][3]["version"], "12.2.0");
    assert_eq!(value["tools"][10]["name"], "qemu-arm");
    assert_eq!(value["tools"][10]["found"], false);
    assert_eq!(value["tools"][10]["package"], "qemu-user");
}

#[test]
fn test_refuses_to_start_and_prints_one_line() {
    let machine = Fake::fresh().with("sudo", "Sudo version 1.9.13p3");
    let outcome = prepare(
        &Test { install: false, host: false, ..Test::default() },
        &machine,
        &mut Progress::default(),
    );
    let error = outcome.expect_err("tools are missing");
    assert_eq!(
        error.to_string(),
        "missing: g++, clang, clang's run time, arm-linux-gnueabihf-gcc, ARM C library, qemu-arm, arm-linux-gnueabihf-g++, \
             arm-none-eabi-gcc, newlib, \
             qemu-system-arm, make, cmake, frama-c, cppcheck"
    );
    let remedy = error.remedy().expect("there is apt-get");
    assert_eq!(remedy.lines().count(), 1);
    assert_eq!(Some(remedy), line(&machine));
    assert_eq!(error.code(), 1);
}

#[test]
fn test_of_the_host_does_without_the_arm_tools() {
    let wanted = Test { install: false, host: true, ..Test::default() };
    assert!(prepare(&wanted, &Fake::host(), &mut Progress::default()).is_ok());
    let outcome = prepare(&wanted, &Fake::fresh(), &mut Progress::default());
    assert!(
        matches!(outcome, Err(Error::Missing { tools, .. }) if tools == ["g++", "clang", "clang's run time"])
    );
}

#[test]
fn installing_without_rights_stops_before_it_starts() {
    let outcome = prepare(
        &Test { install: true, host: false, ..Test::default() },
        &Fake::host(),
        &mut Progress::default(),
    );
    let Err(Error::NoRights { line, .. }) = outcome else { panic!("{outcome:?}") };
    assert!(line.starts_with("su -c 'apt-get update"), "{line}");
}

#[test]
fn nothing_is_installed_when_everything_is_there() {
    let wanted = Test { install: true, host: false, ..Test::default() };
    assert!(prepare(&wanted, &Fake::full(), &mut Progress::default()).is_ok());
}
