//! Bad input does no harm: packets that are none, sensors that are not numbers, clocks that run backwards,
//! trajectories that lead nowhere. Each has one answer, and the motors are safe.

mod recorded;

use bessemer::nalgebra::Vector3;
use bessemer::requirement;
use models::calibration::{Calibration, Echo, Flow, Inertial, Readings, Vicon};
use models::packet::{Packet, SIZE_OFFSET};
use models::receiver::{
    ARM, COMMIT, DISARM, HEARTBEAT, HELLO, MODE, Mode, NEVER, POINT, Receiver, STICKS, STOP,
    TAKE_OFF, within,
};
use models::trajectory::{SetPoint, Space, Trajectory};
use models::{Alarm, Inputs, Onboard, Outputs, Phase, Settings};
use recorded::Recorded;

fn space() -> Space {
    Settings::mambo().space
}

fn packet(kind: u8, sequence: u16, bytes: &[u8]) -> Packet {
    let mut payload = [0; 56];
    payload[..bytes.len()].copy_from_slice(bytes);
    Packet::around(kind, sequence, &payload, bytes.len())
}

fn set_point(index: u8, values: [f64; 5]) -> Vec<u8> {
    named_point(0, index, values)
}

/// A set point of a trajectory by its name.
fn named_point(name: u8, index: u8, values: [f64; 5]) -> Vec<u8> {
    let mut bytes = vec![name, index];
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}

fn take(receiver: &mut Recorded<Receiver>, packet: &Packet) {
    receiver.step(0.005, &space(), packet);
}

#[test]
#[requirement("HLR-27")]
fn every_bit_of_a_packet_counts() {
    let good = packet(POINT, 7, &set_point(0, [0.0, 0.1, 0.2, 1.0, 0.0]));
    assert!(good.is_sound());
    for byte in 0..good.length {
        for bit in 0..8 {
            let mut bad = good;
            bad.bytes[byte] ^= 1 << bit;
            assert!(!bad.is_sound(), "bit {bit} of byte {byte}");
        }
    }
    for length in [1, 2, 7, 8, 48, 50, 64, 65, 1000, usize::MAX] {
        assert!(length == good.length || !Packet { length, ..good }.is_sound(), "{length}");
    }
}

#[test]
#[requirement("HLR-27", "HLR-28", "HLR-33")]
fn what_is_no_packet_is_dropped_and_counted() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(HELLO, 1, &[]));
    let orders = receiver.orders;

    take(&mut receiver, &Packet { length: 64, bytes: [0xFF; 64] });
    take(&mut receiver, &Packet { length: usize::MAX, bytes: [0; 64] });
    // One that claims a longer payload than a packet can have.
    let mut longer = packet(MODE, 2, &[1]);
    longer.bytes[SIZE_OFFSET] = 57;
    take(&mut receiver, &Packet { length: 64, ..longer });
    assert_eq!(receiver.tally.corrupt, 3);
    take(&mut receiver, &packet(MODE, 1, &[1]));
    take(&mut receiver, &packet(MODE, 0, &[1]));
    assert_eq!(receiver.tally.outdated, 2);
    take(&mut receiver, &packet(MODE, 2, &[3]));
    take(&mut receiver, &packet(MODE, 3, &[1, 1]));
    take(&mut receiver, &packet(200, 4, &[]));
    take(&mut receiver, &packet(TAKE_OFF, 5, &[]));
    assert_eq!(receiver.tally.invalid, 4, "the last: there is no trajectory yet");
    assert_eq!(receiver.tally.accepted, 1);
    let models::receiver::Orders { sticks_age, silence, .. } = receiver.orders;
    assert_eq!(receiver.orders, models::receiver::Orders { sticks_age, silence, ..orders });
}

#[test]
#[requirement("HLR-28")]
fn numbers_go_round() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(HELLO, u16::MAX, &[]));
    take(&mut receiver, &packet(MODE, 0, &[1]));
    assert_eq!(receiver.orders.mode, Mode::FeedForward);
}

#[test]
#[requirement("HLR-31")]
fn sticks_are_numbers_within_their_limits() {
    let mut receiver = Recorded::<Receiver>::default();
    let sticks = |values: [f64; 4]| -> Vec<u8> {
        values.iter().flat_map(|value| value.to_le_bytes()).collect()
    };
    take(&mut receiver, &packet(STICKS, 1, &sticks([f64::NAN, 0.0, 0.0, 0.0])));
    take(&mut receiver, &packet(STICKS, 2, &sticks([0.0, 0.0, f64::INFINITY, 0.0])));
    assert_eq!(receiver.tally.invalid, 2);
    take(&mut receiver, &packet(STICKS, 3, &sticks([9.0, -9.0, 99.0, -99.0])));
    let taken = receiver.orders.sticks;
    assert_eq!((taken.lean.x, taken.lean.y, taken.yaw_rate, taken.climb), (0.35, -0.35, 2.0, -0.5));
}

fn trajectory(points: &[(f64, f64)]) -> Trajectory {
    let mut all = Trajectory { count: points.len(), ..Trajectory::default() };
    for (place, (time, height)) in all.points.iter_mut().zip(points) {
        *place = SetPoint { time: *time, position: Vector3::new(0.0, 0.0, *height), yaw: 0.0 };
    }
    all
}

#[test]
#[requirement("HLR-30")]
fn trajectories_out_of_order_or_out_of_bounds_are_refused() {
    assert!(trajectory(&[(0.0, 1.0), (5.0, 2.0)]).is_sound(&space()));
    for bad in [
        &[][..],
        &[(5.0, 1.0), (0.0, 2.0)],
        &[(0.0, 1.0), (0.0, 2.0)],
        &[(-1.0, 1.0)],
        &[(0.0, 1.0), (1e9, 1.0)],
        &[(0.0, 30.0)],
        &[(0.0, -1.0)],
        &[(0.0, f64::NAN)],
        &[(f64::NAN, 1.0)],
    ] {
        assert!(!trajectory(bad).is_sound(&space()), "{bad:?}");
    }
    let many = Trajectory { count: 17, ..trajectory(&[(0.0, 1.0)]) };
    assert!(!many.is_sound(&space()));
}

#[test]
#[requirement("HLR-30")]
fn a_refused_trajectory_leaves_the_one_that_is_flown() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(POINT, 1, &set_point(0, [0.0, 0.0, 0.0, 1.0, 0.0])));
    take(&mut receiver, &packet(COMMIT, 2, &[1, 0]));
    let flown = receiver.orders.trajectory;
    assert_eq!(flown.count, 1);
    take(&mut receiver, &packet(POINT, 3, &set_point(1, [0.0, 0.0, 0.0, 1.5, 0.0])));
    take(&mut receiver, &packet(COMMIT, 4, &[2, 0]));
    take(&mut receiver, &packet(COMMIT, 5, &[16, 0]));
    take(&mut receiver, &packet(COMMIT, 6, &[200, 0]));
    take(&mut receiver, &packet(POINT, 7, &set_point(16, [0.0, 0.0, 0.0, 1.5, 0.0])));
    take(&mut receiver, &packet(POINT, 8, &set_point(0, [0.0, 99.0, 0.0, 1.5, 0.0])));
    assert_eq!(receiver.orders.trajectory, flown);
    assert_eq!(receiver.tally.invalid, 5);
}

#[test]
#[requirement("HLR-30")]
fn a_trajectory_may_have_all_its_points() {
    let mut receiver = Recorded::<Receiver>::default();
    let at = |index: u8| {
        let side = f64::from(index) / 8.0 - 1.0;
        set_point(index, [f64::from(index), side, -side, 1.0, side])
    };
    for index in 0..16 {
        take(&mut receiver, &packet(POINT, 1 + u16::from(index), &at(index)));
    }
    take(&mut receiver, &packet(COMMIT, 17, &[16, 0]));
    let flown = receiver.orders.trajectory;
    assert_eq!((flown.count, flown.points[15].time, receiver.tally.invalid), (16, 15.0, 0));
    take(&mut receiver, &packet(TAKE_OFF, 18, &[]));
    assert!(receiver.orders.take_off);
}

#[test]
fn a_take_off_that_was_ordered_stays_so_in_a_smaller_space() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(POINT, 1, &set_point(0, [0.0, 0.0, 0.0, 1.0, 0.0])));
    take(&mut receiver, &packet(COMMIT, 2, &[1, 0]));
    take(&mut receiver, &packet(TAKE_OFF, 3, &[]));
    assert_eq!((receiver.orders.take_off, receiver.tally.invalid), (true, 0));
    let mut low = space();
    low.heights.y = 0.5;
    receiver.step(0.005, &low, &packet(TAKE_OFF, 4, &[]));
    assert_eq!((receiver.orders.take_off, receiver.tally.invalid), (true, 1));
}

#[test]
#[requirement("HLR-28")]
fn to_stop_a_packet_is_never_too_old() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(MODE, 900, &[1]));
    take(&mut receiver, &packet(STOP, 1, &[]));
    assert!(receiver.orders.stop);
    // And it does not bring the numbers back, at which old packets would be new.
    assert_eq!(receiver.last, 900);
    take(&mut receiver, &packet(MODE, 2, &[2]));
    assert_eq!((receiver.orders.mode, receiver.tally.outdated), (Mode::FeedForward, 1));
}

#[test]
#[requirement("HLR-28")]
fn what_makes_no_sense_moves_no_number() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(MODE, 900, &[1]));
    take(&mut receiver, &packet(HELLO, 5, &[1]));
    take(&mut receiver, &packet(MODE, 5000, &[9]));
    assert_eq!((receiver.last, receiver.tally.outdated, receiver.tally.invalid), (900, 1, 1));
}

#[test]
#[requirement("HLR-30")]
fn points_of_an_earlier_trajectory_are_in_no_later_one() {
    let mut receiver = Recorded::<Receiver>::default();
    let at = |name, index, height| {
        named_point(name, index, [5.0 * f64::from(index), 0.0, 0.0, height, 0.0])
    };
    take(&mut receiver, &packet(POINT, 1, &at(7, 0, 1.0)));
    take(&mut receiver, &packet(POINT, 2, &at(7, 1, 1.0)));
    take(&mut receiver, &packet(COMMIT, 3, &[2, 7]));
    assert_eq!((receiver.orders.trajectory.count, receiver.orders.tag), (2, 7));
    // Of the next, one point is lost on the way; so is the word to fly it, whatever it is called.
    take(&mut receiver, &packet(POINT, 4, &at(8, 1, 1.5)));
    take(&mut receiver, &packet(COMMIT, 5, &[2, 8]));
    // And of the one after that, the other point.
    take(&mut receiver, &packet(POINT, 6, &at(9, 0, 2.0)));
    take(&mut receiver, &packet(COMMIT, 7, &[2, 9]));
    take(&mut receiver, &packet(COMMIT, 8, &[1, 8]));
    assert_eq!((receiver.orders.tag, receiver.tally.invalid), (7, 3));
    take(&mut receiver, &packet(POINT, 9, &at(9, 1, 2.0)));
    take(&mut receiver, &packet(COMMIT, 10, &[2, 9]));
    let heights = [0, 1].map(|n| receiver.orders.trajectory.points[n].position.z);
    assert_eq!((receiver.orders.tag, heights), (9, [2.0, 2.0]));
}

#[test]
#[requirement("HLR-30")]
fn points_of_an_earlier_ground_are_in_no_trajectory() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(POINT, 1, &named_point(1, 1, [5.0, 1.0, 0.0, 1.0, 0.0])));
    // Another begins to number anew, and with the same names.
    take(&mut receiver, &packet(HELLO, 1, &[]));
    take(&mut receiver, &packet(POINT, 2, &named_point(1, 0, [0.0, 0.0, 0.0, 2.0, 0.0])));
    take(&mut receiver, &packet(COMMIT, 3, &[2, 1]));
    assert_eq!((receiver.orders.trajectory.count, receiver.tally.invalid), (0, 1));
}

#[test]
fn sticks_that_never_came_are_old() {
    let mut receiver = Recorded::<Receiver>::default();
    assert!(receiver.orders.sticks_age >= NEVER);
    take(&mut receiver, &packet(STICKS, 1, &[0; 32]));
    assert_eq!(receiver.orders.sticks_age, 0.0);
}

#[test]
fn no_number_is_within_no_limit() {
    assert_eq!([within(f64::NAN, 2.0), within(9.0, 2.0), within(-9.0, 2.0)], [0.0, 2.0, -2.0]);
}

#[test]
#[requirement("HLR-17")]
fn the_ground_is_missed_once_it_has_beaten() {
    let mut receiver = Recorded::<Receiver>::default();
    take(&mut receiver, &packet(HELLO, 1, &[]));
    assert!(!receiver.orders.watched);
    take(&mut receiver, &packet(HEARTBEAT, 2, &[]));
    assert!(receiver.orders.watched && receiver.orders.silence == 0.0);
    for _ in 0..200 {
        take(&mut receiver, &Packet::none());
    }
    assert!(receiver.orders.silence > 0.99);
}

/// The software on a bench at a height of 1 m, flying; `change` is what goes wrong with its inputs.
fn flown(periods: usize, mut change: impl FnMut(usize, &mut Inputs)) -> Vec<Outputs> {
    let settings = Settings::mambo();
    let mut onboard = Recorded::<Onboard>::default();
    let mut packets = vec![
        packet(HELLO, 1, &[]),
        packet(POINT, 2, &set_point(0, [0.0, 0.0, 0.0, 1.0, 0.0])),
        packet(COMMIT, 3, &[1, 0]),
        packet(TAKE_OFF, 4, &[]),
    ]
    .into_iter();
    let scale = Calibration::mambo().accelerometer_scale;
    let weight = (9.81 / scale).round() as i16;
    (0..periods)
        .map(|n| {
            // Noise of a count, so that no sensor looks dead.
            let wiggle = (n * 7919 % 13) as i16;
            let inertial = Inertial {
                fresh: true,
                gyroscope: [wiggle, 6 - wiggle, wiggle / 2],
                accelerometer: [wiggle, -wiggle, weight + wiggle],
            };
            let height = if n < 200 { 0.0 } else { 1.0 } + 1e-4 * f64::from(wiggle);
            let vicon = Vicon {
                fresh: n % 2 == 0,
                position: Vector3::new(1e-4 * f64::from(wiggle), 0.0, height),
                angles: Vector3::zeros(),
            };
            let uplink = if n >= 20 { packets.next().unwrap_or_default() } else { Packet::none() };
            let readings = Readings { inertial, vicon, ..Readings::default() };
            let time = 5000 * n as u64;
            let mut inputs = Inputs { time, readings, uplink, ..Inputs::default() };
            change(n, &mut inputs);
            onboard.step(&settings, &inputs)
        })
        .collect()
}

fn last(outputs: &[Outputs]) -> &Outputs {
    outputs.last().expect("it was flown")
}

#[test]
fn the_bench_flies() {
    let outputs = flown(1000, |_, _| ());
    let last = last(&outputs);
    assert_eq!((last.alarm, last.reference.phase), (Alarm::Clear, Phase::Flight));
    assert!(last.command.motors.min() >= 0.0 && last.command.motors.max() > 100.0);
}

#[test]
#[requirement("HLR-33")]
fn in_flight_neither_arming_nor_disarming_stops_the_motors() {
    let outputs = flown(600, |n, inputs| match n {
        400 => inputs.uplink = packet(DISARM, 5, &[]),
        450 => inputs.uplink = packet(ARM, 6, &[]),
        _ => {}
    });
    let last = last(&outputs);
    assert_eq!((last.alarm, last.reference.phase), (Alarm::Clear, Phase::Flight));
    assert!(last.command.motors.max() > 100.0);
}

#[test]
#[requirement("HLR-33", "HLR-37")]
fn a_moving_aircraft_is_not_armed_again() {
    // Nobody orders a take-off: the aircraft is carried at 2 m/s, held at a height, or rests.
    let phase = |speed: f64, height: f64| {
        let outputs = flown(60, |n, inputs| {
            match n {
                57 => inputs.uplink = packet(STOP, 2, &[]),
                59 => inputs.uplink = packet(ARM, 3, &[]),
                21.. => inputs.uplink = Packet::none(),
                _ => {}
            }
            inputs.readings.vicon.position.x += speed * 0.005 * n as f64;
            inputs.readings.vicon.position.z += height;
        });
        let last = last(&outputs);
        assert_eq!(last.estimate.velocity.norm() > 0.5, speed > 0.0, "{:?}", last.estimate);
        assert_eq!(last.command.motors.max(), 0.0);
        last.reference.phase
    };
    assert_eq!([phase(2.0, 0.0), phase(0.0, 0.5)], [Phase::Over; 2]);
    assert_eq!(phase(0.0, 0.0), Phase::Ready);
}

#[test]
#[requirement("HLR-34", "HLR-37")]
fn a_stop_stops_the_motors_in_its_period() {
    let outputs = flown(800, |n, inputs| match n {
        600 => inputs.uplink = packet(STOP, 5, &[]),
        700 => inputs.uplink = packet(TAKE_OFF, 6, &[]),
        _ => {}
    });
    assert!(outputs[599].command.motors.max() > 100.0);
    for after in &outputs[600..] {
        assert_eq!((after.alarm, after.reference.phase), (Alarm::Commanded, Phase::Over));
        assert_eq!(after.command.motors.amax(), 0.0);
    }
}

#[test]
#[requirement("HLR-20", "HLR-21")]
fn vicon_without_numbers_is_vicon_lost() {
    let nonsense = [f64::NAN, f64::INFINITY, -1e300];
    let outputs = flown(1000, |n, inputs| {
        if n >= 500 {
            inputs.readings.vicon.position.z = nonsense[n % 3];
            inputs.readings.vicon.angles.x = nonsense[(n + 1) % 3];
        }
    });
    let last = last(&outputs);
    assert_eq!(last.alarm, Alarm::Clear);
    assert!(last.ages.vicon > 2.4, "{:?}", last.ages);
    assert!(last.estimate.position.norm().is_finite() && last.command.motors.sum().is_finite());
}

/// The longest period: every sensor delivers, the gyroscope is stuck, and the ground sends packets.
#[test]
fn in_flight_all_sensors_deliver_while_the_gyroscope_is_stuck() {
    let outputs = flown(1000, |n, inputs| {
        let wiggle = (n * 7919 % 13) as i16;
        let readings = &mut inputs.readings;
        if n >= 600 {
            readings.inertial.gyroscope = [3, 3, 3];
            readings.vicon.fresh = true;
            readings.vicon.angles.z = 1e-3 * f64::from(wiggle);
            readings.echo = Echo { fresh: true, delay: 5800 + wiggle as u32 };
            readings.flow = Flow { fresh: true, velocity: [wiggle, -wiggle] };
            let point = set_point((n % 16) as u8, [0.5 * (n % 16) as f64, 0.1, 0.1, 1.0, 0.0]);
            inputs.uplink = match n % 32 {
                31 => packet(COMMIT, n as u16, &[16, 0]),
                _ => packet(POINT, n as u16, &point),
            };
        }
    });
    let last = last(&outputs);
    assert!(last.ages.inertial > 1.0 && last.ages.vicon < 0.1, "{:?}", last.ages);
    assert!(last.estimate.position.norm().is_finite() && last.command.motors.sum().is_finite());
}

#[test]
#[requirement("HLR-20")]
fn angles_without_numbers_alone_do_no_harm() {
    let outputs = flown(1000, |n, inputs| {
        if n >= 500 {
            inputs.readings.vicon.angles.y = f64::NAN;
        }
    });
    assert!(last(&outputs).estimate.angles.norm() < 0.1, "{:?}", last(&outputs).estimate);
}

/// Failures of the inertial sensors from period 600 on.
const GYROSCOPE_LOST: [fn(usize, &mut Inputs); 3] = [
    |n, inputs| {
        if n >= 600 {
            inputs.readings.inertial.gyroscope = [5, 5, 5];
        }
    },
    |n, inputs| inputs.readings.inertial.fresh &= n < 600,
    |n, inputs| {
        if n >= 600 {
            inputs.readings.inertial.gyroscope[0] = i16::MIN;
        }
    },
];

#[test]
#[requirement("HLR-21", "HLR-22", "HLR-24")]
fn without_its_gyroscope_the_aircraft_lands() {
    for lost in GYROSCOPE_LOST {
        let outputs = flown(620, lost);
        let landing = outputs.iter().position(|out| out.reference.phase == Phase::Landing);
        let landing = landing.expect("a landing");
        assert!((604..608).contains(&landing), "{landing}");
        assert!(outputs[landing..].iter().all(|out| out.alarm == Alarm::Clear));
    }
}

#[test]
#[requirement("HLR-25")]
fn with_nothing_that_shows_how_it_leans_it_stops() {
    for lost in GYROSCOPE_LOST {
        let outputs = flown(700, |n, inputs| {
            lost(n, inputs);
            inputs.readings.vicon.fresh &= n < 600;
        });
        let raised =
            outputs.iter().position(|out| out.alarm == Alarm::Unmeasured).expect("an alarm");
        assert!((620..630).contains(&raised), "{raised}");
        assert!(outputs[raised..].iter().all(|out| out.command.motors.amax() == 0.0));
    }
}

#[test]
#[requirement("HLR-37", "HLR-39")]
fn time_that_runs_backwards_stops_the_motors() {
    let backwards = |n: usize, inputs: &mut Inputs| {
        if n >= 600 {
            inputs.time = 5_000_000 - 5000 * n as u64 % 5_000_000;
        }
    };
    let standing =
        |n: usize, inputs: &mut Inputs| inputs.time = inputs.time.min(5000 * 600) + n as u64 / 9999;
    for outputs in [flown(700, backwards), flown(700, standing)] {
        let last = last(&outputs);
        assert_eq!((last.alarm, last.reference.phase), (Alarm::Clock, Phase::Over));
        assert_eq!(last.command.motors.amax(), 0.0);
        let first = outputs.iter().position(|out| out.alarm == Alarm::Clock).expect("an alarm");
        assert!((619..=620).contains(&first), "{first}: after 20 wrong periods");
    }
    // A clock that stumbles once is no reason to fall.
    let once = |n: usize, inputs: &mut Inputs| {
        if n == 600 {
            inputs.time = 0;
        }
    };
    assert_eq!(last(&flown(700, once)).alarm, Alarm::Clear);
}

#[test]
#[requirement("HLR-27")]
fn garbage_on_the_link_changes_nothing() {
    let clean = flown(1000, |_, _| ());
    let dirty = flown(1000, |n, inputs| {
        if n > 100 {
            inputs.uplink.length = n % 70;
            for (at, byte) in inputs.uplink.bytes.iter_mut().enumerate() {
                *byte = (n * 31 + at * 17) as u8;
            }
        }
    });
    let commands = |all: &[Outputs]| all.iter().map(|out| out.command).collect::<Vec<_>>();
    assert_eq!(commands(&clean), commands(&dirty));
}
