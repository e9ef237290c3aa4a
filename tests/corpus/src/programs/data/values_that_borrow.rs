//! A struct, a variant, a tuple or a result may hold a slice. In the C it holds a start
//! index and a length; the array is passed separately, so that no pointer outlives a call.

use bessemer::prelude::*;

/// Reads a packet from the front.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    rest: &'a [u8],
    /// The bytes that were read last.
    last: &'a [u8],
}

#[data]
impl<'a> Reader<'a> {
    /// Starts at the beginning of a packet.
    pub fn new(rest: &'a [u8]) -> Self {
        Self { rest, last: &[] }
    }

    /// The next `count` bytes; `None` if there are fewer.
    pub fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        if count > self.rest.len() {
            return None;
        }
        let (taken, rest) = self.rest.split_at(count);
        self.rest = rest;
        self.last = taken;
        Some(taken)
    }

    /// The next byte.
    pub fn byte(&mut self) -> Option<u8> {
        let byte = self.take(1)?;
        Some(byte[0])
    }

    /// The next two bytes as a number.
    pub fn word(&mut self) -> Option<u16> {
        match self.take(2)? {
            [high, low] => Some(u16::from(*high) << 8 | u16::from(*low)),
            _ => None,
        }
    }
}

/// A parsed packet.
#[data]
#[derive(Clone, Copy, Debug)]
pub enum Packet<'a> {
    /// A word.
    Set(u16),
    /// Bytes for an address.
    Load {
        /// Destination address.
        address: u8,
        /// The bytes.
        bytes: &'a [u8],
    },
}

/// Parses a packet: `None` if it is too short, the kind as an error if that is unknown.
#[function]
pub fn understood(packet: &[u8]) -> Option<Result<Packet<'_>, u8>> {
    let mut reader = Reader::new(packet);
    let kind = reader.byte()?;
    Some(match kind {
        1 => Ok(Packet::Set(reader.word()?)),
        2 => {
            let address = reader.byte()?;
            let count = usize::from(reader.byte()?);
            Ok(Packet::Load { address, bytes: reader.take(count)? })
        }
        other => Err(other),
    })
}

/// A number for each packet of eight bytes: its word, or the sum of its bytes.
#[function]
pub fn outcome(packet: &[u8; 8]) -> u32 {
    match understood(packet) {
        None => 1,
        Some(Err(kind)) => 1000 + u32::from(kind),
        Some(Ok(Packet::Set(word))) => 2000 + u32::from(word),
        Some(Ok(Packet::Load { address, bytes })) => {
            let mut sum = u32::from(address);
            for (i, byte) in bytes.iter().enumerate() {
                sum += (i as u32 + 1) * u32::from(*byte);
            }
            sum
        }
    }
}

/// The outcome of a part of a longer packet.
#[function]
pub fn outcome_behind(packets: &[u8; 12], from: usize) -> u32 {
    match understood(&packets[from..]) {
        Some(Ok(Packet::Load { bytes, .. })) => bytes.first().map_or(7, |byte| u32::from(*byte)),
        Some(Ok(Packet::Set(word))) => u32::from(word),
        _ => 0,
    }
}

/// Both halves of some numbers.
#[function]
pub fn halves(values: &[f64]) -> (&[f64], &[f64]) {
    values.split_at(values.len() / 2)
}

/// The numbers from the first to the last that exceed a limit.
#[function]
pub fn above(mut values: &[f64], limit: f64) -> &[f64] {
    #[bound(64)]
    while let Some((first, rest)) = values.split_first() {
        if *first > limit {
            break;
        }
        values = rest;
    }
    #[bound(64)]
    while let Some((last, rest)) = values.split_last() {
        if *last > limit {
            break;
        }
        values = rest;
    }
    values
}

/// The first number of the later half, and how many exceed half of it.
#[function]
pub fn seen(values: &[f64; 6]) -> (f64, usize) {
    let (early, late) = halves(values);
    let longer = if late[0] > early[0] { above(late, 0.5 * late[0]) } else { above(early, 0.0) };
    (late[0], longer.len())
}

/// Appends to a borrowed array.
#[data]
#[derive(Debug)]
pub struct Writer<'b> {
    buffer: &'b mut [u8],
    length: usize,
}

#[data]
impl<'b> Writer<'b> {
    /// Appends some bytes; returns false if there is no room.
    pub fn put(&mut self, bytes: &[u8]) -> bool {
        if bytes.len() > self.buffer.len() - self.length {
            return false;
        }
        for byte in bytes {
            self.buffer[self.length] = *byte;
            self.length += 1;
        }
        true
    }

    /// The bytes written so far.
    pub fn finish(self) -> &'b [u8] {
        &self.buffer[..self.length]
    }
}

/// Writes the answer to a packet: a length and some of its bytes.
#[function]
pub fn answer(packet: &[u8; 4], room: &mut [u8; 6]) -> u32 {
    let mut writer = Writer { buffer: room, length: 0 };
    let count = packet[0] % 8;
    let mut well = writer.put(&[count, 0]);
    well = well && writer.put(&packet[..usize::from(count).min(4)]);
    well = well && writer.put(&[packet[3]]);
    let written = writer.finish();
    let sum: u32 = written.iter().map(|byte| u32::from(*byte)).sum();
    if well { sum } else { 1000 + sum }
}

/// The gains of an axis.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    /// Gain of the error.
    pub proportional: f64,
    /// Gain of its integral.
    pub integral: f64,
}

/// A control loop with borrowed gains.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Loop<'g> {
    gains: &'g Gains,
    sum: f64,
}

#[data]
impl Loop<'_> {
    fn respond(&mut self, error: f64) -> f64 {
        self.sum += error;
        self.gains.proportional * error + self.gains.integral * self.sum
    }
}

/// A cascade of two loops; the second alternates between two sets of gains.
#[function]
pub fn cascade(outer: &Gains, inner: &Gains, error: f64) -> f64 {
    let mut first = Loop { gains: outer, sum: 0.0 };
    let before = first.gains;
    let rate = first.respond(error);
    if rate > 0.0 {
        first.gains = inner;
    }
    first.respond(rate) + before.integral
}

/// Stores measurements.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Store {
    values: [f64; 4],
    count: usize,
}

#[component]
impl Store {
    /// The measurements so far.
    fn held(&self) -> &[f64] {
        &self.values[..self.count.min(4)]
    }

    /// Stores a measurement; returns the largest one stored.
    #[entry]
    pub fn step(&mut self, value: f64) -> f64 {
        if self.count < 4 {
            self.values[self.count] = value;
            self.count += 1;
        }
        let mut most = f64::NEG_INFINITY;
        for value in self.held() {
            if *value > most {
                most = *value;
            }
        }
        most
    }
}
