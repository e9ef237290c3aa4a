//! The testbed together with the server: requests of pages are executed, and received messages are sent to pages.
//!
//! Invariant: nothing here waits. Requests of pages come from a queue of fixed length; messages to pages are handed
//! over without waiting; a recording has its own thread.

use crate::bench::{Period, Timing};
use crate::catalogue::{self, PAGE_SIGNALS, SIGNALS, UNUSED, parameters};
use crate::command::Seat;
use crate::events::{self, Event, Severity, Sight, Watch};
use crate::messages::{Ask, Charge, Point, Recording, State, Tell};
use crate::radio::Quality;
use crate::recorder::{Recorder, Unwritable};
use crate::refusal::{self, Situation};
use crate::server::Hub;
use crate::testbed::{Error, Testbed, period};
use crate::tools::Tool;
use models::Alarm;
use models::receiver::Sticks;
use models::trajectory::SetPoint;
use nalgebra::{Vector2, Vector3};
use sim::Aircraft;
use sim::ground_station::{News, Order, Record};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Capacity of the queue of requests: half a second of moving sticks.
const QUEUE_LENGTH: usize = 64;

/// Number of periods between two messages with the testbed's state.
const STATE_EVERY: u64 = 50;

/// The testbed, and the tools and pages that observe it.
pub struct Live {
    /// The testbed.
    pub testbed: Testbed,
    hub: Arc<Hub>,
    asked: Receiver<Ask>,
    recorder: Option<Recorder>,
    recorded: Recording,
    /// The last failure that [`failure`](Self::failure) returned.
    failed: Option<String>,
    folder: PathBuf,
    files: u32,
    tools: Vec<(Box<dyn Tool>, Seat)>,
    watch: Watch,
    /// True if a trajectory was sent that no flight has followed yet.
    planned: bool,
    /// True if the aircraft flew in the last period.
    flew: bool,
    /// Number of restarts of the software until the last period.
    restarts: u64,
    /// Events that have not been reported yet.
    events: Vec<Event>,
}

/// Creates the queue for requests of pages.
pub fn queue() -> (SyncSender<Ask>, Receiver<Ask>) {
    sync_channel(QUEUE_LENGTH)
}

/// Returns the first message to a page.
pub fn hello(aircraft: Aircraft, authenticated: bool) -> Tell {
    let space = aircraft.settings().space;
    Tell::Hello {
        signals: SIGNALS,
        parameters: parameters(aircraft),
        motors: aircraft.airframe().motors,
        fastest: aircraft.fastest(),
        wind: aircraft.wind(),
        // By number; an aircraft that is ready is armed, and after a flight it is not.
        phases: ["armed", "take off", "flight", "landing", "disarmed", "hold"]
            .map(String::from)
            .into(),
        alarms: [
            Alarm::Clear,
            Alarm::Commanded,
            Alarm::Undefined,
            Alarm::Clock,
            Alarm::Unmeasured,
            Alarm::Tilt,
            Alarm::Spin,
            Alarm::Speed,
            Alarm::Height,
            Alarm::Position,
            Alarm::Impact,
        ]
        .map(|it| spaced(&format!("{it:?}")))
        .into(),
        authenticated,
        space: [space.reach, space.heights.x, space.heights.y],
        period: period(),
    }
}

/// Converts `TakeOff` to `take off`.
fn spaced(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !text.is_empty() {
            text.push(' ');
        }
        text.extend(letter.to_lowercase());
    }
    text
}

impl Live {
    /// Creates a testbed whose requests arrive through `asked`; recordings are written to `folder`.
    pub fn new(testbed: Testbed, hub: Arc<Hub>, asked: Receiver<Ask>, folder: PathBuf) -> Self {
        let recorded = Recording::default();
        let tools = Vec::new();
        let (recorder, failed) = (None, None);
        let (watch, events) = (Watch::default(), Vec::new());
        Self {
            testbed,
            hub,
            asked,
            recorder,
            recorded,
            failed,
            folder,
            files: 0,
            tools,
            watch,
            planned: false,
            flew: false,
            restarts: 0,
            events,
        }
    }

    /// Adds an external tool.
    pub fn add(&mut self, tool: impl Tool + 'static) {
        self.tools.push((Box::new(tool), self.hub.seat()));
    }

    /// Starts a recording to a file.
    ///
    /// # Errors
    ///
    /// The file cannot be written.
    pub fn record(&mut self, path: PathBuf) -> Result<(), Unwritable> {
        self.save();
        let image = self.testbed.image().ok().flatten();
        self.recorder = Some(Recorder::start(
            path,
            self.testbed.bench.aircraft(),
            image,
            self.testbed.waits(),
        )?);
        Ok(())
    }

    /// Runs one period: executes requests, advances the testbed, and reports the results.
    ///
    /// # Errors
    ///
    /// The testbed ended.
    pub fn step(&mut self) -> Result<Period, Error> {
        if self.hub.take_stop() {
            let now = self.testbed.now();
            self.testbed.station.order(now, Order::Stop);
        }
        while let Ok(ask) = self.asked.try_recv() {
            self.obey(ask);
        }
        let (testbed, situation) = (&self.testbed, self.situation());
        let tools = self.tools.iter_mut();
        let asked: Vec<Ask> =
            tools.flat_map(|(tool, seat)| tool.listen(testbed, &situation, seat)).collect();
        asked.into_iter().for_each(|ask| self.obey(ask));
        let (done, news) = self.testbed.step()?;
        for record in news.iter().filter_map(|it| match it {
            News::Record(record) => Some(record),
            _ => None,
        }) {
            self.hub.tell(&self.frame(record));
        }
        for (tool, _) in &mut self.tools {
            tool.tell(&self.testbed, &situation, &done, &news);
        }
        while let Some((order, outcome)) = self.testbed.station.outcomes.pop_front() {
            if let Some((severity, text)) = events::outcome(&order, &outcome) {
                self.note(severity, text);
            }
            self.hub.tell(&Tell::Outcome { order, outcome });
        }
        self.events.extend(self.watch.look(&Sight::of(&self.testbed, &done)));
        self.follow();
        let events = std::mem::take(&mut self.events);
        for event in &events {
            self.hub.log(event);
            self.tools.iter_mut().for_each(|(tool, _)| tool.report(event));
        }
        if let Some(recorder) = &mut self.recorder {
            recorder.take(&done, events);
        }
        if done.number.is_multiple_of(STATE_EVERY) {
            let state = self.state();
            self.hub.tell(&Tell::State(Box::new(state)));
        }
        Ok(done)
    }

    /// Follows the flight: one that ended has used its trajectory up, and restarted software knows none.
    fn follow(&mut self) {
        let (flies, restarts) = (self.situation().is_flying(), self.testbed.restarts);
        self.planned &= (flies || !self.flew) && restarts == self.restarts;
        (self.flew, self.restarts) = (flies, restarts);
    }

    /// Returns the state of the flight on which refusals depend.
    fn situation(&self) -> Situation {
        let station = &self.testbed.station;
        Situation {
            phase: station.phase(),
            clear: station.signal(catalogue::ALARM) == f32::from(Alarm::Clear as u8),
            arming: station.is_arming(),
            planned: self.planned,
            silence: station.silence(self.testbed.now()),
            aircraft: self.testbed.bench.aircraft(),
            height: station.received(catalogue::PLACE).map(|[_, _, height]| height),
            speed: station.received(catalogue::VELOCITY).map(|it| Vector3::from(it).norm()),
            ages: station.received(catalogue::AGES),
        }
    }

    /// Finishes the recording, if there is one.
    pub fn save(&mut self) {
        let Some(recorder) = self.recorder.take() else { return };
        let path = recorder.path().to_owned();
        self.recorded = recorder.finish();
        if self.recorded.error.is_none() {
            self.hub.keep(path);
            self.recorded.ready = true;
        }
    }

    /// Returns the reason why a recording failed, once for each.
    pub fn failure(&mut self) -> Option<String> {
        let error = match &self.recorder {
            Some(recorder) => recorder.state().error,
            None => self.recorded.error.clone(),
        };
        let news = error.filter(|error| self.failed.as_ref() != Some(error))?;
        self.failed = Some(news.clone());
        Some(news)
    }

    /// Returns the statistics of the period's timing.
    pub fn timing(&self) -> Timing {
        self.testbed.bench.timing
    }

    /// Adds an event at the present time.
    fn note(&mut self, severity: Severity, text: impl Into<String>) {
        let time = self.testbed.now();
        self.events.push(Event { time, severity, text: text.into() });
    }

    fn frame(&self, record: &Record) -> Tell {
        let state = self.testbed.bench.state();
        let (place, angles) = (state.position, state.angles);
        Tell::Frame {
            period: record.period,
            signals: self.testbed.station.chosen().to_vec(),
            values: record.values.clone(),
            truth: [place.x, place.y, place.z, angles.x, angles.y, angles.z].map(|it| it as f32),
        }
    }

    fn state(&mut self) -> State {
        let situation = self.situation();
        let testbed = &self.testbed;
        let now = testbed.now();
        let (up, down) = testbed.counts();
        let station = &testbed.station;
        State {
            time: now,
            alive: testbed.bench.is_answered(),
            restarts: testbed.restarts,
            silence: station.silence(now),
            timing: testbed.bench.timing,
            up,
            down,
            heard: station.down,
            counts: station.status.as_ref().map(|status| status.counts),
            mode: station.status.as_ref().map(|status| status.mode),
            planned: self.planned,
            battery: Charge::of(testbed.bench.battery()),
            recordings: self.hub.recordings(),
            sensors: self.watch.sources().into(),
            checks: refusal::checks(&situation).into(),
            parameters: station.parameters.to_vec(),
            pages: self.hub.pages(),
            commanded: self.hub.is_commanded(),
            skipped: self.hub.skipped(),
            refused: self.tools.iter().map(|(tool, _)| tool.refused()).sum(),
            recording: match &self.recorder {
                Some(recorder) => recorder.state(),
                None => self.recorded.clone(),
            },
        }
    }

    /// Executes a request of a page, or reports why it is refused. Its sender has been checked; its content has not.
    fn obey(&mut self, ask: Ask) {
        let now = self.testbed.now();
        if let Some(reason) = refusal::reason(&ask, &self.situation()) {
            return self.note(Severity::Warning, reason);
        }
        match &ask {
            Ask::Fly { .. } => self.planned = true,
            Ask::Land => self.watch.land(),
            Ask::Kill => self.note(Severity::Info, "fault injection: onboard software stopped"),
            Ask::Inject { injection } => {
                if let Some(text) = events::injected(injection) {
                    self.note(Severity::Info, text);
                }
            }
            _ => {}
        }
        let station = &mut self.testbed.station;
        match ask {
            Ask::Claim { .. } | Ask::Release | Ask::Ping { .. } => {}
            Ask::Stop => station.order(now, Order::Stop),
            Ask::Arm => station.order(now, Order::Arm),
            Ask::Disarm => station.order(now, Order::Disarm),
            Ask::TakeOff => station.order(now, Order::TakeOff),
            Ask::Land => station.order(now, Order::Land),
            Ask::Mode { mode } => station.order(now, Order::Mode(mode.into())),
            Ask::Sticks { roll, pitch, yaw_rate, climb } => {
                let lean = Vector2::new(roll, pitch);
                station.order(now, Order::Sticks(Sticks { lean, yaw_rate, climb }));
            }
            Ask::Fly { points } => station.fly(now, points.iter().map(set_point).collect()),
            Ask::Set { number, value } => station.order(now, Order::Set(number, value)),
            Ask::Choose { every, signals } => {
                let mut chosen = [UNUSED; PAGE_SIGNALS.len()];
                chosen.iter_mut().zip(&signals).for_each(|(place, number)| *place = *number);
                station.choose(now, every, chosen);
            }
            Ask::Inject { injection } => self.testbed.inject(injection),
            Ask::Kill => self.testbed.kill(),
            Ask::Link { loss, duplication, reordering, delay } => {
                let quality = Quality { loss, duplication, reordering, delay };
                (self.testbed.up.quality, self.testbed.down.quality) = (quality, quality);
            }
            Ask::Record => {
                self.files += 1;
                let name = format!("flight-{}-{}.mcap", std::process::id(), self.files);
                if let Err(error) = self.record(self.folder.join(name)) {
                    self.recorded.error = Some(error.to_string());
                }
            }
            Ask::Save => self.save(),
            Ask::Play { .. } | Ask::Seek { .. } => {
                let reason = "a flight that goes on cannot be wound".into();
                self.hub.tell(&Tell::Refused { reason });
            }
        }
    }
}

fn set_point(point: &Point) -> SetPoint {
    let Point { time, x, y, z, yaw } = *point;
    SetPoint { time, position: Vector3::new(x, y, z), yaw }
}
