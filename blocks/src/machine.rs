//! Sequence: finite state machine with entry and exit actions, and several rates in one step.

use bessemer::prelude::*;

/// Actions of a state machine with states `S`, an enum of the author's. Each action has a default that does nothing.
///
/// See [`Machine`].
#[interface]
pub trait Actions<S> {
    /// Returns the state of the next period. `periods` is the number of periods in `state` before this one.
    fn next(&mut self, state: S, periods: u32) -> S;

    /// Runs in each period in a state, after its entry.
    fn during(&mut self, _state: S) {}

    /// Runs once when a state is entered.
    fn enter(&mut self, _state: S) {}

    /// Runs once when a state is left.
    fn exit(&mut self, _state: S) {}
}

/// Finite state machine: the state, and the periods that it has lasted.
///
/// In each period `next` decides; if the state changes, the old one's `exit` and the new one's `enter` run; then
/// `during`. The first period enters the initial state, the `Default` of `S`. The count of periods saturates at 2³² − 1.
///
/// ```
/// use bessemer::prelude::*;
/// use bessemer_blocks::{Actions, Machine};
///
/// /// States of a pump.
/// #[data]
/// #[derive(Clone, Copy, Debug, Default, PartialEq)]
/// pub enum State {
///     #[default]
///     Off,
///     Priming,
///     On,
/// }
///
/// /// What the pump sees and does.
/// #[data]
/// #[derive(Clone, Copy, Debug, Default, PartialEq)]
/// pub struct Pump {
///     pub wanted: bool,
///     pub valve: bool,
///     pub starts: u32,
/// }
///
/// #[data]
/// impl Actions<State> for Pump {
///     fn next(&mut self, state: State, periods: u32) -> State {
///         match state {
///             _ if !self.wanted => State::Off,
///             State::Off => State::Priming,
///             State::Priming if periods >= 2 => State::On,
///             other => other,
///         }
///     }
///
///     fn enter(&mut self, state: State) {
///         self.valve = state != State::Off;
///         if state == State::On {
///             self.starts = self.starts.saturating_add(1);
///         }
///     }
/// }
///
/// let (mut machine, mut pump) = (Machine::<State>::default(), Pump { wanted: true, ..Pump::default() });
/// let states = [0; 4].map(|_| machine.step(&mut pump));
/// assert_eq!(states, [State::Priming, State::Priming, State::On, State::On]);
/// assert_eq!((pump.valve, pump.starts), (true, 1));
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Machine<S> {
    /// The state.
    state: S,
    /// Number of periods in the state.
    periods: u32,
    /// True after the first period.
    running: bool,
}

#[component]
impl<S: Copy + PartialEq> Machine<S> {
    /// Advances one period; returns the state.
    pub fn step<A: Actions<S>>(&mut self, actions: &mut A) -> S {
        if !self.running {
            self.running = true;
            actions.enter(self.state);
        }
        let next = actions.next(self.state, self.periods);
        if next != self.state {
            actions.exit(self.state);
            self.state = next;
            self.periods = 0;
            actions.enter(next);
        }
        actions.during(next);
        self.periods = self.periods.saturating_add(1);
        next
    }
}

/// A task of a [`Schedule`].
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Task {
    /// Number of steps between two runs; 0 means 1.
    pub period: u32,
    /// Number of steps before the first run, below the period.
    pub phase: u32,
    /// Longest duration, in units of the author's, such as µs or instructions.
    pub cost: u32,
}

/// Schedule of `N` tasks, each with its rate. Tasks that are due in a step run in the author's order.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule<const N: usize> {
    /// The tasks.
    pub tasks: [Task; N],
}

impl<const N: usize> Schedule<N> {
    /// Returns the largest sum of the costs of tasks that are due in one step, for an assertion at compile time.
    ///
    /// It tries each step of the hyperperiod, so this should be below a million.
    pub const fn heaviest(&self) -> u64 {
        let mut steps = 1;
        let mut k = 0;
        while k < N {
            steps = least_common_multiple(steps, self.period(k));
            k += 1;
        }
        let (mut step, mut heaviest) = (0, 0);
        while step < steps {
            let (mut sum, mut k) = (0, 0);
            while k < N {
                if step % self.period(k) == self.tasks[k].phase as u64 % self.period(k) {
                    sum += self.tasks[k].cost as u64;
                }
                k += 1;
            }
            if sum > heaviest {
                heaviest = sum;
            }
            step += 1;
        }
        heaviest
    }

    /// Returns true if data flows from tasks to later ones, for an assertion at compile time.
    ///
    /// Each pair is a task and another that reads its results. The first one must be before the other in the author's order,
    /// so that it runs before it in a step in which both are due, and its first run must not be later.
    pub const fn flows(&self, pairs: &[[usize; 2]]) -> bool {
        let mut k = 0;
        while k < pairs.len() {
            let [from, to] = pairs[k];
            if from >= to || to >= N || self.tasks[from].phase > self.tasks[to].phase {
                return false;
            }
            k += 1;
        }
        true
    }

    const fn period(&self, task: usize) -> u64 {
        if self.tasks[task].period == 0 { 1 } else { self.tasks[task].period as u64 }
    }
}

const fn least_common_multiple(a: u64, b: u64) -> u64 {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    a / x * b
}

/// Several rates in one step: which tasks of a [`Schedule`] are due.
///
/// Initialisation: `Default` begins each task at its phase. The rates never drift, since each task has a count of its own.
///
/// ```
/// use bessemer_blocks::{Rates, Schedule, Task};
///
/// const SCHEDULE: Schedule<2> = Schedule { tasks: [
///     Task { period: 1, phase: 0, cost: 40 },
///     Task { period: 3, phase: 1, cost: 50 },
/// ] };
/// const _: () = assert!(SCHEDULE.heaviest() <= 100 && SCHEDULE.flows(&[[0, 1]]));
///
/// let mut rates = Rates::<2>::default();
/// let slow = [0; 6].map(|_| rates.step(&SCHEDULE)[1]);
/// assert_eq!(slow, [false, true, false, false, true, false]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates<const N: usize> {
    /// Steps before the next run of each task.
    waits: [u32; N],
    /// True after the first step.
    running: bool,
}

impl<const N: usize> Default for Rates<N> {
    fn default() -> Self {
        Rates { waits: [0; N], running: false }
    }
}

#[component]
impl<const N: usize> Rates<N> {
    /// Advances one step; returns true for each task that is due.
    #[entry(infallible)]
    pub fn step(&mut self, schedule: &Schedule<N>) -> [bool; N] {
        let mut due = [false; N];
        for ((due, wait), task) in due.iter_mut().zip(&mut self.waits).zip(&schedule.tasks) {
            if !self.running {
                *wait = task.phase;
            }
            *due = *wait == 0;
            *wait = if *due { task.period.saturating_sub(1) } else { wait.saturating_sub(1) };
        }
        self.running = true;
        due
    }
}
