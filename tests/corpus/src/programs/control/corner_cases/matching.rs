//! `match` in every position, with arms that overlap.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    #[default]
    Idle,
    Rising,
    #[allow(non_camel_case_types)]
    EOF,
}

#[data]
impl Phase {
    pub fn next(self) -> Phase {
        match self {
            #[allow(unreachable_patterns)]
            Phase::Idle | Phase::Idle => Phase::Rising,
            Phase::Rising => Phase::EOF,
            Phase::EOF => Self::Idle,
        }
    }

    pub fn is_idle(&self) -> bool {
        *self == Phase::Idle
    }
}

/// An enum of one variant.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Only {
    #[default]
    One,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matching {
    pub phase: Phase,
    pub phases: [Phase; 3],
    pub only: Only,
    pub seen: u8,
}

const LOW: i16 = -7;

#[component]
impl Matching {
    #[entry(infallible)]
    #[allow(unreachable_patterns)]
    pub fn step(&mut self, n: i16, b: bool) -> Phase {
        let weight = match n {
            0 | 1 => 10,
            1 | 2 => 20,
            LOW => 30,
            -32768 => 40,
            i16::MAX => 50,
            _ => 60,
        };
        self.seen = match b && n > -9 {
            true => weight,
            false => 0,
        };
        match b {
            true => self.seen |= 1,
            _ => self.seen ^= 3,
        }
        match n {
            5 => {}
            _ => self.phase = self.phase.next(),
        }
        match self.phase {
            Phase::Idle => {
                if b {
                    return Phase::EOF;
                }
            }
            _ => {}
        }
        match self.only {
            Only::One => self.seen = self.seen.wrapping_add(1),
        }
        self.phases = match self.phase {
            Phase::Rising => [self.phases[2], self.phases[0], self.phase],
            _ => [self.phase, self.phases[1], self.phases[0]],
        };
        if self.phases[1].is_idle() && self.phases[0] != self.phase {
            self.phases[0]
        } else {
            self.phase
        }
    }

    #[entry]
    pub fn chosen(&mut self, n: u64, at: usize) -> [Phase; 2] {
        let a = match n {
            18446744073709551615 => Phase::EOF,
            0 => Phase::Idle,
            9223372036854775808 => Phase::Rising,
            _ => self.phases[at],
        };
        let b = match self.phases[at].next() {
            Phase::EOF => {
                self.seen = 3;
                match a {
                    Phase::EOF => Phase::Idle,
                    _ => a,
                }
            }
            _ => self.phases[0],
        };
        [a, b]
    }
}
