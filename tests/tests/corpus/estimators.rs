//! The filters of the book's page of states and filters find the truth in closed loop.
//!
//! That their C has the same bits is the corpus' to show, as of any other program.

use bessemer::nalgebra::{UnitQuaternion, Vector2, Vector3};
use bessemer_estimation::Status;
use corpus::programs::matrices::error_state::{Pointing, PointingFilter};
use corpus::programs::matrices::unscented::{BEACONS, Located, Pose};

/// The filter of errors finds an attitude that it believed 0.4 rad away, and the gyroscope's bias, by two directions.
#[test]
fn the_filter_of_errors_finds_attitude_and_bias() {
    let period = 0.01;
    let bias = Vector3::new(0.02, -0.01, 0.03);
    let mut attitude = UnitQuaternion::from_euler_angles(0.2, -0.1, 0.3);
    let mut filter = PointingFilter::default();
    let directions = [Vector3::z(), Vector3::new(0.6, 0.0, 0.8)];
    for step in 0..6_000_u32 {
        let time = f64::from(step) * period;
        let rates = Vector3::new(0.5 * time.sin(), 0.3 * (0.7 * time).cos(), 0.2);
        filter.predict(&(rates + bias), period);
        attitude *= UnitQuaternion::from_scaled_axis(rates * period);
        // Errors without a trend, of up to a hundredth.
        let error = f64::from(step * 7 % 11) / 500.0 - 0.01;
        let known = directions[step as usize % 2];
        let seen = attitude.inverse() * known + Vector3::new(error, -error, error);
        assert_eq!(filter.measure(&known, &seen).status, Status::Corrected, "step {step}");
    }
    let truth = Pointing { attitude, bias };
    let errors = truth.difference(&filter.state);
    let part = |first: usize| errors.fixed_rows::<3>(first).amax();
    assert!(part(Pointing::ATTITUDE) < 5e-3, "{errors}");
    assert!(part(Pointing::BIAS) < 2e-3, "{errors}");

    // To move by the difference is to arrive.
    let there = filter.state.retracted(&errors);
    assert!(truth.difference(&there).amax() < 1e-14);
}

/// The unscented filter finds a vehicle that drives in a circle, by its distances to the beacons.
#[test]
fn the_unscented_filter_finds_the_vehicle() {
    let mut truth = Pose { place: Vector2::new(3.0, 2.0), heading: 0.2 };
    let mut filter = Located::default();
    for step in 0..400_u32 {
        let heading = truth.heading + 0.025;
        truth.place += Vector2::new(heading.cos(), heading.sin()) * 0.1;
        truth.heading += 0.05;
        assert!(filter.drive(0.1, 0.05), "step {step}");
        let error = f64::from(step * 7 % 11) / 50.0 - 0.1;
        let distance = |n: usize| (truth.place - Vector2::from(BEACONS[n])).norm();
        let measured = Vector2::new(distance(0) + error, distance(1) - error);
        assert_eq!(filter.measure(&measured).status, Status::Corrected, "step {step}");
    }
    let errors = truth.difference(&filter.pose);
    assert!(errors.fixed_rows::<2>(Pose::PLACE).amax() < 0.1, "{errors}");
    assert!(errors[Pose::HEADING].abs() < 0.05, "{errors}");
}
