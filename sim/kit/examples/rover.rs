//! A rover on a rail, in a loop of its own: orders of an operator, a failure, and a receiver of late and lost packets.
//!
//! `cargo run --example rover` prints where the rover comes to, and writes `rover.csv`.

use std::error::Error;
use std::fs;

use bessemer_sim::{
    Delivery, Events, Fault, FaultKind, Input, Instrument, Integrator, Numbers, PacketSensor,
    Period, Plant, Reading, Recording, State, Stepper, Stream, Tick, View,
};

/// Control period, and tick, ns.
const PERIOD: u64 = 10_000_000;
/// Duration, ticks: 40 s.
const TICKS: u64 = 4_000;
/// Number of periods without a packet after which the drive rests.
const PATIENCE: u32 = 100;

/// A rover with friction. Its states are the position, m, and the speed, m/s; its command is an acceleration, m/s².
pub struct Rover {
    /// True until the drive fails.
    pub has_drive: bool,
}

impl Plant<2> for Rover {
    type Command = f64;
    type Disturbance = ();

    fn derivative(&self, _: f64, state: &State<2>, input: &Input<f64, ()>) -> State<2> {
        let drive = if self.has_drive { input.command } else { 0.0 };
        State::from([state[1], drive - state[1]])
    }
}

/// Receiver of a beacon: position, m, and speed, m/s.
struct Receiver {
    /// Bias of the position, constant over a run, m.
    bias: f64,
}

impl Instrument<Rover, 2, 2> for Receiver {
    fn measure(&mut self, view: &View<'_, Rover, 2>) -> Numbers<2> {
        *view.state
    }

    fn packet(&mut self, truth: Numbers<2>, chance: &mut Stream) -> Option<Numbers<2>> {
        let noise = chance.normals::<2>().component_mul(&Numbers::from([0.01, 0.02]));
        Some(truth + noise + Numbers::from([self.bias, 0.0]))
    }
}

/// An event of a run.
pub enum Event {
    /// The operator wants the rover at a position, m.
    Go(f64),
    /// The drive fails.
    Break,
}

/// The software under test: it drives to a position, and rests where it has heard nothing for too long.
#[derive(Default)]
struct Pilot {
    /// Wanted position, m.
    goal: f64,
    /// Number of periods since the last packet.
    silence: u32,
}

impl Pilot {
    fn step(&mut self, reading: &Reading<Numbers<2>>) -> f64 {
        self.silence = if reading.is_fresh { 0 } else { self.silence.saturating_add(1) };
        let [position, speed] = reading.value.into();
        let is_heard = self.silence < PATIENCE;
        let wanted = if is_heard { 0.5 * (self.goal - position) - 0.5 * speed } else { 0.0 };
        wanted.clamp(-1.0, 1.0)
    }
}

/// Runs the rover for 40 s; records the true position, and the positions that arrived.
pub fn run(seed: u64) -> Result<Recording, bessemer_sim::Error> {
    let events: Events<Event> = [
        (1.0, Event::Go(2.0)),
        (15.0, Event::Go(5.0)),
        (30.0, Event::Break),
        (31.0, Event::Go(0.0)),
    ]
    .into_iter()
    .collect();
    let away = Fault { sensor: "beacon".into(), from: 16.0, until: 24.0, kind: FaultKind::Silent };
    let faults = [away];

    let mut chance = Stream::named(seed, "beacon");
    let receiver = Receiver { bias: 0.02 * chance.normal() };
    let delivery = Delivery { period: Period::ticks(20)?, age: 10, dropout: 0.1 };
    let mut beacon = PacketSensor::new(["beacon"; 2], receiver, delivery, chance);

    let mut recording = Recording::default();
    let position = recording.add("position", "m")?;
    let received = recording.add("received", "m")?;

    let input = Input { command: 0.0, disturbance: () };
    let tick = Tick::nanoseconds(PERIOD)?;
    let plant = Rover { has_drive: true };
    let mut rover = Stepper::new(plant, State::zeros(), input, tick, Integrator::default());
    let mut pilot = Pilot::default();
    let mut pending = events.pending();
    for now in 0..TICKS {
        let time = rover.time();
        for (_, event) in pending.due(time) {
            match event {
                Event::Go(goal) => pilot.goal = *goal,
                Event::Break => rover.plant.has_drive = false,
            }
        }
        let fault = |sensor: &str| Fault::at(&faults, sensor, time);
        let reading = beacon.read(now, &rover.view(), fault);
        rover.input.command = pilot.step(&reading);

        recording.sample(position, tick.log_time(now), rover.state[0])?;
        if reading.is_fresh {
            recording.sample(received, tick.log_time(now), reading.value[0])?;
        }
        rover.advance(1)?;
    }
    Ok(recording)
}

fn main() -> Result<(), Box<dyn Error>> {
    let recording = run(1)?;
    let position = recording.channel("position")?;
    for time in [14.0, 23.0, 29.0, 39.0] {
        let there = position.between(time, time).first().copied().unwrap_or_default();
        println!("at {time} s the rover is at {there:.2} m");
    }
    fs::write("rover.csv", recording.csv())?;
    Ok(())
}
