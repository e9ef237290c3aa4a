// Closures that call one another, whose parameters have one name.
#[function]
pub fn found_closures_that_call_0(n: i32, x: [i32; 3]) -> i32 {
    let f = |a: i32, b: i32| a.wrapping_mul(3).wrapping_add(b);
    let g = |a: i32| f(1, a);
    let h = |b: i32, a: i32| f(a, b).wrapping_sub(f(b, f(a, g(b))));
    let k = |(a, b): (i32, i32), c: i32| f(c, a).wrapping_add(h(b, c));
    let m = |b: (i32, i32)| k(b, f(b.1, b.0)) ^ k((b.1, 2), b.0);
    let mut s = 0_i32;
    let mut p = |a: i32, b: &mut i32| { s = s.wrapping_add(a); *b = b.wrapping_add(g(a)); };
    let mut t = n; let mut a = 5;
    p(t, &mut a); p(a, &mut t);
    g(n).wrapping_mul(3).wrapping_add(h(n, 4)).wrapping_mul(3).wrapping_add(m((n, x[0]))).wrapping_mul(3).wrapping_add(s).wrapping_add(t).wrapping_add(a)
}
#[function]
pub fn found_closures_that_call_1(n: i32, x: [i32; 3]) -> i32 {
    let f = |a: i32, b: i32| { if a == 3 { return b; } a.wrapping_mul(3).wrapping_add(b) };
    let g = |a: i32, c: i32| f(c, a);
    let r = x.map(|a| g(a, x.map(|b| f(a, b)).iter().fold(0_i32, |b, a| f(b, *a))));
    let o = Some(n).map(|a| f(2, a)).and_then(|b| Some(n).map(|a| f(b, a))).unwrap_or(f(n, 1));
    let q = g(f(1, g(2, f(3, n))), f(g(n, 3), 4));
    r[0].wrapping_add(r[1].wrapping_mul(3)).wrapping_add(r[2].wrapping_mul(7)).wrapping_add(o).wrapping_mul(3).wrapping_add(q)
}
