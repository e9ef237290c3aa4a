// References in arrays, structs, enums and iterators, and in what is lent to a function that is inlined, which come to refer to something else.
#[function(expand)]
fn found_references_in_parts_0_e<'a>(p: &mut (&'a [i32; 2], i32), q: &'a [i32; 2]) -> i32 { let r = &p.0[1]; p.0 = q; let v = &p.0[..1]; p.0 = q; r.wrapping_mul(3).wrapping_add(v[0]) }
#[function]
pub fn found_references_in_parts_0(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = (&x[0], n); let a = found_references_in_parts_0_e(&mut t, &x[1]); a.wrapping_mul(7).wrapping_add(t.0[0]).wrapping_add(t.1) }
#[function(expand)]
fn found_references_in_parts_1_e<'a>(p: &mut Option<&'a [i32; 2]>, q: &'a [i32; 2]) -> i32 { let r = p.unwrap(); *p = None; let v = p.unwrap_or(q); *p = Some(q); r[0].wrapping_mul(3).wrapping_add(v[1]) }
#[function]
pub fn found_references_in_parts_1(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = Some(&x[0]); let a = found_references_in_parts_1_e(&mut t, &x[1]); a.wrapping_mul(7).wrapping_add(t.unwrap()[0]) }
#[function(expand)]
fn found_references_in_parts_2_e<'a>(p: &mut (&'a [i32; 2], i32), q: &'a [i32; 2], g: impl Fn(&[i32; 2]) -> i32) -> i32 { let (r, k) = *p; p.0 = q; let mut s = 0i32; for y in p.0 { p.0 = r; s = s.wrapping_mul(3).wrapping_add(*y); } g(r).wrapping_add(k).wrapping_add(s) }
#[function]
pub fn found_references_in_parts_2(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = (&x[0], n); let a = found_references_in_parts_2_e(&mut t, &x[1], |v| v[0] ^ n); a.wrapping_mul(7).wrapping_add(t.0[0]).wrapping_add(t.1) }
#[function(expand)]
fn found_references_in_parts_3_e<'a>(p: &mut (&'a [i32; 2], i32), mut g: impl FnMut(&mut (&'a [i32; 2], i32)) -> i32) -> i32 { let r = &p.0[0]; let k = g(p); let s = &p.0[1]; let l = g(p); r.wrapping_mul(3).wrapping_add(k).wrapping_mul(3).wrapping_add(*s).wrapping_add(l) }
#[function]
pub fn found_references_in_parts_3(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = (&x[0], n); let mut i = 0; let a = found_references_in_parts_3_e(&mut t, |p| { let r = &p.0[1]; i += 1; p.0 = &x[i]; r ^ n }); let b = found_references_in_parts_3_e(&mut (&x[0], 3), |p| { let r = &p.0[1]; i -= 1; p.0 = &x[i]; r ^ n }); a.wrapping_mul(7).wrapping_add(t.0[0]).wrapping_add(t.1).wrapping_add(b) }
#[function]
fn found_references_in_parts_4_p<'a, 'b>(w: &'a mut [(&'b [i32; 2], i32); 2], i: usize) -> &'a mut (&'b [i32; 2], i32) { &mut w[i % 2] }
#[function]
pub fn found_references_in_parts_4(x: [[i32; 2]; 4], n: i32) -> i32 { let mut w = [(&x[0], n), (&x[1], 3)]; let p = found_references_in_parts_4_p(&mut w, 1); let r = p.0; p.0 = &x[2]; let s = &p.0[1]; p.0 = &x[3]; let q = found_references_in_parts_4_p(&mut w, 0).0; found_references_in_parts_4_p(&mut w, 0).0 = &x[2]; r[0].wrapping_mul(3).wrapping_add(*s).wrapping_mul(3).wrapping_add(q[1]).wrapping_add(w[1].0[0]) }
#[function]
pub fn found_references_in_parts_5(x: [[i32; 2]; 4], n: i32) -> i32 { let mut a = [(&x[0], 1), (&x[1], 2)]; let r = &a[0].0[1]; a[0].0 = &x[2]; let s = a[1].0; a[1] = (&x[3], n); let v = &a[0].0[..1]; a[0] = a[1]; r.wrapping_mul(3).wrapping_add(s[0]).wrapping_mul(3).wrapping_add(v[0]).wrapping_add(a[0].0[1]).wrapping_add(a[1].1) }
#[function]
pub fn found_references_in_parts_6(x: [[i32; 2]; 4], n: i32) -> i32 { let mut o = [Some(&x[0]), Some(&x[1]), None]; let r = o[0].unwrap(); o[0] = Some(&x[3]); let s = o[1].unwrap_or(&x[2]); o[1] = None; o.swap(0, 1); let w = o[1].unwrap(); o[1] = o[2]; r[0].wrapping_mul(3).wrapping_add(s[1]).wrapping_mul(3).wrapping_add(w[0]).wrapping_add(o[0].is_some() as i32) }
#[data]
#[derive(Clone, Copy)]
pub struct FoundReferencesInParts7a<'a> { pub o: Option<&'a [i32; 2]>, pub p: (&'a [i32; 2], [i32; 2]), pub k: i32 }
#[function]
pub fn found_references_in_parts_7(x: [[i32; 2]; 4], n: i32) -> i32 { let mut s = FoundReferencesInParts7a { o: Some(&x[0]), p: (&x[1], [1, n]), k: n }; let r = s.o.unwrap(); s.o = Some(&x[2]); let q = &s.p.0[1]; s.p.0 = &x[3]; let v = &s.p.0[..1]; s.p = (&x[0], [3, 4]); for y in s.p.1.iter_mut() { *y ^= 3; } let w = &mut s.p.1; w[0] = 9; let z = &mut s.p; z.1[1] ^= n; z.0 = &x[1]; for y in s.p.0 { s.p.0 = &x[2]; s.k ^= y; }
 r[0].wrapping_mul(3).wrapping_add(*q).wrapping_mul(3).wrapping_add(v[0]).wrapping_mul(3).wrapping_add(s.p.1[0]).wrapping_add(s.p.1[1]).wrapping_add(s.k).wrapping_add(s.o.unwrap()[1]).wrapping_add(s.p.0[0]) }
#[data]
#[derive(Clone, Copy)]
pub struct FoundReferencesInParts8a<'a> { pub o: Option<&'a [i32; 2]>, pub p: (&'a [i32; 2], i32) }
#[data]
impl<'a> FoundReferencesInParts8a<'a> {
  pub fn go(&mut self, q: &'a [i32; 2]) -> i32 { let r = self.o.unwrap(); self.o = Some(q); let (a, b) = self.p; self.p = (q, 3); let c = &self.p.0[1]; self.p.0 = a; let d = match self.o { Some(d) => d, None => return 3 }; self.o = None; r[0].wrapping_mul(3).wrapping_add(a[1]).wrapping_mul(3).wrapping_add(b).wrapping_add(*c).wrapping_add(d[0]) }
}
#[function]
pub fn found_references_in_parts_8(x: [[i32; 2]; 4], n: i32) -> i32 { let mut s = FoundReferencesInParts8a { o: Some(&x[0]), p: (&x[1], n) }; let a = s.go(&x[2]); a.wrapping_mul(5).wrapping_add(s.p.0[0]) }
#[function]
fn found_references_in_parts_9_f<'a>(v: &mut [(&'a [i32; 2], i32)], q: &'a [i32; 2]) -> i32 { let r = &v[0].0[1]; v[0].0 = q; let s = v[1].0; v[1] = (q, 3); let mut z = 0i32; for y in v.iter_mut() { let a = &y.0[0]; y.0 = found_references_in_parts_9_r0(s); z = z.wrapping_mul(3).wrapping_add(*a); } for y in v[0].0 { v[0].0 = q; z = z.wrapping_mul(3).wrapping_add(*y); } r.wrapping_mul(3).wrapping_add(s[0]).wrapping_add(z) }
#[function]
fn found_references_in_parts_9_r0<'a>(a: &'a [i32; 2]) -> &'a [i32; 2] { a }
#[function]
pub fn found_references_in_parts_9(x: [[i32; 2]; 4], n: i32) -> i32 { let mut a = [(&x[0], 1), (&x[1], 2), (&x[2], n)]; let z = found_references_in_parts_9_f(&mut a[1..], &x[3]); z.wrapping_mul(3).wrapping_add(a[1].0[0]).wrapping_add(a[2].0[1]) }
#[function]
pub fn found_references_in_parts_10(x: [[i32; 2]; 4], n: i32) -> i32 { let mut a = [Some(&x[0]), Some(&x[1]), None]; let mut s = 0i32; for o in &mut a { if let Some(r) = o { let q = r[0]; *r = &x[3]; s = s.wrapping_mul(3).wrapping_add(q ^ r[1]); } } for i in 0..3 { let q = a[i].unwrap_or(&x[2]); a[i] = Some(&x[1]); s = s.wrapping_mul(3).wrapping_add(q[0]); } if let Some(q) = a[1] { a[1] = Some(&x[2]); s = s.wrapping_mul(3).wrapping_add(q[0]); } match a { [Some(p), .., z] => { a = [None; 3]; s = s.wrapping_mul(3).wrapping_add(p[0]).wrapping_add(z.unwrap()[1]); } _ => {} } let c = a.map(|o| o.map_or(1, |v| v[0])); s.wrapping_add(c[0]).wrapping_add(a[0].is_none() as i32) }
#[function(expand)]
fn found_references_in_parts_11_e<'a>(a: impl Iterator<Item = &'a i32> + Clone, k: i32) -> i32 { let mut s = k; for y in a.clone() { s = s.wrapping_mul(3).wrapping_add(*y); } for y in a { s = s.wrapping_mul(3).wrapping_add(*y); } s }
#[function]
pub fn found_references_in_parts_11(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = (&x[0], 3); let b = found_references_in_parts_11_e(t.0.iter(), { t.0 = &x[2]; t.1 }); let c = found_references_in_parts_11_e(t.0.iter().chain(&x[0]), { t.0 = &x[3]; t.1 }); let d = found_references_in_parts_11_e(t.0.iter().filter(|v| **v > 0), { t.0 = &x[1]; t.1 }); let e = found_references_in_parts_11_e(t.0.iter().skip(1), { t.0 = &x[0]; t.1 }); b.wrapping_mul(3).wrapping_add(c).wrapping_mul(3).wrapping_add(d).wrapping_add(e) }
#[function]
pub fn found_references_in_parts_12(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = (&x[0], 3); let it = t.0.into_iter(); t.0 = &x[1]; let mut s = 0i32; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } let it = t.0.iter().chain(t.0); t.0 = &x[2]; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } let it = x[0].iter().chain(t.0); t.0 = &x[3]; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } let it = x[0].iter().zip(t.0.iter().rev()); t.0 = &x[1]; for (y, z) in it { s = s.wrapping_mul(3).wrapping_add(*y ^ z); } let it = t.0.iter().take(1).copied(); t.0 = &x[2]; for y in it { s = s.wrapping_mul(3).wrapping_add(y); } let it = t.0.iter().step_by(1); t.0 = &x[0]; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } let it = t.0.iter().take(3); t.0 = &x[1]; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } let it = t.0.windows(1); t.0 = &x[3]; for y in it { s = s.wrapping_mul(3).wrapping_add(y[0]); } let it = t.0.chunks(1); t.0 = &x[2]; for y in it { s = s.wrapping_mul(3).wrapping_add(y[0]); } s }
#[function]
pub fn found_references_in_parts_13(x: [[i32; 2]; 4], n: i32) -> i32 { let mut a = [(&x[0], 1), (&x[1], 2)]; let mut s = 0i32; let it = a[0].0.iter(); a[0].0 = &x[2]; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } s }
#[function]
pub fn found_references_in_parts_14(x: [[i32; 2]; 4], n: i32) -> i32 { let mut a = [(&x[0], 1), (&x[1], 2)]; let mut s = 0i32; for y in a[1].0 { a[1] = a[0]; s = s.wrapping_mul(3).wrapping_add(*y); } let v = a[0].0.iter().map(|y| { a[0].0 = &x[3]; y ^ 1 }).fold(0_i32, |a, b| a.wrapping_mul(3).wrapping_add(b)); s ^ v }
#[function]
pub fn found_references_in_parts_15(x: [[i32; 2]; 4], n: i32) -> i32 { let mut s = 0i32; let mut o = Some(&x[0]); let it = o.unwrap().iter(); o = Some(&x[1]); for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } for y in o.unwrap() { o = Some(&x[2]); s = s.wrapping_mul(3).wrapping_add(*y); } s }
#[data]
#[derive(Clone, Copy)]
pub struct FoundReferencesInParts16s<'a> { pub r: &'a [i32; 2], pub k: i32 }
#[function]
pub fn found_references_in_parts_16(x: [[i32; 2]; 4], n: i32) -> i32 { let mut v = FoundReferencesInParts16s { r: &x[0], k: n }; let m = &mut v.r; *m = &x[1]; let a = m[0]; *m = &x[2]; let FoundReferencesInParts16s { r: q, .. } = &mut v; let b = q[1]; *q = &x[3]; let mut t = (&x[0], 3); let z = &mut t.0; *z = &x[1]; let c = z[0]; *z = &x[3]; let mut ff = |w: &mut &'_ [i32; 2]| { 3 }; a.wrapping_mul(3).wrapping_add(b).wrapping_mul(3).wrapping_add(c).wrapping_add(v.r[0]).wrapping_add(t.0[1]) }
#[data]
#[derive(Clone, Copy)]
pub struct FoundReferencesInParts17s<'a> { pub r: &'a [i32; 2], pub k: i32 }
#[function]
pub fn found_references_in_parts_17(x: [[i32; 2]; 4], n: i32) -> i32 { let mut v = [FoundReferencesInParts17s { r: &x[0], k: n }, FoundReferencesInParts17s { r: &x[1], k: 2 }]; let mut s = 0i32; for e in v.iter_mut() { let q = e.r; e.r = &x[2]; for y in q { e.k ^= y; } for y in e.r.iter() { e.r = &x[3]; e.k = e.k.wrapping_mul(3).wrapping_add(*y); } s = s.wrapping_mul(3).wrapping_add(e.k); } let it = v[1].r.iter().zip(v[0].r); v[1].r = &x[0]; v[0] = v[1]; for (a, b) in it { s = s.wrapping_mul(3).wrapping_add(a ^ b); } v.swap(0, 1); let w = v[0].r; v.reverse(); s.wrapping_add(w[0]) }
#[function]
pub fn found_references_in_parts_18(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = [(1, (&x[0], Some(&x[1]))), (2, (&x[2], None))]; let i = (n & 1) as usize; let (a, (b, c)) = t[i]; t[i].1 = (&x[3], Some(&x[0])); let d = t[i].1.0; t[i] = t[1 - i]; let e = c.map_or(3, |v| v[0]); let f = &t[1 - i].1.1; let g = f.map_or(1, |v| v[1]); let [(_, (h, _)), (_, (_, j))] = t; t = [t[0]; 2]; a.wrapping_mul(3).wrapping_add(b[0]).wrapping_mul(3).wrapping_add(d[0]).wrapping_mul(3).wrapping_add(e).wrapping_add(g).wrapping_mul(3).wrapping_add(h[0]).wrapping_add(j.is_some() as i32) }
#[function]
fn found_references_in_parts_19_go<'a>(v: &mut [(&'a [i32; 2], i32); 2], q: &'a [i32; 2], f: impl Fn(&[i32; 2]) -> i32) -> i32 { let r = v[0].0; v[0].0 = q; let a = f(r); let b = &v[0].0[1]; v.swap(0, 1); a.wrapping_mul(3).wrapping_add(*b).wrapping_add(f(v[0].0)) }
#[function]
pub fn found_references_in_parts_19(x: [[i32; 2]; 4], n: i32) -> i32 { let mut v = [(&x[0], n), (&x[1], 2)]; let a = found_references_in_parts_19_go(&mut v, &x[2], |r| r[0] ^ n); let mut t = (&x[3], n); let b = found_references_in_parts_19_go(&mut v, &x[0], |r| r[1] ^ t.0[0]); t.0 = &x[1]; a.wrapping_mul(5).wrapping_add(b).wrapping_add(t.0[0]).wrapping_add(v[1].0[0]) }
