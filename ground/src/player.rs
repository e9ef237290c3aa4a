//! Shows a recorded flight in the page again: the frames of the recording, at the requested speed.
//!
//! Needs no software and no aircraft. The recording has every step completely, so every signal can be shown, even if
//! it was not part of the downlink.

use crate::bench::Worked;
use crate::catalogue::SIGNALS;
use crate::events::Event;
use crate::messages::{Ask, Flight, Playing, Tell};
use crate::recorded::Recorded;
use crate::recorder::{EVENTS, STEPS, event, step};
use crate::replay::Error;
use crate::seeds::{self, Seed};
use crate::server::Hub;
use models::onboard::signals;
use serde_json::Value;
use sim::scenario::LEAD;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::Receiver;

/// Number of periods between two frames: 50 Hz.
const DECIMATION: u64 = 4;

/// Real time between two reports of the player's position to the page, s.
const TOLD: f64 = 0.25;

/// The most samples of a flight that are shown as a whole: two minutes at 50 Hz, and fewer a second beyond.
const MOST_SAMPLES: usize = 6000;

/// The greatest speed at which a flight is shown.
const FASTEST: f64 = 16.0;

/// A frame of a recording.
#[derive(Clone, Debug)]
struct Frame {
    /// Time since the testbed began, s.
    time: f64,
    tell: Tell,
}

/// The player.
pub struct Player {
    frames: Vec<Frame>,
    /// Bytes without a whole chunk at the end of a truncated recording.
    pub missing: Option<usize>,
    hub: Arc<Hub>,
    requests: Receiver<Ask>,
    /// Time in the recording, s.
    time: f64,
    speed: f64,
    /// Index of the first frame that has not been shown.
    next: usize,
    untold: f64,
}

impl Player {
    /// Opens a recording; requests of pages arrive through `requests`.
    ///
    /// # Errors
    ///
    /// The recording cannot be read, or has nothing to show.
    pub fn open(path: &Path, hub: Arc<Hub>, requests: Receiver<Ask>) -> Result<Self, Error> {
        Self::of(&Recorded::read(path)?, path, hub, requests)
    }

    /// Opens a recording that was read from a file.
    ///
    /// # Errors
    ///
    /// The recording is damaged, or has nothing to show.
    pub fn of(
        recorded: &Recorded,
        path: &Path,
        hub: Arc<Hub>,
        requests: Receiver<Ask>,
    ) -> Result<Self, Error> {
        let (frames, missing) = (Vec::new(), None);
        let (time, speed, next, untold) = (0.0, 1.0, 0, TOLD);
        let mut player = Self { frames, missing, hub, requests, time, speed, next, untold };
        player.load(recorded, path)?;
        Ok(player)
    }

    /// Shows another recording from its start. If it cannot be shown, the one before stays.
    ///
    /// # Errors
    ///
    /// The recording is damaged, or has nothing to show.
    pub fn load(&mut self, recorded: &Recorded, path: &Path) -> Result<(), Error> {
        let Read { frames, events, missing } = read(recorded, path)?;
        let nothing = || match missing {
            Some(_) => Error::Cut { path: path.to_owned() },
            None => Error::Empty { path: path.to_owned() },
        };
        self.time = frames.first().ok_or_else(nothing)?.time;
        self.hub.show(whole(&frames), &events);
        (self.frames, self.missing, self.next, self.untold) = (frames, missing, 0, TOLD);
        Ok(())
    }

    /// Flies a seed that a person wants to see, records it in a folder, and shows it.
    pub fn fly(&mut self, seed: Seed, folder: &Path) {
        let shown = seeds::fly(seed.campaign, seed.seed, folder)
            .map_err(|error| error.to_string())
            .and_then(|path| {
                let recorded = Recorded::read(&path).map_err(|error| error.to_string())?;
                self.load(&recorded, &path).map_err(|error| error.to_string())
            });
        seed.answer(shown);
    }

    /// Returns the time in the recording, s, and the speed.
    pub fn playing(&self) -> Playing {
        let from = self.frames.first().map_or(0.0, |frame| frame.time);
        let to = self.frames.last().map_or(0.0, |frame| frame.time);
        Playing { from, to, time: self.time, speed: self.speed }
    }

    /// Advances by `passed` seconds of real time, and shows the frames that are due.
    pub fn step(&mut self, passed: f64) {
        while let Ok(ask) = self.requests.try_recv() {
            self.obey(&ask);
        }
        let Playing { to, .. } = self.playing();
        self.time = (self.time + passed * self.speed).min(to);
        while let Some(frame) = self.frames.get(self.next).filter(|it| it.time <= self.time) {
            self.hub.tell(&frame.tell);
            self.next += 1;
        }
        self.untold += passed;
        if self.untold >= TOLD {
            self.untold = 0.0;
            self.hub.tell(&Tell::Playing(self.playing()));
        }
    }

    fn obey(&mut self, ask: &Ask) {
        match *ask {
            Ask::Play { speed } if speed.is_finite() => self.speed = speed.clamp(0.0, FASTEST),
            Ask::Seek { time } if time.is_finite() => {
                let Playing { from, to, .. } = self.playing();
                self.time = time.clamp(from, to);
                // The frame there is shown even while it stands still, and the page forgets what came after it.
                let next = self.frames.partition_point(|frame| frame.time <= self.time);
                self.next = next.saturating_sub(1);
                self.untold = TOLD;
            }
            _ => {
                let reason = "a flight that is over takes no orders".into();
                self.hub.tell(&Tell::Refused { reason });
            }
        }
    }
}

/// Contents of a recording.
struct Read {
    frames: Vec<Frame>,
    events: Vec<Event>,
    /// Number of missing bytes of a truncated recording.
    missing: Option<usize>,
}

/// Reads a recording.
fn read(recorded: &Recorded, path: &Path) -> Result<Read, Error> {
    let broken = |source| Error::Mcap { path: path.to_owned(), source };
    let (mut frames, mut events, mut truth) = (Vec::new(), Vec::new(), [f32::NAN; 6]);
    for message in recorded.messages().map_err(broken)? {
        let message = message.map_err(|source| Error::Mcap { path: path.to_owned(), source })?;
        match message.channel.topic.as_str() {
            "/truth" => truth = seen(&message.data),
            STEPS => {
                let worked =
                    step(&message.data).ok_or_else(|| Error::Empty { path: path.to_owned() })?;
                if worked.count.is_multiple_of(DECIMATION) {
                    let time = message.log_time as f64 * 1e-9 - LEAD;
                    frames.push(Frame { time, tell: frame(&worked, truth) });
                }
            }
            EVENTS => events.extend(event(&message.data)),
            _ => {}
        }
    }
    Ok(Read { frames, events, missing: recorded.missing })
}

/// Returns a flight with as many samples as a page draws.
fn whole(frames: &[Frame]) -> Flight {
    let every = frames.len().div_ceil(MOST_SAMPLES).max(1);
    let mut flight = Flight {
        signals: SIGNALS.iter().map(|signal| signal.number).collect(),
        columns: vec![Vec::new(); SIGNALS.len()],
        ..Flight::default()
    };
    for frame in frames.iter().step_by(every) {
        let Tell::Frame { values, .. } = &frame.tell else { continue };
        flight.times.push(frame.time as f32);
        flight.columns.iter_mut().zip(values).for_each(|(column, value)| column.push(*value));
    }
    flight
}

/// Returns the message of a step with every signal.
fn frame(worked: &Worked, truth: [f32; 6]) -> Tell {
    let all = signals(&worked.outputs);
    let numbers = SIGNALS.iter().map(|signal| signal.number);
    let values = numbers.clone().map(|number| all[usize::from(number)] as f32).collect();
    let period = u32::try_from(worked.count).unwrap_or(u32::MAX);
    Tell::Frame { period, signals: numbers.collect(), values, truth }
}

/// Returns the true position of the aircraft; NaN if it is not recorded.
fn seen(message: &[u8]) -> [f32; 6] {
    let truth: Value = serde_json::from_slice(message).unwrap_or_default();
    ["x", "y", "z", "roll", "pitch", "yaw"]
        .map(|name| truth[name].as_f64().map_or(f32::NAN, |value| value as f32))
}
