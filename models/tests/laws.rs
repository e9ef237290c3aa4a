//! The laws of the loops, one by one, against the thesis' formulas.

use bessemer::nalgebra::{SVector, Vector2, Vector3};
use bessemer::requirement;
use models::{Attitude, Controller, Estimate, Height, Parameters, Target, horizontal};

const WEIGHT: f64 = 0.07 * 9.81;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-15
}

#[test]
#[requirement("HLR-01")]
fn takeoff_pushes_a_fifth_more_than_the_weight() {
    let mut height = Height::default();
    let target = Target { take_off: true, position: Vector3::z(), ..Target::default() };
    let thrust = height.step(&Parameters::mambo(), &target, 0.3, 1.0);
    assert!(close(thrust, 1.2 * WEIGHT), "{thrust}");
    assert_eq!(height, Height::default(), "the integral waits");
}

#[test]
#[requirement("HLR-02")]
fn height_adds_its_three_terms() {
    let mut height = Height { integral: 2.0 };
    let target = Target {
        position: Vector3::new(9.0, 9.0, 1.0),
        velocity: Vector3::new(9.0, 9.0, 0.5),
        climb_acceleration: 0.4,
        ..Target::default()
    };
    let thrust = height.step(&Parameters::mambo(), &target, 0.8, 0.1);
    let expected = WEIGHT + 0.07 * 0.4 + 1.5 * 0.2 + 0.05 * 2.0 + 0.3 * 0.4;
    assert!(close(thrust, expected), "{thrust}");
    assert!(close(height.integral, 2.0 + 0.2 * 0.005), "{height:?}");
}

#[test]
#[requirement("HLR-03")]
fn to_go_forward_is_to_pitch_down_and_to_go_left_is_to_roll_up() {
    let parameters = Parameters::thesis();
    let mut target =
        Target { position: Vector3::new(1.0, 2.0, 3.0), yaw: 0.7, ..Target::default() };
    let velocity = Vector3::new(0.3, 0.2, 0.1);
    let wanted = horizontal::lean(&parameters, &target, &Vector3::zeros(), &velocity);
    let expected = Vector3::new(0.24 * 2.0 - 0.1 * 0.2, -0.24 * 1.0 + 0.1 * 0.3, 0.7);
    assert!((wanted - expected).norm() < 1e-15, "{wanted}");
    // A planned acceleration has its own tilt, in the same directions.
    target.acceleration = Vector2::new(0.981, 1.962);
    let planned = horizontal::lean(&parameters, &target, &Vector3::zeros(), &velocity);
    let difference = planned - wanted - Vector3::new(0.2, -0.1, 0.0);
    assert!(difference.norm() < 1e-15, "{planned}");
}

#[test]
#[requirement("HLR-04")]
fn attitude_adds_the_terms_of_each_axis() {
    let mut attitude = Attitude { integral: Vector3::new(0.1, 0.2, 0.3) };
    let error = Vector3::new(0.1, 0.2, 0.3);
    let error_rate = Vector3::new(0.4, 0.5, 0.6);
    let torque = attitude.step(&Parameters::mambo(), &error, &error_rate, false);
    let expected = Vector3::new(
        0.01 * 0.1 + 0.01 * 0.1 + 0.0028 * 0.4,
        0.014 * 0.2 + 0.01 * 0.2 + 0.002 * 0.5,
        0.005 * 0.3 + 0.0012 * 0.6,
    );
    assert!((torque - expected).norm() < 1e-15, "{torque}");
    let integral = Vector3::new(0.1, 0.2, 0.3) + error * 0.005;
    assert!((attitude.integral - integral).norm() < 1e-15, "{attitude:?}");
}

#[test]
#[requirement("HLR-15")]
fn motors_stop_when_the_ground_holds_what_is_asked_to_sink() {
    let parameters = Parameters::mambo();
    let mut controller = Controller::default();
    let none = SVector::zeros();
    let mut target =
        Target { land: true, position: Vector3::new(0.0, 0.0, -0.05), ..Target::default() };
    let at = |z: f64, climb: f64| Estimate {
        position: Vector3::new(0.0, 0.0, z),
        velocity: Vector3::new(0.0, 0.0, climb),
        ..Estimate::default()
    };
    let mut motors = |target: &Target, estimate: &Estimate| {
        controller.step(&parameters, estimate, target, &none).motors.amax()
    };
    for (height, climb, why) in [
        (0.05, -0.25, "it still sinks"),
        (0.09, -0.081, "it sinks slowly"),
        (0.101, 0.0, "it hovers"),
    ] {
        for _ in 0..100 {
            assert!(motors(&target, &at(height, climb)) > 0.0, "{why}");
        }
    }
    target.position.z = -0.019;
    assert!((0..100).all(|_| motors(&target, &at(0.005, 0.0)) > 0.0), "it may still descend");
    target.position.z = -0.021;
    let steps = (0..100).take_while(|_| motors(&target, &at(0.005, 0.0)) > 0.0).count();
    assert!((28..31).contains(&steps), "{steps}");
    assert_eq!(motors(&target, &at(0.2, 0.5)), 0.0, "a bounce does not start them");

    target.land = false;
    target.take_off = true;
    assert!(motors(&target, &at(0.0, 0.0)) > 300.0);
}

#[test]
#[requirement("HLR-04")]
fn torque_lowers_the_angle() {
    // Positive roll error: the left pair (arms 1, 2) pushes less, so that the passive angle grows.
    let estimate = Estimate { angles: Vector3::new(-0.01, 0.0, 0.0), ..Estimate::default() };
    let command = Controller::default().step(
        &Parameters::mambo(),
        &estimate,
        &Target::default(),
        &SVector::zeros(),
    );
    assert!(command.motors[0] < command.motors[3], "{:?}", command.motors);
    assert!(command.motors[1] < command.motors[2], "{:?}", command.motors);
}
