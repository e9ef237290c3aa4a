// Values that are put back where a condition wrote them.
#[function]
fn found_put_back_0_bump(x: &mut i32) -> bool { *x = x.wrapping_add(1); *x % 2 == 0 }
#[function]
pub fn found_put_back_0(a0: [i32; 3], n: i32) -> i32 {
    let mut a = a0[0];
    let saved = a;
    if found_put_back_0_bump(&mut a) { a = saved; }
    a.wrapping_mul(3).wrapping_add(n)
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundPutBack1S { pub n: i32, pub m: i32 }
#[function]
fn found_put_back_1_bump(x: &mut FoundPutBack1S) -> bool { x.n = x.n.wrapping_add(1); x.n % 2 == 0 }
#[function]
pub fn found_put_back_1(a0: [i32; 3], n: i32) -> i32 {
    let mut a = FoundPutBack1S { n: a0[0], m: n };
    let saved = a.n;
    if !found_put_back_1_bump(&mut a) { a.m = 2; } else { a.n = saved; }
    a.n.wrapping_mul(3).wrapping_add(a.m)
}
#[function]
fn found_put_back_2_bump(x: &mut i32) -> bool { *x = x.wrapping_add(1); *x % 2 == 0 }
#[function]
pub fn found_put_back_2(a0: [i32; 3], n: i32) -> i32 {
    let mut a = a0[0];
    let mut y = n;
    let saved = a;
    let same = y;
    if found_put_back_2_bump(&mut a) { a = saved; }
    if a0[1] > 3 { y = 4; } else { y = same; }
    a.wrapping_mul(3).wrapping_add(y)
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundPutBack3S { pub n: i32, pub m: i32 }
#[function]
fn found_put_back_3_bump(x: &mut FoundPutBack3S) -> bool { x.n = x.n.wrapping_add(1); x.m = x.m.wrapping_sub(1); x.n % 2 == 0 }
#[function]
pub fn found_put_back_3(a0: [i32; 3], n: i32) -> i32 {
    let mut a = FoundPutBack3S { n: a0[0], m: n };
    let saved = a.n;
    let sm = a.m;
    if found_put_back_3_bump(&mut a) { a.n = saved; if a0[1] > 3 { a.m = 5; } else { a.m = sm; } }
    if a0[2] > 2 { a.m = 7; } else { a.m = sm; }
    a.n.wrapping_mul(3).wrapping_add(a.m)
}
