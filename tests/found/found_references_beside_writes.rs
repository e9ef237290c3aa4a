// References in variables that get another beside where they are matched, or given to closures.
#[function]
pub fn found_references_beside_writes(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut o = Some(&x[2]); let mut t = (&x[1], 2);
    let h = match (o.unwrap(), { o = Some(&x[0]); 1 }) { (r, k) => r[0].wrapping_add(k) };
    let i = match (t.0, o.unwrap(), { t.0 = &x[3]; o = None; 2 }) { ([p, _], [_, q], k) => p.wrapping_mul(3).wrapping_add(*q).wrapping_add(k) };
    let (e, g) = (o.unwrap_or(t.0), { t.0 = &x[2]; o = Some(&x[1]); t.0 });
    let f = |p: (&[i32; 2], i32), q: i32| p.0[1].wrapping_add(p.1).wrapping_mul(q);
    let j = f(t, { t = (&x[0], 9); t.1 });
    let k = f((t.0, t.1), { t = (&x[1], 7); t.1 });
    h.wrapping_mul(3).wrapping_add(i).wrapping_add(n).wrapping_add(o.map_or(3, |r| r[0])).wrapping_add(t.0[0]).wrapping_add(e[0]).wrapping_mul(5).wrapping_add(g[1]).wrapping_add(j).wrapping_mul(3).wrapping_add(k)
}
#[function]
pub fn found_references_beside_writes_a(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut t = (&x[1], 2);
    let f = |r: &[i32; 2], k: i32| r[0].wrapping_mul(3).wrapping_add(r[1]).wrapping_add(k);
    f(t.0, { t = (&x[2], 4); t.1 }).wrapping_add(t.0[0]).wrapping_add(n)
}
#[function]
pub fn found_references_beside_writes_a_b(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut o = Some(&x[0]);
    let f = |r: &[i32; 2], k: i32| r[0].wrapping_mul(3).wrapping_add(r[1]).wrapping_add(k);
    let b = f(o.unwrap(), { o = None; 3 });
    b.wrapping_add(n).wrapping_add(o.map_or(3, |r| r[0]))
}
