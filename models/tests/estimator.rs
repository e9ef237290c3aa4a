//! The filters: covariances stay what they are, gates keep out what is too far.

mod recorded;

use bessemer::nalgebra::{SMatrix, Vector2, Vector3};
use bessemer::requirement;
use models::Airframe;
use models::attitude_filter::AttitudeFilter;
use models::axis_filter::AxisFilter;
use models::calibration::{Calibration, Inertial, Measured, Readings, Vicon};
use models::estimator::{Estimator, Sensors};
use models::expectation::{Expectation, Push};
use models::feed_forward::{Injection, compensation};
use models::geometry::{Orientation, wrapped};
use models::stuck::Stuck;
use recorded::Recorded;

fn is_covariance<const N: usize>(p: &SMatrix<f64, N, N>) -> bool
where
    bessemer::nalgebra::Const<N>: bessemer::nalgebra::DimMin<
            bessemer::nalgebra::Const<N>,
            Output = bessemer::nalgebra::Const<N>,
        >,
{
    // A touch on the diagonal: what is known exactly has no spread.
    *p == p.transpose() && (p + SMatrix::identity() * 1e-18).cholesky().is_some()
}

#[test]
#[requirement("HLR-26")]
fn an_axis_stays_symmetric_and_positive_for_an_hour() {
    let mut axis = AxisFilter::at_rest(3.0, 0.3);
    for n in 0..720_000_u32 {
        let push = f64::from(n % 17) * 0.1 - 0.8;
        axis.predict(push, 0.005, 0.15, 0.01);
        if n % 3 == 0 {
            axis.correct(&Vector3::new(1.0, -0.01, 0.0), 0.0, 1e-12, 1e9);
        }
        if n % 7 == 0 {
            axis.correct(&Vector3::new(0.0, 1.0, 0.0), 0.0, 1e3, 1e9);
        }
        if n % 1000 == 0 {
            let covariance = axis.covariance.matrix();
            assert!(is_covariance(covariance), "{n}: {covariance}");
        }
    }
}

#[test]
#[requirement("HLR-26")]
fn the_attitude_stays_symmetric_and_positive_while_it_tumbles() {
    let mut attitude = AttitudeFilter::level(1.0, 0.05);
    for n in 0..20_000_u32 {
        let rates = Vector3::new((f64::from(n) * 0.01).sin(), 0.5, -2.0);
        attitude.predict(&rates, 0.005, 0.01, 0.0005);
        attitude.state[1] = attitude.state[1].clamp(-1.2, 1.2);
        let variance = if n % 2 == 0 { 1e-12 } else { 1.0 };
        attitude.correct(n as usize % 3, &[false; 6], 0.001, variance, 5.0);
        let covariance = attitude.covariance.matrix();
        assert!(is_covariance(covariance), "{n}: {covariance}");
    }
}

#[test]
#[requirement("HLR-20")]
fn gates_keep_out_what_is_too_far_or_no_number() {
    let mut axis = AxisFilter::at_rest(0.1, 0.1);
    let before = axis;
    let row = Vector3::new(1.0, 0.0, 0.0);
    for measured in [0.6, -0.6, f64::NAN, f64::INFINITY, 1e300] {
        assert!(!axis.correct(&row, measured, 1e-4, 5.0), "{measured}");
        assert_eq!(axis, before);
    }
    assert!(axis.correct(&row, 0.4, 1e-4, 5.0));
    assert!((axis.state[0] - 0.4).abs() < 0.01, "{}", axis.state);

    let mut attitude = AttitudeFilter::level(0.1, 0.05);
    let before = attitude;
    for innovation in [0.51, -0.51, f64::NAN, f64::INFINITY] {
        assert!(!attitude.correct(1, &[false; 6], innovation, 1e-4, 5.0), "{innovation}");
        assert_eq!(attitude, before);
    }
    assert!(attitude.correct(1, &[false; 6], 0.4, 1e-4, 5.0));
}

#[test]
#[requirement("HLR-21")]
fn counts_at_the_end_of_the_range_are_not_measured() {
    let is_measured = |sensor: usize, count: i16| {
        let mut inertial = Inertial { fresh: true, ..Inertial::default() };
        match sensor {
            0..3 => inertial.gyroscope[sensor] = count,
            _ => inertial.accelerometer[sensor - 3] = count,
        }
        let readings = Readings { inertial, ..Readings::default() };
        Calibration::mambo().measured(&readings).inertial
    };
    for sensor in 0..6 {
        for (count, measured) in [(i16::MIN, false), (-32767, false), (-32766, true)] {
            assert_eq!(is_measured(sensor, count), measured, "{sensor}: {count}");
        }
        for (count, measured) in [(32766, true), (32767, false)] {
            assert_eq!(is_measured(sensor, count), measured, "{sensor}: {count}");
        }
    }
}

#[test]
#[requirement("HLR-21")]
fn the_altimeter_is_used_within_its_range() {
    for (distance, taken) in [(0.029, false), (0.031, true), (3.9, true), (4.01, false)] {
        let mut estimator = Estimator::default();
        for n in 0..100_u32 {
            // Vicon is lost, and no echo repeats the last one.
            let echo = n == 99;
            let measured = Measured { echo, distance, ..Measured::default() };
            estimator.step(&Sensors::mambo(), &Push::default(), &measured);
        }
        assert_eq!(estimator.ages.height == 0.0, taken, "{distance} m");
    }
}

#[test]
fn an_axis_finds_the_bias_of_its_accelerometer() {
    let mut axis = AxisFilter::at_rest(1.0, 0.3);
    for _ in 0..4000 {
        axis.predict(0.2, 0.005, 0.05, 0.001);
        axis.correct(&Vector3::new(1.0, 0.0, 0.0), 0.5, 1e-6, 5.0);
    }
    assert!((axis.state - Vector3::new(0.5, 0.0, 0.2)).amax() < 0.01, "{}", axis.state);
}

#[test]
fn attitude_finds_the_biases_of_the_gyroscope() {
    let bias = Vector3::new(0.02, -0.03, 0.01);
    let mut attitude = AttitudeFilter::level(1.0, 0.05);
    for _ in 0..8000 {
        attitude.predict(&bias, 0.005, 0.005, 1e-5);
        for n in 0..3 {
            let truth = [0.1, -0.2, 0.7][n];
            attitude.correct(n, &[false; 6], truth - attitude.state[n], 1e-5, 9.0);
        }
    }
    let found = Vector3::zeros() - attitude.rates(&Vector3::zeros());
    assert!((found - bias).amax() < 1e-3, "{found}");
    assert!((attitude.angles() - Vector3::new(0.1, -0.2, 0.7)).amax() < 1e-3);
}

#[test]
fn angles_are_the_same_after_whole_turns() {
    let pi = std::f64::consts::PI;
    for (angle, expected) in [(0.0, 0.0), (3.0, 3.0), (4.0, 4.0 - 2.0 * pi), (-7.0, 2.0 * pi - 7.0)]
    {
        assert!((wrapped(angle) - expected).abs() < 1e-14, "{angle}");
    }
}

#[test]
#[requirement("HLR-18")]
fn feed_forward_carries_the_weight() {
    for airframe in [Airframe::mambo(), Airframe::hexacopter()] {
        let still = Vector3::zeros();
        let level = Orientation::of(&still);
        let speeds = compensation(&airframe, &level, &still, 0.0);
        let wrench = airframe.wrench(&speeds);
        assert!((wrench.thrust - airframe.mass * 9.81).abs() < 1e-12, "{wrench:?}");
        assert!(wrench.torque.norm() < 1e-12, "{wrench:?}");
        // (4.7): leaning, the part of the weight along the body's z.
        let leaning = Orientation::of(&Vector3::new(0.3, -0.4, 0.9));
        let thrust = airframe.wrench(&compensation(&airframe, &leaning, &still, 0.0)).thrust;
        let part = 0.3_f64.cos() * 0.4_f64.cos() * airframe.mass * 9.81;
        assert!((thrust - part).abs() < 1e-12, "{thrust}");
    }
}

#[test]
fn gains_grow_as_the_thesis_has_them() {
    let linear = Injection::linear(0.5);
    for (time, gain) in [(0.0, 0.0), (10.0, 0.0), (20.0, 0.2), (35.0, 0.5), (100.0, 0.5)] {
        assert!((linear.gain(time) - gain).abs() < 1e-12, "{time}");
    }
    let sigmoid = Injection::sigmoid(0.7);
    assert!(sigmoid.gain(10.0) < 0.02 && (sigmoid.gain(28.0) - 0.5).abs() < 0.03);
    assert_eq!(sigmoid.gain(40.0), 0.7);
    assert_eq!(Injection::constant(0.3).gain(9.9), 0.0);
    assert_eq!(Injection::constant(0.3).gain(10.0), 0.3);
    assert!((Injection::gain_for(0.75 * 9.81) - 0.5).abs() < 1e-12);
}

#[test]
fn what_the_motors_do_stands_in_for_silent_sensors() {
    // Propellers that push 5 % less than is believed, and unevenly: what the sensors show besides is learnt.
    let mut expectation = Expectation::default();
    let commanded = Push { force: 10.3, turn: Vector3::new(4.0, -2.0, 0.5) };
    let mut rates = Vector3::zeros();
    let force = Vector3::new(0.1, -0.05, 9.80665);
    for _ in 0..2000 {
        expectation.step(0.005, &commanded);
        expectation.correct_rates(&rates);
        expectation.correct_force(&force);
    }
    // From now on both are silent, and twice the torque is commanded.
    let more = Push { turn: commanded.turn * 2.0, ..commanded };
    for _ in 0..40 {
        expectation.step(0.005, &more);
        rates += commanded.turn * 0.005;
    }
    assert!(
        (expectation.predicted_force() - force).amax() < 1e-3,
        "{}",
        expectation.predicted_force()
    );
    // The motors follow within 17 ms.
    assert!((expectation.rates - rates).amax() < 0.1, "{} {rates}", expectation.rates);
}

#[test]
#[requirement("HLR-22")]
fn a_sensor_that_repeats_itself_is_not_believed_once() {
    let mut stuck = Stuck::default();
    assert!(stuck.is_new(&Vector3::new(0.1, 0.2, 0.3)));
    assert!(!stuck.is_new(&Vector3::new(0.1, 0.2, 0.3)));
    assert!(stuck.is_new(&Vector3::new(0.1, 0.2, 0.300_001)));
}

#[test]
#[requirement("HLR-21")]
fn vicon_sees_nothing_below_the_ground() {
    // Not half a box below it, as far as the box goes up: only as far as its own error and the ground's.
    for (x, y, height, taken) in [
        (0.01, 0.0, 4.9, true),
        (0.01, 0.0, 0.0, true),
        (0.01, 0.0, -0.1, true),
        (0.01, 0.0, -0.2, false),
        (0.01, 0.0, -4.9, false),
        (0.01, 0.0, 5.1, false),
        (4.9, -4.9, 1.0, true),
        (5.1, 0.0, 1.0, false),
        (0.0, -5.1, 1.0, false),
    ] {
        let mut estimator = Estimator::default();
        let position = Vector3::new(x, y, height);
        let vicon = Vicon { fresh: true, position, angles: Vector3::zeros() };
        let measured = Measured { vicon, ..Measured::default() };
        estimator.step(&Sensors::mambo(), &Push::default(), &measured);
        assert_eq!(
            (estimator.outliers == 0, estimator.ages.vicon == 0.0),
            (taken, taken),
            "{position}"
        );
    }
}

/// The longest period: each sensor corrects, the yaw is several revolutions away, and the gyroscope is stuck.
#[test]
fn all_sensors_correct_in_one_period_without_a_gyroscope() {
    let sensors = Sensors::mambo();
    let mut estimator = Recorded::<Estimator>::default();
    for n in 0..60_u32 {
        let small = f64::from(n) * 1e-4;
        let vicon = Vicon {
            fresh: true,
            position: Vector3::new(small, -small, 1.0 + small),
            angles: Vector3::new(0.01 + small, 0.02 - small, 20.0 + small),
        };
        let measured = Measured {
            inertial: true,
            rates: Vector3::repeat(0.1),
            force: Vector3::new(0.1 + small, 0.2, 9.8 - small),
            echo: true,
            distance: 1.0 + small,
            flow: true,
            flow_velocity: Vector2::new(0.02 + small, 0.02 - small),
            vicon,
        };
        let estimate = estimator.step(&sensors, &Push::default(), &measured);
        assert!(estimate.position.norm().is_finite() && estimate.angles.norm().is_finite());
    }
    assert!(estimator.gyro_lost(), "{:?}", estimator.ages);
    let ages = estimator.ages;
    assert_eq!([ages.vicon, ages.height, ages.plane], [0.0; 3], "{ages:?}");
}
