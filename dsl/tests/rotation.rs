//! Rotations from angles against nalgebra's: the same bits wherever the platform's sine and cosine, which
//! nalgebra takes, happen to be the DSL's.

use bessemer::math::ElementaryMethods;
use bessemer::math::arctangent::{acos, asin, atan2};
use bessemer::math::sine::sin_cos;
use bessemer::nalgebra::{ComplexField, RealField};
use bessemer::prelude::*;
use bessemer::{Plain, rotation};
use proptest::prelude::*;

fn bits<T: Plain>(value: T) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

/// Returns true if the platform's sine and cosine of this angle equal the DSL's.
fn agrees(angle: f64) -> bool {
    sin_cos(angle) == ComplexField::sin_cos(angle)
}

fn vector() -> impl Strategy<Value = Vector3<f64>> {
    [-4.0..4.0_f64, -4.0..4.0_f64, -1e3..1e3_f64].prop_map(Vector3::from)
}

fn unit() -> impl Strategy<Value = UnitQuaternion<f64>> {
    [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64, 0.01..1.0_f64]
        .prop_map(|[i, j, k, w]| UnitQuaternion::new_normalize(Quaternion::new(w, i, j, k)))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn from_angles(angles in vector(), angle in -7.0..7.0_f64) {
        let [roll, pitch, yaw] = angles.data.0[0];
        if [roll, pitch, yaw].iter().all(|angle| agrees(0.5 * angle)) {
            let theirs = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
            prop_assert_eq!(bits(rotation::from_euler_angles(roll, pitch, yaw)), bits(theirs));
        }
        if [roll, pitch, yaw].iter().all(|angle| agrees(*angle)) {
            let theirs = Rotation3::from_euler_angles(roll, pitch, yaw);
            prop_assert_eq!(bits(rotation::matrix_from_euler_angles(roll, pitch, yaw)), bits(theirs));
        }
        let axis = Unit::new_normalize(angles);
        if agrees(angle / 2.0) {
            let theirs = UnitQuaternion::from_axis_angle(&axis, angle);
            prop_assert_eq!(bits(rotation::from_axis_angle(&axis, angle)), bits(theirs));
        }
        if agrees(angle) {
            let theirs = Rotation3::from_axis_angle(&axis, angle);
            prop_assert_eq!(bits(rotation::matrix_from_axis_angle(&axis, angle)), bits(theirs));
            prop_assert_eq!(bits(rotation::matrix_from_angle(angle)), bits(Rotation2::new(angle)));
        }
        if agrees((angles / 2.0).norm_squared().sqrt()) {
            let theirs = UnitQuaternion::from_scaled_axis(angles);
            prop_assert_eq!(bits(rotation::from_scaled_axis(angles)), bits(theirs));
        }
    }

    #[test]
    fn angles(a in unit(), b in unit()) {
        let m = a.to_rotation_matrix();
        let down = m[(2, 0)];
        let pitch = -asin(down);
        let [y, x] = [m[(2, 1)] / pitch.dsl_cos(), m[(2, 2)] / pitch.dsl_cos()];
        let [north, east] = [m[(1, 0)] / pitch.dsl_cos(), m[(0, 0)] / pitch.dsl_cos()];
        let same = ComplexField::asin(down) == asin(down)
            && agrees(pitch)
            && RealField::atan2(y, x) == atan2(y, x)
            && RealField::atan2(north, east) == atan2(north, east);
        if same {
            prop_assert_eq!(bits(rotation::euler_angles(&a)), bits(a.euler_angles()));
            prop_assert_eq!(bits(rotation::matrix_euler_angles(&m)), bits(m.euler_angles()));
        }
        let (length, w) = (a.imag().norm(), a.w.abs());
        if RealField::atan2(length, w) == atan2(length, w) {
            prop_assert_eq!(bits(rotation::angle(&a)), bits(a.angle()));
            prop_assert_eq!(bits(rotation::scaled_axis(&a)), bits(a.scaled_axis()));
            prop_assert_eq!(bits(rotation::axis_angle(&a)), bits(a.axis_angle()));
        }
        let delta = a.rotation_to(&b);
        if RealField::atan2(delta.imag().norm(), delta.w.abs()) == atan2(delta.imag().norm(), delta.w.abs()) {
            prop_assert_eq!(bits(rotation::angle_to(&a, &b)), bits(a.angle_to(&b)));
        }
    }

    #[test]
    fn between_directions(a in vector(), b in vector(), share in 0.0..1.0_f64) {
        let cosine = a.normalize().dot(&b.normalize());
        let angle = acos(cosine);
        if ComplexField::acos(cosine) == angle && agrees(angle * share / 2.0) {
            let theirs = UnitQuaternion::scaled_rotation_between(&a, &b, share);
            prop_assert_eq!(rotation::scaled_rotation_between(&a, &b, share).map(bits), theirs.map(bits));
        }
        if ComplexField::acos(cosine) == angle && agrees(angle / 2.0) {
            let theirs = UnitQuaternion::rotation_between(&a, &b);
            prop_assert_eq!(rotation::rotation_between(&a, &b).map(bits), theirs.map(bits));
            let (a, b) = (UnitVector3::new_normalize(a), UnitVector3::new_normalize(b));
            let theirs = UnitQuaternion::rotation_between_axis(&a, &b);
            prop_assert_eq!(rotation::rotation_between_axis(&a, &b).map(bits), theirs.map(bits));
        }
    }

    #[test]
    fn parts_of_the_way(a in unit(), b in unit(), share in 0.0..1.0_f64) {
        let cosine = a.coords.dot(&b.coords).abs();
        let angle = acos(cosine);
        if ComplexField::acos(cosine) == angle && agrees((1.0 - share) * angle) && agrees(share * angle) {
            prop_assert_eq!(bits(rotation::slerp(&a, &b, share)), bits(a.slerp(&b, share)));
        }
        let (length, w) = (a.imag().norm(), a.w.abs());
        if RealField::atan2(length, w) == atan2(length, w) && agrees(a.angle() * share / 2.0) {
            prop_assert_eq!(bits(rotation::powf(&a, share)), bits(a.powf(share)));
        }
    }
}

#[test]
fn the_platform_agrees_at_most_angles() {
    let angles = (0..1_000).map(|i| f64::from(i) * 0.0071 - 3.5);
    assert!(angles.filter(|&angle| agrees(angle)).count() > 700);
}

#[test]
fn ends_are_those_of_nalgebra() {
    let none = rotation::from_scaled_axis(Vector3::<f64>::zeros());
    assert_eq!(bits(none), bits(UnitQuaternion::<f64>::identity()));
    assert_eq!(rotation::axis_angle(&none), None);
    assert_eq!(bits(rotation::powf(&none, 2.0)), bits(none));
    let one = rotation::from_euler_angles(0.1, -0.2, 0.3);
    assert_eq!(bits(rotation::slerp(&one, &one, 0.7)), bits(one));
    // Nothing turns zero, and nothing says which way something turns into its opposite.
    let (x, zero) = (Vector3::x(), Vector3::zeros());
    for (a, b) in [(zero, x), (x, zero), (x, x), (x, -x), (x * 2.0, -x * 3.0)] {
        let theirs = UnitQuaternion::rotation_between(&a, &b);
        assert_eq!(rotation::rotation_between(&a, &b).map(bits), theirs.map(bits));
    }
    // Straight up and down: roll alone is left.
    for pitch in [-1.0, 1.0] {
        let half = 0.5_f64.sqrt();
        let q = UnitQuaternion::new_unchecked(Quaternion::new(half, 0.0, pitch * half, 0.0));
        assert_eq!(bits(rotation::euler_angles(&q)), bits(q.euler_angles()));
    }
}
