// `Wrapping`, its operators and what is derived; and the numbers of a loop that its author changes.
#[data]
#[derive(Clone, Copy, Default)]
pub struct FoundNumbersThatWrap { pub sum: core::num::Wrapping<u16>, pub ring: [core::num::Wrapping<i8>; 3] }
#[function]
pub fn found_numbers_that_wrap_u16(a: [u16; 4], k: u16) -> u16 {
    use core::num::Wrapping;
    let mut sum = Wrapping(k);
    for x in a { sum = sum * Wrapping(31) + Wrapping(x); sum -= Wrapping(7); sum *= Wrapping(x | 1); sum += -Wrapping(x); }
    let bits = (sum & Wrapping(0xF0F)) | Wrapping(k) ^ sum;
    if bits > sum { bits.0 } else { (sum - bits).0 }
}
#[function]
pub fn found_numbers_that_wrap_i8(a: [i8; 3], k: i8) -> i32 {
    let mut it = FoundNumbersThatWrap::default();
    for (i, x) in a.iter().enumerate() { it.ring[i] = core::num::Wrapping(*x) * core::num::Wrapping(k); it.sum += core::num::Wrapping(it.ring[i].0 as u16); }
    let [p, q, r] = it.ring;
    i32::from((p - q).0) * 3 + i32::from((-r).0) + i32::from((p * q + r).0) + i32::from(it.sum.0) + i32::from(p == q) + i32::from(p < r)
}
#[function]
pub fn found_numbers_that_wrap_i64(a: [i64; 2], k: u64) -> i64 {
    let mut x = core::num::Wrapping(a[0]); let mut y = core::num::Wrapping(k);
    for z in a { x = x * core::num::Wrapping(z) - core::num::Wrapping(i64::MIN); y = y * y + core::num::Wrapping(z as u64); }
    (x ^ core::num::Wrapping(y.0 as i64)).0
}
#[function]
pub fn found_numbers_that_wrap_own(a: [i32; 4], k: usize) -> i32 {
    let mut s = 0_i32;
    for (mut i, x) in (0_usize..).zip(a.iter()) { i += k & 7; s = s.wrapping_mul(3).wrapping_add(i as i32).wrapping_add(*x); i ^= 1; s ^= i as i32; }
    for (x, mut i) in a.iter().zip(3_u8..) { i = i.wrapping_add(200); s = s.wrapping_mul(3).wrapping_add(i as i32).wrapping_add(*x); }
    for (mut i, x) in a.iter().enumerate().rev().skip(k & 1) { i += k & 3; s = s.wrapping_mul(5).wrapping_add(i as i32).wrapping_add(*x); }
    for (mut i, x) in (0..4_u32).zip(a) { i += 3; s = s.wrapping_mul(5).wrapping_add(i as i32).wrapping_add(x); }
    for mut i in (0..(k & 7)).rev().step_by(2) { i += 3; s = s.wrapping_mul(5).wrapping_add(i as i32); }
    for mut i in (1..=(k & 7)).skip(1) { i += 3; s = s.wrapping_mul(5).wrapping_add(i as i32); }
    s
}
