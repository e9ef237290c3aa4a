//! The other end of MAVLink is pymavlink: a mission flown by it alone, in time that waits for the software.

use ground::live::{self, Live};
use ground::program::{Program, Target};
use ground::server::Hub;
use ground::testbed::{Pace, Testbed, Wanted};
use ground::tools::mavlink::{Mavlink, Signature};
use models::Alarm;
use std::io::{BufRead, BufReader, Lines};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Path at which `cargo xtask test --full --install` installs it.
const PYTHON: &str = "target/python/bin/python";

/// Key with which both ends sign.
const SECRET: [u8; 32] = *b"a secret of thirty-two bytes, eh";

fn flown(seed: u64) -> (Live, Arc<Hub>) {
    let program = Program::build(&bessemer_legs::root(), Target::Native)
        .unwrap_or_else(|error| panic!("{error}"));
    let wanted = Wanted { pace: Pace::Patient, seed, ..Wanted::default() };
    let testbed = Testbed::start(&program, &wanted).unwrap_or_else(|error| panic!("{error}"));
    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    (Live::new(testbed, hub.clone(), asks, std::env::temp_dir()), hub)
}

/// pymavlink with a script, and the port at which it listens; none, if it is not here.
fn pymavlink(root: &Path) -> Option<(Child, u16, Lines<BufReader<ChildStdout>>)> {
    let python = root.join(PYTHON);
    if !python.exists() {
        println!("left out: there is no {}", python.display());
        return None;
    }
    let mut child = Command::new(python)
        .arg(root.join("ground/tests/pymavlink/mission.py"))
        .arg(SECRET.map(|byte| format!("{byte:02x}")).concat())
        .stdout(Stdio::piped())
        .spawn()
        .expect("python starts");
    let mut lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    let port = lines.next().and_then(Result::ok).and_then(|line| line.parse().ok());
    Some((child, port.expect("it says where it listens"), lines))
}

/// Returns a channel of the printed lines.
fn said(lines: Lines<BufReader<ChildStdout>>) -> Receiver<String> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        lines.map_while(Result::ok).all(|line| sender.send(line).is_ok());
    });
    receiver
}

#[test]
fn pymavlink_alone_flies_a_mission() {
    let root = bessemer_legs::root();
    let Some((mut child, port, lines)) = pymavlink(&root) else { return };
    let (mut live, hub) = flown(1);
    let signature = Signature::new(SECRET);
    live.add(Mavlink::start(([127, 0, 0, 1], port).into(), signature).expect("a port"));
    let lines = said(lines);
    let mut seen = Vec::new();
    loop {
        live.step().unwrap_or_else(|error| panic!("{error}"));
        match lines.try_recv() {
            Ok(line) => {
                // What it takes for x, y and z of the room is so in truth.
                let place = live.testbed.bench.state().position;
                if line == "it is there" {
                    assert!(
                        (place - nalgebra::Vector3::new(0.8, -0.4, 1.2)).norm() < 0.2,
                        "{place}"
                    );
                    assert!(hub.is_commanded());
                }
                seen.push(line);
            }
            Err(TryRecvError::Empty) => {}
            Err(TryRecvError::Disconnected) => break,
        }
    }
    let status = child.wait().expect("it has ended");
    assert!(status.success() && seen.last().is_some_and(|it| it == "flown"), "{seen:#?}");
    assert_eq!(live.testbed.station.signal(35), f32::from(Alarm::Commanded as u8));
}
