//! Unused items, and empty bodies.

use bessemer::prelude::*;

/// A constant that nothing uses.
pub const SPARE: f64 = 1.0;

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unused {
    pub level: i32,
}

#[function]
pub fn nothing() {}

#[function]
pub fn ignores(_a: f64, b: i32) -> i32 {
    b
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alone {
    pub a: [Matrix2<f32>; 2],
}

#[component]
#[allow(
    dead_code,
    unused_variables,
    unused_assignments,
    path_statements,
    unused_must_use,
    unused_mut
)]
impl Unused {
    fn private(&self, a: f64) -> f64 {
        a
    }

    fn also(&mut self) {}

    #[entry(infallible)]
    pub fn empty(&mut self, a: f64, b: &Alone, c: [u8; 3]) {}

    #[entry(infallible)]
    pub fn still(&self) {}

    #[entry]
    pub fn step(&mut self, a: i32, b: Alone) -> i32 {
        let x = a.wrapping_add(1);
        let mut y = 3;
        y = a;
        let m = Matrix2::new(1.0, 2.0, 3.0, a as f64);
        let n = m * m;
        let z = [a; 5];
        let alone = b;
        let faulty = 10 / a;
        let _ = a - 7;
        let _w = self.level;
        nothing();
        ignores(1.0, 2);
        self.also();
        a;
        if a > 3 {}
        if a > 4 {
        } else {
            y = 2;
        }
        match a {
            1 => {}
            _ => {}
        }
        for i in 0..3 {}
        for _ in 0..a.min(3) {}
        let u;
        if a > 2 {
            u = 1;
        } else {
            u = 2;
        }
        let late: i32;
        late = a;
        {}
        5
    }
}
