//! Assignments to several places at once.

use bessemer::prelude::*;

#[function]
pub fn pair(x: i32) -> (i32, [i32; 2]) {
    (x.wrapping_add(1), [x, 2])
}

#[function]
pub fn taken(values: &mut [i32; 4], at: usize) -> i32 {
    let a;
    let mut b;
    let mut i = at;
    (a, [b, _]) = pair(values[0]);
    (values[i], i) = (i as i32, 1);
    [values[i], b] = [b, values[i]];
    (values[2], _) = (a, b);
    _ = pair(a);
    (b, values[3]) = (b.wrapping_sub(a), values[0]);
    b
}

static TABLE: [u16; 4] = [1, 20, 300, 4000];

#[function]
pub fn looked_up(at: usize) -> u16 {
    static OFFSETS: [u16; 2] = [5, 6];
    TABLE[at % 4] + OFFSETS[at % 2] + TABLE.len() as u16
}

/// A point, and the number of steps to it.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    pub at: [i16; 2],
    pub by: Step,
}

/// Width of a step, and number of repetitions.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step(pub i16, pub u8);

#[function]
pub fn parts_of_structs(from: [i16; 2], by: i16, times: u8) -> (i16, i16, u8, [i16; 2]) {
    let (mut x, y);
    let mut kept = [0; 2];
    let (at, mut often);
    Reached { at, by: Step(x, often) } = Reached { at: from, by: Step(by, times) };
    Reached { at: [kept[1], y], .. } = Reached { at, by: Step(x, often) };
    (x, ..) = (y.wrapping_sub(x), often, kept);
    Step(kept[usize::from(often % 2)], often) = Step(x, often ^ 1);
    (x, y, often, kept)
}

#[function]
pub fn left_by_error(value: i16) -> Result<i16, i8> {
    if value > 9 {
        Err(3)?;
    }
    if value < -9 {
        let _ = Err(-3)?;
    }
    Ok(value)
}

/// A pair of a number and a vector.
type Pair = (f64, [f64; 2]);

/// Names of a pattern with a type, each assigned in every branch.
#[function]
pub fn parts_assigned_later(x: f64, positive: bool) -> (f64, f64, f64, i32) {
    let (first, [second, mut third]): Pair;
    let [count, _]: [i32; 2];
    if positive {
        first = x;
        second = 2.0 * x;
        third = second - 1.0;
        count = 1;
    } else {
        (first, second) = (-x, 0.5);
        third = first;
        third += second;
        count = -1;
    }
    (first, second, third, count)
}
