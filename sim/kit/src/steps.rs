//! One step of each method: Euler, the classical Runge–Kutta method, and the embedded pair of Dormand and Prince.
//!
//! Knows no events and no step control. Sources: Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations
//! I*, 1993, tables II.1.2 and II.5.2; Dormand and Prince, *A family of embedded Runge–Kutta formulae*, Journal of
//! Computational and Applied Mathematics 6 (1), 1980.

use crate::dense::Dense;
use crate::system::{State, System};

/// Nodes of Dormand and Prince: where in the step each stage is.
const NODES: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

/// Weights of the stages before each stage. The last row is the solution of order 5.
const STAGES: [&[f64]; 7] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Weights of the difference between the solutions of order 5 and 4.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Weights of the coefficient r4 of the dense output (Hairer's `dopri5`).
const FOURTH: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// A step: its last state, and what error control and dense output need of it.
pub(crate) struct Step<const N: usize> {
    start: State<N>,
    first: State<N>,
    length: f64,
    pub(crate) end: State<N>,
    /// Estimated error of each state, in its unit; 0 for methods without an estimate.
    pub(crate) error: State<N>,
    stages: Option<[State<N>; 7]>,
}

impl<const N: usize> Step<N> {
    /// Takes Euler's step y + h f(t, y), of order 1; `first` is the derivative at the start.
    pub(crate) fn euler(state: &State<N>, first: State<N>, length: f64) -> Self {
        Self::fixed(state, first, length, state + first * length)
    }

    /// Takes a step of the classical Runge–Kutta method, of order 4; `first` is the derivative at the start.
    pub(crate) fn runge_kutta(
        system: &impl System<N>,
        time: f64,
        state: &State<N>,
        first: State<N>,
        length: f64,
    ) -> Self {
        let derivative = |time, state: &State<N>| system.derivative(time, state);
        let end = classical(derivative, time, state, first, length);
        Self::fixed(state, first, length, end)
    }

    fn fixed(state: &State<N>, first: State<N>, length: f64, end: State<N>) -> Self {
        Self { start: *state, first, length, end, error: State::zeros(), stages: None }
    }

    /// Takes a step of Dormand and Prince, of order 5; `first` is the derivative at the start.
    pub(crate) fn dormand_prince(
        system: &impl System<N>,
        time: f64,
        state: &State<N>,
        first: State<N>,
        length: f64,
    ) -> Self {
        let mut stages = [first; 7];
        let mut end = *state;
        for stage in 1..7 {
            end = state + weighted(STAGES[stage], &stages) * length;
            stages[stage] = system.derivative(time + NODES[stage] * length, &end);
        }
        let error = weighted(&ERROR, &stages) * length;
        Self { start: *state, first, length, end, error, stages: Some(stages) }
    }

    /// Returns the states within the step.
    pub(crate) fn dense(&self, system: &impl System<N>, end: f64) -> Dense<N> {
        let (last, fourth) = match &self.stages {
            Some(stages) => (stages[6], weighted(&FOURTH, stages) * self.length),
            None => (system.derivative(end, &self.end), State::zeros()),
        };
        Dense::new([self.start, self.end], [self.first, last], self.length, fourth)
    }
}

/// Takes one step of the classical Runge–Kutta method, of order 4, of a length in s, and returns the state after it.
///
/// This is the step of [`Solver::RungeKutta`](crate::Solver::RungeKutta), without events.
///
/// ```
/// use bessemer_sim::{State, runge_kutta};
/// let state = runge_kutta(|_, state| -state, 0.0, &State::from([1.0]), 0.1);
/// assert!((state[0] - (-0.1_f64).exp()).abs() < 1e-7);
/// ```
pub fn runge_kutta<const N: usize>(
    derivative: impl Fn(f64, &State<N>) -> State<N>,
    time: f64,
    state: &State<N>,
    length: f64,
) -> State<N> {
    let first = derivative(time, state);
    classical(derivative, time, state, first, length)
}

/// Takes the step of [`runge_kutta`] with a known first derivative.
fn classical<const N: usize>(
    derivative: impl Fn(f64, &State<N>) -> State<N>,
    time: f64,
    state: &State<N>,
    first: State<N>,
    length: f64,
) -> State<N> {
    let half = 0.5 * length;
    let second = derivative(time + half, &(state + first * half));
    let third = derivative(time + half, &(state + second * half));
    let fourth = derivative(time + length, &(state + third * length));
    state + (first + second * 2.0 + third * 2.0 + fourth) * (length / 6.0)
}

/// Returns the weighted sum of the first stages.
fn weighted<const N: usize>(weights: &[f64], stages: &[State<N>; 7]) -> State<N> {
    let mut sum = State::zeros();
    for (weight, stage) in weights.iter().zip(stages) {
        if *weight != 0.0 {
            sum += stage * *weight;
        }
    }
    sum
}
