//! A simulated ground station, which sends commands and receives telemetry.
//!
//! It converts commands to packets, at most one in a period, in their order, and assembles the records
//! of the onboard logger. Written from the description of the packets, not with the models' code.

use models::packet::Packet;
use models::receiver::{
    ARM, ASK, CHOOSE, COMMIT, DISARM, GOODBYE, HEARTBEAT, HELLO, LAND, MODE, Mode, POINT, SET,
    STICKS, STOP, Sticks, TAKE_OFF,
};
use models::sender::{PARAMETER, RECORD, STATUS};
use models::trajectory::SetPoint;
use std::collections::VecDeque;

/// A command to be sent.
#[derive(Clone, Debug, PartialEq)]
pub enum Order {
    /// Opens the link.
    Hello,
    /// Closes the link.
    Goodbye,
    /// Changes the mode.
    Mode(Mode),
    /// Sends a trajectory, in several packets.
    Fly(Vec<SetPoint>),
    /// Sends a trajectory with a number, by which it can be recognised in flight.
    FlyAs(u8, Vec<SetPoint>),
    /// Takes off.
    TakeOff,
    /// Lands.
    Land,
    /// Moves the sticks.
    Sticks(Sticks),
    /// Stops the motors.
    Stop,
    /// Sends a heartbeat.
    Beat,
    /// Arms the aircraft for another flight.
    Arm,
    /// Disarms the aircraft on the ground.
    Disarm,
    /// Requests a parameter by its number.
    Ask(u8),
    /// Sets a parameter.
    Set(u8, f64),
    /// Selects the signals of the records: a number for the selection, the number of periods between records, and the
    /// signals.
    Choose(u8, u8, [u8; 36]),
    /// Arbitrary bytes, for tests of invalid packets.
    Raw(Packet),
}

/// Converts commands to packets, which are numbered in order.
#[derive(Clone, Debug, Default)]
pub struct Framer {
    sequence: u16,
}

impl Framer {
    /// Returns the packets of a command.
    pub fn frame(&mut self, order: &Order) -> Vec<Packet> {
        match order {
            Order::Hello => vec![self.packet(HELLO, &[])],
            Order::Goodbye => vec![self.packet(GOODBYE, &[])],
            Order::Mode(mode) => vec![self.packet(MODE, &[*mode as u8])],
            Order::TakeOff => vec![self.packet(TAKE_OFF, &[])],
            Order::Land => vec![self.packet(LAND, &[])],
            Order::Stop => vec![self.packet(STOP, &[])],
            Order::Raw(packet) => vec![*packet],
            Order::Sticks(sticks) => {
                let Sticks { lean, yaw_rate, climb } = sticks;
                vec![self.packet(STICKS, &numbers(&[lean.x, lean.y, *yaw_rate, *climb]))]
            }
            Order::Beat => vec![self.packet(HEARTBEAT, &[])],
            Order::Arm => vec![self.packet(ARM, &[])],
            Order::Disarm => vec![self.packet(DISARM, &[])],
            Order::Ask(number) => vec![self.packet(ASK, &[*number])],
            Order::Set(number, value) => {
                let payload = [vec![*number], numbers(&[*value])].concat();
                vec![self.packet(SET, &payload)]
            }
            Order::Choose(tag, every, signals) => {
                let payload = [&[*tag, *every], signals.as_slice()].concat();
                vec![self.packet(CHOOSE, &payload)]
            }
            Order::Fly(points) => self.trajectory(0, points),
            Order::FlyAs(tag, points) => self.trajectory(*tag, points),
        }
    }

    fn trajectory(&mut self, tag: u8, points: &[SetPoint]) -> Vec<Packet> {
        let mut packets = Vec::new();
        for (index, point) in points.iter().enumerate() {
            let SetPoint { time, position, yaw } = point;
            let mut bytes = vec![tag, index as u8];
            bytes.extend(numbers(&[*time, position.x, position.y, position.z, *yaw]));
            packets.push(self.packet(POINT, &bytes));
        }
        packets.push(self.packet(COMMIT, &[points.len() as u8, tag]));
        packets
    }

    fn packet(&mut self, kind: u8, payload: &[u8]) -> Packet {
        self.sequence = self.sequence.wrapping_add(1);
        framed(kind, self.sequence, payload)
    }
}

/// One moment recorded by the onboard logger.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Number of periods since the software began.
    pub period: u32,
    /// Number of the selection of signals.
    pub tag: u8,
    /// Values of the signals, in single precision.
    pub values: Vec<f32>,
}

/// State of the link as the aircraft reports it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Status {
    /// Counters of packets: accepted, corrupt, outdated, invalid, unsealed, forged, replayed; and of lost records.
    pub counts: [u32; 8],
    /// Number of the flight mode.
    pub mode: u8,
    /// Number of the active trajectory.
    pub tag: u8,
    /// True if heartbeats of the ground station are expected.
    pub watched: bool,
}

/// Contents of the downlink.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// A complete record.
    Record(Record),
    /// State of the link.
    Status(Status),
    /// The number and the value of a parameter.
    Parameter(u8, f64),
}

/// Assembles records from packets, since a record has several parts.
#[derive(Clone, Debug, Default)]
pub struct Collector {
    record: Record,
}

impl Collector {
    /// Processes a packet; returns what it completes.
    pub fn take(&mut self, packet: &Packet) -> Option<News> {
        let bytes = &packet.bytes[..packet.length.min(64)];
        let (head, payload) = unframed(bytes)?;
        match (head, payload.len()) {
            (RECORD, 54) => self.part(payload).map(News::Record),
            (STATUS, 35) => {
                let mut counts = [0; 8];
                for (count, four) in counts.iter_mut().zip(payload.chunks_exact(4)) {
                    *count = u32::from_le_bytes(fixed(four));
                }
                let (mode, tag, watched) = (payload[32], payload[33], payload[34] != 0);
                Some(News::Status(Status { counts, mode, tag, watched }))
            }
            (PARAMETER, 9) => {
                Some(News::Parameter(payload[0], f64::from_le_bytes(fixed(&payload[1..]))))
            }
            _ => None,
        }
    }

    /// Adds a part of a record; returns the record, if this is the last part and none is missing.
    fn part(&mut self, payload: &[u8]) -> Option<Record> {
        let (stamp, values) = payload.split_at(6);
        let (period, tag) = (u32::from_le_bytes(fixed(&stamp[..4])), stamp[4]);
        if stamp[5] == 0 {
            self.record = Record { period, tag, values: Vec::with_capacity(36) };
        }
        let record = &mut self.record;
        if usize::from(stamp[5]) * 12 != record.values.len() || record.period != period {
            record.values.clear();
            return None;
        }
        record.values.extend(values.chunks_exact(4).map(|four| f32::from_le_bytes(fixed(four))));
        (record.values.len() == 36).then(|| std::mem::take(record))
    }
}

/// The simulated ground station of one flight.
#[derive(Clone, Debug, Default)]
pub struct GroundStation {
    packets: VecDeque<Packet>,
    framer: Framer,
    collector: Collector,
    /// All complete records.
    pub records: Vec<Record>,
}

impl GroundStation {
    /// Queues the packets of a command.
    pub fn order(&mut self, order: &Order) {
        self.packets.extend(self.framer.frame(order));
    }

    /// Returns the packet to send in the next period; an empty one if nothing is queued.
    pub fn send(&mut self) -> Packet {
        self.packets.pop_front().unwrap_or_default()
    }

    /// Processes a received packet.
    pub fn receive(&mut self, packet: &Packet) {
        if let Some(News::Record(record)) = self.collector.take(packet) {
            self.records.push(record);
        }
    }
}

/// Builds a packet with a payload of at most 56 bytes.
pub fn framed(kind: u8, sequence: u16, payload: &[u8]) -> Packet {
    let mut bytes = vec![0xA5, 0x5A, kind];
    bytes.extend(sequence.to_le_bytes());
    bytes.push(payload.len() as u8);
    bytes.extend(payload);
    bytes.extend(crc(&bytes[2..]).to_le_bytes());
    let mut packet = Packet { length: bytes.len(), bytes: [0; 64] };
    packet.bytes[..bytes.len()].copy_from_slice(&bytes);
    packet
}

/// Returns kind and payload of a valid packet.
pub fn unframed(bytes: &[u8]) -> Option<(u8, &[u8])> {
    let (body, sum) = bytes.split_at_checked(bytes.len().checked_sub(2)?)?;
    let sound = body.starts_with(&[0xA5, 0x5A]) && crc(&body[2..]).to_le_bytes() == sum;
    let whole = body.len() > 5 && body.len() == 6 + usize::from(body[5]);
    (sound && whole).then(|| (body[2], &body[6..]))
}

/// Remainders of CRC-16/CCITT for each byte.
const REMAINDERS: [u16; 256] = {
    let mut all = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut sum = (byte as u16) << 8;
        let mut bit = 0;
        while bit < 8 {
            sum = if sum >> 15 == 1 { (sum << 1) ^ 0x1021 } else { sum << 1 };
            bit += 1;
        }
        all[byte] = sum;
        byte += 1;
    }
    all
};

/// Computes CRC-16/CCITT byte by byte, from the most significant bit.
fn crc(bytes: &[u8]) -> u16 {
    let step = |sum: u16, byte: &u8| (sum << 8) ^ REMAINDERS[usize::from((sum >> 8) as u8 ^ byte)];
    bytes.iter().fold(0xFFFF, step)
}

fn numbers(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn fixed<const N: usize>(bytes: &[u8]) -> [u8; N] {
    let mut all = [0; N];
    all.copy_from_slice(bytes);
    all
}
