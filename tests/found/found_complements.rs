// Complements, and what the types alone decide, beside numbers.
#[function]
pub fn found_complements_0(a: u8, b: u16, c: i8, d: i16, e: u32, f: u64) -> u64 {
    const M: i8 = -1;
    const N: i16 = -1;
    const O: u8 = 255;
    let s = [(!c as u8) == a, (!d as u8) == a, (!b as u8) == a, (!c as u16) == b, (!a as i16 as u16) == b, (!c as i16 as u16) == b, !a as u16 == b, !a as u16 as u8 == a, (!a as i16) as u8 == a, ((c ^ -1) as u8) == a, ((M ^ c) as u8) < a, ((-1 ^ c) as u8) > a,
      ((M ^ d as i8) as u8) != a, (N ^ d) as u16 >= b, !d as u16 >= b, !c as u32 == e, !a as i32 as u32 == e, !a as i64 as u64 == f, !d as u32 as u64 == f, (O ^ a) as u16 == b, (O - a) as u16 == b, (255 - a) as i16 as u16 == b, (O - a) as i16 as u8 == a,
      ((-1 - (c >> 1)) as u8) == a, ((M - (c >> 1)) as u8) == a, ((N - (d >> 1)) as u16) < b, !(a as u16) == b, !(a as i16) as u16 == b, !(c as i16) as u16 == b, !(c as i16) as u8 == a, !(b as u8) as u16 == b, (!a == b as u8) , (!a as u64) < f, !(!a) as u16 == b, (!a & 0xFF) == b as u8, (!a | 0) == a, (!c as u8 & 255) < a, (!c as u8 & O) == a, (!d as u8 | 0) < a, (!a as u16 & 255 | 0) == b];
    let mut h = 0_u64; let mut k = c; if (!k as u8) == a { k ^= 1; } for _ in 0..100 { if (!k as u8) < 10 { break; } k = k.wrapping_add(3); h += 1; }
    for x in s { h = h * 2 + x as u64; }
    h + k as u8 as u64
}
#[function]
pub fn found_complements_1(a: u8, b: i16, c: i8, f: f64) -> i32 {
    let x = match !a { 5 => 1, _ => 2 };
    let y = match a & 1 { 2 => 1, _ => 4 };
    let z = match a % 4 { 7 => 1, _ => 8 };
    let w = match a as u32 { 300 => 1, _ => 16 };
    let v = match b as i8 as u8 { 200 => 32, 201..=210 | 255 => 64, _ => 0 };
    let u = match (!c) as u8 { 200 => 128, _ => 256 };
    let t = match b { i16::MIN..=-1 => 512, 0 => 1024, 1..=i16::MAX => 2048 };
    let s = match a ^ 255 { 3 => 4096, 9 => 1, _ => 0 };
    let r = if let 7 = 255 - a { 8192 } else { 0 };
    let q = match f { 0.0 => 16384, x if x < 0.0 => 3, _ => 0 };
    let p = match c { -128 => 1 << 20, -1 | 127 => 1 << 21, _ => 0 };
    let o = match (a > 3, c < 0) { (true, false) => 1 << 22, (false, _) => 1 << 23, _ => 0 };
    let n = matches!(!a, 0 | 1 | 254) as i32;
    let m = matches!(a | 1, 0) as i32;
    x + y + z + w + v + u + t + s + r + q + p + o + n + m
}
#[function]
pub fn found_complements_2(k: usize, a: u8, e: bool) -> i32 {
    let mut s = 0_i32;
    for i in 0..(k % 6) { match i { 3 => s += 1, _ => s += 2 } match !a { 4 => { if e { break; } s += 5 } _ => continue } }
    for i in 0..5_u8 { match i & 1 { 1 => s ^= 8, _ => {} } match a % 3 { 5 => break, 1 => s += 7, _ => {} } match (e, i) { (true, 3) => break, _ => s += 1 } }
    match k & 7 { 0 => s, n if n > 3 => s + 1, 2 => -s, _ => !s }
}
#[function]
pub fn found_complements_3(a: u32, b: u32, c: i32, d: u64) -> u32 {
    let mut k = 0_u32;
    if a - a == 0 { k += 1; }
    if (a & 0xFF) < 256 { k += 2; }
    if (a % 10) > 9 { k += 4; }
    if (a >> 24) <= 255 { k += 8; }
    if (a as u64) <= 4294967295 { k += 16; }
    if (c as i64) >= -2147483648 { k += 32; }
    if (b as u8) < 255 { k += 64; }
    if (a | 3) != 0 { k += 128; }
    if a >= 0 && d >= 0 { k += 256; }
    if (c >> 31) >= -1 { k += 512; }
    if (a as u8 as i32) > -1 { k += 1024; }
    if (a ^ a) == 0 { k += 2048; }
    if (d & 3) as u8 == 4 { k += 4096; }
    if (c % 3) < 3 { k += 8192; }
    if c.wrapping_abs() as u32 <= 2147483648 { k += 1 << 14; }
    if !(a < b) == (a >= b) { k += 1 << 15; }
    if (a > b) as u8 > 1 { k += 1 << 16; }
    if ((a > b) as u8) < 2 && (a < 3) as i32 == 1 { k += 1 << 17; }
    if a.leading_zeros() > 32 { k += 1 << 18; }
    if (d >> 40) as u32 >= 1 << 24 { k += 1 << 19; }
    k
}
