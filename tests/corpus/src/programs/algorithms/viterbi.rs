//! A Viterbi decoder for the convolutional code (7, 5) of rate 1/2, which decodes 16 bits to eight.

use bessemer::prelude::*;

const STATES: usize = 4;
const LENGTH: usize = 8;

/// The two bits that the encoder sends for `bit` in `state`.
#[function]
fn sent(state: usize, bit: usize) -> u32 {
    let window = (bit << 2) | state;
    let high = (window & 0b111).count_ones() % 2;
    let low = (window & 0b101).count_ones() % 2;
    high << 1 | low
}

/// Encodes eight bits, the most significant first.
#[function]
pub fn encode(byte: u8) -> u16 {
    let mut state = 0;
    let mut code = 0;
    for i in (0..LENGTH).rev() {
        let bit = usize::from(byte >> i & 1);
        code = code << 2 | sent(state, bit) as u16;
        state = (bit << 1) | (state >> 1);
    }
    code
}

/// The byte that was most likely sent, and the number of received bits that differ from its code.
#[function]
pub fn decode(code: u16) -> (u8, u32) {
    let mut costs = [0, 100, 100, 100];
    let mut paths = [[0_u8; LENGTH]; STATES];
    for step in 0..LENGTH {
        let came = u32::from(code >> (2 * (LENGTH - 1 - step)) & 0b11);
        let mut next_costs = [u32::MAX; STATES];
        let mut next_paths = paths;
        for (state, &cost) in costs.iter().enumerate() {
            for bit in 0..2 {
                let to = (bit << 1) | (state >> 1);
                let total = cost + (sent(state, bit) ^ came).count_ones();
                if total < next_costs[to] {
                    next_costs[to] = total;
                    next_paths[to] = paths[state];
                    next_paths[to][step] = bit as u8;
                }
            }
        }
        costs = next_costs;
        paths = next_paths;
    }
    let (best, &cost) =
        costs.iter().enumerate().min_by_key(|(_, cost)| **cost).unwrap_or((0, &costs[0]));
    let byte = paths[best].iter().fold(0, |byte, bit| byte << 1 | bit);
    (byte, cost)
}
