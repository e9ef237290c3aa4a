//! The flight as a MAVLink 2 system: sends telemetry, and converts MAVLink's commands.
//!
//! It serves one ground station at one address and ignores datagrams of others. The station gets the right to command
//! with its first command, if no other client has it, and loses it after silence; stopping the motors does not need
//! the right. A command is acknowledged when it has been sent to the aircraft.
//!
//! Frames: [`telemetry`]. Knows messages, but not their effects.

mod mission;
mod parameters;
mod signature;
mod telemetry;

pub use signature::Signature;

use super::Tool;
use crate::bench::Period;
use crate::command::Seat;
use crate::events::{Event, Severity};
use crate::messages::{Ask, Flown, Point};
use crate::testbed::Testbed;
use ::mavlink::dialects::common::*;
use ::mavlink::error::MessageReadError;
use ::mavlink::{MAVLinkMessageRaw, MavHeader, MavlinkReader, MavlinkVersion, Message};
use mission::{Mission, Peer, Seen};
use models::receiver::Mode;
use models::tuning::PARAMETER_COUNT;
use parameters::{decimal, number_of, parameter};
use sim::ground_station::News;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};
use telemetry::is_flying;

/// MAVLink numbers of the aircraft: its system and its component.
const SYSTEM: u8 = 1;
const COMPONENT: u8 = 1;

/// Silence after which the ground station loses the right to command, s.
const SILENT: f64 = 5.0;

/// Silence of the aircraft after which its heartbeat is no longer sent, s.
const LOST: f64 = 3.0;

/// Number of datagrams that are read in a period; more wait in the socket, and may be lost there.
const MOST: usize = 16;

/// Periods of heartbeat (with battery and mission) and of phase messages, in control periods.
const HEARTBEAT_PERIODS: u64 = 200;
const PHASE_PERIODS: u64 = 40;

/// Setpoints at the sticks' limits: tilt, rad, yaw rate, rad/s, climb rate, m/s. The page has the same.
const STICK_TILT: f64 = 0.12;
const STICK_YAW_RATE: f64 = 1.0;
const STICK_CLIMB: f64 = 0.4;

/// Parameter that forces a disarming in the air (MAV_CMD_COMPONENT_ARM_DISARM).
const FORCE: f32 = 21196.0;

/// The link to a MAVLink ground station.
#[derive(Debug)]
pub struct Mavlink {
    socket: UdpSocket,
    sequence: u8,
    heard: Option<f64>,
    records: u32,
    wanted: Vec<MavMessage>,
    mission: Mission,
    signature: Signature,
    /// Number of the last text.
    texts: u16,
}

/// Result of a command: requests, or the reason to reject it.
type Verdict = Result<Vec<Ask>, MavResult>;

impl Mavlink {
    /// Creates a link to the ground station at an address, with or without a key.
    ///
    /// # Errors
    ///
    /// There is no port.
    pub fn start(station: SocketAddr, signature: Signature) -> io::Result<Self> {
        let own: IpAddr = match station.ip().is_loopback() && station.is_ipv4() {
            true => Ipv4Addr::LOCALHOST.into(),
            false if station.is_ipv4() => Ipv4Addr::UNSPECIFIED.into(),
            false => std::net::Ipv6Addr::UNSPECIFIED.into(),
        };
        let socket = UdpSocket::bind((own, 0))?;
        socket.connect(station)?;
        socket.set_nonblocking(true)?;
        Ok(Self {
            socket,
            sequence: 0,
            heard: None,
            records: 0,
            wanted: Vec::new(),
            mission: Mission::default(),
            signature,
            texts: 0,
        })
    }

    fn send(&mut self, message: &MavMessage) {
        let header = MavHeader {
            system_id: SYSTEM.into(),
            component_id: COMPONENT,
            sequence: self.sequence,
        };
        self.sequence = self.sequence.wrapping_add(1);
        let raw = self.signature.sealed(header, message);
        // Nobody there, or no room: lost, as datagrams are.
        let _ = self.socket.send(raw.raw_bytes());
    }

    /// Returns the requests of a message.
    fn take(
        &mut self,
        testbed: &Testbed,
        seat: &Seat,
        from: Peer,
        message: &MavMessage,
    ) -> Vec<Ask> {
        match message {
            MavMessage::COMMAND_LONG(it) => {
                let verdict = self.command(testbed, seat, it);
                let result = verdict.as_ref().err().copied();
                let result = result.unwrap_or(MavResult::MAV_RESULT_ACCEPTED);
                let ack =
                    COMMAND_ACK_DATA { command: it.command, result, ..COMMAND_ACK_DATA::DEFAULT };
                self.send(&MavMessage::COMMAND_ACK(ack));
                verdict.unwrap_or_default()
            }
            MavMessage::SET_POSITION_TARGET_LOCAL_NED(it) => {
                let asks = place(testbed, it).and_then(|ask| allowed(seat, vec![ask]));
                self.instead(asks).unwrap_or_default()
            }
            MavMessage::MANUAL_CONTROL(it) => {
                let flown = testbed.station.status.as_ref().map(|status| status.mode);
                let asks = match flown == Some(Mode::Manual as u8) {
                    true => allowed(seat, vec![sticks(it)]),
                    false => Err(MavResult::MAV_RESULT_DENIED),
                };
                asks.unwrap_or_default()
            }
            MavMessage::PARAM_REQUEST_LIST(_) => {
                self.wanted.extend((0..PARAMETER_COUNT).map(|n| parameter(testbed, n)));
                Vec::new()
            }
            MavMessage::PARAM_REQUEST_READ(it) => {
                let named = it.param_id.to_str().ok().and_then(number_of);
                let number = usize::try_from(it.param_index).ok().or(named);
                self.wanted
                    .extend(number.filter(|n| *n < PARAMETER_COUNT).map(|n| parameter(testbed, n)));
                Vec::new()
            }
            MavMessage::PARAM_SET(it) => {
                let Some(number) = it.param_id.to_str().ok().and_then(number_of) else {
                    return Vec::new();
                };
                // The aircraft answers with the value that it has then, which goes on as PARAM_VALUE.
                let set = Ask::Set { number: number as u8, value: decimal(it.param_value) };
                allowed(seat, vec![set]).unwrap_or_else(|_| {
                    self.wanted.push(parameter(testbed, number));
                    Vec::new()
                })
            }
            message => {
                let answers = self.mission.take(testbed.now(), from, message, || seat.claim(false));
                answers.iter().for_each(|answer| self.send(answer));
                Vec::new()
            }
        }
    }

    /// Returns the requests of a command.
    fn command(&mut self, testbed: &Testbed, seat: &Seat, it: &COMMAND_LONG_DATA) -> Verdict {
        if it.command != MavCmd::MAV_CMD_MISSION_START {
            let asks = command(testbed, it).and_then(|asks| allowed(seat, asks));
            return self.instead(asks);
        }
        if !seat.claim(false) {
            return Err(MavResult::MAV_RESULT_TEMPORARILY_REJECTED);
        }
        self.mission.start(testbed.now(), &seen(testbed))
    }

    /// Returns the requests that replace those of a running mission.
    fn instead(&mut self, asks: Verdict) -> Verdict {
        if asks.as_ref().is_ok_and(|asks| !asks.is_empty()) {
            self.mission.leave();
        }
        asks
    }
}

impl Tool for Mavlink {
    fn refused(&self) -> u64 {
        self.signature.refused
    }

    fn listen(&mut self, testbed: &Testbed, seat: &Seat) -> Vec<Ask> {
        let now = testbed.now();
        let mut asks = Vec::new();
        let mut datagram = [0; 2048];
        for _ in 0..MOST {
            // Refused: nobody listens there.
            let Ok(length) = self.socket.recv(&mut datagram) else { break };
            let mut reader = MavlinkReader::new(&datagram[..length]);
            loop {
                match reader.read_raw_message::<MavMessage>(MavlinkVersion::V2) {
                    Ok(MAVLinkMessageRaw::V2(raw)) if self.signature.admits(&raw) => {
                        // Of a kind that `common` does not have.
                        let Ok(message) =
                            MavMessage::parse(MavlinkVersion::V2, raw.message_id(), raw.payload())
                        else {
                            continue;
                        };
                        self.heard = Some(now);
                        if addressed(&message).is_none_or(is_ours) {
                            let from = (raw.system_id() as u8, raw.component_id());
                            asks.extend(self.take(testbed, seat, from, &message));
                        }
                    }
                    Ok(_) | Err(MessageReadError::Parse(_)) => {}
                    Err(MessageReadError::Io(_)) => break,
                }
            }
        }
        if seat.is_taken() {
            self.mission.leave();
        }
        let (told, land) = self.mission.watch(now, &seen(testbed));
        let again = self.mission.tick(now);
        told.iter().chain(&again).for_each(|message| self.send(message));
        if land && seat.claim(false) {
            asks.push(Ask::Land);
        }
        if self.heard.is_none_or(|heard| now - heard > SILENT) {
            seat.release();
        }
        asks
    }

    fn report(&mut self, event: &Event) {
        let severity = match event.severity {
            Severity::Info => MavSeverity::MAV_SEVERITY_INFO,
            Severity::Warning => MavSeverity::MAV_SEVERITY_WARNING,
            Severity::Critical => MavSeverity::MAV_SEVERITY_CRITICAL,
        };
        // A chunk has 50 characters; the texts are ASCII.
        self.texts = self.texts.wrapping_add(1).max(1);
        let chunks: Vec<String> = event
            .text
            .as_bytes()
            .chunks(50)
            .map(|chunk| String::from_utf8_lossy(chunk).into_owned())
            .collect();
        let id = if chunks.len() > 1 { self.texts } else { 0 };
        for (number, chunk) in chunks.iter().enumerate() {
            let text = chunk.as_str().into();
            let chunk_seq = number as u8;
            self.send(&MavMessage::STATUSTEXT(STATUSTEXT_DATA { severity, text, id, chunk_seq }));
        }
    }

    fn tell(&mut self, testbed: &Testbed, done: &Period, news: &[News]) {
        for message in std::mem::take(&mut self.wanted) {
            self.send(&message);
        }
        for it in news {
            match it {
                News::Record(record) => {
                    self.records = self.records.wrapping_add(1);
                    let told = telemetry::record(testbed, record, self.records);
                    told.iter().for_each(|message| self.send(message));
                }
                News::Parameter(number, _) if usize::from(*number) < PARAMETER_COUNT => {
                    self.send(&parameter(testbed, usize::from(*number)));
                }
                News::Parameter(..) | News::Status(_) => {}
            }
        }
        // What has not been heard of does not live.
        let heard = testbed.station.silence(testbed.now()).is_some_and(|since| since < LOST);
        if heard && done.number.is_multiple_of(PHASE_PERIODS) {
            self.send(&telemetry::landed(testbed));
        }
        if heard && done.number.is_multiple_of(HEARTBEAT_PERIODS) {
            self.send(&telemetry::heartbeat(testbed));
            self.send(&telemetry::battery(testbed));
            self.send(&self.mission.current());
        }
    }
}

/// The addressee of a message; `None` for a broadcast.
fn addressed(message: &MavMessage) -> Option<Peer> {
    Some(match message {
        MavMessage::COMMAND_LONG(it) => (it.target_system, it.target_component),
        MavMessage::SET_POSITION_TARGET_LOCAL_NED(it) => (it.target_system, it.target_component),
        MavMessage::MANUAL_CONTROL(it) => (it.target, COMPONENT),
        MavMessage::PARAM_REQUEST_LIST(it) => (it.target_system, it.target_component),
        MavMessage::PARAM_REQUEST_READ(it) => (it.target_system, it.target_component),
        MavMessage::PARAM_SET(it) => (it.target_system, it.target_component),
        MavMessage::MISSION_COUNT(it) => (it.target_system, it.target_component),
        MavMessage::MISSION_ITEM_INT(it) => (it.target_system, it.target_component),
        MavMessage::MISSION_REQUEST_LIST(it) => (it.target_system, it.target_component),
        MavMessage::MISSION_REQUEST_INT(it) => (it.target_system, it.target_component),
        MavMessage::MISSION_CLEAR_ALL(it) => (it.target_system, it.target_component),
        _ => return None,
    })
}

/// Returns true if a message is addressed to this system; 0 addresses all.
fn is_ours((system, component): Peer) -> bool {
    [0, SYSTEM].contains(&system) && [0, COMPONENT].contains(&component)
}

/// Returns the state of the flight that a mission depends on.
fn seen(testbed: &Testbed) -> Seen {
    Seen {
        phase: testbed.station.phase(),
        time: telemetry::flight_time(testbed),
        place: telemetry::place(testbed),
    }
}

/// Converts sticks: forward, right and clockwise, each from -1000 to 1000; thrust from 0 to 1000, where 500 keeps the
/// height.
fn sticks(it: &MANUAL_CONTROL_DATA) -> Ask {
    // The largest number represents an axis that there is not.
    let axis = |value: i16, middle: i16| match value {
        i16::MAX => 0.0,
        value => (f64::from(value.clamp(-1000, 1000)) - f64::from(middle)) / 1000.0,
    };
    Ask::Sticks {
        // A positive roll flies along y, to the left, and a negative pitch along x: the angles are passive.
        roll: -STICK_TILT * axis(it.y, 0),
        pitch: -STICK_TILT * axis(it.x, 0),
        // Counter-clockwise is positive here and negative there.
        yaw_rate: -STICK_YAW_RATE * axis(it.r, 0),
        climb: STICK_CLIMB * (2.0 * axis(it.z, 500)).clamp(-1.0, 1.0),
    }
}

/// Accepts requests that need no right to command, or whose sender has it.
fn allowed(seat: &Seat, asks: Vec<Ask>) -> Verdict {
    if asks.iter().all(|ask| matches!(ask, Ask::Stop)) || seat.claim(false) {
        Ok(asks)
    } else {
        Err(MavResult::MAV_RESULT_TEMPORARILY_REJECTED)
    }
}

/// Returns the requests of a command.
fn command(testbed: &Testbed, it: &COMMAND_LONG_DATA) -> Verdict {
    let flying = is_flying(testbed.station.phase());
    match it.command {
        MavCmd::MAV_CMD_NAV_TAKEOFF if flying => Err(MavResult::MAV_RESULT_DENIED),
        MavCmd::MAV_CMD_NAV_TAKEOFF => {
            let signal = |number| f64::from(testbed.station.signal(number));
            let up =
                Ask::Fly { points: vec![point(signal(0), signal(1), it.param7.into(), signal(5))] };
            let wanted = (it.param7 > 0.0).then_some(up);
            Ok(wanted.into_iter().chain([Ask::TakeOff]).collect())
        }
        MavCmd::MAV_CMD_NAV_LAND => Ok(vec![Ask::Land]),
        MavCmd::MAV_CMD_DO_SET_MODE => mode(it.param2 as u32).map(|ask| vec![ask]),
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM if it.param1 == 1.0 && !flying => Ok(vec![Ask::Arm]),
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM if it.param1 == 1.0 => Ok(Vec::new()),
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM if !flying || it.param2 == FORCE => {
            Ok(vec![Ask::Stop])
        }
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM => Err(MavResult::MAV_RESULT_DENIED),
        MavCmd::MAV_CMD_DO_FLIGHTTERMINATION if it.param1 > 0.5 => Ok(vec![Ask::Stop]),
        _ => Err(MavResult::MAV_RESULT_UNSUPPORTED),
    }
}

/// Converts the number of a mode.
fn mode(number: u32) -> Result<Ask, MavResult> {
    match number {
        0 => Ok(Ask::Mode { mode: Flown::ClosedLoop }),
        1 => Ok(Ask::Mode { mode: Flown::FeedForward }),
        2 => Ok(Ask::Mode { mode: Flown::Manual }),
        _ => Err(MavResult::MAV_RESULT_DENIED),
    }
}

/// Converts a target position; without a yaw, the present one is kept.
fn place(testbed: &Testbed, it: &SET_POSITION_TARGET_LOCAL_NED_DATA) -> Result<Ask, MavResult> {
    use PositionTargetTypemask as Mask;
    let without = Mask::POSITION_TARGET_TYPEMASK_X_IGNORE
        | Mask::POSITION_TARGET_TYPEMASK_Y_IGNORE
        | Mask::POSITION_TARGET_TYPEMASK_Z_IGNORE;
    let finite = [it.x, it.y, it.z].iter().all(|it| it.is_finite());
    if it.type_mask.intersects(without)
        || it.coordinate_frame != MavFrame::MAV_FRAME_LOCAL_NED
        || !finite
    {
        return Err(MavResult::MAV_RESULT_UNSUPPORTED);
    }
    let held = f64::from(testbed.station.signal(15));
    let ignored = it.type_mask.contains(Mask::POSITION_TARGET_TYPEMASK_YAW_IGNORE);
    // Level, the angle of a passive rotation about the axis up is equal to an active one's about the axis down.
    let yaw = if ignored { held } else { f64::from(it.yaw) };
    Ok(Ask::Fly { points: vec![point(it.x.into(), -f64::from(it.y), -f64::from(it.z), yaw)] })
}

fn point(x: f64, y: f64, z: f64, yaw: f64) -> Point {
    Point { time: 0.0, x, y, z, yaw }
}
