//! Fletcher's checksum over the used part of a buffer.

use bessemer::prelude::*;

/// The checksum of some bytes.
#[function]
pub fn fletcher16(bytes: &[u8]) -> u16 {
    let (mut low, mut high) = (0_u16, 0_u16);
    for byte in bytes {
        low = (low + u16::from(*byte)) % 255;
        high = (high + low) % 255;
    }
    high << 8 | low
}

/// Returns true if the last two bytes of a frame are its checksum.
#[function]
pub fn is_sound(frame: &List<u8, 16>) -> bool {
    if frame.len() < 3 {
        return false;
    }
    let (body, tail) = (&frame[..frame.len() - 2], &frame[frame.len() - 2..]);
    fletcher16(body).to_be_bytes() == [tail[0], tail[1]]
}
