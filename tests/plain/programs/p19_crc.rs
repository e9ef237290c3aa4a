//! Table-driven CRC-16 and CRC-32 with the tables made at compile time; one
//! digest type, generic over the algorithm.

use core::fmt;
use core::marker::PhantomData;

/// A CRC as its parameters; register and table are of type `Word`.
pub trait Algorithm {
    type Word: Copy + Eq + fmt::LowerHex + fmt::Debug;
    const INIT: Self::Word;
    const XOR_OUT: Self::Word;
    /// CRC of the bytes "123456789".
    const CHECK: Self::Word;

    fn update(crc: Self::Word, byte: u8) -> Self::Word;
    fn finish(crc: Self::Word) -> Self::Word;
}

const fn table16_msb(poly: u16) -> [u16; 256] {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        let mut crc = (i as u16) << 8;
        let mut bit = 0;
        while bit < 8 {
            crc = if crc & 0x8000 != 0 { crc << 1 ^ poly } else { crc << 1 };
            bit += 1;
        }
        table[i] = crc;
        i += 1;
    }
    table
}

const fn table32_lsb(poly: u32) -> [u32; 256] {
    let reversed = poly.reverse_bits();
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        let mut crc = i as u32;
        let mut bit = 0;
        while bit < 8 {
            crc = if crc & 1 != 0 { crc >> 1 ^ reversed } else { crc >> 1 };
            bit += 1;
        }
        table[i] = crc;
        i += 1;
    }
    table
}

/// CRC-16/CCITT-FALSE.
#[derive(Clone, Copy, Debug)]
pub struct Ccitt;

impl Ccitt {
    const TABLE: [u16; 256] = table16_msb(0x1021);
}

impl Algorithm for Ccitt {
    type Word = u16;
    const INIT: u16 = 0xFFFF;
    const XOR_OUT: u16 = 0;
    const CHECK: u16 = 0x29B1;

    fn update(crc: u16, byte: u8) -> u16 {
        let [high, _] = crc.to_be_bytes();
        crc << 8 ^ Self::TABLE[usize::from(high ^ byte)]
    }

    fn finish(crc: u16) -> u16 {
        crc ^ Self::XOR_OUT
    }
}

/// CRC-32 as in Ethernet and zip.
#[derive(Clone, Copy, Debug)]
pub struct Ieee;

static IEEE_TABLE: [u32; 256] = table32_lsb(0x04C1_1DB7);

impl Algorithm for Ieee {
    type Word = u32;
    const INIT: u32 = u32::MAX;
    const XOR_OUT: u32 = u32::MAX;
    const CHECK: u32 = 0xCBF4_3926;

    fn update(crc: u32, byte: u8) -> u32 {
        crc >> 8 ^ IEEE_TABLE[((crc ^ u32::from(byte)) & 0xFF) as usize]
    }

    fn finish(crc: u32) -> u32 {
        crc ^ Self::XOR_OUT
    }
}

/// A CRC in the making.
#[derive(Debug)]
pub struct Digest<A: Algorithm> {
    crc: A::Word,
    _algorithm: PhantomData<A>,
}

impl<A: Algorithm> Digest<A> {
    pub fn new() -> Self {
        Self { crc: A::INIT, _algorithm: PhantomData }
    }

    pub fn push(&mut self, byte: u8) -> &mut Self {
        self.crc = A::update(self.crc, byte);
        self
    }

    pub fn finish(&self) -> A::Word {
        A::finish(self.crc)
    }
}

impl<A: Algorithm> Default for Digest<A> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'a, A: Algorithm> Extend<&'a u8> for Digest<A> {
    fn extend<I: IntoIterator<Item = &'a u8>>(&mut self, bytes: I) {
        self.crc = bytes.into_iter().fold(self.crc, |crc, &b| A::update(crc, b));
    }
}

/// CRC of a whole slice.
pub fn checksum<A: Algorithm>(bytes: &[u8]) -> A::Word {
    let mut digest = Digest::<A>::new();
    digest.extend(bytes);
    digest.finish()
}

/// Splits off and verifies a trailing big-endian CRC-16.
pub fn verify_trailer(frame: &[u8]) -> Option<&[u8]> {
    let (payload, trailer) = frame.split_last_chunk::<2>()?;
    (checksum::<Ccitt>(payload) == u16::from_be_bytes(*trailer)).then_some(payload)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn self_test<A: Algorithm>() {
        assert_eq!(checksum::<A>(b"123456789"), A::CHECK);
    }

    #[test]
    fn check_values() {
        self_test::<Ccitt>();
        self_test::<Ieee>();
    }

    #[test]
    fn piecewise_equals_whole() {
        let mut digest = Digest::<Ieee>::default();
        digest.push(b'a').push(b'b').extend(b"cdef");
        assert_eq!(digest.finish(), checksum::<Ieee>(b"abcdef"));
    }

    #[test]
    fn trailer() {
        let mut frame = *b"telemetry..";
        let crc = checksum::<Ccitt>(b"telemetry").to_be_bytes();
        frame[9..].copy_from_slice(&crc);
        assert_eq!(verify_trailer(&frame), Some(&b"telemetry"[..]));
        frame[3] ^= 0x10;
        assert_eq!(verify_trailer(&frame), None);
        assert_eq!(verify_trailer(&[1]), None);
    }
}
