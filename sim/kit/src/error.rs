//! Errors of a simulation: each names the item that it is about, and says what to write instead.
//!
//! No input of a user panics; it ends here. Errors know no plant and no computer.

use std::error;

/// Error of a simulation, a recording or an integrator.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A number is outside of its range.
    #[error("`{item}` is {value}; write a number that is {range}")]
    Range {
        /// The field or the argument.
        item: String,
        /// Its value.
        value: f64,
        /// The numbers that are allowed.
        range: &'static str,
    },
    /// A period has no ticks.
    #[error("a period has 0 ticks; write `Period::ticks(1)` or more")]
    Period,
    /// The tick has no length.
    #[error("the tick is 0 ns; write `Tick::nanoseconds(1)` or more")]
    Tick,
    /// The changes of a timeline are not in order.
    #[error(
        "the change at {time} s is not after the change before it; sort the changes by time, each time once"
    )]
    Unsorted {
        /// Time of the change, s.
        time: f64,
    },
    /// Two channels have one name.
    #[error("two channels have the name `{name}`; rename one")]
    Twice {
        /// The name.
        name: String,
    },
    /// A name or a unit cannot be in a recording.
    #[error(
        "`{text}` cannot name a channel or a unit; write it without commas, quotes, brackets, backslashes and control characters, and not empty"
    )]
    Name {
        /// The text.
        text: String,
    },
    /// A sample is not after its channel's last one.
    #[error(
        "the sample of `{name}` at {time} s is not after the one before it; record samples in order of time, each time once"
    )]
    Late {
        /// Name of the channel.
        name: String,
        /// Time of the sample, s.
        time: f64,
    },
    /// No channel has this name.
    #[error("no channel has the name `{name}`; the channels are {known}")]
    Unknown {
        /// The name.
        name: String,
        /// Names of all channels.
        known: String,
    },
    /// A derivative or a state is NaN or infinite.
    #[error(
        "state {index} or its derivative is not finite at {time} s; check the plant for a division by zero or an unstable step"
    )]
    NotFinite {
        /// Index of the state.
        index: usize,
        /// Time, s.
        time: f64,
    },
    /// A step is too short: no step meets the tolerances, or a fixed step does not change the time.
    #[error(
        "the step at {time} s fell to {step} s; lengthen a fixed step, loosen the tolerances, or make the derivative continuous and its jumps events"
    )]
    Underflow {
        /// Time, s.
        time: f64,
        /// Length of the refused step, s.
        step: f64,
    },
    /// The adaptive solver needs too many steps in one interval.
    #[error(
        "the solver took {count} steps in one interval up to {time} s; the plant is stiff: leave out its fastest states, or loosen the tolerances"
    )]
    Stiff {
        /// Time, s.
        time: f64,
        /// Number of steps.
        count: usize,
    },
    /// An event occurs again and again within one interval.
    #[error(
        "event {event} occurred {count} times up to {time} s without an end; let `handle` leave the state in which it recurs"
    )]
    Chatter {
        /// Index of the event.
        event: usize,
        /// Number of events in the interval.
        count: usize,
        /// Time, s.
        time: f64,
    },
    /// An interval ends before it begins.
    #[error(
        "the interval from {from} s to {until} s runs backwards; write its end after its start"
    )]
    Backwards {
        /// Start, s.
        from: f64,
        /// End, s.
        until: f64,
    },
    /// The computer under test failed.
    #[error("the computer failed at {time} s: {source}")]
    Computer {
        /// Time, s.
        time: f64,
        /// Error of the computer.
        source: Box<dyn error::Error + Send + Sync>,
    },
    /// A file or a picture could not be written.
    #[error("the recording could not be written: {0}")]
    Write(String),
}

/// Returns a number that is finite and above 0, or an error that names `item`.
pub(crate) fn positive(item: &str, value: f64) -> Result<f64, Error> {
    let range = "finite and above 0";
    checked(item, value, range, value.is_finite() && value > 0.0)
}

/// Returns a number that is finite and not below 0, or an error that names `item`.
pub(crate) fn not_negative(item: &str, value: f64) -> Result<f64, Error> {
    let range = "finite and 0 or more";
    checked(item, value, range, value.is_finite() && value >= 0.0)
}

/// Returns a number from 0 to 1, or an error that names `item`.
pub(crate) fn probability(item: &str, value: f64) -> Result<f64, Error> {
    checked(item, value, "from 0 to 1", (0.0..=1.0).contains(&value))
}

/// Returns a number that is in its range, or an error that names `item`.
pub(crate) fn checked(
    item: &str,
    value: f64,
    range: &'static str,
    is_fine: bool,
) -> Result<f64, Error> {
    if is_fine { Ok(value) } else { Err(Error::Range { item: item.to_owned(), value, range }) }
}
