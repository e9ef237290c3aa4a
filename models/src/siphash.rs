//! SipHash-2-4, a short keyed hash of a message (Aumasson, Bernstein: "SipHash: a fast short-input PRF", INDOCRYPT
//! 2012).
//!
//! The purpose of key and bytes is unknown here.

use crate::packet::MAX_BYTES;
use bessemer::prelude::*;

/// Size of the words that the hash absorbs, in bytes.
const WORD: usize = 8;

/// Secret key of 16 bytes, shared with the ground station.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Key {
    /// True if a key is set.
    pub is_set: bool,
    /// First and last eight bytes of the key, least significant byte first.
    pub halves: [u64; 2],
}

/// The four state words of the hash.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sip {
    /// v0 of the paper.
    pub v0: u64,
    /// v1 of the paper.
    pub v1: u64,
    /// v2 of the paper.
    pub v2: u64,
    /// v3 of the paper.
    pub v3: u64,
}

#[data]
impl Sip {
    /// Returns the initial state for a key (paper, section 2.1).
    pub fn keyed(key: &Key) -> Sip {
        Sip {
            v0: key.halves[0] ^ 0x736F_6D65_7073_6575,
            v1: key.halves[1] ^ 0x646F_7261_6E64_6F6D,
            v2: key.halves[0] ^ 0x6C79_6765_6E65_7261,
            v3: key.halves[1] ^ 0x7465_6462_7974_6573,
        }
    }

    /// Applies one SipRound (paper, figure 2.1).
    pub fn turn(&mut self) {
        self.v0 = self.v0.wrapping_add(self.v1);
        self.v2 = self.v2.wrapping_add(self.v3);
        self.v1 = self.v1.rotate_left(13) ^ self.v0;
        self.v3 = self.v3.rotate_left(16) ^ self.v2;
        self.v0 = self.v0.rotate_left(32);
        self.v2 = self.v2.wrapping_add(self.v1);
        self.v0 = self.v0.wrapping_add(self.v3);
        self.v1 = self.v1.rotate_left(17) ^ self.v2;
        self.v3 = self.v3.rotate_left(21) ^ self.v0;
        self.v2 = self.v2.rotate_left(32);
    }

    /// Absorbs eight bytes of the message: the two rounds of SipHash-2-4.
    pub fn take(&mut self, word: u64) {
        self.v3 ^= word;
        self.turn();
        self.turn();
        self.v0 ^= word;
    }

    /// Returns the hash after the last word: the four rounds of SipHash-2-4.
    pub fn sum(&self) -> u64 {
        let mut last = *self;
        last.v2 ^= 0xFF;
        for _ in 0..4 {
            last.turn();
        }
        last.v0 ^ last.v1 ^ last.v2 ^ last.v3
    }
}

/// Returns the hash of the bytes from `from` to before `end`.
#[requirement("HLR-29")]
#[function]
pub fn sip_hash(key: &Key, bytes: &[u8; MAX_BYTES], from: usize, end: usize) -> u64 {
    let mut sip = Sip::keyed(key);
    let stop = end.min(MAX_BYTES);
    let mut at = from.min(stop);
    let length = stop - at;
    for _ in 0..MAX_BYTES / WORD {
        if at + WORD <= stop {
            let mut word: u64 = 0;
            for n in 0..WORD {
                word |= (bytes[at + n] as u64) << (8 * n);
            }
            sip.take(word);
            at += WORD;
        }
    }
    // The remaining bytes, and the length of the message in the highest byte.
    let mut last = (length as u64) << 56;
    for n in 0..WORD - 1 {
        if at + n < stop {
            last |= (bytes[at + n] as u64) << (8 * n);
        }
    }
    sip.take(last);
    sip.sum()
}
