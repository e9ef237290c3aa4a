//! Filters without a derivative, roots of covariances, the smoother and models over a period, against independent computations.

use bessemer::prelude::*;
use bessemer_estimation::{
    Correction, Estimate, Rooted, Selection, Status, Symmetric, exponential, runge_kutta,
    runge_kutta_jacobian, smoothed, unscented,
};

/// A full covariance of three numbers.
fn covariance() -> Symmetric<f64, 3> {
    Symmetric::of_lower(&Matrix3::new(2.0, 0.0, 0.0, 0.3, 1.0, 0.0, -0.2, 0.4, 0.5))
}

/// Largest difference of two matrices.
fn largest<const R: usize, const C: usize>(
    one: &SMatrix<f64, R, C>,
    other: &SMatrix<f64, R, C>,
) -> f64 {
    (one - other).amax()
}

/// Behind a linear function the distribution is exact.
#[test]
fn the_transform_of_a_linear_function_is_its_congruence() {
    let law = Matrix2x3::new(1.0, -2.0, 0.5, 0.25, 1.0, 3.0);
    let mean = Vector3::new(1.0, -1.0, 2.0);
    let p = covariance();
    for spread in [0.5, 3.0, 7.0] {
        let found = unscented(&mean, &p, spread, |x| law * x).expect("positive");
        assert!(largest(&found.mean, &(law * mean)) < 1e-14);
        assert!(largest(found.covariance.matrix(), &(law * p.matrix() * law.transpose())) < 1e-13);
        assert!(largest(&found.cross, &(p.matrix() * law.transpose())) < 1e-14);
    }
    assert_eq!(unscented(&mean, &p, 0.0, |x| law * x), None);
    assert_eq!(unscented(&mean, &Symmetric::default(), 3.0, |x| law * x), None);
}

/// The mean of the square of a normal number is its variance for any spread.
#[test]
fn the_transform_has_the_second_order_of_the_mean() {
    let found =
        unscented(&Vector1::new(1.0_f64), &Symmetric::diagonal(&Vector1::new(0.5)), 3.0, |x| {
            Vector1::new(x[0] * x[0])
        });
    let found = found.expect("positive");
    assert!((found.mean[0] - 1.5).abs() < 1e-15);
    // E[x⁴] − E[x²]² = 4 μ² σ² + 2 σ⁴, by the fourth moment of a spread of 3.
    assert!((found.covariance.at(0, 0) - 2.5).abs() < 1e-14);
}

/// The root has the covariance of the whole matrix, step by step.
#[test]
fn a_root_filters_as_its_covariance() {
    let f = Matrix3::new(1.0, 0.1, 0.0, -0.1, 1.0, 0.2, 0.0, 0.0, 0.9);
    let deviations = Vector3::new(0.1, 0.0, 0.05);
    let (mut state, mut by_root) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.0, 2.0, 3.0));
    let mut whole = covariance();
    let mut root = Rooted::of(&whole).expect("positive");
    for step in 0..200 {
        whole.congruence(&f);
        whole.add_diagonal(&deviations.component_mul(&deviations));
        root.predict(&f, &deviations);
        let row = Vector3::new(1.0, 0.0, if step % 2 == 0 { 1.0 } else { -0.5 });
        let innovation = 0.01 * f64::from(step % 5);
        let one = whole.correct(&mut state, &row, innovation, 0.04, 9.0);
        let other = root.correct(&mut by_root, &row, innovation, 0.04, 9.0);
        assert_eq!(one.status, other.status);
        assert!((one.surprise - other.surprise).abs() < 1e-12);
        assert!(largest(&state, &by_root) < 1e-12, "step {step}");
        assert!(largest(whole.matrix(), root.covariance().matrix()) < 1e-12, "step {step}");
    }
}

/// A vector that was added can be removed. One that was not cannot, and nothing changes.
#[test]
fn a_root_gains_and_loses_a_vector() {
    let start = Rooted::of(&covariance()).expect("positive");
    let mut root = start;
    let vector = Vector3::new(0.5, -2.0, 1.0);
    root.add(&vector);
    let expected = covariance().matrix() + vector * vector.transpose();
    assert!(largest(root.covariance().matrix(), &expected) < 1e-14);
    assert!(root.remove(&vector));
    assert!(largest(root.factor(), start.factor()) < 1e-13);
    assert!(!root.remove(&Vector3::new(5.0, 0.0, 0.0)));
    assert!(!root.remove(&Vector3::new(f64::NAN, 0.0, 0.0)));
    let kept = root;
    assert!(!root.remove(&Vector3::new(0.0, 0.0, 4.0)));
    assert_eq!(root, kept);
}

/// A vehicle's distances to two beacons.
fn distances(pose: &Vector3<f64>) -> Vector2<f64> {
    Vector2::new(
        (pose[0].powi(2) + pose[1].powi(2)).sqrt(),
        ((pose[0] - 10.0).powi(2) + pose[1].powi(2)).sqrt(),
    )
}

/// A vehicle after a distance and a turn.
fn driven(pose: &Vector3<f64>, distance: f64, turn: f64) -> Vector3<f64> {
    let heading = pose[2] + 0.5 * turn;
    pose + Vector3::new(distance * heading.cos(), distance * heading.sin(), turn)
}

/// Unscented filters by covariance and by root find a vehicle that drives in a circle, and agree.
#[test]
fn both_unscented_filters_find_the_vehicle() {
    let mut truth = Vector3::new(5.0, 3.0, 0.3);
    let mut state = Vector3::new(4.0, 4.0, 0.0);
    let mut by_root = state;
    let mut whole = Symmetric::diagonal(&Vector3::new(4.0, 4.0, 0.25));
    let mut root = Rooted::diagonal(&Vector3::new(2.0, 2.0, 0.5));
    let deviations = Vector3::new(0.01, 0.01, 0.002);
    let noise = Symmetric::diagonal(&Vector2::new(0.01, 0.01));
    for step in 0..300 {
        truth = driven(&truth, 0.1, 0.05);
        let law = |pose: &Vector3<f64>| driven(pose, 0.1, 0.05);
        let moved = unscented(&state, &whole, 3.0, law).expect("positive");
        (state, whole) = (moved.mean, moved.covariance);
        whole.add_diagonal(&deviations.component_mul(&deviations));
        assert!(root.predict_unscented(&mut by_root, 3.0, &deviations, law));

        // A fixed pattern of errors, of a tenth of a metre.
        let error = 0.1 * f64::from(step * 7 % 11 - 5) / 5.0;
        let measured = distances(&truth) + Vector2::new(error, -error);
        // One by one for both, since the root takes single numbers.
        for n in 0..2 {
            let expected = unscented(&state, &whole, 3.0, |x| Vector1::new(distances(x)[n]))
                .expect("positive");
            let single = Symmetric::diagonal(&Vector1::new(noise.at(n, n)));
            let one = whole.correct_unscented(
                &mut state,
                &expected,
                &Vector1::new(measured[n]),
                &single,
                100.0,
            );
            let other = root.correct_unscented(&mut by_root, 3.0, measured[n], 0.01, 100.0, |x| {
                distances(x)[n]
            });
            assert_eq!(
                (one.status, other.status),
                (Status::Corrected, Status::Corrected),
                "step {step}"
            );
        }
        assert!(largest(&state, &by_root) < 1e-9, "step {step}: {:e}", largest(&state, &by_root));
        assert_eq!(*whole.matrix(), whole.matrix().transpose());
    }
    assert!(largest(&state, &truth) < 0.1, "{state} {truth}");
    assert!(largest(whole.matrix(), root.covariance().matrix()) < 1e-9);
}

/// A root refuses a spread with a negative weight, and a measurement beyond the gate; nothing changes.
#[test]
fn refused_steps_change_nothing() {
    let start = Rooted::diagonal(&Vector3::new(1.0, 1.0, 1.0));
    let (mut root, mut state) = (start, Vector3::zeros());
    assert!(!root.predict_unscented(&mut state, 2.0, &Vector3::zeros(), |x| *x));
    assert!(!root.predict_unscented(&mut state, f64::NAN, &Vector3::zeros(), |x| *x));
    let far: Correction<f64> = root.correct_unscented(&mut state, 3.0, 100.0, 1.0, 9.0, |x| x[0]);
    assert_eq!(far.status, Status::Rejected);
    let none = root.correct_unscented(&mut state, 3.0, 0.0, 0.0, 9.0, |x| x[0]);
    assert_eq!(none.status, Status::Lost);
    let unknown = root.correct_unscented(&mut state, 3.0, f64::NAN, 1.0, 9.0, |x| x[0]);
    assert_eq!(unknown.status, Status::Rejected);
    assert_eq!((root, state), (start, Vector3::zeros()));

    let mut whole = covariance();
    let expected = unscented(&state, &whole, 3.0, |x| Vector1::new(x[0])).expect("positive");
    let single = Symmetric::diagonal(&Vector1::new(1.0));
    let far = whole.correct_unscented(&mut state, &expected, &Vector1::new(100.0), &single, 9.0);
    assert_eq!((far.status, whole, state), (Status::Rejected, covariance(), Vector3::zeros()));
}

/// The smoother's states minimise the squares of all measurements and all noise at once.
#[test]
fn the_smoother_is_the_least_squares_of_the_record() {
    const STEPS: usize = 4;
    let f = Matrix2::new(1.0, 0.5, -0.2, 0.9);
    let (first, noise, variance) = (Vector2::new(4.0, 1.0), Vector2::new(0.1, 0.3), 0.25);
    let measured = [1.0, 2.5, 1.5, -0.5];

    let start = Estimate { state: Vector2::zeros(), covariance: Symmetric::diagonal(&first) };
    let (mut filtered, mut predicted) = ([start; STEPS], [start; STEPS]);
    for step in 0..STEPS {
        if step > 0 {
            let mut ahead = filtered[step - 1];
            ahead.state = f * ahead.state;
            ahead.covariance.congruence(&f);
            ahead.covariance.add_diagonal(&noise);
            predicted[step] = ahead;
        }
        let mut now = predicted[step];
        let innovation = measured[step] - now.state[0];
        now.covariance.correct_element(&mut now.state, 0, innovation, variance, 1e9);
        filtered[step] = now;
    }
    let mut found = filtered;
    for step in (0..STEPS - 1).rev() {
        found[step] = smoothed(&filtered[step], &f, &predicted[step + 1], &found[step + 1])
            .expect("positive");
    }

    // The normal equations of the whole record.
    let mut information = SMatrix::<f64, 8, 8>::zeros();
    let mut right = SVector::<f64, 8>::zeros();
    let weight = |of: Vector2<f64>| Matrix2::from_diagonal(&of.map(|it| 1.0 / it));
    let mut add = |at: usize, with: usize, block: Matrix2<f64>| {
        let mut view = information.fixed_view_mut::<2, 2>(2 * at, 2 * with);
        view += block;
    };
    add(0, 0, weight(first));
    for step in 0..STEPS {
        add(step, step, Matrix2::new(1.0 / variance, 0.0, 0.0, 0.0));
        right[2 * step] += measured[step] / variance;
        if step > 0 {
            let w = weight(noise);
            add(step, step, w);
            add(step, step - 1, -w * f);
            add(step - 1, step, -f.transpose() * w);
            add(step - 1, step - 1, f.transpose() * w * f);
        }
    }
    let inverse = information.try_inverse().expect("regular");
    let best = inverse * right;
    for (step, found) in found.iter().enumerate() {
        assert!(largest(&found.state, &best.fixed_rows::<2>(2 * step).into_owned()) < 1e-12);
        let block = inverse.fixed_view::<2, 2>(2 * step, 2 * step).into_owned();
        assert!(largest(found.covariance.matrix(), &block) < 1e-12);
    }
}

/// The exponential of a turn that grows, and of a chain of integrators, by their formulas.
#[test]
fn the_exponential_follows_the_formulas() {
    for (growth, turn) in [(0.0, 0.01), (-0.3, 1.0), (0.5, 6.0)] {
        let a = Matrix2::new(growth, -turn, turn, growth);
        let (sine, cosine) = f64::sin_cos(turn);
        let reference = Matrix2::new(cosine, -sine, sine, cosine) * f64::exp(growth);
        assert!(largest(&exponential(&a, 6), &reference) < 1e-13);
    }
    let chain = Matrix3::new(0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0);
    assert_eq!(exponential(&chain, 5), Matrix3::new(1.0, 2.0, 2.0, 0.0, 1.0, 2.0, 0.0, 0.0, 1.0));
}

/// Fourth order: half the period has a sixteenth of the error. Its Jacobian equals central differences.
#[test]
fn the_step_has_fourth_order_and_its_own_jacobian() {
    let law = |x: &Vector2<f64>| Vector2::new(x[1], -9.81 * x[0].sin());
    let start = Vector2::new(1.0, 0.5);
    let run = |steps: usize| {
        let period = 0.5 / steps as f64;
        (0..steps).fold(start, |state, _| runge_kutta(&state, period, law))
    };
    let exact = run(4096);
    let ratio = largest(&run(16), &exact) / largest(&run(32), &exact);
    assert!((ratio - 16.0).abs() < 1.5, "{ratio}");

    let both = |x: &Vector2<f64>| (law(x), Matrix2::new(0.0, 1.0, -9.81 * x[0].cos(), 0.0));
    let (next, jacobian) = runge_kutta_jacobian(&start, 0.1, both);
    assert_eq!(next, runge_kutta(&start, 0.1, law));
    for n in 0..2 {
        let mut step = Vector2::zeros();
        step[n] = 1e-6;
        let slope = (runge_kutta(&(start + step), 0.1, law)
            - runge_kutta(&(start - step), 0.1, law))
            / 2e-6;
        assert!(largest(&jacobian.column(n).into_owned(), &slope) < 1e-9);
    }
}

/// A correction by selected elements equals one by the whole Jacobian, for sizes with and without a rest of three.
#[test]
fn a_selected_correction_is_the_whole_one() {
    fn both<const N: usize, const K: usize, const M: usize>(indices: [usize; K]) {
        let root =
            SMatrix::<f64, N, N>::from_fn(
                |r, c| if r == c { 2.0 } else { 1.0 / (r + 2 * c + 1) as f64 },
            );
        let start = Symmetric::of_lower(&(root * root.transpose()));
        let jacobian = SMatrix::<f64, M, K>::from_fn(|m, k| ((3 * m + 2 * k) % 5) as f64 - 1.5);
        let mut whole = SMatrix::<f64, M, N>::zeros();
        for (k, index) in indices.iter().enumerate() {
            whole.set_column(*index, &jacobian.column(k));
        }
        let innovation = SVector::<f64, M>::from_fn(|m, _| 0.5 - m as f64);
        let variances = SVector::<f64, M>::from_fn(|m, _| 0.25 + m as f64);
        let (mut one, mut other) = (start, start);
        let (mut state, mut by_whole) = (SVector::<f64, N>::zeros(), SVector::<f64, N>::zeros());
        let selection = Selection { indices };
        let found =
            one.correct_selected(&mut state, &selection, &jacobian, &innovation, &variances, 100.0);
        let noise = Symmetric::diagonal(&variances);
        let expected = other.correct_jointly(&mut by_whole, &whole, &innovation, &noise, 100.0);
        assert_eq!((found.status, expected.status), (Status::Corrected, Status::Corrected));
        assert!((found.surprise - expected.surprise).abs() < 1e-12);
        assert!(largest(&state, &by_whole) < 1e-12);
        assert!(largest(one.matrix(), other.matrix()) < 1e-12);
        assert_eq!(*one.matrix(), one.matrix().transpose());

        let kept = one;
        let far =
            one.correct_selected(&mut state, &selection, &jacobian, &innovation, &variances, 1e-9);
        assert_eq!((far.status, one), (Status::Rejected, kept));
        let worse = variances * -1000.0;
        let lost =
            one.correct_selected(&mut state, &selection, &jacobian, &innovation, &worse, 100.0);
        assert_eq!((lost.status, one), (Status::Lost, kept));
    }
    both::<3, 2, 1>([0, 2]);
    both::<4, 2, 2>([3, 1]);
    both::<5, 3, 3>([4, 0, 2]);
    both::<7, 4, 2>([1, 2, 5, 6]);
    both::<6, 6, 6>([0, 1, 2, 3, 4, 5]);
}
