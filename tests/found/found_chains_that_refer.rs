// Conditions in which what stands behind a pattern lets a value refer to something else.
#[function]
pub fn found_chains_that_refer_0(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut t = (&x[0], &x[1]);
    let (p, q) = t; t = (&x[2], &x[3]);
    let r = t.0; let s = t.1[0]; t.0 = &x[1];
    let mut o = Some(&x[2]);
    let u = if let Some(v) = o && { o = None; true } && v[0] != n { v[1] } else { 3 };
    let mut best = (x[0][0], &x[0]);
    for y in &x { let (b, at) = best; if y[0] > b { best = (y[0], y); } if at[1] == n { best.0 = at[0]; } }
    let (b, c) = best; best = (1, &x[3]);
    let w = match (t, o) { ((a, b), None) => { t = (&x[3], &x[3]); a[0].wrapping_sub(b[1]) } ((a, _), Some(_)) => a[1] };
    p[0].wrapping_add(q[1]).wrapping_mul(3).wrapping_add(r[0]).wrapping_mul(3).wrapping_add(s).wrapping_add(u).wrapping_mul(3).wrapping_add(b).wrapping_add(c[1]).wrapping_mul(3).wrapping_add(best.1[0]).wrapping_add(t.0[1]).wrapping_add(w)
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundChainsThatRefer1 { pub a: i32, pub b: [i32; 2] }
#[function]
fn found_chains_that_refer_1_pick(s: &[FoundChainsThatRefer1; 3], n: i32) -> Option<&FoundChainsThatRefer1> { s.iter().find(|q| q.a > n) }
#[function]
pub fn found_chains_that_refer_1(x: [i32; 6], n: i32) -> i32 {
    let mut s = [FoundChainsThatRefer1 { a: x[0], b: [x[1], 2] }, FoundChainsThatRefer1 { a: x[2], b: [x[3], 4] }, FoundChainsThatRefer1 { a: x[4], b: [x[5], 6] }];
    let mut best: Option<&FoundChainsThatRefer1> = None; let mut k = 0;
    for y in &s { if best.is_none_or(|q| q.a < y.a) { best = Some(y); } if let Some(b) = best && { best = Some(y); b.a != n } { k = k + (b.b[0] & 7); } }
    let z = best.map_or(3, |q| q.b[1]);
    let was = found_chains_that_refer_1_pick(&s, n).copied(); s[0].a = 5; s[1] = FoundChainsThatRefer1 { a: 1, b: [2, 3] };
    let f = s.iter().map(|q| (q, q.a)).max_by_key(|(_, a)| *a).map(|(q, _)| q.b[0]).unwrap_or(8);
    let g = s.iter().rev().enumerate().skip(1).map(|(i, q)| (i, q)).fold((0, &s[0]), |(a, p), (i, q)| if q.a > p.a { (a + 1, q) } else { (a + i as i32, p) });
    let mut pair = (&s[0], 3); let w = pair.0; pair = (&s[2], w.a & 3); let h = pair.0.b[1] + w.b[1] + pair.1;
    was.map_or(4, |q| q.a).wrapping_add(k).wrapping_mul(3).wrapping_add(z).wrapping_add(f).wrapping_mul(3).wrapping_add(g.0).wrapping_add(g.1.a).wrapping_add(h)
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundChainsThatRefer2<'a> { pub at: &'a [i32], pub k: i32 }
#[function]
pub fn found_chains_that_refer_2(x: [i32; 6], n: i32) -> i32 {
    let mut s = FoundChainsThatRefer2 { at: &x[1..4], k: n };
    let FoundChainsThatRefer2 { at, k } = s; s = FoundChainsThatRefer2 { at: &x[3..], k: 2 };
    let mut t = (s, 1); let (FoundChainsThatRefer2 { at: b, .. }, m) = t; t = (FoundChainsThatRefer2 { at, k: 4 }, 5);
    let mut o = Some(s); let c = if let Some(FoundChainsThatRefer2 { at: q, .. }) = o && { o = None; true } && q.len() > 2 { q[2] } else { 9 };
    s.at = &s.at[1..]; let d = s.at; s.at = at;
    at[0].wrapping_add(k).wrapping_mul(3).wrapping_add(b[0]).wrapping_add(m).wrapping_mul(3).wrapping_add(t.0.at[1]).wrapping_add(c).wrapping_mul(3).wrapping_add(d[0]).wrapping_add(d.len() as i32).wrapping_add(s.at[2]).wrapping_add(o.is_none() as i32)
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundChainsThatRefer3<'a> { pub at: &'a [i32], pub k: i32 }
#[function]
pub fn found_chains_that_refer_3(x: [i32; 6], n: i32) -> i32 {
    let s = FoundChainsThatRefer3 { at: &x[1..4], k: n };
    let mut o = Some(s); if let Some(FoundChainsThatRefer3 { at: mut q, .. }) = o && { if n > 3 { q = &q[1..]; } true } && q.len() > 2 { q[2] } else { 9 }
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundChainsThatRefer4<'a> { pub at: &'a [i32], pub k: i32 }
#[function]
pub fn found_chains_that_refer_4(x: [i32; 6], n: i32) -> i32 {
    let s = FoundChainsThatRefer4 { at: &x[1..4], k: n };
    let mut o = Some(s); if let Some(FoundChainsThatRefer4 { at: q, .. }) = o && { o = Some(FoundChainsThatRefer4 { at: &x[3..], k: 5 }); true } && q.len() > 2 { q[2] } else { 9 }
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundChainsThatRefer5<'a> { pub at: &'a [i32], pub k: i32 }
#[function]
pub fn found_chains_that_refer_5(x: [i32; 6], n: i32) -> i32 {
    let mut o = Some(FoundChainsThatRefer5 { at: &x[1..], k: n }); let mut s = 0_i32; let mut i = 0;
    #[bound(9)]
    while let Some(FoundChainsThatRefer5 { at: q, k }) = o && { o = if q.len() > 1 { Some(FoundChainsThatRefer5 { at: &q[1..], k: k.wrapping_add(1) }) } else { None }; i += 1; true } && q.len() > i - 1 { s = s.wrapping_mul(3).wrapping_add(q[0]).wrapping_add(k); }
    let mut t = (&x[0], &x[1]);
    let mut w = 0;
    #[bound(9)]
    while let (a, b) = t && { t = (b, &x[w + 2]); w += 1; w < 4 } && *a != n { s = s.wrapping_mul(5).wrapping_add(a ^ b); }
    s
}
