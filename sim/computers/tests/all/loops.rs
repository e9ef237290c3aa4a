//! The loop of the drive example around each computer: the bits are those of the Rust.

#[path = "../../../kit/examples/drive/main.rs"]
#[allow(dead_code, unexpected_cfgs)]
mod example;

use std::fs;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use std::time::Duration;

use bessemer_computers::{Error, Leg, Package, Toolchain, Unit, host, wired};
use bessemer_legs::firmware::{Firmware, Machine};
use bessemer_legs::toolchain::{ARM, ZYNQ, is_asked_for};
use bessemer_sim::{Computer, Outcome, Reading, Scenario};
use cargo_bessemer::args::Fmu;
use example::{MOTOR, Motor, PERIOD, control::Drive, settings, setup};

/// Command of the loop: the duties of three half bridges.
type Duties = [f64; 3];

static PACKAGE: LazyLock<Package> =
    LazyLock::new(|| Package::find(folder()).unwrap_or_else(|error| panic!("{error}")));

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("drive")
}

/// Runs the example's loop for a time, s, in which the load comes.
fn run(duration: f64, computer: &mut impl Computer<3, f64, Duties>) -> Outcome<Motor, 4> {
    let scenario = example::scenario(1).expect("a scenario");
    let changes = vec![(0.3 * duration, example::LOAD), (0.6 * duration, 0.0)];
    let disturbances = bessemer_sim::Timeline::new(0.0, changes).expect("in order");
    let scenario = Scenario { duration, disturbances, ..scenario };
    let outcome = setup().expect("a setup").run(&scenario, computer);
    outcome.unwrap_or_else(|error| panic!("{error}"))
}

/// Compares the loop around a leg with that around the Rust, bit for bit.
fn same_bits(duration: f64, leg: impl Leg) {
    let settings = settings(&MOTOR);
    let mut drive = Drive::default();
    let mut native = |[a, b, angle]: &[Reading; 3], target: &f64| {
        drive.step(&settings, *target, [a.value, b.value], angle.value)
    };
    let expected = run(duration, &mut native);
    let arguments = |[a, b, angle]: &[Reading; 3], target: &f64| {
        (example::settings(&MOTOR), *target, [a.value, b.value], angle.value)
    };
    let outcome = run(duration, &mut wired(leg, arguments, |duties: Duties| duties));
    let bits = |outcome: &Outcome<Motor, 4>| outcome.state.map(f64::to_bits);
    assert!(expected.state[2] != 0.0, "it moves");
    assert_eq!(bits(&outcome), bits(&expected));
    assert_eq!(outcome.recording, expected.recording);
}

#[test]
fn the_interpreter_has_the_bits_of_the_rust() {
    same_bits(0.1, PACKAGE.entry("Drive::step").expect("an entry").interpreter());
}

/// Returns true if the run uses an emulated processor.
fn is_there(toolchain: &Toolchain) -> bool {
    toolchain.programs().into_iter().all(is_asked_for)
}

/// By the compiler of this machine, and for the emulated Cortex-A9 if it is there.
#[test]
fn the_c_has_the_bits_of_the_rust() {
    let entry = PACKAGE.entry("drive_step").expect("an entry");
    let toolchains = [Some(host().expect("a compiler")), Some(ARM).filter(is_there)];
    for toolchain in toolchains.into_iter().flatten() {
        same_bits(0.1, entry.process(&toolchain).unwrap_or_else(|error| panic!("{error}")));
    }
}

/// A board's port, as a program of this machine has it: its standard input and output.
const PORT: &str = "#include <stdlib.h>\n#include <unistd.h>\n#include \"uart.h\"\n\
    void uart_open(void)\n{\n}\n\
    uint8_t uart_get(void)\n{\n    uint8_t byte;\n    if (read(0, &byte, 1) != 1) {\n        exit(0);\n    }\n    return byte;\n}\n\
    void uart_put(uint8_t byte)\n{\n    if (write(1, &byte, 1) != 1) {\n        exit(1);\n    }\n}\n";

/// Starts the firmware as a program of this machine, whose port is its standard input and output.
fn stand_in(sources: &[(&str, String)], folder: &Path) -> (Machine, UnixStream) {
    let mut paths = Vec::new();
    for (name, text) in sources.iter().chain(&[("port.c", PORT.to_owned())]) {
        let path = folder.join(name);
        fs::write(&path, text).expect("a source");
        paths.extend(Some(path).filter(|_| name.ends_with(".c")));
    }
    let program = folder.join("board");
    let flags = ["-D_POSIX_C_SOURCE=200112L"];
    host().expect("a compiler").link(&paths, &program, &flags).expect("it compiles");
    let (here, there) = UnixStream::pair().expect("a line");
    let there = OwnedFd::from(there);
    let mut command = Command::new(program);
    command.stdin(there.try_clone().expect("a line")).stdout(there);
    (Machine::from(command.spawn().expect("it starts")), here)
}

/// Over a serial line: a program of this machine, and the emulated Zynq if it is there.
#[test]
fn a_board_has_the_bits_of_the_rust() {
    let entry = PACKAGE.entry("Drive::step").expect("an entry");
    let sources = PACKAGE.firmware().unwrap_or_else(|error| panic!("{error}"));
    let sources: Vec<(&str, String)> =
        sources.iter().map(|(name, text)| (name.as_str(), text.clone())).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let (_program, line) = stand_in(&sources, folder.path());
    same_bits(0.02, entry.board(line).unwrap_or_else(|error| panic!("{error}")));
    if is_there(&ZYNQ) {
        let board = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/zynq/board");
        let firmware = Firmware::build(&[board], &sources, &[], &ZYNQ).expect("it compiles");
        // The first query is lost while the machine starts.
        let (_machine, line) = firmware.start(Duration::from_secs(2)).expect("it starts");
        let patience = line.try_clone().expect("a line");
        let leg = entry.board(line).unwrap_or_else(|error| panic!("{error}"));
        patience.set_read_timeout(Some(Duration::from_secs(20))).expect("a line");
        same_bits(0.02, leg);
    }
}

#[test]
fn a_unit_has_the_bits_of_the_rust() {
    let output = tempfile::tempdir().expect("a folder");
    let wanted = Fmu {
        package: Default::default(),
        entry: Some("Drive::step".to_owned()),
        period: Some(PERIOD),
        output: output.path().to_owned(),
    };
    cargo_bessemer::fmu::run(&folder(), &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    let path = output.path().join("drive_step.fmu");
    let unit = Unit::open(&path, PERIOD).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(unit.outputs().collect::<Vec<_>>(), [("result", 3)]);
    let period = Unit::open(&path, 0.001).expect_err("it has another").to_string();
    assert!(period.ends_with("its step is 0.0001 s, not 0.001 s; pass that period"), "{period}");
    same_bits(0.1, unit);
}

/// Each mistake is an error with a remedy.
#[test]
fn mistakes_are_errors() {
    let said = |error: Error| error.to_string();
    let missing = PACKAGE.entry("Drive::stop").err().map(said).expect("there is none");
    assert!(missing.starts_with("there is no entry point `Drive::stop`; there are: "), "{missing}");
    let entry = PACKAGE.entry("Drive::step").expect("an entry");
    let short = entry.interpreter().call(&[0]).expect_err("too few words").to_string();
    assert!(short.contains("and the call has 1; pass a tuple"), "{short}");
    let arguments = |[a, b, angle]: &[Reading; 3], target: &f64| {
        (settings(&MOTOR), *target, [a.value, b.value], angle.value)
    };
    let mut wrong = wired(entry.interpreter(), arguments, |duty: f64| [duty; 3]);
    let wrong = wrong.step(&[Reading::default(); 3], &1.0).expect_err("three words").to_string();
    assert!(
        wrong.starts_with("the result has 3 words, and the argument of `command` 1"),
        "{wrong}"
    );
    let none = Unit::open("no such unit", PERIOD).expect_err("there is none").to_string();
    assert!(none.starts_with("`no such unit`: "), "{none}");
}
