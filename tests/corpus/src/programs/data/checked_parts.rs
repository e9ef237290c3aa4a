//! `get(a..b)` returns a part of an array if it is in range; `?` returns if it is not.

use bessemer::prelude::*;

/// The exclusive or of a part of a line; `None` if it is out of range.
#[function]
pub fn parity(line: &[u8; 8], from: usize, to: usize) -> Option<u8> {
    let part = line.get(from..to)?;
    Some(part.iter().fold(0, |sum, byte| sum ^ byte))
}

/// The sum of the payload; the second byte is its length. 0 if the frame is too short.
#[function]
pub fn payload_sum(frame: &[u8; 8]) -> u32 {
    let Some(payload) = frame.get(2..2 + usize::from(frame[1])) else { return 0 };
    payload.iter().map(|&byte| u32::from(byte)).sum()
}

/// Number of bytes from an index on; `None` if it is out of range.
#[function]
pub fn behind(line: &[u8; 8], from: usize) -> Option<usize> {
    let rest = line.get(from..)?;
    Some(rest.len())
}

/// Clears the bytes up to and including an index; returns false if it is out of range.
#[function]
pub fn clear_up_to(line: &mut [u8; 8], last: usize) -> bool {
    if let Some(part) = line.get_mut(..=last) {
        part.fill(0);
        true
    } else {
        false
    }
}

/// Increments a byte; `None` if the index is out of range.
#[function]
pub fn count_up(line: &mut [u8; 8], index: usize) -> Option<u8> {
    let byte = line.get_mut(index)?;
    *byte = byte.wrapping_add(1);
    Some(*byte)
}

/// Value of a list of one or two elements.
#[function]
pub fn few(values: &List<u8, 4>) -> u16 {
    match values.as_slice() {
        &[only] => u16::from(only),
        [first, second] => u16::from(*first) * 256 + u16::from(*second),
        _ => 0,
    }
}

/// Reason why a field is missing.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Missing {
    /// The frame is too short.
    #[default]
    Short,
    /// The position is out of range.
    Beyond(usize),
}

/// The two-byte number at a position of a frame.
#[function]
pub fn number(frame: &[u8; 6], at: usize) -> Result<u16, Missing> {
    let bytes = frame.get(at..at + 2).ok_or(Missing::Short)?;
    Ok(u16::from_le_bytes([bytes[0], bytes[1]]))
}

/// The sum of a frame's bytes before a position.
#[function]
pub fn sum_up_to(frame: &[u8; 6], end: usize) -> Result<u16, Missing> {
    let bytes = frame.get(..end).ok_or(Missing::Beyond(end))?;
    Ok(bytes.iter().map(|byte| u16::from(*byte)).sum())
}

/// A distance, and the time that it takes.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leg {
    /// Distance, m.
    pub way: f64,
    /// Time, s.
    pub time: f64,
}

/// Speed on a leg, m/s; `None` if there is no such leg.
#[function]
pub fn speed_on(route: &List<Leg, 4>, index: usize) -> Option<f64> {
    let leg = route.get(index)?;
    Some(leg.way / leg.time)
}

/// The time of the last leg, s.
#[function]
pub fn last_time(route: &[Leg; 2], count: usize) -> Result<f64, Missing> {
    let leg = route[..count].last().ok_or(Missing::Short)?;
    Ok(leg.time)
}
