//! Integrators: fixed steps, or steps by tolerance, and events located between the ends of a step.
//!
//! An integrator knows a [`System`] only. Its bits depend on the system's bits alone: it calls no function of the
//! platform's mathematics library.

use crate::dense::Dense;
use crate::error::{Error, positive};
use crate::steps::Step;
use crate::system::{State, System};

/// Parts of a step at whose ends events are looked for.
const PARTS: u32 = 4;

/// Part of a step after which an event that is not armed is looked at: a body that bounces has left the floor by then.
const LIFT: f64 = 1e-6;

/// Halvings of a part of a step when an event is located: to 2⁻⁵⁰ of the step.
const HALVINGS: u32 = 48;

/// Largest number of events in one interval.
const MOST_EVENTS: usize = 10_000;

/// Largest number of adaptive steps in one interval, as in Hairer's `dopri5`.
const MOST_STEPS: usize = 100_000;

/// Limits of an adaptive step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Error of a step relative to the state's size.
    pub relative: f64,
    /// Error of a step beside a state of 0, in the unit of the state.
    pub absolute: f64,
    /// Longest step, s; infinity for none.
    pub longest_step: f64,
}

impl Default for Tolerances {
    /// 10⁻⁶ relative, 10⁻⁹ absolute, steps of any length.
    fn default() -> Self {
        Self { relative: 1e-6, absolute: 1e-9, longest_step: f64::INFINITY }
    }
}

/// Method of integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solver {
    /// Euler's method, of order 1, in equal steps.
    Euler {
        /// Longest step, s.
        step: f64,
    },
    /// The classical Runge–Kutta method, of order 4, in equal steps.
    RungeKutta {
        /// Longest step, s.
        step: f64,
    },
    /// The pair 5(4) of Dormand and Prince, in steps by tolerance.
    DormandPrince(Tolerances),
}

impl Solver {
    fn check(&self) -> Result<(), Error> {
        match self {
            Solver::Euler { step } | Solver::RungeKutta { step } => {
                positive("step", *step).map(drop)
            }
            Solver::DormandPrince(tolerances) => {
                positive("relative", tolerances.relative)?;
                positive("absolute", tolerances.absolute)?;
                if tolerances.longest_step != f64::INFINITY {
                    positive("longest_step", tolerances.longest_step)?;
                }
                Ok(())
            }
        }
    }
}

/// An event that occurred.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occurrence {
    /// Time, s.
    pub time: f64,
    /// Index of the event.
    pub event: usize,
}

/// Integrator of a system of N states: a method, and its memory between intervals.
///
/// The memory is the adaptive step, and which events are armed. An event is armed while its crossing is above 0.
///
/// ```
/// use bessemer_sim::{Integrator, Solver, State, Tolerances};
///
/// let decay = |_: f64, state: &State<1>| -state;
/// let mut integrator = Integrator::new(Solver::DormandPrince(Tolerances::default()))?;
/// let mut state = State::from([1.0]);
/// integrator.advance(&mut { decay }, 0.0, &mut state, 2.0)?;
/// assert!((state[0] - 0.135_335_283).abs() < 1e-6);
/// # Ok::<(), bessemer_sim::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Integrator<const N: usize> {
    solver: Solver,
    /// Next adaptive step, s.
    step: Option<f64>,
    armed: Vec<bool>,
}

/// One step of the classical Runge–Kutta method for each interval.
impl<const N: usize> Default for Integrator<N> {
    fn default() -> Self {
        Self::of(Solver::RungeKutta { step: f64::MAX })
    }
}

/// A step that was accepted, with its end in s.
type Accepted<const N: usize> = (f64, Step<N>);

/// Receives each part of the solution: start and end in s, the polynomial, and its θ at the end.
type Observer<'o, const N: usize> = &'o mut dyn FnMut([f64; 2], &Dense<N>, f64);

impl<const N: usize> Integrator<N> {
    /// Creates an integrator.
    ///
    /// # Errors
    ///
    /// A step or a tolerance is not above 0.
    pub fn new(solver: Solver) -> Result<Self, Error> {
        solver.check()?;
        Ok(Self::of(solver))
    }

    fn of(solver: Solver) -> Self {
        Self { solver, step: None, armed: Vec::new() }
    }

    /// Advances a state from `time` to `until`, both in s; returns the events in order of time.
    ///
    /// An event is located to 2⁻⁵⁰ of its step, on the step's polynomial, whose own error the tolerances bound. Events
    /// of one time are handled in order of index. A crossing that falls to 0 and rises again within a quarter of
    /// a step is not seen: bound the step where that can be.
    ///
    /// # Errors
    ///
    /// A derivative is not finite, tolerances cannot be met, events recur without an end, or `until` is before `time`.
    pub fn advance(
        &mut self,
        system: &mut impl System<N>,
        time: f64,
        state: &mut State<N>,
        until: f64,
    ) -> Result<Vec<Occurrence>, Error> {
        self.observed(system, time, state, until, None)
    }

    /// Advances as [`advance`](Integrator::advance) does to the last of some rising times, s. Returns the state at each.
    ///
    /// The states are those of the dense output, so the times do not shorten the steps. At the time of an event it is
    /// the state before the event.
    ///
    /// # Errors
    ///
    /// As of [`advance`](Integrator::advance); or a time is before its predecessor.
    pub fn trajectory(
        &mut self,
        system: &mut impl System<N>,
        time: f64,
        state: &mut State<N>,
        times: &[f64],
    ) -> Result<Vec<State<N>>, Error> {
        let mut before = time;
        for &at in times {
            if !(at >= before && at.is_finite()) {
                return Err(Error::Backwards { from: before, until: at });
            }
            before = at;
        }
        let first = *state;
        let mut states = Vec::with_capacity(times.len());
        let mut observe = |[from, until]: [f64; 2], dense: &Dense<N>, theta: f64| {
            while let Some(&at) = times.get(states.len()).filter(|at| **at <= until) {
                states.push(dense.at(theta * ((at - from) / (until - from)).max(0.0)));
            }
        };
        self.observed(system, time, state, before, Some(&mut observe))?;
        // No step was taken after the last state, or none at all.
        let last = if states.is_empty() { first } else { *state };
        states.resize(times.len(), last);
        Ok(states)
    }

    fn observed(
        &mut self,
        system: &mut impl System<N>,
        time: f64,
        state: &mut State<N>,
        until: f64,
        mut observer: Option<Observer<'_, N>>,
    ) -> Result<Vec<Occurrence>, Error> {
        if !(until >= time && time.is_finite() && until.is_finite()) {
            return Err(Error::Backwards { from: time, until });
        }
        self.armed.resize(system.events(), false);
        let mut occurred = Vec::new();
        let mut now = time;
        for count in 0_usize.. {
            if count > MOST_STEPS && matches!(self.solver, Solver::DormandPrince(_)) {
                return Err(Error::Stiff { time: now, count });
            }
            self.handle_jumps(system, now, state, &mut occurred)?;
            if until - now <= shortest(until) {
                break;
            }
            let (end, step) = self.accepted(system, now, state, until)?;
            if self.armed.is_empty() && observer.is_none() {
                (now, *state) = (end, step.end);
                continue;
            }
            let dense = step.dense(system, end);
            let crossing = self.first_crossing(system, [now, end], &dense);
            let theta = crossing.map_or(1.0, |(_, theta)| theta);
            let reached = if crossing.is_some() { now + theta * (end - now) } else { end };
            if let Some(observe) = &mut observer {
                observe([now, reached], &dense, theta);
            }
            now = reached;
            *state = if crossing.is_some() { dense.at(theta) } else { step.end };
            if let Some((event, _)) = crossing {
                self.occur(system, event, now, state, &mut occurred)?;
            }
        }
        Ok(occurred)
    }

    /// Handles armed events whose crossing has jumped to 0 or below: an input or a handler changed it.
    fn handle_jumps(
        &mut self,
        system: &mut impl System<N>,
        time: f64,
        state: &mut State<N>,
        occurred: &mut Vec<Occurrence>,
    ) -> Result<(), Error> {
        while let Some(event) = (0..self.armed.len())
            .find(|&event| self.armed[event] && system.crossing(event, time, state) <= 0.0)
        {
            self.occur(system, event, time, state, occurred)?;
        }
        for (event, armed) in self.armed.iter_mut().enumerate() {
            *armed = system.crossing(event, time, state) > 0.0;
        }
        Ok(())
    }

    fn occur(
        &mut self,
        system: &mut impl System<N>,
        event: usize,
        time: f64,
        state: &mut State<N>,
        occurred: &mut Vec<Occurrence>,
    ) -> Result<(), Error> {
        self.armed[event] = false;
        system.handle(event, time, state);
        occurred.push(Occurrence { time, event });
        let count = occurred.len();
        if count > MOST_EVENTS { Err(Error::Chatter { event, count, time }) } else { Ok(()) }
    }

    /// Returns the first event within a step and its θ, and arms events that rise above 0 before it.
    fn first_crossing(
        &mut self,
        system: &impl System<N>,
        [start, end]: [f64; 2],
        dense: &Dense<N>,
    ) -> Option<(usize, f64)> {
        let value = |event: usize, theta: f64| {
            system.crossing(event, start + theta * (end - start), &dense.at(theta))
        };
        for (event, armed) in self.armed.iter_mut().enumerate() {
            *armed = *armed || value(event, LIFT) > 0.0;
        }
        for part in 1..=PARTS {
            let [from, until] = [part - 1, part].map(|part| f64::from(part) / f64::from(PARTS));
            let mut first: Option<(usize, f64)> = None;
            let mut armed = self.armed.clone();
            for (event, armed) in armed.iter_mut().enumerate() {
                let last = value(event, until);
                if *armed && last <= 0.0 {
                    let theta = located(|theta| value(event, theta), from.max(LIFT), until);
                    if first.is_none_or(|(_, before)| theta < before) {
                        first = Some((event, theta));
                    }
                }
                *armed |= last > 0.0;
            }
            if first.is_some() {
                return first;
            }
            self.armed = armed;
        }
        None
    }

    /// Takes the next step from `now` towards `until`.
    fn accepted(
        &mut self,
        system: &impl System<N>,
        now: f64,
        state: &State<N>,
        until: f64,
    ) -> Result<Accepted<N>, Error> {
        let first = system.derivative(now, state);
        finite(now, state)?;
        finite(now, &first)?;
        let left = until - now;
        let equal = |step: f64| {
            // A quotient a rounding above a whole number is that number.
            let parts = (left / step * (1.0 - 1e-12)).ceil();
            if parts > 1.0 { (now + left / parts, left / parts) } else { (until, left) }
        };
        let (end, step) = match self.solver {
            Solver::Euler { step } => {
                let (end, length) = equal(step);
                (end, Step::euler(state, first, length))
            }
            Solver::RungeKutta { step } => {
                let (end, length) = equal(step);
                (end, Step::runge_kutta(system, now, state, first, length))
            }
            Solver::DormandPrince(tolerances) => {
                self.adaptive(&tolerances, system, now, state, first, until)?
            }
        };
        if end <= now {
            return Err(Error::Underflow { time: now, step: end - now });
        }
        finite(end, &step.end)?;
        Ok((end, step))
    }

    /// Takes a step of Dormand and Prince within tolerances. Its length follows Hairer, Nørsett and Wanner, section II.4.
    fn adaptive(
        &mut self,
        tolerances: &Tolerances,
        system: &impl System<N>,
        now: f64,
        state: &State<N>,
        first: State<N>,
        until: f64,
    ) -> Result<Accepted<N>, Error> {
        let left = until - now;
        let longest = tolerances.longest_step.min(left);
        let wanted = self
            .step
            .unwrap_or_else(|| first_step(tolerances, system, now, state, &first, longest));
        let mut length = wanted.min(longest);
        // A remainder of a thousandth is no step of its own.
        if length > 0.999 * left && left <= tolerances.longest_step {
            length = left;
        }
        let mut is_retry = false;
        loop {
            let step = Step::dormand_prince(system, now, state, first, length);
            let error = norm(tolerances, &step.error, state, &step.end);
            // The error is of order 5. NaN shrinks the step, too.
            let factor = if error.is_nan() { 0.1 } else { 0.9 * libm::pow(error, -0.2) };
            if error <= 1.0 {
                let growth = factor.clamp(0.2, if is_retry { 1.0 } else { 5.0 });
                // An interval that cut the step says nothing of the next one, unless the error grew.
                self.step = Some(if length < wanted && growth >= 1.0 && !is_retry {
                    wanted.max(length * growth)
                } else {
                    length * growth
                });
                let end = if length == left { until } else { now + length };
                return Ok((end, step));
            }
            length *= factor.clamp(0.1, 0.9);
            is_retry = true;
            if length <= shortest(now) {
                return Err(Error::Underflow { time: now, step: length });
            }
        }
    }
}

/// Returns the shortest step at a time, s: a few units in the last place.
fn shortest(time: f64) -> f64 {
    4.0 * f64::EPSILON * time.abs().max(f64::MIN_POSITIVE)
}

/// Returns the end, at which the crossing is 0 or below, of a bracket that bisection narrows.
fn located(crossing: impl Fn(f64) -> f64, mut above: f64, mut below: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (above + below);
        if crossing(middle) > 0.0 { above = middle } else { below = middle }
    }
    below
}

/// Returns the root mean square of the errors, each as a multiple of its tolerance.
fn norm<const N: usize>(
    tolerances: &Tolerances,
    error: &State<N>,
    start: &State<N>,
    end: &State<N>,
) -> f64 {
    let mut sum = 0.0;
    for index in 0..N {
        let size = start[index].abs().max(end[index].abs());
        let scaled = error[index] / (tolerances.absolute + tolerances.relative * size);
        sum += scaled * scaled;
    }
    (sum / N.max(1) as f64).sqrt()
}

/// Returns a first step, s (Hairer, Nørsett and Wanner, section II.4).
fn first_step<const N: usize>(
    tolerances: &Tolerances,
    system: &impl System<N>,
    time: f64,
    state: &State<N>,
    first: &State<N>,
    longest: f64,
) -> f64 {
    let size = norm(tolerances, state, state, state);
    let slope = norm(tolerances, first, state, state);
    let guess = if size < 1e-5 || slope < 1e-5 { 1e-6 } else { 0.01 * size / slope };
    let guess = guess.min(longest);
    let next = system.derivative(time + guess, &(state + first * guess));
    let curve = norm(tolerances, &(next - first), state, state) / guess;
    let most = slope.max(curve);
    let step = if most <= 1e-15 { (1e-3 * guess).max(1e-6) } else { libm::pow(0.01 / most, 0.2) };
    let step = step.min(100.0 * guess).min(longest);
    if step > 0.0 { step } else { guess }
}

fn finite<const N: usize>(time: f64, state: &State<N>) -> Result<(), Error> {
    match state.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(Error::NotFinite { index, time }),
        None => Ok(()),
    }
}
