//! Nonlinear predictive control of a pendulum on a cart, and a linear one of a lander within a cone of thrust.

pub use bessemer_blocks::{Horizon, Outcome, RealTimeIteration, Receding, RiccatiAdmm, RiccatiProgram};
use bessemer::prelude::*;

/// Period of the prediction, s.
const PERIOD: f64 = 0.05;

/// Acceleration of the cart, m/s², as the input; state: position, m, angle from upright, rad, and their rates.
#[function]
pub fn swung(state: &Vector4<f64>, push: &SVector<f64, 1>) -> Vector4<f64> {
    let (sine, cosine) = state[1].sin_cos();
    // A rod of 0.5 m with its mass at the end.
    let turn = (9.81 * sine - push[0] * cosine) / 0.5 - 0.1 * state[3];
    let (speed, rate) = (state[2] + PERIOD * push[0], state[3] + PERIOD * turn);
    Vector4::new(state[0] + PERIOD * speed, state[1] + PERIOD * rate, speed, rate)
}

/// The next state with its Jacobians by the state and by the push.
#[function(derivative(swung, state, push))]
pub fn swung_jacobian(
    state: &Vector4<f64>,
    push: &SVector<f64, 1>,
) -> (Vector4<f64>, Matrix4<f64>, Vector4<f64>) {
    let sin_cos_state_1 = state[1].sin_cos();
    let slope = -sin_cos_state_1.0;
    let turn = (9.81 * sin_cos_state_1.0 - push[0] * sin_cos_state_1.1) / 0.5 - 0.1 * state[3];
    let turn_d1 = (9.81 * sin_cos_state_1.1 - push[0] * slope) / 0.5;
    let turn_d4 = -sin_cos_state_1.1 / 0.5;
    let speed = state[2] + PERIOD * push[0];
    let rate = state[3] + PERIOD * turn;
    let rate_d1 = PERIOD * turn_d1;
    let rate_d3 = 1.0 + PERIOD * -0.1;
    let rate_d4 = PERIOD * turn_d4;
    let result_0 = state[0] + PERIOD * speed;
    let result_0_d4 = PERIOD * PERIOD;
    let result_1 = state[1] + PERIOD * rate;
    let result_1_d1 = 1.0 + PERIOD * rate_d1;
    let result_1_d3 = PERIOD * rate_d3;
    let result_1_d4 = PERIOD * rate_d4;
    let mut jacobian: SMatrix<f64, 4, 4> = SMatrix::zeros();
    jacobian[(0, 0)] = 1.0;
    jacobian[(0, 2)] = PERIOD;
    jacobian[(1, 1)] = result_1_d1;
    jacobian[(1, 3)] = result_1_d3;
    jacobian[(2, 2)] = 1.0;
    jacobian[(3, 1)] = rate_d1;
    jacobian[(3, 3)] = rate_d3;
    let mut jacobian_2: SVector<f64, 4> = SVector::zeros();
    jacobian_2[0] = result_0_d4;
    jacobian_2[1] = result_1_d4;
    jacobian_2[2] = PERIOD;
    jacobian_2[3] = rate_d4;
    (vector![result_0, result_1, speed, rate], jacobian, jacobian_2)
}

/// Balances a pendulum, within 0.8 m of the middle.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Balance {
    plan: RealTimeIteration<f64, 4, 1, 1, 8, 8, 16, 12>,
}

#[component]
impl Balance {
    /// Plans to stay at a state.
    #[entry(infallible)]
    pub fn begin(&mut self, state: &Vector4<f64>) {
        self.plan.begin(state, &SVector::zeros());
    }

    /// Advances one period; returns the acceleration of the cart, at most 12 m/s².
    #[entry(infallible)]
    pub fn step(&mut self, state: &Vector4<f64>, target: f64) -> Receding<f64, 1> {
        let weights = Vector4::new(2.0, 4.0, 0.1, 0.2);
        let horizon = Horizon {
            state: Matrix4::from_diagonal(&weights),
            last: Matrix4::from_diagonal(&(weights * 20.0)),
            input: SMatrix::<f64, 1, 1>::repeat(0.01),
            rest: SVector::zeros(),
            low: SVector::repeat(-12.0),
            high: SVector::repeat(12.0),
            outputs: RowVector4::new(1.0, 0.0, 0.0, 0.0),
            lowest: SVector::repeat(-0.8),
            highest: SVector::repeat(0.8),
            tolerance: 1e-6,
        };
        let targets = [Vector4::new(target, 0.0, 0.0, 0.0); 8];
        self.plan.step(&horizon, state, &targets, |state, push| swung_jacobian(state, push))
    }
}

/// Periods of the lander's plan.
const PERIODS: usize = 8;

/// Controls a lander by a linear law of its position, m, and velocity, m/s, along three axes.
/// The input is the acceleration of its engine less gravity, m/s².
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lander {
    plan: RiccatiAdmm<f32, 6, 3, PERIODS, 1, 3, 10>,
}

#[component]
impl Lander {
    /// Advances one period; returns the acceleration along the axes, of which the first is up.
    #[entry(infallible)]
    pub fn step(&mut self, program: &RiccatiProgram<f32, 6, 3>, state: &SVector<f32, 6>) -> Vector3<f32> {
        self.plan.step(program, state, &SVector::zeros()).input
    }
}
