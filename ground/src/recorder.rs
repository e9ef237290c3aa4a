//! Records a flight as an MCAP file while it is flown.
//!
//! There are two kinds of topics. Those of `sim::recording` are JSON for Foxglove and PlotJuggler, at 50 Hz. For a
//! replay, `/image` is the software's memory at the beginning, and `/steps` has the words of its inputs and outputs
//! in each period. A thread writes the file. If that fails, or is too slow in real time, the recording ends with an
//! error, and the flight continues. In virtual time the flight waits for the disk.

use crate::bench::{Period, Worked};
use crate::events::{Event, Severity};
use crate::messages::Recording;
use crate::priority;
use bessemer_legs::{value, words};
use models::{Inputs, Outputs};
use sim::Aircraft;
use sim::computer::Native;
use sim::recording::Writer;
use sim::scenario::Scenario;
use sim::voyage::{Moment, follow};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SendError, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;

/// The topic of the software's steps.
pub const STEPS: &str = "/steps";

/// The topic of events, which Foxglove shows as a log.
pub const EVENTS: &str = "/events";

/// The topic of the software's memory.
pub const IMAGE: &str = "/image";

/// The key of the aircraft's name in the metadata of each topic.
pub const AIRCRAFT: &str = "aircraft";

/// Periods that may wait for the disk: five seconds.
const WAITING: usize = 1000;

/// Number of periods of which one is recorded in the human-readable topics.
const DECIMATION: u64 = 4;

/// Error: the file of a recording cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("the recording `{path}` cannot be written: {source}")]
pub struct Unwritable {
    pub(crate) path: PathBuf,
    pub(crate) source: std::io::Error,
}

/// Item of the writing thread's queue.
struct Page {
    shown: Option<Moment>,
    worked: Vec<(f64, Worked)>,
    events: Vec<(f64, Event)>,
}

/// A recording that is being made.
pub struct Recorder {
    path: PathBuf,
    pages: Option<SyncSender<Page>>,
    writer: Option<JoinHandle<()>>,
    error: Arc<Mutex<Option<String>>>,
    broken: Arc<AtomicBool>,
    periods: u64,
    waits: bool,
}

impl Recorder {
    /// Starts to write a file about a flight of an aircraft. `image` is the memory of software that already runs. With `waits`, the caller waits
    /// for the disk.
    ///
    /// # Errors
    ///
    /// The file cannot be written.
    pub fn start(
        path: PathBuf,
        aircraft: Aircraft,
        image: Option<Vec<u8>>,
        waits: bool,
    ) -> Result<Self, Unwritable> {
        let file = created(&path)?;
        let (pages, waiting) = sync_channel(WAITING);
        let (error, broken) = (Arc::new(Mutex::new(None)), Arc::new(AtomicBool::new(false)));
        let (said, there, place) = (error.clone(), broken.clone(), path.clone());
        let writer = std::thread::spawn(move || {
            priority::lower();
            if let Err(reason) = write(file, aircraft, image.as_deref(), &waiting) {
                there.store(true, Ordering::Relaxed);
                if let Ok(mut said) = said.lock() {
                    *said = Some(format!("`{}`: {}", place.display(), whole(reason.as_ref())));
                }
            }
        });
        let (pages, writer) = (Some(pages), Some(writer));
        Ok(Self { path, pages, writer, error, broken, periods: 0, waits })
    }

    /// Returns the path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Hands over a period and its events; does nothing if the recording has ended.
    pub fn take(&mut self, done: &Period, events: Vec<Event>) {
        let time = done.moment.time;
        let shown = is_shown(done).then(|| done.moment.clone());
        let worked = done.worked().map(|worked| (time, worked)).collect();
        let Some(pages) = &self.pages else { return };
        let events = events.into_iter().map(|event| (time, event)).collect();
        let page = Page { shown, worked, events };
        let sent = match self.waits {
            true => pages.send(page).map_err(|SendError(page)| TrySendError::Disconnected(page)),
            false => pages.try_send(page),
        };
        match sent {
            Ok(()) => self.periods += 1,
            Err(TrySendError::Full(_)) => {
                self.fail("the disk does not keep up");
            }
            Err(TrySendError::Disconnected(_)) => self.pages = None,
        }
    }

    /// Returns the state of the recording.
    pub fn state(&self) -> Recording {
        let error = self.error.lock().ok().and_then(|error| error.clone());
        let running = self.pages.is_some() && !self.broken.load(Ordering::Relaxed);
        Recording { running, periods: self.periods, error, ready: false }
    }

    /// Finishes the file. The returned state has the error, if any.
    pub fn finish(mut self) -> Recording {
        self.end();
        self.state()
    }

    /// Finishes the file, unless it is finished.
    fn end(&mut self) {
        self.pages = None;
        if let Some(writer) = self.writer.take()
            && writer.join().is_err()
        {
            self.fail("the writer ended");
        }
    }

    fn fail(&mut self, reason: &str) {
        self.pages = None;
        if let Ok(mut error) = self.error.lock() {
            error.get_or_insert_with(|| format!("`{}`: {reason}", self.path.display()));
        }
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        self.end();
    }
}

/// Flies a scenario by the models, as fast as it goes, and records it as a live flight is recorded.
///
/// # Errors
///
/// The file cannot be written.
pub fn simulated(scenario: &Scenario, path: PathBuf) -> Result<(), Unwritable> {
    let mut recorder = Recorder::start(path.clone(), Aircraft::Mambo, None, true)?;
    let mut number = 0;
    follow(scenario, &mut Native::default(), |moment, _| {
        let (moment, count) = (moment.clone(), Some(number));
        let period = Period { number, count, moment, addressee: None, late: Vec::new() };
        recorder.take(&period, Vec::new());
        number += 1;
        recorder.state().error.is_none()
    });
    match recorder.finish().error {
        None => Ok(()),
        Some(error) => Err(Unwritable { path, source: std::io::Error::other(error) }),
    }
}

/// Checks that a recording can be written to a file, without changing its contents.
///
/// # Errors
///
/// It cannot be written.
pub fn check(path: &Path) -> Result<(), Unwritable> {
    let opened = File::options().write(true).create(true).truncate(false).open(path);
    opened.map(drop).map_err(|source| Unwritable { path: path.to_owned(), source })
}

/// Creates the file of a recording, or empties it.
fn created(path: &Path) -> Result<File, Unwritable> {
    File::create(path).map_err(|source| Unwritable { path: path.to_owned(), source })
}

/// Returns true if a period is recorded in the human-readable topics.
pub fn is_shown(done: &Period) -> bool {
    done.number.is_multiple_of(DECIMATION)
}

/// Returns an error with its causes.
fn whole(error: &dyn std::error::Error) -> String {
    match error.source() {
        Some(source) => format!("{error}: {}", whole(source)),
        None => error.to_string(),
    }
}

/// Writes items from the queue until it is closed.
fn write(
    file: File,
    aircraft: Aircraft,
    image: Option<&[u8]>,
    pages: &Receiver<Page>,
) -> Result<(), Box<dyn std::error::Error>> {
    let file = BufWriter::new(file);
    let about = [("flight", "live"), (AIRCRAFT, aircraft.name())];
    let about = BTreeMap::from(about.map(|(key, value)| (key.to_owned(), value.to_owned())));
    let mut writer = Writer::new(file, &about)?;
    writer.raw(STEPS, "words", "u64: steps since the software began, inputs, outputs")?;
    writer.raw(IMAGE, "image", "the memory of the program that /steps are of")?;
    writer.json(EVENTS, "foxglove.Log", LOG)?;
    if let Some(image) = image {
        writer.bytes(IMAGE, 0.0, image)?;
    }
    while let Ok(Page { shown, worked, events }) = pages.recv() {
        if let Some(moment) = shown {
            writer.moment(&moment)?;
        }
        for (time, worked) in worked {
            let all = [vec![worked.count], words(&worked.inputs), words(&worked.outputs)].concat();
            writer.bytes(STEPS, time, &crate::bench::bytes(&all))?;
        }
        for (time, event) in events {
            writer.bytes(EVENTS, time, log(&event).to_string().as_bytes())?;
        }
    }
    writer.finish()?;
    Ok(())
}

/// JSON schema of `foxglove.Log`.
const LOG: &str = r#"{"type":"object","properties":{"timestamp":{"type":"object","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"level":{"type":"integer"},"message":{"type":"string"},"name":{"type":"string"},"file":{"type":"string"},"line":{"type":"integer"}}}"#;

/// Returns an event as a `foxglove.Log`, whose levels are 2 for information, 3 for a warning, 5 for a fatal error.
fn log(event: &Event) -> serde_json::Value {
    let level = match event.severity {
        Severity::Info => 2,
        Severity::Warning => 3,
        Severity::Critical => 5,
    };
    let nanoseconds = (event.time * 1e9) as u64;
    let (sec, nsec) = (nanoseconds / 1_000_000_000, nanoseconds % 1_000_000_000);
    let timestamp = serde_json::json!({ "sec": sec, "nsec": nsec });
    serde_json::json!({
        "timestamp": timestamp, "level": level, "message": event.text, "name": "flight", "file": "", "line": 0,
    })
}

/// Returns the event of a message of the topic [`EVENTS`]; none for any other bytes.
pub fn event(bytes: &[u8]) -> Option<Event> {
    let log: serde_json::Value = serde_json::from_slice(bytes).ok()?;
    let severity = match log["level"].as_u64()? {
        0..=2 => Severity::Info,
        3 => Severity::Warning,
        _ => Severity::Critical,
    };
    let part = |name: &str| log["timestamp"][name].as_f64();
    let time = part("sec")? + part("nsec")? * 1e-9;
    Some(Event { time, severity, text: log["message"].as_str()?.to_owned() })
}

/// Parses a recorded step of the software; `None` if the bytes are not one.
pub fn step(bytes: &[u8]) -> Option<Worked> {
    let all: Vec<u64> = bytes
        .chunks_exact(8)
        .map(|eight| u64::from_le_bytes(eight.try_into().unwrap_or_default()))
        .collect();
    let (inputs, outputs) = (words(&Inputs::default()).len(), words(&Outputs::default()).len());
    if bytes.len() != 8 * (1 + inputs + outputs) {
        return None;
    }
    let (taken, said) = all[1..].split_at(inputs);
    Some(Worked { count: all[0], inputs: value(taken), outputs: value(said) })
}
