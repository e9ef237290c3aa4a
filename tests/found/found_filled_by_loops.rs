// Arrays of equal values that loops fill: a pass may end the loop, or read what a later one fills.
#[function]
pub fn found_filled_by_loops_0(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [7; 6];
    for i in 0..6 { a[i] = n.wrapping_add(i as i32); if a[i] % 3 == 0 { break; } }
    a[5].wrapping_mul(3).wrapping_add(a[4]).wrapping_add(a0[0])
}
#[function]
pub fn found_filled_by_loops_1(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [7; 6];
    let mut s = 0i32;
    for i in 0..6 { a[i] = n.wrapping_add(i as i32); s = s.wrapping_mul(3).wrapping_add(a[5 - i]); }
    s.wrapping_add(a[2]).wrapping_add(a0[0])
}
#[function]
pub fn found_filled_by_loops_2(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [7; 6];
    for i in 0..6 { if n.wrapping_add(i as i32) % 2 == 0 { a[i] = 3; continue; } else { a[i] = a0[0]; } }
    a[5].wrapping_mul(3).wrapping_add(a[4]).wrapping_add(a0[0])
}
#[function]
pub fn found_filled_by_loops_3(a0: [i32; 3], n: i32) -> i32 {
    let mut m = Matrix3::<f64>::zeros();
    for r in 0..3 { for c in 0..3 { m[(r, c)] = (a0[r] % 7) as f64 + c as f64; if n % 3 == 0 && c == 1 { break; } } }
    let mut v = Vector6::<f64>::repeat(2.5);
    for i in 0..6 { v[i] = m[(i % 3, 1)]; if v[0] > 3.0 { continue; } v[5 - i] += 1.0; }
    let mut s = 0.0; for i in 0..6 { s = s * 2.0 + v[i]; } for i in 0..9 { s = s * 2.0 + m[i]; }
    s as i32
}
#[function]
pub fn found_filled_by_loops_4(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [7; 6];
    for i in 0..6 { if (n >> i) & 1 == 0 { a[i] = 3; a[i] += n % 5; } else { a[i] = a0[0] % 9; if a[i] > 4 { a[(i + 1) % 6] = 9; } } }
    let mut b = [5_i32; 6];
    for i in 0..6 { b[i] = 2; b[i] += a[i] % 3; }
    a[5].wrapping_mul(3).wrapping_add(a[4]).wrapping_add(b[2]).wrapping_mul(5).wrapping_add(a[1])
}
#[function]
fn found_filled_by_loops_5_f(a0: [i32; 3], n: i32) -> [i32; 6] {
    let mut a = [7; 6];
    for i in 0..6 { a[i] = a0[i % 3] % 5; if (n >> i) & 3 == 1 { return a; } }
    a
}
#[function]
pub fn found_filled_by_loops_5(a0: [i32; 3], n: i32) -> i32 { let b = found_filled_by_loops_5_f(a0, n); b[5].wrapping_mul(3).wrapping_add(b[2]) }
#[function]
pub fn found_filled_by_loops_6(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [7; 40];
    for i in 0..17 { a[i] = a0[i % 3] % 5; }
    a[17] = 1; a[18] = 2; a[39] = n;
    for i in 0..10 { a[i + 19] = 3; if i as i32 > (n & 7) { break; } }
    let mut s = 0i32; for i in 0..40 { s = s.wrapping_mul(3).wrapping_add(a[i]); }
    s
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundFilledByLoops7S { pub v: [i32; 6], pub n: i32, pub m: i32 }
#[function]
fn found_filled_by_loops_7_z() -> FoundFilledByLoops7S { FoundFilledByLoops7S { v: [3; 6], n: 4, m: 8 } }
#[function]
pub fn found_filled_by_loops_7(a0: [i32; 3], n: i32) -> i32 {
    let mut s = found_filled_by_loops_7_z();
    s.n = a0[0];
    for i in 0..6 { s.v[i] = n; }
    for i in 0..0 { s.m = i; }
    let mut t = FoundFilledByLoops7S { v: [0; 6], n: 0, m: 0 };
    for i in 0..6 { t.v[i] = a0[i % 3]; if t.v[0] % 2 == 0 { break; } }
    t.n = s.m; t.m = s.n;
    s.v[5].wrapping_mul(3).wrapping_add(s.m).wrapping_mul(3).wrapping_add(t.v[5]).wrapping_add(t.m).wrapping_add(t.n)
}
