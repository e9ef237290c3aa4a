//! Authentication of packets: rejects packets that are not sealed with the key.
//!
//! A sealed packet has two fields after its payload. The first is a counter of six bytes: the sender's milliseconds
//! since 1970, or one more than the last counter. The second is the SipHash of everything from the kind to the
//! counter. An accepted packet is returned without these fields. The contents and the source of the packets are
//! unknown here.

use crate::packet::{CHECKSUM_START, HEADER_BYTES, MAX_PAYLOAD, Packet};
use crate::receiver::STOP;
use crate::siphash::{Key, sip_hash};
use bessemer::prelude::*;

/// Size of the counter, bytes.
#[data]
pub const COUNTER_BYTES: usize = 6;

/// Size of the counter and the checksum, bytes.
#[data]
pub const SEAL_BYTES: usize = 14;

/// Age, relative to the last packet, up to which a STOP is accepted, ms: it may have been overtaken. A repeated STOP
/// within that time stops the motors again.
#[requirement("HLR-28")]
#[data]
pub const STOP_MAX_AGE: u64 = 2000;

/// Numbers of rejected packets by cause.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Refused {
    /// Packets too short to be sealed, or malformed.
    pub unsealed: u32,
    /// Packets whose checksum does not match the key.
    pub forged: u32,
    /// Packets that are sealed but not newer than the last accepted one.
    pub replayed: u32,
}

/// The authentication gate.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gate {
    /// Counter of the newest accepted packet.
    pub counter: u64,
    /// Rejected packets.
    pub refused: Refused,
}

#[component]
impl Gate {
    /// Returns the packet without its seal, or no packet if it is rejected. Without a key each packet passes unchanged.
    #[requirement("HLR-28", "HLR-29")]
    #[entry(infallible)]
    pub fn step(&mut self, key: &Key, packet: &Packet) -> Packet {
        if !key.is_set {
            return *packet;
        }
        let whole = packet.size().min(MAX_PAYLOAD);
        if !packet.is_sound() || whole < SEAL_BYTES {
            self.refused.unsealed = self.refused.unsealed.saturating_add(1);
            return Packet::none();
        }
        let size = whole - SEAL_BYTES;
        let sum = packet.word(size + COUNTER_BYTES);
        if sip_hash(key, &packet.bytes, CHECKSUM_START, HEADER_BYTES + size + COUNTER_BYTES) != sum
        {
            self.refused.forged = self.refused.forged.saturating_add(1);
            return Packet::none();
        }
        // The two bytes above the counter belong to the checksum.
        let counter = packet.word(size) & 0xFFFF_FFFF_FFFF;
        let late = packet.kind() == STOP && counter.saturating_add(STOP_MAX_AGE) > self.counter;
        if counter <= self.counter && !late {
            self.refused.replayed = self.refused.replayed.saturating_add(1);
            return Packet::none();
        }
        self.counter = self.counter.max(counter);
        let mut payload = [0; MAX_PAYLOAD];
        for n in 0..MAX_PAYLOAD {
            if n < size {
                payload[n] = packet.byte(n);
            }
        }
        Packet::around(packet.kind(), packet.sequence(), &payload, size)
    }
}
