//! CRC-32 (IEEE 802.3, reflected), with a table computed at compile time.

use bessemer::prelude::*;

/// The checksum of each possible byte.
const TABLE: [u32; 256] = table();

const fn table() -> [u32; 256] {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut sum = byte as u32;
        let mut bit = 0;
        while bit < 8 {
            sum = if sum & 1 == 1 { (sum >> 1) ^ 0xedb8_8320 } else { sum >> 1 };
            bit += 1;
        }
        table[byte] = sum;
        byte += 1;
    }
    table
}

/// Updates the checksum with one byte. Callers invert all bits of the checksum before the first and after the last
/// byte.
#[function]
pub fn crc32_next(sum: u32, byte: u8) -> u32 {
    TABLE[usize::from(sum as u8 ^ byte)] ^ (sum >> 8)
}

/// The checksum of the first bytes of a buffer.
#[function]
pub fn crc32(bytes: &[u8; 16], length: usize) -> u32 {
    assert!(length <= 16);
    let mut sum = u32::MAX;
    for i in 0..length {
        sum = crc32_next(sum, bytes[i]);
    }
    !sum
}
