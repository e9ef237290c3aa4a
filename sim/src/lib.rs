//! The plant and the flights: desktop Rust, never emitted.
//!
//! | module | what it says |
//! |---|---|
//! | [`vehicle`] | a multicopter with any number of motors: forces and torques |
//! | [`aircraft`] | the aircraft of the testbed, with settings, motors and battery of each |
//! | [`plant`] | its motion: twelve states, a floor |
//! | [`motors`], [`battery`] | motors that lag, and what they draw |
//! | [`air`], [`sensors`], [`noise`] | wind, sensors as they are, chance from a seed |
//! | [`world`] | all of these together as a plant of `bessemer_sim`, one control period at a time |
//! | [`ground_station`] | the other end of the link |
//! | [`computer`] | whatever can run the onboard software: the models here, their emitted C in `sim/program` |
//! | [`scenario`], [`voyage`] | a flight before it is flown, and as it was flown |
//! | [`flights`], [`measure`], [`checks`] | every flight, and by which figures it is judged |
//! | [`channels`], [`recording`], [`figures`], [`summary`] | flights as files, pictures, tables |
//! | [`campaign`] | very many flights |
//! | [`identify`] | which thrust coefficients a logged flight speaks for |
//!
//! The closed loop alone, with a perfect estimator, has a smaller world of its own:
//!
//! | module | what it says |
//! |---|---|
//! | [`pilot`] | whatever can fly it: the model, its emitted C, the interpreter of its IR |
//! | [`mission`] | what is asked of the pilot, when, and what air the aircraft meets |
//! | [`flight`] | a pilot flying a mission, recorded step by step |
//! | [`report`], [`verdict`] | how it went |
//!
//! The plant shares no code with the model that flies it, save its data: a fault in one must not
//! hide in the other.

pub mod air;
pub mod aircraft;
pub mod batch;
pub mod battery;
pub mod campaign;
pub mod channels;
pub mod checks;
pub mod computer;
mod course;
pub mod figures;
pub mod flight;
pub mod flights;
pub mod ground_station;
pub mod identify;
pub mod measure;
pub mod mission;
pub mod motors;
pub mod noise;
pub mod pilot;
pub mod plant;
pub mod recording;
pub mod report;
pub mod scenario;
pub mod sensors;
pub mod summary;
pub mod vehicle;
pub mod verdict;
pub mod voyage;
pub mod world;

pub use aircraft::Aircraft;
pub use flight::{Flight, Step, fly};
pub use mission::{Action, Gust, Manoeuvre, Mission};
pub use pilot::{Native, Pilot};
pub use plant::State;
pub use vehicle::Vehicle;
pub use verdict::{Fault, Tolerance};
