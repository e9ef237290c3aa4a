// Arrays of an enum whose first variant has another number than 0.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays0E { A = 5, B = 7, C = 0 }
#[function]
pub fn found_numbered_in_arrays_0(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [FoundNumberedInArrays0E::A; 20];
    a[(n & 15) as usize] = FoundNumberedInArrays0E::B;
    let mut b = [[FoundNumberedInArrays0E::A; 3]; 12];
    b[(n & 7) as usize][1] = FoundNumberedInArrays0E::C;
    let c = [FoundNumberedInArrays0E::A; 30];
    let mut s = 0_i32;
    for e in a { s = s.wrapping_mul(3).wrapping_add(e as i32); if e == FoundNumberedInArrays0E::A { s ^= 1; } }
    for r in b { for e in r { s = s.wrapping_mul(3).wrapping_add(e as i32); } }
    for i in 0..3 { s = s.wrapping_mul(3).wrapping_add(match c[(a0[i] & 15) as usize] { FoundNumberedInArrays0E::A => 4, FoundNumberedInArrays0E::B => 5, FoundNumberedInArrays0E::C => 6 }); }
    s
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays1E { A = 5, B = 7, C = 0 }
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundNumberedInArrays1S { pub e: [FoundNumberedInArrays1E; 12], pub o: Option<FoundNumberedInArrays1E>, pub n: i32, pub q: Option<[FoundNumberedInArrays1E; 10]> }
#[function]
fn found_numbered_in_arrays_1_z(n: i32) -> FoundNumberedInArrays1S { if n & 1 == 0 { FoundNumberedInArrays1S { e: [FoundNumberedInArrays1E::A; 12], o: None, n, q: None } } else { FoundNumberedInArrays1S { e: [FoundNumberedInArrays1E::C; 12], o: Some(FoundNumberedInArrays1E::A), n, q: Some([FoundNumberedInArrays1E::A; 10]) } } }
#[function]
pub fn found_numbered_in_arrays_1(a0: [i32; 3], n: i32) -> i32 {
    let x = FoundNumberedInArrays1S { e: [FoundNumberedInArrays1E::A; 12], o: Some(FoundNumberedInArrays1E::A), n: 4, q: Some([FoundNumberedInArrays1E::A; 10]) };
    let mut s = 0_i32;
    for y in [x, found_numbered_in_arrays_1_z(n), found_numbered_in_arrays_1_z(a0[0])] {
        for e in y.e { s = s.wrapping_mul(3).wrapping_add(e as i32); }
        if let Some(e) = y.o { s = s.wrapping_mul(3).wrapping_add(e as i32); }
        if let Some(q) = y.q { for e in q { s = s.wrapping_mul(3).wrapping_add(e as i32); } }
        s ^= y.n;
    }
    s
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays2E { A = 5, B = 7, C = 0 }
pub const found_numbered_in_arrays_2_T: [FoundNumberedInArrays2E; 20] = [FoundNumberedInArrays2E::A; 20];
pub const found_numbered_in_arrays_2_U: [[FoundNumberedInArrays2E; 10]; 3] = [[FoundNumberedInArrays2E::A; 10]; 3];
#[function]
pub fn found_numbered_in_arrays_2(a0: [i32; 3], n: i32) -> i32 {
    let mut s = n;
    for i in 0..3 { s = s.wrapping_mul(3).wrapping_add(found_numbered_in_arrays_2_T[(a0[i] & 15) as usize] as i32); s = s.wrapping_mul(3).wrapping_add(found_numbered_in_arrays_2_U[i % 3][(a0[i] & 7) as usize] as i32); }
    let mut t = found_numbered_in_arrays_2_T;
    t[2] = FoundNumberedInArrays2E::B;
    for e in t { s = s.wrapping_mul(3).wrapping_add(e as i32); }
    s
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays3E { A = 5, B = 7 }
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundNumberedInArrays3S { pub k: i32, pub e: FoundNumberedInArrays3E }
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays3W { Off, On(FoundNumberedInArrays3E), Many([FoundNumberedInArrays3E; 10]) }
#[function]
pub fn found_numbered_in_arrays_3(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [FoundNumberedInArrays3S { k: 0, e: FoundNumberedInArrays3E::A }; 12];
    a[(n & 7) as usize].k = 3;
    let mut w = [FoundNumberedInArrays3W::Off; 10];
    w[1] = FoundNumberedInArrays3W::Many([FoundNumberedInArrays3E::A; 10]);
    w[(n & 7) as usize] = FoundNumberedInArrays3W::On(FoundNumberedInArrays3E::A);
    let mut s = a0[0];
    for x in a { s = s.wrapping_mul(3).wrapping_add(x.k).wrapping_add(x.e as i32); }
    for x in w { s = s.wrapping_mul(3).wrapping_add(match x { FoundNumberedInArrays3W::Off => 1, FoundNumberedInArrays3W::On(e) => e as i32, FoundNumberedInArrays3W::Many(m) => { let mut t = 0_i32; for e in m { t = t.wrapping_mul(3).wrapping_add(e as i32); } t } }); }
    s
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays4E { A = 5, B = 7, C = -3 }
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundNumberedInArrays4I { pub e: FoundNumberedInArrays4E, pub v: [FoundNumberedInArrays4E; 9], pub k: i32 }
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundNumberedInArrays4S { pub i: [FoundNumberedInArrays4I; 2], pub o: [Option<FoundNumberedInArrays4E>; 10], pub n: i32 }
#[function]
fn found_numbered_in_arrays_4_f(n: i32) -> Option<FoundNumberedInArrays4I> { if n & 1 == 0 { None } else { Some(FoundNumberedInArrays4I { e: FoundNumberedInArrays4E::A, v: [FoundNumberedInArrays4E::A; 9], k: n }) } }
#[function]
fn found_numbered_in_arrays_4_g(n: i32) -> FoundNumberedInArrays4S { let i = FoundNumberedInArrays4I { e: FoundNumberedInArrays4E::A, v: [FoundNumberedInArrays4E::A; 9], k: 0 }; let mut s = FoundNumberedInArrays4S { i: [i; 2], o: [Some(FoundNumberedInArrays4E::A); 10], n: 0 }; if n & 1 == 0 { s.o = [None; 10]; } s.i[1].e = FoundNumberedInArrays4E::C; s }
#[function]
pub fn found_numbered_in_arrays_4(a0: [i32; 3], n: i32) -> i32 {
    let mut s = a0[0];
    let mut q = found_numbered_in_arrays_4_g(n);
    if let Some(i) = found_numbered_in_arrays_4_f(n) { q.i[0] = i; }
    for e in [FoundNumberedInArrays4E::A; 10] { s = s.wrapping_mul(3).wrapping_add(e as i32); }
    for i in q.i { s = s.wrapping_mul(3).wrapping_add(i.e as i32 ^ i.k); for e in i.v { s = s.wrapping_mul(3).wrapping_add(e as i32); } }
    for o in q.o { s = s.wrapping_mul(3).wrapping_add(match o { Some(e) => e as i32, None => 11 }); }
    let mut w = [[FoundNumberedInArrays4E::A; 2]; 11];
    for k in 0..5 { w[k] = [FoundNumberedInArrays4E::B; 2]; }
    for r in w { s = s.wrapping_mul(3).wrapping_add(r[0] as i32).wrapping_mul(3).wrapping_add(r[1] as i32); }
    s
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundNumberedInArrays5E { A = 5, B = 7 }
#[function]
pub fn found_numbered_in_arrays_5(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [FoundNumberedInArrays5E::A; 40];
    for i in 0..17 { a[i] = if n >> (i & 7) & 1 == 0 { FoundNumberedInArrays5E::B } else { FoundNumberedInArrays5E::A }; }
    let mut s = a0[0];
    for e in a { s = s.wrapping_mul(3).wrapping_add(e as i32); }
    s
}
