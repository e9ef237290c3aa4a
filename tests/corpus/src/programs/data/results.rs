//! `Result` is a struct: a flag for whether there is a value, the value, and the error.

use bessemer::prelude::*;

/// Reason why a frame is refused.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Refused {
    /// Too few bytes were received.
    #[default]
    Short,
    /// The checksum is wrong.
    Checksum,
}

/// The payload of a frame of which `len` bytes were received.
#[function]
pub fn payload(frame: &[u8; 3], len: u8) -> Result<u16, Refused> {
    if len < 3 {
        return Err(Refused::Short);
    }
    if frame[0].wrapping_add(frame[1]) != frame[2] {
        return Err(Refused::Checksum);
    }
    Ok(u16::from_le_bytes([frame[0], frame[1]]))
}
