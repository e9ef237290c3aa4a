//! The orders of the ground, packet by packet (thesis, §6.1, command receiver).
//!
//! A packet that is not sound, not new, not known or not sensible is dropped and counted; what was asked
//! before stays. One is taken however old it is: to stop. A new trajectory is collected beside the one that
//! is flown and takes its place as a whole. Knows how orders are written, not how they are carried out.

use crate::logger::{Choice, WIDTH};
use crate::packet::{MOST_BYTES, Packet};
use crate::trajectory::{MOST_POINTS, SetPoint, Space, Trajectory};
use bessemer::prelude::*;

/// Opens the link: always taken, and the numbering begins with it.
#[data]
pub const HELLO: u8 = 1;
/// Closes the link: nothing is sent down any more.
#[data]
pub const GOODBYE: u8 = 2;
/// A [`Mode`], one byte.
#[data]
pub const MODE: u8 = 3;
/// A set point: what to call its trajectory, one byte; its index, one byte; time, x, y, z, yaw.
#[data]
pub const POINT: u8 = 4;
/// Flies the collected trajectory: how many points, one byte; what it is called, one byte.
#[data]
pub const COMMIT: u8 = 5;
/// Takes off.
#[data]
pub const TAKE_OFF: u8 = 6;
/// Lands.
#[data]
pub const LAND: u8 = 7;
/// Sticks: roll, pitch, rate of yaw, rate of climb.
#[data]
pub const STICKS: u8 = 8;
/// Stops the motors at once.
#[data]
pub const STOP: u8 = 9;
/// Says that the ground is there. From the first one on, it is missed when it is silent.
#[data]
pub const BEAT: u8 = 10;
/// Makes ready for another flight; nothing happens unless the aircraft stands on the ground.
#[data]
pub const ARM: u8 = 11;
/// Asks for a parameter: its number, one byte.
#[data]
pub const ASK: u8 = 12;
/// Sets a parameter: its number, one byte; its value.
#[data]
pub const SET: u8 = 13;
/// Chooses what to write down: what to call the choice, every so many periods, and each signal, one byte each.
#[data]
pub const CHOOSE: u8 = 14;

/// Bytes of the payload of [`MODE`].
#[data]
pub const MODE_BYTES: usize = 1;
/// Bytes of the payload of [`COMMIT`]: how many points, and a name.
#[data]
pub const COMMIT_BYTES: usize = 2;
/// Bytes of the payload of [`ASK`]: a parameter.
#[data]
pub const ASK_BYTES: usize = 1;
/// Bytes of the payload of [`POINT`]: a name, an index and five numbers.
#[data]
pub const POINT_BYTES: usize = 42;
/// Bytes of the payload of [`STICKS`]: four numbers.
#[data]
pub const STICKS_BYTES: usize = 32;
/// Bytes of the payload of [`SET`]: a parameter and a number.
#[data]
pub const SET_BYTES: usize = 9;
/// Bytes of the payload of [`CHOOSE`]: two, and one for each signal.
#[data]
pub const CHOOSE_BYTES: usize = 38;

/// How old what never came is, s: older than any patience.
#[data]
pub const NEVER: f64 = 1e9;

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

/// What the ground wants of the settings, which the receiver does not hold.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Request {
    /// Nothing.
    #[default]
    Nothing,
    /// To know a parameter.
    Ask,
    /// To change a parameter.
    Set,
    /// To change what is written down.
    Choose,
}

/// A request of one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wish {
    /// What for.
    pub request: Request,
    /// The parameter's number: see [`crate::tuning`].
    pub number: u8,
    /// The value it is to have.
    pub value: f64,
    /// What is to be written down.
    pub choice: Choice,
}

/// Everything that the ground has asked for.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orders {
    /// Who decides.
    pub mode: Mode,
    /// Whether to fly.
    pub take_off: bool,
    /// Whether to land.
    pub land: bool,
    /// Whether to stop the motors.
    pub stop: bool,
    /// Whether to make ready for another flight: in the period in which it is asked for.
    pub arm: bool,
    /// Whether anyone listens.
    pub link: bool,
    /// Whether the ground has said that it will be heard from again and again.
    pub watched: bool,
    /// How long nothing has been taken, s.
    pub silence: f64,
    /// Where to go.
    pub trajectory: Trajectory,
    /// What the ground calls that.
    pub tag: u8,
    /// The sticks.
    pub sticks: Sticks,
    /// How old they are, s.
    pub sticks_age: f64,
}

impl Default for Orders {
    /// Nothing was asked for, and the sticks were never heard of.
    fn default() -> Self {
        Orders {
            mode: Mode::ClosedLoop,
            take_off: false,
            land: false,
            stop: false,
            arm: false,
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
#[data]
const STICK_LIMITS: [f64; 3] = [0.35, 2.0, 0.5];

/// The command receiver.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Receiver {
    /// What is to be done.
    pub orders: Orders,
    /// What is wanted of the settings in this period.
    pub wish: Wish,
    /// How the packets fared.
    pub tally: Tally,
    /// The trajectory that is being collected.
    pub collected: Trajectory,
    /// What the ground calls it.
    pub collecting: u8,
    /// Which of its points have come: a bit for each.
    pub received: u32,
    /// Number of the last packet that was taken.
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
        self.orders.silence += period;
        self.orders.arm = false;
        self.wish.request = Request::Nothing;
        if packet.length == 0 {
            return;
        }
        if packet.length > MOST_BYTES || !packet.is_sound() {
            self.tally.broken = self.tally.broken.saturating_add(1);
            return;
        }
        let hello = packet.kind() == HELLO && packet.size() == 0;
        let stop = packet.kind() == STOP && packet.size() == 0;
        let newer = self.is_newer(packet.sequence());
        if !newer && !hello && !stop {
            self.tally.old = self.tally.old.saturating_add(1);
            return;
        }
        if !self.take(space, packet) {
            self.tally.senseless = self.tally.senseless.saturating_add(1);
            return;
        }
        self.tally.taken = self.tally.taken.saturating_add(1);
        self.orders.silence = 0.0;
        if newer || hello {
            self.heard = true;
            self.last = packet.sequence();
        }
    }

    /// Makes ready for another flight: what was asked for is over.
    #[entry(infallible)]
    pub fn forget(&mut self) {
        self.orders.take_off = false;
        self.orders.land = false;
        self.orders.stop = false;
    }

    /// Whether a number is ahead of the last, by less than half of all numbers.
    fn is_newer(&self, number: u16) -> bool {
        let ahead = number.wrapping_sub(self.last);
        !self.heard || (ahead > 0 && ahead < 0x8000)
    }

    /// Does what the packet asks for; whether it made sense.
    fn take(&mut self, space: &Space, packet: &Packet) -> bool {
        let kind = packet.kind();
        let size = packet.size();
        if size == 0 {
            return self.take_word(space, kind);
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

    /// What needs no more than the kind of the packet.
    fn take_word(&mut self, space: &Space, kind: u8) -> bool {
        if kind == TAKE_OFF {
            let ready = self.orders.trajectory.is_sound(space);
            self.orders.take_off = self.orders.take_off || ready;
            return ready;
        }
        if kind == HELLO {
            self.orders.link = true;
            // It may be another ground, with names of its own: what the last one left is in no trajectory.
            self.received = 0;
        } else if kind == GOODBYE {
            self.orders.link = false;
            self.orders.watched = false;
        } else if kind == LAND {
            self.orders.land = true;
        } else if kind == STOP {
            self.orders.stop = true;
        } else if kind == BEAT {
            self.orders.watched = true;
        } else if kind == ARM {
            self.orders.arm = true;
        } else {
            return false;
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

    /// Puts a set point into the trajectory that is being collected: the first of another one empties it.
    fn collect(&mut self, space: &Space, packet: &Packet) -> bool {
        let name = packet.byte(0);
        let index = packet.byte(1) as usize;
        let place = Vector3::new(packet.number(10), packet.number(18), packet.number(26));
        let point = SetPoint { time: packet.number(2), position: place, yaw: packet.number(34) };
        if index >= MOST_POINTS || !point.is_inside(space) {
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

    /// Flies the collected trajectory from now on, if it is sound and all of it has come. The next one is
    /// collected anew.
    fn commit(&mut self, space: &Space, packet: &Packet) -> bool {
        let count = packet.byte(0) as usize;
        let mut wanted = self.collected;
        wanted.count = count;
        if packet.byte(1) != self.collecting || !wanted.is_sound(space) {
            return false;
        }
        for n in 0..MOST_POINTS {
            if n < count && self.received & (1 << n) == 0 {
                return false;
            }
        }
        self.orders.trajectory = wanted;
        self.orders.tag = self.collecting;
        self.received = 0;
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

    /// Asks for a parameter, or sets it: whoever holds the settings knows whether that can be.
    fn wish_for(&mut self, request: Request, packet: &Packet) -> bool {
        self.wish.request = request;
        self.wish.number = packet.byte(0);
        self.wish.value = packet.number(1);
        true
    }

    /// Asks for other signals to be written down.
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

/// The value, or the limit that it exceeds; 0 for what is no number.
#[function]
pub fn within(value: f64, limit: f64) -> f64 {
    if value.is_nan() {
        return 0.0;
    }
    value.max(-limit).min(limit)
}
