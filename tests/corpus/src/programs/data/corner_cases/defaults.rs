//! Derived `Default` and `PartialEq` of structs, arrays and matrices; tables of all of these.

use bessemer::prelude::*;

/// A gain with a limit.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain {
    pub p: f64,
    pub limit: f32,
    pub on: bool,
}

impl Default for Gain {
    fn default() -> Gain {
        Gain { p: 0.5, limit: 100.0, on: true }
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Set {
    pub gains: [[Gain; 2]; 3],
    pub offsets: Matrix3<f64>,
    pub scale: Vector2<f64>,
    pub name: [u8; 6],
    pub cells: [[[i8; 2]; 2]; 2],
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Defaults {
    pub set: Set,
    pub sets: [Set; 2],
}

const NAMES: [[u8; 6]; 2] = [*b"first\0", *b"second"];
const GRID: [[Gain; 2]; 3] = [
    [Gain { p: 1.0, limit: 2.0, on: false }, Gain { p: -0.0, limit: 0.1, on: true }],
    [Gain { p: 3.0, limit: f32::INFINITY, on: false }, Gain { p: 1e-300, limit: 4.0, on: true }],
    [Gain { p: 5.0, limit: 6.0, on: false }, Gain { p: 7.0, limit: 8.0, on: true }],
];

#[component]
impl Defaults {
    #[entry(infallible)]
    pub fn reset(&mut self, p: f64) -> Gain {
        self.set = Set { scale: Vector2::new(p, -p), ..Default::default() };
        self.sets[0] = Set::default();
        self.sets[1] = Set { name: NAMES[1], gains: GRID, ..self.sets[0] };
        Gain { p, ..Gain::default() }
    }

    #[entry(infallible)]
    pub fn same(&self, set: &Set, gain: Gain) -> u8 {
        let mut bits = 0u8;
        if *set == self.set {
            bits += 1;
        }
        if self.sets[0] == self.sets[1] {
            bits += 2;
        }
        if set.gains[1] != self.set.gains[2] {
            bits += 4;
        }
        if set.offsets == self.set.offsets {
            bits += 8;
        }
        if set.scale != self.set.scale || set.name == *b"first\0" {
            bits += 16;
        }
        if gain == Gain::default() {
            bits += 32;
        }
        if set.cells == [[[0; 2]; 2]; 2] {
            bits += 64;
        }
        if self.sets == [Set::default(); 2] {
            bits += 128;
        }
        bits
    }

    #[entry]
    pub fn cell(&mut self, i: usize, j: usize, k: usize) -> [[i8; 2]; 2] {
        self.set.cells[i][j][k] = self.set.cells[k][j][i] / 2 + 1;
        self.set.gains[i + j][k] = GRID[i + j][k];
        let plane = self.set.cells[1 - i];
        self.set.cells[i][k] = plane[k];
        plane
    }

    #[entry]
    pub fn named(&mut self, i: usize, letter: u8) -> [u8; 6] {
        let before = self.set.name;
        self.set.name = NAMES[i & 1];
        self.set.name[i] = letter;
        if before == NAMES[0] || letter == b'x' { *b"\x00\xffabc\n" } else { before }
    }

    #[entry]
    pub fn picked(&mut self, i: usize, j: usize) -> Gain {
        let gain = self.set.gains[i][j];
        self.set.gains[2 - i] = GRID[i];
        for row in &mut self.set.gains {
            for gain in row {
                gain.p += 1.0;
            }
        }
        gain
    }
}
