//! A closed loop in time: what acts at a tick, in which order, and what is recorded.
//!
//! Invariant: the outcome depends on the setup, the scenario and the computer alone. Nothing is random but by seed, and
//! simultaneous things have one order.

use std::collections::BTreeSet;

use crate::clock::{Period, Tick};
use crate::computer::Computer;
use crate::error::{Error, positive};
use crate::plant::{Input, Plant};
use crate::recording::Recording;
use crate::scenario::{Fault, Scenario};
use crate::sensor::{Channel, Reading, Sampler, Signal};
use crate::solver::{Integrator, Occurrence, Solver};
use crate::stepper::Stepper;
use crate::system::State;

/// A closed loop of a plant P with N states and S sensors, before it runs.
pub struct Setup<P: Plant<N>, const N: usize, const S: usize> {
    /// The plant.
    pub plant: P,
    /// Its first state.
    pub start: State<N>,
    /// Command before the first step of the computer.
    pub command: P::Command,
    /// Sensors, whose readings the computer gets in this order. Each is recorded.
    pub sensors: [Channel<P, N>; S],
    /// Numbers of the plant that are recorded and that nobody measures.
    pub probes: Vec<Signal<P, N>>,
    /// Base tick, of which all periods are multiples.
    pub tick: Tick,
    /// Period of the computer.
    pub control: Period,
    /// Period of the probes.
    pub record: Period,
    /// Method that integrates the plant.
    pub solver: Solver,
}

/// A run.
#[derive(Debug)]
pub struct Outcome<P, const N: usize> {
    /// All sensors, then all probes.
    pub recording: Recording,
    /// Events of the plant, in order of time.
    pub events: Vec<Occurrence>,
    /// The plant as its events left it.
    pub plant: P,
    /// Last state.
    pub state: State<N>,
}

impl<P: Plant<N>, const N: usize, const S: usize> Setup<P, N, S> {
    /// Runs the loop from 0 to the scenario's duration, both included.
    ///
    /// At a tick the following happens, in this order, as far as it is due:
    ///
    /// 1. Goals, disturbances and faults change, at the first tick that is not before their time.
    /// 2. The sensors sample, in their order. They see the command that was in effect up to now. Then the readings whose
    ///    delay is over arrive; a recording has them at that time.
    /// 3. The computer takes a step; its command is in effect from now on.
    /// 4. The probes are recorded, in their order, with the new command.
    /// 5. The plant advances, with a constant input, to the next tick at which one of these is due.
    ///
    /// # Errors
    ///
    /// A field is out of its range, a name occurs twice, the plant cannot be integrated, or the computer fails.
    pub fn run<G>(
        self,
        scenario: &Scenario<G, P::Disturbance>,
        computer: &mut impl Computer<S, G, P::Command>,
    ) -> Result<Outcome<P, N>, Error> {
        let tick = self.tick;
        let mut recording = self.recording()?;
        let mut samplers = Vec::with_capacity(S);
        for channel in &self.sensors {
            samplers.push(Sampler::new(channel, scenario.seed, tick)?);
        }
        let end = tick.not_before("duration", positive("duration", scenario.duration)?)?;
        let changes = self.changes(scenario)?;
        let mut readings = [Reading::default(); S];
        let mut events = Vec::new();
        let disturbance = scenario.disturbances.at(0.0).clone();
        let input = Input { command: self.command, disturbance };
        let integrator = Integrator::new(self.solver)?;
        let mut stepper = Stepper::new(self.plant, self.start, input, tick, integrator);
        loop {
            let (now, time) = (stepper.now(), stepper.time());
            stepper.input.disturbance = scenario.disturbances.at(time).clone();
            let due = self.sensors.iter().zip(&mut samplers).zip(&mut readings).enumerate();
            for (index, ((channel, sampler), reading)) in due {
                let signal = &channel.signal;
                if channel.period.is_due(now) {
                    let truth = signal.sensor.measure(&stepper.view());
                    let fault = Fault::at(&scenario.faults, &signal.name, time);
                    sampler.sample(&channel.quality, now, truth, fault);
                }
                while let Some((arrival, value)) = sampler.arrived(now) {
                    *reading = Reading { value, is_fresh: true };
                    recording.push(index, tick.log_time(arrival), value);
                }
            }
            if self.control.is_due(now) {
                let goal = scenario.goals.at(time);
                let answer = computer.step(&readings, goal);
                stepper.input.command =
                    answer.map_err(|source| Error::Computer { time, source })?;
                readings.iter_mut().for_each(|reading| reading.is_fresh = false);
            }
            if self.record.is_due(now) {
                for (index, probe) in self.probes.iter().enumerate() {
                    let value = probe.sensor.measure(&stepper.view());
                    recording.push(S + index, tick.log_time(now), value);
                }
            }
            if now >= end {
                let Stepper { plant, state, .. } = stepper;
                return Ok(Outcome { recording, events, plant, state });
            }
            let periods = self.sensors.iter().map(|channel| channel.period);
            let periods = periods.chain([self.control, self.record]);
            let due = periods.map(|period| period.next(now)).min().unwrap_or(end);
            let change = changes.range(now + 1..).next().copied().unwrap_or(end);
            events.extend(stepper.advance(due.min(change).min(end) - now)?);
        }
    }

    /// Returns an empty recording of the sensors and the probes.
    fn recording(&self) -> Result<Recording, Error> {
        let sensors = self.sensors.iter().map(|channel| &channel.signal);
        let mut recording = Recording::default();
        for signal in sensors.chain(&self.probes) {
            recording.add(&signal.name, &signal.unit)?;
        }
        Ok(recording)
    }

    /// Returns the ticks at which the scenario changes something.
    fn changes<G>(&self, scenario: &Scenario<G, P::Disturbance>) -> Result<BTreeSet<u64>, Error> {
        let mut times: Vec<f64> =
            scenario.goals.times().chain(scenario.disturbances.times()).collect();
        for fault in &scenario.faults {
            fault.check()?;
            let name = |channel: &Channel<P, N>| channel.signal.name.clone();
            let known: Vec<String> = self.sensors.iter().map(name).collect();
            if !known.contains(&fault.sensor) {
                let name = fault.sensor.clone();
                return Err(Error::Unknown { name, known: known.join(", ") });
            }
            times.extend([fault.from, fault.until].into_iter().filter(|time| time.is_finite()));
        }
        times.into_iter().map(|time| self.tick.not_before("time", time)).collect()
    }
}
