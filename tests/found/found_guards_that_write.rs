// Tuples that are matched by part: guards and later parts that write what a part was taken from, or where it is.
#[function]
pub fn found_guards_that_write_0(a0: i32, b: i32, n: i32) -> i32 {
    let mut a = a0;
    match (a, b) {
        (x, y) if { a = n; x & 1 == 0 } => x.wrapping_add(y),
        (3, _) if { a = a.wrapping_add(1); false } => 5,
        (x, _) => x.wrapping_mul(3).wrapping_add(a),
    }
}
#[function]
fn found_guards_that_write_1_b(a: &mut Option<i32>, n: i32) -> bool { *a = Some(n); n & 1 == 0 }
#[function]
pub fn found_guards_that_write_1(a0: [i32; 2], b: i32, n: i32) -> i32 {
    let mut a = if a0[0] & 1 == 0 { Some(a0[1]) } else { None };
    match (a, b) {
        (Some(x), y) if found_guards_that_write_1_b(&mut a, n) => x.wrapping_add(y),
        (None, 3) if { a = None; false } => 5,
        (Some(x), _) => x.wrapping_mul(3),
        (None, _) => a.unwrap_or(4),
    }
}
#[function]
pub fn found_guards_that_write_2(a0: [i32; 2], n: i32) -> i32 {
    let mut a = if a0[0] & 1 == 0 { Some(a0[1]) } else { None };
    let r = match a.clone() { Some(x) if { a = Some(n); x & 1 == 0 } => x, Some(x) => x.wrapping_mul(3), None => 7 };
    let mut k = a0[1];
    let q = match k.clone() { 3 => 1, _ if { k = 2; n > 3 } => 5, 2 => 6, _ => 7 };
    r.wrapping_add(q)
}
#[function]
pub fn found_guards_that_write_3(a0: [i32; 2], n: i32) -> i32 {
    let mut k = a0[1];
    let q = match { k } { 3 => 1, _ if { k = 2; n > 3 } => 5, 2 => 6, x => x };
    q.wrapping_add(k)
}
#[function]
pub fn found_guards_that_write_4(x: [i32; 4], n: i32, i0: usize) -> i32 {
    let mut i = i0 % 3; let v = x;
    let r = match v[i] { 3 => 1, _ if { i += 1; n > 5 } => 2, 2 => 3, y if { i = 0; y > n } => y, _ if i == 1 => 9, z => z ^ 1 };
    let o = [Some(x[0]), None, Some(x[2])];
    i = i0 % 2;
    let q = match o[i] { Some(y) if { i += 1; y > 3 } => y.wrapping_add(i as i32), None if { i += 1; true } => 5, Some(y) => y, None => 6 };
    r.wrapping_mul(3).wrapping_add(q).wrapping_add(i as i32)
}
#[function]
pub fn found_guards_that_write_5(v0: [i32; 3], w0: [i32; 3], i0: usize) -> i32 {
    let mut i = i0 % 2;
    let mut v = v0; let mut w = w0;
    match (&mut v[i], { i += 1; &mut w[i] }) { (a, b) => { i = 0; *a = 5; *b = 7; } }
    v[0].wrapping_add(v[1].wrapping_mul(3)).wrapping_add(v[2].wrapping_mul(5)).wrapping_add(w[0].wrapping_mul(7)).wrapping_add(w[1].wrapping_mul(11)).wrapping_add(w[2].wrapping_mul(13)).wrapping_add(i as i32)
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundGuardsThatWrite6 { pub a: i32, pub b: i32 }
#[function]
pub fn found_guards_that_write_6(a0: i32, b: i32) -> i32 {
    let mut s = FoundGuardsThatWrite6 { a: a0, b };
    match (&mut s.a, { s.b = 3; s.b }) { (x, y) => *x = x.wrapping_add(y) }
    let r = &mut s.a;
    match (r, { s.b = 5; s.b }) { (x, y) => *x = x.wrapping_mul(y) }
    let (x, y) = (&mut s.b, { s.a ^= 9; s.a });
    *x = x.wrapping_mul(y);
    s.a.wrapping_mul(7).wrapping_add(s.b)
}
