//! Methods of `Result` with closures become branches.

use bessemer::prelude::*;

/// Errors of a frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FrameError {
    #[default]
    Short,
    Checksum,
}

/// Errors reported to the ground.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum LinkError {
    #[default]
    Silent,
    /// A damaged frame: its number.
    Damaged(u8),
}

/// The value in a frame.
#[function]
pub fn value(frame: [u8; 4]) -> Result<u16, FrameError> {
    if frame[0] < 2 {
        return Err(FrameError::Short);
    }
    if frame[1] ^ frame[2] != frame[3] {
        return Err(FrameError::Checksum);
    }
    Ok(u16::from_be_bytes([frame[1], frame[2]]))
}

/// The reading in volts, with its error converted to one of the link.
#[function]
pub fn volts(frame: [u8; 4]) -> Result<f32, LinkError> {
    value(frame).map(|raw| f32::from(raw) * 0.001).map_err(|error| match error {
        FrameError::Short => LinkError::Silent,
        FrameError::Checksum => LinkError::Damaged(frame[0]),
    })
}

/// The sum of the values of two frames.
#[function]
pub fn total(one: [u8; 4], other: [u8; 4]) -> Result<u16, FrameError> {
    let one = value(one)?;
    value(other).and_then(|other| one.checked_add(other).ok_or_else(|| FrameError::Checksum))
}

/// The value, or a number for the error.
#[function]
pub fn shown(frame: [u8; 4]) -> u16 {
    value(frame).unwrap_or_else(|error| match error {
        FrameError::Short => 1,
        FrameError::Checksum => 2,
    })
}
