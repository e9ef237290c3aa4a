//! The reference generator follows orders: the first step, the way round, the link that is lost; and what the
//! loops remember.

mod recorded;

use bessemer::nalgebra::{Vector2, Vector3};
use bessemer::requirement;
use models::receiver::{Orders, Sticks};
use models::reference_generator::{Course, ReferenceGenerator};
use models::trajectory::{SetPoint, Trajectory};
use models::{Attitude, Estimate, Height, Mode, Parameters, Phase, Target};
use recorded::Recorded;
use std::f64::consts::PI;

/// To 1 m, and to a yaw from 5 s on.
fn orders(yaw: f64) -> Orders {
    let mut trajectory = Trajectory { count: 2, ..Trajectory::default() };
    let place = Vector3::new(0.0, 0.0, 1.0);
    trajectory.points[0] = SetPoint { time: 0.0, position: place, yaw: 0.0 };
    trajectory.points[1] = SetPoint { time: 5.0, position: place, yaw };
    Orders { take_off: true, link: true, trajectory, ..Orders::default() }
}

fn at(height: f64, yaw: f64) -> Estimate {
    Estimate {
        position: Vector3::new(0.0, 0.0, height),
        angles: Vector3::new(0.0, 0.0, yaw),
        ..Estimate::default()
    }
}

/// A generator that has followed the orders for so long, s, at the wanted height.
fn flown(generator: &mut Recorded<ReferenceGenerator>, orders: &Orders, time: f64) -> Target {
    let course = Course::mambo();
    let mut target = Target::idle();
    for _ in 0..(time / course.period).round() as u32 {
        target = generator.step(&course, orders, &at(1.0, generator.yaw), false, false).target;
    }
    target
}

#[test]
#[requirement("HLR-01")]
fn a_take_off_in_the_very_first_step_is_one() {
    let mut generator = Recorded::<ReferenceGenerator>::default();
    // The height is a little above 0, by noise.
    let first = generator.step(&Course::mambo(), &orders(0.0), &at(0.01, 0.0), false, false);
    assert_eq!(first.phase, Phase::TakeOff);
    let second = generator.step(&Course::mambo(), &orders(0.0), &at(0.01, 0.0), false, false);
    assert_eq!((second.phase, second.target.position.z), (Phase::TakeOff, 1.0));
}

#[test]
#[requirement("HLR-01")]
fn a_take_off_ends_after_a_second_or_at_half_the_height() {
    let taken = |height: f64| {
        let mut generator = Recorded::<ReferenceGenerator>::default();
        let mut phase =
            || generator.step(&Course::mambo(), &orders(0.0), &at(height, 0.0), false, false).phase;
        (0..1000).take_while(|_| phase() == Phase::TakeOff).count()
    };
    assert_eq!([taken(0.01), taken(0.49), taken(0.51)], [200, 200, 1]);
}

#[test]
#[requirement("HLR-14")]
fn a_landing_sinks_at_its_rate_from_the_wanted_height() {
    let mut generator = Recorded::<ReferenceGenerator>::default();
    flown(&mut generator, &orders(0.0), 4.0);
    let target = flown(&mut generator, &Orders { land: true, ..orders(0.0) }, 6.0);
    assert_eq!((generator.phase, target.land, target.velocity.z), (Phase::Landing, true, -0.25));
    assert!((target.position.z - (1.0 - 6.0 * 0.25)).abs() < 1e-9, "{}", target.position.z);
}

#[test]
#[requirement("HLR-31")]
fn sticks_count_as_centred_after_half_a_second() {
    let mut generator = Recorded::<ReferenceGenerator>::default();
    let sticks = Sticks { lean: Vector2::new(0.1, -0.2), yaw_rate: 0.5, climb: 0.3 };
    let manual = Orders { mode: Mode::Manual, sticks, sticks_age: 0.0, ..orders(0.0) };
    flown(&mut generator, &manual, 2.0);
    let mut wanted = |sticks_age| {
        let target = flown(&mut generator, &Orders { sticks_age, ..manual }, 0.005);
        Sticks { lean: target.lean, yaw_rate: target.yaw_rate, climb: target.velocity.z }
    };
    assert_eq!([wanted(0.5), wanted(0.501)], [sticks, Sticks::centred()]);
}

#[test]
#[requirement("HLR-09")]
fn the_yaw_set_point_keeps_to_its_rate() {
    let mut generator = Recorded::<ReferenceGenerator>::default();
    let (mut before, mut fastest) = (0.0, 0.0_f64);
    for _ in 0..2000 {
        let yaw = flown(&mut generator, &orders(3.0), 0.005).yaw;
        fastest = fastest.max((yaw - before).abs() / 0.005);
        before = yaw;
    }
    assert!((fastest - 1.0).abs() < 1e-9 && (before - 3.0).abs() < 1e-9, "{fastest} rad/s");
}

#[test]
#[requirement("HLR-05")]
fn integrals_wait_until_the_aircraft_has_left_the_ground() {
    let parameters = Parameters::mambo();
    let grounded = |height| {
        let mut generator = Recorded::<ReferenceGenerator>::default();
        let reference =
            generator.step(&Course::mambo(), &orders(0.0), &at(height, 0.0), false, false);
        reference.target.grounded
    };
    assert_eq!([grounded(0.0), grounded(0.099), grounded(0.101)], [true, true, false]);
    let (mut height, mut attitude) = (Height::default(), Attitude::default());
    let target = Target { grounded: true, position: Vector3::z(), ..Target::idle() };
    height.step(&parameters, &target, 0.0, 0.0);
    attitude.step(&parameters, &Vector3::repeat(0.3), &Vector3::zeros(), true);
    assert_eq!((height, attitude), (Height::default(), Attitude::default()));
}

#[test]
#[requirement("HLR-09")]
fn it_turns_the_short_way_round() {
    let mut generator = Recorded::<ReferenceGenerator>::default();
    flown(&mut generator, &orders(3.0), 9.0);
    assert!((generator.yaw - 3.0).abs() < 1e-9, "{}", generator.yaw);
    // From 3 to −3 it is 0.28 through half a turn, not 6 back.
    let mut back = orders(-3.0);
    back.trajectory.count = 1;
    back.trajectory.points[0].yaw = -3.0;
    let target = flown(&mut generator, &back, 1.0);
    assert!((generator.yaw - (2.0 * PI - 3.0)).abs() < 1e-9, "{}", generator.yaw);
    assert_eq!(target.yaw, generator.yaw);
}

#[test]
#[requirement("HLR-17")]
fn a_silent_ground_is_waited_for_then_left() {
    let course = Course::mambo();
    assert_eq!((course.hold_timeout, course.landing_timeout), (1.0, 6.0));
    let mut generator = Recorded::<ReferenceGenerator>::default();
    let mut orders = Orders { watched: true, silence: 0.0, ..orders(1.0) };
    flown(&mut generator, &orders, 3.0);
    assert_eq!(generator.phase, Phase::Flight);
    // It stays where it was wanted, although the trajectory goes on.
    orders.silence = course.hold_timeout + 0.01;
    flown(&mut generator, &orders, 3.0);
    assert_eq!((generator.phase, generator.wanted.yaw), (Phase::Hold, 0.0));
    orders.silence = 0.0;
    flown(&mut generator, &orders, 0.01);
    assert_eq!((generator.phase, generator.wanted.yaw), (Phase::Flight, 1.0));
    // Silent again, and for longer.
    for (silence, phase) in
        [(course.hold_timeout, Phase::Hold), (course.landing_timeout, Phase::Landing)]
    {
        orders.silence = silence + 0.01;
        flown(&mut generator, &orders, 0.01);
        assert_eq!(generator.phase, phase);
    }
    // A ground that never said that it would be heard of again is not missed.
    let mut other = Recorded::<ReferenceGenerator>::default();
    flown(&mut other, &Orders { watched: false, ..orders }, 3.0);
    assert_eq!(other.phase, Phase::Flight);
}

#[test]
#[requirement("HLR-17")]
fn a_pilot_who_is_lost_leaves_the_aircraft_where_it_is() {
    let mut generator = Recorded::<ReferenceGenerator>::default();
    let mut manual = Orders { watched: true, silence: 0.0, ..orders(0.0) };
    flown(&mut generator, &manual, 3.0);
    manual.mode = Mode::Manual;
    let moved = Estimate { position: Vector3::new(0.7, -0.4, 1.2), ..Estimate::default() };
    generator.step(&Course::mambo(), &manual, &moved, false, false);
    manual.silence = 2.0;
    let held = generator.step(&Course::mambo(), &manual, &moved, false, false);
    assert_eq!(held.phase, Phase::Hold);
    assert!(!held.target.manual);
    assert_eq!((held.target.position.x, held.target.position.y), (0.7, -0.4));
}

#[test]
fn an_aircraft_that_must_land_at_once_stops_gently_ahead_of_its_place() {
    let (course, orders) = (Course::mambo(), orders(0.0));
    let mut generator = Recorded::<ReferenceGenerator>::default();
    flown(&mut generator, &orders, 3.0);
    let moving = Estimate { velocity: Vector3::new(1.0, 0.0, 0.3), ..at(1.0, 0.0) };
    let mut before = generator.step(&course, &orders, &moving, false, true);
    assert_eq!(before.phase, Phase::Landing);
    let place = before.target.position.x;
    let limits = course.shaping;
    for _ in 0..1000 {
        let now = generator.step(&course, &orders, &moving, false, true);
        assert!(now.target.velocity.x <= before.target.velocity.x && now.target.velocity.x >= 0.0);
        assert!(now.target.acceleration.norm() < limits.acceleration / 2.0);
        assert!(now.target.position.z < before.target.position.z);
        before = now;
    }
    let way = before.target.position.x - place;
    assert!((way - 2.0 / limits.rate()).abs() < 0.02, "{way}");
}

#[test]
#[requirement("HLR-05")]
fn integrals_end_somewhere() {
    let parameters = Parameters::mambo();
    let (mut height, mut attitude) = (Height::default(), Attitude::default());
    let far = Target { position: Vector3::new(0.0, 0.0, 1000.0), ..Target::idle() };
    for _ in 0..10_000 {
        height.step(&parameters, &far, 0.0, 0.0);
        attitude.step(&parameters, &Vector3::repeat(-3.0), &Vector3::zeros(), false);
    }
    assert_eq!(height.integral, 14.0);
    assert_eq!(attitude.integral, Vector3::repeat(-0.5));
    // And let go at once.
    let near = Target { position: Vector3::new(0.0, 0.0, -1000.0), ..Target::idle() };
    height.step(&parameters, &near, 0.0, 0.0);
    assert_eq!(height.integral, 9.0);
}

#[test]
fn a_trajectory_with_all_its_points_is_flown_to_its_end() {
    let mut orders = orders(0.0);
    orders.trajectory.count = orders.trajectory.points.len();
    for (n, point) in orders.trajectory.points.iter_mut().enumerate() {
        let turn = n as f64 * 0.4;
        let position = Vector3::new(turn.sin(), turn.cos() - 1.0, 1.0);
        *point = SetPoint { time: 0.5 * n as f64, position, yaw: 2.5 * turn };
    }
    let mut generator = Recorded::<ReferenceGenerator>::default();
    let last = orders.trajectory.points[orders.trajectory.count - 1];
    flown(&mut generator, &orders, 12.0);
    assert_eq!((generator.phase, generator.wanted.position), (Phase::Flight, last.position));
}
