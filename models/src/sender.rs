//! The downlink (thesis, §6.1, data sender): one packet a period, records in several packets.
//!
//! Payload of a part of a record: the record's period, four bytes; the choice of signals, one byte; which
//! part, one byte; its twelve values, in single precision. Twice a second the state of the link goes down in
//! between, and a parameter that was asked for goes before everything. Knows the link's packets, not what the
//! values mean.

use crate::gate::Refused;
use crate::logger::{Logger, Record, WIDTH};
use crate::packet::{MOST_PAYLOAD, Packet};
use crate::receiver::{Mode, Tally};
use bessemer::prelude::*;

/// A part of a record.
#[data]
pub const RECORD: u8 = 0x40;

/// The state of the link: see [`Status`].
#[data]
pub const STATUS: u8 = 0x41;

/// A parameter: its number, one byte; its value, or no number if there is no such parameter.
#[data]
pub const PARAMETER: u8 = 0x42;

/// Values in a packet.
#[data]
const VALUES: usize = 12;

/// Packets of a record.
#[data]
const PARTS: usize = WIDTH / VALUES;

/// Bytes before the values.
#[data]
const FRONT: usize = 6;

/// Bytes of a part of a record.
#[data]
const RECORD_BYTES: usize = 54;

/// Counts in the state of the link.
#[data]
const COUNTS: usize = 8;

/// Bytes of the state of the link.
#[data]
const STATUS_BYTES: usize = 35;

/// Bytes of a parameter.
#[data]
const PARAMETER_BYTES: usize = 9;

/// The state of the link goes down every so many periods.
#[data]
const STATUS_EVERY: u32 = 100;

/// How the link is: eight counts of four bytes, and what was asked for.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Status {
    /// How the packets fared.
    pub tally: Tally,
    /// Which did not get that far.
    pub refused: Refused,
    /// Records that were overwritten before they went down.
    pub lost: u32,
    /// The mode, one byte.
    pub mode: Mode,
    /// The trajectory, by the name that the ground gave it, one byte.
    pub tag: u8,
    /// Whether the ground is missed when it is silent, one byte.
    pub watched: bool,
}

/// A parameter to send down.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reply {
    /// Whether there is one.
    pub wanted: bool,
    /// Its number.
    pub number: u8,
    /// Its value.
    pub value: f64,
}

/// The data sender.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sender {
    /// The record that is being sent.
    pub record: Record,
    /// Which part of it is next; as many as it has when all are gone.
    pub part: usize,
    /// Whether a record is being sent.
    pub busy: bool,
    /// Number of the next packet.
    pub sequence: u16,
    /// Periods since the state of the link went down.
    pub since: u32,
}

#[component]
impl Sender {
    /// One period: the packet to send, if there is something to send.
    #[entry(infallible)]
    pub fn step(&mut self, logger: &mut Logger, status: &Status, reply: &Reply) -> Packet {
        self.since = self.since.saturating_add(1);
        let sequence = self.sequence;
        if reply.wanted {
            self.sequence = sequence.wrapping_add(1);
            return parameter(sequence, reply);
        }
        if self.since >= STATUS_EVERY {
            self.since = 0;
            self.sequence = sequence.wrapping_add(1);
            return state(sequence, status);
        }
        if !self.busy {
            if !logger.has_one() {
                return Packet::none();
            }
            self.record = logger.take();
            self.part = 0;
            self.busy = true;
        }
        let part = self.part.min(PARTS - 1);
        let packet = self.packet(part);
        self.sequence = sequence.wrapping_add(1);
        self.part = part + 1;
        self.busy = self.part < PARTS;
        packet
    }

    /// A part of the record, framed.
    fn packet(&self, part: usize) -> Packet {
        let mut payload = [0; MOST_PAYLOAD];
        put(&mut payload, 0, self.record.period);
        payload[4] = self.record.tag;
        payload[5] = part as u8;
        for value in 0..VALUES {
            let single = self.record.values[VALUES * part.min(PARTS - 1) + value] as f32;
            put(&mut payload, FRONT + 4 * value, single.to_bits());
        }
        Packet::around(RECORD, self.sequence, &payload, RECORD_BYTES)
    }
}

/// The state of the link, framed.
#[function]
fn state(sequence: u16, status: &Status) -> Packet {
    let counts = [
        status.tally.taken,
        status.tally.broken,
        status.tally.old,
        status.tally.senseless,
        status.refused.unsealed,
        status.refused.forged,
        status.refused.replayed,
        status.lost,
    ];
    let mut payload = [0; MOST_PAYLOAD];
    for n in 0..COUNTS {
        put(&mut payload, 4 * n, counts[n]);
    }
    payload[4 * COUNTS] = status.mode as u8;
    payload[4 * COUNTS + 1] = status.tag;
    payload[4 * COUNTS + 2] = status.watched as u8;
    Packet::around(STATUS, sequence, &payload, STATUS_BYTES)
}

/// A parameter, framed.
#[function]
fn parameter(sequence: u16, reply: &Reply) -> Packet {
    let mut payload = [0; MOST_PAYLOAD];
    payload[0] = reply.number;
    let bytes = reply.value.to_le_bytes();
    for n in 0..8 {
        payload[1 + n] = bytes[n];
    }
    Packet::around(PARAMETER, sequence, &payload, PARAMETER_BYTES)
}

/// Puts a word at `at`, least significant byte first; at the end, if it would not fit behind that.
#[function]
fn put(payload: &mut [u8; MOST_PAYLOAD], at: usize, word: u32) {
    let start = at.min(MOST_PAYLOAD - 4);
    let bytes = word.to_le_bytes();
    for n in 0..4 {
        payload[start + n] = bytes[n];
    }
}
