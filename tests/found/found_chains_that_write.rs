// Conditions in which what stands behind a pattern writes the place that its names are taken from.
#[function]
pub fn found_chains_that_write_0(a0: [i32; 2], n: i32) -> i32 {
    let mut a = if a0[0] & 1 == 0 { Some(a0[0]) } else { None };
    let mut r = 0;
    if let Some(x) = a && { a = Some(n); true } && x > 3 { r = x ^ 5; }
    r ^ a.unwrap_or(7)
}
#[function]
fn found_chains_that_write_1_set(a: &mut Option<i32>, n: i32) -> bool { *a = Some(n); n != 4 }
#[function]
pub fn found_chains_that_write_1(a0: [i32; 2], n: i32) -> i32 {
    let mut a = if a0[0] & 1 == 0 { Some(a0[0]) } else { None };
    if let Some(x) = a && found_chains_that_write_1_set(&mut a, n) { x } else { a.unwrap_or(11) }
}
#[function]
pub fn found_chains_that_write_2(a0: [i32; 2], n: i32) -> i32 {
    let mut a = Some(a0[0]);
    let mut i = 0;
    let mut r = 0_i32;
    #[bound(5)]
    while let Some(x) = a && { a = Some(n.wrapping_add(i)); i < 4 } && x > -1000 { i += 1; r = r.wrapping_mul(3).wrapping_add(x); }
    r
}
#[function]
pub fn found_chains_that_write_3(a0: [i32; 3], n: i32) -> i32 {
    let mut t = (a0[0], a0[1]);
    if let (x, 0..) = t && { t.0 = n; true } && x > 2 { x } else { t.0 }
}
#[function]
pub fn found_chains_that_write_4(a0: [i32; 3], n: i32, i0: usize) -> i32 {
    let mut v = [Some(a0[0]), None, Some(a0[2])];
    let mut i = i0 % 3;
    let mut r = 0;
    if let Some(x) = v[i] && { i = (i + 1) % 3; v[i] = Some(n); true } && let Some(y) = v[i] && x != y { r = x.wrapping_sub(y); }
    r
}
#[function]
pub fn found_chains_that_write_5(x0: [i32; 4], n: i32) -> i32 {
    let mut x = x0;
    let [a, rest @ ..] = x; x[1] = n; x[0] = 3;
    let s = a.wrapping_add(rest[0].wrapping_mul(3)).wrapping_add(rest[2]);
    let t = match x { [a, rest @ .., b] => { x[2] = 4; x[1] = 5; x[3] = 6; a.wrapping_add(rest[1].wrapping_mul(3)).wrapping_add(rest[0]).wrapping_add(b) } };
    let u = if let [p, q @ ..] = x && { x[1] = n; true } { p.wrapping_add(q[0]) } else { 0 };
    s.wrapping_mul(7).wrapping_add(t).wrapping_mul(3).wrapping_add(u)
}
#[function]
pub fn found_chains_that_write_6(x0: [i32; 4], n: i32) -> i32 {
    let mut x = x0;
    let u = if let [p, mut q @ ..] = x && { q[0] = n; true } && q[1] != n { p.wrapping_add(q[0]) } else { 0 };
    let [mut a, mut r @ ..] = x; r[1] = 5; a ^= 1;
    u.wrapping_mul(3).wrapping_add(x[1]).wrapping_add(r[1].wrapping_mul(5)).wrapping_add(a)
}
#[function]
pub fn found_chains_that_write_7(x0: [i32; 4], n: i32, i0: usize) -> i32 {
    let mut x = [Some(x0[0]), None, Some(x0[2])]; let mut i = i0 % 2;
    let mut s = 0_i32;
    if let Some(r) = &mut x[i] && { i += 1; *r = r.wrapping_add(n); true } && *r > 3 { *r ^= 5; s = i as i32; }
    if let Some(r) = x[i] && let Some(q) = &mut x[2] && { *q = q.wrapping_mul(3); r > 1 } { s ^= r; }
    if let (Some(r), y) = (x[0], i) && { i = 2; x[0] = x[i]; true } && let Some(z) = x[y] { s = s.wrapping_add(r ^ z); }
    s.wrapping_mul(3).wrapping_add(x[0].unwrap_or(1)).wrapping_mul(3).wrapping_add(x[2].unwrap_or(4)).wrapping_add(i as i32)
}
#[function]
pub fn found_chains_that_write_8(x: [i32; 4], n: i32) -> i32 {
    let mut o = Some(x[0]); let mut s = 0_i32;
    if let Some(v) = o && let Some(v) = Some(v).filter(|q| *q & 1 == 0) && { o = Some(n); true } && v > 1 { s = v; }
    o = Some(x[1]);
    if let Some(v) = o && { o = Some(n); true } && let Some(v) = o.map(|q| q ^ v) && { o = None; v > 0 } { s = s.wrapping_add(v); }
    s.wrapping_mul(3).wrapping_add(o.unwrap_or(5))
}
#[function]
fn found_chains_that_write_9_ap(f: impl Fn(i32) -> i32, x: i32) -> i32 { f(x).wrapping_mul(3) }
#[function]
fn found_chains_that_write_9_f(x: [i32; 4], n: i32, k: &mut i32) -> Option<i32> {
    let mut o = Some(x[0]); let mut s = 0_i32;
    for y in x {
        if let Some(v) = o && { o = Some(found_chains_that_write_9_ap(|q| q ^ v ^ y, n)); *k += 1; if v == 3 { break; } if v == 5 { continue; } if v == 6 { return None; } Some(v).filter(|q| *q != 7)? > 2 } && v != n { s = s.wrapping_mul(3).wrapping_add(v); }
    }
    Some(s.wrapping_add(o?))
}
#[function]
pub fn found_chains_that_write_9(x: [i32; 4], n: i32) -> i32 { let mut k = 0; found_chains_that_write_9_f(x, n & 7, &mut k).unwrap_or(9).wrapping_mul(8).wrapping_add(k) }
#[function]
fn found_chains_that_write_10_ap(f: impl Fn(i32) -> i32, x: i32) -> i32 { f(x).wrapping_mul(3) }
#[function]
pub fn found_chains_that_write_10(x: [i32; 4], n: i32) -> i32 {
    let mut a = x[0]; let mut s = 0_i32;
    for y in x {
        s = s.wrapping_mul(3).wrapping_add(match (a, y, (s, a)) {
            (3, ..) => break,
            (v, w, (z, _)) if { a = found_chains_that_write_10_ap(|q| q ^ v, w); s ^= 1; a & 1 == 0 } => v.wrapping_add(w) ^ z,
            (5, _, (_, 5)) => continue,
            (v, _, (z, u)) => { let q = found_chains_that_write_10_ap(|q| q.wrapping_mul(v), z); q ^ u ^ a }
        });
    }
    s.wrapping_add(a)
}
#[function]
pub fn found_chains_that_write_11(x: [i32; 4], n: i32) -> i32 {
    let mut o = if x[0] & 1 == 0 { Some(x[1]) } else { None }; let mut k = n;
    let r = if let Some(v) = o && { k = k.wrapping_add(v); v & 2 == 0 } { v } else if { k ^= 5; k > 3 } && let Some(w) = o.take() { w ^ k } else if let None = o && { o = Some(k); true } && let Some(u) = o { u ^ 3 } else { k };
    let mut c = 0;
    #[bound(9)]
    while { c += 1; c < 5 } && let Some(q) = o && q != k { o = if c == 3 { None } else { Some(q ^ c) }; k = k.wrapping_mul(3); }
    r.wrapping_mul(3).wrapping_add(k).wrapping_add(c).wrapping_add(o.unwrap_or(4))
}
