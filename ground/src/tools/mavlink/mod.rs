//! The flight as a MAVLink 2 system: sends telemetry, and converts MAVLink's commands.
//!
//! It serves one ground station at one address and ignores datagrams of others. The station gets the right to command
//! with its first command, if no other client has it, and loses it after silence; stopping the motors does not need
//! the right. A command is acknowledged when it has been sent to the aircraft; one that the ground station refuses is
//! denied, and the reason goes out as text.
//!
//! Frames: [`telemetry`]. Knows messages, but not their effects.

mod mission;
mod parameters;
mod signature;
mod streams;
mod telemetry;

pub use signature::Signature;

use super::Tool;
use crate::bench::Period;
use crate::catalogue;
use crate::command::Seat;
use crate::events::{Event, Severity};
use crate::messages::{Ask, Flown, Point};
use crate::refusal::{self, Situation};
use crate::testbed::{self, Testbed};
use ::mavlink::dialects::common::*;
use ::mavlink::error::MessageReadError;
use ::mavlink::{
    MAVLinkMessageRaw, MavHeader, MavlinkReader, MavlinkVersion, Message, MessageData,
};
use mission::{Mission, Peer, Seen};
use models::receiver::Mode;
use models::tuning::PARAMETER_COUNT;
use parameters::{decimal, number_of, parameter};
use sim::ground_station::News;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};
use std::time::Duration;
use streams::{Source, Streams, Unchanged};
use telemetry::{Origin, is_flying};

/// MAVLink numbers of the aircraft: its system and its component.
const SYSTEM: u8 = 1;
const COMPONENT: u8 = 1;

/// Silence after which the ground station loses the right to command, s.
const SILENT: f64 = 5.0;

/// Silence of the aircraft after which its heartbeat is no longer sent, s.
const LOST: f64 = 3.0;

/// Number of datagrams that are read in a period; more wait in the socket, and may be lost there.
const MOST: usize = 16;

/// Numbers of the messages that are sent periodically or on request.
mod id {
    use ::mavlink::MessageData;
    use ::mavlink::dialects::common::*;

    pub const HEARTBEAT: u32 = HEARTBEAT_DATA::ID;
    pub const SYS_STATUS: u32 = SYS_STATUS_DATA::ID;
    pub const ATTITUDE: u32 = ATTITUDE_DATA::ID;
    pub const LOCAL_POSITION: u32 = LOCAL_POSITION_NED_DATA::ID;
    pub const GLOBAL_POSITION: u32 = GLOBAL_POSITION_INT_DATA::ID;
    pub const MISSION_CURRENT: u32 = MISSION_CURRENT_DATA::ID;
    pub const ORIGIN: u32 = GPS_GLOBAL_ORIGIN_DATA::ID;
    pub const BATTERY: u32 = BATTERY_STATUS_DATA::ID;
    pub const VERSION: u32 = AUTOPILOT_VERSION_DATA::ID;
    pub const HOME: u32 = HOME_POSITION_DATA::ID;
    pub const LANDED: u32 = EXTENDED_SYS_STATE_DATA::ID;
}

/// Messages with their sources and initial periods, in control periods.
const STREAMS: [(u32, Source, Option<u64>); 11] = [
    (id::HEARTBEAT, Source::State, Some(200)),
    (id::SYS_STATUS, Source::State, Some(200)),
    (id::BATTERY, Source::State, Some(200)),
    (id::MISSION_CURRENT, Source::State, Some(200)),
    (id::HOME, Source::State, Some(2000)),
    (id::LANDED, Source::State, Some(40)),
    (id::ATTITUDE, Source::Record, Some(4)),
    (id::LOCAL_POSITION, Source::Record, Some(20)),
    (id::GLOBAL_POSITION, Source::Record, Some(40)),
    (id::ORIGIN, Source::Request, None),
    (id::VERSION, Source::Request, None),
];

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
    streams: Streams,
    origin: Origin,
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
            streams: Streams::new(&STREAMS, Duration::from_secs_f64(testbed::period())),
            origin: Origin::default(),
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
        now: &Situation,
        seat: &Seat,
        from: Peer,
        message: &MavMessage,
    ) -> Vec<Ask> {
        match message {
            MavMessage::COMMAND_LONG(it) => self.execute(testbed, now, seat, it),
            MavMessage::COMMAND_INT(it) if it.command == MavCmd::MAV_CMD_DO_SET_GLOBAL_ORIGIN => {
                let altitude = (1000.0 * it.z) as i32;
                let origin = Origin { latitude: it.x, longitude: it.y, altitude };
                let result = match self.place(seat, origin) {
                    true => MavResult::MAV_RESULT_ACCEPTED,
                    false => MavResult::MAV_RESULT_TEMPORARILY_REJECTED,
                };
                self.acknowledge(it.command, result);
                Vec::new()
            }
            MavMessage::COMMAND_INT(it) => self.execute(testbed, now, seat, &long(it)),
            // Superseded by the command, which stations do not know yet.
            #[expect(deprecated)]
            MavMessage::SET_GPS_GLOBAL_ORIGIN(it) => {
                let SET_GPS_GLOBAL_ORIGIN_DATA { latitude, longitude, altitude, .. } = *it;
                self.place(seat, Origin { latitude, longitude, altitude });
                Vec::new()
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
                if refusal::reason(&set, now).is_some() {
                    self.wanted.push(parameter(testbed, number));
                }
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

    /// Acknowledges a command and returns its requests.
    fn execute(
        &mut self,
        testbed: &Testbed,
        now: &Situation,
        seat: &Seat,
        it: &COMMAND_LONG_DATA,
    ) -> Vec<Ask> {
        let starts = it.command == MavCmd::MAV_CMD_MISSION_START;
        let (result, asks) = match self.command(testbed, now, seat, it) {
            Ok(mut asks) => {
                let refused = refusal::first_refused(&asks, now);
                // A mission ends by requests that replace its own, and does not begin if those are refused.
                if !asks.is_empty() && starts == refused.is_some() {
                    self.mission.leave();
                }
                match refused {
                    // It still goes to the testbed, which refuses it for the same reason and reports it.
                    Some(at) => (MavResult::MAV_RESULT_DENIED, vec![asks.swap_remove(at)]),
                    None => (MavResult::MAV_RESULT_ACCEPTED, asks),
                }
            }
            Err(result) => (result, Vec::new()),
        };
        self.acknowledge(it.command, result);
        asks
    }

    /// Moves the room's origin on the earth and reports it; returns false without the right to command.
    fn place(&mut self, seat: &Seat, origin: Origin) -> bool {
        let may = seat.claim(false);
        if may {
            self.origin = origin;
        }
        self.send(&telemetry::origin(&self.origin));
        self.send(&telemetry::home(&self.origin));
        may
    }

    fn acknowledge(&mut self, command: MavCmd, result: MavResult) {
        let ack = COMMAND_ACK_DATA { command, result, ..COMMAND_ACK_DATA::DEFAULT };
        self.send(&MavMessage::COMMAND_ACK(ack));
    }

    /// Returns the requests of a command.
    fn command(
        &mut self,
        testbed: &Testbed,
        now: &Situation,
        seat: &Seat,
        it: &COMMAND_LONG_DATA,
    ) -> Verdict {
        match it.command {
            MavCmd::MAV_CMD_REQUEST_MESSAGE => self.requested(testbed, now, it),
            MavCmd::MAV_CMD_SET_MESSAGE_INTERVAL => {
                let number = number(it.param1).ok_or(MavResult::MAV_RESULT_DENIED)?;
                let set = self.streams.set(number, it.param2.into(), id::HEARTBEAT);
                set.map(|()| Vec::new()).map_err(|why| match why {
                    Unchanged::Unknown => MavResult::MAV_RESULT_UNSUPPORTED,
                    Unchanged::Denied => MavResult::MAV_RESULT_DENIED,
                })
            }
            MavCmd::MAV_CMD_MISSION_START if !seat.claim(false) => {
                Err(MavResult::MAV_RESULT_TEMPORARILY_REJECTED)
            }
            MavCmd::MAV_CMD_MISSION_START => self.mission.start(testbed.now(), &seen(testbed)),
            _ => command(testbed, it).and_then(|asks| allowed(seat, asks)),
        }
    }

    /// Sends a message that a command requests.
    fn requested(&mut self, testbed: &Testbed, now: &Situation, it: &COMMAND_LONG_DATA) -> Verdict {
        let wanted = number(it.param1).ok_or(MavResult::MAV_RESULT_DENIED)?;
        let message = if wanted == MESSAGE_INTERVAL_DATA::ID {
            let of = number(it.param2).ok_or(MavResult::MAV_RESULT_DENIED)?;
            Some(MavMessage::MESSAGE_INTERVAL(MESSAGE_INTERVAL_DATA {
                message_id: of as u16,
                interval_us: self.streams.interval(of),
            }))
        } else if self.streams.contains(wanted) {
            self.message(testbed, now, wanted)
        } else {
            return Err(MavResult::MAV_RESULT_UNSUPPORTED);
        };
        // Its signals are not received, or not yet.
        let message = message.ok_or(MavResult::MAV_RESULT_TEMPORARILY_REJECTED)?;
        self.send(&message);
        Ok(Vec::new())
    }

    /// Returns a message by its number; none if its signals are not received.
    fn message(&self, testbed: &Testbed, now: &Situation, number: u32) -> Option<MavMessage> {
        Some(match number {
            id::HEARTBEAT => telemetry::heartbeat(testbed),
            id::SYS_STATUS => telemetry::system(testbed, now),
            id::BATTERY => telemetry::battery(testbed),
            id::MISSION_CURRENT => self.mission.current(),
            id::HOME => telemetry::home(&self.origin),
            id::LANDED => telemetry::landed(testbed),
            id::ORIGIN => telemetry::origin(&self.origin),
            id::VERSION => telemetry::version(),
            id::ATTITUDE => return telemetry::attitude(testbed),
            id::LOCAL_POSITION => return telemetry::local_position(testbed),
            id::GLOBAL_POSITION => return telemetry::global_position(testbed, &self.origin),
            _ => return None,
        })
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

    fn listen(&mut self, testbed: &Testbed, situation: &Situation, seat: &Seat) -> Vec<Ask> {
        let now = testbed.now();
        let mut situation = *situation;
        let mut asks = Vec::new();
        let mut datagram = [0; 2048];
        for _ in 0..MOST {
            // Refused: nobody listens there.
            let Ok(length) = self.socket.recv(&mut datagram) else { break };
            let mut reader = MavlinkReader::new(&datagram[..length]);
            loop {
                match reader.read_raw_message::<MavMessage>(MavlinkVersion::V2) {
                    Ok(MAVLinkMessageRaw::V2(raw)) if self.signature.admits(&raw) => {
                        self.heard = Some(now);
                        // With a number that an enum of `common` does not have: heard, but not understood.
                        let Ok(message) =
                            MavMessage::parse(MavlinkVersion::V2, raw.message_id(), raw.payload())
                        else {
                            continue;
                        };
                        if addressed(&message).is_none_or(is_ours) {
                            let from = (raw.system_id() as u8, raw.component_id());
                            let new = self.take(testbed, &situation, seat, from, &message);
                            situation = new.iter().fold(situation, |it, ask| it.after(ask));
                            asks.extend(new);
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

    fn tell(&mut self, testbed: &Testbed, now: &Situation, done: &Period, news: &[News]) {
        for message in std::mem::take(&mut self.wanted) {
            self.send(&message);
        }
        for it in news {
            match it {
                News::Parameter(number, _) if usize::from(*number) < PARAMETER_COUNT => {
                    self.send(&parameter(testbed, usize::from(*number)));
                }
                News::Record(_) | News::Parameter(..) | News::Status(_) => {}
            }
        }
        // What has not been heard of does not live.
        let heard = testbed.station.silence(testbed.now()).is_some_and(|since| since < LOST);
        let record = testbed.station.record().map(|record| record.period);
        for number in self.streams.due(done.number, record, heard) {
            if let Some(message) = self.message(testbed, now, number) {
                self.send(&message);
            }
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
        MavMessage::COMMAND_INT(it) => (it.target_system, it.target_component),
        #[expect(deprecated)]
        MavMessage::SET_GPS_GLOBAL_ORIGIN(it) => (it.target_system, COMPONENT),
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
        MavCmd::MAV_CMD_NAV_TAKEOFF => {
            let signal = |number| f64::from(testbed.station.signal(number));
            let ([x, y, _], [_, _, yaw]) = (catalogue::PLACE, catalogue::ANGLES);
            let place = point(signal(x), signal(y), it.param7.into(), signal(yaw));
            let up = Ask::Fly { points: vec![place] };
            let wanted = (it.param7 > 0.0).then_some(up);
            Ok(wanted.into_iter().chain([Ask::TakeOff]).collect())
        }
        MavCmd::MAV_CMD_NAV_LAND => Ok(vec![Ask::Land]),
        MavCmd::MAV_CMD_DO_SET_MODE => mode(it.param2 as u32).map(|ask| vec![ask]),
        // An aircraft that flies is armed.
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM if it.param1 == 1.0 && flying => Ok(Vec::new()),
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM if it.param1 == 1.0 => Ok(vec![Ask::Arm]),
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM if flying && it.param2 == FORCE => Ok(vec![Ask::Stop]),
        MavCmd::MAV_CMD_COMPONENT_ARM_DISARM => Ok(vec![Ask::Disarm]),
        MavCmd::MAV_CMD_DO_FLIGHTTERMINATION if it.param1 > 0.5 => Ok(vec![Ask::Stop]),
        _ => Err(MavResult::MAV_RESULT_UNSUPPORTED),
    }
}

/// Converts a command whose place is in whole numbers.
fn long(it: &COMMAND_INT_DATA) -> COMMAND_LONG_DATA {
    COMMAND_LONG_DATA {
        command: it.command,
        param1: it.param1,
        param2: it.param2,
        param3: it.param3,
        param4: it.param4,
        param5: it.x as f32,
        param6: it.y as f32,
        param7: it.z,
        ..COMMAND_LONG_DATA::DEFAULT
    }
}

/// Converts a parameter to the number of a message.
fn number(parameter: f32) -> Option<u32> {
    // 24 bits, which the parameter holds exactly.
    let sound = (0.0..16_777_216.0).contains(&parameter) && parameter.fract() == 0.0;
    sound.then_some(parameter as u32)
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
    let held = f64::from(testbed.station.signal(catalogue::WANTED_YAW));
    let ignored = it.type_mask.contains(Mask::POSITION_TARGET_TYPEMASK_YAW_IGNORE);
    // Level, the angle of a passive rotation about the axis up is equal to an active one's about the axis down.
    let yaw = if ignored { held } else { f64::from(it.yaw) };
    Ok(Ask::Fly { points: vec![point(it.x.into(), -f64::from(it.y), -f64::from(it.z), yaw)] })
}

fn point(x: f64, y: f64, z: f64, yaw: f64) -> Point {
    Point { time: 0.0, x, y, z, yaw }
}
