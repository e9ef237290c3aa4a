// References to what a tuple or an option refers to, which comes to refer to something else.
#[function]
pub fn found_references_that_move_0(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut o = Some(&x[0]); let r = o.unwrap(); o = Some(&x[1]); let s = o.unwrap_or(&x[3]); o = None; let t = o.unwrap_or(&x[2]); o = Some(&x[3]);
    let u = o.expect("there"); o = Some(&x[2]); let v = o.take().unwrap(); 
    r[0].wrapping_add(s[1]).wrapping_mul(3).wrapping_add(t[0]).wrapping_mul(3).wrapping_add(u[1]).wrapping_add(v[0]).wrapping_add(o.is_none() as i32)
}
#[function]
fn found_references_that_move_1_f(x: &[[i32; 2]; 4], n: i32) -> Option<i32> {
    let mut t = (Some(&x[0]), &x[1]); let r = t.0.unwrap(); t.0 = if n > 3 { Some(&x[2]) } else { None }; let q = t.1; t.1 = &x[3];
    let w = match t.0 { Some(v) => v, None => return Some(r[0]) }; t.0 = Some(&x[0]);
    let z = if let Some(v) = t.0 { v } else { return None }; t = (None, &x[2]);
    Some(r[1].wrapping_add(q[0]).wrapping_mul(3).wrapping_add(w[0]).wrapping_mul(3).wrapping_add(z[1]).wrapping_add(t.1[0]))
}
#[function]
pub fn found_references_that_move_1(x: [[i32; 2]; 4], n: i32) -> i32 { found_references_that_move_1_f(&x, n).unwrap_or(7) }
#[function]
pub fn found_references_that_move_2(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut o = Some(&x[0]); let mut t = (&x[1], 2);
    let f = |r: &[i32; 2], k: i32| r[0].wrapping_mul(3).wrapping_add(r[1]).wrapping_add(k);
    let a = f(t.0, { t = (&x[2], 4); t.1 }); let b = f(o.unwrap(), { o = None; 3 });
    let c = o.or(Some(t.0)).map(|r| { t.0 = &x[3]; r[0] }).unwrap_or(5); o = Some(&x[2]);
    let d = o.map_or(1, |r| { o = Some(&x[0]); r[1] }); let (e, g) = (t.0, { t.0 = &x[0]; t.0 }); let h = match (o, { o = None; 1 }) { (Some(r), k) => r[0] + k, (None, _) => 3 };
    let i = match (t.0, { t.0 = &x[1]; 2 }) { (r, k) => r[1].wrapping_add(k) }; let (j, k) = (t.0, { t.0 = &x[3]; t.0 });
    a.wrapping_add(b).wrapping_mul(3).wrapping_add(c).wrapping_mul(3).wrapping_add(d).wrapping_add(e[0]).wrapping_mul(3).wrapping_add(g[0]).wrapping_add(h).wrapping_add(i).wrapping_mul(3).wrapping_add(j[0]).wrapping_add(k[1])
}
#[function]
fn found_references_that_move_3_g(a: &[i32; 2], b: &[i32; 2], k: i32) -> i32 { a[0].wrapping_mul(3).wrapping_add(b[1]).wrapping_add(k) }
#[function(expand)]
fn found_references_that_move_3_e(a: &[i32; 2], b: &[i32; 2], k: i32) -> i32 { a[0].wrapping_mul(3).wrapping_add(b[1]).wrapping_add(k) }
#[function]
pub fn found_references_that_move_3(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut t = (&x[1], &x[0]); let mut s = 0_i32;
    s = s.wrapping_mul(3).wrapping_add(found_references_that_move_3_g(t.0, { t.0 = &x[2]; t.0 }, 2)); s = s.wrapping_mul(3).wrapping_add(found_references_that_move_3_g(t.0, t.1, { t = (&x[3], &x[3]); t.1[0] }));
    s = s.wrapping_mul(3).wrapping_add(found_references_that_move_3_e(t.0, { t.0 = &x[2]; t.0 }, 2)); s = s.wrapping_mul(3).wrapping_add(found_references_that_move_3_e(t.0, t.1, { t = (&x[1], &x[0]); t.1[0] }));
    let mut p = (&x[0], 1); for y in &x { let q = p.0; p = (y, 2); s = s.wrapping_mul(3).wrapping_add(q[0] ^ p.0[1]); } let o = [Some(&x[0]), Some(&x[1]), None]; let mut i = 0; let r = o[i].unwrap(); i = 1; s = s.wrapping_add(r[0] ^ o[i].unwrap()[1]); s
}
#[function]
pub fn found_references_that_move_4(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut t = (&x[0], 3, &x[1]); let a = &t.0[1]; t.0 = &x[2]; let b = &t.2[..1]; t.2 = &x[3]; let c = &t.1; let d = *c; t.1 = 8;
    let mut o = Some((&x[0], 1)); let e = &o.as_ref().unwrap().0[1]; o = Some((&x[3], 2)); let f = o.unwrap().0; o = None;
    let mut y = x; let mut u = (&x[0], 5); let r = &mut u.1; *r += 1; let m = &mut u; m.0 = &x[2]; m.1 ^= 3; let g = m.0; m.0 = &x[1];
    let mut p = Some((&x[0], 7)); if let Some(q) = p.as_mut() { q.1 = 9; q.0 = &x[3]; } let q = p.as_mut().unwrap(); q.1 += 1; q.0 = &x[1]; let h = q.0; let w = p.get_or_insert((&x[0], 2)); w.1 ^= 1;
    a.wrapping_mul(3).wrapping_add(b[0]).wrapping_mul(3).wrapping_add(d).wrapping_add(*e).wrapping_mul(3).wrapping_add(f[0]).wrapping_add(u.0[1]).wrapping_mul(3).wrapping_add(u.1).wrapping_add(g[0]).wrapping_mul(3).wrapping_add(p.map_or(1, |(a, b)| a[0] ^ b)).wrapping_add(h[1]).wrapping_add(o.is_none() as i32)
}
#[function]
pub fn found_references_that_move_5(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut t = (&x[0], 3, &x[1]); let a = &t.0[1]; t.0 = &x[2]; let b = &t.2[..1]; t.2 = &x[3]; let c = t.1; t.1 = 8;
    let v = t.0.iter().map(|y| { t.0 = &x[0]; y ^ 1 }).fold(0_i32, |a, b| a.wrapping_mul(3).wrapping_add(b));
    for (i, y) in t.2.iter().enumerate() { t.2 = &x[i]; t.1 = t.1.wrapping_mul(3).wrapping_add(*y); }
    let it = t.0.iter(); t.0 = &x[3]; let s = it.fold(1_i32, |a, b| a.wrapping_mul(3).wrapping_add(*b));
    for y in t.0 { t.0 = &x[1]; t.1 ^= y; } let (k, l) = t.2.split_at(1); t.2 = &x[0]; if let [p, q] = t.0 { t.0 = &x[2]; t.1 = t.1.wrapping_add(p ^ q); }
    let z = t.2.first(); t.2 = &x[2]; let w = match z { Some(z) => *z, None => 0 }; let m = if let Some(z) = t.2.get(1) && { t.2 = &x[3]; true } { *z } else { 2 };
    a.wrapping_mul(3).wrapping_add(b[0]).wrapping_mul(3).wrapping_add(c).wrapping_add(v).wrapping_mul(3).wrapping_add(t.1).wrapping_add(s).wrapping_mul(3).wrapping_add(k[0]).wrapping_add(l[0]).wrapping_add(w).wrapping_add(m)
}
#[function(expand)]
fn found_references_that_move_6_e(v: &mut [i32; 3], r: &[i32; 2]) { v[0] = r[1]; for y in v.iter_mut() { *y ^= 3; } let s = &mut v[1..]; s[0] = 4; }
#[function]
fn found_references_that_move_6_g(v: &mut [i32; 3], r: &[i32; 2]) { v[0] = r[1]; v[1] ^= 6; }
#[function]
pub fn found_references_that_move_6(x: [[i32; 2]; 4], n: i32) -> i32 { let mut k = 0_i32; let mut t = (&x[0], [1, 2, n]); t.0 = &x[1]; let (r, v) = &mut t; v[1] = r[0]; *r = &x[0]; v[2] ^= r[1]; t.1[0].wrapping_mul(3).wrapping_add(t.1[1]).wrapping_mul(3).wrapping_add(t.1[2]).wrapping_add(t.0[0]).wrapping_add(k) }
#[function(expand)]
fn found_references_that_move_7_e(v: &mut [i32; 3], r: &[i32; 2]) { v[0] = r[1]; for y in v.iter_mut() { *y ^= 3; } let s = &mut v[1..]; s[0] = 4; }
#[function]
fn found_references_that_move_7_g(v: &mut [i32; 3], r: &[i32; 2]) { v[0] = r[1]; v[1] ^= 6; }
#[function]
pub fn found_references_that_move_7(x: [[i32; 2]; 4], n: i32) -> i32 { let mut k = 0_i32; let mut t = (&x[0], [1, 2, n]); t.0 = &x[1]; let mut o = Some((&x[0], [1, 2])); if let Some((r, v)) = &mut o { v[0] = r[1]; *r = &x[2]; for y in v.iter_mut() { *y ^= 3; } } let w = o.as_mut().unwrap(); w.1[1] = 9; for y in w.1.iter_mut() { *y += 1; } t.1[0] = o.map_or(1, |(r, v)| r[0] ^ v[0] ^ (v[1] << 4)); t.1[0].wrapping_mul(3).wrapping_add(t.1[1]).wrapping_mul(3).wrapping_add(t.1[2]).wrapping_add(t.0[0]).wrapping_add(k) }
#[function(expand)]
fn found_references_that_move_8_e(v: &mut [i32; 3], r: &[i32; 2]) { v[0] = r[1]; for y in v.iter_mut() { *y ^= 3; } let s = &mut v[1..]; s[0] = 4; }
#[function]
fn found_references_that_move_8_g(v: &mut [i32; 3], r: &[i32; 2]) { v[0] = r[1]; v[1] ^= 6; }
#[function]
pub fn found_references_that_move_8(x: [[i32; 2]; 4], n: i32) -> i32 { let mut k = 0_i32; let mut t = (&x[0], [1, 2, n]); t.0 = &x[1]; for y in t.1.iter() { t.0 = &x[2]; k = k.wrapping_mul(3).wrapping_add(*y); } for y in t.0.iter().rev() { t.0 = &x[3]; k ^= y; } t.1[0].wrapping_mul(3).wrapping_add(t.1[1]).wrapping_mul(3).wrapping_add(t.1[2]).wrapping_add(t.0[0]).wrapping_add(k) }
