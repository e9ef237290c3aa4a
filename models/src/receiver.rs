//! Receiver of the ground station's commands, packet by packet (thesis, §6.1, command receiver).
//!
//! A packet that is corrupt, outdated, unknown or invalid is dropped and counted; earlier commands stay in force.
//! STOP is accepted at any age. A new trajectory is collected separately and replaces the active one as a whole.
//! Carrying out the commands is up to other modules.

use crate::logger::{Choice, WIDTH};
use crate::packet::{MAX_BYTES, Packet};
use crate::trajectory::{MAX_POINTS, SetPoint, Space, Trajectory};
use bessemer::prelude::*;

/// Opens the link: always accepted, and restarts the sequence numbers.
#[data]
pub const HELLO: u8 = 1;
/// Closes the link: the downlink stops.
#[data]
pub const GOODBYE: u8 = 2;
/// Sets the mode, one byte.
#[data]
pub const MODE: u8 = 3;
/// Adds a set point: tag of its trajectory, one byte; its index, one byte; time, x, y, z, yaw.
#[data]
pub const POINT: u8 = 4;
/// Activates the collected trajectory: number of points, one byte; its tag, one byte.
#[data]
pub const COMMIT: u8 = 5;
/// Takes off.
#[data]
pub const TAKE_OFF: u8 = 6;
/// Lands.
#[data]
pub const LAND: u8 = 7;
/// Sticks: roll, pitch, yaw rate, climb rate.
#[data]
pub const STICKS: u8 = 8;
/// Stops the motors at once.
#[data]
pub const STOP: u8 = 9;
/// Heartbeat of the ground station. After the first one, silence counts as a lost link.
#[data]
pub const HEARTBEAT: u8 = 10;
/// Prepares another flight; ignored unless the aircraft is at rest on the ground.
#[data]
pub const ARM: u8 = 11;
/// Requests a parameter: its number, one byte.
#[data]
pub const ASK: u8 = 12;
/// Sets a parameter: its number, one byte; its value.
#[data]
pub const SET: u8 = 13;
/// Selects the logged signals: tag and period of the selection, then each signal, one byte each.
#[data]
pub const CHOOSE: u8 = 14;
/// Disarms: no take-off until the next arming; ignored in flight.
#[data]
pub const DISARM: u8 = 15;

/// Payload of a mode packet, bytes.
#[data]
pub const MODE_BYTES: usize = 1;
/// Payload of a commit packet, bytes: number of points and tag.
#[data]
pub const COMMIT_BYTES: usize = 2;
/// Payload of a query packet, bytes: a parameter.
#[data]
pub const ASK_BYTES: usize = 1;
/// Payload of a set point packet, bytes: tag, index and five numbers.
#[data]
pub const POINT_BYTES: usize = 42;
/// Payload of a sticks packet, bytes: four numbers.
#[data]
pub const STICKS_BYTES: usize = 32;
/// Payload of a parameter packet, bytes: a parameter and a number.
#[data]
pub const SET_BYTES: usize = 9;
/// Payload of a selection packet, bytes: tag, period and one byte for each signal.
#[data]
pub const CHOOSE_BYTES: usize = 38;

/// Age of a message that was never received, s: larger than any timeout.
#[data]
pub const NEVER: f64 = 1e9;

/// Source of the target.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Trajectory, by the closed loop.
    #[default]
    ClosedLoop,
    /// Trajectory, by the closed loop and the feed-forward.
    FeedForward,
    /// Sticks of a pilot.
    Manual,
}

/// Setpoints of a pilot's sticks.
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
    /// Returns centred sticks.
    pub fn centred() -> Sticks {
        Sticks { lean: Vector2::zeros(), yaw_rate: 0.0, climb: 0.0 }
    }
}

/// Request concerning the settings, which the receiver does not own.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Request {
    /// No request.
    #[default]
    Nothing,
    /// Query of a parameter.
    Ask,
    /// Change of a parameter.
    Set,
    /// Change of the logged signals.
    Choose,
}

/// Request of one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wish {
    /// Kind of the request.
    pub request: Request,
    /// The parameter's number: see [`crate::tuning`].
    pub number: u8,
    /// Requested value.
    pub value: f64,
    /// Requested selection of logged signals.
    pub choice: Choice,
}

/// Commands of the ground station.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orders {
    /// Source of the target.
    pub mode: Mode,
    /// True if take-off is commanded.
    pub take_off: bool,
    /// True if landing is commanded.
    pub land: bool,
    /// True if the motors are commanded to stop.
    pub stop: bool,
    /// True in the period in which preparation of another flight is commanded.
    pub arm: bool,
    /// True in the period in which disarming is commanded.
    pub disarm: bool,
    /// True if the link is open.
    pub link: bool,
    /// True if the ground station has announced heartbeats.
    pub watched: bool,
    /// Time since the last accepted packet, s.
    pub silence: f64,
    /// Trajectory to follow.
    pub trajectory: Trajectory,
    /// Tag of the trajectory.
    pub tag: u8,
    /// Setpoints of the sticks.
    pub sticks: Sticks,
    /// Age of the sticks, s.
    pub sticks_age: f64,
}

impl Default for Orders {
    /// Returns the initial commands: nothing commanded, sticks never received.
    fn default() -> Self {
        Orders {
            mode: Mode::ClosedLoop,
            take_off: false,
            land: false,
            stop: false,
            arm: false,
            disarm: false,
            link: false,
            watched: false,
            silence: NEVER,
            trajectory: Trajectory::default(),
            tag: 0,
            sticks: Sticks::centred(),
            sticks_age: NEVER,
        }
    }
}

/// Numbers of packets by result.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Accepted packets.
    pub accepted: u32,
    /// Corrupt packets: sync bytes, length or checksum wrong.
    pub corrupt: u32,
    /// Packets not newer than the last one.
    pub outdated: u32,
    /// Invalid packets: unknown kind, or invalid content.
    pub invalid: u32,
}

/// Limits of the sticks: tilt, rad, yaw rate, rad/s, and climb rate, m/s.
#[requirement("HLR-31")]
#[data]
const STICK_LIMITS: [f64; 3] = [0.35, 2.0, 0.5];

/// The command receiver.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Receiver {
    /// Present commands.
    pub orders: Orders,
    /// Request concerning the settings in this period.
    pub wish: Wish,
    /// Numbers of packets by result.
    pub tally: Tally,
    /// Trajectory being collected.
    pub collected: Trajectory,
    /// Tag of the trajectory being collected.
    pub collecting: u8,
    /// Points received so far, one bit each.
    pub received: u32,
    /// Sequence number of the last accepted packet.
    pub last: u16,
    /// True if a packet has been accepted.
    pub has_last: bool,
}

#[component]
impl Receiver {
    /// Advances one period, s, and processes the packet received in it, if any.
    #[requirement("HLR-17", "HLR-27", "HLR-28")]
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, space: &Space, packet: &Packet) {
        self.orders.sticks_age += period;
        self.orders.silence += period;
        self.orders.arm = false;
        self.orders.disarm = false;
        self.wish.request = Request::Nothing;
        if packet.length == 0 {
            return;
        }
        if packet.length > MAX_BYTES || !packet.is_sound() {
            self.tally.corrupt = self.tally.corrupt.saturating_add(1);
            return;
        }
        let hello = packet.kind() == HELLO && packet.size() == 0;
        let stop = packet.kind() == STOP && packet.size() == 0;
        let newer = self.is_newer(packet.sequence());
        if !newer && !hello && !stop {
            self.tally.outdated = self.tally.outdated.saturating_add(1);
            return;
        }
        if !self.take(space, packet) {
            self.tally.invalid = self.tally.invalid.saturating_add(1);
            return;
        }
        self.tally.accepted = self.tally.accepted.saturating_add(1);
        self.orders.silence = 0.0;
        if newer || hello {
            self.has_last = true;
            self.last = packet.sequence();
        }
    }

    /// Clears the commands before another flight.
    #[entry(infallible)]
    pub fn forget(&mut self) {
        self.orders.take_off = false;
        self.orders.land = false;
        self.orders.stop = false;
    }

    /// Returns true if a sequence number is ahead of the last one by less than half the range.
    #[requirement("HLR-28")]
    fn is_newer(&self, number: u16) -> bool {
        let ahead = number.wrapping_sub(self.last);
        !self.has_last || (ahead > 0 && ahead < 0x8000)
    }

    /// Executes a packet; returns true if it is valid.
    #[requirement("HLR-27")]
    fn take(&mut self, space: &Space, packet: &Packet) -> bool {
        let kind = packet.kind();
        let size = packet.size();
        if size == 0 {
            return self.take_bare(space, kind);
        }
        if kind == MODE && size == MODE_BYTES {
            return self.take_mode(packet.byte(0));
        }
        if kind == POINT && size == POINT_BYTES {
            return self.collect(space, packet);
        }
        if kind == COMMIT && size == COMMIT_BYTES {
            return self.commit(space, packet);
        }
        if kind == STICKS && size == STICKS_BYTES {
            return self.take_sticks(packet);
        }
        if kind == ASK && size == ASK_BYTES {
            return self.wish_for(Request::Ask, packet);
        }
        if kind == SET && size == SET_BYTES {
            return self.wish_for(Request::Set, packet);
        }
        if kind == CHOOSE && size == CHOOSE_BYTES {
            return self.choose(packet);
        }
        false
    }

    /// Executes a packet without payload; returns true if its kind is known.
    #[requirement("HLR-33", "HLR-34")]
    fn take_bare(&mut self, space: &Space, kind: u8) -> bool {
        if kind == TAKE_OFF {
            let ready = self.orders.trajectory.is_sound(space);
            self.orders.take_off = self.orders.take_off || ready;
            return ready;
        }
        if kind == HELLO {
            self.orders.link = true;
            // Another ground station may use the same tags: discard the points collected so far.
            self.received = 0;
        } else if kind == GOODBYE {
            self.orders.link = false;
            self.orders.watched = false;
        } else if kind == LAND {
            self.orders.land = true;
        } else if kind == STOP {
            self.orders.stop = true;
        } else if kind == HEARTBEAT {
            self.orders.watched = true;
        } else if kind == ARM {
            self.orders.arm = true;
        } else if kind == DISARM {
            self.orders.disarm = true;
        } else {
            return false;
        }
        true
    }

    /// Sets the mode by its number; returns true if there is such a mode.
    fn take_mode(&mut self, number: u8) -> bool {
        match number {
            0 => self.orders.mode = Mode::ClosedLoop,
            1 => self.orders.mode = Mode::FeedForward,
            2 => self.orders.mode = Mode::Manual,
            _ => return false,
        }
        true
    }

    /// Stores a set point in the trajectory being collected; returns true if it is valid. A new tag starts a new
    /// trajectory.
    #[requirement("HLR-30")]
    fn collect(&mut self, space: &Space, packet: &Packet) -> bool {
        let name = packet.byte(0);
        let index = packet.byte(1) as usize;
        let place = Vector3::new(packet.number(10), packet.number(18), packet.number(26));
        let point = SetPoint { time: packet.number(2), position: place, yaw: packet.number(34) };
        if index >= MAX_POINTS || !point.is_inside(space) {
            return false;
        }
        if name != self.collecting {
            self.collecting = name;
            self.received = 0;
        }
        self.collected.points[index] = point;
        self.received |= 1 << index;
        true
    }

    /// Activates the collected trajectory if it is valid and complete; returns true if so. The next one starts empty.
    #[requirement("HLR-30")]
    fn commit(&mut self, space: &Space, packet: &Packet) -> bool {
        let count = packet.byte(0) as usize;
        let mut wanted = self.collected;
        wanted.count = count;
        if packet.byte(1) != self.collecting || !wanted.is_sound(space) {
            return false;
        }
        for n in 0..MAX_POINTS {
            if n < count && self.received & (1 << n) == 0 {
                return false;
            }
        }
        self.orders.trajectory = wanted;
        self.orders.tag = self.collecting;
        self.received = 0;
        true
    }

    /// Stores the sticks, limited to their range; returns true if they are numbers.
    #[requirement("HLR-31")]
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

    /// Stores a query or a change of a parameter; the owner of the settings decides whether it is valid.
    fn wish_for(&mut self, request: Request, packet: &Packet) -> bool {
        self.wish.request = request;
        self.wish.number = packet.byte(0);
        self.wish.value = packet.number(1);
        true
    }

    /// Stores a selection of logged signals.
    fn choose(&mut self, packet: &Packet) -> bool {
        self.wish.request = Request::Choose;
        self.wish.choice.tag = packet.byte(0);
        self.wish.choice.every = packet.byte(1) as u32;
        for n in 0..WIDTH {
            self.wish.choice.signals[n] = packet.byte(2 + n);
        }
        true
    }
}

/// Limits a value to ±`limit`; returns 0 for NaN.
#[function]
pub fn within(value: f64, limit: f64) -> f64 {
    if value.is_nan() {
        return 0.0;
    }
    value.max(-limit).min(limit)
}
