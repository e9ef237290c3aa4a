//! Elements that move within an array, its first and last elements, and slices converted to arrays.

use bessemer::prelude::*;

/// Adds a sample to those of a filter, the newest first.
#[function]
pub fn record(samples: &mut [f32; 5], sample: f32) {
    samples.rotate_right(1);
    samples[0] = sample;
}

/// Removes the bytes that have been read from a buffer.
#[function]
pub fn consume(buffer: &mut [u8; 8], read: usize) {
    buffer.copy_within(read.., 0);
}

/// Returns true if a text is a complete sentence of the receiver.
#[function]
pub fn is_sentence(text: &[u8; 12]) -> bool {
    text.starts_with(b"$GP") && text.ends_with(b"\r\n")
}

/// Big-endian numbers in a frame.
#[function]
pub fn fields(frame: &[u8; 10]) -> (u32, i16) {
    let count = u32::from_be_bytes(frame[2..6].try_into().unwrap());
    (count, i16::from_be_bytes([frame[6], frame[7]]))
}

/// The big-endian number at a position; `None` if the frame is too short.
#[function]
pub fn field(frame: &List<u8, 16>, at: usize) -> Option<u32> {
    let bytes = frame.get(at..)?;
    bytes.first_chunk::<4>().map(|bytes| u32::from_le_bytes(*bytes))
}

/// The number at the front of a frame, and whether its last two bytes are the sum of the others.
#[function]
pub fn framed(frame: &List<u8, 12>) -> Option<(u16, bool)> {
    let (number, behind) = frame.split_first_chunk::<2>()?;
    let (payload, trailer) = behind.split_last_chunk::<2>()?;
    let mut sum = 0_u16;
    for byte in payload {
        sum = sum.wrapping_add(u16::from(*byte));
    }
    Some((u16::from_be_bytes(*number), sum == u16::from_be_bytes(*trailer)))
}

/// The last three of five samples, and the number of those before them.
#[function]
pub fn latest(samples: &[i16; 5]) -> ([i16; 3], usize) {
    match samples.split_last_chunk::<3>() {
        Some((before, latest)) => (*latest, before.len()),
        None => ([0; 3], 0),
    }
}
