// Methods of integers beside a literal of 2 or 3. Of them `pow` and `wrapping_pow` alone are products of the number with itself.
// Before, `k.saturating_add_signed(3)` was the cube of `k`.
#[function]
pub fn found_integers_beside_a_literal_0(k: u8) -> [u8; 12] {
    [
        k.saturating_add_signed(2),
        k.wrapping_add_signed(2),
        k.checked_add_signed(2).unwrap_or(1),
        k.wrapping_pow(2),
        k.saturating_pow(2),
        k.checked_pow(2).unwrap_or(1),
        k.saturating_add(2),
        k.div_ceil(2),
        k.midpoint(2),
        k.saturating_mul(2),
        k.rem_euclid(2),
        k.abs_diff(2),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_1(k: u8) -> [u8; 12] {
    [
        k.saturating_add_signed(3),
        k.wrapping_add_signed(3),
        k.checked_add_signed(3).unwrap_or(1),
        k.wrapping_pow(3),
        k.saturating_pow(3),
        k.checked_pow(3).unwrap_or(1),
        k.saturating_add(3),
        k.div_ceil(3),
        k.midpoint(3),
        k.saturating_mul(3),
        k.rem_euclid(3),
        k.abs_diff(3),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_2(k: i8) -> u8 {
    let low = (k as u8).saturating_add_signed(3);
    low.saturating_add_signed(-3).wrapping_add_signed(2)
}
#[function]
pub fn found_integers_beside_a_literal_3(k: i8) -> i8 {
    let power = (k >> 4).pow(2);
    power.wrapping_add((k >> 6).pow(3)).saturating_add(3).rem_euclid(3)
}
#[function]
pub fn found_integers_beside_a_literal_4(k: u16) -> [u16; 12] {
    [
        k.saturating_add_signed(2),
        k.wrapping_add_signed(2),
        k.checked_add_signed(2).unwrap_or(1),
        k.wrapping_pow(2),
        k.saturating_pow(2),
        k.checked_pow(2).unwrap_or(1),
        k.saturating_add(2),
        k.div_ceil(2),
        k.midpoint(2),
        k.saturating_mul(2),
        k.rem_euclid(2),
        k.abs_diff(2),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_5(k: u16) -> [u16; 12] {
    [
        k.saturating_add_signed(3),
        k.wrapping_add_signed(3),
        k.checked_add_signed(3).unwrap_or(1),
        k.wrapping_pow(3),
        k.saturating_pow(3),
        k.checked_pow(3).unwrap_or(1),
        k.saturating_add(3),
        k.div_ceil(3),
        k.midpoint(3),
        k.saturating_mul(3),
        k.rem_euclid(3),
        k.abs_diff(3),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_6(k: i16) -> u16 {
    let low = (k as u16).saturating_add_signed(3);
    low.saturating_add_signed(-3).wrapping_add_signed(2)
}
#[function]
pub fn found_integers_beside_a_literal_7(k: i16) -> i16 {
    let power = (k >> 4).pow(2);
    power.wrapping_add((k >> 6).pow(3)).saturating_add(3).rem_euclid(3)
}
#[function]
pub fn found_integers_beside_a_literal_8(k: u32) -> [u32; 12] {
    [
        k.saturating_add_signed(2),
        k.wrapping_add_signed(2),
        k.checked_add_signed(2).unwrap_or(1),
        k.wrapping_pow(2),
        k.saturating_pow(2),
        k.checked_pow(2).unwrap_or(1),
        k.saturating_add(2),
        k.div_ceil(2),
        k.midpoint(2),
        k.saturating_mul(2),
        k.rem_euclid(2),
        k.abs_diff(2),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_9(k: u32) -> [u32; 12] {
    [
        k.saturating_add_signed(3),
        k.wrapping_add_signed(3),
        k.checked_add_signed(3).unwrap_or(1),
        k.wrapping_pow(3),
        k.saturating_pow(3),
        k.checked_pow(3).unwrap_or(1),
        k.saturating_add(3),
        k.div_ceil(3),
        k.midpoint(3),
        k.saturating_mul(3),
        k.rem_euclid(3),
        k.abs_diff(3),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_10(k: i32) -> u32 {
    let low = (k as u32).saturating_add_signed(3);
    low.saturating_add_signed(-3).wrapping_add_signed(2)
}
#[function]
pub fn found_integers_beside_a_literal_11(k: i32) -> i32 {
    let power = (k >> 4).pow(2);
    power.wrapping_add((k >> 6).pow(3)).saturating_add(3).rem_euclid(3)
}
#[function]
pub fn found_integers_beside_a_literal_12(k: u64) -> [u64; 12] {
    [
        k.saturating_add_signed(2),
        k.wrapping_add_signed(2),
        k.checked_add_signed(2).unwrap_or(1),
        k.wrapping_pow(2),
        k.saturating_pow(2),
        k.checked_pow(2).unwrap_or(1),
        k.saturating_add(2),
        k.div_ceil(2),
        k.midpoint(2),
        k.saturating_mul(2),
        k.rem_euclid(2),
        k.abs_diff(2),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_13(k: u64) -> [u64; 12] {
    [
        k.saturating_add_signed(3),
        k.wrapping_add_signed(3),
        k.checked_add_signed(3).unwrap_or(1),
        k.wrapping_pow(3),
        k.saturating_pow(3),
        k.checked_pow(3).unwrap_or(1),
        k.saturating_add(3),
        k.div_ceil(3),
        k.midpoint(3),
        k.saturating_mul(3),
        k.rem_euclid(3),
        k.abs_diff(3),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_14(k: i64) -> u64 {
    let low = (k as u64).saturating_add_signed(3);
    low.saturating_add_signed(-3).wrapping_add_signed(2)
}
#[function]
pub fn found_integers_beside_a_literal_15(k: i64) -> i64 {
    let power = (k >> 4).pow(2);
    power.wrapping_add((k >> 6).pow(3)).saturating_add(3).rem_euclid(3)
}
#[function]
pub fn found_integers_beside_a_literal_16(k: usize) -> [usize; 12] {
    [
        k.saturating_add_signed(2),
        k.wrapping_add_signed(2),
        k.checked_add_signed(2).unwrap_or(1),
        k.wrapping_pow(2),
        k.saturating_pow(2),
        k.checked_pow(2).unwrap_or(1),
        k.saturating_add(2),
        k.div_ceil(2),
        k.midpoint(2),
        k.saturating_mul(2),
        k.rem_euclid(2),
        k.abs_diff(2),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_17(k: usize) -> [usize; 12] {
    [
        k.saturating_add_signed(3),
        k.wrapping_add_signed(3),
        k.checked_add_signed(3).unwrap_or(1),
        k.wrapping_pow(3),
        k.saturating_pow(3),
        k.checked_pow(3).unwrap_or(1),
        k.saturating_add(3),
        k.div_ceil(3),
        k.midpoint(3),
        k.saturating_mul(3),
        k.rem_euclid(3),
        k.abs_diff(3),
    ]
}
#[function]
pub fn found_integers_beside_a_literal_18(k: isize) -> usize {
    let low = (k as usize).saturating_add_signed(3);
    low.saturating_add_signed(-3).wrapping_add_signed(2)
}
#[function]
pub fn found_integers_beside_a_literal_19(k: isize) -> isize {
    let power = (k >> 4).pow(2);
    power.wrapping_add((k >> 6).pow(3)).saturating_add(3).rem_euclid(3)
}
