//! The complete onboard software on a bare Zynq, in lockstep with the plant over its serial line (`examples/zynq`).
//! Outputs and states are compared by bits, in real time, within the stack that `gen` reports; a failing line is
//! reported.

use std::io::{self, Read, Write};
use std::os::unix::net::UnixStream;
use std::sync::LazyLock;

use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, ZYNQ};
use bessemer_tests::{flight_models, texts};
use sim::computer::{Computer, Native};
use sim::flights::find;
use sim::scenario::{LEAD, Scenario};
use sim::voyage::follow;
use sim_program::board::{Board, Loaded};

/// Simulated part of the hover, s.
const FLOWN: f64 = 30.0;

/// The firmware, built once; none where the tools are not there and need not be.
fn loaded() -> Option<&'static Loaded> {
    static LOADED: LazyLock<Option<Loaded>> = LazyLock::new(|| {
        let asked =
            toolchain::is_asked_for("qemu-system-arm") && toolchain::is_asked_for(ZYNQ.compiler);
        asked
            .then(|| Loaded::zynq(flight_models(), &ZYNQ).unwrap_or_else(|error| panic!("{error}")))
    });
    if LOADED.is_none() {
        println!("left out: the tools of the bare Zynq are not installed");
    }
    LOADED.as_ref()
}

fn hover(seconds: f64) -> Scenario {
    let flight = find("hover").expect("a flight");
    Scenario { duration: seconds, ..(flight.scenario)(1) }
}

/// A digest of outputs and state of each period.
fn flown<C: Computer>(scenario: &Scenario, computer: &mut C) -> Vec<u64> {
    let mut sums = Vec::new();
    follow(scenario, computer, |_, computer| {
        sums.push(computer.digest());
        true
    });
    sums
}

/// Seconds that a process has had of a processor: what runs beside it takes none of them.
fn processor_time(process: u32) -> f64 {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).expect("it runs");
    // Behind the program's name, which may hold anything, the 12th and the 13th: in its own code, and in the system's.
    let (_, behind) = stat.rsplit_once(')').expect("a name");
    let ticks = behind.split_whitespace().skip(11).take(2);
    // Hundredths, whatever the kernel counts by.
    ticks.map(|it| it.parse::<f64>().expect("a number") / 100.0).sum()
}

#[test]
fn it_flies_the_same_bits_in_real_time_and_within_its_stack() {
    let Some(loaded) = loaded() else { return };
    let models = flight_models();
    let stacks: Vec<_> = models.entries.iter().map(|it| (&it.entry, it.stack_bytes)).collect();
    once("30 s on a bare Zynq", &(texts(&models.files), stacks), || fly_in_real_time(loaded));
}

fn fly_in_real_time(loaded: &Loaded) {
    let scenario = hover(FLOWN);
    let native = flown(&scenario, &mut Native::default());
    let mut board = loaded.start(|line| line).unwrap_or_else(|error| panic!("{error}"));
    let before = processor_time(board.machine.id());
    let bare = flown(&scenario, &mut board);
    let took = processor_time(board.machine.id()) - before;
    assert!(board.failure().is_none(), "{}", board.failure().expect("one"));
    let parted = native.iter().zip(&bare).position(|(here, there)| here != there);
    assert_eq!((parted, native.len()), (None, bare.len()));
    assert!(took <= FLOWN + LEAD, "{FLOWN} s of flight take {took:.1} s of a processor");

    let stack = board.stack().unwrap_or_else(|error| panic!("{error}"));
    let entries = &flight_models().entries;
    let entry = entries.iter().find(|it| it.entry == "onboard_step").expect("an entry point");
    assert!(stack.step > 0 && stack.step <= entry.stack_bytes, "{stack:?}, {}", entry.stack_bytes);
    assert!(stack.all < stack.size, "{stack:?}");
    println!("{} periods bit-equal in {took:.1} s of a processor; {stack:?}", bare.len());
}

/// A line on which one bit turns over, so many bytes on: of what is read, or of what is written.
struct Noisy {
    line: UnixStream,
    read: Option<usize>,
    written: Option<usize>,
}

fn turned(bytes: &mut [u8], at: &mut Option<usize>) {
    if let Some(left) = at {
        match bytes.get_mut(*left) {
            Some(byte) => {
                *byte ^= 0x10;
                *at = None;
            }
            None => *left -= bytes.len(),
        }
    }
}

impl Read for Noisy {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let count = self.line.read(to)?;
        turned(&mut to[..count], &mut self.read);
        Ok(count)
    }
}

impl Write for Noisy {
    fn write(&mut self, from: &[u8]) -> io::Result<usize> {
        let mut bytes = from.to_vec();
        turned(&mut bytes, &mut self.written);
        self.line.write_all(&bytes).map(|()| bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.line.flush()
    }
}

/// Periods until the lockstep is broken, a hundred at most, and what is said of it.
fn broken<L: Read + Write>(board: &mut Board<L>) -> String {
    let scenario = hover(1.0);
    follow(&scenario, board, |moment, board| board.failure().is_none() && moment.time < 0.0);
    board.failure().map(ToString::to_string).unwrap_or_default()
}

#[test]
fn a_garbled_line_is_told() {
    let Some(loaded) = loaded() else { return };
    let noisy = |read, written| {
        let start = loaded.start(|line| Noisy { line, read, written });
        broken(&mut start.unwrap_or_else(|error| panic!("{error}")))
    };
    let here = noisy(Some(5000), None);
    assert!(here.starts_with("in period ") && here.contains("is garbled: "), "{here}");
    let there = noisy(None, Some(5000));
    let expected = " the board says: a frame came garbled: its checksum is wrong";
    assert!(there.ends_with(expected), "{there}");
    assert_eq!(noisy(None, None), "");
}

#[test]
fn a_board_that_is_gone_is_told() {
    let Some(loaded) = loaded() else { return };
    let mut board = loaded.start(|line| line).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(broken(&mut board), "");
    board.machine.kill();
    assert_eq!(broken(&mut board), "in period 201: the line is closed: the other end is gone");
}
