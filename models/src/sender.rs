//! Records on their way down (thesis, §6.1, data sender): a record in several packets, one packet a
//! period.
//!
//! Payload of a packet: the record's period, four bytes; which part of the record, one byte; its six
//! values, eight bytes each. Knows the link's packets, not what the values mean.

use crate::logger::{Logger, Record, WIDTH};
use crate::packet::Packet;
use bessemer::prelude::*;

/// A part of a record.
pub const RECORD: u8 = 0x40;

/// Values in a packet.
const VALUES: usize = 6;

/// Packets of a record.
const PARTS: usize = WIDTH / VALUES;

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
}

#[component]
impl Sender {
    /// One period: the packet to send, if there is something to send.
    #[entry(infallible)]
    pub fn step(&mut self, logger: &mut Logger) -> Packet {
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
        self.sequence = self.sequence.wrapping_add(1);
        self.part = part + 1;
        self.busy = self.part < PARTS;
        packet
    }

    /// A part of the record, framed.
    fn packet(&self, part: usize) -> Packet {
        let mut payload = [0; 56];
        let stamp = self.record.period.to_le_bytes();
        for n in 0..4 {
            payload[n] = stamp[n];
        }
        payload[4] = part as u8;
        for value in 0..VALUES {
            let bytes = self.record.values[VALUES * part.min(PARTS - 1) + value].to_le_bytes();
            for n in 0..8 {
                payload[5 + 8 * value + n] = bytes[n];
            }
        }
        Packet::around(RECORD, self.sequence, &payload, 53)
    }
}
