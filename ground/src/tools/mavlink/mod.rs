//! The flight as a MAVLink 2 system: what comes down as its telemetry, its commands as orders.
//!
//! One ground station at one address; what others send to the socket does not arrive. It takes the command with its first
//! command if nobody has it, and loses it when it is silent; to stop, it need not have it. A command is acknowledged
//! when it has been sent to the aircraft.
//!
//! Frames: MAVLink's north, east and down are the room's x, -y and -z; its angles are those of the turns about body
//! axes forward, right, down, in the order yaw, pitch, roll. Knows messages, not what is done about them.

use super::Tool;
use crate::bench::Period;
use crate::command::Seat;
use crate::messages::{Ask, Flown, Point};
use crate::testbed::{Testbed, period};
use ::mavlink::dialects::common::*;
use ::mavlink::error::MessageReadError;
use ::mavlink::{MAVLinkV2MessageRaw, MavHeader, MavlinkReader, MavlinkVersion};
use models::tuning::TUNABLE;
use models::{Alarm, Phase};
use nalgebra::{Rotation3, Vector3};
use sim::ground_station::{News, Record};
use sim::plant::rotation;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};

/// Our system and component.
const SYSTEM: u8 = 1;
const COMPONENT: u8 = 1;

/// After so long without a word the ground station commands no more, s.
const SILENT: f64 = 5.0;

/// After so long without a word the aircraft's heart beats no more, s.
const LOST: f64 = 3.0;

/// Datagrams that are taken in a period: more wait in the socket, and are lost there.
const MOST: usize = 16;

/// Heartbeats, battery and phase go out every so many periods; the position with every fifth record.
const BEAT: u64 = 200;
const PHASE: u64 = 40;
const PLACE: u32 = 5;

/// With this, a disarming in the air is meant (MAV_CMD_COMPONENT_ARM_DISARM).
const FORCE: f32 = 21196.0;

/// What the parameters are called, at most 16 letters, in the order of `models::tuning`.
const NAMES: [&str; TUNABLE] = [
    "HEIGHT_P",
    "HEIGHT_I",
    "HEIGHT_D",
    "ROLL_P",
    "ROLL_I",
    "ROLL_D",
    "PITCH_P",
    "PITCH_I",
    "PITCH_D",
    "YAW_P",
    "YAW_D",
    "X_P",
    "X_D",
    "Y_P",
    "Y_D",
    "FF_GAIN",
    "FF_FRICTION",
    "LAND_RATE",
    "TAKEOFF_EXCESS",
    "CANDIDATE",
];

/// The link to a MAVLink ground station.
#[derive(Debug)]
pub struct Mavlink {
    socket: UdpSocket,
    sequence: u8,
    heard: Option<f64>,
    records: u32,
    wanted: Vec<MavMessage>,
}

/// What a command comes to.
type Verdict = Result<Vec<Ask>, MavResult>;

impl Mavlink {
    /// A link to the ground station that listens at an address.
    ///
    /// # Errors
    /// There is no port.
    pub fn start(station: SocketAddr) -> io::Result<Self> {
        let own: IpAddr = match station.ip().is_loopback() && station.is_ipv4() {
            true => Ipv4Addr::LOCALHOST.into(),
            false if station.is_ipv4() => Ipv4Addr::UNSPECIFIED.into(),
            false => std::net::Ipv6Addr::UNSPECIFIED.into(),
        };
        let socket = UdpSocket::bind((own, 0))?;
        socket.connect(station)?;
        socket.set_nonblocking(true)?;
        Ok(Self { socket, sequence: 0, heard: None, records: 0, wanted: Vec::new() })
    }

    fn send(&mut self, message: &MavMessage) {
        let header = MavHeader {
            system_id: SYSTEM.into(),
            component_id: COMPONENT,
            sequence: self.sequence,
        };
        self.sequence = self.sequence.wrapping_add(1);
        let mut raw = MAVLinkV2MessageRaw::new();
        raw.serialize_message(header, message);
        // Nobody there, or no room: lost, as datagrams are.
        let _ = self.socket.send(raw.raw_bytes());
    }

    /// What a message asks for.
    fn take(&mut self, testbed: &Testbed, seat: &Seat, message: &MavMessage) -> Vec<Ask> {
        match message {
            MavMessage::COMMAND_LONG(it) if is_ours(it.target_system, it.target_component) => {
                let verdict = command(testbed, it).and_then(|asks| allowed(seat, asks));
                let result = verdict.as_ref().err().copied();
                let result = result.unwrap_or(MavResult::MAV_RESULT_ACCEPTED);
                let ack = COMMAND_ACK_DATA { command: it.command, result };
                self.send(&MavMessage::COMMAND_ACK(ack));
                verdict.unwrap_or_default()
            }
            MavMessage::SET_POSITION_TARGET_LOCAL_NED(it)
                if is_ours(it.target_system, it.target_component) =>
            {
                place(testbed, it).and_then(|ask| allowed(seat, vec![ask])).unwrap_or_default()
            }
            MavMessage::PARAM_REQUEST_LIST(it)
                if is_ours(it.target_system, it.target_component) =>
            {
                self.wanted.extend((0..TUNABLE).map(|n| parameter(testbed, n)));
                Vec::new()
            }
            MavMessage::PARAM_REQUEST_READ(it)
                if is_ours(it.target_system, it.target_component) =>
            {
                let named = it.param_id.to_str().ok().and_then(number_of);
                let number = usize::try_from(it.param_index).ok().or(named);
                self.wanted.extend(number.filter(|n| *n < TUNABLE).map(|n| parameter(testbed, n)));
                Vec::new()
            }
            MavMessage::PARAM_SET(it) if is_ours(it.target_system, it.target_component) => {
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
            _ => Vec::new(),
        }
    }

    fn tell_record(&mut self, testbed: &Testbed, record: &Record) {
        let time_boot_ms = (f64::from(record.period) * 1000.0 * period()) as u32;
        let read = |signals: [u8; 3]| {
            let known = signals.iter().all(|it| testbed.station.chosen().contains(it));
            known.then(|| Vector3::from(signals.map(|it| f64::from(testbed.station.signal(it)))))
        };
        // What is not chosen to come down is not known.
        if let (Some(angles), Some(rates)) = (read([3, 4, 5]), read([9, 10, 11])) {
            let (roll, pitch, yaw) = turned(&angles);
            self.send(&MavMessage::ATTITUDE(ATTITUDE_DATA {
                time_boot_ms,
                roll: roll as f32,
                pitch: pitch as f32,
                yaw: yaw as f32,
                rollspeed: rates.x as f32,
                pitchspeed: -rates.y as f32,
                yawspeed: -rates.z as f32,
            }));
        }
        self.records = self.records.wrapping_add(1);
        if let (true, Some(place), Some(velocity)) =
            (self.records.is_multiple_of(PLACE), read([0, 1, 2]), read([6, 7, 8]))
        {
            self.send(&MavMessage::LOCAL_POSITION_NED(LOCAL_POSITION_NED_DATA {
                time_boot_ms,
                x: place.x as f32,
                y: -place.y as f32,
                z: -place.z as f32,
                vx: velocity.x as f32,
                vy: -velocity.y as f32,
                vz: -velocity.z as f32,
            }));
        }
    }
}

impl Tool for Mavlink {
    fn listen(&mut self, testbed: &Testbed, seat: &Seat) -> Vec<Ask> {
        let now = testbed.now();
        let mut asks = Vec::new();
        let mut datagram = [0; 2048];
        for _ in 0..MOST {
            // Refused: nobody listens there.
            let Ok(length) = self.socket.recv(&mut datagram) else { break };
            let mut reader = MavlinkReader::new(&datagram[..length]);
            loop {
                match reader.read_message::<MavMessage>(MavlinkVersion::V2) {
                    Ok((_, message)) => {
                        self.heard = Some(now);
                        asks.extend(self.take(testbed, seat, &message));
                    }
                    // Of a kind that `common` does not have.
                    Err(MessageReadError::Parse(_)) => {}
                    Err(MessageReadError::Io(_)) => break,
                }
            }
        }
        if self.heard.is_none_or(|heard| now - heard > SILENT) {
            seat.release();
        }
        asks
    }

    fn tell(&mut self, testbed: &Testbed, done: &Period, news: &[News]) {
        for message in std::mem::take(&mut self.wanted) {
            self.send(&message);
        }
        for it in news {
            match it {
                News::Record(record) => self.tell_record(testbed, record),
                News::Parameter(number, _) if usize::from(*number) < TUNABLE => {
                    self.send(&parameter(testbed, usize::from(*number)));
                }
                News::Parameter(..) | News::Status(_) => {}
            }
        }
        // What has not been heard of does not live.
        let heard = testbed.station.silence(testbed.now()).is_some_and(|since| since < LOST);
        if heard && done.number.is_multiple_of(PHASE) {
            self.send(&landed(testbed));
        }
        if heard && done.number.is_multiple_of(BEAT) {
            self.send(&heartbeat(testbed));
            self.send(&battery(testbed));
        }
    }
}

/// Whether a message goes to us; 0 stands for all.
fn is_ours(system: u8, component: u8) -> bool {
    [0, SYSTEM].contains(&system) && [0, COMPONENT].contains(&component)
}

/// Lets through what needs no command, or whoever has it.
fn allowed(seat: &Seat, asks: Vec<Ask>) -> Verdict {
    if asks.iter().all(|ask| matches!(ask, Ask::Stop)) || seat.claim(false) {
        Ok(asks)
    } else {
        Err(MavResult::MAV_RESULT_TEMPORARILY_REJECTED)
    }
}

/// What a command asks for.
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

/// A mode by its number on board.
fn mode(number: u32) -> Result<Ask, MavResult> {
    match number {
        0 => Ok(Ask::Mode { mode: Flown::ClosedLoop }),
        1 => Ok(Ask::Mode { mode: Flown::FeedForward }),
        2 => Ok(Ask::Mode { mode: Flown::Manual }),
        _ => Err(MavResult::MAV_RESULT_DENIED),
    }
}

/// A place to go to; without a yaw of its own, that of now is held.
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
    // Level, the angle of a passive rotation about the axis up is the same as an active one's about the axis down.
    let yaw = if ignored { held } else { f64::from(it.yaw) };
    Ok(Ask::Fly { points: vec![point(it.x.into(), -f64::from(it.y), -f64::from(it.z), yaw)] })
}

fn point(x: f64, y: f64, z: f64, yaw: f64) -> Point {
    Point { time: 0.0, x, y, z, yaw }
}

/// Roll, pitch and yaw as MAVLink has them, rad, from the thesis' angles.
fn turned(angles: &Vector3<f64>) -> (f64, f64, f64) {
    let flipped = nalgebra::Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    Rotation3::from_matrix_unchecked(flipped * rotation(angles) * flipped).euler_angles()
}

fn is_flying(phase: u8) -> bool {
    phase != Phase::Ready as u8 && phase != Phase::Over as u8
}

fn heartbeat(testbed: &Testbed) -> MavMessage {
    let phase = testbed.station.phase();
    let mut base_mode = MavModeFlag::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    // Ready for take-off is armed: nothing but the take-off is missing.
    if phase != Phase::Over as u8 {
        base_mode |= MavModeFlag::MAV_MODE_FLAG_SAFETY_ARMED;
    }
    let alarmed = testbed.station.signal(35) != f32::from(Alarm::Clear as u8);
    let system_status = if alarmed {
        MavState::MAV_STATE_EMERGENCY
    } else if is_flying(phase) {
        MavState::MAV_STATE_ACTIVE
    } else {
        MavState::MAV_STATE_STANDBY
    };
    MavMessage::HEARTBEAT(HEARTBEAT_DATA {
        custom_mode: testbed.station.status.as_ref().map_or(0, |status| status.mode.into()),
        mavtype: MavType::MAV_TYPE_QUADROTOR,
        autopilot: MavAutopilot::MAV_AUTOPILOT_GENERIC,
        base_mode,
        system_status,
        mavlink_version: 3,
    })
}

fn landed(testbed: &Testbed) -> MavMessage {
    let phase = testbed.station.phase();
    let landed_state = if phase == Phase::TakeOff as u8 {
        MavLandedState::MAV_LANDED_STATE_TAKEOFF
    } else if phase == Phase::Landing as u8 {
        MavLandedState::MAV_LANDED_STATE_LANDING
    } else if is_flying(phase) {
        MavLandedState::MAV_LANDED_STATE_IN_AIR
    } else {
        MavLandedState::MAV_LANDED_STATE_ON_GROUND
    };
    let vtol_state = MavVtolState::MAV_VTOL_STATE_UNDEFINED;
    MavMessage::EXTENDED_SYS_STATE(EXTENDED_SYS_STATE_DATA { vtol_state, landed_state })
}

/// The battery of the simulated aircraft, which has no word for it on its link.
fn battery(testbed: &Testbed) -> MavMessage {
    let it = testbed.bench.battery();
    let mut voltages = [u16::MAX; 10];
    voltages[0] = (1000.0 * it.voltage()) as u16;
    MavMessage::BATTERY_STATUS(BATTERY_STATUS_DATA {
        // mA·h, and not measured.
        current_consumed: (it.drawn() / 3.6) as i32,
        energy_consumed: -1,
        temperature: i16::MAX,
        voltages,
        // 10 mA.
        current_battery: (100.0 * it.current()) as i16,
        id: 0,
        battery_function: MavBatteryFunction::MAV_BATTERY_FUNCTION_ALL,
        mavtype: MavBatteryType::MAV_BATTERY_TYPE_LIPO,
        battery_remaining: (100.0 * it.left()).ceil() as i8,
    })
}

fn number_of(name: &str) -> Option<usize> {
    NAMES.iter().position(|it| *it == name)
}

/// A parameter; what is not known yet is no number.
fn parameter(testbed: &Testbed, number: usize) -> MavMessage {
    MavMessage::PARAM_VALUE(PARAM_VALUE_DATA {
        param_value: testbed.station.parameters[number].map_or(f32::NAN, |value| value as f32),
        param_count: TUNABLE as u16,
        param_index: number as u16,
        param_id: NAMES[number].into(),
        param_type: MavParamType::MAV_PARAM_TYPE_REAL32,
    })
}

/// The number that was written with the fewest digits: 0.1 became an `f32` on its way, and its bound is an `f64`.
fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}
