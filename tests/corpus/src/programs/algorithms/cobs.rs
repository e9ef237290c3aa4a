//! Consistent overhead byte stuffing (Cheshire and Baker 1999): frames without a zero inside.

use bessemer::prelude::*;

/// Longest payload; short enough for one block.
pub const PAYLOAD: usize = 12;

/// A frame: the payload, one byte of overhead, and the closing zero.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    pub bytes: [u8; PAYLOAD + 2],
    pub length: usize,
}

/// Encodes the first `length` bytes as a frame.
#[function]
pub fn encode(payload: &[u8; PAYLOAD], length: usize) -> Frame {
    assert!(length <= PAYLOAD);
    let mut frame = Frame { bytes: [0; PAYLOAD + 2], length: 0 };
    let mut mark = 0;
    let mut distance = 1;
    for i in 0..length {
        if payload[i] == 0 {
            frame.bytes[mark] = distance;
            mark = i + 1;
            distance = 1;
        } else {
            frame.bytes[i + 1] = payload[i];
            distance += 1;
        }
    }
    frame.bytes[mark] = distance;
    frame.length = length + 2;
    frame
}

/// Decodes a frame into `payload`; returns its length, or `PAYLOAD + 1` if the frame is invalid.
#[function]
pub fn decode(frame: &Frame, payload: &mut [u8; PAYLOAD]) -> usize {
    if frame.length < 2 || frame.length > PAYLOAD + 2 {
        return PAYLOAD + 1;
    }
    let end = frame.length - 1;
    let mut next = usize::from(frame.bytes[0]);
    for i in 1..end {
        let byte = frame.bytes[i];
        if i == next {
            if byte == 0 {
                return PAYLOAD + 1;
            }
            next = i + usize::from(byte);
            payload[i - 1] = 0;
        } else if byte == 0 {
            return PAYLOAD + 1;
        } else {
            payload[i - 1] = byte;
        }
    }
    if next == end && frame.bytes[end] == 0 { end - 1 } else { PAYLOAD + 1 }
}
