//! Variants may have explicit numbers, as in a protocol: these are
//! the values in the C, the results of `as`, and the order of `<`.

use bessemer::prelude::*;

/// Contents of a frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Kind {
    /// The sender is alive.
    #[default]
    Heartbeat = 1,
    /// Position.
    Position = 33,
    /// Attitude; its number is one more than the previous.
    Attitude,
    /// A command, with a constant as its number.
    Command = FIRST_COMMAND,
    /// Empty frame.
    Nothing = 0,
}

/// The lowest number of a command.
pub const FIRST_COMMAND: u8 = 0x80;

/// An enum with a negative number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd)]
pub enum Turn {
    /// To the left.
    Left = -1,
    /// No turn.
    #[default]
    Straight,
    /// To the right.
    Right,
}

/// A frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    /// Contents.
    pub kind: Kind,
    /// Kind of the expected answer, if any.
    pub answer: Option<Kind>,
    /// The next turns.
    pub turns: [Turn; 2],
}

/// The number of a kind, as in the protocol.
#[function]
pub fn byte_of(kind: Kind) -> u8 {
    kind as u8
}

/// The kind with a number.
#[function]
pub fn kind_of(byte: u8) -> Option<Kind> {
    match byte {
        1 => Some(Kind::Heartbeat),
        33 => Some(Kind::Position),
        34 => Some(Kind::Attitude),
        FIRST_COMMAND => Some(Kind::Command),
        _ => None,
    }
}

/// Length of the payload.
#[function]
pub fn length(kind: Kind) -> u32 {
    match kind {
        Kind::Heartbeat | Kind::Nothing => 0,
        Kind::Position | Kind::Attitude => 12,
        Kind::Command => 1,
    }
}

/// Returns true if the first kind is sent before the second.
#[function]
pub fn before(first: Kind, second: Kind) -> bool {
    first < second
}

/// The numbers of a kind and a turn in other types.
#[function]
pub fn numbers(kind: Kind, turn: Turn) -> (i8, i64, u16, usize) {
    (kind as i8, turn as i64, turn as u16, kind as usize)
}

/// The sum of the turns of a frame, plus one if it expects an answer.
#[function]
pub fn sum(frame: Frame) -> i32 {
    let mut sum = if frame.answer.is_some() { 1 } else { 0 };
    for turn in frame.turns {
        sum += turn as i32;
    }
    sum
}

/// A frame that expects no answer.
#[function]
pub fn silent(kind: Kind, right: bool) -> Frame {
    let turn = if right { Turn::Right } else { Turn::Left };
    Frame { kind, answer: None, turns: [turn, Turn::default()] }
}

/// Number of occurrences of each kind.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics {
    last: Kind,
    counts: [u32; 129],
}

impl Default for Statistics {
    fn default() -> Statistics {
        Statistics { last: Kind::Nothing, counts: [0; 129] }
    }
}

#[component]
impl Statistics {
    /// Counts a kind; its number is at most 128, so no check is needed.
    #[entry]
    pub fn count(&mut self, kind: Kind) -> u32 {
        self.last = kind;
        self.counts[kind as usize] = self.counts[kind as usize].wrapping_add(1);
        self.counts[kind as usize]
    }
}
