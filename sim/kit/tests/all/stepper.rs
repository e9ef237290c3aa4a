//! A plant tick by tick: equal steps, the parts that it solves itself, and its limits.

use bessemer_sim::*;

use super::loops::{Tank, scenario, setup};

/// A ball that a motor pushes upwards. Its states are height, m, and speed, m/s; the motor follows its command with a
/// time constant of 0.1 s.
struct Ball {
    push: f64,
    /// Start and length of each interval, s.
    intervals: Vec<[f64; 2]>,
}

impl Plant<2> for Ball {
    /// Acceleration by the motor, m/s².
    type Command = f64;
    type Disturbance = ();

    fn derivative(&self, _: f64, state: &State<2>, _: &Input<f64, ()>) -> State<2> {
        State::from([state[1], self.push - 9.81])
    }

    fn begin(&mut self, time: f64, length: f64, _: &State<2>, input: &Input<f64, ()>) {
        self.intervals.push([time, length]);
        self.push = input.command + (self.push - input.command) * (-length / 0.1).exp();
    }

    fn end(&mut self, _: f64, state: &mut State<2>) {
        if state[0] < 0.0 {
            *state = State::zeros();
        }
    }
}

fn ball() -> Stepper<Ball, 2> {
    let tick = Tick::nanoseconds(10_000_000).expect("a tick");
    let ball = Ball { push: 0.0, intervals: Vec::new() };
    let input = Input { command: 0.0, disturbance: () };
    Stepper::new(ball, State::zeros(), input, tick, Integrator::default())
}

/// The steps of equal intervals are equal to the bit, however late it is.
#[test]
fn equal_intervals_have_equal_steps() {
    let decay = |_: f64, state: &State<1>| -state;
    struct Decay;
    impl Plant<1> for Decay {
        type Command = ();
        type Disturbance = ();
        fn derivative(&self, _: f64, state: &State<1>, _: &Input<(), ()>) -> State<1> {
            -state
        }
    }
    for length in [100_000, 333_333, 2_500_000] {
        let tick = Tick::nanoseconds(length).expect("a tick");
        let input = Input { command: (), disturbance: () };
        let mut stepper =
            Stepper::new(Decay, State::from([1.0]), input, tick, Integrator::default());
        let mut expected = State::from([1.0]);
        for count in 1..=1000 {
            stepper.advance(1).expect("it decays");
            expected = runge_kutta(decay, 0.0, &expected, tick.seconds(1));
            assert_eq!(stepper.state, expected, "{count} · {length} ns");
        }
        assert_eq!((stepper.now(), stepper.time()), (1000, tick.seconds(1000)));
    }
}

/// A part with a solution of its own and a floor: the ball stays down until the motor carries it.
#[test]
fn a_plant_solves_parts_itself_and_has_limits() {
    let mut ball = ball();
    ball.input.command = 20.0;
    let mut rose = None;
    for count in 1..=20 {
        ball.advance(1).expect("it moves");
        let push = 20.0 * (1.0 - (-0.1 * f64::from(count)).exp());
        assert!((ball.plant.push - push).abs() < 1e-12);
        assert_eq!(ball.state[0] > 0.0, push > 9.81, "{count}");
        rose = rose.or((ball.state[0] > 0.0).then_some(count));
    }
    // 20 (1 − e^−t/0.1) is 9.81 at 67 ms.
    assert_eq!(rose, Some(7));
    ball.input.command = 0.0;
    ball.advance(100).expect("it falls");
    assert_eq!(ball.state, State::<2>::zeros());
    assert_eq!(ball.plant.intervals[..2], [[0.0, 0.01], [0.01, 0.01]]);
    assert_eq!(ball.plant.intervals.last(), Some(&[0.2, 1.0]));
}

/// A loop of your own with the order of a run has its bits.
#[test]
fn a_loop_of_your_own_has_the_bits_of_a_run() {
    let wave = |time: f64| (time * 40.0).floor();
    let mut computer = |_: &[Reading; 0], goal: &f64| *goal;
    let changes = (1..40).map(|n| f64::from(n) / 40.0).map(|time| (time, wave(time))).collect();
    let scenario =
        Scenario { goals: Timeline::new(0.0, changes).expect("in order"), ..scenario(1.0) };
    let Setup { plant, start, tick, solver, .. } = setup([]);
    let run = setup([]).run(&scenario, &mut computer).expect("it runs");

    let input = Input { command: 0.0, disturbance: 0.0 };
    let mut stepper: Stepper<Tank, 1> =
        Stepper::new(plant, start, input, tick, Integrator::new(solver).expect("a solver"));
    while stepper.now() < 1000 {
        if stepper.now() % 4 == 0 {
            stepper.input.command = *scenario.goals.at(stepper.time());
        }
        // The run stops where the probes are recorded, too.
        let due = [4, 6, 25].map(|period| period - stepper.now() % period);
        let left = 1000 - stepper.now();
        stepper.advance(due.into_iter().min().unwrap_or(1).min(left)).expect("it moves");
    }
    assert_eq!(stepper.state, run.state);
}

/// Events have the time of the plant, and an interval that cannot be integrated is an error.
#[test]
fn events_and_errors_have_the_time_of_the_plant() {
    #[derive(Default)]
    struct Fuse {
        blown: Vec<f64>,
        times: std::cell::Cell<f64>,
    }
    impl Plant<1> for Fuse {
        type Command = f64;
        type Disturbance = ();
        fn derivative(&self, time: f64, _: &State<1>, input: &Input<f64, ()>) -> State<1> {
            self.times.set(time);
            State::from([input.command])
        }
        fn events(&self) -> usize {
            1
        }
        fn crossing(&self, _: usize, _: f64, state: &State<1>, _: &Input<f64, ()>) -> f64 {
            2.5 - state[0]
        }
        fn handle(&mut self, _: usize, time: f64, _: &mut State<1>) {
            self.blown.push(time);
        }
    }
    let tick = Tick::nanoseconds(1_000_000_000).expect("a tick");
    let input = Input { command: 1.0, disturbance: () };
    let mut fuse =
        Stepper::new(Fuse::default(), State::zeros(), input, tick, Integrator::default());
    assert_eq!(fuse.advance(2).expect("it lasts"), []);
    let events = fuse.advance(1).expect("it blows");
    assert!((events[0].time - 2.5).abs() < 1e-12 && fuse.plant.blown == [events[0].time]);
    assert_eq!((fuse.plant.times.get(), fuse.view().time), (3.0, 3.0));
    fuse.input.command = f64::NAN;
    let error = fuse.advance(1).expect_err("it is no number");
    assert!(matches!(error, Error::NotFinite { index: 0, .. }), "{error}");
}
