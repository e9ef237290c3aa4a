//! Eight flights at once, in vectors, for campaigns: each with the bits of [`voyage::follow`].
//!
//! The flight software is the models' in vectors (`models-lanes`), the world is [`world`], and each aircraft has its own
//! sensors, air and ground station. The software's own link to the ground is not read: a campaign judges the flight, not its
//! records.

mod inputs;
mod world;

use bessemer_lanes::{LANES, Lanes, Mask, Real};
use bessemer_words::{value, words};
use models::{Alarm, Phase};
use nalgebra::Vector3;

use crate::air::Wind;
use crate::computer::Native;
use crate::course::Course;
use crate::plant::State;
use crate::plant::rotation_of;
use crate::scenario::{LEAD, Scenario};
use crate::sensors::{Seen, Sensors};
use crate::vehicle::Vehicle;
use crate::voyage::{self, Moment};
use inputs::Received;
use world::World;

/// The parts of a moment that a campaign judges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glimpse {
    /// Start of the period, relative to take-off, s.
    pub time: f64,
    /// True state of the aircraft.
    pub state: State,
    /// Speed at which the aircraft hit the ground in the period, m/s; 0 if it did not.
    pub impact: f64,
    /// Alarm of the software.
    pub alarm: Alarm,
    /// Phase of the flight.
    pub phase: Phase,
    /// Wanted position, m.
    pub wanted: Vector3<f64>,
    /// Largest command of the motors.
    pub motors: f64,
}

impl From<&Moment> for Glimpse {
    fn from(moment: &Moment) -> Self {
        let outputs = &moment.outputs;
        Self {
            time: moment.time,
            state: moment.state,
            impact: moment.impact,
            alarm: outputs.alarm,
            phase: outputs.reference.phase,
            wanted: outputs.reference.target.position,
            motors: outputs.command.motors.amax(),
        }
    }
}

/// Flies scenarios. Calls `seen` with the index of a flight and each of its periods in order, until it returns false.
pub fn fly(scenarios: &[Scenario], mut seen: impl FnMut(usize, &Glimpse) -> bool) {
    for (group, scenarios) in scenarios.chunks(LANES).enumerate() {
        let mut seen = |lane: usize, glimpse: &Glimpse| seen(group * LANES + lane, glimpse);
        match Group::of(scenarios) {
            Some(group) => group.fly(&mut seen),
            None => {
                for (lane, scenario) in scenarios.iter().enumerate() {
                    voyage::follow(scenario, &mut Native::default(), |moment, _| {
                        seen(lane, &moment.into())
                    });
                }
            }
        }
    }
}

/// Parts that an aircraft has for itself.
struct Single<'s> {
    /// Number of periods.
    count: usize,
    course: Course<'s>,
    sensors: Sensors,
    wind: Wind,
}

/// Flights of equal control periods and numbers of motors, at most as many as there are lanes.
struct Group<'s> {
    flights: Vec<Single<'s>>,
    period: f64,
    world: World,
    onboard: models_lanes::Onboard,
    settings: models_lanes::Settings,
    inputs: models_lanes::Inputs,
}

impl<'s> Group<'s> {
    /// Creates a group before the first period; none if the flights differ in form, or there is just one.
    fn of(scenarios: &'s [Scenario]) -> Option<Self> {
        let [first, others @ ..] = scenarios else { return None };
        let period = first.settings.parameters.period;
        let motors = first.airframe.motors;
        let is_alike =
            |it: &Scenario| it.settings.parameters.period == period && it.airframe.motors == motors;
        if others.is_empty() || !others.iter().all(is_alike) {
            return None;
        }
        let single = |scenario: &'s Scenario| Single {
            count: ((scenario.duration + LEAD) / period).round() as usize,
            course: Course::new(scenario),
            sensors: Sensors::new(&scenario.senses, period, scenario.seed),
            wind: Wind::new(scenario.air, scenario.seed),
        };
        let mut settings = models_lanes::Settings::zero();
        let vehicles: Vec<Vehicle> =
            scenarios.iter().map(|it| Vehicle::new(&it.airframe)).collect();
        for (lane, scenario) in scenarios.iter().enumerate() {
            settings.put(lane, &mut words(&scenario.settings).into_iter());
        }
        Some(Self {
            flights: scenarios.iter().map(single).collect(),
            period,
            world: World::new(scenarios, &vehicles, period),
            onboard: models_lanes::Onboard::of_words(&words(&models::Onboard::default())),
            settings,
            inputs: models_lanes::Inputs::of_words(&words(&models::Inputs::default())),
        })
    }

    fn fly(mut self, seen: &mut impl FnMut(usize, &Glimpse) -> bool) {
        let longest = self.flights.iter().map(|it| it.count).max().unwrap_or_default();
        let mut active: [bool; LANES] = std::array::from_fn(|lane| lane < self.flights.len());
        for n in 0..longest {
            for (active, flight) in active.iter_mut().zip(&self.flights) {
                *active = *active && n < flight.count;
            }
            if !active.contains(&true) {
                break;
            }
            let time = n as f64 * self.period - LEAD;
            let states = self.world.states();
            self.receive(n, time, &active, &states);
            let mask = Mask::new(active);
            let outputs =
                models_lanes::onboard_step(mask, &mut self.onboard, &self.settings, &self.inputs);
            let impacts = self.advance(&active, &outputs.command.speeds).to_array();
            let alarms = outputs.alarm.to_array();
            let phases = outputs.reference.phase.to_array();
            let wanted = outputs.reference.target.position.map(Real::to_array);
            let motors = outputs.command.motors.map(Real::to_array);
            for lane in 0..self.flights.len() {
                if !active[lane] {
                    continue;
                }
                let largest = |most: f64, motor: &[f64; LANES]| most.max(motor[lane].abs());
                let glimpse = Glimpse {
                    time,
                    state: states[lane],
                    impact: impacts[lane],
                    alarm: value(&[alarms[lane] as u64]),
                    phase: value(&[phases[lane] as u64]),
                    wanted: Vector3::from_fn(|axis, _| wanted[axis][lane]),
                    motors: motors.iter().fold(0.0, largest),
                };
                active[lane] = seen(lane, &glimpse);
            }
        }
    }

    /// Reads the sensors and the link of each aircraft in period `n`.
    fn receive(&mut self, n: usize, time: f64, active: &[bool; LANES], states: &[State; LANES]) {
        let mut received = Received::default();
        let angles = std::array::from_fn(|axis| {
            Real::new(std::array::from_fn(|lane| states[lane].angles[axis]))
        });
        let rotations = rotation_of(angles).map(|row| row.map(Real::to_array));
        for (lane, flight) in self.flights.iter_mut().enumerate().filter(|it| active[it.0]) {
            if flight.course.happen(time) {
                self.settings.put(lane, &mut words(&flight.course.settings).into_iter());
            }
            let rotation = rotations.map(|row| row.map(|it| it[lane]));
            let seen = Seen { state: states[lane], rotation };
            let course = &flight.course;
            let fault = |sensor: &str| course.fault(sensor, time);
            received.readings[lane] = flight.sensors.read(n as u64, &seen, fault);
            inputs::put_packet(&mut self.inputs.uplink, lane, &flight.course.ground.send());
        }
        received.clock = 1_000_000 + (n as u64) * (1e6 * self.period).round() as u64;
        received.put(&mut self.inputs);
    }

    /// Advances the world by a period with set points of the motors' speeds, rad/s. Returns the speeds of touch-downs.
    fn advance(&mut self, active: &[bool; LANES], speeds: &[Real; 8]) -> Real {
        let mut wind = [[0.0; LANES]; 3];
        let mut dead = [[false; LANES]; 8];
        for (lane, flight) in self.flights.iter_mut().enumerate().filter(|it| active[it.0]) {
            let force = flight.wind.blow(self.period);
            (0..3).for_each(|axis| wind[axis][lane] = force[axis]);
            if let Some(motor) = flight.course.dead
                && let Some(motor) = dead.get_mut(motor)
            {
                motor[lane] = true;
            }
        }
        let dead = dead.map(Mask::new);
        self.world.advance(speeds, &dead, wind.map(Real::new))
    }
}
