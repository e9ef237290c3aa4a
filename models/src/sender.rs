//! Downlink (thesis, §6.1, data sender): one packet per period; a record takes several packets.
//!
//! Payload of a part of a record: the record's period, four bytes; tag of the selection, one byte; number of the
//! part, one byte; twelve values in single precision. The state of the link is sent twice a second. A requested
//! parameter has priority over everything.

use crate::gate::Refused;
use crate::logger::{Logger, Record, WIDTH};
use crate::packet::{MAX_PAYLOAD, Packet};
use crate::receiver::{Mode, Tally};
use bessemer::prelude::*;

/// Kind of a packet with a part of a record.
#[data]
pub const RECORD: u8 = 0x40;

/// Kind of a packet with the state of the link.
#[data]
pub const STATUS: u8 = 0x41;

/// Kind of a packet with a parameter: its number, one byte; its value, NaN if there is no such parameter.
#[data]
pub const PARAMETER: u8 = 0x42;

/// Number of values in a packet.
#[data]
const VALUES_PER_PACKET: usize = 12;

/// Number of packets of a record.
#[data]
const PACKETS_PER_RECORD: usize = WIDTH / VALUES_PER_PACKET;

/// Size of the header before the values, bytes.
#[data]
const RECORD_HEADER_BYTES: usize = 6;

/// Payload of a part of a record, bytes.
#[data]
const RECORD_BYTES: usize = 54;

/// Number of counters in the state of the link.
#[data]
const STATUS_COUNTERS: usize = 8;

/// Payload of the state of the link, bytes.
#[data]
const STATUS_BYTES: usize = 35;

/// Payload of a parameter, bytes.
#[data]
const PARAMETER_BYTES: usize = 9;

/// Interval between two states of the link, in periods.
#[requirement("HLR-40")]
#[data]
const STATUS_INTERVAL: u32 = 100;

/// State of the link: eight counters of four bytes, mode, tag and heartbeat.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Status {
    /// Numbers of received packets by result.
    pub tally: Tally,
    /// Numbers of packets that the gate rejected.
    pub refused: Refused,
    /// Number of records overwritten before they were sent.
    pub lost: u32,
    /// Mode, one byte.
    pub mode: Mode,
    /// Tag of the trajectory, chosen by the ground station, one byte.
    pub tag: u8,
    /// True if heartbeats of the ground station are expected, one byte.
    pub watched: bool,
}

/// A parameter to send down.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reply {
    /// True if a reply is due.
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
    /// Record being sent.
    pub record: Record,
    /// Index of its next part; the number of parts when all are sent.
    pub part: usize,
    /// True while a record is being sent.
    pub busy: bool,
    /// Number of the next packet.
    pub sequence: u16,
    /// Number of periods since the state of the link was sent.
    pub status_age: u32,
}

#[component]
impl Sender {
    /// Advances one period and returns the packet to send, if any.
    #[requirement("HLR-40")]
    #[entry(infallible)]
    pub fn step(&mut self, logger: &mut Logger, status: &Status, reply: &Reply) -> Packet {
        self.status_age = self.status_age.saturating_add(1);
        let sequence = self.sequence;
        if reply.wanted {
            self.sequence = sequence.wrapping_add(1);
            return parameter(sequence, reply);
        }
        if self.status_age >= STATUS_INTERVAL {
            self.status_age = 0;
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
        let part = self.part.min(PACKETS_PER_RECORD - 1);
        let packet = self.packet(part);
        self.sequence = sequence.wrapping_add(1);
        self.part = part + 1;
        self.busy = self.part < PACKETS_PER_RECORD;
        packet
    }

    /// Returns a packet with one part of the record.
    fn packet(&self, part: usize) -> Packet {
        let mut payload = [0; MAX_PAYLOAD];
        put(&mut payload, 0, self.record.period);
        payload[4] = self.record.tag;
        payload[5] = part as u8;
        for value in 0..VALUES_PER_PACKET {
            let single = self.record.values
                [VALUES_PER_PACKET * part.min(PACKETS_PER_RECORD - 1) + value]
                as f32;
            put(&mut payload, RECORD_HEADER_BYTES + 4 * value, single.to_bits());
        }
        Packet::around(RECORD, self.sequence, &payload, RECORD_BYTES)
    }
}

/// Returns a packet with the state of the link.
#[function]
fn state(sequence: u16, status: &Status) -> Packet {
    let counts = [
        status.tally.accepted,
        status.tally.corrupt,
        status.tally.outdated,
        status.tally.invalid,
        status.refused.unsealed,
        status.refused.forged,
        status.refused.replayed,
        status.lost,
    ];
    let mut payload = [0; MAX_PAYLOAD];
    for n in 0..STATUS_COUNTERS {
        put(&mut payload, 4 * n, counts[n]);
    }
    payload[4 * STATUS_COUNTERS] = status.mode as u8;
    payload[4 * STATUS_COUNTERS + 1] = status.tag;
    payload[4 * STATUS_COUNTERS + 2] = status.watched as u8;
    Packet::around(STATUS, sequence, &payload, STATUS_BYTES)
}

/// Returns a packet with a parameter.
#[function]
fn parameter(sequence: u16, reply: &Reply) -> Packet {
    let mut payload = [0; MAX_PAYLOAD];
    payload[0] = reply.number;
    let bytes = reply.value.to_le_bytes();
    for n in 0..8 {
        payload[1 + n] = bytes[n];
    }
    Packet::around(PARAMETER, sequence, &payload, PARAMETER_BYTES)
}

/// Writes a word at `at`, least significant byte first; at the end of the payload if it does not fit.
#[function]
fn put(payload: &mut [u8; MAX_PAYLOAD], at: usize, word: u32) {
    let start = at.min(MAX_PAYLOAD - 4);
    let bytes = word.to_le_bytes();
    for n in 0..4 {
        payload[start + n] = bytes[n];
    }
}
