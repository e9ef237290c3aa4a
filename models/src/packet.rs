//! Packets of bounded size: how bytes are framed on the way up and down.
//!
//! `A5 5A kind sequence(2) length payload(length) checksum(2)`, least significant byte first; the
//! checksum is CRC-16/CCITT over all between the first two bytes and itself. Knows bytes, not meanings.

use bessemer::prelude::*;

/// The most bytes of a packet.
#[data]
pub const MOST_BYTES: usize = 64;

/// Where what is summed up begins: behind the two marks, with the kind.
#[data]
pub const START: usize = 2;

/// Where the length of the payload stands.
#[data]
pub const SIZE_AT: usize = 5;

/// Bytes before the payload: two marks, kind, sequence (2), length.
#[data]
pub const HEADER: usize = 6;

/// Bytes of the checksum behind the payload.
#[data]
pub const SUM: usize = 2;

/// The most bytes of a payload: the rest is header and checksum.
#[data]
pub const MOST_PAYLOAD: usize = 56;

/// The first byte of every packet.
#[data]
const FIRST: u8 = 0xA5;

/// The second byte of every packet.
#[data]
const SECOND: u8 = 0x5A;

/// Bytes as they come from a link, or go to one.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Packet {
    /// How many of the bytes there are; 0 is no packet.
    pub length: usize,
    /// The bytes.
    pub bytes: [u8; MOST_BYTES],
}

impl Default for Packet {
    fn default() -> Self {
        Packet::none()
    }
}

#[data]
impl Packet {
    /// No packet.
    pub fn none() -> Packet {
        Packet { length: 0, bytes: [0; MOST_BYTES] }
    }

    /// A packet of a kind around the first `length` bytes of a payload.
    pub fn around(kind: u8, sequence: u16, payload: &[u8; MOST_PAYLOAD], length: usize) -> Packet {
        let mut packet = Packet::none();
        let size = length.min(MOST_PAYLOAD);
        packet.length = HEADER + size + SUM;
        packet.bytes[0] = FIRST;
        packet.bytes[1] = SECOND;
        packet.bytes[2] = kind;
        packet.bytes[3] = (sequence & 0xFF) as u8;
        packet.bytes[4] = (sequence >> 8) as u8;
        packet.bytes[SIZE_AT] = size as u8;
        for n in 0..size {
            packet.bytes[HEADER + n] = payload[n];
        }
        let sum = checksum(&packet.bytes[START..HEADER + size]);
        packet.bytes[HEADER + size] = (sum & 0xFF) as u8;
        packet.bytes[HEADER + size + 1] = (sum >> 8) as u8;
        packet
    }

    /// Whether the bytes are a packet: its marks, its length and its checksum.
    pub fn is_sound(&self) -> bool {
        let size = self.bytes[SIZE_AT] as usize;
        if self.bytes[0] != FIRST || self.bytes[1] != SECOND || size > MOST_PAYLOAD {
            return false;
        }
        if self.length != HEADER + size + SUM {
            return false;
        }
        let sent = u16::from_le_bytes([self.bytes[HEADER + size], self.bytes[HEADER + size + 1]]);
        checksum(&self.bytes[START..HEADER + size]) == sent
    }

    /// What it says it is.
    pub fn kind(&self) -> u8 {
        self.bytes[2]
    }

    /// Its number.
    pub fn sequence(&self) -> u16 {
        u16::from_le_bytes([self.bytes[3], self.bytes[4]])
    }

    /// How long its payload is.
    pub fn size(&self) -> usize {
        self.bytes[SIZE_AT] as usize
    }

    /// The byte of the payload at `at`; 0 behind its capacity.
    pub fn byte(&self, at: usize) -> u8 {
        let place = at.min(MOST_PAYLOAD - 1);
        self.bytes[HEADER + place]
    }

    /// The number at `at` in the payload, of eight bytes.
    pub fn number(&self, at: usize) -> f64 {
        f64::from_bits(self.word(at))
    }

    /// The word at `at` in the payload, of eight bytes.
    pub fn word(&self, at: usize) -> u64 {
        let start = at.min(MOST_PAYLOAD - 8);
        let mut eight = [0; 8];
        for n in 0..8 {
            eight[n] = self.bytes[HEADER + start + n];
        }
        u64::from_le_bytes(eight)
    }
}

/// CRC-16/CCITT (polynomial 0x1021, from 0xFFFF).
#[function]
fn checksum(bytes: &[u8]) -> u16 {
    let mut sum: u16 = 0xFFFF;
    for byte in bytes {
        sum ^= (*byte as u16) << 8;
        for _ in 0..8 {
            if sum & 0x8000 != 0 {
                sum = (sum << 1) ^ 0x1021;
            } else {
                sum <<= 1;
            }
        }
    }
    sum
}
