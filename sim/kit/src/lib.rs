//! Closed loops of a controller and a plant: what a model is tested in before it becomes firmware.
//!
//! | module | purpose |
//! |---|---|
//! | [`system`], [`solver`] | differential equations with events, and their integrators: fixed steps or tolerances |
//! | [`plant`] | continuous states that a command and a disturbance drive |
//! | [`sensor`], [`noise`] | what is measured of them: rates, noise, bias, resolution, losses, all by seed |
//! | [`packet`] | sensors of several numbers that are late and lost together, for a loop of your own |
//! | [`computer`] | the controller under test: a closure, a model, or whatever implements the trait |
//! | [`scenario`] | goals, disturbances, faults and events of your own by time |
//! | [`clock`], [`run`] | periods as whole ticks, and the one order of simultaneous things |
//! | [`stepper`] | a plant tick by tick, for a loop of your own |
//! | [`recording`] | named channels with units, as CSV, MCAP or Parquet, and as a picture |
//! | `plot` | pictures of any points; with the feature `plots` |
//! | `log` | MCAP files of any topics; with the feature `mcap` |
//!
//! A motor whose speed a PI controller holds, while a load comes and goes:
//!
//! ```
//! use bessemer_sim::*;
//!
//! /// A motor with inertia 0.01 kg·m². Its state is the speed, rad/s; its command is a torque, N·m.
//! struct Motor;
//!
//! impl Plant<1> for Motor {
//!     type Command = f64;
//!     /// Torque of the load, N·m.
//!     type Disturbance = f64;
//!
//!     fn derivative(&self, _: f64, _: &State<1>, input: &Input<f64, f64>) -> State<1> {
//!         State::from([(input.command - input.disturbance) / 0.01])
//!     }
//! }
//!
//! let tick = Tick::nanoseconds(1_000_000)?;
//! let setup = Setup {
//!     plant: Motor,
//!     start: State::from([0.0]),
//!     command: 0.0,
//!     sensors: [Channel {
//!         signal: Signal::new("speed", "rad/s", |view: &View<Motor, 1>| view.state[0]),
//!         period: Period::TICK,
//!         quality: Quality { noise: 0.05, resolution: 0.1, dropout: 0.01, ..Quality::default() },
//!     }],
//!     probes: vec![Signal::new("torque", "N·m", |view: &View<Motor, 1>| view.input.command)],
//!     tick,
//!     control: Period::ticks(2)?,
//!     record: Period::ticks(10)?,
//!     solver: Solver::RungeKutta { step: 1e-3 },
//! };
//! let scenario = Scenario {
//!     duration: 2.0,
//!     goals: Timeline::constant(50.0),
//!     disturbances: Timeline::new(0.0, vec![(1.0, 0.5), (1.5, 0.0)])?,
//!     faults: Vec::new(),
//!     seed: 1,
//! };
//! let mut integral = 0.0;
//! let mut controller = |readings: &[Reading; 1], target: &f64| {
//!     let error = target - readings[0].value;
//!     integral += 0.002 * error;
//!     0.2 * error + 1.0 * integral
//! };
//! let outcome = setup.run(&scenario, &mut controller)?;
//! let speeds = outcome.recording.channel("speed")?.between(1.9, 2.0);
//! assert!(speeds.iter().all(|speed| (speed - 50.0).abs() < 1.5));
//! # Ok::<(), Error>(())
//! ```
//!
//! The outcome has the same bits in each run and on each machine, if those of the plant and of the computer have.

#![deny(missing_docs)]

pub mod clock;
pub mod computer;
mod dense;
pub mod error;
#[cfg(feature = "mcap")]
pub mod log;
pub mod noise;
pub mod packet;
#[cfg(feature = "parquet")]
mod parquet;
pub mod plant;
#[cfg(feature = "plots")]
pub mod plot;
pub mod recording;
pub mod run;
pub mod scenario;
pub mod sensor;
pub mod solver;
pub mod stepper;
mod steps;
pub mod system;

pub use clock::{Period, Tick};
pub use computer::{Computer, Failure};
pub use error::Error;
pub use noise::{Chance, Stream};
pub use packet::{Delivery, Instrument, Numbers, PacketSensor};
pub use plant::{Input, InputOf, Plant, View};
pub use recording::{Recorded, Recording};
pub use run::{Outcome, Setup};
pub use scenario::{Events, Fault, FaultKind, Pending, Scenario, Timeline};
pub use sensor::{Channel, Quality, Reading, Sensor, Signal};
pub use solver::{Integrator, Occurrence, Solver, Tolerances};
pub use stepper::Stepper;
pub use steps::runge_kutta;
pub use system::{State, System};
