//! A system of ordinary differential equations with events: all that an integrator knows.

use nalgebra::SVector;

/// State of a system: N numbers, each in its own unit.
pub type State<const N: usize> = SVector<f64, N>;

/// An ordinary differential equation y' = f(t, y) of N states, with events.
///
/// A closure `Fn(f64, &State<N>) -> State<N>` is a system without events.
///
/// An event occurs where its [`crossing`](System::crossing) falls from above 0 to 0 or below. It occurs again once the
/// crossing has been above 0 in between.
pub trait System<const N: usize> {
    /// Returns the derivative of each state at a time in s, in the unit of the state per second.
    fn derivative(&self, time: f64, state: &State<N>) -> State<N>;

    /// Returns the number of events.
    fn events(&self) -> usize {
        0
    }

    /// Returns the zero-crossing function of an event, continuous in time and state.
    fn crossing(&self, event: usize, time: f64, state: &State<N>) -> f64 {
        let _ = (event, time, state);
        1.0
    }

    /// Handles an event at its time, s. The handler may change the state and the system.
    fn handle(&mut self, event: usize, time: f64, state: &mut State<N>) {
        let _ = (event, time, state);
    }
}

impl<const N: usize, F: Fn(f64, &State<N>) -> State<N>> System<N> for F {
    fn derivative(&self, time: f64, state: &State<N>) -> State<N> {
        self(time, state)
    }
}
