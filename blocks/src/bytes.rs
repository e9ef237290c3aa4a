//! Bytes: cyclic redundancy checks (CRC), ring buffer and CAN signals from a table.

use bessemer::prelude::*;
use num_traits::AsPrimitive;

/// Returns the table of a CRC of 8 bits whose polynomial is not reflected, such as 0x07 (SMBus) or 0x1d (SAE J1850).
pub const fn crc8_table(polynomial: u8) -> [u8; 256] {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut sum = byte as u8;
        let mut bit = 0;
        while bit < 8 {
            sum = if sum & 0x80 != 0 { (sum << 1) ^ polynomial } else { sum << 1 };
            bit += 1;
        }
        table[byte] = sum;
        byte += 1;
    }
    table
}

/// Returns the table of a CRC of 16 bits whose polynomial is not reflected, such as 0x1021 (CCITT).
pub const fn crc16_table(polynomial: u16) -> [u16; 256] {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut sum = (byte as u16) << 8;
        let mut bit = 0;
        while bit < 8 {
            sum = if sum & 0x8000 != 0 { (sum << 1) ^ polynomial } else { sum << 1 };
            bit += 1;
        }
        table[byte] = sum;
        byte += 1;
    }
    table
}

/// Returns the table of a reflected CRC of 32 bits. The polynomial is reflected, too: 0xedb88320 (IEEE 802.3),
/// 0x82f63b78 (Castagnoli).
pub const fn crc32_table(polynomial: u32) -> [u32; 256] {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut sum = byte as u32;
        let mut bit = 0;
        while bit < 8 {
            sum = if sum & 1 != 0 { (sum >> 1) ^ polynomial } else { sum >> 1 };
            bit += 1;
        }
        table[byte] = sum;
        byte += 1;
    }
    table
}

/// Table of the polynomial 0x07, as in SMBus.
#[data]
pub static CRC8_SMBUS: [u8; 256] = crc8_table(0x07);

/// Table of the polynomial 0x1021, as in CCITT, XMODEM and IBM-3740.
#[data]
pub static CRC16_CCITT: [u16; 256] = crc16_table(0x1021);

/// Table of the polynomial 0x04c11db7, reflected, as in IEEE 802.3.
#[data]
pub static CRC32_IEEE: [u32; 256] = crc32_table(0xedb8_8320);

/// CRC of 8 bits: updates `sum`, which begins at the CRC's initial value, with bytes.
///
/// ```
/// use bessemer_blocks::{CRC8_SMBUS, crc8};
///
/// assert_eq!(crc8(&CRC8_SMBUS, 0, b"123456789"), 0xf4);
/// ```
#[function]
pub fn crc8(table: &[u8; 256], sum: u8, bytes: &[u8]) -> u8 {
    let mut sum = sum;
    for byte in bytes {
        sum = table[usize::from(sum ^ byte)];
    }
    sum
}

/// CRC of 16 bits: updates `sum`, which begins at the CRC's initial value, with bytes.
///
/// ```
/// use bessemer_blocks::{CRC16_CCITT, crc16};
///
/// assert_eq!(crc16(&CRC16_CCITT, 0xffff, b"123456789"), 0x29b1);
/// ```
#[function]
pub fn crc16(table: &[u16; 256], sum: u16, bytes: &[u8]) -> u16 {
    let mut sum = sum;
    for byte in bytes {
        sum = table[usize::from((sum >> 8) as u8 ^ byte)] ^ (sum << 8);
    }
    sum
}

/// Reflected CRC of 32 bits: updates `sum` with bytes. CRC-32 begins with all bits set, and inverts the last sum.
///
/// ```
/// use bessemer_blocks::{CRC32_IEEE, crc32};
///
/// // In two parts, as bytes arrive.
/// let sum = crc32(&CRC32_IEEE, u32::MAX, b"12345");
/// assert_eq!(!crc32(&CRC32_IEEE, sum, b"6789"), 0xcbf4_3926);
/// ```
#[function]
pub fn crc32(table: &[u32; 256], sum: u32, bytes: &[u8]) -> u32 {
    let mut sum = sum;
    for byte in bytes {
        sum = table[usize::from(sum as u8 ^ byte)] ^ (sum >> 8);
    }
    sum
}

/// Ring buffer of at most `N` values, oldest first.
///
/// Initialisation: `Default` is empty. Saturation: a value that is pushed into a full buffer replaces the oldest.
///
/// ```
/// let mut ring = bessemer_blocks::RingBuffer::<u16, 2>::default();
/// assert_eq!([7, 8, 9].map(|value| ring.push(value)), [true, true, false]);
/// assert_eq!((ring.pop(), ring.len(), ring.pop(), ring.pop()), (Some(8), 1, Some(9), None));
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingBuffer<T: Copy + Default, const N: usize> {
    /// The values.
    values: [T; N],
    /// Index of the oldest.
    oldest: u32,
    /// Number of values.
    count: u32,
}

impl<T: Copy + Default, const N: usize> Default for RingBuffer<T, N> {
    fn default() -> Self {
        RingBuffer { values: [T::default(); N], oldest: 0, count: 0 }
    }
}

#[component]
impl<T: Copy + Default, const N: usize> RingBuffer<T, N> {
    /// Appends a value; returns false if it replaced the oldest.
    #[entry(infallible)]
    pub fn push(&mut self, value: T) -> bool {
        let oldest = self.oldest % N as u32;
        let count = self.count.min(N as u32);
        self.values[((oldest + count) % N as u32) as usize] = value;
        let has_room = count < N as u32;
        if has_room {
            self.count = count + 1;
        } else {
            self.oldest = (oldest + 1) % N as u32;
        }
        has_room
    }

    /// Removes the oldest value; returns `None` if there is none.
    #[entry(infallible)]
    pub fn pop(&mut self) -> Option<T> {
        let oldest = self.oldest % N as u32;
        if self.count == 0 {
            return None;
        }
        self.count -= 1;
        self.oldest = (oldest + 1) % N as u32;
        Some(self.values[oldest as usize])
    }

    /// Returns the number of values.
    #[entry(infallible)]
    pub fn len(&self) -> u32 {
        self.count
    }

    /// Returns true if there are no values.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
}

/// Orders of the bits of a CAN signal.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Order {
    /// Least significant byte first, Intel; `start` is the least significant bit.
    #[default]
    Little,
    /// Most significant byte first, Motorola; `start` is the most significant bit.
    Big,
}

/// CAN signal: a row of a table, as in a DBC file. `Default` is one bit.
///
/// value = raw · scale + offset. `start` is counted as in DBC files: bit 0 is the least significant of the first byte.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Signal<T> {
    /// Number of the start bit, 0 to 63.
    pub start: u8,
    /// Number of bits, 1 to 64. The signal fits into the frame.
    pub bits: u8,
    /// Order of the bits.
    pub order: Order,
    /// True if the raw number has a sign (two's complement).
    pub is_signed: bool,
    /// Value of a step of the raw number, not 0.
    pub scale: T,
    /// Value of the raw number 0.
    pub offset: T,
}

impl<T: Real> Default for Signal<T> {
    fn default() -> Self {
        Signal {
            start: 0,
            bits: 1,
            order: Order::Little,
            is_signed: false,
            scale: T::ONE,
            offset: T::ZERO,
        }
    }
}

/// Reads a signal from a frame. It uses 64-bit integers.
///
/// ```
/// use bessemer_blocks::{Order, Signal, read_signal, write_signal};
///
/// let speed = Signal { start: 12, bits: 12, is_signed: true, scale: 0.5, ..Signal::default() };
/// let mut frame = [0xff; 8];
/// write_signal(&mut frame, &speed, -100.0);
/// assert_eq!((frame, read_signal(&frame, &speed)), ([0xff, 0x8f, 0xf3, 0xff, 0xff, 0xff, 0xff, 0xff], -100.0));
/// ```
#[function]
pub fn read_signal<T: Real>(frame: &[u8; 8], signal: &Signal<T>) -> T
where
    u64: AsPrimitive<T>,
    i64: AsPrimitive<T>,
{
    let word = match signal.order {
        Order::Little => u64::from_le_bytes(*frame),
        Order::Big => u64::from_be_bytes(*frame),
    };
    let raw = (word >> shift(signal)) & mask(signal);
    let top = (mask(signal) >> 1) + 1;
    let number = if signal.is_signed {
        <i64 as AsPrimitive<T>>::as_((raw ^ top).wrapping_sub(top) as i64)
    } else {
        <u64 as AsPrimitive<T>>::as_(raw)
    };
    number * signal.scale + signal.offset
}

/// Writes a signal into a frame, whose other bits it keeps.
///
/// Saturation: a value beyond the raw number's range becomes its lowest or highest; NaN becomes raw 0. Between
/// two steps, the nearer one is written.
#[function]
pub fn write_signal<T: Real + AsPrimitive<u64> + AsPrimitive<i64>>(
    frame: &mut [u8; 8],
    signal: &Signal<T>,
    value: T,
) {
    let (shift, mask) = (shift(signal), mask(signal));
    let number = ((value - signal.offset) / signal.scale).round();
    let raw = if signal.is_signed {
        let highest = (mask >> 1) as i64;
        let number: i64 = number.as_();
        number.max(-1 - highest).min(highest) as u64
    } else {
        let number: u64 = number.as_();
        number.min(mask)
    };
    let word = match signal.order {
        Order::Little => u64::from_le_bytes(*frame),
        Order::Big => u64::from_be_bytes(*frame),
    };
    let word = (word & !(mask << shift)) | ((raw & mask) << shift);
    *frame = match signal.order {
        Order::Little => word.to_le_bytes(),
        Order::Big => word.to_be_bytes(),
    };
}

/// Returns the mask of a signal's bits.
#[function]
fn mask<T: Real>(signal: &Signal<T>) -> u64 {
    u64::MAX >> (64 - u32::from(signal.bits.max(1).min(64)))
}

/// Returns the number of bits below a signal in its word.
#[function]
fn shift<T: Real>(signal: &Signal<T>) -> u32 {
    let start = u32::from(signal.start & 63);
    match signal.order {
        Order::Little => start,
        Order::Big => {
            // Byte 0 is the highest of the word.
            let top = 56 - (start & 0x38) + (start & 7);
            (top + 1).saturating_sub(u32::from(signal.bits)) & 63
        }
    }
}
