//! Designs against python-control and SciPy, whose values `blocks/tests/data/generate.py` writes.

use bessemer_design::constants::Constants;
use bessemer_design::*;
use nalgebra::{Complex, Matrix1, Matrix3, SMatrix, Vector3};

/// Returns the numbers of a name.
fn get(name: &str) -> Vec<f64> {
    let line = include_str!("design.txt").lines().find(|line| line.split(' ').next() == Some(name));
    let numbers = line.unwrap_or_else(|| panic!("no `{name}`")).split(' ').skip(1);
    numbers.map(|number| number.parse().expect("a number")).collect()
}

fn matrix<const R: usize, const C: usize>(name: &str) -> SMatrix<f64, R, C> {
    SMatrix::from_row_slice(&get(name))
}

/// Checks a matrix, relative to its largest element.
#[track_caller]
fn near<const R: usize, const C: usize>(found: &SMatrix<f64, R, C>, name: &str, digits: i32) {
    let expected = matrix::<R, C>(name);
    let off = (found - expected).amax() / expected.amax();
    assert!(off < 10_f64.powi(-digits), "{name}: {found} is not {expected}");
}

/// Returns the continuous system of the tests: a swinging load with an actuator.
fn system() -> StateSpace<3> {
    StateSpace { a: matrix("a"), b: matrix("b"), c: matrix("c"), d: 0.1 }
}

fn held() -> (Matrix3<f64>, Vector3<f64>) {
    zero_order_hold(&system().a, &system().b, 0.02)
}

#[test]
fn discrete_models() {
    let (a, b) = held();
    near(&a, "held_a", 13);
    near(&b, "held_b", 13);
    for (name, prewarped) in [("tustin", None), ("prewarped", Some(30.0))] {
        let found = system().tustin(0.02, prewarped).expect("2/h is no pole");
        near(&found.a, &format!("{name}_a"), 13);
        near(&found.b, &format!("{name}_b"), 13);
        near(&found.c, &format!("{name}_c"), 13);
        near(&Matrix1::new(found.d), &format!("{name}_d"), 13);
    }
    // An integrator, whose matrix has no inverse; and a long period.
    let (a, b) = zero_order_hold(&Matrix1::new(0.0), &Matrix1::new(3.0), 0.5);
    assert_eq!((a[(0, 0)], b[(0, 0)]), (1.0, 1.5));
    let (a, _) = zero_order_hold(&Matrix1::new(-2.0), &Matrix1::new(1.0), 10.0);
    assert!((a[(0, 0)] / (-20.0_f64).exp() - 1.0).abs() < 1e-9);
}

#[test]
fn gains() {
    let (a, b) = held();
    let (q, r) = (Matrix3::from_diagonal(&Vector3::new(10.0, 1.0, 0.1)), Matrix1::new(0.5));
    near(&dare(&a, &b, &q, &r).expect("a solution"), "riccati", 11);
    near(&lqr(&a, &b, &q, &r).expect("a gain"), "lqr", 11);
    let noise = Matrix3::from_diagonal(&Vector3::new(0.01, 0.1, 0.2));
    let gain = kalman(&a, &system().c, &noise, &Matrix1::new(0.3)).expect("a gain");
    near(&gain, "kalman", 11);
    let poles = [Complex::new(0.7, 0.0), Complex::new(0.6, 0.2), Complex::new(0.6, -0.2)];
    near(&place(&a, &b, &poles).expect("a gain"), "place", 10);
}

#[test]
fn what_has_no_solution_is_none() {
    let (unstable, nothing) = (Matrix1::new(2.0), Matrix1::new(0.0));
    assert_eq!(lqr(&unstable, &nothing, &Matrix1::new(1.0), &Matrix1::new(1.0)), None);
    assert_eq!(lqr(&unstable, &Matrix1::new(1.0), &Matrix1::new(1.0), &nothing), None);
    assert_eq!(place(&unstable, &nothing, &[Complex::new(0.5, 0.0)]), None);
    let pole = StateSpace { a: Matrix1::new(2.0), b: nothing, c: nothing, d: 0.0 };
    assert_eq!(pole.tustin(1.0, None), None);
}

#[test]
fn filters() {
    let cycles = get("cycles");
    for order in [1, 2, 3, 4, 5, 8] {
        for (kind, name) in [(Kind::LowPass, "lowpass"), (Kind::HighPass, "highpass")] {
            for (family, sections) in [
                ("butterworth", butterworth(kind, order, 60.0, 1000.0)),
                ("chebyshev", chebyshev(kind, order, 1.5, 60.0, 1000.0)),
            ] {
                assert_eq!(sections.len(), order.div_ceil(2));
                let name = format!("{family}_{name}_{order}");
                for (cycles, expected) in cycles.iter().zip(get(&name).as_chunks::<2>().0) {
                    let off = sections.gain(*cycles) - Complex::new(expected[0], expected[1]);
                    assert!(off.norm_sqr().sqrt() < 1e-10, "{name} at {cycles}");
                }
            }
        }
    }
}

#[test]
fn responses_and_their_plot() {
    let (a, b) = held();
    let system = StateSpace { a, b, ..system() };
    for (found, expected) in system.step_response(20).iter().zip(get("step")) {
        assert!((found - expected).abs() < 1e-12, "{found} is not {expected}");
    }
    // After a long time, the step response is the gain at rest.
    let last = system.step_response(5000)[4999];
    assert!((system.gain(0.0).re - last).abs() < 1e-9);
    let sections = butterworth(Kind::LowPass, 4, 60.0, 1000.0);
    assert!((sections.step_response(500)[499] - 1.0).abs() < 1e-9);
    let picture = plot(&system, 0.02, 1.0).expect("finite responses");
    assert!(picture.starts_with("<svg") && picture.matches("<polyline").count() >= 2);
}

/// Compares constants that a model of the book includes with designed ones.
fn stored(name: &str, text: &str) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/corpus/src/programs/blocks");
    let path = format!("{folder}/{name}.in");
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(&path, text).expect("the constants are written");
    }
    // The last digits may differ on another machine.
    let numbers = |text: &str| -> Vec<f64> {
        let words = text.split(|it: char| !(it.is_ascii_digit() || "+-.e".contains(it)));
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let stored = numbers(&std::fs::read_to_string(path).expect("the constants are there"));
    let found = numbers(text);
    assert_eq!(stored.len(), found.len());
    for (stored, found) in stored.iter().zip(&found) {
        assert!((stored - found).abs() <= 1e-12 * found.abs().max(1.0), "{stored} is not {found}");
    }
}

/// The cart of [`the_constants_of_the_example_are_designed`], predicted over eight periods of 100 ms.
fn predicted() -> (Condensed<2, 8, 16>, nalgebra::RowVector2<f64>) {
    let (a, b) = (nalgebra::Matrix2::new(0.0, 1.0, 0.0, -0.5), nalgebra::Vector2::new(0.0, 2.0));
    let (transition, input) = zero_order_hold(&a, &b, 0.1);
    let (q, r) = (nalgebra::Matrix2::new(100.0, 0.0, 0.0, 1.0), Matrix1::new(0.1));
    let last = dare(&transition, &input, &q, &r).expect("a solution");
    let speed = nalgebra::RowVector2::new(0.0, 1.0);
    let program = condensed((&transition, &input, &speed), (&q, &r, &last)).expect("its sizes");
    (program, lqr(&transition, &input, &q, &r).expect("a gain"))
}

/// Without limits, a prediction with the regulator's cost at its end is the regulator.
#[test]
fn predictions_without_limits_are_the_regulator() {
    let (program, gain) = predicted();
    let state = nalgebra::Vector2::new(0.3, -0.2);
    let inputs = program.hessian.try_inverse().expect("definite") * -(program.gradient * state);
    assert!((inputs[0] + (gain * state)[0]).abs() < 1e-10, "{inputs}");
    // The rows are the inputs, and the speeds that they cause.
    let (transition, input) = zero_order_hold(
        &nalgebra::Matrix2::new(0.0, 1.0, 0.0, -0.5),
        &nalgebra::Vector2::new(0.0, 2.0),
        0.1,
    );
    let (rows, mut state_then) = (program.rows * inputs + program.offset * state, state);
    for k in 0..8 {
        state_then = transition * state_then + input * inputs[k];
        assert_eq!(rows[k], inputs[k]);
        assert!((rows[8 + k] - state_then.y).abs() < 1e-12, "{k}");
    }
    let wrong: Option<Condensed<2, 8, 15>> = condensed(
        (&transition, &input, &nalgebra::RowVector2::new(0.0, 1.0)),
        (&transition, &Matrix1::new(1.0), &transition),
    );
    assert_eq!(wrong, None);
}

/// The constants of the book's predictive control.
#[test]
fn the_prediction_of_the_example_is_designed() {
    let (program, _) = predicted();
    let solver = bessemer_blocks::ActiveSetProgram::new(&program.hessian, &program.rows, 1e-6);
    let solver = solver.expect("definite");
    let text = Constants::new()
        .matrix("GRADIENT", "Gradient of the cost for each state", &program.gradient)
        .matrix("OFFSET", "Inputs and speeds for each state", &program.offset)
        .matrix("INVERSE", "L⁻ᵀ of the solver", &solver.inverse)
        .matrix("ROWS", "Rows of the solver", &solver.rows)
        .text();
    stored("predicted", &text);
}

/// The constants of the book's example, which the model includes.
#[test]
fn the_constants_of_the_example_are_designed() {
    // A cart on a rail: position and speed, pushed by a force.
    let (a, b) = (nalgebra::Matrix2::new(0.0, 1.0, 0.0, -0.5), nalgebra::Vector2::new(0.0, 2.0));
    let (transition, input) = zero_order_hold(&a, &b, 0.01);
    let weight = nalgebra::Matrix2::new(100.0, 0.0, 0.0, 1.0);
    let gain = lqr(&transition, &input, &weight, &Matrix1::new(0.1)).expect("a gain");
    let noise = nalgebra::Matrix2::new(1e-6, 0.0, 0.0, 1e-3);
    let seen = nalgebra::RowVector2::new(1.0, 0.0);
    let observer = kalman(&transition, &seen, &noise, &Matrix1::new(1e-4)).expect("a gain");
    let text = Constants::new()
        .matrix("TRANSITION", "State after a period of 10 ms without a force", &transition)
        .matrix("INPUT", "State after a period with a force of 1 N from rest", &input)
        .matrix("GAIN", "Gain of the regulator, N/m and N·s/m", &gain)
        .matrix("OBSERVER", "Gain of the observer, 1 and 1/s", &observer)
        .sections(
            "SMOOTH",
            "Butterworth low-pass at 5 Hz",
            &butterworth(Kind::LowPass, 3, 5.0, 100.0),
        )
        .text();
    stored("designed", &text);
    let single = Constants::single().number("SHARE", "Share of the way", 0.1).text();
    assert_eq!(single, "/// Share of the way.\npub const SHARE: f32 = 0.1;\n");
}
