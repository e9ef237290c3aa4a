// Arguments of closures that what is given behind them writes.
#[function(expand)]
fn found_arguments_of_closures_0_ex(mut f: impl FnMut(i32, i32) -> i32, x: i32, v0: [i32; 3]) -> i32 { let mut s = x; let mut v = v0; let mut i = 0; let a = f(s, { s = s.wrapping_add(1); s }); let b = f(v[i], { i += 1; v[0] = 9; v[i] }); let e = f(s, 2); let c = f(s, e); a.wrapping_mul(3).wrapping_add(b).wrapping_mul(3).wrapping_add(c).wrapping_add(v[0]) }
#[function(expand)]
fn found_arguments_of_closures_0_st(mut f: impl FnMut([i32; 3], i32) -> i32, x: [i32; 3]) -> i32 { let mut v = x; let a = f(v, { v[0] = 5; v[1] = 4; 3 }); let b = f({ v[2] = 3; v }, v[1]); a.wrapping_mul(7).wrapping_add(b) }
#[function]
pub fn found_arguments_of_closures_0(x: i32, v: [i32; 3]) -> i32 {
    let mut k = 1_i32; let mut w = v;
    let p = found_arguments_of_closures_0_ex(|a, b| { k = k.wrapping_add(b); a.wrapping_mul(5).wrapping_add(b) }, x, v);
    let q = found_arguments_of_closures_0_ex(|a, mut b| { b ^= 1; w[0] = a; w[0].wrapping_sub(b) }, x, v);
    let r = found_arguments_of_closures_0_st(|[a, b, c], d| a.wrapping_mul(3).wrapping_add(b).wrapping_mul(3).wrapping_add(c).wrapping_add(d), w);
    let s = found_arguments_of_closures_0_st(|a, d| { w[1] = d; a[1].wrapping_add(w[1]) }, v);
    p.wrapping_mul(3).wrapping_add(q).wrapping_mul(3).wrapping_add(r).wrapping_mul(3).wrapping_add(s).wrapping_add(k).wrapping_add(w[1])
}
#[function]
pub fn found_arguments_of_closures_1(x: i32, v: [i32; 3]) -> i32 {
    let mut w = v; let mut n = x; let mut t = (x, v[0]);
    let mut f = |a: i32, b: i32| { w[0] = w[0].wrapping_add(b); a.wrapping_mul(3).wrapping_add(w[0]) };
    let p = f(n, { n ^= 5; n }); let q = f(t.0, { t = (4, 5); t.1 });
    let g = |(a, b): (i32, i32), c: [i32; 3]| { let [d, ..] = c; a.wrapping_mul(3).wrapping_add(b).wrapping_mul(3).wrapping_add(d) };
    let r = g(t, { t.0 = 9; t.1 = 8; w }); let s = g((n, { n = 3; n }), { w[0] = n; w });
    let h = |a: Option<i32>, b: i32| a.map_or(b, |a| a ^ b); let mut o = Some(n); let u = h(o, { o = None; 4 }); let z = h(o, { o = Some(1); 5 });
    p.wrapping_mul(3).wrapping_add(q).wrapping_mul(3).wrapping_add(r).wrapping_mul(3).wrapping_add(s).wrapping_add(u).wrapping_mul(3).wrapping_add(z).wrapping_add(o.unwrap_or(2))
}
#[function]
pub fn found_arguments_of_closures_2(x: [i32; 4], n: i32) -> i32 {
    let mut k = n; let mut w = x;
    let a = x.iter().map(|y| (k, { k = k.wrapping_mul(3).wrapping_add(*y); k })).fold(0_i32, |a, (p, q)| a.wrapping_mul(5).wrapping_add(p ^ q));
    let b = x.iter().map(|y| (w[0], { w[0] = w[0].wrapping_add(*y); *y })).filter(|(p, q)| p > q).map(|(p, q)| [p, { k = k.wrapping_add(q); k }]).fold(0_i32, |a, [p, q]| a.wrapping_mul(5).wrapping_add(p ^ q));
    let c = x.iter().zip(x.iter().rev()).map(|(p, q)| (k, *p, { k ^= q; k })).max_by_key(|(p, q, r)| p ^ q ^ r).map_or(0, |(p, q, r)| p.wrapping_sub(q).wrapping_add(r));
    let d = x.iter().scan((1, n), |s, y| { let (p, q) = *s; *s = (q, p.wrapping_add(*y)); s.0 ^= 1; Some((p, s.1)) }).fold(0_i32, |a, (p, q)| a.wrapping_mul(3).wrapping_add(p ^ q));
    let e = x.iter().enumerate().map(|(i, y)| (i, k, { k = k.wrapping_add(1); y })).find(|(i, p, y)| *p > **y && *i > 0).map_or(2, |(i, p, y)| p ^ y ^ i as i32);
    for (p, q) in x.iter().map(|y| (k, { k = k.wrapping_add(*y); y })) { w[1] = w[1].wrapping_mul(3).wrapping_add(p ^ q); }
    let mut f = |a: (i32, i32), b: i32| { k = k.wrapping_add(b); a.0.wrapping_mul(3).wrapping_add(a.1) };
    let g = f((n, 2), 3); let h = x.iter().fold((1, 2), |(p, q), y| (q, p.wrapping_add(*y))); let (h0, h1) = h;
    [b, c, d, e, g, h0, h1, w[1], k].iter().fold(a, |a, b| a.wrapping_mul(7).wrapping_add(*b))
}
