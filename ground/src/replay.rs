//! Runs the onboard software again from a recording, and compares its outputs with the recorded ones, bit by bit.
//!
//! Needs no aircraft and no key: the recording has the packets that the gate accepted.

use crate::bench::{Answer, Worked, bytes};
use crate::program::{self, Boot, Program, Running};
use crate::recorded::Recorded;
use crate::recorder::{IMAGE, STEPS, step};
use crate::wait;
use bessemer::Plain;
use models::Outputs;
use sim::Aircraft;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, UdpSocket};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Timeout of an answer.
const ANSWER_TIMEOUT: Duration = Duration::from_secs(30);

/// Reason why a recording cannot be replayed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// It cannot be read.
    #[error("`{path}`: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// An error of the system.
        source: io::Error,
    },
    /// The file is not an MCAP file, or it is damaged.
    #[error("`{path}` is no sound MCAP file: {source}")]
    Mcap {
        /// The file.
        path: PathBuf,
        /// Error of the file.
        source: mcap::McapError,
    },
    /// The recording has no steps of the software.
    #[error(
        "`{path}` holds nothing to run again; `cargo xtask fly --record FILE` records what can be"
    )]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// The recording was cut off too early.
    #[error(
        "`{path}` was cut off before its first chunk was whole: there is nothing in it to run again"
    )]
    Cut {
        /// The file.
        path: PathBuf,
    },
    /// The recording does not start at the software's beginning, and has no memory image.
    #[error(
        "`{path}` begins after the software did, and without its memory: record from the beginning"
    )]
    Middle {
        /// The file.
        path: PathBuf,
    },
    /// The recording is of an aircraft that this version does not know.
    #[error(
        "`{path}` is a flight of `{name}`, which this version does not know: replay it with the version that recorded it"
    )]
    Aircraft {
        /// The file.
        path: PathBuf,
        /// Name of the aircraft.
        name: String,
    },
    /// The software could not be started.
    #[error(transparent)]
    Program(#[from] program::Error),
    /// The software does not answer.
    #[error("the onboard software does not answer: {0}")]
    Silent(io::Error),
}

/// First difference between a replay and its recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Steps since the software began.
    pub count: u64,
    /// Time since the testbed began, s.
    pub time: f64,
    /// Name of the signal.
    pub signal: String,
    /// Recorded and replayed value, as words.
    pub words: (u64, u64),
}

/// Result of a replay.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Number of steps that were replayed.
    pub steps: u64,
    /// Time of the last step, s.
    pub until: f64,
    /// Bytes without a whole chunk at the end of a truncated recording.
    pub missing: Option<usize>,
    /// The first difference.
    pub difference: Option<Difference>,
}

/// Runs the software again from a recording.
///
/// # Errors
/// The recording cannot be read, or the software does not run.
pub fn replay(program: &Program, path: &Path) -> Result<Report, Error> {
    let recorded = Recorded::read(path)?;
    let broken = |source| Error::Mcap { path: path.to_owned(), source };
    let aircraft = recorded.aircraft(path)?;
    let mut report = Report { missing: recorded.missing, ..Report::default() };
    let mut runner: Option<Runner> = None;
    let mut image = None;
    for message in recorded.messages().map_err(broken)? {
        let message = message.map_err(|source| Error::Mcap { path: path.to_owned(), source })?;
        if message.channel.topic == IMAGE {
            image = Some(message.data.to_vec());
        }
        if message.channel.topic != STEPS {
            continue;
        }
        let Some(recorded) = step(&message.data) else {
            return Err(Error::Empty { path: path.to_owned() });
        };
        if recorded.count == 0 {
            // The software began anew.
            runner = Some(Runner::start(program, aircraft)?);
        }
        if runner.is_none() {
            let Some(image) = image.take() else {
                return Err(Error::Middle { path: path.to_owned() });
            };
            let begun = Runner::start(program, aircraft)?;
            begun.send(&image)?;
            runner = Some(begun);
        }
        let Some(running) = &runner else { continue };
        let outputs = running.step(&recorded)?;
        report.steps += 1;
        let time = message.log_time as f64 * 1e-9 - sim::scenario::LEAD;
        report.until = time;
        report.difference = difference(&recorded, &outputs, time);
        if report.difference.is_some() {
            return Ok(report);
        }
    }
    let path = path.to_owned();
    match (report.steps, report.missing) {
        (0, Some(_)) => Err(Error::Cut { path }),
        (0, None) => Err(Error::Empty { path }),
        _ => Ok(report),
    }
}

/// Receives a datagram from the bus.
fn heard(bus: &UdpSocket, buffer: &mut [u8]) -> Result<(usize, SocketAddr), Error> {
    let heard =
        wait::receive(bus, buffer, Instant::now() + ANSWER_TIMEOUT).map_err(Error::Silent)?;
    heard.ok_or_else(|| Error::Silent(io::ErrorKind::TimedOut.into()))
}

/// The software and the other end of its bus.
struct Runner {
    bus: UdpSocket,
    computer: SocketAddr,
    _running: Running,
}

impl Runner {
    fn start(program: &Program, aircraft: Aircraft) -> Result<Self, Error> {
        let bus = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).map_err(Error::Silent)?;
        let port = bus.local_addr().map_err(Error::Silent)?.port();
        let running = program.start(&Boot { aircraft, ..Boot::on(port) })?;
        let (_, computer) = heard(&bus, &mut [0; 16])?;
        Ok(Self { bus, computer, _running: running })
    }

    fn send(&self, datagram: &[u8]) -> Result<(), Error> {
        self.bus.send_to(datagram, self.computer).map_err(Error::Silent).map(drop)
    }

    fn step(&self, recorded: &Worked) -> Result<Outputs, Error> {
        let mut all = vec![recorded.count];
        recorded.inputs.store(&mut |word| all.push(word));
        self.send(&bytes(&all))?;
        let mut buffer = [0; 4096];
        let (length, _) = heard(&self.bus, &mut buffer)?;
        let answer = Answer::read(&buffer[..length]);
        let nonsense = || Error::Silent(io::Error::other("it answers something else"));
        answer.map(|answer| answer.outputs).ok_or_else(nonsense)
    }
}

/// The first word that differs; all NaN are equal.
fn difference(recorded: &Worked, now: &Outputs, time: f64) -> Option<Difference> {
    let (then, now) = (bessemer_legs::words(&recorded.outputs), bessemer_legs::words(now));
    let plain = |word: u64| if f64::from_bits(word).is_nan() { u64::MAX } else { word };
    let place = then.iter().zip(&now).position(|(then, now)| plain(*then) != plain(*now))?;
    Some(Difference {
        count: recorded.count,
        time,
        signal: signal(place),
        words: (then[place], now[place]),
    })
}

/// Returns the name of the output at a word's index.
fn signal(place: usize) -> String {
    const PARTS: &[(&str, usize)] = &[
        ("command.motors", 8),
        ("command.speeds", 8),
        ("command.closed_loop", 8),
        ("command.feed_forward", 8),
        ("estimate.position", 3),
        ("estimate.angles", 3),
        ("estimate.velocity", 3),
        ("estimate.rates", 3),
        ("ages", 4),
        ("reference.target", 17),
        ("reference.phase", 1),
        ("reference.motors", 1),
        ("reference.time", 1),
        ("variances", 6),
        ("gain", 1),
        ("wish", 41),
        ("alarm", 1),
        ("downlink", 65),
    ];
    let mut left = place;
    for (name, length) in PARTS {
        if left < *length {
            return if *length == 1 { (*name).to_owned() } else { format!("{name}[{left}]") };
        }
        left -= length;
    }
    format!("word {place}")
}
