//! Rotations against nalgebra's: the same bits where no angle takes part, and where one does, wherever
//! the platform's sine and cosine, which nalgebra takes, happen to be the DSL's.

use bessemer::math::ElementaryMethods;
use bessemer::math::arctangent::{acos, asin, atan2};
use bessemer::math::sine::sin_cos;
use bessemer::nalgebra::{ComplexField, Quaternion, RealField, Unit, UnitQuaternion};
use bessemer::prelude::*;
use bessemer::rotation::Turn;
use proptest::prelude::*;

fn turn(q: &UnitQuaternion<f64>) -> Turn<f64> {
    Turn { i: q.i, j: q.j, k: q.k, w: q.w }
}

fn bits(turn: Turn<f64>) -> [u64; 4] {
    [turn.i, turn.j, turn.k, turn.w].map(f64::to_bits)
}

/// Whether the platform's sine and cosine of this angle are the DSL's.
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
    fn without_angles_the_bits_are_nalgebras(a in unit(), b in unit(), v in vector()) {
        let (one, other) = (turn(&a), turn(&b));
        prop_assert_eq!(bits(one.after(&other)), bits(turn(&(a * b))));
        prop_assert_eq!(bits(one.inverse()), bits(turn(&a.inverse())));
        prop_assert_eq!(one.rotate(&v).data.0[0].map(f64::to_bits), (a * v).data.0[0].map(f64::to_bits));
        let back = a.inverse_transform_vector(&v);
        prop_assert_eq!(one.rotate_back(&v), back);
        prop_assert_eq!(one.matrix(), a.to_rotation_matrix().into_inner());
        let long = Quaternion::new(3.0 * a.w, 3.0 * a.i, 3.0 * a.j, 3.0 * a.k);
        let scaled = Turn { i: long.i, j: long.j, k: long.k, w: long.w };
        prop_assert_eq!(bits(scaled.renormalized()), bits(turn(&UnitQuaternion::new_normalize(long))));
    }

    #[test]
    fn from_angles_too_where_the_platform_agrees(angles in vector(), angle in -7.0..7.0_f64) {
        let [roll, pitch, yaw] = angles.data.0[0];
        let theirs = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        let ours = Turn::of_euler_angles(roll, pitch, yaw);
        if [roll, pitch, yaw].iter().all(|angle| agrees(0.5 * angle)) {
            prop_assert_eq!(bits(ours), bits(turn(&theirs)));
        }
        let axis = Unit::new_normalize(angles);
        if agrees(angle / 2.0) {
            let theirs = UnitQuaternion::from_axis_angle(&axis, angle);
            prop_assert_eq!(bits(Turn::about(&axis, angle)), bits(turn(&theirs)));
        }
        if agrees((angles / 2.0).norm_squared().sqrt()) {
            let theirs = UnitQuaternion::from_scaled_axis(angles);
            prop_assert_eq!(bits(Turn::of_scaled_axis(&angles)), bits(turn(&theirs)));
        }
    }

    #[test]
    fn angles_and_the_way_between_too(a in unit(), b in unit(), share in 0.0..1.0_f64) {
        let down = a.to_rotation_matrix()[(2, 0)];
        let m = a.to_rotation_matrix();
        let pitch = -asin(down);
        let [y, x] = [m[(2, 1)] / pitch.dsl_cos(), m[(2, 2)] / pitch.dsl_cos()];
        let [north, east] = [m[(1, 0)] / pitch.dsl_cos(), m[(0, 0)] / pitch.dsl_cos()];
        let same = ComplexField::asin(down) == asin(down)
            && agrees(pitch)
            && RealField::atan2(y, x) == atan2(y, x)
            && RealField::atan2(north, east) == atan2(north, east);
        if same {
            let (roll, pitch, yaw) = a.euler_angles();
            prop_assert_eq!(turn(&a).roll_pitch_yaw(), Vector3::new(roll, pitch, yaw));
        }
        let cosine = a.coords.dot(&b.coords).abs();
        let angle = acos(cosine);
        if ComplexField::acos(cosine) == angle && agrees((1.0 - share) * angle) && agrees(share * angle) {
            let theirs = a.slerp(&b, share);
            prop_assert_eq!(bits(turn(&a).towards(&turn(&b), share)), bits(turn(&theirs)));
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
    assert_eq!(Turn::of_scaled_axis(&Vector3::zeros()), Turn::<f64>::identity());
    let one = Turn::of_euler_angles(0.1, -0.2, 0.3);
    assert_eq!(one.towards(&one, 0.7), one);
    // Straight up: roll alone is left.
    let up = Turn { i: 0.0, j: -0.5_f64.sqrt(), k: 0.0, w: 0.5_f64.sqrt() };
    let theirs = UnitQuaternion::new_unchecked(Quaternion::new(up.w, up.i, up.j, up.k));
    let (roll, pitch, yaw) = theirs.euler_angles();
    assert_eq!(up.roll_pitch_yaw(), Vector3::new(roll, pitch, yaw));
}
