//! Types that authors compare with numbers, on either side, also with literals. Comparisons by methods.

use bessemer::prelude::*;
use core::cmp::Ordering;

/// A number with an order beside plain numbers; its name is like a number's.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct F32(pub f32);

#[data]
impl PartialEq<f32> for F32 {
    fn eq(&self, other: &f32) -> bool {
        self.0.eq(other)
    }
}

#[data]
impl PartialEq<F32> for f32 {
    fn eq(&self, other: &F32) -> bool {
        !self.ne(&other.0)
    }
}

#[data]
impl PartialOrd<f32> for F32 {
    fn partial_cmp(&self, other: &f32) -> Option<Ordering> {
        self.0.partial_cmp(other)
    }
}

#[data]
impl PartialOrd<F32> for f32 {
    fn partial_cmp(&self, other: &F32) -> Option<Ordering> {
        self.partial_cmp(&other.0)
    }
}

/// A share in percent, compared with whole numbers of two types; the order is reversed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    percent: u8,
    spare: i16,
}

#[data]
impl PartialEq<i16> for Share {
    fn eq(&self, other: &i16) -> bool {
        i16::from(self.percent) == *other
    }
}

#[data]
impl PartialEq<F32> for Share {
    fn eq(&self, other: &F32) -> bool {
        *other == f32::from(self.percent)
    }
}

#[data]
impl PartialOrd<i16> for Share {
    fn partial_cmp(&self, other: &i16) -> Option<Ordering> {
        if *other == self.spare { None } else { Some(other.cmp(&i16::from(self.percent))) }
    }
}

/// Counts calls.
#[function]
fn bumped(count: &mut u32, value: f32) -> F32 {
    *count += 1;
    F32(value)
}

#[function]
pub fn beside_numbers(x: f32, y: f32) -> [bool; 12] {
    let a = F32(x);
    [
        a == y, y == a, a != y, y != a, a < y, y < a, a <= y, y <= a, a > y, y > a, a >= y, y >= a,
    ]
}

#[function]
pub fn beside_literals(x: f32) -> [bool; 6] {
    let a = F32(x);
    [a < 0.5, 0.5 < a, a == -1.0, 2.0 >= a, a != 0.0, (F32(0.25) < x) == (a > 0.25)]
}

#[function]
pub fn of_shares(percent: u8, spare: i16, x: i16, y: f32) -> ([bool; 6], Option<F32>, Option<f32>) {
    let share = Share { percent, spare };
    let all = [share == x, share == 50, share < x, share >= x, share > 50, share == F32(y)];
    (all, (y < F32(1.0)).then_some(F32(y)), (F32(y) < 1.0).then_some(y))
}

/// Each operand is evaluated once, from left to right, also in a loop's condition.
#[function]
pub fn in_order(x: f32, y: f32) -> (bool, u32, u32) {
    let mut count = 0;
    let less = bumped(&mut count, x) < y && bumped(&mut count, y) >= x;
    let mut passes = 0_u32;
    #[bound(8)]
    while passes < 5 && bumped(&mut count, passes as f32) < x {
        passes += 1;
    }
    (less, count, passes)
}

/// The methods by which operators may be written.
#[function]
pub fn by_methods(x: f64, y: f64, n: i16, m: i16, flag: bool) -> ([bool; 6], [bool; 7]) {
    let pair = (n, flag);
    (
        [x.eq(&y), x.ne(&y), x.lt(&y), x.le(&y), x.gt(&y), x.ge(&y)],
        [n.eq(&m), n.ne(&m), n.lt(&m), n.le(&m), pair.gt(&(m, true)), n.ge(&m), flag.eq(&(n > m))],
    )
}
