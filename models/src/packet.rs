//! Packets of bounded size: framing of uplink and downlink.
//!
//! Format: `A5 5A kind sequence(2) length payload(length) checksum(2)`, least significant byte first. The checksum is
//! CRC-16/CCITT over everything between the sync bytes and itself.

use bessemer::prelude::*;

/// Largest size of a packet, bytes.
#[data]
pub const MAX_BYTES: usize = 64;

/// Offset of the first byte that the checksum covers: the kind, after the two sync bytes.
#[data]
pub const CHECKSUM_START: usize = 2;

/// Offset of the payload's length.
#[data]
pub const SIZE_OFFSET: usize = 5;

/// Size of the header, bytes: two sync bytes, kind, sequence (2), length.
#[data]
pub const HEADER_BYTES: usize = 6;

/// Size of the checksum after the payload, bytes.
#[data]
pub const CHECKSUM_BYTES: usize = 2;

/// Largest size of a payload, bytes: the packet without header and checksum.
#[data]
pub const MAX_PAYLOAD: usize = 56;

/// First sync byte.
#[data]
const SYNC_1: u8 = 0xA5;

/// Second sync byte.
#[data]
const SYNC_2: u8 = 0x5A;

/// Bytes received from a link or sent to one.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Packet {
    /// Number of bytes; 0 if there is no packet.
    pub length: usize,
    /// The bytes.
    pub bytes: [u8; MAX_BYTES],
}

impl Default for Packet {
    fn default() -> Self {
        Packet::none()
    }
}

#[data]
impl Packet {
    /// Returns the empty packet.
    pub fn none() -> Packet {
        Packet { length: 0, bytes: [0; MAX_BYTES] }
    }

    /// Builds a packet from its kind and the first `length` bytes of a payload.
    pub fn around(kind: u8, sequence: u16, payload: &[u8; MAX_PAYLOAD], length: usize) -> Packet {
        let mut packet = Packet::none();
        let size = length.min(MAX_PAYLOAD);
        packet.length = HEADER_BYTES + size + CHECKSUM_BYTES;
        packet.bytes[0] = SYNC_1;
        packet.bytes[1] = SYNC_2;
        packet.bytes[2] = kind;
        packet.bytes[3] = (sequence & 0xFF) as u8;
        packet.bytes[4] = (sequence >> 8) as u8;
        packet.bytes[SIZE_OFFSET] = size as u8;
        for n in 0..size {
            packet.bytes[HEADER_BYTES + n] = payload[n];
        }
        let sum = checksum(&packet.bytes[CHECKSUM_START..HEADER_BYTES + size]);
        packet.bytes[HEADER_BYTES + size] = (sum & 0xFF) as u8;
        packet.bytes[HEADER_BYTES + size + 1] = (sum >> 8) as u8;
        packet
    }

    /// Returns true if sync bytes, length and checksum are correct.
    #[requirement("HLR-27")]
    pub fn is_sound(&self) -> bool {
        let size = self.bytes[SIZE_OFFSET] as usize;
        if self.bytes[0] != SYNC_1 || self.bytes[1] != SYNC_2 || size > MAX_PAYLOAD {
            return false;
        }
        if self.length != HEADER_BYTES + size + CHECKSUM_BYTES {
            return false;
        }
        let sent = u16::from_le_bytes([
            self.bytes[HEADER_BYTES + size],
            self.bytes[HEADER_BYTES + size + 1],
        ]);
        checksum(&self.bytes[CHECKSUM_START..HEADER_BYTES + size]) == sent
    }

    /// Returns the kind.
    pub fn kind(&self) -> u8 {
        self.bytes[2]
    }

    /// Returns the sequence number.
    pub fn sequence(&self) -> u16 {
        u16::from_le_bytes([self.bytes[3], self.bytes[4]])
    }

    /// Returns the length of the payload.
    pub fn size(&self) -> usize {
        self.bytes[SIZE_OFFSET] as usize
    }

    /// Returns the payload's byte at `at`, or the last one of its capacity if `at` is beyond that.
    pub fn byte(&self, at: usize) -> u8 {
        let place = at.min(MAX_PAYLOAD - 1);
        self.bytes[HEADER_BYTES + place]
    }

    /// Returns the payload's eight-byte number at `at`.
    pub fn number(&self, at: usize) -> f64 {
        f64::from_bits(self.word(at))
    }

    /// Returns the payload's eight-byte word at `at`.
    pub fn word(&self, at: usize) -> u64 {
        let start = at.min(MAX_PAYLOAD - 8);
        let mut eight = [0; 8];
        for n in 0..8 {
            eight[n] = self.bytes[HEADER_BYTES + start + n];
        }
        u64::from_le_bytes(eight)
    }
}

/// Remainders of the 16 values of four bits, by the polynomial 0x1021.
#[data]
const REMAINDERS: [u16; 16] = [
    0x0000, 0x1021, 0x2042, 0x3063, 0x4084, 0x50A5, 0x60C6, 0x70E7, 0x8108, 0x9129, 0xA14A, 0xB16B,
    0xC18C, 0xD1AD, 0xE1CE, 0xF1EF,
];

/// Returns the CRC-16/CCITT of the bytes (polynomial 0x1021, initial value 0xFFFF), four bits at a time.
#[requirement("HLR-27")]
#[function]
fn checksum(bytes: &[u8]) -> u16 {
    let mut sum: u16 = 0xFFFF;
    for byte in bytes {
        for part in [*byte >> 4, *byte & 0xF] {
            let row = (sum >> 12) ^ part as u16;
            sum = (sum << 4) ^ REMAINDERS[(row & 0xF) as usize];
        }
    }
    sum
}
