//! The telemetry of the ground station in MAVLink's messages.
//!
//! Frames: MAVLink's north, east and down are the room's x, -y and -z; its angles are rotations about the body axes
//! forward, right, down, in the order yaw, pitch, roll.

use crate::catalogue;
use crate::refusal::{self, Situation};
use crate::testbed::{Testbed, period};
use ::mavlink::dialects::common::*;
use models::{Alarm, Phase};
use nalgebra::{Rotation3, Vector3};
use sim::Aircraft;
use sim::plant::rotation;

/// Mean radius of the earth, m.
const EARTH: f64 = 6_371_008.8;

/// Place on the earth of the room's origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Origin {
    /// Latitude, 1e-7°.
    pub latitude: i32,
    /// Longitude, 1e-7°.
    pub longitude: i32,
    /// Height above the mean sea level, mm.
    pub altitude: i32,
}

impl Origin {
    /// Returns latitude and longitude of a place in the room, 1e-7°, on a sphere.
    fn located(&self, place: &Vector3<f64>) -> [i32; 2] {
        let north = f64::from(self.latitude) * 1e-7;
        let degrees = |arc: f64| arc.to_degrees() * 1e7;
        let latitude = f64::from(self.latitude) + degrees(place.x / EARTH);
        let longitude = f64::from(self.longitude)
            - degrees(place.y / (EARTH * north.to_radians().cos().max(1e-6)));
        [latitude.round() as i32, longitude.round() as i32]
    }
}

/// Returns the time of the last record since the software began, ms.
fn boot(testbed: &Testbed) -> u32 {
    let periods = testbed.station.record().map_or(0, |record| record.period);
    (f64::from(periods) * 1000.0 * period()) as u32
}

/// Returns the attitude; none without its signals.
pub fn attitude(testbed: &Testbed) -> Option<MavMessage> {
    let angles = read(testbed, catalogue::ANGLES)?;
    let rates = read(testbed, catalogue::RATES)?;
    let (roll, pitch, yaw) = turned(&angles);
    Some(MavMessage::ATTITUDE(ATTITUDE_DATA {
        time_boot_ms: boot(testbed),
        roll: roll as f32,
        pitch: pitch as f32,
        yaw: yaw as f32,
        rollspeed: rates.x as f32,
        pitchspeed: -rates.y as f32,
        yawspeed: -rates.z as f32,
    }))
}

/// Returns the position and velocity in the room; none without their signals.
pub fn local_position(testbed: &Testbed) -> Option<MavMessage> {
    let (place, velocity) = (place(testbed)?, read(testbed, catalogue::VELOCITY)?);
    Some(MavMessage::LOCAL_POSITION_NED(LOCAL_POSITION_NED_DATA {
        time_boot_ms: boot(testbed),
        x: place.x as f32,
        y: -place.y as f32,
        z: -place.z as f32,
        vx: velocity.x as f32,
        vy: -velocity.y as f32,
        vz: -velocity.z as f32,
    }))
}

/// Returns the position and velocity on the earth; none without their signals.
pub fn global_position(testbed: &Testbed, origin: &Origin) -> Option<MavMessage> {
    let (place, velocity) = (place(testbed)?, read(testbed, catalogue::VELOCITY)?);
    let (_, _, yaw) = turned(&read(testbed, catalogue::ANGLES)?);
    let [lat, lon] = origin.located(&place);
    let height = (1000.0 * place.z) as i32;
    let speed = |it: f64| (100.0 * it) as i16;
    Some(MavMessage::GLOBAL_POSITION_INT(GLOBAL_POSITION_INT_DATA {
        time_boot_ms: boot(testbed),
        lat,
        lon,
        alt: origin.altitude.saturating_add(height),
        relative_alt: height,
        vx: speed(velocity.x),
        vy: speed(-velocity.y),
        vz: speed(-velocity.z),
        // 0.01°, from 0 to 35,999.
        hdg: (yaw.to_degrees().rem_euclid(360.0) * 100.0) as u16 % 36_000,
    }))
}

/// Returns the place of the start: the room's origin.
pub fn home(origin: &Origin) -> MavMessage {
    MavMessage::HOME_POSITION(HOME_POSITION_DATA {
        latitude: origin.latitude,
        longitude: origin.longitude,
        altitude: origin.altitude,
        q: [1.0, 0.0, 0.0, 0.0],
        ..HOME_POSITION_DATA::DEFAULT
    })
}

/// Returns the place of the room's origin on the earth.
pub fn origin(origin: &Origin) -> MavMessage {
    MavMessage::GPS_GLOBAL_ORIGIN(GPS_GLOBAL_ORIGIN_DATA {
        latitude: origin.latitude,
        longitude: origin.longitude,
        altitude: origin.altitude,
        ..GPS_GLOBAL_ORIGIN_DATA::DEFAULT
    })
}

/// Sensors and motors that the aircraft has, that are in use, and that are healthy.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Parts {
    present: MavSysStatusSensor,
    enabled: MavSysStatusSensor,
    healthy: MavSysStatusSensor,
}

/// Returns the state of the parts. A sensor whose age is not received is neither enabled nor healthy.
fn parts(now: &Situation) -> Parts {
    use MavSysStatusSensor as Part;
    let inertial = Part::MAV_SYS_STATUS_SENSOR_3D_GYRO | Part::MAV_SYS_STATUS_SENSOR_3D_ACCEL;
    let (vicon, height) = (
        Part::MAV_SYS_STATUS_SENSOR_EXTERNAL_GROUND_TRUTH,
        Part::MAV_SYS_STATUS_SENSOR_LASER_POSITION,
    );
    let (motors, ready) =
        (Part::MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS, Part::MAV_SYS_STATUS_PREARM_CHECK);
    let present = inertial | vicon | height | motors | ready;
    let (mut enabled, mut healthy) = (present, present);
    let checks = refusal::checks(now);
    let [_, _, seen, measured, _] = &checks;
    for (part, check) in [(vicon, seen), (height, measured)] {
        enabled.set(part, check.known);
        healthy.set(part, check.known && check.problem.is_none());
    }
    enabled.set(motors, now.is_flying());
    healthy.set(motors, now.clear);
    // An aircraft that flies has passed the checks.
    healthy.set(ready, now.is_flying() || checks.iter().all(|check| check.problem.is_none()));
    Parts { present, enabled, healthy }
}

/// Returns the state of sensors, motors and battery.
pub fn system(testbed: &Testbed, now: &Situation) -> MavMessage {
    let Parts { present, enabled, healthy } = parts(now);
    let cell = testbed.bench.battery();
    MavMessage::SYS_STATUS(SYS_STATUS_DATA {
        onboard_control_sensors_present: present,
        onboard_control_sensors_enabled: enabled,
        onboard_control_sensors_health: healthy,
        voltage_battery: (1000.0 * cell.voltage()) as u16,
        current_battery: (100.0 * cell.current()) as i16,
        battery_remaining: (100.0 * cell.left()).ceil() as i8,
        drop_rate_comm: lost(testbed),
        ..SYS_STATUS_DATA::DEFAULT
    })
}

/// Returns the share of the downlink's packets that were lost, 0.01 %.
fn lost(testbed: &Testbed) -> u16 {
    let down = testbed.station.down;
    let all = (down.heard + down.missing).max(1);
    (10_000 * down.missing / all) as u16
}

/// Returns the versions and abilities of the onboard software.
pub fn version() -> MavMessage {
    use MavProtocolCapability as Able;
    // Major, minor and patch in a byte each; the last byte is the kind: 0 for development.
    let parts = [env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR")];
    let [major, minor] = parts.map(|it| it.parse::<u32>().unwrap_or_default());
    let patch = env!("CARGO_PKG_VERSION_PATCH").parse::<u32>().unwrap_or_default();
    MavMessage::AUTOPILOT_VERSION(AUTOPILOT_VERSION_DATA {
        capabilities: Able::MAV_PROTOCOL_CAPABILITY_MISSION_INT
            | Able::MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST
            | Able::MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_LOCAL_NED
            | Able::MAV_PROTOCOL_CAPABILITY_FLIGHT_TERMINATION
            | Able::MAV_PROTOCOL_CAPABILITY_MAVLINK2,
        flight_sw_version: major << 24 | minor << 16 | patch << 8,
        ..AUTOPILOT_VERSION_DATA::DEFAULT
    })
}

/// Returns the position of the aircraft in the room, m, if it is received.
pub fn place(testbed: &Testbed) -> Option<Vector3<f64>> {
    read(testbed, catalogue::PLACE)
}

/// Returns the time since the take-off, s, if it is received.
pub fn flight_time(testbed: &Testbed) -> Option<f64> {
    testbed.station.received([catalogue::TIME]).map(|[time]| time)
}

fn read(testbed: &Testbed, signals: [u8; 3]) -> Option<Vector3<f64>> {
    testbed.station.received(signals).map(Vector3::from)
}

/// Returns true if the aircraft has raised an alarm.
fn is_alarmed(testbed: &Testbed) -> bool {
    testbed.station.signal(catalogue::ALARM) != f32::from(Alarm::Clear as u8)
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
    // An aircraft that is ready for take-off is armed.
    if phase != Phase::Over as u8 {
        base_mode |= MavModeFlag::MAV_MODE_FLAG_SAFETY_ARMED;
    }
    let system_status = if is_alarmed(testbed) {
        MavState::MAV_STATE_EMERGENCY
    } else if is_flying(phase) {
        MavState::MAV_STATE_ACTIVE
    } else {
        MavState::MAV_STATE_STANDBY
    };
    MavMessage::HEARTBEAT(HEARTBEAT_DATA {
        custom_mode: testbed.station.status.as_ref().map_or(0, |status| status.mode.into()),
        mavtype: match testbed.bench.aircraft() {
            Aircraft::Mambo => MavType::MAV_TYPE_QUADROTOR,
            Aircraft::F550 => MavType::MAV_TYPE_HEXAROTOR,
        },
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

#[cfg(test)]
mod tests {
    use super::*;
    use MavSysStatusSensor as Part;

    #[test]
    fn a_sensor_is_healthy_only_if_its_age_is_received_and_small() {
        let now = |ages| Situation {
            phase: Phase::Ready as u8,
            clear: true,
            arming: false,
            planned: false,
            silence: Some(0.0),
            aircraft: Aircraft::Mambo,
            height: Some(0.0),
            speed: Some(0.0),
            ages,
        };
        let (vicon, height) = (
            Part::MAV_SYS_STATUS_SENSOR_EXTERNAL_GROUND_TRUTH,
            Part::MAV_SYS_STATUS_SENSOR_LASER_POSITION,
        );
        let (ready, none) = (Part::MAV_SYS_STATUS_PREARM_CHECK, Part::empty());
        let rows = [
            (now(Some([0.01, 0.0])), vicon | height, vicon | height | ready),
            (now(Some([2.0, 0.0])), vicon | height, height),
            (now(Some([0.0, f64::NAN])), vicon | height, vicon),
            // An aircraft may be armed if a check is not known.
            (now(None), none, ready),
            // Without telemetry, received ages are old.
            (Situation { silence: None, ..now(Some([0.0, 0.0])) }, none, none),
        ];
        for (now, enabled, healthy) in rows {
            let it = parts(&now);
            assert_eq!(it.enabled & (vicon | height), enabled, "{now:?}");
            assert_eq!(it.healthy & (vicon | height | ready), healthy, "{now:?}");
        }
        let flying = Situation { phase: Phase::Flight as u8, ..now(Some([0.0, 0.0])) };
        let motors = Part::MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS;
        assert!(parts(&flying).healthy.contains(ready | motors));
        assert!(parts(&flying).enabled.contains(motors));
        assert!(!parts(&Situation { clear: false, ..flying }).healthy.contains(motors));
    }
}
