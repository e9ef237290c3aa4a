//! The jobs of `cargo xtask bench --only dsp`, as a user writes them.
#![no_std]

use bessemer::prelude::*;

/// Samples in a block.
pub const BLOCK: usize = 64;
/// Sections of a cascade.
pub const SECTIONS: usize = 4;
/// Taps of a filter.
pub const TAPS: usize = 32;
/// Samples that a filter reads for a block.
pub const LINE: usize = BLOCK + TAPS - 1;

/// Gains of a PID controller in incremental form.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    pub a0: f32,
    pub a1: f32,
    pub a2: f32,
}

/// The memory of a PID controller in incremental form.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    pub last: f32,
    pub before: f32,
    pub output: f32,
}

#[data]
impl Memory {
    /// Advances one period; firmware may inline it.
    #[inline]
    pub fn advance(&mut self, gains: &Gains, error: f32) -> f32 {
        let output =
            gains.a0 * error + gains.a1 * self.last + gains.a2 * self.before + self.output;
        self.before = self.last;
        self.last = error;
        self.output = output;
        output
    }
}

/// A PID controller in incremental form.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Regulator {
    pub memory: Memory,
}

#[component]
impl Regulator {
    /// Advances one period.
    #[entry(infallible)]
    pub fn step(&mut self, gains: &Gains, error: f32) -> f32 {
        self.memory.advance(gains, error)
    }
}

/// Coefficients of a section: `y = b0 x + b1 x1 + b2 x2 + a1 y1 + a2 y2`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    pub b0: f32,
    pub b1: f32,
    pub b2: f32,
    pub a1: f32,
    pub a2: f32,
}

/// State of a section in direct form I.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Direct {
    pub x1: f32,
    pub x2: f32,
    pub y1: f32,
    pub y2: f32,
}

#[data]
impl Direct {
    /// Filters one sample.
    pub fn step(&mut self, section: &Section, x: f32) -> f32 {
        let y = section.b0 * x
            + section.b1 * self.x1
            + section.b2 * self.x2
            + section.a1 * self.y1
            + section.a2 * self.y2;
        self.x2 = self.x1;
        self.x1 = x;
        self.y2 = self.y1;
        self.y1 = y;
        y
    }
}

/// A cascade in direct form I.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DirectCascade {
    pub states: [Direct; SECTIONS],
}

#[component]
impl DirectCascade {
    /// Filters a block in place.
    #[entry(infallible)]
    pub fn filter(&mut self, sections: &[Section; SECTIONS], block: &mut [f32; BLOCK]) {
        for (section, state) in sections.iter().zip(self.states.iter_mut()) {
            for sample in block.iter_mut() {
                *sample = state.step(section, *sample);
            }
        }
    }
}

/// A cascade in transposed direct form II.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TransposedCascade {
    pub states: [[f32; 2]; SECTIONS],
}

#[component]
impl TransposedCascade {
    /// Filters a block in place.
    #[entry(infallible)]
    pub fn filter(&mut self, sections: &[Section; SECTIONS], block: &mut [f32; BLOCK]) {
        for (section, state) in sections.iter().zip(self.states.iter_mut()) {
            for sample in block.iter_mut() {
                let x = *sample;
                let y = section.b0 * x + state[0];
                state[0] = section.b1 * x + section.a1 * y + state[1];
                state[1] = section.b2 * x + section.a2 * y;
                *sample = y;
            }
        }
    }
}

/// A filter of finite impulse response, whose line holds the last samples, oldest first.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Fir {
    pub line: [f32; LINE],
}

impl Default for Fir {
    fn default() -> Self {
        Self { line: [0.0; LINE] }
    }
}

#[component]
impl Fir {
    /// Filters a block; `taps` are in reverse order.
    #[entry(infallible)]
    pub fn filter(&mut self, taps: &[f32; TAPS], input: &[f32; BLOCK]) -> [f32; BLOCK] {
        for n in 0..BLOCK {
            self.line[TAPS - 1 + n] = input[n];
        }
        let mut output = [0.0; BLOCK];
        for n in 0..BLOCK {
            let mut sum = 0.0;
            for k in 0..TAPS {
                sum += taps[k] * self.line[n + k];
            }
            output[n] = sum;
        }
        for k in 0..TAPS - 1 {
            self.line[k] = self.line[BLOCK + k];
        }
        output
    }
}

/// Two of three phase currents in the rotor's frame; firmware may inline it.
#[function]
#[inline]
pub fn transformed(a: f32, b: f32, sine: f32, cosine: f32) -> Vector2<f32> {
    let alpha = a;
    let beta = 0.577_350_26 * (a + 2.0 * b);
    Vector2::new(alpha * cosine + beta * sine, -alpha * sine + beta * cosine)
}

/// Two of three phase currents in the rotor's frame.
#[function]
pub fn clarke_park(a: f32, b: f32, sine: f32, cosine: f32) -> Vector2<f32> {
    transformed(a, b, sine, cosine)
}

/// Two of three phase currents in the frame of a rotor at `angle`.
#[function]
pub fn clarke_park_at(a: f32, b: f32, angle: f32) -> Vector2<f32> {
    let (sine, cosine) = angle.sin_cos();
    transformed(a, b, sine, cosine)
}

/// Controllers of the two currents of a motor, in the rotor's frame.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Currents {
    pub direct: Memory,
    pub quadrature: Memory,
}

#[component]
impl Currents {
    /// Advances one period: from two phase currents and the rotor's angle to the voltages of three phases.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        gains: &Gains,
        wanted: &Vector2<f32>,
        a: f32,
        b: f32,
        angle: f32,
    ) -> Vector3<f32> {
        let (sine, cosine) = angle.sin_cos();
        self.advance(gains, wanted, &transformed(a, b, sine, cosine), [sine, cosine])
    }

    /// As [`step`](Self::step), by the fast sine and cosine.
    #[entry(infallible)]
    pub fn step_fast(
        &mut self,
        gains: &Gains,
        wanted: &Vector2<f32>,
        a: f32,
        b: f32,
        angle: f32,
    ) -> Vector3<f32> {
        let (sine, cosine) = bessemer::fast::sin_cos(angle);
        self.advance(gains, wanted, &transformed(a, b, sine, cosine), [sine, cosine])
    }

    fn advance(
        &mut self,
        gains: &Gains,
        wanted: &Vector2<f32>,
        current: &Vector2<f32>,
        [sine, cosine]: [f32; 2],
    ) -> Vector3<f32> {
        let direct = self.direct.advance(gains, wanted.x - current.x);
        let quadrature = self.quadrature.advance(gains, wanted.y - current.y);
        let alpha = direct * cosine - quadrature * sine;
        let beta = direct * sine + quadrature * cosine;
        let half = -0.5 * alpha;
        let rest = 0.866_025_4 * beta;
        Vector3::new(alpha, half + rest, half - rest)
    }
}

/// A sine.
#[function]
pub fn sine(angle: f32) -> f32 {
    angle.sin()
}

/// A sine of the fast form.
#[function]
pub fn sine_fast(angle: f32) -> f32 {
    bessemer::fast::sin(angle)
}

/// As [`clarke_park_at`], by the fast sine and cosine.
#[function]
pub fn clarke_park_fast(a: f32, b: f32, angle: f32) -> Vector2<f32> {
    let (sine, cosine) = bessemer::fast::sin_cos(angle);
    transformed(a, b, sine, cosine)
}

/// The angle of a point.
#[function]
pub fn angle(y: f32, x: f32) -> f32 {
    y.atan2(x)
}

/// The angle of a point, in the fast form.
#[function]
pub fn angle_fast(y: f32, x: f32) -> f32 {
    bessemer::fast::atan2(y, x)
}

/// A power of e.
#[function]
pub fn power(x: f32) -> f32 {
    x.exp()
}

/// A power of e, in the fast form.
#[function]
pub fn power_fast(x: f32) -> f32 {
    bessemer::fast::exp(x)
}

/// A product.
#[function]
pub fn product(a: &SMatrix<f32, 12, 12>, b: &SMatrix<f32, 12, 12>) -> SMatrix<f32, 12, 12> {
    a * b
}

/// The solution of a positive definite system; zero if it is not.
#[function]
pub fn definite(a: &SMatrix<f32, 12, 12>, b: &SVector<f32, 12>) -> SVector<f32, 12> {
    match a.cholesky() {
        Some(factor) => factor.solve(b),
        None => SVector::<f32, 12>::zeros(),
    }
}

/// The solution of a system of four equations; zero if there is none.
#[function]
pub fn solved_4(a: &SMatrix<f32, 4, 4>, b: &SVector<f32, 4>) -> SVector<f32, 4> {
    a.lu().solve(b).unwrap_or(SVector::<f32, 4>::zeros())
}

/// The solution of a system of eight equations; zero if there is none.
#[function]
pub fn solved_8(a: &SMatrix<f32, 8, 8>, b: &SVector<f32, 8>) -> SVector<f32, 8> {
    a.lu().solve(b).unwrap_or(SVector::<f32, 8>::zeros())
}

/// The solution of a system of twenty equations; zero if there is none.
#[function]
pub fn solved_20(a: &SMatrix<f32, 20, 20>, b: &SVector<f32, 20>) -> SVector<f32, 20> {
    a.lu().solve(b).unwrap_or(SVector::<f32, 20>::zeros())
}

/// Solves a system of four equations in place.
#[function]
pub fn into_4(a: &SMatrix<f32, 4, 4>, b: &mut SVector<f32, 4>) -> bool {
    bessemer::solve_into(a, b)
}

/// Solves a system of eight equations in place.
#[function]
pub fn into_8(a: &SMatrix<f32, 8, 8>, b: &mut SVector<f32, 8>) -> bool {
    bessemer::solve_into(a, b)
}

/// Solves a system of twenty equations in place.
#[function]
pub fn into_20(a: &SMatrix<f32, 20, 20>, b: &mut SVector<f32, 20>) -> bool {
    bessemer::solve_into(a, b)
}

/// States of the predicted system.
pub const STATES: usize = 12;
/// Inputs of the predicted system.
pub const INPUTS: usize = 4;
/// Predicted states; there is one input fewer.
pub const HORIZON: usize = 10;

/// The predicted system, the gains of its regulator and its limits.
#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    pub a: SMatrix<f32, STATES, STATES>,
    pub b: SMatrix<f32, STATES, INPUTS>,
    pub gain: SMatrix<f32, INPUTS, STATES>,
    pub closed: SMatrix<f32, STATES, STATES>,
    pub inverse: SMatrix<f32, INPUTS, INPUTS>,
    pub cost_to_go: SMatrix<f32, STATES, STATES>,
    pub cost: SVector<f32, STATES>,
    pub target: SVector<f32, STATES>,
    pub low: SVector<f32, STATES>,
    pub high: SVector<f32, STATES>,
    pub least: SVector<f32, INPUTS>,
    pub most: SVector<f32, INPUTS>,
    pub rho: f32,
}

/// Variables of a step of one stage.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stage {
    pub x: SVector<f32, STATES>,
    pub slack: SVector<f32, STATES>,
    pub dual: SVector<f32, STATES>,
    pub q: SVector<f32, STATES>,
    pub p: SVector<f32, STATES>,
}

/// Variables of a step between two stages.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Action {
    pub u: SVector<f32, INPUTS>,
    pub slack: SVector<f32, INPUTS>,
    pub dual: SVector<f32, INPUTS>,
    pub r: SVector<f32, INPUTS>,
    pub d: SVector<f32, INPUTS>,
}

/// Model predictive control by the alternating direction method of multipliers.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mpc {
    pub stages: [Stage; HORIZON],
    pub actions: [Action; HORIZON - 1],
    pub primal: f32,
    pub dual: f32,
}

#[component]
impl Mpc {
    /// Returns the input for a state, after ten iterations.
    #[entry(infallible)]
    pub fn step(&mut self, plan: &Plan, state: &SVector<f32, STATES>) -> SVector<f32, INPUTS> {
        self.stages[0].x = *state;
        for _ in 0..10 {
            self.costs(plan);
            self.backward(plan);
            self.forward(plan);
            self.project(plan);
        }
        self.actions[0].u
    }

    fn costs(&mut self, plan: &Plan) {
        for stage in self.stages.iter_mut() {
            stage.q =
                -plan.target.component_mul(&plan.cost) - (stage.slack - stage.dual) * plan.rho;
        }
        for action in self.actions.iter_mut() {
            action.r = -(action.slack - action.dual) * plan.rho;
        }
        let last = &mut self.stages[HORIZON - 1];
        last.p = -(plan.cost_to_go * plan.target) - (last.slack - last.dual) * plan.rho;
    }

    fn backward(&mut self, plan: &Plan) {
        for i in (0..HORIZON - 1).rev() {
            let p = self.stages[i + 1].p;
            let r = self.actions[i].r;
            self.actions[i].d = plan.inverse * (plan.b.tr_mul(&p) + r);
            self.stages[i].p = self.stages[i].q + plan.closed * p - plan.gain.tr_mul(&r);
        }
    }

    fn forward(&mut self, plan: &Plan) {
        for i in 0..HORIZON - 1 {
            let x = self.stages[i].x;
            let u = -(plan.gain * x) - self.actions[i].d;
            self.actions[i].u = u;
            self.stages[i + 1].x = plan.a * x + plan.b * u;
        }
    }

    fn project(&mut self, plan: &Plan) {
        self.primal = 0.0;
        self.dual = 0.0;
        for stage in self.stages.iter_mut() {
            let slack = (stage.x + stage.dual).sup(&plan.low).inf(&plan.high);
            stage.dual += stage.x - slack;
            self.primal = self.primal.max((stage.x - slack).amax());
            self.dual = self.dual.max((stage.slack - slack).amax() * plan.rho);
            stage.slack = slack;
        }
        for action in self.actions.iter_mut() {
            let slack = (action.u + action.dual).sup(&plan.least).inf(&plan.most);
            action.dual += action.u - slack;
            self.primal = self.primal.max((action.u - slack).amax());
            self.dual = self.dual.max((action.slack - slack).amax() * plan.rho);
            action.slack = slack;
        }
    }
}
