//! Trajectories, drives and attitudes against SciPy, NumPy and AHRS.

use bessemer::nalgebra::{Quaternion, SVector, UnitQuaternion, Vector3};
use bessemer::prelude::{Real, real};
use bessemer_blocks::*;

use crate::data::{Data, near};

#[test]
fn smoothest_motions() {
    let data = Data::read(include_str!("../data/trajectories.txt"));
    let point = |name| {
        let [position, speed, acceleration, jerk] = data.all::<f64, 4>(name);
        Point { position, speed, acceleration, jerk }
    };
    let (start, end) = (point("start"), point("end"));
    let jerk = MinimumJerk::between(&start, &end, 2.5);
    let snap = MinimumSnap::between(&start, &end, 2.5);
    let numbers = |it: Point<f64>| [it.position, it.speed, it.acceleration, it.jerk];
    for (k, time) in data.get::<f64>("times").into_iter().enumerate() {
        near(&numbers(jerk.at(time)), &data.rows::<f64, 4>("jerk")[k], 12);
        near(&numbers(snap.at(time)), &data.rows::<f64, 4>("snap")[k], 12);
    }
}

fn space_vectors<T: Real>() {
    let data = Data::read(include_str!("../data/drives.txt"));
    let vectors = data.rows::<T, 2>("vectors");
    for ([alpha, beta], duties) in vectors.into_iter().zip(data.rows::<T, 3>("duties")) {
        let found = space_vector(Stator { alpha, beta }, real(24.0));
        near(&found.duties, &duties, 14);
        assert!(!found.is_limited);
    }
    let [flux, direct, quadrature] = data.all::<T, 3>("motor");
    for (current, best) in data.get::<T>("currents").into_iter().zip(data.rows::<T, 2>("mtpa")) {
        let found = mtpa(current, flux, direct, quadrature);
        // A search for a maximum finds half of the digits.
        near(&[found.direct, found.quadrature], &best, 7);
    }
}

#[test]
fn space_vectors_and_torque() {
    space_vectors::<f64>();
    space_vectors::<f32>();
}

/// Follows a motor whose currents an ODE has computed; returns the largest error of the angle in the second half.
fn observed<T: Real>() -> f64 {
    let data = Data::read(include_str!("../data/drives.txt"));
    let [resistance, inductance, flux, period] = data.all::<T, 4>("observed");
    let gain = real::<T>(1000.0) / (flux * flux);
    let motor = FluxParameters { resistance, inductance, flux, gain, period };
    let mut observer = FluxObserver::default();
    observer.preset(&motor, real(0.5));
    let mut worst = 0.0_f64;
    for (k, row) in data.rows::<T, 5>("motion").into_iter().enumerate() {
        let [alpha, beta, current_alpha, current_beta, angle] = row;
        let current = Stator { alpha: current_alpha, beta: current_beta };
        observer.step(&motor, Stator { alpha, beta }, current);
        let off = (observer.angle() - angle).as_f64();
        if k >= 200 {
            worst = worst.max(off.sin().abs().max(1.0 - off.cos()));
        }
    }
    worst
}

#[test]
fn the_flux_observer_finds_the_angle_of_a_motor_that_an_ode_simulates() {
    let (double, single) = (observed::<f64>(), observed::<f32>());
    assert!(double < 0.02 && single < 0.02, "{double} rad, {single} rad");
}

fn attitudes<T: Real>() {
    let data = Data::read(include_str!("../data/attitude.txt"));
    let [period, proportional, integral, gain] = data.all::<T, 4>("gains");
    let (mut mahony, mut madgwick) = (Mahony::default(), Madgwick::default());
    let mahony_gains = MahonyGains { proportional, integral, period };
    let samples = data.rows::<T, 3>("gyro").into_iter().zip(data.rows::<T, 3>("force"));
    let numbers = |q: UnitQuaternion<T>| [q.w, q.i, q.j, q.k];
    for (k, (rates, force)) in samples.enumerate() {
        let (rates, force) = (Vector3::from(rates), Vector3::from(force));
        let found = mahony.step(&mahony_gains, &rates, &force);
        near(&numbers(found), &data.rows::<T, 4>("mahony")[k], 13);
        let found = madgwick.step(&MadgwickGain { gain, period }, &rates, &force);
        near(&numbers(found), &data.rows::<T, 4>("madgwick")[k], 13);
    }
    let quaternion =
        |[i, j, k, w]: [T; 4]| UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k));
    let pairs = data.rows("attitudes").into_iter().zip(data.rows("targets"));
    for ((attitude, target), error) in pairs.zip(data.rows::<T, 3>("errors")) {
        let found = attitude_error(&quaternion(attitude), &quaternion(target));
        near(found.as_slice(), &error, 13);
    }
}

#[test]
fn attitudes_equal_those_of_ahrs() {
    attitudes::<f64>();
    attitudes::<f32>();
}

fn error_states<T: Real>(digits: i32) {
    let data = Data::read(include_str!("../data/error_state.txt"));
    let noise = ErrorStateNoise {
        rates: real::<T>(1e-5),
        drift: real(1e-8),
        force: real(4e-3),
        gate: real(1e6),
        period: real(0.01),
    };
    let variances = [0.25, 0.25, 1.5, 1e-3, 1e-3, 1e-3].map(real::<T>);
    let north = Vector3::new(real(0.6), T::ZERO, real(-0.8));
    let mut filter = ErrorStateFilter::<T>::default();
    filter.begin(&UnitQuaternion::identity(), &SVector::from(variances));
    let (attitudes, biases) = (data.rows::<T, 4>("attitude"), data.rows::<T, 3>("bias"));
    let (fields, surprises) = (data.rows::<T, 3>("field"), data.get::<T>("surprise"));
    let samples = data.rows::<T, 3>("rates").into_iter().zip(data.rows::<T, 3>("force"));
    let mut attitude = UnitQuaternion::identity();
    for (k, (rates, force)) in samples.enumerate() {
        filter.predict(&noise, &Vector3::from(rates));
        let up = filter.correct(&Vector3::z(), &Vector3::from(force), noise.force, noise.gate);
        let mut surprise = up.surprise;
        if k % 5 == 0 {
            let field = Vector3::from(fields[k / 5]);
            surprise = filter.correct(&north, &field, real(1e-2), noise.gate).surprise;
        }
        attitude = filter.attitude();
        if k % 20 == 0 {
            let found = [attitude.i, attitude.j, attitude.k, attitude.w];
            let sign = if attitude.w < T::ZERO { -T::ONE } else { T::ONE };
            let expected = attitudes[k / 20];
            let turned = if expected[3] < T::ZERO { -T::ONE } else { T::ONE };
            near(&found.map(|it| it * sign), &expected.map(|it| it * turned), digits);
            near(filter.bias().as_slice(), &biases[k / 20], digits - 1);
            near(&[surprise], &surprises[k / 20..=k / 20], digits - 2);
        }
    }
    let [i, j, k, w] = data.all::<T, 4>("truth");
    let truth = UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k));
    assert!(attitude_error(&attitude, &truth).norm().as_f64() < 0.03);
    assert!((filter.bias() - Vector3::from(data.all::<T, 3>("true_bias"))).norm().as_f64() < 0.06);
}

#[test]
fn an_error_state_filter_equals_one_on_dense_matrices() {
    error_states::<f64>(11);
    error_states::<f32>(13);
}

/// Samples that are none, and surprising ones, change nothing.
#[test]
fn an_error_state_filter_ignores_what_it_must() {
    let noise =
        ErrorStateNoise { rates: 1e-5, drift: 1e-8, force: 1e-3, gate: 16.0, period: 0.01_f64 };
    let mut filter = ErrorStateFilter::default();
    for _ in 0..200 {
        filter.step(&noise, &Vector3::zeros(), &Vector3::new(0.0, 0.1, 0.995));
    }
    let before = filter.clone();
    filter.predict(&noise, &Vector3::new(f64::NAN, 0.0, 0.0));
    for force in [[0.0; 3], [f64::INFINITY, 0.0, 1.0], [f64::NAN, 0.0, 1.0], [1.0, 0.0, 0.0]] {
        let found = filter.correct(&Vector3::z(), &Vector3::from(force), noise.force, noise.gate);
        assert_eq!(found.status, bessemer_estimation::Status::Rejected, "{force:?}");
    }
    assert_eq!(filter, before);
}
