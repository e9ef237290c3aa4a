//! Calls of `audio-codec-algorithms` over plain numbers.

use crate::*;

pub fn laws(linear: i16, coded: u8) -> ([u8; 4], [i16; 2]) {
    let codes = [encode_alaw(linear), encode_ulaw(linear), convert_ulaw_to_alaw(coded), convert_alaw_to_ulaw(coded)];
    (codes, [decode_alaw(coded), decode_ulaw(coded)])
}

pub fn decoded(predictor: i16, index: u8, nibbles: [u8; 8]) -> ([i16; 8], i16, u8) {
    let mut state = AdpcmImaState::new();
    state.predictor = predictor;
    state.step_index = index;
    let mut out = [0; 8];
    for k in 0..8 {
        out[k] = decode_adpcm_ima(nibbles[k], &mut state);
    }
    (out, state.predictor, state.step_index)
}

pub fn encoded(predictor: i16, index: u8, samples: [i16; 8]) -> ([u8; 8], i16, u8) {
    let mut state = AdpcmImaState { predictor, step_index: index };
    let mut out = [0; 8];
    for k in 0..8 {
        out[k] = encode_adpcm_ima(samples[k], &mut state);
    }
    (out, state.predictor, state.step_index)
}

pub fn block(samples: [i16; 64]) -> ([u8; 34], [i16; 64]) {
    let mut state = AdpcmImaState::default();
    let mut bytes = [0; 34];
    encode_adpcm_ima_ima4(&samples, &mut state, &mut bytes);
    let mut back = [0; 64];
    decode_adpcm_ima_ima4(&bytes, &mut AdpcmImaState::new(), &mut back);
    (bytes, back)
}

pub fn stereo(bytes: [u8; 16]) -> Option<[i16; 18]> {
    let mut samples = [0; 18];
    match decode_adpcm_ima_ms(&bytes, true, &mut samples) {
        Ok(()) => Some(samples),
        Err(_) => None,
    }
}

pub fn mono(samples: [i16; 9]) -> Option<[u8; 8]> {
    let mut bytes = [0; 8];
    let mut states = [AdpcmImaState::new()];
    match encode_adpcm_ima_ms(&samples, &mut states, &mut bytes) {
        Ok(()) => Some(bytes),
        Err(Error::InvalidChannels) => None,
        Err(Error::InvalidBufferSize) => Some([1; 8]),
    }
}
