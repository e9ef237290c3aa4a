//! The mixer against the airframe that it commands.

use bessemer::nalgebra::{Matrix3, Matrix4, SVector, Vector3, Vector4};
use bessemer::requirement;
use models::{Airframe, Command, Layout, Parameters, Wrench};

const GRAVITY: f64 = 9.81;

fn mixed(parameters: &Parameters, thrust: f64, torque: Vector3<f64>) -> Command {
    parameters.mixer.mix(&Wrench { thrust, torque }, &SVector::zeros())
}

/// Returns thrust, roll, pitch and yaw torque of an airframe's motors at these commands.
fn loads(airframe: &Airframe, parameters: &Parameters, command: &Command) -> Vector4<f64> {
    airframe.effectiveness() * command.motors * parameters.mixer.square_per_command
}

#[test]
#[requirement("HLR-11")]
fn allocation_inverts_effectiveness_for_any_number_of_motors() {
    for layout in [Layout::Plus, Layout::Cross] {
        for motors in [4, 6, 8] {
            let airframe = Airframe {
                layout,
                motors,
                thrust_coefficients: Airframe::for_each(motors, 0.0107),
                drag_coefficients: Airframe::for_each(motors, 0.7826e-3),
                ..Airframe::mambo()
            };
            let product = airframe.effectiveness() * airframe.allocation();
            assert!((product - Matrix4::identity()).norm() < 1e-13, "{motors}: {product}");
        }
    }
}

#[test]
fn motors_of_their_own_still_give_thrust_roll_and_pitch() {
    let mut airframe = Airframe::mambo();
    airframe.thrust_coefficients[2] *= 0.9;
    let product = airframe.effectiveness() * airframe.allocation();
    let exact = product.fixed_view::<3, 3>(0, 0) - Matrix3::identity();
    assert!(exact.norm() < 1e-14, "{product}");
}

#[test]
fn effectiveness_is_the_thesis_matrix() {
    // (2.49) for the Mambo: the factor ρAR² times C_FT, l C_FT sin a, −l C_FT cos a, ±R C_MD.
    let factor = 1.184 * 0.0034 * 0.033 * 0.033;
    let lever = 0.0624 * 0.0107 * core::f64::consts::FRAC_1_SQRT_2;
    let moment = 0.033 * 0.7826e-3;
    #[rustfmt::skip]
    let expected = factor * Matrix4::new(
        0.0107,  0.0107,  0.0107,  0.0107,
         lever,   lever,  -lever,  -lever,
        -lever,   lever,   lever,  -lever,
        moment, -moment,  moment, -moment,
    );
    let effectiveness = Airframe::mambo().effectiveness();
    let quad = effectiveness.fixed_view::<4, 4>(0, 0);
    let error = (quad - expected).component_div(&expected);
    assert!(error.amax() < 1e-13, "{error}");
    assert_eq!(effectiveness.fixed_view::<4, 4>(0, 4).amax(), 0.0, "there are no more motors");
}

#[test]
#[requirement("HLR-11")]
fn motors_produce_what_is_wanted() {
    for (airframe, parameters, scale) in [
        (Airframe::mambo(), Parameters::mambo(), 1.0),
        (Airframe::hexacopter(), Parameters::hexacopter(), 20.0),
    ] {
        let torque = Vector3::new(2e-4, -3e-4, 1e-4) * scale;
        let command = mixed(&parameters, 0.7 * scale, torque);
        let wanted = Vector4::new(0.7 * scale, torque.x, torque.y, torque.z);
        let loads = loads(&airframe, &parameters, &command);
        assert!((loads - wanted).norm() < 1e-14 * scale, "{loads}");
    }
}

#[test]
fn hover_is_half_of_full_power() {
    let parameters = Parameters::mambo();
    let command = mixed(&parameters, parameters.mass * GRAVITY, Vector3::zeros());
    for motor in &command.motors.as_slice()[..4] {
        assert!((motor - 264.4).abs() < 0.1, "{motor}");
    }
    assert_eq!(command.motors.as_slice()[4..], [0.0; 4]);
}

#[test]
#[requirement("HLR-12", "HLR-13")]
fn roll_is_kept_before_yaw_and_yaw_before_height() {
    let (airframe, parameters) = (Airframe::mambo(), Parameters::mambo());
    // More of everything than the motors have.
    let wanted = Vector3::new(0.012, 0.0, 0.008);
    let got = loads(&airframe, &parameters, &mixed(&parameters, 5.0, wanted));
    assert!((got[1] - wanted.x).abs() < 1e-15, "roll is kept: {got}");
    assert!(got[2].abs() < 1e-15, "and makes no pitch: {got}");
    assert!(got[3] > 0.0 && got[3] < wanted.z, "yaw gives way: {got}");
    assert!(got[0] < 1.4, "and so does height: {got}");

    // Yaw that fits is kept, whatever the height.
    let wanted = Vector3::new(0.004, 0.002, 0.0005);
    for thrust in [-1.0, 0.0, 0.3, 5.0] {
        let got = loads(&airframe, &parameters, &mixed(&parameters, thrust, wanted));
        assert!((got.fixed_rows::<3>(1) - wanted).amax() < 1e-15, "{thrust}: {got}");
    }

    // More roll than there is: as much as there is.
    let command = mixed(&parameters, 0.7, Vector3::new(1.0, 0.0, 0.0));
    let all = Vector4::new(500.0, 500.0, 0.0, 0.0);
    assert!((command.motors.fixed_rows::<4>(0) - all).amax() < 1e-12, "{}", command.motors);
}

/// Two motors at their limits have no room for each other, and rounding must not take the room of the others.
#[test]
#[requirement("HLR-13")]
fn yaw_is_kept_beside_any_tilt_that_two_motors_share() {
    let (airframe, parameters) = (Airframe::mambo(), Parameters::mambo());
    for size in 1..=400 {
        for [roll, pitch] in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
            let size = 0.0137 * f64::from(size);
            let wanted = Vector3::new(roll * size, pitch * size, 1e-4);
            let got = loads(&airframe, &parameters, &mixed(&parameters, 0.7, wanted));
            assert!(got[3] > 0.9e-4, "{wanted}: {got}");
        }
    }
}

#[test]
fn feed_forward_adds_speed_and_leaves_torques_as_they_are() {
    let (airframe, parameters) = (Airframe::mambo(), Parameters::mambo());
    let feed_forward = Airframe::for_each(4, 1500.0);
    let wanted = Wrench { thrust: 0.1, torque: Vector3::new(2e-4, -3e-4, 1e-4) };
    let command = parameters.mixer.mix(&wanted, &feed_forward);
    let got = loads(&airframe, &parameters, &command);
    assert!((got.fixed_rows::<3>(1) - wanted.torque).amax() < 1e-15, "{got}");
    let whole = command.closed_loop + command.feed_forward;
    assert!((whole - command.speeds).amax() < 1e-9, "{whole}");
    let spins = parameters.mixer.spins;
    assert_eq!(command.feed_forward, feed_forward.component_mul(&spins));
}

#[test]
fn speeds_carry_the_signs_of_rotation() {
    // Table A.1: the largest motor speed is 2630.7 rad/s.
    let command = mixed(&Parameters::mambo(), 100.0, Vector3::zeros());
    let largest = Vector4::new(2630.7, -2630.7, 2630.7, -2630.7);
    assert!((command.speeds.fixed_rows::<4>(0) - largest).amax() < 0.1, "{}", command.speeds);
}

#[test]
#[requirement("HLR-12")]
fn motors_stand_still_when_nothing_can_be_computed() {
    let parameters = Parameters::mambo();
    for wrench in [
        Wrench { thrust: f64::NAN, torque: Vector3::zeros() },
        Wrench { thrust: 0.7, torque: Vector3::new(f64::NAN, 0.0, 0.0) },
        Wrench { thrust: 0.7, torque: Vector3::new(0.0, 0.0, f64::INFINITY) },
    ] {
        let command = parameters.mixer.mix(&wrench, &SVector::zeros());
        assert!(command.motors.iter().all(|motor| (0.0..=500.0).contains(motor)), "{command:?}");
    }
    let command = mixed(&parameters, f64::NAN, Vector3::zeros());
    assert_eq!(command.motors.amax(), 0.0);
}
