//! A receiver of UBX frames: sync, class, length, payload, checksum; byte by byte.

use bessemer::prelude::*;

/// State of the receiver within a frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Stage {
    #[default]
    Idle,
    Synced,
    Class,
    Id {
        class: u8,
    },
    Length {
        class: u8,
        id: u8,
        low: Option<u8>,
    },
    Payload {
        class: u8,
        id: u8,
        left: u16,
    },
    Check {
        class: u8,
        id: u8,
        first: Option<u8>,
    },
}

/// A complete frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    pub class: u8,
    pub id: u8,
    pub payload: List<u8, 16>,
}

/// Reason why a frame was rejected.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wrong {
    TooLong(u16),
    Checksum { expected: u16, came: u16 },
}

/// Receiver of frames.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Receiver {
    stage: Stage,
    payload: List<u8, 16>,
    sums: (u8, u8),
    lost: u32,
}

#[component]
impl Receiver {
    /// Takes a byte; returns the frame that it completes, if any.
    #[entry(infallible)]
    pub fn take(&mut self, byte: u8) -> Result<Option<Frame>, Wrong> {
        let (next, outcome) = match self.stage {
            Stage::Idle if byte == 0xB5 => (Stage::Synced, Ok(None)),
            Stage::Synced if byte == 0x62 => {
                self.payload.clear();
                self.sums = (0, 0);
                (Stage::Class, Ok(None))
            }
            Stage::Idle | Stage::Synced => (Stage::Idle, Ok(None)),
            Stage::Class => {
                self.add(byte);
                (Stage::Id { class: byte }, Ok(None))
            }
            Stage::Id { class } => {
                self.add(byte);
                (Stage::Length { class, id: byte, low: None }, Ok(None))
            }
            Stage::Length { class, id, low: None } => {
                self.add(byte);
                (Stage::Length { class, id, low: Some(byte) }, Ok(None))
            }
            Stage::Length { class, id, low: Some(low) } => {
                self.add(byte);
                match u16::from_le_bytes([low, byte]) {
                    0 => (Stage::Check { class, id, first: None }, Ok(None)),
                    left @ 1..=16 => (Stage::Payload { class, id, left }, Ok(None)),
                    more => (Stage::Idle, Err(Wrong::TooLong(more))),
                }
            }
            Stage::Payload { class, id, left } => {
                self.add(byte);
                if self.payload.len() < self.payload.capacity() {
                    self.payload.push(byte);
                }
                let next = if left > 1 {
                    Stage::Payload { class, id, left: left - 1 }
                } else {
                    Stage::Check { class, id, first: None }
                };
                (next, Ok(None))
            }
            Stage::Check { class, id, first: None } => {
                (Stage::Check { class, id, first: Some(byte) }, Ok(None))
            }
            Stage::Check { class, id, first: Some(first) } => {
                (Stage::Idle, self.checked(class, id, u16::from_be_bytes([first, byte])).map(Some))
            }
        };
        self.stage = next;
        if outcome.is_err() {
            self.lost = self.lost.saturating_add(1);
        }
        outcome
    }

    fn checked(&self, class: u8, id: u8, came: u16) -> Result<Frame, Wrong> {
        let expected = u16::from_be_bytes([self.sums.0, self.sums.1]);
        if came != expected {
            return Err(Wrong::Checksum { expected, came });
        }
        Ok(Frame { class, id, payload: self.payload })
    }

    fn add(&mut self, byte: u8) {
        self.sums.0 = self.sums.0.wrapping_add(byte);
        self.sums.1 = self.sums.1.wrapping_add(self.sums.0);
    }
}
