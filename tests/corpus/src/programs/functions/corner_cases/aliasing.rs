//! Results that are assigned to one of their arguments.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    pub x: f64,
    pub y: f64,
}

#[data]
impl Pair {
    pub fn swapped(&self) -> Pair {
        Pair { x: self.y, y: self.x }
    }

    pub fn turn(&mut self, by: f64) {
        let x = self.x - by * self.y;
        self.y += by * self.x;
        self.x = x;
    }

    pub fn consumed(mut self) -> Pair {
        self.x += 1.0;
        self.turn(0.5);
        self
    }
}

/// Arrays of components, and of structs.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inner {
    pub count: u8,
    pub pairs: [Pair; 2],
}

#[component]
impl Inner {
    fn bump(&mut self, total: &mut u32) -> u8 {
        *total += 1;
        self.count += 1;
        self.pairs[1] = self.pairs[0].swapped();
        self.count
    }
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Aliases {
    pub m: Matrix3<f64>,
    pub v: Vector3<f64>,
    pub pair: Pair,
    pub rows: [[i32; 3]; 2],
    pub inner: [Inner; 2],
    pub total: u32,
}

#[function]
fn changed(mut pair: Pair, array: [i32; 3]) -> Pair {
    let mut array = array;
    array[0] = 7;
    pair.x = pair.y + array[0] as f64 + array[2] as f64;
    pair
}

#[function]
fn rotated(a: &[i32; 3]) -> [i32; 3] {
    [a[2], a[0], a[1]]
}

#[function]
fn product(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Matrix3<f64> {
    a * b
}

#[function]
fn mixed(out: &mut Pair, from: Pair) {
    out.x = from.y;
    out.y = from.x;
}

#[component]
impl Aliases {
    #[entry(infallible)]
    pub fn matrices(&mut self) -> Vector3<f64> {
        self.v = self.m * self.v;
        self.m = self.m * self.m;
        self.m = self.m.transpose();
        self.m = self.m.tr_mul(&self.m);
        self.m = product(&self.m, &self.m);
        self.v = self.v.cross(&self.v) + self.v * self.v.x;
        self.v = self.v / self.v.y;
        self.v = Vector3::new(self.v.z, self.v.x, self.v.y);
        self.v = self.v * self.v.dot(&self.v) - self.v;
        self.v *= self.v[0];
        self.v -= self.v * 0.5;
        self.v
    }

    #[entry(infallible)]
    pub fn structs(&mut self, other: Pair) -> Pair {
        self.pair = self.pair.swapped();
        self.pair = Pair { x: self.pair.y, y: self.pair.x + other.x };
        let before = self.pair;
        self.pair.x = 1.5;
        self.pair = changed(self.pair, [1, 2, 3]);
        self.pair = self.pair.consumed();
        let copy = self.pair;
        mixed(&mut self.pair, copy);
        let mut moved = before;
        moved.turn(0.25);
        mixed(&mut moved, before);
        let swap = self.pair;
        self.pair = moved;
        moved = swap;
        Pair { x: moved.x + before.x, y: moved.y - before.y }
    }

    #[entry]
    pub fn arrays(&mut self, at: usize, mut by_value: [i32; 3]) -> [i32; 3] {
        let before = by_value;
        by_value = rotated(&by_value);
        self.rows[0] = rotated(&self.rows[0]);
        self.rows[1] = self.rows[0];
        self.rows[at] = rotated(&self.rows[1 - at]);
        self.rows[0][at] = self.rows[0][self.rows[1][at] as usize];
        by_value = [by_value[1], by_value[0], before[2]];
        let t = by_value[at];
        by_value[at] = by_value[at + 1];
        by_value[at + 1] = t;
        by_value
    }

    #[entry]
    pub fn nested(&mut self, at: usize) -> u32 {
        let first = self.inner[at].bump(&mut self.total);
        let copy = self.inner[at];
        self.inner[0].count = 9;
        self.inner[1] = copy;
        self.inner[0].pairs = self.inner[1].pairs;
        let second = self.inner[1].bump(&mut self.total) as u32;
        first as u32 * 100 + second
    }

    #[entry]
    pub fn through(&mut self, pair: &mut Pair, given: Pair, row: &mut [i32; 3], n: &mut u8) -> f64 {
        let old = *pair;
        *pair = given.swapped();
        pair.turn(old.x);
        self.pair = *pair;
        *row = rotated(row);
        row[0] += 1;
        *n = n.wrapping_add(3);
        *n += 1;
        let p = &mut self.pair;
        p.x += 1.0;
        let q = &*p;
        q.x + q.y + old.y
    }
}
