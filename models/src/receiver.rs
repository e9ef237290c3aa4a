//! What the ground asks for, packet by packet (thesis, §6.1, command receiver).
//!
//! A packet that is not sound, not new, not known or not sensible is dropped and counted; what was asked
//! before stays. A new trajectory is collected beside the one that is flown and takes its place as a
//! whole. Knows how orders are written, not how they are carried out.

use crate::packet::{MOST_BYTES, Packet};
use crate::trajectory::{MOST_POINTS, SetPoint, Space, Trajectory};
use bessemer::prelude::*;

/// Opens the link: always taken, and the numbering begins with it.
pub const HELLO: u8 = 1;
/// Closes the link: nothing is sent down any more.
pub const GOODBYE: u8 = 2;
/// A [`Mode`], one byte.
pub const MODE: u8 = 3;
/// A set point: its index, one byte; time, x, y, z, yaw.
pub const POINT: u8 = 4;
/// Flies the collected trajectory: how many points, one byte.
pub const COMMIT: u8 = 5;
/// Takes off.
pub const TAKE_OFF: u8 = 6;
/// Lands.
pub const LAND: u8 = 7;
/// Sticks: roll, pitch, rate of yaw, rate of climb.
pub const STICKS: u8 = 8;
/// Stops the motors at once.
pub const STOP: u8 = 9;

/// Who decides where the aircraft goes.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// The trajectory, by the closed loop.
    #[default]
    ClosedLoop,
    /// The trajectory, by the closed loop and the feed-forward.
    FeedForward,
    /// A pilot with sticks.
    Manual,
}

/// What a pilot's sticks ask for.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sticks {
    /// Roll and pitch, rad.
    pub lean: Vector2<f64>,
    /// Rate of yaw, rad/s.
    pub yaw_rate: f64,
    /// Rate of climb, m/s.
    pub climb: f64,
}

#[data]
impl Sticks {
    /// Nobody's hands on them.
    pub fn centred() -> Sticks {
        Sticks { lean: Vector2::zeros(), yaw_rate: 0.0, climb: 0.0 }
    }
}

/// Everything that the ground has asked for.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Orders {
    /// Who decides.
    pub mode: Mode,
    /// Whether to fly.
    pub take_off: bool,
    /// Whether to land.
    pub land: bool,
    /// Whether to stop the motors.
    pub stop: bool,
    /// Whether anyone listens.
    pub link: bool,
    /// Where to go.
    pub trajectory: Trajectory,
    /// The sticks.
    pub sticks: Sticks,
    /// How old they are, s.
    pub sticks_age: f64,
}

/// How many packets came to what.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Taken.
    pub taken: u32,
    /// Not packets: marks, length or checksum wrong.
    pub broken: u32,
    /// Not newer than the last one.
    pub old: u32,
    /// Of no known kind, or with content that makes no sense.
    pub senseless: u32,
}

/// The largest lean, rad, rate of yaw, rad/s, and rate of climb, m/s, that sticks can ask for.
const STICK_LIMITS: [f64; 3] = [0.35, 2.0, 0.5];

/// The command receiver.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Receiver {
    /// What is to be done.
    pub orders: Orders,
    /// How the packets fared.
    pub tally: Tally,
    /// The trajectory that is being collected.
    pub collected: Trajectory,
    /// Number of the last packet.
    pub last: u16,
    /// Whether there was one.
    pub heard: bool,
}

#[component]
impl Receiver {
    /// One period, s, with the packet that came in it, if one came.
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, space: &Space, packet: &Packet) {
        self.orders.sticks_age += period;
        if packet.length == 0 {
            return;
        }
        if packet.length > MOST_BYTES || !packet.is_sound() {
            self.tally.broken = self.tally.broken.saturating_add(1);
            return;
        }
        let ahead = packet.sequence().wrapping_sub(self.last);
        let newer = ahead > 0 && ahead < 0x8000;
        if self.heard && !newer && packet.kind() != HELLO {
            self.tally.old = self.tally.old.saturating_add(1);
            return;
        }
        self.heard = true;
        self.last = packet.sequence();
        if self.take(space, packet) {
            self.tally.taken = self.tally.taken.saturating_add(1);
        } else {
            self.tally.senseless = self.tally.senseless.saturating_add(1);
        }
    }

    /// Does what the packet asks for; whether it made sense.
    fn take(&mut self, space: &Space, packet: &Packet) -> bool {
        let size = packet.size();
        match packet.kind() {
            HELLO if size == 0 => self.orders.link = true,
            GOODBYE if size == 0 => self.orders.link = false,
            TAKE_OFF if size == 0 => {
                let ready = self.orders.trajectory.is_sound(space);
                self.orders.take_off = self.orders.take_off || ready;
                return ready;
            }
            LAND if size == 0 => self.orders.land = true,
            STOP if size == 0 => self.orders.stop = true,
            MODE if size == 1 => return self.take_mode(packet.byte(0)),
            POINT if size == 41 => return self.collect(space, packet),
            COMMIT if size == 1 => return self.commit(space, packet.byte(0) as usize),
            STICKS if size == 32 => return self.take_sticks(packet),
            _ => return false,
        }
        true
    }

    /// A mode by its number.
    fn take_mode(&mut self, number: u8) -> bool {
        match number {
            0 => self.orders.mode = Mode::ClosedLoop,
            1 => self.orders.mode = Mode::FeedForward,
            2 => self.orders.mode = Mode::Manual,
            _ => return false,
        }
        true
    }

    /// Puts a set point into the trajectory that is being collected.
    fn collect(&mut self, space: &Space, packet: &Packet) -> bool {
        let index = packet.byte(0) as usize;
        let place = Vector3::new(packet.number(9), packet.number(17), packet.number(25));
        let point = SetPoint { time: packet.number(1), position: place, yaw: packet.number(33) };
        if index >= MOST_POINTS || !point.is_inside(space) {
            return false;
        }
        self.collected.points[index] = point;
        true
    }

    /// Flies the collected trajectory from now on, if it is sound.
    fn commit(&mut self, space: &Space, count: usize) -> bool {
        let mut wanted = self.collected;
        wanted.count = count;
        if !wanted.is_sound(space) {
            return false;
        }
        self.orders.trajectory = wanted;
        true
    }

    /// Sticks, within what they may ask for.
    fn take_sticks(&mut self, packet: &Packet) -> bool {
        let roll = packet.number(0);
        let pitch = packet.number(8);
        let yaw_rate = packet.number(16);
        let climb = packet.number(24);
        if !(roll + pitch + yaw_rate + climb).is_finite() {
            return false;
        }
        let [lean, turn, rise] = STICK_LIMITS;
        self.orders.sticks = Sticks {
            lean: Vector2::new(within(roll, lean), within(pitch, lean)),
            yaw_rate: within(yaw_rate, turn),
            climb: within(climb, rise),
        };
        self.orders.sticks_age = 0.0;
        true
    }
}

/// The value, or the limit that it exceeds.
#[function]
fn within(value: f64, limit: f64) -> f64 {
    value.max(-limit).min(limit)
}
