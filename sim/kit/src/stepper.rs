//! A plant in time, tick by tick: for a loop of your own, such as one with an operator, a link or a clock.
//!
//! [`Setup::run`](crate::Setup::run) rests on it. Knows no sensors, no computer and no scenario.

use crate::clock::Tick;
use crate::error::Error;
use crate::plant::{InputOf, Plant, View};
use crate::solver::{Integrator, Occurrence};
use crate::system::{State, System};

/// A plant P with N states, its input and its time.
///
/// A loop reads [`view`](Stepper::view), writes [`input`](Stepper::input), and advances. A mass that a hand pushes for 1 s:
///
/// ```
/// use bessemer_sim::*;
///
/// /// A mass of 2 kg on ice. Its states are the position, m, and the speed, m/s; its command is a force, N.
/// struct Mass;
///
/// impl Plant<2> for Mass {
///     type Command = f64;
///     type Disturbance = ();
///
///     fn derivative(&self, _: f64, state: &State<2>, input: &Input<f64, ()>) -> State<2> {
///         State::from([state[1], input.command / 2.0])
///     }
/// }
///
/// let tick = Tick::nanoseconds(10_000_000)?;
/// let input = Input { command: 4.0, disturbance: () };
/// let mut mass = Stepper::new(Mass, State::zeros(), input, tick, Integrator::default());
/// mass.advance(100)?;
/// mass.input.command = 0.0;
/// mass.advance(50)?;
/// assert_eq!(mass.time(), 1.5);
/// assert!((mass.state - State::from([2.0, 2.0])).norm() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct Stepper<P: Plant<N>, const N: usize> {
    /// The plant.
    pub plant: P,
    /// Its state.
    pub state: State<N>,
    /// Its input from now on.
    pub input: InputOf<P, N>,
    tick: Tick,
    now: u64,
    integrator: Integrator<N>,
}

impl<P: Plant<N>, const N: usize> Stepper<P, N> {
    /// Creates a plant at tick 0.
    pub fn new(
        plant: P,
        start: State<N>,
        input: InputOf<P, N>,
        tick: Tick,
        integrator: Integrator<N>,
    ) -> Self {
        Self { plant, state: start, input, tick, now: 0, integrator }
    }

    /// Returns the number of ticks since the start.
    pub fn now(&self) -> u64 {
        self.now
    }

    /// Returns the time, s.
    pub fn time(&self) -> f64 {
        self.tick.seconds(self.now)
    }

    /// Returns what sensors and probes see.
    pub fn view(&self) -> View<'_, P, N> {
        View { time: self.time(), plant: &self.plant, state: &self.state, input: &self.input }
    }

    /// Advances by a number of ticks in one interval, with the present input. Returns the events in order of time.
    ///
    /// # Errors
    ///
    /// The plant cannot be integrated; see [`Integrator::advance`].
    pub fn advance(&mut self, ticks: u64) -> Result<Vec<Occurrence>, Error> {
        let (start, length) = (self.time(), self.tick.seconds(ticks));
        self.plant.begin(start, length, &self.state, &self.input);
        let mut driven = Driven { plant: &mut self.plant, input: &self.input, start };
        let mut events = self.integrator.advance(&mut driven, 0.0, &mut self.state, length)?;
        events.iter_mut().for_each(|event| event.time += start);
        self.now = self.now.saturating_add(ticks);
        self.plant.end(self.tick.seconds(self.now), &mut self.state);
        Ok(events)
    }
}

/// The plant under a constant input, in time from the start of an interval.
///
/// The differences of large times would be rounded: equal intervals have steps of equal length only so.
struct Driven<'a, P: Plant<N>, const N: usize> {
    plant: &'a mut P,
    input: &'a InputOf<P, N>,
    /// Start of the interval, s.
    start: f64,
}

impl<P: Plant<N>, const N: usize> System<N> for Driven<'_, P, N> {
    fn derivative(&self, time: f64, state: &State<N>) -> State<N> {
        self.plant.derivative(self.start + time, state, self.input)
    }

    fn events(&self) -> usize {
        self.plant.events()
    }

    fn crossing(&self, event: usize, time: f64, state: &State<N>) -> f64 {
        self.plant.crossing(event, self.start + time, state, self.input)
    }

    fn handle(&mut self, event: usize, time: f64, state: &mut State<N>) {
        self.plant.handle(event, self.start + time, state);
    }
}
