//! Calls of `cobs` over plain numbers.

use crate::*;

pub fn encoded(source: [u8; 12], len: usize) -> ([u8; 16], usize) {
    let mut dest = [0; 16];
    let used = encode(&source[..len % 13], &mut dest);
    (dest, used)
}

pub fn with_sentinel(source: [u8; 12], sentinel: u8) -> ([u8; 16], usize) {
    let mut dest = [0; 16];
    let used = encode_with_sentinel(&source, &mut dest, sentinel);
    (dest, used)
}

pub fn decoded(source: [u8; 12]) -> ([u8; 12], usize, u8) {
    let mut dest = [0; 12];
    match decode(&source, &mut dest) {
        Ok(used) => (dest, used, 0),
        Err(DecodeError::EmptyFrame) => (dest, 0, 1),
        Err(DecodeError::InvalidFrame { decoded_bytes }) => (dest, decoded_bytes, 2),
        Err(DecodeError::TargetBufTooSmall) => (dest, 0, 3),
    }
}

pub fn in_place(mut bytes: [u8; 12]) -> ([u8; 12], usize) {
    let used = decode_in_place(&mut bytes).unwrap_or(99);
    (bytes, used)
}

pub fn by_the_byte(source: [u8; 8]) -> [u8; 8] {
    let mut state = EncoderState::default();
    let mut out = [0; 8];
    for k in 0..8 {
        out[k] = match state.push(source[k]) {
            PushResult::AddSingle(byte) => byte,
            PushResult::ModifyFromStartAndSkip((at, code)) => (at as u8) ^ code,
            PushResult::ModifyFromStartAndPushAndSkip((at, code, byte)) => (at as u8) ^ code ^ byte,
        };
    }
    out
}
