//! Integrators against closed forms, against an orbit of the literature, and against SciPy.

use std::f64::consts::{FRAC_PI_2, PI};

use bessemer_sim::{Error, Integrator, Solver, State, System, Tolerances};

fn tight(tolerance: f64) -> Solver {
    let tolerances = Tolerances { relative: tolerance, absolute: tolerance, ..Default::default() };
    Solver::DormandPrince(tolerances)
}

fn solved<const N: usize>(
    solver: Solver,
    system: impl Fn(f64, &State<N>) -> State<N>,
    start: [f64; N],
    until: f64,
) -> State<N> {
    let mut state = State::from(start);
    let mut system = system;
    let mut integrator = Integrator::new(solver).expect("a valid solver");
    integrator.advance(&mut system, 0.0, &mut state, until).expect("it is integrated");
    state
}

fn oscillator(_: f64, state: &State<2>) -> State<2> {
    State::from([state[1], -state[0]])
}

/// y' = −y has y(1) = 1/e; halving the step divides the error by 2 to the order.
#[test]
fn fixed_steps_have_their_order() {
    let error =
        |solver| (solved(solver, |_, state| -state, [1.0], 1.0)[0] - (-1.0_f64).exp()).abs();
    let euler = |step| error(Solver::Euler { step });
    let runge_kutta = |step| error(Solver::RungeKutta { step });
    let order = |coarse: f64, fine: f64| (coarse / fine).log2();
    assert!((order(euler(0.01), euler(0.005)) - 1.0).abs() < 0.01);
    assert!((order(runge_kutta(0.1), runge_kutta(0.05)) - 4.0).abs() < 0.1);
    assert!(runge_kutta(0.01) < 1e-10);
}

/// Ten periods of an oscillator: energy 1/2, and the phase it started with.
#[test]
fn an_oscillator_keeps_energy_and_phase() {
    for (solver, bound) in
        [(Solver::RungeKutta { step: 0.01 }, 1e-8), (tight(1e-10), 1e-8), (tight(1e-6), 1e-4)]
    {
        let end = solved(solver, oscillator, [1.0, 0.0], 20.0 * PI);
        let energy = 0.5 * end.norm_squared();
        assert!((energy - 0.5).abs() < bound, "{solver:?}: energy {energy}");
        let phase = (-end[1]).atan2(end[0]);
        assert!(phase.abs() < bound, "{solver:?}: phase {phase}");
    }
}

/// The Arenstorf orbit closes after 17.0652165601579625588917206249 units of time (Hairer, Nørsett and Wanner, eqs.
/// (II.0.1) and (II.0.2)).
#[test]
fn the_arenstorf_orbit_closes() {
    const MOON: f64 = 0.012_277_471;
    let orbit = |_: f64, state: &State<4>| {
        let [x, y, u, v] = [state[0], state[1], state[2], state[3]];
        let earth = ((x + MOON).powi(2) + y * y).powf(1.5);
        let moon = ((x - 1.0 + MOON).powi(2) + y * y).powf(1.5);
        let (near, far) = ((1.0 - MOON) / earth, MOON / moon);
        State::from([
            u,
            v,
            x + 2.0 * v - near * (x + MOON) - far * (x - 1.0 + MOON),
            y - 2.0 * u - near * y - far * y,
        ])
    };
    let start = [0.994, 0.0, 0.0, -2.001_585_106_379_082_5];
    let end = solved(tight(1e-12), orbit, start, 17.065_216_560_157_964);
    assert!((end[0] - 0.994).abs() < 1e-6 && end[1].abs() < 1e-6, "{end}");
}

/// Van der Pol's oscillator with μ = 5 at 20, against SciPy 1.17.1:
///
/// ```text
/// solve_ivp(lambda t, y: [y[1], 5*(1 - y[0]**2)*y[1] - y[0]], (0, 20), [2, 0], method="DOP853", rtol=1e-13, atol=1e-13)
/// ```
///
/// Its `Radau` with tolerances of 10⁻¹² differs from these by less than 10⁻¹².
#[test]
fn an_oscillator_of_van_der_pol_is_scipys() {
    let system =
        |_: f64, y: &State<2>| State::from([y[1], 5.0 * (1.0 - y[0] * y[0]) * y[1] - y[0]]);
    let end = solved(tight(1e-11), system, [2.0, 0.0], 20.0);
    let expected = State::from([-1.601_296_879_542_835_5, 0.198_326_676_338_667_3]);
    assert!((end - expected).amax() < 1e-8, "{end}");
}

/// Falls under gravity, and bounces with the coefficient of restitution 0.8.
struct Ball {
    /// Speed below which it rests, m/s.
    rest: f64,
    is_resting: bool,
}

const GRAVITY: f64 = 9.81;
const RESTITUTION: f64 = 0.8;

impl System<2> for Ball {
    fn derivative(&self, _: f64, state: &State<2>) -> State<2> {
        let weight = if self.is_resting { 0.0 } else { -GRAVITY };
        State::from([state[1], weight])
    }

    fn events(&self) -> usize {
        1
    }

    fn crossing(&self, _: usize, _: f64, state: &State<2>) -> f64 {
        state[0]
    }

    fn handle(&mut self, _: usize, _: f64, state: &mut State<2>) {
        let up = -RESTITUTION * state[1];
        self.is_resting = up < self.rest;
        *state = State::from([0.0, if self.is_resting { 0.0 } else { up }]);
    }
}

/// Impact n of a ball from height h is at √(2h/g) (1 + 2 (e + e² + … + eⁿ⁻¹)).
#[test]
fn a_ball_hits_the_floor_when_it_must() {
    let solvers = [
        (tight(1e-9), 1e-11),
        (Solver::RungeKutta { step: 0.01 }, 1e-11),
        // Euler's method has order 1: the impacts are late by some steps, and the speeds after them too high.
        (Solver::Euler { step: 1e-4 }, 1e-2),
    ];
    for (solver, bound) in solvers {
        let mut ball = Ball { rest: 0.5, is_resting: false };
        let mut state = State::from([1.0, 0.0]);
        let mut integrator = Integrator::new(solver).expect("a solver");
        let impacts = integrator.advance(&mut ball, 0.0, &mut state, 5.0).expect("it bounces");
        let fall = (2.0 / GRAVITY).sqrt();
        let (mut time, mut flight) = (fall, 2.0 * fall);
        for impact in &impacts {
            assert!((impact.time - time).abs() < bound, "{solver:?}: {} for {time}", impact.time);
            flight *= RESTITUTION;
            time += flight;
        }
        // √(2 g h) eⁿ falls below 0.5 m/s at n = 10.
        assert_eq!((impacts.len(), state), (10, State::zeros()), "{solver:?}");
    }
}

/// A handler that lifts the state by 10⁻⁵ lets a fall of 1 unit/s recur 100 000 times in 1 s.
#[test]
fn endless_events_are_an_error() {
    struct Stuck;
    impl System<1> for Stuck {
        fn derivative(&self, _: f64, _: &State<1>) -> State<1> {
            State::from([-1.0])
        }
        fn events(&self) -> usize {
            1
        }
        fn crossing(&self, _: usize, _: f64, state: &State<1>) -> f64 {
            state[0]
        }
        fn handle(&mut self, _: usize, _: f64, state: &mut State<1>) {
            state[0] = 1e-5;
        }
    }
    let mut integrator = Integrator::new(Solver::RungeKutta { step: 1.0 }).expect("a solver");
    let ended = integrator.advance(&mut Stuck, 0.0, &mut State::from([1e-5]), 1.0);
    assert!(matches!(ended, Err(Error::Chatter { event: 0, .. })), "{ended:?}");
}

/// Two events in one quarter of a step occur in order of time, not of index.
#[test]
fn events_are_in_order_of_time() {
    struct Fall;
    impl System<1> for Fall {
        fn derivative(&self, _: f64, _: &State<1>) -> State<1> {
            State::from([-1.0])
        }
        fn events(&self) -> usize {
            2
        }
        fn crossing(&self, event: usize, _: f64, state: &State<1>) -> f64 {
            state[0] - [0.45, 0.48][event]
        }
    }
    let mut integrator = Integrator::new(Solver::RungeKutta { step: 1.0 }).expect("a solver");
    let events =
        integrator.advance(&mut Fall, 0.0, &mut State::from([1.0]), 1.0).expect("it falls");
    assert_eq!(events.iter().map(|it| it.event).collect::<Vec<_>>(), [1, 0]);
    assert!((events[0].time - 0.52).abs() < 1e-14 && (events[1].time - 0.55).abs() < 1e-14);
}

/// A pendulum from 2 rad swings through 0 after a quarter of 2π/agm(1, cos 1) at √(g/l) = 1.
#[test]
fn a_pendulum_swings_through_when_it_must() {
    struct Pendulum;
    impl System<2> for Pendulum {
        fn derivative(&self, _: f64, state: &State<2>) -> State<2> {
            State::from([state[1], -state[0].sin()])
        }
        fn events(&self) -> usize {
            1
        }
        fn crossing(&self, _: usize, _: f64, state: &State<2>) -> f64 {
            state[0]
        }
    }
    let (mut a, mut b) = (1.0_f64, 1.0_f64.cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let mut integrator = Integrator::new(tight(1e-11)).expect("a solver");
    let mut state = State::from([2.0, 0.0]);
    let crossings = integrator.advance(&mut Pendulum, 0.0, &mut state, 12.0).expect("it swings");
    let expected = [FRAC_PI_2 / a, 5.0 * FRAC_PI_2 / a];
    assert_eq!(crossings.len(), 2);
    for (crossing, expected) in crossings.iter().zip(expected) {
        assert!((crossing.time - expected).abs() < 1e-8, "{} for {expected}", crossing.time);
    }
}

/// States between the ends of steps are as exact as the steps.
#[test]
fn dense_output_is_as_exact_as_its_steps() {
    let times: Vec<f64> = (0..=1000).map(|n| 0.01 * f64::from(n)).collect();
    for (solver, bound) in [(tight(1e-9), 1e-7), (Solver::RungeKutta { step: 0.02 }, 2e-8)] {
        let mut integrator = Integrator::new(solver).expect("a solver");
        let mut state = State::from([1.0, 0.0]);
        let states = integrator
            .trajectory(&mut { oscillator }, 0.0, &mut state, &times)
            .expect("it is integrated");
        assert_eq!(states.len(), times.len());
        for (time, state) in times.iter().zip(&states) {
            assert!((state[0] - time.cos()).abs() < bound, "{solver:?} at {time}: {state}");
        }
    }
}

#[test]
fn wrong_input_is_an_error() {
    type Made = Result<Integrator<1>, Error>;
    let made: [Made; 3] = [
        Integrator::new(Solver::Euler { step: 0.0 }),
        Integrator::new(Solver::RungeKutta { step: f64::NAN }),
        Integrator::new(tight(-1.0)),
    ];
    assert!(made.iter().all(|made| matches!(made, Err(Error::Range { .. }))));

    let mut state = State::from([1.0]);
    let mut integrator = Integrator::new(tight(1e-6)).expect("a solver");
    let mut infinite = |_: f64, state: &State<1>| state / 0.0;
    let ended = integrator.advance(&mut infinite, 0.0, &mut state, 1.0);
    assert!(matches!(ended, Err(Error::NotFinite { index: 0, .. })), "{ended:?}");
    let ended = integrator.advance(&mut infinite, 1.0, &mut state, 0.0);
    assert!(matches!(ended, Err(Error::Backwards { .. })), "{ended:?}");

    // A step that changes no time would never arrive.
    for solver in [Solver::Euler { step: 1e-300 }, Solver::RungeKutta { step: 1e-20 }] {
        let mut integrator = Integrator::new(solver).expect("a solver");
        let mut decay = |_: f64, state: &State<1>| -state;
        let ended = integrator.advance(&mut decay, 1.0, &mut State::from([1.0]), 2.0);
        assert!(matches!(ended, Err(Error::Underflow { .. })), "{ended:?}");
    }

    // y' = y² from 1 is infinite at 1.
    let mut pole = |_: f64, state: &State<1>| state.component_mul(state);
    let mut state = State::from([1.0]);
    let ended = integrator.advance(&mut pole, 0.0, &mut state, 2.0);
    assert!(matches!(ended, Err(Error::Underflow { .. } | Error::NotFinite { .. })), "{ended:?}");

    // Steps of some ns would take hours.
    let mut stiff = |time: f64, state: &State<1>| State::from([1e9 * (time.cos() - state[0])]);
    let ended = integrator.advance(&mut stiff, 0.0, &mut State::from([1.0]), 10.0);
    assert!(matches!(ended, Err(Error::Stiff { .. })), "{ended:?}");
}
