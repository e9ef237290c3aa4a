//! The install step on machines that have some of the tools: afterwards none is missing.
//!
//! A machine is a folder whose `bin` is all of `PATH`, with programs that are one script by many names (`installed/fake.sh`):
//! compilers that are there if their package was installed, an apt-get that installs packages, a Python with modules.
//! `PATH` belongs to a process, so each test is this program once more, in which only that test runs.

use std::collections::BTreeSet;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;
use xtask::args::Test;
use xtask::install::Plan;
use xtask::stages::Progress;
use xtask::test::prepare;
use xtask::tools::{Probe, Source, TOOLS, ThisMachine, Tool, find, python};

/// The folder that is the machine; only for the process that runs on it.
const HERE: &str = "XTASK_MACHINE";

/// Runs `work` in a process of its own whose `PATH` is a machine's `bin`.
fn on_a_machine(test: &str, work: impl FnOnce(&Path)) {
    if let Some(folder) = std::env::var_os(HERE) {
        return work(Path::new(&folder));
    }
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", test, "--nocapture"])
        .env(HERE, folder.path())
        .env("PATH", folder.path().join("bin"))
        // The folder above it is where the project lies.
        .env("CARGO_MANIFEST_DIR", folder.path().join("xtask"))
        .output()
        .expect("it starts");
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said);
    assert!(output.status.success(), "{said}");
    assert!(said.contains("1 passed"), "{test} is no test: {said}");
}

/// Installed programs and modules of a machine.
#[derive(Clone, Debug, Default)]
struct Has {
    /// Packages of Debian's.
    packages: BTreeSet<&'static str>,
    /// Modules of the system's Python.
    modules: BTreeSet<&'static str>,
    /// Packages of the environment below `target`, if there is one.
    environment: Option<BTreeSet<String>>,
}

/// The package of Debian's that brings a tool.
fn package(tool: &Tool) -> Option<&'static str> {
    match tool.source {
        Source::Package(name) => Some(name),
        _ => None,
    }
}

/// Module and requirement of a tool that is a package of Python's.
fn module(tool: &Tool) -> Option<(&'static str, &'static str)> {
    match tool.probe {
        Probe::Environment { module, requirement } => Some((module, requirement)),
        _ => None,
    }
}

/// Makes the machine in `folder` one that has this and nothing else.
fn make(folder: &Path, has: &Has) {
    let write = |path: PathBuf, text: &str| fs::write(path, text).expect("the folder");
    for entry in fs::read_dir(folder).expect("the folder").flatten() {
        match entry.file_type().expect("a type").is_dir() {
            true => fs::remove_dir_all(entry.path()).expect("it is ours"),
            false => fs::remove_file(entry.path()).expect("it is ours"),
        }
    }
    for name in ["bin", "installed", "provides", "headers", "modules"] {
        fs::create_dir_all(folder.join(name)).expect("the folder");
    }
    write(folder.join("fake"), include_str!("installed/fake.sh"));
    let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    fs::set_permissions(folder.join("fake"), mode).expect("it is ours");
    for name in ["apt-get", "id", "python3"] {
        symlink("../fake", folder.join("bin").join(name)).expect("the folder");
    }
    symlink("/usr/bin/env", folder.join("bin/env")).expect("the folder");
    for tool in TOOLS {
        if let Some((module, requirement)) = module(tool) {
            write(folder.join("provides").join(requirement), module);
        }
        let Some(package) = package(tool) else { continue };
        let provides = folder.join("provides").join(package);
        let mut programs = fs::read_to_string(&provides).unwrap_or_default();
        match tool.probe {
            Probe::Version(program) => programs += &format!("{program}\n"),
            Probe::Headers(compiler) => write(folder.join("headers").join(compiler), package),
            _ => {}
        }
        write(provides, &programs);
    }
    for package in &has.packages {
        write(folder.join("installed").join(package), "");
        let programs = fs::read_to_string(folder.join("provides").join(package));
        for program in programs.expect("a tool has this package").lines() {
            symlink("../fake", folder.join("bin").join(program)).expect("the folder");
        }
    }
    for module in &has.modules {
        write(folder.join("modules").join(module), "");
    }
    if let Some(packages) = &has.environment {
        let own = folder.join("target/python");
        fs::create_dir_all(own.join("bin")).expect("the folder");
        fs::create_dir_all(own.join("modules")).expect("the folder");
        for name in ["python", "pip"] {
            symlink(folder.join("fake"), own.join("bin").join(name)).expect("the folder");
        }
        for package in packages {
            write(own.join(package), "");
            // In whichever version.
            let name = |it: &str| it.split('=').next().map(str::to_owned);
            let mut known = TOOLS.iter().filter_map(module);
            let known = known.find(|(_, requirement)| name(requirement) == name(package));
            let (module, _) = known.expect("a tool has this module");
            write(own.join("modules").join(module), "");
        }
    }
}

/// Installs the missing tools of a kind; then none is missing.
fn install(folder: &Path, kind: &[&'static Tool], has: &Has) {
    make(folder, has);
    let lacking = || -> Vec<&'static Tool> {
        kind.iter().copied().filter(|tool| find(tool, &ThisMachine).is_missing()).collect()
    };
    let missing = lacking();
    if let Some(plan) = Plan::of(&missing, &ThisMachine) {
        let done = plan.carry_out(&missing, &mut Progress::silent());
        done.unwrap_or_else(|error| panic!("{error}: {has:?}"));
    }
    let left: Vec<&str> = lacking().iter().map(|tool| tool.name).collect();
    assert!(left.is_empty(), "still missing: {left:?}; before: {has:?}");
}

/// Every subset of these.
fn subsets<T: Clone + Ord>(all: &[T]) -> impl Iterator<Item = BTreeSet<T>> {
    (0..1_usize << all.len()).map(|bits| {
        let chosen = all.iter().enumerate().filter(|(n, _)| bits >> n & 1 == 1);
        chosen.map(|(_, one)| one.clone()).collect()
    })
}

/// The tools of these packages.
fn tools_of(packages: &[&str]) -> Vec<&'static Tool> {
    TOOLS.iter().filter(|tool| package(tool).is_some_and(|it| packages.contains(&it))).collect()
}

#[test]
fn whichever_modules_of_python_are_there() {
    on_a_machine("whichever_modules_of_python_are_there", |folder| {
        let mut kind = tools_of(&["python3-venv"]);
        kind.extend(TOOLS.iter().filter(|tool| module(tool).is_some()));
        let known: Vec<_> = TOOLS.iter().filter_map(module).collect();
        assert!(known.len() > 3, "{known:?}");
        let modules: Vec<&str> = known.iter().map(|(module, _)| *module).collect();
        for modules in subsets(&modules) {
            install(folder, &kind, &Has { modules, ..Has::default() });
        }
        let requirements: Vec<String> = known.iter().map(|(_, it)| (*it).to_owned()).collect();
        for environment in subsets(&requirements) {
            install(folder, &kind, &Has { environment: Some(environment), ..Has::default() });
        }
        // Each in a version that was pinned before.
        for old in &requirements {
            let (name, _) = old.split_once("==").expect("it is pinned");
            let others = requirements.iter().filter(|it| *it != old).cloned();
            let environment = others.chain([format!("{name}==0.0.1")]).collect();
            install(folder, &kind, &Has { environment: Some(environment), ..Has::default() });
        }
        // An environment whose Python is gone.
        make(folder, &Has::default());
        fs::create_dir_all(python().join("bin")).expect("the folder");
        symlink("/no/such/python", python().join("bin/python")).expect("the folder");
        assert!(kind.iter().skip(1).all(|tool| find(tool, &ThisMachine).is_missing()));
    });
}

/// Compilers and emulators, with what they cannot do without, by the machine that they are for.
const KINDS: &[&[&str]] = &[
    &["gcc", "g++", "clang", "libclang-rt-dev", "libc6-dev"],
    &["gcc-arm-linux-gnueabihf", "libc6-dev-armhf-cross", "qemu-user", "g++-arm-linux-gnueabihf"],
    &["gcc-arm-none-eabi", "libnewlib-arm-none-eabi", "qemu-system-arm"],
    &["gcc-aarch64-linux-gnu", "libc6-dev-arm64-cross", "qemu-user"],
    &["gcc-riscv64-linux-gnu", "libc6-dev-riscv64-cross", "qemu-user"],
    &["gcc-s390x-linux-gnu", "libc6-dev-s390x-cross", "qemu-user"],
    &["gcc-alpha-linux-gnu", "libc6.1-dev-alpha-cross", "qemu-user"],
];

#[test]
fn whichever_compilers_and_emulators_are_there() {
    on_a_machine("whichever_compilers_and_emulators_are_there", |folder| {
        for packages in KINDS {
            let kind = tools_of(packages);
            assert!(kind.len() >= packages.len(), "{packages:?}");
            for packages in subsets(packages) {
                install(folder, &kind, &Has { packages, ..Has::default() });
            }
        }
    });
}

#[test]
fn on_a_machine_with_nothing_everything_is_installed_at_once() {
    on_a_machine("on_a_machine_with_nothing_everything_is_installed_at_once", |folder| {
        // Rust itself is there, without which nobody asks.
        make(folder, &Has::default());
        for name in ["rustc", "rustfmt", "cargo-clippy"] {
            symlink("../fake", folder.join("bin").join(name)).expect("the folder");
        }
        let wanted = Test { install: true, full: true, ..Test::default() };
        let mut progress = Progress::silent();
        let begun = prepare(&wanted, &ThisMachine, &mut progress).expect("it can be installed");
        begun.expect("something is missing").end(&mut progress).expect("it is installed");
        let again = Test { install: false, full: true, ..Test::default() };
        let left = prepare(&again, &ThisMachine, &mut progress);
        assert!(matches!(left, Ok(None)), "{left:?}");
    });
}
