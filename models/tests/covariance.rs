//! The filters' covariances stay symmetric, without negative variances, for a million periods. Where nothing is
//! uncertain, nothing is divided by it.

use bessemer::nalgebra::{Matrix6, Vector3, Vector6};
use bessemer::requirement;
use models::attitude_filter::AttitudeFilter;
use models::axis_filter::AxisFilter;
use models::geometry::{LEAST_PITCH_COSINE, Orientation};
use std::f64::consts::FRAC_PI_2;

/// An hour and a half of flight at 200 Hz.
const PERIODS: u32 = 1_000_000;

/// Returns true if a symmetric matrix has no negative eigenvalue: Cholesky's elimination meets no pivot that is not
/// positive.
fn is_covariance(matrix: &Matrix6<f64>) -> bool {
    *matrix == matrix.transpose() && matrix.cholesky().is_some()
}

#[test]
#[requirement("HLR-26")]
fn a_million_periods_leave_covariances() {
    let mut attitude = AttitudeFilter::level(1.0, 0.05);
    let mut axis = AxisFilter::at_rest(3.0, 0.3);
    for n in 0..PERIODS {
        let t = f64::from(n) * 0.005;
        // It leans, turns, and comes near the singularity of its angles every minute.
        let rates = Vector3::new((0.9 * t).sin(), 1.2 * (0.1 * t).cos(), 0.4);
        attitude.predict(&rates, 0.005, 0.01, 0.0005);
        axis.predict((0.7 * t).sin(), 0.005, 0.15, 0.01);
        // Vicon at 100 Hz, away for one minute of five.
        if n % 2 == 0 && n % 60_000 > 12_000 {
            for angle in 0..3 {
                let off = 0.003 * (f64::from(n * 7 + angle as u32)).sin();
                attitude.correct(angle, &[false; 6], off, 25e-6, 5.0);
            }
            let row = Vector3::new(1.0, -0.01, 0.0);
            axis.correct(&row, axis.state[0] + 0.001 * (f64::from(n)).sin(), 4e-6, 5.0);
        }
        if n % 1000 == 0 {
            let attitude = attitude.covariance.matrix();
            assert!(is_covariance(attitude), "{n}: {attitude}");
            let axis = axis.covariance.matrix();
            assert!(*axis == axis.transpose() && axis.cholesky().is_some(), "{n}: {axis}");
        }
    }
}

#[test]
fn where_nothing_is_uncertain_nothing_is_learnt() {
    let mut attitude = AttitudeFilter::level(0.0, 0.0);
    let before = attitude;
    assert!(!attitude.correct(0, &[false; 6], 0.0, 0.0, 5.0));
    assert_eq!(attitude, before);

    let mut axis = AxisFilter::default();
    let before = axis;
    assert!(!axis.correct(&Vector3::new(1.0, 0.0, 0.0), 0.0, 0.0, 5.0));
    assert_eq!(axis, before);
}

#[test]
#[requirement("HLR-20")]
fn from_what_can_be_anything_nothing_is_learnt() {
    let mut attitude = AttitudeFilter::level(1.0, 0.05);
    let mut axis = AxisFilter::at_rest(3.0, 0.3);
    let before = (attitude, axis);
    for variance in [f64::INFINITY, f64::NAN, -f64::INFINITY, f64::MAX * 4.0] {
        assert!(!attitude.correct(0, &[false; 6], 0.1, variance, 5.0), "{variance}");
        assert!(!axis.correct(&Vector3::new(1.0, 0.0, 0.0), 0.1, variance, 5.0), "{variance}");
    }
    assert_eq!((attitude, axis), before);
}

#[test]
#[requirement("HLR-26")]
fn nothing_is_divided_by_a_cosine_of_zero() {
    for pitch in [FRAC_PI_2, -FRAC_PI_2, 1.57, FRAC_PI_2 + 4e-6, 3.0 * FRAC_PI_2] {
        let orientation = Orientation::of(&Vector3::new(0.3, pitch, -0.2));
        assert!(orientation.divisor().abs() >= LEAST_PITCH_COSINE);
        let rates = orientation.angle_rates(&Vector3::new(12.0, 12.0, 12.0));
        assert!(rates.norm() < 17.0 / LEAST_PITCH_COSINE + 50.0, "{rates}");
        let mut filter = AttitudeFilter {
            state: Vector6::new(0.3, pitch, -0.2, 0.0, 0.0, 0.0),
            ..AttitudeFilter::level(1.0, 0.05)
        };
        filter.predict(&Vector3::new(1.0, 1.0, 1.0), 0.005, 0.01, 0.0005);
        let finite = filter.state.norm().is_finite();
        assert!(finite && filter.covariance.elements.norm().is_finite());
    }
    // Where it is not near, nothing is changed.
    let level = Orientation::of(&Vector3::new(0.3, 0.5, -0.2));
    assert_eq!(level.divisor(), 0.5_f64.cos().max(level.c2));
}
