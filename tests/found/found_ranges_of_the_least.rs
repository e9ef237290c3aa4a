// Ranges that go from the end on, and end at the least number of their type.
#[function]
pub fn found_ranges_of_the_least_0(a0: [i32; 3], n: i32) -> i32 {
    let mut s = 0i32;
    for k in 0..3 { let m = if a0[k] % 3 == 0 { i32::MIN } else { a0[k] & 7 }; for i in (0..m).rev() { s = s.wrapping_mul(3).wrapping_add(i); } }
    for i in (2..(if n % 2 == 0 { i32::MIN } else { n & 7 })).rev() { s = s.wrapping_mul(5).wrapping_add(i); }
    s
}
#[function]
pub fn found_ranges_of_the_least_1(a0: [i64; 3], n: i64) -> i64 {
    let mut s = 0i64;
    for k in 0..3 { let m = if a0[k] % 3 == 0 { i64::MIN } else { a0[k] & 7 }; for i in (-3..m).rev() { s = s.wrapping_mul(3).wrapping_add(i); } }
    s.wrapping_add(n)
}
#[function]
pub fn found_ranges_of_the_least_2(a0: [i32; 3], n: i32) -> i32 {
    let mut s = 0u32;
    for i in 250..=255_u8 { s = s.wrapping_mul(3).wrapping_add(u32::from(i)); if i == (n as u8) { continue; } s ^= 5; }
    for i in (250..=255_u8).rev() { s = s.wrapping_mul(3).wrapping_add(u32::from(i)); if i == (n as u8) { break; } }
    for i in (-128..=(a0[0] as i8)).rev() { s = s.wrapping_mul(3).wrapping_add(i as u32); if s % 5 == 0 { break; } }
    for i in (a0[1] as i8)..=127 { s = s.wrapping_mul(3).wrapping_add(i as u32); if s % 7 == 0 { break; } }
    for i in (i32::MAX - 2)..=i32::MAX { s = s.wrapping_mul(3).wrapping_add(i as u32); }
    for i in (i32::MIN..=(i32::MIN + 2)).rev() { s = s.wrapping_mul(3).wrapping_add(i as u32); }
    for i in (0..(a0[2] as i8)).rev() { s = s.wrapping_mul(3).wrapping_add(i as u32); }
    for i in (i64::MIN..(i64::MIN + i64::from(n & 3))).rev() { s = s.wrapping_mul(3).wrapping_add(i as u32); }
    s as i32
}
