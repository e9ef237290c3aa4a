//! The plant: continuous states that a command and a disturbance drive.
//!
//! Knows no sensors, no computer and no solver.

use crate::system::State;

/// Drive of a plant, constant between two ticks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Input<C, D> {
    /// Command of the computer.
    pub command: C,
    /// Disturbance of the scenario: a load, wind, a change of a parameter.
    pub disturbance: D,
}

/// Input of a plant P.
pub type InputOf<P, const N: usize> = Input<<P as Plant<N>>::Command, <P as Plant<N>>::Disturbance>;

/// A plant of N continuous states, each in SI units unless it says otherwise.
///
/// Functions of the platform's library (`f64::sin`) differ between machines in their last bits; those of the crate `libm` do
/// not.
pub trait Plant<const N: usize> {
    /// Command of the computer, such as voltages.
    type Command: Clone;
    /// Disturbance from outside, such as the torque of a load; `()` for none.
    type Disturbance: Clone;

    /// Returns the derivative of each state at a time in s, in the unit of the state per second.
    fn derivative(&self, time: f64, state: &State<N>, input: &InputOf<Self, N>) -> State<N>;

    /// Returns the number of events.
    fn events(&self) -> usize {
        0
    }

    /// Returns the zero-crossing function of an event; see [`System`](crate::System).
    fn crossing(&self, event: usize, time: f64, state: &State<N>, input: &InputOf<Self, N>) -> f64 {
        let _ = (event, time, state, input);
        1.0
    }

    /// Handles an event at its time, s. The handler may change the state and the plant.
    fn handle(&mut self, event: usize, time: f64, state: &mut State<N>) {
        let _ = (event, time, state);
    }

    /// Begins an interval at its start and of its length, both in s, with a constant input.
    ///
    /// Here the plant advances the parts that it solves itself: a motor that follows its command by an exponential
    /// function, a process of chance. The derivative takes them as constant over the interval.
    fn begin(&mut self, time: f64, length: f64, state: &State<N>, input: &InputOf<Self, N>) {
        let _ = (time, length, state, input);
    }

    /// Ends an interval at a time, s. Here the plant limits its states: a floor, a stop.
    fn end(&mut self, time: f64, state: &mut State<N>) {
        let _ = (time, state);
    }
}

/// A plant at one time, as sensors and probes see it.
pub struct View<'a, P: Plant<N>, const N: usize> {
    /// Time, s.
    pub time: f64,
    /// The plant.
    pub plant: &'a P,
    /// Its state.
    pub state: &'a State<N>,
    /// Its input.
    pub input: &'a InputOf<P, N>,
}
