//! Quadrature decoder with a transition table, index pulse and a speed estimate
//! that uses the time between edges when slow and counts when fast.

use core::f32::consts::TAU;
use core::num::NonZeroU32;
use core::ops::Sub;

/// Encoder position in quarter lines; wraps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts(pub i32);

impl Sub for Counts {
    type Output = i32;
    fn sub(self, rhs: Self) -> i32 {
        self.0.wrapping_sub(rhs.0)
    }
}

/// One reading of the pins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pins {
    pub a: bool,
    pub b: bool,
    pub index: bool,
}

impl Pins {
    fn code(self) -> u8 {
        u8::from(self.a) << 1 | u8::from(self.b)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    Still,
    Forward,
    Backward,
    /// Both channels changed at once, a state was missed.
    Skipped,
}

use Motion::{Backward as B, Forward as F, Skipped as X, Still as S};

/// Row is the previous code, column the present one.
const TRANSITIONS: [[Motion; 4]; 4] = [
    [S, B, F, X],
    [F, S, X, B],
    [B, X, S, F],
    [X, F, B, S],
];

/// Decoder; `step` is called at the sampling rate of the pins.
#[derive(Clone, Debug, Default)]
pub struct QuadratureDecoder {
    last: Option<Pins>,
    counts: Counts,
    skipped: u32,
    index_at: Option<Counts>,
}

impl QuadratureDecoder {
    pub fn new() -> Self {
        Self::default()
    }

    pub fn step(&mut self, pins: Pins) -> Motion {
        // The first reading only tells where the encoder stands.
        let Some(last) = self.last.replace(pins) else {
            return Motion::Still;
        };
        let motion = TRANSITIONS[last.code() as usize][pins.code() as usize];
        match motion {
            Motion::Forward => self.counts.0 = self.counts.0.wrapping_add(1),
            Motion::Backward => self.counts.0 = self.counts.0.wrapping_sub(1),
            Motion::Skipped => self.skipped = self.skipped.saturating_add(1),
            Motion::Still => {}
        }
        if pins.index && !last.index {
            self.index_at = Some(self.counts);
        }
        motion
    }

    pub fn counts(&self) -> Counts {
        self.counts
    }

    pub fn skipped(&self) -> u32 {
        self.skipped
    }

    /// Angle from the last index pulse in [0, 2π), if one was seen.
    pub fn angle(&self, per_turn: NonZeroU32) -> Option<f32> {
        let since = self.counts - self.index_at?;
        let turn = per_turn.get() as i32;
        Some(since.rem_euclid(turn) as f32 * TAU / turn as f32)
    }
}

/// Speed from counts and edge times, in counts per second.
#[derive(Clone, Debug)]
pub struct SpeedEstimator {
    last_counts: Counts,
    last_edge_s: f32,
    speed: f32,
}

impl SpeedEstimator {
    /// Without an edge for this long the shaft is taken to stand.
    const STANDSTILL_S: f32 = 0.2;

    pub fn new(start: Counts) -> Self {
        Self { last_counts: start, last_edge_s: 0.0, speed: 0.0 }
    }

    /// `since_edge` is the age of the newest edge at the end of this period.
    pub fn step(&mut self, counts: Counts, dt: f32, since_edge: f32) -> f32 {
        let moved = counts - self.last_counts;
        self.last_counts = counts;
        self.speed = match moved {
            0 => {
                self.last_edge_s += dt;
                // It cannot be faster than one count since the last edge.
                let bound = 1.0 / self.last_edge_s.max(dt);
                if self.last_edge_s > Self::STANDSTILL_S {
                    0.0
                } else {
                    self.speed.clamp(-bound, bound)
                }
            }
            n => {
                let span = self.last_edge_s + dt - since_edge;
                self.last_edge_s = since_edge;
                n as f32 / span.max(0.01 * dt)
            }
        };
        self.speed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pins of an encoder at quarter-line `n`.
    fn pins_at(n: i32) -> Pins {
        let (a, b) = match n.rem_euclid(4) {
            0 => (false, false),
            1 => (true, false),
            2 => (true, true),
            _ => (false, true),
        };
        Pins { a, b, index: n.rem_euclid(40) == 10 }
    }

    #[test]
    fn counts_both_ways() {
        let mut dec = QuadratureDecoder::new();
        (0..=25).for_each(|n| assert_ne!(dec.step(pins_at(n)), Motion::Skipped));
        assert_eq!(dec.counts(), Counts(25));
        (-5..25).rev().for_each(|n| assert_eq!(dec.step(pins_at(n)), Motion::Backward));
        assert_eq!(dec.counts(), Counts(-5));
        let turn = NonZeroU32::new(40).unwrap();
        // The index was seen last on the way back, at count 10.
        assert!(dec.angle(turn).is_some_and(|a| (a - TAU * 25.0 / 40.0).abs() < 1e-5));
    }

    #[test]
    fn missed_states_are_counted() {
        let mut dec = QuadratureDecoder::new();
        for n in [0, 2, 3, 1] {
            dec.step(pins_at(n));
        }
        assert_eq!((dec.skipped(), dec.counts()), (2, Counts(1)));
        assert_eq!(dec.angle(NonZeroU32::MIN), None);
    }

    #[test]
    fn slow_speed_is_exact_and_standstill_decays() {
        let mut est = SpeedEstimator::new(Counts(0));
        // One count every 25 ms, estimator at 10 ms.
        let mut speed = 0.0;
        for k in 1..=100 {
            let t = k as f32 * 0.01;
            let n = (t / 0.025 + 1e-3) as i32;
            speed = est.step(Counts(n), 0.01, t - n as f32 * 0.025);
        }
        assert!((speed - 40.0).abs() < 1.0, "{speed}");
        let stopped = (0..30).map(|_| est.step(Counts(40), 0.01, 1.0)).last();
        assert_eq!(stopped, Some(0.0));
    }
}
