//! Missions: uploaded and downloaded by MAVLink's protocol, and flown as a trajectory.
//!
//! The whole mission is sent to the aircraft before it is flown, so that it does not depend on the link. Each item
//! becomes a setpoint that begins when the previous one is expected to be done. The ground only commands the landing
//! and reports the progress. Knows items, but not who may send them.

use super::telemetry::is_flying;
use crate::messages::{Ask, Point};
use ::mavlink::dialects::common::*;
use models::trajectory::{MAX_POINTS, SetPoint};
use models::{Phase, Settings};
use nalgebra::Vector3;

/// Speed assumed between two waypoints, m/s.
const CRUISE_SPEED: f64 = 0.5;

/// Time to stop at a waypoint, s.
const STOP_TIME: f64 = 4.0;

/// Distance at which a waypoint is reached, m.
const WAYPOINT_RADIUS: f64 = 0.2;

/// Period after which an item is requested again, s, and number of requests: as in the protocol.
const RETRY_PERIOD: f64 = 0.25;
const REQUEST_LIMIT: u32 = 5;

/// Time after which a take-off has failed, s: the station has given up.
const TAKEOFF_TIMEOUT: f64 = 6.0;

/// Number of units in a metre: items have whole numbers of 0.1 mm.
const UNITS: f64 = 1e4;

/// Meaning of a mission item.
#[derive(Clone, Copy, Debug)]
enum What {
    /// Flies to a position, m, with a yaw, rad, if one is set, and waits there, s.
    Place { place: Vector3<f64>, yaw: Option<f64>, hold: f64 },
    /// Lands.
    Land,
}

/// A mission item as received, and its meaning.
#[derive(Clone, Debug)]
struct Item {
    raw: MISSION_ITEM_INT_DATA,
    what: What,
}

/// A mission that is being uploaded.
#[derive(Debug)]
struct Upload {
    from: Peer,
    count: usize,
    items: Vec<Item>,
    asked: f64,
    tries: u32,
}

/// A mission that is being flown.
#[derive(Debug)]
struct Flight {
    /// Start of each item, in seconds since the take-off.
    begins: Vec<f64>,
    /// Time of the take-off, s.
    zero: f64,
    started: f64,
    airborne: bool,
    current: usize,
    reached: Option<usize>,
    lands: bool,
}

/// Address of a peer: its system and component.
pub type Peer = (u8, u8);

/// State of the flight that a mission depends on.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Phase of the flight.
    pub phase: u8,
    /// Time since the take-off, s, if it is received.
    pub time: Option<f64>,
    /// Position of the aircraft, m, if it is received.
    pub place: Option<Vector3<f64>>,
}

/// The mission.
#[derive(Debug, Default)]
pub struct Mission {
    items: Vec<Item>,
    upload: Option<Upload>,
    flight: Option<Flight>,
    complete: bool,
}

impl Mission {
    /// Answers a message of the mission protocol. `may` returns true if the sender may change the mission.
    pub fn take(
        &mut self,
        now: f64,
        from: Peer,
        message: &MavMessage,
        may: impl Fn() -> bool,
    ) -> Vec<MavMessage> {
        match message {
            MavMessage::MISSION_COUNT(it) => vec![self.begin(now, from, it, may)],
            MavMessage::MISSION_ITEM_INT(it) => self.collect(now, it).into_iter().collect(),
            MavMessage::MISSION_REQUEST_LIST(it) if it.mission_type == OURS => {
                vec![MavMessage::MISSION_COUNT(MISSION_COUNT_DATA {
                    count: self.items.len() as u16,
                    target_system: from.0,
                    target_component: from.1,
                    ..MISSION_COUNT_DATA::DEFAULT
                })]
            }
            MavMessage::MISSION_REQUEST_LIST(it) => {
                vec![ack(from, MavMissionResult::MAV_MISSION_UNSUPPORTED, it.mission_type)]
            }
            MavMessage::MISSION_REQUEST_INT(it) => vec![self.item(from, it.seq)],
            MavMessage::MISSION_CLEAR_ALL(it) => {
                let result = if it.mission_type != OURS {
                    MavMissionResult::MAV_MISSION_UNSUPPORTED
                } else if self.flight.is_some() || !may() {
                    MavMissionResult::MAV_MISSION_DENIED
                } else {
                    self.items.clear();
                    MavMissionResult::MAV_MISSION_ACCEPTED
                };
                vec![ack(from, result, it.mission_type)]
            }
            _ => Vec::new(),
        }
    }

    /// Requests a missing item again.
    pub fn tick(&mut self, now: f64) -> Option<MavMessage> {
        let upload = self.upload.as_mut().filter(|it| now - it.asked >= RETRY_PERIOD)?;
        (upload.asked, upload.tries) = (now, upload.tries + 1);
        if upload.tries <= REQUEST_LIMIT {
            return Some(request(upload));
        }
        let from = upload.from;
        self.upload = None;
        Some(ack(from, MavMissionResult::MAV_MISSION_OPERATION_CANCELLED, OURS))
    }

    /// Starts the mission at the aircraft's position; returns the necessary requests.
    ///
    /// # Errors
    ///
    /// There is no mission, it is being flown, or the aircraft is not armed.
    pub fn start(&mut self, now: f64, seen: &Seen) -> Result<Vec<Ask>, MavResult> {
        let flying = is_flying(seen.phase);
        let begin = if flying { seen.time } else { Some(0.0) };
        let (Some(begin), Some(mut last)) = (begin, seen.place) else {
            return Err(MavResult::MAV_RESULT_TEMPORARILY_REJECTED);
        };
        let ready = flying || seen.phase == Phase::Ready as u8;
        if self.items.is_empty() || self.flight.is_some() || !ready {
            return Err(MavResult::MAV_RESULT_DENIED);
        }
        let (mut at, mut heading) = (begin, 0.0);
        let (mut points, mut begins) = (Vec::new(), Vec::new());
        for item in &self.items {
            begins.push(at);
            if let What::Place { place, yaw, hold } = item.what {
                heading = yaw.unwrap_or(heading);
                let [x, y, z] = place.into();
                points.push(Point { time: at, x, y, z, yaw: heading });
                at += (place - last).norm() / CRUISE_SPEED + STOP_TIME + hold;
                last = place;
            }
        }
        let zero = now - begin;
        self.complete = false;
        self.flight = Some(Flight {
            begins,
            zero,
            started: now,
            airborne: flying,
            current: 0,
            reached: None,
            lands: false,
        });
        let up = (!flying).then_some(Ask::TakeOff);
        Ok([Ask::Fly { points }].into_iter().chain(up).collect())
    }

    /// Ends the mission, since another request has priority.
    pub fn leave(&mut self) {
        self.flight = None;
    }

    /// Returns the messages on the mission's progress, and true if it is time to land.
    pub fn watch(&mut self, now: f64, seen: &Seen) -> (Vec<MavMessage>, bool) {
        let mut told = Vec::new();
        let Some(flight) = &mut self.flight else { return (told, false) };
        let flying = is_flying(seen.phase);
        if !flight.airborne && !flying {
            flight.zero = now;
        } else if let Some(time) = seen.time.filter(|_| flying) {
            flight.zero = now - time;
        }
        let time = now - flight.zero;
        let begun = flight.begins.partition_point(|begin| *begin <= time);
        let current = begun.saturating_sub(1).max(flight.current);
        let what = self.items[current].what;
        let there = match what {
            What::Place { place, .. } => {
                seen.place.is_some_and(|it| flying && (it - place).norm() < WAYPOINT_RADIUS)
            }
            What::Land => flight.airborne && !flying,
        };
        let changed = current != flight.current;
        flight.current = current;
        if there && flight.reached != Some(current) {
            flight.reached = Some(current);
            let reached = MISSION_ITEM_REACHED_DATA { seq: current as u16 };
            told.push(MavMessage::MISSION_ITEM_REACHED(reached));
        }
        let land = matches!(what, What::Land) && flying && !flight.lands;
        flight.lands |= land;
        // It is over with its last item, when the motors stop before, or if they never turned.
        let last = flight.reached == Some(self.items.len() - 1);
        let missed = !flight.airborne && now - flight.started > TAKEOFF_TIMEOUT;
        let over = !flying && (flight.airborne || missed);
        flight.airborne |= flying;
        if last || over {
            (self.flight, self.complete) = (None, last);
        }
        if changed || last || over {
            told.push(self.current());
        }
        (told, land)
    }

    /// Returns the message with the current item.
    pub fn current(&self) -> MavMessage {
        let mission_state = match &self.flight {
            Some(_) => MissionState::MISSION_STATE_ACTIVE,
            None if self.items.is_empty() => MissionState::MISSION_STATE_NO_MISSION,
            None if self.complete => MissionState::MISSION_STATE_COMPLETE,
            None => MissionState::MISSION_STATE_NOT_STARTED,
        };
        MavMessage::MISSION_CURRENT(MISSION_CURRENT_DATA {
            seq: self.flight.as_ref().map_or(0, |flight| flight.current as u16),
            total: self.items.len() as u16,
            mission_state,
            ..MISSION_CURRENT_DATA::DEFAULT
        })
    }

    fn begin(
        &mut self,
        now: f64,
        from: Peer,
        it: &MISSION_COUNT_DATA,
        may: impl Fn() -> bool,
    ) -> MavMessage {
        let count = usize::from(it.count);
        let result = if it.mission_type != OURS {
            MavMissionResult::MAV_MISSION_UNSUPPORTED
        } else if self.flight.is_some() || !may() {
            MavMissionResult::MAV_MISSION_DENIED
        } else if count > MAX_POINTS + 1 {
            // As many places as a trajectory has, and the landing.
            MavMissionResult::MAV_MISSION_NO_SPACE
        } else if count == 0 {
            self.items.clear();
            MavMissionResult::MAV_MISSION_ACCEPTED
        } else {
            let upload = Upload { from, count, items: Vec::new(), asked: now, tries: 0 };
            let first = request(&upload);
            self.upload = Some(upload);
            return first;
        };
        ack(from, result, it.mission_type)
    }

    fn collect(&mut self, now: f64, it: &MISSION_ITEM_INT_DATA) -> Option<MavMessage> {
        // One that was requested twice comes twice.
        let upload = self.upload.as_mut().filter(|upload| it.seq as usize == upload.items.len())?;
        let from = upload.from;
        let what = match meant(it) {
            Ok(what) => what,
            Err(result) => {
                self.upload = None;
                return Some(ack(from, result, OURS));
            }
        };
        upload.items.push(Item { raw: it.clone(), what });
        (upload.asked, upload.tries) = (now, 0);
        if upload.items.len() < upload.count {
            return Some(request(upload));
        }
        let items = std::mem::take(&mut upload.items);
        self.upload = None;
        let landing = items.iter().position(|item| matches!(item.what, What::Land));
        let ends = landing.is_none_or(|at| at + 1 == items.len());
        let places = items.len() - usize::from(landing.is_some());
        if !ends || !(1..=MAX_POINTS).contains(&places) {
            return Some(ack(from, MavMissionResult::MAV_MISSION_INVALID, OURS));
        }
        (self.items, self.complete) = (items, false);
        Some(ack(from, MavMissionResult::MAV_MISSION_ACCEPTED, OURS))
    }

    fn item(&self, from: Peer, number: u16) -> MavMessage {
        let Some(item) = self.items.get(usize::from(number)) else {
            return ack(from, MavMissionResult::MAV_MISSION_INVALID_SEQUENCE, OURS);
        };
        let (target_system, target_component) = from;
        MavMessage::MISSION_ITEM_INT(MISSION_ITEM_INT_DATA {
            target_system,
            target_component,
            ..item.raw.clone()
        })
    }
}

/// The only kind of mission that is supported: no fences, no rally points.
const OURS: MavMissionType = MavMissionType::MAV_MISSION_TYPE_MISSION;

/// Returns the meaning of an item, or the reason why it cannot be flown.
fn meant(it: &MISSION_ITEM_INT_DATA) -> Result<What, MavMissionResult> {
    use MavMissionResult as Refused;
    let hold = match it.command {
        MavCmd::MAV_CMD_NAV_LAND => return Ok(What::Land),
        MavCmd::MAV_CMD_NAV_WAYPOINT => f64::from(it.param1),
        MavCmd::MAV_CMD_NAV_TAKEOFF => 0.0,
        _ => return Err(Refused::MAV_MISSION_UNSUPPORTED),
    };
    if it.frame != MavFrame::MAV_FRAME_LOCAL_NED {
        return Err(Refused::MAV_MISSION_UNSUPPORTED_FRAME);
    }
    let space = Settings::mambo().space;
    let place = Vector3::new(f64::from(it.x) / UNITS, -f64::from(it.y) / UNITS, -f64::from(it.z));
    // Degrees; no number for a yaw that is to stay.
    let yaw = (!it.param4.is_nan()).then(|| f64::from(it.param4).to_radians());
    let point = SetPoint { time: 0.0, position: place, yaw: yaw.unwrap_or(0.0) };
    if !(0.0..=600.0).contains(&hold) {
        return Err(Refused::MAV_MISSION_INVALID_PARAM1);
    }
    if !point.is_inside(&space) {
        return Err(if place.x.abs() > space.reach {
            Refused::MAV_MISSION_INVALID_PARAM5_X
        } else if place.y.abs() > space.reach {
            Refused::MAV_MISSION_INVALID_PARAM6_Y
        } else if (space.heights.x..=space.heights.y).contains(&place.z) {
            Refused::MAV_MISSION_INVALID_PARAM4
        } else {
            Refused::MAV_MISSION_INVALID_PARAM7
        });
    }
    Ok(What::Place { place, yaw, hold })
}

/// Requests the next item.
fn request(upload: &Upload) -> MavMessage {
    MavMessage::MISSION_REQUEST_INT(MISSION_REQUEST_INT_DATA {
        seq: upload.items.len() as u16,
        target_system: upload.from.0,
        target_component: upload.from.1,
        ..MISSION_REQUEST_INT_DATA::DEFAULT
    })
}

fn ack(to: Peer, result: MavMissionResult, mission_type: MavMissionType) -> MavMessage {
    MavMessage::MISSION_ACK(MISSION_ACK_DATA {
        target_system: to.0,
        target_component: to.1,
        mavtype: result,
        mission_type,
        ..MISSION_ACK_DATA::DEFAULT
    })
}
