//! `verify` as its users call it: on each leg, by a recording, from a test, on a board.

use std::fs;
use std::io::{BufRead as _, BufReader};
use std::os::fd::OwnedFd;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use bessemer_legs::firmware::{Firmware, Machine};
use bessemer_legs::panics::caught;
use bessemer_tests::toolchain::{self, Toolchain};
use cargo_bessemer::args::{Target, Verify};
use cargo_bessemer::verify;

/// On each leg the same bits; what cannot be called is named.
pub fn verified(package: &Path) {
    let source = package.join("src/lib.rs");
    let sound = fs::read_to_string(&source).expect("the model");
    let hidden = "mod hidden {\n    use bessemer::prelude::*;\n    /// Counts.\n    #[component]\n    \
        #[derive(Clone, Debug, Default, PartialEq)]\n    pub struct Count {\n        n: u8,\n    }\n    #[component]\n    \
        impl Count {\n        /// One more.\n        #[entry]\n        pub fn more(&mut self) {\n            self.n += 1;\n        }\n    }\n}\n";
    fs::write(&source, format!("{sound}\n{hidden}")).expect("the model");
    // One without an operating system and with the smallest of processors: others differ in their table's row alone.
    let bare = toolchain::is_asked_for("qemu-system-arm");
    let mut target = if bare { vec![Target::CortexM4f] } else { Vec::new() };
    let full = std::env::var("BESSEMER_FULL").is_ok_and(|value| value == "1");
    if full || toolchain::RISCV32.is_there() {
        target.push(Target::Riscv32);
    }
    let targets = target.len();
    let wanted = Verify { seed: 1, target, ..Verify::default() };
    let (text, agree) =
        verify::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(agree, "{text}");
    let legs = 2 + toolchain::host().len() + targets;
    let (legs_told, costs) = text.split_once("\n\n").unwrap_or((&text, ""));
    assert_eq!(legs_told.lines().count(), legs + 1, "{text}");
    assert_eq!(text.matches(" 0 words differ").count(), legs - 1, "{text}");
    if bare {
        assert!(costs.starts_with("on cortex-m4f: "), "{text}");
        let row = costs.lines().find(|line| line.contains("Motor::step")).unwrap_or_default();
        let figures: Vec<u32> =
            row.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        // Double precision is in software there.
        let [instructions, stack, longest] = figures[..] else { panic!("{text}") };
        assert!(instructions >= 100 && (8..512).contains(&stack), "{text}");
        assert!(longest >= instructions, "{text}");
    }
    assert!(text.contains("  Rust ") && text.contains("Count::more: not called"), "{text}");
    fs::write(&source, sound).expect("the model");
}

/// A log becomes the life of an entry point on each leg; what is wrong in it is reported at its line.
pub fn verified_by_a_recording(package: &Path) {
    let log = package.join("log.csv");
    let recorded = |speed: &str, target: u32| {
        let head = "time,speed,gains.proportional,gains.integral,gains.period,target";
        let rows = format!("0,0,0.1,0.5,0.005,{target}\n0.005,{speed},0.1,0.5,0.005,{target}\n");
        fs::write(&log, format!("{head}\n{rows}")).expect("the log");
        // By its name in the Rust and in the C.
        let entry = Some(if target == 100 { "Motor::step" } else { "motor_step" }.to_owned());
        let wanted = Verify { inputs: Some(log.clone()), entry, ..Verify::default() };
        verify::run(package, &wanted, false).map_err(|error| error.to_string())
    };
    let (text, agree) = recorded("12.5", 100).unwrap_or_else(|error| panic!("{error}"));
    assert!(agree && text.starts_with("1 entry points, 2 calls; "), "{text}");
    assert!(!text.contains("no call ran") && !text.contains("warning"), "{text}");
    // At its limit it does not integrate; and what lies in the folder is not what was compared.
    let source = fs::read_to_string(package.join("src/lib.rs")).expect("the model");
    let line = 1 + source.lines().take_while(|it| !it.contains("self.integral +=")).count();
    let c = package.join("generated/motor.c");
    let sound = fs::read_to_string(&c).expect("the C");
    fs::write(&c, sound.replace("integral +=", "integral -=")).expect("the C");
    let (text, agree) = recorded("12.5", 10_000).unwrap_or_else(|error| panic!("{error}"));
    fs::write(&c, sound).expect("the C");
    assert!(agree && text.contains("older than the models"), "{text}");
    let never = format!("Motor::step: no call ran motor/src/lib.rs: {line}\n");
    assert!(text.contains(&never), "{never}{text}");
    let said = recorded("fast", 100).expect_err("that is no number");
    assert!(said.ends_with("line 3: `fast` is no number, as `speed` has to be"), "{said}");
    fs::remove_file(&log).expect("the log");
}

/// Each table of the page of flight logs maps a log of its kind; the replayed table is a recording itself.
pub fn verified_by_flight_logs(package: &Path) {
    let root = bessemer_tests::root();
    let page = fs::read_to_string(root.join("docs/book/flight-logs.md")).expect("the page");
    let tables = page.split("```toml\n").skip(1).filter_map(|it| it.split("```").next());
    let samples = root.join("cli/src/verify/recording/flight/samples");
    let logs = [("px4.ulg", 111), ("ardupilot.bin", 48), ("betaflight.bbl", 190)];
    assert_eq!(tables.clone().count(), logs.len());
    let settings = package.join("bessemer.toml");
    let sound = fs::read_to_string(&settings).expect("the settings");
    let replayed = package.join("replayed.csv");
    for (table, (log, calls)) in tables.zip(logs) {
        fs::write(&settings, format!("{sound}\n{table}")).expect("the settings");
        let verified = |inputs: PathBuf, outputs: Option<PathBuf>| {
            let wanted = Verify { inputs: Some(inputs), outputs, ..Verify::default() };
            let outcome = verify::run(package, &wanted, false);
            outcome.unwrap_or_else(|error| panic!("{log}: {error}: {:?}", error.remedy()))
        };
        let (text, agree) = verified(samples.join(log), Some(replayed.clone()));
        let first = format!("1 entry points, {calls} calls; ");
        assert!(agree && text.starts_with(&first), "{log}: {text}");
        let table = fs::read_to_string(&replayed).expect("the table");
        let (head, rows) = table.split_once('\n').expect("a line of names");
        let names = "gains.proportional,gains.integral,gains.period,target,speed,out:result,out:self.integral,out:fault";
        assert_eq!((head, rows.lines().count()), (names, calls));
        let again = package.join("again.csv");
        fs::rename(&replayed, &again).expect("the table");
        let (text, agree) = verified(again.clone(), Some(replayed.clone()));
        assert!(agree && text.starts_with(&first), "{text}");
        assert_eq!(fs::read_to_string(&replayed).expect("the table"), table);
        for file in [&replayed, &again] {
            fs::remove_file(file).expect("the table");
        }
    }
    fs::write(&settings, sound).expect("the settings");
}

/// As a test of the package calls it; what is no input is reported.
pub fn verified_by_a_test(package: &Path) {
    // Its name is what counts here: the package is none of this program's.
    struct Motor;
    let gains = (0.05, 2.0, 1.0e-3);
    let inputs = (0..20).map(|n| (gains, 100.0, f64::from(n)));
    cargo_bessemer::same_bits_at::<Motor, _>(package, "step", inputs);
    let short = || cargo_bessemer::same_bits_at::<Motor, _>(package, "step", [(gains, 100.0)]);
    let said = caught(short).expect_err("an argument is missing");
    let expected =
        "`Motor::step` takes 5 numbers beside its component, and an input has 4; pass a tuple";
    assert!(said.starts_with(expected), "{said}");
}

/// A board's port, as a program of this machine has it: its standard input and output.
const PORT: &str = "#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>\n#include \"uart.h\"\n\
    void uart_open(void)\n{\n}\n\
    uint8_t uart_get(void)\n{\n    uint8_t byte;\n    if (read(0, &byte, 1) != 1) {\n        exit(0);\n    }\n    return byte;\n}\n\
    void uart_put(uint8_t byte)\n{\n    if (write(1, &byte, 1) != 1) {\n        exit(1);\n    }\n}\n";

/// Over serial lines: a program of this machine at the other end of a pseudo-terminal, and an emulated board's own port.
pub fn verified_on_a_board(package: &Path) {
    let folder = package.join("board");
    let wanted = Verify { board: Some(folder.clone()), ..Verify::default() };
    let (text, _) = verify::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(text.contains("-DLINK_MOST=1024") && folder.join("verify_main.c").is_file(), "{text}");

    let port = package.join("port.c");
    fs::write(&port, PORT).expect("the port");
    let files = fs::read_dir(&folder).expect("the sources").flatten().map(|it| it.path());
    let sources = files.filter(|it| it.extension().is_some_and(|it| it == "c")).chain([port]);
    let program = package.join("board-program");
    let include = format!("-I{}", folder.display());
    let flags = ["-DLINK_MOST=1024", "-D_POSIX_C_SOURCE=200112L", &include];
    toolchain::GCC
        .link(&sources.collect::<Vec<_>>(), &program, &flags)
        .unwrap_or_else(|said| panic!("{said}"));
    let (board, name) = pseudo_terminal();
    let mut command = Command::new(&program);
    command.stdin(board.try_clone().expect("a line")).stdout(board);
    let _program = Machine::from(command.spawn().expect("it starts"));
    let mut serial = vec![name];

    let zynq = Toolchain { emulator: Some(ZYNQ_AT_A_PORT), ..toolchain::ZYNQ };
    let firmware = zynq.programs().into_iter().all(toolchain::is_asked_for).then(|| {
        let board = [folder.clone(), bessemer_tests::root().join("examples/zynq/board")];
        Firmware::build(&board, &[], &[], &zynq).unwrap_or_else(|error| panic!("{error}"))
    });
    let _machine = firmware.as_ref().map(|firmware| {
        let mut emulator = zynq.runner(firmware.program());
        let mut emulator = emulator.stdout(Stdio::piped()).spawn().expect("it starts");
        let (mut said, output) = (String::new(), emulator.stdout.take().expect("a pipe"));
        BufReader::new(output).read_line(&mut said).expect("it says where its port is");
        let name = said.split_whitespace().find(|word| word.starts_with("/dev/"));
        serial.push(name.unwrap_or_else(|| panic!("{said}")).into());
        Machine::from(emulator)
    });
    let wanted = Verify { serial: serial.clone(), baud: 115_200, ..Verify::default() };
    let (text, agree) =
        verify::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(agree, "{text}");
    for port in serial {
        let row = text.lines().find(|line| line.contains(&*port.to_string_lossy()));
        assert!(row.is_some_and(|row| row.ends_with(" 0 words differ")), "{text}");
    }
    fs::remove_dir_all(&folder).expect("the sources");
}

/// The Zynq, whose serial port is one of this machine.
const ZYNQ_AT_A_PORT: &[&str] = &[
    "qemu-system-arm",
    "-machine",
    "xilinx-zynq-a9",
    "-display",
    "none",
    "-monitor",
    "none",
    "-m",
    "128M",
    "-serial",
    "null",
    "-serial",
    "pty",
    "-kernel",
];

/// A line whose one end is a port with a name.
fn pseudo_terminal() -> (OwnedFd, PathBuf) {
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    let board = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC);
    let board = board.expect("a pseudo-terminal");
    grantpt(&board).and_then(|()| unlockpt(&board)).expect("it is ours");
    let name = ptsname(&board, Vec::new()).expect("a name");
    (board, name.into_string().expect("a name").into())
}
