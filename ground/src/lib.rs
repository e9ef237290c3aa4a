//! The ground station and the testbed around it: desktop Rust, never emitted.
//!
//! | module | what it says |
//! |---|---|
//! | [`program`] | the emitted C around its sockets: compiled, started, killed |
//! | [`relay`] | the same on a board, at the other end of a serial line |
//! | [`bench`] | the aircraft in real or virtual time, with that program as its computer |
//! | [`mocap`] | a real motion-capture system in place of the simulated one, and the simulated aircraft as one |
//! | [`radio`] | a link that loses, doubles, delays and reorders |
//! | [`key`] | the seal of those who may command |
//! | [`station`] | the other end of the link: orders up, news down |
//! | [`catalogue`] | what signals and parameters are called |
//! | [`testbed`] | all of these, one control period at a time |
//! | [`recorder`], [`replay`] | a flight as a file, and the C run again from it |
//! | [`live`], [`player`] | the testbed, or a recording, with the server at its side |
//! | [`seeds`] | flights of a campaign's seeds, opened by the links of its summary page |
//! | [`command`] | who commands |
//! | [`refusal`] | reasons to refuse a request before it goes to the aircraft |
//! | [`events`] | changes of a flight, in an operator's words |
//! | [`messages`], [`server`], [`limited`], [`page`] | what the browser is reported and may ask |
//! | [`tools`] | the same for Foxglove, and over MAVLink |
//!
//! The aircraft depends on none of what listens: the testbed never waits for the server, nor for a disk.

pub mod bench;
pub mod catalogue;
pub mod command;
pub mod ending;
pub mod events;
pub mod key;
pub mod limited;
pub mod live;
pub mod messages;
pub mod mocap;
pub mod page;
pub mod player;
pub mod priority;
pub mod program;
pub mod radio;
pub mod recorded;
pub mod recorder;
pub mod refusal;
pub mod relay;
pub mod replay;
pub mod seeds;
pub mod server;
pub mod station;
pub mod testbed;
pub mod tools;
pub mod wait;
