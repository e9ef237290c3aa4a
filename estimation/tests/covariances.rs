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

/// The difference of the triangles of a full matrix grows with each step; here there is none. The reference has 106 bits.
#[test]
fn many_steps_stay_symmetric_positive_and_exact() {
    let steps = if std::env::var_os("BESSEMER_FULL").is_some() { 1_000_000 } else { 20_000 };
    let mut state = SVector::<f64, 4>::zeros();
    let variances = [1.0, 4.0, 0.5, 2.0];
    let mut covariance = Symmetric::diagonal(&SVector::from(variances));
    let mut reference = Reference::diagonal(variances);
    for step in 0..steps {
        let noise = [1e-9, 1e-9, 1e-6, 1e-6];
        covariance.congruence(&transition(step));
        covariance.add_diagonal(&SVector::from(noise));
        reference.predict(&transition(step), noise);
        // By one number, by a number at an index, in Joseph's form, by two at once and by two of the state, in turn.
        let mut row = SVector::<f64, 4>::zeros();
        row[step % 2] = 1.0;
        let report = match step % 5 {
            0 => covariance.correct(&mut state, &row, 1e-3, 1e-4, 100.0),
            1 => covariance.correct_joseph(&mut state, &row, 1e-3, 1e-4, 100.0),
            2 => covariance.correct_element(&mut state, 1, 1e-3, 1e-4, 100.0),
            3 => {
                let jacobian = SMatrix::<f64, 2, 4>::identity();
                let noise = Symmetric::diagonal(&SVector::from([1e-4; 2]));
                let innovation = SVector::from([1e-3; 2]);
                covariance.correct_jointly(&mut state, &jacobian, &innovation, &noise, 100.0)
            }
            _ => {
                let (innovation, variances) = (SVector::from([1e-3; 2]), SVector::from([1e-4; 2]));
                covariance.correct_part::<0, 2>(&mut state, &innovation, &variances, 100.0)
            }
        };
        assert_eq!(report.status, Status::Corrected, "step {step}");
        match step % 5 {
            0 | 1 => reference.correct(step % 2, 1e-4),
            2 => reference.correct(1, 1e-4),
            _ => (0..2).for_each(|index| reference.correct(index, 1e-4)),
        }
    }
    let matrix = covariance.matrix();
    assert_eq!(*matrix, matrix.transpose());
    assert!(covariance.is_plausible());
    let error = reference.error(matrix);
    println!("after {steps} steps the relative error is {error:.1e}");
    assert!(error < 1e-12, "{error:e}");
    let least = SymmetricEigen::<f64, Const<4>>::new(*matrix).eigenvalues.min();
    assert!(least > 0.0, "{least:e}");
}

/// A number of 106 bits: the sum of two.
#[derive(Clone, Copy)]
struct Long(f64, f64);

impl Long {
    fn of(high: f64, low: f64) -> Long {
        let sum = high + low;
        Long(sum, low - (sum - high))
    }

    fn plus(self, other: Long) -> Long {
        let sum = self.0 + other.0;
        let part = sum - self.0;
        let rest = (self.0 - (sum - part)) + (other.0 - part);
        Long::of(sum, rest + self.1 + other.1)
    }

    fn times(self, other: Long) -> Long {
        let product = self.0 * other.0;
        let rest = self.0.mul_add(other.0, -product);
        Long::of(product, rest + self.0 * other.1 + self.1 * other.0)
    }

    fn over(self, other: Long) -> Long {
        let first = self.0 / other.0;
        let rest = self.plus(other.times(Long(-first, 0.0)));
        Long::of(first, rest.0 / other.0)
    }
}

/// A covariance of 106 bits, by the definition of each step.
struct Reference([[Long; 4]; 4]);

impl Reference {
    fn diagonal(variances: [f64; 4]) -> Reference {
        let at = |row, col| Long(if row == col { variances[row] } else { 0.0 }, 0.0);
        Reference([0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|col| at(row, col))))
    }

    fn predict(&mut self, f: &SMatrix<f64, 4, 4>, noise: [f64; 4]) {
        let sum = |row: usize, term: &dyn Fn(usize) -> Long| {
            let terms = (0..4).map(|k| Long(f[(row, k)], 0.0).times(term(k)));
            terms.fold(Long(0.0, 0.0), Long::plus)
        };
        let p = &self.0;
        let half = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|col| sum(row, &|k| p[k][col])));
        let whole = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|col| sum(col, &|k| half[row][k])));
        self.0 = whole;
        for (n, variance) in noise.into_iter().enumerate() {
            self.0[n][n] = self.0[n][n].plus(Long(variance, 0.0));
        }
    }

    fn correct(&mut self, index: usize, variance: f64) {
        let p = self.0;
        let expected = p[index][index].plus(Long(variance, 0.0));
        for row in 0..4 {
            let gain = p[row][index].over(expected);
            for (col, spread) in p[index].into_iter().enumerate() {
                let loss = gain.times(spread);
                self.0[row][col] = p[row][col].plus(Long(-loss.0, -loss.1));
            }
        }
    }

    /// Returns the largest difference from a matrix, relative to its largest element.
    fn error(&self, matrix: &SMatrix<f64, 4, 4>) -> f64 {
        let all = (0..4).flat_map(|row| (0..4).map(move |col| (row, col)));
        let far = |(row, col): (usize, usize)| {
            self.0[row][col].plus(Long(-matrix[(row, col)], 0.0)).0.abs()
        };
        all.map(far).fold(0.0, f64::max) / matrix.amax()
    }
}

/// A correction by a part of the state equals the joint one, for every number of states and of measured ones.
#[test]
fn a_part_is_corrected_as_jointly() {
    fn agree<const FIRST: usize, const M: usize, const N: usize>() {
        let mut prior = Symmetric::<f64, N>::default();
        for row in 0..N {
            for col in 0..=row {
                let coupled = 0.1 / (1.0 + (row - col) as f64);
                prior.set(row, col, if row == col { 1.0 + row as f64 } else { coupled });
            }
        }
        let mut jacobian = SMatrix::<f64, M, N>::zeros();
        let (mut innovation, mut variances) = (SVector::<f64, M>::zeros(), SVector::zeros());
        for m in 0..M {
            jacobian[(m, FIRST + m)] = 1.0;
            innovation[m] = 0.3 - 0.1 * m as f64;
            variances[m] = 0.5 + 0.25 * m as f64;
        }
        let (mut part, mut of_part) = (prior, SVector::zeros());
        let (mut joint, mut of_joint) = (prior, SVector::zeros());
        let noise = Symmetric::diagonal(&variances);
        let found = part.correct_part::<FIRST, M>(&mut of_part, &innovation, &variances, 50.0);
        let wanted = joint.correct_jointly(&mut of_joint, &jacobian, &innovation, &noise, 50.0);
        assert_eq!(found.status, Status::Corrected);
        assert!((found.surprise - wanted.surprise).abs() < 1e-13, "{N}: {found:?}");
        assert!((of_part - of_joint).amax() < 1e-13, "{N}: {of_part}");
        assert!((part.matrix() - joint.matrix()).amax() < 1e-13, "{N}: {}", part.matrix());
        assert_eq!(part.matrix().transpose(), *part.matrix(), "{N}");

        // One that is refused changes nothing.
        let mut refused = part;
        for (variance, gate, status) in [
            (1.0, -1.0, Status::Rejected),
            (-100.0, 50.0, Status::Lost),
            (f64::NAN, 50.0, Status::Lost),
        ] {
            let mut state = of_part;
            let variances = SVector::repeat(variance);
            let report =
                refused.correct_part::<FIRST, M>(&mut state, &innovation, &variances, gate);
            assert_eq!((report.status, state, refused), (status, of_part, part), "{N}: {variance}");
        }
    }
    agree::<0, 1, 1>();
    agree::<0, 2, 2>();
    agree::<1, 2, 3>();
    agree::<2, 1, 4>();
    agree::<0, 5, 5>();
    agree::<1, 3, 7>();
    agree::<0, 6, 12>();
    agree::<4, 8, 13>();
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
        // The innovation shrinks by what the corrections before it explain.
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

/// Considered elements of the state stay as they are: Joseph's form with a gain of zero for them.
#[test]
fn considered_elements_stay() {
    let mut prior = Symmetric::diagonal(&SVector::from([1.0, 4.0, 0.5, 2.0]));
    (0..5).for_each(|step| prior.congruence(&transition(step)));
    let row = SVector::from([0.0, 1.0, 0.0, 0.0]);
    let spread = prior.matrix() * row;
    let expected = spread[1] + 0.1;
    for considered in [[false; 4], [false, true, false, true], [true, false, true, true]] {
        let (mut found, mut state) = (prior, SVector::<f64, 4>::zeros());
        let report = found.correct_considering(&mut state, &considered, 1, 0.3, 0.1, f64::MAX);
        assert_eq!(report.status, Status::Corrected);
        assert!((report.surprise - 0.09 / expected).abs() < 1e-15);

        let moves = SVector::<f64, 4>::from_fn(|n, _| if considered[n] { 0.0 } else { 1.0 });
        let gain = spread.component_mul(&moves) / expected;
        let kept = SMatrix::<f64, 4, 4>::identity() - gain * row.transpose();
        let wanted = kept * prior.matrix() * kept.transpose() + gain * gain.transpose() * 0.1;
        assert!((found.matrix() - wanted).amax() < 1e-15, "{considered:?}");
        assert_eq!(found.matrix().transpose(), *found.matrix());
        assert!((state - gain * 0.3).amax() < 1e-15);
        for n in (0..4).filter(|n| considered[*n]) {
            assert_eq!(state[n], 0.0);
            for k in (0..4).filter(|k| considered[*k]) {
                assert_eq!(found.at(n, k), prior.at(n, k));
            }
        }
    }
    for (index, variance, gate, status) in [
        (4, 0.1, 9.0, Status::Lost),
        (1, -5.0, 9.0, Status::Lost),
        (1, f64::NAN, 9.0, Status::Lost),
        (1, 0.1, 1e-3, Status::Rejected),
    ] {
        let (mut found, mut state) = (prior, SVector::<f64, 4>::zeros());
        let all = [false; 4];
        let report = found.correct_considering(&mut state, &all, index, 0.3, variance, gate);
        assert_eq!((report.status, found, state), (status, prior, SVector::zeros()));
    }
}

/// In Joseph's form a certain measurement of an uncertain state leaves the variance of the measurement.
#[test]
fn josephs_form_keeps_small_variances() {
    let wide = Symmetric::diagonal(&SVector::from([1e12, 1e12]));
    let row = SVector::from([1.0, 0.0]);
    let (mut short, mut long) = (wide, wide);
    let mut state = SVector::<f64, 2>::zeros();
    assert_eq!(short.correct(&mut state, &row, 1.0, 1e-6, 9.0).status, Status::Lost);
    assert_eq!(long.correct_joseph(&mut state, &row, 1.0, 1e-6, 9.0).status, Status::Corrected);
    assert!((long.at(0, 0) - 1e-6).abs() < 1e-18, "{}", long.matrix());

    for (innovation, variance, gate, status) in [
        (f64::NAN, 1.0, f64::MAX, Status::Rejected),
        (f64::INFINITY, 1.0, f64::MAX, Status::Rejected),
        (10.0, 1e-6, 1e-30, Status::Rejected),
        (0.1, f64::NAN, 9.0, Status::Lost),
        (0.1, -1e13, 9.0, Status::Lost),
        (0.1, 0.0, 9.0, Status::Lost),
    ] {
        let (mut covariance, mut state) = (wide, SVector::zeros());
        let report = covariance.correct_joseph(&mut state, &row, innovation, variance, gate);
        assert_eq!(report.status, status, "{innovation} {variance}");
        assert_eq!((covariance, state), (wide, SVector::zeros()));
    }
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
