//! What the people on the ground send up, and what they make of what comes down.
//!
//! The other end of the link: it frames orders into packets, one a period, in the order of their times,
//! and puts the records of the onboard logger together again. Written against the description of the
//! packets, not with the models' code.

use models::packet::Packet;
use models::receiver::{
    COMMIT, GOODBYE, HELLO, LAND, MODE, Mode, POINT, STICKS, STOP, Sticks, TAKE_OFF,
};
use models::sender::RECORD;
use models::trajectory::SetPoint;
use std::collections::VecDeque;

/// Something to send.
#[derive(Clone, Debug, PartialEq)]
pub enum Order {
    /// Opens the link.
    Hello,
    /// Closes it.
    Goodbye,
    /// Changes the mode.
    Mode(Mode),
    /// Hands in a trajectory: several packets.
    Fly(Vec<SetPoint>),
    /// Takes off.
    TakeOff,
    /// Lands.
    Land,
    /// Moves the sticks.
    Sticks(Sticks),
    /// Stops the motors.
    Stop,
    /// Any bytes at all, to see what happens.
    Raw(Packet),
}

/// The ground station of one flight.
#[derive(Clone, Debug, Default)]
pub struct GroundStation {
    orders: VecDeque<(f64, Order)>,
    packets: VecDeque<Packet>,
    sequence: u16,
    parts: Vec<f64>,
    /// Every record that came down whole: its period and its values.
    pub records: Vec<(u32, Vec<f64>)>,
}

impl GroundStation {
    /// A ground station that sends each order from its time on, s.
    pub fn new(orders: &[(f64, Order)]) -> Self {
        Self { orders: orders.iter().cloned().collect(), ..Self::default() }
    }

    /// The packet to send in the period that begins at `time`, s.
    pub fn send(&mut self, time: f64) -> Packet {
        while self.orders.front().is_some_and(|(at, _)| *at <= time) {
            if let Some((_, order)) = self.orders.pop_front() {
                self.frame(&order);
            }
        }
        self.packets.pop_front().unwrap_or_default()
    }

    /// Takes in what came down.
    pub fn receive(&mut self, packet: &Packet) {
        let bytes = &packet.bytes[..packet.length.min(64)];
        let Some((head, payload)) = unframed(bytes) else { return };
        if head != RECORD || payload.len() != 53 {
            return;
        }
        let (stamp, rest) = payload.split_at(4);
        let (part, values) = rest.split_at(1);
        if usize::from(part[0]) * 6 != self.parts.len() {
            self.parts.clear();
            return;
        }
        self.parts.extend(values.chunks_exact(8).map(|eight| f64::from_le_bytes(fixed(eight))));
        if self.parts.len() == 36 {
            self.records.push((u32::from_le_bytes(fixed(stamp)), std::mem::take(&mut self.parts)));
        }
    }

    fn frame(&mut self, order: &Order) {
        match order {
            Order::Hello => self.push(HELLO, &[]),
            Order::Goodbye => self.push(GOODBYE, &[]),
            Order::Mode(mode) => self.push(MODE, &[*mode as u8]),
            Order::TakeOff => self.push(TAKE_OFF, &[]),
            Order::Land => self.push(LAND, &[]),
            Order::Stop => self.push(STOP, &[]),
            Order::Raw(packet) => self.packets.push_back(*packet),
            Order::Sticks(sticks) => {
                let Sticks { lean, yaw_rate, climb } = sticks;
                self.push(STICKS, &numbers(&[lean.x, lean.y, *yaw_rate, *climb]));
            }
            Order::Fly(points) => {
                for (index, point) in points.iter().enumerate() {
                    let SetPoint { time, position, yaw } = point;
                    let mut bytes = vec![index as u8];
                    bytes.extend(numbers(&[*time, position.x, position.y, position.z, *yaw]));
                    self.push(POINT, &bytes);
                }
                self.push(COMMIT, &[points.len() as u8]);
            }
        }
    }

    fn push(&mut self, kind: u8, payload: &[u8]) {
        self.sequence = self.sequence.wrapping_add(1);
        self.packets.push_back(framed(kind, self.sequence, payload));
    }
}

/// A packet around a payload of at most 56 bytes.
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

/// Kind and payload of a packet that came whole.
fn unframed(bytes: &[u8]) -> Option<(u8, &[u8])> {
    let (body, sum) = bytes.split_at_checked(bytes.len().checked_sub(2)?)?;
    let sound = body.starts_with(&[0xA5, 0x5A]) && crc(&body[2..]).to_le_bytes() == sum;
    let whole = body.len() > 5 && body.len() == 6 + usize::from(body[5]);
    (sound && whole).then(|| (body[2], &body[6..]))
}

/// CRC-16/CCITT, bit by bit from the highest.
fn crc(bytes: &[u8]) -> u16 {
    let step = |sum: u16| if sum >> 15 == 1 { (sum << 1) ^ 0x1021 } else { sum << 1 };
    bytes
        .iter()
        .fold(0xFFFF, |sum, byte| (0..8).fold(sum ^ u16::from(*byte) << 8, |sum, _| step(sum)))
}

fn numbers(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn fixed<const N: usize>(bytes: &[u8]) -> [u8; N] {
    let mut all = [0; N];
    all.copy_from_slice(bytes);
    all
}
