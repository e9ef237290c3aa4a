// Stepped ranges of all the numbers of a type, which are one more than it counts to.
#[function]
pub fn found_steps_of_all_0(a: u8) -> i64 {
    let mut s = 0_i64; let mut c = 0_i64;
    for i in (0..=255_u8).step_by(1) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (0..=127_i8).step_by(1) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (-128..=127_i8).step_by(1) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (-128..127_i8).step_by(2) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (0..=255_u8).step_by(255) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (3..=255_u8).step_by(2).rev() { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (0..=255_u8).step_by(1).rev() { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (a..=255_u8).step_by(3) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (0..=a).step_by(1) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (0..=a).step_by(2) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (65000..=u16::MAX).step_by(1) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    for i in (0..=u16::MAX).step_by(40000) { s = s.wrapping_mul(3).wrapping_add(i as i64); c += 1; }
    s.wrapping_mul(1000).wrapping_add(c)
}
#[function]
pub fn found_steps_of_all_1(a: u8, b: i8) -> i64 {
    let mut s = 0_i64; let mut c = 0_i64;
    for i in (5..=4_u8).step_by(1) { s += i as i64; c += 1; }
    for i in (5..3_i8).step_by(2) { s += i as i64; c += 1; }
    for i in (a..=a.wrapping_sub(1)).step_by(1) { s += i as i64; c += 1; }
    for i in (b..=b.wrapping_sub(1)).step_by(1) { s += i as i64; c += 1; }
    for i in (b..=b).step_by(200) { s += i as i64; c += 1; }
    for i in (0..=0_u8).rev() { s += i as i64; c += 1; }
    for i in (1..=0_u8).rev() { s += i as i64; c += 1; }
    s.wrapping_mul(1000).wrapping_add(c)
}
#[function]
pub fn found_steps_of_all_2(a: u8) -> i64 {
    let mut s = 0_i64;
    for i in (0..=u64::MAX).step_by(1) { if i > u64::from(a) { break; } s = s.wrapping_mul(3).wrapping_add(i as i64); }
    for i in (i64::MIN..=i64::MAX).step_by(1) { if i & 63 == i64::from(a & 31) { break; } s = s.wrapping_mul(3).wrapping_add(i & 63); }
    s
}
