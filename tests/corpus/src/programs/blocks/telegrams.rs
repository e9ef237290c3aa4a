//! Frames of a bus: signals from a table, checksums and a queue.

use bessemer::prelude::*;
pub use bessemer_blocks::{
    CRC8_SMBUS, CRC16_CCITT, CRC32_IEEE, Order, RingBuffer, Signal, crc8, crc16, crc32, read_signal,
    write_signal,
};

/// Signals of the frame of the wheels, m/s and °C.
#[data]
pub static WHEELS: [Signal<f32>; 3] = [
    Signal { start: 0, bits: 12, order: Order::Little, is_signed: false, scale: 0.05, offset: 0.0 },
    Signal { start: 12, bits: 12, order: Order::Little, is_signed: true, scale: 0.05, offset: 0.0 },
    Signal { start: 39, bits: 10, order: Order::Big, is_signed: true, scale: 0.25, offset: 40.0 },
];

/// Reads the signals of a frame.
#[function]
pub fn wheels(frame: &[u8; 8]) -> [f32; 3] {
    let mut values = [0.0; 3];
    for (value, signal) in values.iter_mut().zip(&WHEELS) {
        *value = read_signal(frame, signal);
    }
    values
}

/// Writes the signals of a frame, and its checksum into the last byte.
#[function]
pub fn wheels_frame(values: &[f32; 3]) -> [u8; 8] {
    let mut frame = [0; 8];
    for (value, signal) in values.iter().zip(&WHEELS) {
        write_signal(&mut frame, signal, *value);
    }
    frame[7] = crc8(&CRC8_SMBUS, 0, &frame[..7]);
    frame
}

/// Reads and writes a signal of any place.
#[function]
pub fn exchanged(frame: [u8; 8], signal: &Signal<f64>, value: f64) -> (f64, [u8; 8]) {
    let mut frame = frame;
    let before = read_signal(&frame, signal);
    write_signal(&mut frame, signal, value);
    (before, frame)
}

/// Checksums of a record, by CRC-16 (IBM-3740) and CRC-32.
#[function]
pub fn checksums(record: &[u8; 12]) -> (u16, u32) {
    (crc16(&CRC16_CCITT, 0xffff, record), !crc32(&CRC32_IEEE, u32::MAX, record))
}

/// Queue of commands between an interrupt and the main loop.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Commands {
    queue: RingBuffer<u16, 4>,
}

#[component]
impl Commands {
    /// Appends a command; returns false if the oldest was lost.
    #[entry(infallible)]
    pub fn put(&mut self, command: u16) -> bool {
        self.queue.push(command)
    }

    /// Removes the oldest command.
    #[entry(infallible)]
    pub fn take(&mut self) -> Option<u16> {
        if self.queue.is_empty() { None } else { self.queue.pop() }
    }
}
