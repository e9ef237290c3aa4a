//! Tuples, tuple structs and newtypes: stored, passed, returned, destructured, compared.

use bessemer::prelude::*;

/// A length.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metres(pub f64);

/// A point and the certainty of its measurement.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fix(pub Vector3<f64>, pub u8);

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Holder {
    pub pair: (f64, bool),
    pub pairs: [(u8, i16); 3],
    pub nested: ((u8, bool), Metres),
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tuples {
    pub last: (f64, bool),
    pub table: [[(u8, i16); 2]; 2],
    pub height: Metres,
    pub fix: Fix,
    pub holder: Holder,
}

const START: (f64, bool) = (1.5, true);
const TABLE: [(u8, i16); 3] = [(1, -1), (2, -2), (3, -3)];

#[function]
fn divided(a: i32, b: i32) -> (i32, i32) {
    (a / b, a % b)
}

#[function]
fn swapped(pair: (f64, bool)) -> (bool, f64) {
    let (x, flag) = pair;
    (flag, x)
}

#[function]
fn raised(pair: &mut (f64, bool), by: f64) {
    pair.0 += by;
    pair.1 = !pair.1;
}

#[data]
impl Metres {
    pub fn add(self, other: Metres) -> Metres {
        Metres(self.0 + other.0)
    }
}

#[component]
impl Tuples {
    #[entry]
    pub fn several(&mut self, a: i32, b: i32) -> (i32, i32) {
        let (quotient, remainder) = divided(a, b);
        self.table[0][1].0 = (quotient == remainder) as u8;
        (remainder, quotient)
    }

    #[entry(infallible)]
    pub fn exchange(&mut self, given: (f64, bool)) -> (bool, f64) {
        let before = self.last;
        self.last = given;
        if before == given { (true, 0.0) } else { swapped(before) }
    }

    #[entry(infallible)]
    pub fn lent(&mut self, by: f64) -> (f64, bool) {
        raised(&mut self.last, by);
        let mut mine = START;
        raised(&mut mine, self.last.0);
        mine
    }

    #[entry]
    pub fn tables(&mut self, i: usize, j: usize) -> (u8, i16) {
        let at = self.table[i][j];
        self.table[j][i] = TABLE[i + j];
        self.holder.pairs[i] = (at.0, at.1.wrapping_neg());
        let (a, _) = self.holder.pairs[j];
        (a, at.1)
    }

    #[entry(infallible)]
    pub fn lengths(&mut self, x: f64, y: Metres) -> Metres {
        let Metres(own) = self.height;
        self.height = Metres(x).add(y).add(Metres(own));
        self.fix = Fix(Vector3::new(x, y.0, own), 3);
        let Fix(point, sure) = self.fix;
        Metres(point.x * sure as f64 + self.fix.0[1])
    }

    #[entry(infallible)]
    pub fn nests(&mut self, a: (u8, bool), b: Metres) -> ((u8, bool), Metres) {
        let old = self.holder.nested;
        self.holder.nested = (a, b);
        let ((small, flag), Metres(length)) = old;
        self.holder.pair = (length, flag && small > 3);
        (self.holder.nested.0, Metres(self.holder.pair.0))
    }

    #[entry(infallible)]
    pub fn compared(&self, a: (f64, bool), b: (f64, bool), h: &Holder) -> u8 {
        let mut bits = 0u8;
        if a == b {
            bits |= 1;
        }
        if a != self.last {
            bits |= 2;
        }
        if *h == self.holder {
            bits |= 4;
        }
        if h.pairs == self.holder.pairs {
            bits |= 8;
        }
        if h.nested != (a_small(a), self.height) {
            bits |= 16;
        }
        if self.fix == Fix(Vector3::zeros(), 0) {
            bits |= 32;
        }
        bits
    }

    #[entry(infallible)]
    pub fn matched(&self, a: u8, b: bool, pair: (u8, bool)) -> i32 {
        let first = match (a, b) {
            (0, _) => 1,
            (x, true) if x > 100 => 2,
            (1..=9, false) => 3,
            (_, flag) => 4 + flag as i32,
        };
        let second = match pair {
            (0 | 255, false) => 10,
            (n, true) => n as i32,
            (..) => 20,
        };
        first * 1000 + second
    }

    #[entry(infallible)]
    pub fn looped(&self, pairs: [(f64, u8); 5]) -> (f64, u8) {
        let mut total = (0.0, 0u8);
        for (x, n) in &pairs {
            total.0 += x;
            total.1 = total.1.wrapping_add(*n);
        }
        for (i, (x, _)) in pairs.iter().enumerate() {
            total.0 += x * i as f64;
        }
        total
    }
}

#[function]
fn a_small(a: (f64, bool)) -> (u8, bool) {
    (a.0 as u8, a.1)
}
