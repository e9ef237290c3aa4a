//! Integrators against SciPy's: `tests/data/generate.py` writes the values, and says how far its own methods differ.

use bessemer_sim::{Integrator, Solver, State, System, Tolerances};

const DATA: &str = include_str!("../data/scipy.txt");

/// Length of the single step in the data.
const STEP: f64 = 1.0 / 64.0;

fn numbers(name: &str) -> Vec<f64> {
    let line = DATA.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
    let words = line.unwrap_or_else(|| panic!("{name} is missing")).split(' ');
    words.map(|word| word.parse().expect("a number")).collect()
}

fn states<const N: usize>(name: &str) -> Vec<State<N>> {
    numbers(name).chunks(N).map(State::from_column_slice).collect()
}

/// Compares a whole solution at 16 times, and one step of the method, with SciPy's.
fn hold<const N: usize>(
    name: &str,
    system: impl Fn(f64, &State<N>) -> State<N> + Copy,
    start: [f64; N],
) {
    let start = State::from(start);
    let (times, expected) = (numbers(&format!("{name}_times")), states(&format!("{name}_states")));
    let size = expected.iter().map(State::amax).fold(0.0, f64::max);
    let adaptive = |tolerance: f64, longest_step: f64| {
        let (relative, absolute) = (tolerance, tolerance);
        Solver::DormandPrince(Tolerances { relative, absolute, longest_step })
    };
    // The error of a solution is that of its steps, by the growth of the system's errors.
    let solvers = [
        (adaptive(1e-11, f64::INFINITY), 1e-9),
        (adaptive(1e-7, f64::INFINITY), 1e-5),
        (Solver::RungeKutta { step: 1e-3 }, 1e-8),
    ];
    for (solver, bound) in solvers {
        let mut integrator = Integrator::new(solver).expect("a solver");
        let solved = integrator.trajectory(&mut { system }, 0.0, &mut { start }, &times);
        let solved = solved.expect("it is solved");
        for ((state, expected), time) in solved.iter().zip(&expected).zip(&times) {
            let error = (state - expected).amax() / size;
            assert!(error < bound, "{name} with {solver:?} at {time}: {error:e}");
        }
    }
    // No tolerance shortens this step, so it has the method's own digits.
    let mut integrator = Integrator::new(adaptive(1e3, STEP)).expect("a solver");
    let mut state = start;
    integrator.advance(&mut { system }, 0.0, &mut state, STEP).expect("it is solved");
    let error = (state - states(&format!("{name}_step"))[0]).amax() / size;
    assert!(error < 1e-15, "a step of {name}: {error:e}");
}

#[test]
fn solutions_are_scipys() {
    let van_der_pol =
        |_: f64, y: &State<2>| State::from([y[1], 5.0 * (1.0 - y[0] * y[0]) * y[1] - y[0]]);
    hold("van_der_pol", van_der_pol, [2.0, 0.0]);
    let lorenz = |_: f64, y: &State<3>| {
        let [a, b, c] = (*y).into();
        State::from([10.0 * (b - a), a * (28.0 - c) - b, a * b - 8.0 / 3.0 * c])
    };
    hold("lorenz", lorenz, [1.0; 3]);
    let predators =
        |_: f64, y: &State<2>| State::from([1.5 * y[0] - y[0] * y[1], y[0] * y[1] - 3.0 * y[1]]);
    hold("predators", predators, [10.0, 5.0]);
    hold("driven", driven, [0.0, 1.0]);
}

fn driven(time: f64, y: &State<2>) -> State<2> {
    State::from([y[1], time - time * time / 8.0 - 0.2 * y[1] - 4.0 * y[0]])
}

/// The driven oscillator, and its falls through 0.
struct Driven;

impl System<2> for Driven {
    fn derivative(&self, time: f64, state: &State<2>) -> State<2> {
        driven(time, state)
    }

    fn events(&self) -> usize {
        1
    }

    fn crossing(&self, _: usize, _: f64, state: &State<2>) -> f64 {
        state[0]
    }
}

#[test]
fn events_are_scipys() {
    let tolerances = Tolerances { relative: 1e-11, absolute: 1e-11, ..Default::default() };
    let mut integrator = Integrator::new(Solver::DormandPrince(tolerances)).expect("a solver");
    let events = integrator.advance(&mut Driven, 0.0, &mut State::from([0.0, 1.0]), 10.0);
    let events = events.expect("it is solved");
    let expected = numbers("driven_falls");
    assert_eq!(events.len(), expected.len());
    for (event, expected) in events.iter().zip(expected) {
        assert!((event.time - expected).abs() < 1e-9, "{} for {expected}", event.time);
    }
}
