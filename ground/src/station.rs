//! The ground's end of the link: it sends commands and receives telemetry.
//!
//! A link loses packets, so a command is repeated until the telemetry shows that it was executed, or, if it changes
//! the flight, until a timeout. Heartbeats are sent ten times a second, so that the aircraft knows that the ground
//! station is there.
//!
//! The station knows the time only from its callers.

use crate::catalogue::{self, PAGE_SIGNALS};
use crate::key::Key;
use models::packet::Packet;
use models::tuning::PARAMETER_COUNT;
use models::{Alarm, Phase};
use serde::Serialize;
use sim::ground_station::{Collector, Framer, News, Order, Record, Status};
use std::collections::VecDeque;

/// Period of the heartbeat, s.
const HEARTBEAT_PERIOD: f64 = 0.1;

/// Period after which a command is repeated, s: half of that of the state of the link.
const RETRY_PERIOD: f64 = 0.25;

/// Time after which a command that is not confirmed fails, s.
const RETRY_TIMEOUT: f64 = 5.0;

/// Silence after which the peer may be a restarted software that does not know this station, s.
const PEER_RESET_SILENCE: f64 = 1.0;

/// Period of the logged signals, in control periods: 50 Hz.
const SIGNAL_DECIMATION: u8 = 4;

/// Result of a command.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// The command was executed.
    Done,
    /// The command was not confirmed in time.
    GivenUp,
    /// The aircraft rejected the command.
    Refused,
}

/// A command that is not confirmed yet.
#[derive(Clone, Debug)]
struct Pending {
    order: Order,
    /// True if it was sent again.
    repeated: bool,
    again: f64,
    until: f64,
}

/// Counters of the downlink's packets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Down {
    /// Number of received packets.
    pub heard: u64,
    /// Number of datagrams that were not packets.
    pub broken: u64,
    /// Number of missing packets, derived from the packets' numbers.
    pub missing: u64,
}

/// The ground station.
#[derive(Debug)]
pub struct Station {
    key: Option<Key>,
    /// Signals that are received unless others are selected.
    page: [u8; 36],
    counter: u64,
    framer: Framer,
    collector: Collector,
    outbox: VecDeque<Packet>,
    pending: Vec<Pending>,
    next_beat: f64,
    tag: u8,
    sequence: Option<u16>,
    heard_at: Option<f64>,
    signals: Vec<(u8, [u8; 36])>,
    values: [f32; 64],
    record: Option<Record>,
    /// State of the uplink as the aircraft reports it.
    pub status: Option<Status>,
    /// Values of the parameters; `None` for those not received yet.
    pub parameters: [Option<f64>; PARAMETER_COUNT],
    /// Statistics of the downlink.
    pub down: Down,
    /// Results of commands, for display.
    pub outcomes: VecDeque<(String, Outcome)>,
}

impl Station {
    /// Creates a ground station at a time, s, that receives the signals `page` unless others are selected.
    pub fn new(key: Option<Key>, page: [u8; 36], now: f64) -> Self {
        let mut station = Self {
            key,
            page,
            counter: 0,
            framer: Framer::default(),
            collector: Collector::default(),
            outbox: VecDeque::new(),
            pending: Vec::new(),
            next_beat: now,
            tag: 0,
            sequence: None,
            heard_at: None,
            // What the onboard software begins with.
            signals: vec![(0, std::array::from_fn(|n| n as u8))],
            values: disarmed(),
            record: None,
            status: None,
            parameters: [None; PARAMETER_COUNT],
            down: Down::default(),
            outcomes: VecDeque::new(),
        };
        station.meet(now);
        station
    }

    /// Opens the link to an aircraft that may not know this station: at the start, and after silence.
    fn meet(&mut self, now: f64) {
        self.order(now, Order::Hello);
        self.choose(now, SIGNAL_DECIMATION, self.page);
        for number in 0..PARAMETER_COUNT {
            self.order(now, Order::Ask(number as u8));
        }
    }

    /// Returns true if commands are sealed.
    pub fn is_authenticated(&self) -> bool {
        self.key.is_some()
    }

    /// Returns the time since the last packet of the downlink, s.
    pub fn silence(&self, now: f64) -> Option<f64> {
        self.heard_at.map(|at| now - at)
    }

    fn is_strange(&self, now: f64) -> bool {
        self.silence(now).is_some_and(|silence| silence > PEER_RESET_SILENCE)
    }

    /// Returns the last received value of a signal.
    pub fn signal(&self, number: u8) -> f32 {
        self.values.get(usize::from(number)).copied().unwrap_or(f32::NAN)
    }

    /// Returns the last values of signals, if all of them are received.
    pub fn received<const N: usize>(&self, signals: [u8; N]) -> Option<[f64; N]> {
        let known = signals.iter().all(|it| self.chosen().contains(it));
        known.then(|| signals.map(|it| f64::from(self.signal(it))))
    }

    /// Returns the numbers of the received signals, in order.
    pub fn chosen(&self) -> &[u8; 36] {
        let tag = self.record.as_ref().map_or(0, |record| record.tag);
        self.layout(tag).unwrap_or(&PAGE_SIGNALS)
    }

    /// Returns the last record.
    pub fn record(&self) -> Option<&Record> {
        self.record.as_ref()
    }

    /// Returns the phase of the flight, as far as it is known.
    pub fn phase(&self) -> u8 {
        self.signal(catalogue::PHASE) as u8
    }

    /// Returns true if the command to arm is not confirmed yet.
    pub fn is_arming(&self) -> bool {
        self.pending.iter().any(|it| it.order == Order::Arm)
    }

    /// Selects the signals of the downlink and their period.
    pub fn choose(&mut self, now: f64, every: u8, signals: [u8; 36]) {
        self.tag = self.tag.wrapping_add(1).max(1);
        self.signals.push((self.tag, signals));
        if self.signals.len() > 16 {
            self.signals.remove(1);
        }
        self.order(now, Order::Choose(self.tag, every, signals));
    }

    /// Sends a trajectory. Its number differs from all in use, since a restarted station must not take another's for
    /// its own.
    pub fn fly(&mut self, now: f64, points: Vec<models::trajectory::SetPoint>) {
        let flown = self.status.as_ref().map(|status| status.tag);
        while {
            self.tag = self.tag.wrapping_add(1).max(1);
            flown == Some(self.tag)
        } {}
        self.order(now, Order::FlyAs(self.tag, points));
    }

    /// Sends a command and repeats it until it is confirmed.
    pub fn order(&mut self, now: f64, order: Order) {
        match order {
            // Nobody repeats where a stick was.
            Order::Sticks(_) | Order::Raw(_) | Order::Beat => return self.send(&order),
            // What was wanted before is not wanted any more.
            Order::Stop | Order::Arm | Order::Disarm => {
                self.pending.retain(|it| !is_course(&it.order));
                self.outbox.clear();
            }
            Order::Land => self.pending.retain(|it| it.order != Order::TakeOff),
            _ => {}
        }
        self.pending.retain(|it| !replaces(&order, &it.order));
        self.send(&order);
        let until = if is_lasting(&order) { f64::INFINITY } else { now + RETRY_TIMEOUT };
        let again = now + RETRY_PERIOD;
        self.pending.push(Pending { order, repeated: false, again, until });
    }

    /// Returns the datagram to be sent now, if any; `clock` is the time in milliseconds since 1970.
    pub fn tick(&mut self, now: f64, clock: u64) -> Option<Vec<u8>> {
        if now >= self.next_beat {
            self.next_beat = now + HEARTBEAT_PERIOD;
            self.send(&Order::Beat);
        }
        if self.is_strange(now) && !self.pending.iter().any(|it| it.order == Order::Hello) {
            self.order(now, Order::Hello);
        }
        let mut due = Vec::new();
        for waiting in &mut self.pending {
            if now >= waiting.again {
                waiting.again = now + RETRY_PERIOD;
                waiting.repeated = true;
                due.push(waiting.order.clone());
            }
        }
        for order in due {
            self.send(&order);
        }
        self.give_up(now);
        let packet = self.outbox.pop_front()?;
        self.sealed(&packet, clock)
    }

    /// Processes a received datagram.
    pub fn receive(&mut self, now: f64, datagram: &[u8]) -> Option<News> {
        let mut packet = Packet { length: datagram.len(), bytes: [0; 64] };
        let sound = datagram.len() <= 64 && {
            packet.bytes[..datagram.len()].copy_from_slice(datagram);
            sim::ground_station::unframed(datagram).is_some()
        };
        if !sound {
            self.down.broken += 1;
            return None;
        }
        self.down.heard += 1;
        let number = u16::from_le_bytes([datagram[3], datagram[4]]);
        let ahead = self.sequence.map_or(1, |last| number.wrapping_sub(last));
        if ahead == 0 || ahead >= 0x8000 {
            // Twice, or overtaken.
            return None;
        }
        self.down.missing += u64::from(ahead - 1);
        self.sequence = Some(number);
        if self.is_strange(now) {
            self.meet(now);
        }
        self.heard_at = Some(now);
        let news = self.collector.take(&packet)?;
        self.learn(&news);
        Some(news)
    }

    /// Forgets the packets' numbers, since a restarted software begins anew.
    pub fn anew(&mut self) {
        self.sequence = None;
        self.record = None;
        self.status = None;
    }

    fn learn(&mut self, news: &News) {
        match news {
            News::Record(record) => {
                let layout = self.layout(record.tag).copied();
                for (number, value) in layout.into_iter().flatten().zip(&record.values) {
                    self.values[usize::from(number % 64)] = *value;
                }
                self.record = Some(record.clone());
            }
            News::Status(status) => self.status = Some(status.clone()),
            News::Parameter(number, value) => {
                if let Some(place) = self.parameters.get_mut(usize::from(*number)) {
                    *place = Some(*value);
                }
            }
        }
        let (done, left): (Vec<Pending>, Vec<Pending>) =
            std::mem::take(&mut self.pending).into_iter().partition(|it| self.is_done(it, news));
        self.pending = left;
        for Pending { order, .. } in done {
            let refused = matches!((&order, news), (Order::Set(_, wanted), News::Parameter(_, is)) if wanted != is);
            self.tell(&order, if refused { Outcome::Refused } else { Outcome::Done });
        }
    }

    /// Returns true if a message confirms a command.
    fn is_done(&self, pending: &Pending, news: &News) -> bool {
        let phase = self.phase();
        match (&pending.order, news) {
            (Order::Hello, _) => true,
            (Order::Ask(number), News::Parameter(it, _)) => number == it,
            // Another value may answer an earlier command for the same parameter, unless the command was repeated since.
            (Order::Set(number, wanted), News::Parameter(it, value)) => {
                number == it && (wanted == value || pending.repeated)
            }
            (Order::Choose(tag, ..), News::Record(record)) => record.tag == *tag,
            (Order::Mode(mode), News::Status(status)) => status.mode == *mode as u8,
            (Order::FlyAs(tag, _), News::Status(status)) => status.tag == *tag,
            (Order::TakeOff, News::Record(_)) => {
                phase != Phase::Ready as u8 && phase != Phase::Over as u8
            }
            (Order::Land, News::Record(_)) => {
                [Phase::Landing, Phase::Over, Phase::Ready].map(|it| it as u8).contains(&phase)
            }
            (Order::Stop, News::Record(_)) => {
                self.signal(catalogue::ALARM) != Alarm::Clear as u8 as f32
            }
            (Order::Arm, News::Record(_)) => phase == Phase::Ready as u8,
            (Order::Disarm, News::Record(_)) => phase == Phase::Over as u8,
            _ => false,
        }
    }

    fn give_up(&mut self, now: f64) {
        let (left, over): (Vec<Pending>, Vec<Pending>) =
            std::mem::take(&mut self.pending).into_iter().partition(|it| now < it.until);
        self.pending = left;
        for Pending { order, .. } in over {
            self.tell(&order, Outcome::GivenUp);
        }
    }

    fn tell(&mut self, order: &Order, outcome: Outcome) {
        if matches!(order, Order::Ask(_) | Order::Hello) && outcome == Outcome::Done {
            return;
        }
        self.outcomes.push_back((name(order), outcome));
    }

    fn send(&mut self, order: &Order) {
        // A link that takes one packet a period never catches up with more than this.
        if self.outbox.len() < 256 {
            self.outbox.extend(self.framer.frame(order));
        }
    }

    fn sealed(&mut self, packet: &Packet, clock: u64) -> Option<Vec<u8>> {
        let mut sealed = *packet;
        if let Some(key) = &self.key {
            // A clock that goes backwards changes nothing.
            self.counter = clock.max(self.counter + 1);
            sealed = key.seal(packet, self.counter)?;
        }
        Some(sealed.bytes[..sealed.length.min(64)].to_vec())
    }

    fn layout(&self, tag: u8) -> Option<&[u8; 36]> {
        self.signals.iter().rev().find(|(known, _)| *known == tag).map(|(_, signals)| signals)
    }
}

/// Returns the signals that are assumed before the first record: a disarmed aircraft.
fn disarmed() -> [f32; 64] {
    let mut values = [0.0; 64];
    values[usize::from(catalogue::PHASE)] = f32::from(Phase::Over as u8);
    values
}

/// Returns true if a command changes the course of the flight.
fn is_course(order: &Order) -> bool {
    matches!(order, Order::TakeOff | Order::Land | Order::Arm | Order::Disarm | Order::Stop)
}

/// Returns true if a command stays valid until it arrives. A take-off that arrives after minutes does not.
fn is_lasting(order: &Order) -> bool {
    matches!(order, Order::Hello | Order::Ask(_) | Order::Choose(..) | Order::Land | Order::Stop)
}

/// Returns true if a new command replaces an old one.
fn replaces(new: &Order, old: &Order) -> bool {
    match (new, old) {
        (Order::Ask(new) | Order::Set(new, _), Order::Ask(old) | Order::Set(old, _)) => new == old,
        _ => std::mem::discriminant(new) == std::mem::discriminant(old),
    }
}

/// Returns the name of a command for people.
fn name(order: &Order) -> String {
    match order {
        Order::Hello => "open the link".into(),
        Order::Goodbye => "close the link".into(),
        Order::Mode(_) => "mode".into(),
        Order::Fly(_) | Order::FlyAs(..) => "trajectory".into(),
        Order::TakeOff => "take off".into(),
        Order::Land => "land".into(),
        Order::Sticks(_) => "sticks".into(),
        Order::Stop => "stop".into(),
        Order::Beat => "beat".into(),
        Order::Arm => "arm".into(),
        Order::Disarm => "disarm".into(),
        Order::Ask(number) => format!("parameter {number}"),
        Order::Set(number, _) => format!("set parameter {number}"),
        Order::Choose(..) => "signals".into(),
        Order::Raw(_) => "raw".into(),
    }
}
