//! Keeps out the packets of those who do not have the key.
//!
//! A sealed packet has two things behind its payload: a counter of six bytes, the sender's milliseconds
//! since 1970 or one more than the last, and the [`sip_hash`] over everything from the kind to the counter.
//! It lets the packet through without them, as it would be on a link without a key. Knows neither
//! what the packets say nor where they come from.

use crate::packet::{HEADER, MOST_PAYLOAD, Packet, START};
use crate::receiver::STOP;
use crate::siphash::{Key, sip_hash};
use bessemer::prelude::*;

/// Bytes of the counter.
#[data]
pub const COUNTER: usize = 6;

/// Bytes of the counter and of the sum.
#[data]
pub const SEAL: usize = 14;

/// So much older than the last packet, ms, a STOP is still taken: it may have been overtaken. Whoever
/// repeats one within that time stops what has been stopped.
#[data]
pub const OVERTAKEN: u64 = 2000;

/// How many packets were kept out, and why.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Refused {
    /// Too short to be sealed, or no packets at all.
    pub unsealed: u32,
    /// The sum is not that of the key.
    pub forged: u32,
    /// Sealed with the key, but not newer than one that was let through.
    pub replayed: u32,
}

/// The gate.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gate {
    /// The counter of the newest packet that was let through.
    pub counter: u64,
    /// What was not.
    pub refused: Refused,
}

#[component]
impl Gate {
    /// The packet without its seal; none, if it is kept out. Without a key everything passes as it is.
    #[entry(infallible)]
    pub fn step(&mut self, key: &Key, packet: &Packet) -> Packet {
        if !key.given {
            return *packet;
        }
        let whole = packet.size().min(MOST_PAYLOAD);
        if !packet.is_sound() || whole < SEAL {
            self.refused.unsealed = self.refused.unsealed.saturating_add(1);
            return Packet::none();
        }
        let size = whole - SEAL;
        let sum = packet.word(size + COUNTER);
        if sip_hash(key, &packet.bytes, START, HEADER + size + COUNTER) != sum {
            self.refused.forged = self.refused.forged.saturating_add(1);
            return Packet::none();
        }
        // The two bytes above the counter are the sum's.
        let counter = packet.word(size) & 0xFFFF_FFFF_FFFF;
        let late = packet.kind() == STOP && counter.saturating_add(OVERTAKEN) > self.counter;
        if counter <= self.counter && !late {
            self.refused.replayed = self.refused.replayed.saturating_add(1);
            return Packet::none();
        }
        self.counter = self.counter.max(counter);
        let mut payload = [0; MOST_PAYLOAD];
        for n in 0..MOST_PAYLOAD {
            if n < size {
                payload[n] = packet.byte(n);
            }
        }
        Packet::around(packet.kind(), packet.sequence(), &payload, size)
    }
}
