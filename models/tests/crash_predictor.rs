//! The crash predictor raises its alarms beyond its limits, and not within them.

mod recorded;

use bessemer::nalgebra::Vector3;
use bessemer::requirement;
use models::crash_predictor::CrashPredictor;
use models::estimator::Ages;
use models::{Alarm, Estimate, Limits, Orientation};
use recorded::Recorded;

/// Returns the alarm of an aircraft in level flight at this height and vertical speed, m and m/s, that accelerates
/// vertically by `climb`, m/s².
fn alarm(height: f64, speed: f64, climb: f64) -> Alarm {
    alarm_at(Vector3::z() * height, Vector3::z() * speed, climb)
}

/// Returns the alarm at this position and velocity, m and m/s.
fn alarm_at(position: Vector3<f64>, velocity: Vector3<f64>, climb: f64) -> Alarm {
    let mut predictor = Recorded::<CrashPredictor>::default();
    let estimate = Estimate { position, velocity, ..Estimate::default() };
    let level = Orientation::of(&Vector3::zeros());
    let mut period =
        || predictor.step(&Limits::room(), true, &estimate, &level, &Ages::default(), climb);
    // The third period confirms.
    [period(), period(), period()][2]
}

#[test]
#[requirement("HLR-35", "HLR-36")]
fn the_ceiling_and_a_hard_touch_down_raise_their_alarms() {
    assert_eq!(alarm(3.9, 0.0, 0.0), Alarm::Clear);
    assert_eq!(alarm(4.1, 0.0, 0.0), Alarm::Height);
    assert_eq!(alarm(3.9, 2.0, 0.0), Alarm::Height, "within the horizon");
    assert_eq!(alarm(1.0, -1.0, 0.0), Alarm::Clear, "far from the ground");
    assert_eq!(alarm(0.01, -0.5, 0.0), Alarm::Clear, "slow");
    assert_eq!(alarm(0.05, -1.0, 0.0), Alarm::Impact);
    assert_eq!(alarm(0.05, -0.6, -2.0), Alarm::Impact, "fast within the horizon");
}

#[test]
#[requirement("HLR-35")]
fn leaving_the_room_to_any_side_raises_its_alarm() {
    let reach = Limits::room().reach;
    for side in [Vector3::x(), Vector3::y()] {
        for side in [side, -side] {
            let at = |place: f64| Vector3::z() + side * place;
            assert_eq!(alarm_at(at(reach - 0.1), Vector3::zeros(), 0.0), Alarm::Clear);
            assert_eq!(alarm_at(at(reach + 0.1), Vector3::zeros(), 0.0), Alarm::Position);
            assert_eq!(
                alarm_at(at(reach - 0.01), side, 0.0),
                Alarm::Position,
                "within the horizon"
            );
        }
    }
}

#[test]
#[requirement("HLR-35")]
fn a_tilt_a_turn_and_a_speed_raise_their_alarms_in_the_third_period() {
    let alarms = |angles: Vector3<f64>, rates: Vector3<f64>, velocity: Vector3<f64>| {
        let mut predictor = Recorded::<CrashPredictor>::default();
        let estimate = Estimate { position: 2.0 * Vector3::z(), angles, velocity, rates };
        let orientation = Orientation::of(&angles);
        [(); 3].map(|()| {
            let (limits, ages) = (Limits::room(), Ages::default());
            predictor.step(&limits, true, &estimate, &orientation, &ages, 0.0)
        })
    };
    let (zero, x, y, z) = (Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::z());
    for ([angles, rates, velocity], alarm) in [
        ([0.89 * x, zero, zero], Alarm::Clear),
        ([0.91 * x, zero, zero], Alarm::Tilt),
        ([-0.91 * y, zero, zero], Alarm::Tilt),
        // A positive rate lowers the angle: within the horizon it is beyond the limit.
        ([-0.85 * x, x, zero], Alarm::Tilt),
        ([zero, 11.9 * z, zero], Alarm::Clear),
        ([zero, -12.1 * z, zero], Alarm::Spin),
        ([zero, 12.1 * x, zero], Alarm::Spin),
        ([zero, zero, 3.9 * x], Alarm::Clear),
        ([zero, zero, -4.1 * y], Alarm::Speed),
        // The thrust of a tilted aircraft accelerates it beyond the limit within the horizon.
        ([0.5 * x, zero, 3.9 * y], Alarm::Speed),
    ] {
        let found = alarms(angles, rates, velocity);
        assert_eq!(found, [Alarm::Clear, Alarm::Clear, alarm], "{angles} {rates} {velocity}");
    }
}

#[test]
#[requirement("HLR-37")]
fn a_state_without_numbers_raises_its_alarm_at_once_and_for_good() {
    for nonsense in [f64::NAN, f64::INFINITY] {
        let mut predictor = Recorded::<CrashPredictor>::default();
        let level = Orientation::of(&Vector3::zeros());
        let mut step = |estimate: &Estimate| {
            predictor.step(&Limits::room(), true, estimate, &level, &Ages::default(), 0.0)
        };
        let good = Estimate { position: Vector3::z(), ..Estimate::default() };
        assert_eq!(step(&good), Alarm::Clear);
        let bad = Estimate { rates: Vector3::new(0.0, nonsense, 0.0), ..good };
        assert_eq!([step(&bad), step(&good), step(&good)], [Alarm::Undefined; 3]);
    }
}
