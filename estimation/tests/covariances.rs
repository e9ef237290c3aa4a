//! Covariances over many steps: symmetric to the last bit, positive, and equal to a reference by plain matrices.

use bessemer::prelude::*;
use bessemer_estimation::{Factored, Status, Symmetric, discretized};
use nalgebra::{Const, SymmetricEigen};

/// A transition with rotations and couplings, whose eigenvalues are near one.
fn transition(step: usize) -> SMatrix<f64, 4, 4> {
    let angle = 0.01 * (1.0 + (step % 7) as f64);
    let mut f = SMatrix::<f64, 4, 4>::identity();
    f[(0, 2)] = 0.02;
    f[(1, 3)] = 0.02 * angle.cos();
    f[(2, 3)] = angle.sin();
    f[(3, 2)] = -angle.sin();
    f
}

/// The difference of the triangles of a full matrix grows with each step; here there is none.
#[test]
fn many_steps_stay_symmetric_and_positive() {
    let steps = if std::env::var_os("BESSEMER_FULL").is_some() { 1_000_000 } else { 20_000 };
    let mut state = SVector::<f64, 4>::zeros();
    let mut covariance = Symmetric::diagonal(&SVector::from([1.0, 4.0, 0.5, 2.0]));
    for step in 0..steps {
        covariance.congruence(&transition(step));
        covariance.add_diagonal(&SVector::from([1e-9, 1e-9, 1e-6, 1e-6]));
        let mut row = SVector::<f64, 4>::zeros();
        row[step % 2] = 1.0;
        let report = covariance.correct(&mut state, &row, 1e-3, 1e-4, 100.0);
        assert_eq!(report.status, Status::Corrected, "step {step}");
    }
    let matrix = covariance.matrix();
    assert_eq!(*matrix, matrix.transpose());
    assert!(covariance.is_plausible());
    let least = SymmetricEigen::<f64, Const<4>>::new(*matrix).eigenvalues.min();
    assert!(least > 0.0, "{least:e}");
}

/// Corrections one by one, jointly and by factors give one covariance, one state and one surprise.
#[test]
fn corrections_agree() {
    let mut prior = Symmetric::diagonal(&SVector::from([1.0, 4.0, 0.5, 2.0]));
    for step in 0..5 {
        prior.congruence(&transition(step));
    }
    let rows = [SVector::from([1.0, 0.0, 0.5, 0.0]), SVector::from([0.0, 2.0, 0.0, -1.0])];
    let innovation = [0.3, -0.2];
    let noise = Symmetric::diagonal(&SVector::from([0.1, 0.2]));

    let (mut joint, mut of_joint) = (prior, SVector::<f64, 4>::zeros());
    let jacobian = SMatrix::from_rows(&[rows[0].transpose(), rows[1].transpose()]);
    let report =
        joint.correct_jointly(&mut of_joint, &jacobian, &SVector::from(innovation), &noise, 50.0);
    assert_eq!(report.status, Status::Corrected);

    let (mut single, mut of_single) = (prior, SVector::<f64, 4>::zeros());
    let mut factors = Factored::of(&prior).expect("it is positive");
    let mut of_factors = of_single;
    let mut surprise = 0.0;
    for m in 0..2 {
        // Of what the state expects after the corrections before.
        let rest = innovation[m] - rows[m].dot(&of_single);
        surprise += single.correct(&mut of_single, &rows[m], rest, noise.at(m, m), 50.0).surprise;
        let rest = innovation[m] - rows[m].dot(&of_factors);
        factors.correct(&mut of_factors, &rows[m], rest, noise.at(m, m), 50.0);
    }
    let close = |a: f64, b: f64| (a - b).abs() < 1e-13;
    assert!(close(surprise, report.surprise), "{surprise} {}", report.surprise);
    for n in 0..4 {
        assert!(close(of_joint[n], of_single[n]) && close(of_joint[n], of_factors[n]), "state {n}");
        for k in 0..4 {
            let all = [joint.at(n, k), single.at(n, k), factors.covariance().at(n, k)];
            assert!(close(all[0], all[1]) && close(all[0], all[2]), "({n}, {k}): {all:?}");
        }
    }
    // The reference: (P⁻¹ + Hᵀ R⁻¹ H)⁻¹.
    let inverse = |of: &SMatrix<f64, 4, 4>| of.try_inverse().expect("it is positive");
    let weights = SMatrix::<f64, 2, 2>::from_diagonal(&SVector::from([10.0, 5.0]));
    let reference = inverse(&(inverse(prior.matrix()) + jacobian.transpose() * weights * jacobian));
    assert!((reference - joint.matrix()).amax() < 1e-12);
}

/// A refused correction changes nothing.
#[test]
fn a_refused_correction_changes_nothing() {
    let prior = Symmetric::diagonal(&SVector::from([1.0, 4.0]));
    let row = SVector::from([1.0, 0.0]);
    let cases = [
        (10.0, 1.0, 9.0, Status::Rejected),
        (f64::NAN, 1.0, 9.0, Status::Rejected),
        (0.1, f64::NAN, 9.0, Status::Lost),
        (0.1, f64::INFINITY, 9.0, Status::Lost),
        (0.1, -2.0, 9.0, Status::Lost),
        (0.1, -1e-30, 9.0, Status::Lost),
    ];
    for (innovation, variance, gate, status) in cases {
        let (mut covariance, mut state) = (prior, SVector::zeros());
        let report = covariance.correct(&mut state, &row, innovation, variance, gate);
        assert_eq!(report.status, status, "{innovation} {variance}");
        assert_eq!((covariance, state), (prior, SVector::zeros()));
        let noise = Symmetric::diagonal(&SVector::from([variance]));
        let jacobian = row.transpose();
        let report = covariance.correct_jointly(
            &mut state,
            &jacobian,
            &SVector::from([innovation]),
            &noise,
            gate,
        );
        assert_eq!(report.status, status, "jointly: {innovation} {variance}");
        assert_eq!((covariance, state), (prior, SVector::zeros()));
    }
    assert!(Factored::of(&Symmetric::diagonal(&SVector::from([1.0, -1.0]))).is_none());
}

/// An integrator of an integrator with white acceleration has known transition and noise.
#[test]
fn a_model_is_discretized() {
    let system = SMatrix::<f64, 2, 2>::new(0.0, 1.0, 0.0, 0.0);
    let noise = Symmetric::diagonal(&SVector::from([0.0, 2.0]));
    for halvings in [0, 3] {
        let (transition, added) = discretized(&system, &noise, 0.5, halvings);
        assert_eq!(transition, SMatrix::<f64, 2, 2>::new(1.0, 0.5, 0.0, 1.0));
        let expected = [2.0 * 0.125 / 3.0, 2.0 * 0.125, 2.0 * 0.5];
        let found = [added.at(0, 0), added.at(1, 0), added.at(1, 1)];
        let worst = expected.iter().zip(found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-15, "{found:?}");
    }
    let turning = SMatrix::<f64, 2, 2>::new(0.0, 3.0, -3.0, 0.0);
    let (transition, _) = discretized(&turning, &noise, 1.0, 4);
    let expected = SMatrix::<f64, 2, 2>::new(3f64.cos(), 3f64.sin(), -3f64.sin(), 3f64.cos());
    assert!((transition - expected).amax() < 1e-14);
}
