//! The C that replaces a method evaluates each operand once, in the order of the Rust.

use bessemer::prelude::*;

/// Returns the next of three indices.
#[function]
fn next(place: &mut usize) -> usize {
    *place = (*place + 1) % 3;
    *place
}

#[function]
fn raised(x: &mut i32) -> i32 {
    *x += 1;
    *x
}

/// The end of the range is read before the value raises it.
#[function]
pub fn range_before_value(low: i8, high: i8) -> bool {
    let (low, mut high) = (i32::from(low), i32::from(high));
    (low..=high).contains(&raised(&mut high))
}

#[function]
pub fn start_before_value(low: i8, high: i8) -> bool {
    let (mut low, high) = (i32::from(low), i32::from(high));
    (low..high).contains(&raised(&mut low))
}

/// The key of each element is computed once.
#[function]
pub fn keys_counted(values: [i32; 3]) -> (i32, Option<i32>) {
    let mut asked = 0;
    let best = values.iter().min_by_key(|value| {
        asked += 1;
        **value
    });
    (asked, best.copied())
}

/// The key of a single element may fault.
#[function]
pub fn key_of_one(values: [i32; 1]) -> Option<i32> {
    values.iter().max_by_key(|value| 10 / **value).copied()
}

/// The key of the first element faults before that of the second.
#[function]
pub fn keys_in_order(values: [i32; 2]) -> Option<i32> {
    let key = |value: i32| if value > 3 { value + 2_147_483_640 } else { 10 / value };
    values.iter().min_by_key(|value| key(**value)).copied()
}

/// The pair with the least sum; the first of several.
#[function]
pub fn key_of_pairs(a: [i16; 3], b: [u8; 3]) -> Option<(i16, u8)> {
    let least = a.iter().zip(&b).min_by_key(|(x, y)| i32::from(**x / 2) + i32::from(**y / 4));
    least.map(|(x, y)| (*x, *y))
}

/// The index of a column view is evaluated once.
#[function]
pub fn scaled_column(m: Matrix3<f64>, place: usize) -> (Matrix3<f64>, usize) {
    let (mut m, mut place) = (m, place % 3);
    m.column_mut(next(&mut place)).scale_mut(2.0);
    (m, place)
}

#[function]
pub fn column_of_several(m: [Matrix2<f64>; 3], place: usize) -> ([Matrix2<f64>; 3], usize) {
    let (mut m, mut place) = (m, place % 3);
    m[next(&mut place)].row_mut(next(&mut place) / 2).unscale_mut(4.0);
    (m, place)
}

/// A view's position is evaluated before the written value changes it.
#[function]
pub fn filled_view(m: Matrix3<f64>, place: usize) -> Matrix3<f64> {
    let (mut m, mut place) = (m, place % 2);
    m.fixed_view_mut::<2, 2>(place, 0).fill({
        place += 1;
        place as f64
    });
    m
}

/// An author's parameter with the name `part`.
#[function]
pub fn own_part(m: Matrix3<f64>, part: Vector3<f64>) -> Matrix3<f64> {
    let mut m = m;
    m.column_mut(1).component_mul_assign(&part);
    m.column_mut(0).axpy(2.0, &part, 0.5);
    m
}
