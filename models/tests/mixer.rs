//! The mixer against the airframe that it commands.

use bessemer::nalgebra::{Matrix4, Vector3, Vector4};
use models::{Airframe, Parameters};

const GRAVITY: f64 = 9.81;

#[test]
fn allocation_inverts_effectiveness() {
    let airframe = Airframe::mambo();
    let product = airframe.effectiveness() * airframe.allocation();
    assert!((product - Matrix4::identity()).norm() < 1e-14, "{product}");
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
    let error = (effectiveness - expected).component_div(&expected);
    assert!(error.amax() < 1e-14, "{error}");
}

#[test]
fn motors_produce_what_is_wanted() {
    let mixer = Parameters::mambo().mixer;
    let torque = Vector3::new(2e-4, -3e-4, 1e-4);
    let command = mixer.mix(0.7, &torque);
    let squares = command.motors * mixer.square_per_command;
    let loads = Airframe::mambo().effectiveness() * squares;
    let wanted = Vector4::new(0.7, torque.x, torque.y, torque.z);
    assert!((loads - wanted).norm() < 1e-15, "{loads}");
}

#[test]
fn hover_is_half_of_full_power() {
    let parameters = Parameters::mambo();
    let command = parameters.mixer.mix(parameters.mass * GRAVITY, &Vector3::zeros());
    for motor in &command.motors {
        assert!((motor - 264.4).abs() < 0.1, "{motor}");
    }
}

#[test]
fn motors_saturate_at_both_ends() {
    let mixer = Parameters::mambo().mixer;
    let command = mixer.mix(0.7, &Vector3::new(0.0, 0.0, 0.01));
    assert_eq!(command.motors, Vector4::new(500.0, 0.0, 500.0, 0.0));
}

#[test]
fn speeds_carry_the_signs_of_rotation() {
    // Table A.1: the largest motor speed is 2630.7 rad/s.
    let command = Parameters::mambo().mixer.mix(100.0, &Vector3::zeros());
    let largest = Vector4::new(2630.7, -2630.7, 2630.7, -2630.7);
    assert!((command.speeds - largest).amax() < 0.1, "{}", command.speeds);
}

#[test]
fn motors_stand_still_when_nothing_can_be_computed() {
    let mixer = Parameters::mambo().mixer;
    let command = mixer.mix(f64::NAN, &Vector3::zeros());
    assert_eq!(command.motors, Vector4::zeros());
}
