//! The program as its operator runs it: signals, failing recordings, truncated recordings.
//!
//! Flies in real time until the first frame comes down. No test depends on kept periods.

use ground::program::{Program, Target};
use ground::recorded::Recorded;
use ground::recorder::{Recorder, STEPS};
use ground::replay::replay;
use ground::testbed::{Pace, Testbed, Wanted};
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Time limit of a wait. Only a broken program exceeds it.
const LIMIT: Duration = Duration::from_secs(120);

fn fly(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ground"));
    command.args(["fly", "--headless", "--port", "0"]).args(arguments);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn ended(command: &mut Command) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = command.output().expect("it starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (status.code(), text(&stdout), text(&stderr))
}

fn kill(signal: &str, process: u32) -> bool {
    let mut command = Command::new("kill");
    command.args([signal, &process.to_string()]).stderr(Stdio::null());
    command.status().expect("it starts").success()
}

/// A program that flies and records.
struct Flying {
    child: Child,
    /// The process of its onboard software.
    software: u32,
}

impl Flying {
    /// Starts it, and waits until it is in the middle of it.
    fn start(recording: &Path) -> Self {
        let mut child =
            fly(&["--record", &recording.to_string_lossy()]).spawn().expect("it starts");
        let mut lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
        let address = lines.next().and_then(Result::ok).expect("it says where its page is");
        let (host, _) =
            address.strip_prefix("http://").and_then(|it| it.split_once('/')).expect("one");
        let (mut page, _) = tungstenite::connect(format!("ws://{host}/live")).expect("it listens");
        // A frame of the page comes down from the aircraft.
        while !page.read().expect("it speaks").to_text().is_ok_and(|it| it.contains("\"frame\"")) {}
        let listed = Command::new("ps").args(["-A", "-o", "pid=,ppid="]).output().expect("ps");
        let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
        let software = listed.lines().find_map(|line| {
            let mut numbers = line.split_whitespace().map(|it| it.parse::<u32>().ok());
            let (process, parent) = (numbers.next()??, numbers.next()??);
            (parent == child.id()).then_some(process)
        });
        Self { software: software.expect("it has started its software"), child }
    }
}

#[test]
fn each_signal_to_end_leaves_a_whole_recording() {
    let folder = tempfile::tempdir().expect("a folder");
    for signal in ["-INT", "-TERM", "-HUP"] {
        let path = folder.path().join(format!("flight{signal}.mcap"));
        let Flying { mut child, software } = Flying::start(&path);
        assert!(kill(signal, child.id()));
        let status = child.wait().expect("it is ours");
        assert!(!kill("-0", software), "{signal}: the software outlives it");
        let mut said = String::new();
        child.stderr.take().expect("it is piped").read_to_string(&mut said).expect("text");
        assert_eq!(status.code(), Some(0), "{signal}: {said}");
        assert_eq!(Recorded::read(&path).expect("a recording").missing, None, "{signal}");
        let report = replay(&built(), &path).unwrap_or_else(|error| panic!("{signal}: {error}"));
        assert!(report.steps > 0 && report.difference.is_none(), "{signal}: {report:?}");
    }
}

#[test]
fn whoever_kills_it_kills_the_software() {
    let folder = tempfile::tempdir().expect("a folder");
    let Flying { mut child, software } = Flying::start(&folder.path().join("flight.mcap"));
    assert!(kill("-KILL", child.id()));
    child.wait().expect("it is ours");
    let begun = Instant::now();
    while kill("-0", software) {
        assert!(begun.elapsed() < LIMIT, "it outlives its parent");
    }
}

#[test]
fn an_unwritable_recording_is_refused_before_the_flight() {
    let (code, stdout, stderr) = ended(&mut fly(&["--record", "/no/such/folder/flight.mcap"]));
    assert_eq!((code, stdout.as_str()), (Some(2), ""), "{stderr}");
    assert!(
        stderr
            .starts_with("error: the recording `/no/such/folder/flight.mcap` cannot be written: "),
        "{stderr}"
    );
}

#[test]
fn a_recording_that_fails_is_reported_by_text_and_exit_code() {
    let (code, stdout, stderr) = ended(&mut fly(&["--record", "/dev/full", "--seconds", "0.5"]));
    assert_eq!(code, Some(1), "{stderr}");
    assert!(stdout.contains("100 periods of 5 ms"), "the flight goes on: {stdout}");
    assert!(stderr.contains("the recording has ended: `/dev/full`: "), "{stderr}");
    assert!(stderr.contains("No space left"), "{stderr}");
}

fn built() -> Program {
    Program::build(&bessemer_legs::root(), Target::Native).unwrap_or_else(|error| panic!("{error}"))
}

/// A recording of some chunks.
fn recorded(folder: &Path) -> PathBuf {
    let path = folder.join("flight.mcap");
    let wanted = Wanted { pace: Pace::Virtual, ..Wanted::default() };
    let mut testbed = Testbed::start(&built(), &wanted).unwrap_or_else(|error| panic!("{error}"));
    let recorder = Recorder::start(path.clone(), sim::Aircraft::Mambo, None, true);
    let mut recorder = recorder.unwrap_or_else(|error| panic!("{error}"));
    let run = testbed.run_until(6.0, |done, _| recorder.take(done, Vec::new()));
    run.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);
    path
}

/// The steps in a recording, as bytes, and whether something of it is missing.
fn steps(path: &Path) -> (Vec<Vec<u8>>, bool) {
    let recorded = Recorded::read(path).unwrap_or_else(|error| panic!("{error}"));
    let messages = recorded.messages().expect("a recording");
    let messages = messages.map(|message| message.expect("it is whole"));
    let steps = messages.filter(|message| message.channel.topic == STEPS);
    (steps.map(|message| message.data.to_vec()).collect(), recorded.missing.is_some())
}

#[test]
fn of_a_recording_that_was_cut_off_the_whole_chunks_are_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = recorded(folder.path());
    let bytes = std::fs::read(&path).expect("the recording");
    let (all, cut) = steps(&path);
    assert_eq!((all.len(), cut), (1200, false));

    let cut = folder.path().join("cut.mcap");
    let mut lengths = std::collections::BTreeSet::new();
    let places = (1..40).map(|n| bytes.len() * n / 40);
    for place in places.chain([8, 9, 17, bytes.len() - 1, bytes.len() - 8]) {
        // A killed program leaves no zeros, a disk may leave some in unwritten blocks.
        for zeros in [0, 5000] {
            let left = [&bytes[..place], &vec![0; zeros][..]].concat();
            std::fs::write(&cut, left).expect("the folder");
            let (steps, missing) = steps(&cut);
            assert!(all.starts_with(&steps) && missing, "{place}: {} steps", steps.len());
            lengths.insert(steps.len());
        }
    }
    assert!(lengths.len() > 2 && lengths.contains(&0) && lengths.contains(&1200), "{lengths:?}");

    std::fs::write(&cut, &bytes[..bytes.len() * 3 / 4]).expect("the folder");
    let report = replay(&built(), &cut).unwrap_or_else(|error| panic!("{error}"));
    assert!(report.steps > 0 && report.steps < 1200 && report.difference.is_none(), "{report:?}");
    assert!(report.missing.is_some_and(|missing| missing > 0), "{report:?}");
    let mut command = Command::new(env!("CARGO_BIN_EXE_ground"));
    let (code, stdout, stderr) = ended(command.arg("replay").arg(&cut));
    assert_eq!(code, Some(0), "{stderr}");
    assert!(stdout.contains("every output the same bits"), "{stdout}");
    assert!(stderr.starts_with("the recording was cut off: it ends at "), "{stderr}");

    std::fs::write(&cut, &bytes[..2000]).expect("the folder");
    let error = replay(&built(), &cut).expect_err("nothing of it is whole").to_string();
    assert!(
        error.ends_with(
            "was cut off before its first chunk was whole: there is nothing in it to run again"
        ),
        "{error}"
    );
    std::fs::write(&cut, "no recording").expect("the folder");
    let error = replay(&built(), &cut).expect_err("it is none").to_string();
    assert!(error.contains("is no sound MCAP file"), "{error}");
}
