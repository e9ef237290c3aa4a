//! The telemetry of the ground station in MAVLink's messages.
//!
//! Frames: MAVLink's north, east and down are the room's x, -y and -z; its angles are rotations about the body axes
//! forward, right, down, in the order yaw, pitch, roll.

use crate::testbed::{Testbed, period};
use ::mavlink::dialects::common::*;
use models::{Alarm, Phase};
use nalgebra::{Rotation3, Vector3};
use sim::ground_station::Record;
use sim::plant::rotation;

/// Number of records between two messages with the position.
const PLACE: u32 = 5;

/// Returns the messages with the attitude and, every few records, the position.
pub fn record(testbed: &Testbed, record: &Record, count: u32) -> Vec<MavMessage> {
    let time_boot_ms = (f64::from(record.period) * 1000.0 * period()) as u32;
    let mut told = Vec::new();
    // What is not chosen to come down is not known.
    if let (Some(angles), Some(rates)) = (read(testbed, [3, 4, 5]), read(testbed, [9, 10, 11])) {
        let (roll, pitch, yaw) = turned(&angles);
        told.push(MavMessage::ATTITUDE(ATTITUDE_DATA {
            time_boot_ms,
            roll: roll as f32,
            pitch: pitch as f32,
            yaw: yaw as f32,
            rollspeed: rates.x as f32,
            pitchspeed: -rates.y as f32,
            yawspeed: -rates.z as f32,
        }));
    }
    let place = place(testbed).zip(read(testbed, [6, 7, 8]));
    if let Some((place, velocity)) = place.filter(|_| count.is_multiple_of(PLACE)) {
        told.push(MavMessage::LOCAL_POSITION_NED(LOCAL_POSITION_NED_DATA {
            time_boot_ms,
            x: place.x as f32,
            y: -place.y as f32,
            z: -place.z as f32,
            vx: velocity.x as f32,
            vy: -velocity.y as f32,
            vz: -velocity.z as f32,
        }));
    }
    told
}

/// Returns the position of the aircraft in the room, m, if it is received.
pub fn place(testbed: &Testbed) -> Option<Vector3<f64>> {
    read(testbed, [0, 1, 2])
}

/// Returns the time since the take-off, s, if it is received.
pub fn flight_time(testbed: &Testbed) -> Option<f64> {
    read(testbed, [17; 3]).map(|it| it.x)
}

fn read(testbed: &Testbed, signals: [u8; 3]) -> Option<Vector3<f64>> {
    let known = signals.iter().all(|it| testbed.station.chosen().contains(it));
    known.then(|| Vector3::from(signals.map(|it| f64::from(testbed.station.signal(it)))))
}

/// Converts the thesis' angles to MAVLink's roll, pitch and yaw, rad.
fn turned(angles: &Vector3<f64>) -> (f64, f64, f64) {
    let flipped = nalgebra::Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    Rotation3::from_matrix_unchecked(flipped * rotation(angles) * flipped).euler_angles()
}

/// Returns true if the motors turn in a phase of the flight.
pub fn is_flying(phase: u8) -> bool {
    phase != Phase::Ready as u8 && phase != Phase::Over as u8
}

/// Returns the heartbeat: mode, alarm, and whether the aircraft can take off.
pub fn heartbeat(testbed: &Testbed) -> MavMessage {
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

/// Returns the message with the phase of the flight.
pub fn landed(testbed: &Testbed) -> MavMessage {
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

/// Returns the battery of the simulated aircraft; its own telemetry does not include it.
pub fn battery(testbed: &Testbed) -> MavMessage {
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
        ..BATTERY_STATUS_DATA::DEFAULT
    })
}
