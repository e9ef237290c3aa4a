//! Destructured values, and structs constructed from others.

use bessemer::prelude::*;

/// Gains of a controller.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    /// Proportional gain.
    pub p: f64,
    /// Integral gain.
    pub i: f64,
    /// The last errors.
    pub past: [f64; 2],
}

#[data]
impl Gains {
    /// Weight of the past.
    pub const SHARE: f64 = 0.25;

    /// Gains with zero past errors.
    pub fn fresh(p: f64, i: f64) -> Self {
        Self { p, i, past: [Self::SHARE; 2] }
    }

    /// Shifts the past errors; returns the newest.
    pub fn advance(&mut self) -> f64 {
        self.past = [self.p, self.past[0]];
        self.p
    }
}

/// Returns consecutive numbers.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counter {
    /// The next number.
    pub next: u8,
    /// The last numbers.
    pub pair: Pair,
}

/// Three numbers.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// First number.
    pub first: u8,
    /// Second number.
    pub second: u8,
    /// Third number.
    pub third: u8,
}

#[component]
impl Counter {
    fn take(&mut self) -> u8 {
        self.next += 1;
        self.pair.first += 2;
        self.next
    }

    /// Fields are evaluated in the order in which they are written.
    #[entry]
    pub fn run(&mut self, zero: u8) -> u8 {
        let pair = Pair { third: self.take(), first: self.take(), second: zero };
        self.pair = Pair { third: self.take(), ..self.pair };
        let faulty = Pair { third: 100 / zero, second: 0, first: 255 + zero };
        pair.first + pair.third + faulty.third + faulty.first
    }
}

/// Destructures its gains.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// The gains.
    pub gains: Gains,
}

#[component]
impl Parts {
    /// Swaps, destructures and reconstructs the gains.
    #[entry]
    pub fn run(&mut self, a: f64, b: f64, n: u8) -> f64 {
        let (mut a, b) = (b, a);
        let (first, [second, third]) = (a + b, self.gains.past);
        let Gains { p, i: integral, past: [newest, _] } = self.gains;
        let Gains { past, .. } = &self.gains;
        let oldest = past[1];
        a += 1.0;
        self.gains = Gains { p: a, ..self.gains };
        let bare = Gains { i: b, ..Gains::fresh(p, integral) };
        self.gains = Gains { p: bare.p + self.gains.advance(), i: bare.i, ..self.gains };
        assert!(n < 200, "{n} is too many");
        assert_ne!(n, 100);
        assert_eq!(n % 2, 0, "odd: {}", n);
        let spread = {
            let spread = first - second;
            spread * Gains::SHARE
        };
        let spread = if n == 2 {
            spread + third
        } else if n == 4 {
            let newest = newest * 2.0;
            newest - oldest
        } else {
            return spread;
        };
        spread + self.gains.past[1]
    }
}
