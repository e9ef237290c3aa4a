// Patterns of bytes and with names inside `|` in their parts, closures by reference, chains of any two, defaults, keys that are references, ranges of floats.
#[function]
fn found_idioms_fs_apply(f: impl Fn(i32) -> i32, x: i32) -> i32 {
    f(x).wrapping_add(1)
}
#[function]
fn found_idioms_fs_twice<F: FnMut(i32) -> i32>(mut f: F, x: i32) -> i32 {
    found_idioms_fs_apply2(&mut f, x) ^ found_idioms_fs_apply2(&mut f, x)
}
#[function]
fn found_idioms_fs_apply2(mut f: impl FnMut(i32) -> i32, x: i32) -> i32 {
    f(x).wrapping_mul(3)
}
#[function]
fn found_idioms_fs_sum(f: impl Fn(i32) -> i32, x: i32) -> i32 {
    found_idioms_fs_apply(&f, x).wrapping_add(found_idioms_fs_apply(&f, x ^ 1))
}
#[function]
pub fn found_idioms_fs(a: i32, b: i32, xs: [i32; 3]) -> i32 {
    let mut n = 0_i32;
    let g = |x: i32| x ^ b;
    let mut h = |x: i32| { n = n.wrapping_add(1); x.wrapping_mul(n) };
    let r = found_idioms_fs_apply(&g, a).wrapping_add(found_idioms_fs_twice(&mut h, b)).wrapping_add(found_idioms_fs_sum(|x| x.wrapping_sub(a), b)).wrapping_add(found_idioms_fs_sum(&g, 3)).wrapping_add(found_idioms_fs_apply(&|x| x ^ 5, 3));
    r ^ n ^ g(2)
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundIdiomsOrsDrive {
    #[default]
    Idle,
    Ramping { target: u16, now: u16 },
    Running { speed: u16, ticks: u32 },
    Braking(u16, [u16; 2]),
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundIdiomsOrsEv { Tick, Stop(u16), Go(u16), Off }
#[function]
fn found_idioms_ors_make(k: u8, x: u16, y: u16) -> FoundIdiomsOrsDrive {
    match k & 3 { 0 => FoundIdiomsOrsDrive::Idle, 1 => FoundIdiomsOrsDrive::Ramping { target: x, now: y }, 2 => FoundIdiomsOrsDrive::Running { speed: x, ticks: y as u32 }, _ => FoundIdiomsOrsDrive::Braking(x, [y, x ^ y]) }
}
#[function]
fn found_idioms_ors_ev(k: u8, x: u16) -> FoundIdiomsOrsEv {
    match k & 3 { 0 => FoundIdiomsOrsEv::Tick, 1 => FoundIdiomsOrsEv::Stop(x), 2 => FoundIdiomsOrsEv::Go(x), _ => FoundIdiomsOrsEv::Off }
}
#[function]
fn found_idioms_ors_odd(x: u16, n: &mut u32) -> bool { *n = n.wrapping_mul(31).wrapping_add(x as u32 + 1); x & 1 == 1 }
#[function]
pub fn found_idioms_ors(k: u8, l: u8, x: u16, y: u16) -> u32 {
    let d = found_idioms_ors_make(k, x, y);
    let e = found_idioms_ors_ev(l, y);
    let mut n = 0u32;
    let a = match (d, e) {
        (FoundIdiomsOrsDrive::Ramping { now: v, .. } | FoundIdiomsOrsDrive::Running { speed: v, .. }, FoundIdiomsOrsEv::Stop(w) | FoundIdiomsOrsEv::Go(w)) => v as u32 * 3 + w as u32,
        (FoundIdiomsOrsDrive::Braking(v, [_, w] | [w, 3]), FoundIdiomsOrsEv::Tick | FoundIdiomsOrsEv::Off) if found_idioms_ors_odd(v, &mut n) || found_idioms_ors_odd(w, &mut n) => v as u32 * 7 + w as u32,
        (FoundIdiomsOrsDrive::Braking(v, [w @ 0..=30000, _] | [_, w]), _) => v as u32 ^ w as u32,
        (x @ (FoundIdiomsOrsDrive::Idle | FoundIdiomsOrsDrive::Running { .. }), FoundIdiomsOrsEv::Tick) => (x == FoundIdiomsOrsDrive::Idle) as u32,
        _ => 9,
    };
    let pair = (Some(d), [e, found_idioms_ors_ev(k, x)]);
    let b = match &pair {
        (Some(FoundIdiomsOrsDrive::Ramping { now: v, .. } | FoundIdiomsOrsDrive::Braking(_, [v, _])), [FoundIdiomsOrsEv::Stop(w) | FoundIdiomsOrsEv::Go(w), _] | [_, FoundIdiomsOrsEv::Stop(w)]) => (*v as u32) << 3 ^ *w as u32,
        (_, [.., FoundIdiomsOrsEv::Go(w) | FoundIdiomsOrsEv::Stop(w)]) => *w as u32,
        _ => 1,
    };
    let mut q = pair;
    match &mut q {
        (Some(FoundIdiomsOrsDrive::Ramping { now: v, .. } | FoundIdiomsOrsDrive::Running { speed: v, .. }), _) => *v = v.wrapping_add(3),
        (_, [FoundIdiomsOrsEv::Go(v) | FoundIdiomsOrsEv::Stop(v), _]) => *v ^= 1,
        _ => {}
    }
    let c = 0;
    a.wrapping_mul(31).wrapping_add(b).wrapping_mul(31).wrapping_add(c).wrapping_add(n) ^ (q != pair) as u32
}
#[function]
fn found_idioms_bytes_kind(word: &[u8]) -> i32 {
    match word {
        b"GO" => 1,
        b"STOP" | b"HALT" => 2,
        [b'S', rest @ ..] if !rest.is_empty() => rest.len() as i32 + 10,
        b"" => 3,
        _ => 4,
    }
}
#[function]
pub fn found_idioms_bytes(k: u8, raw: [u8; 4]) -> i32 {
    let word = match k & 3 { 0 => *b"GOOD", 1 => *b"STOP", 2 => *b"HALT", _ => raw };
    let n = (k >> 2) as usize % 5;
    let fixed = match &word { b"STOP" => 100, b"SLOW" => 200, _ => 0 };
    let by_value = match word { [b'G', ..] => 1, _ => 0 };
    let o = if let b"HA" = &word[..2] { 1000 } else { 0 };
    let s = matches!(raw.get(..2), Some(b"AB")) as i32;
    found_idioms_bytes_kind(&word[..n]) + fixed + by_value + o + s
}
#[function]
pub fn found_idioms_chains(a: [i32; 4], b: [i32; 3], n: u8) -> i64 {
    let n = n as usize % 5;
    let mut t = 0i64;
    let (x, y) = a.split_at(n);
    for (i, v) in x.iter().rev().chain(y.iter().rev()).enumerate() {
        t = t.wrapping_mul(31).wrapping_add(*v as i64 * (i as i64 + 1));
        if t & 7 == 3 { break; }
    }
    let s: i64 = x.iter().rev().chain(y.iter().rev()).zip(&b).map(|(p, q)| *p as i64 * *q as i64).sum();
    let u = a.into_iter().chain(b).fold(0i64, |s, v| s.wrapping_mul(3).wrapping_add(v as i64));
    let w = (0..n).chain(2..4).map(|i| a[i.min(3)] as i64).fold(0i64, |s, v| s.wrapping_mul(5).wrapping_add(v));
    let z = a.iter().step_by(2).chain(b.iter().skip(1)).fold(0i64, |s, v| s.wrapping_mul(7).wrapping_add(*v as i64));
    let m = a.windows(2).chain(b.windows(2)).filter(|p| p[0] < p[1]).count() as i64;
    let e = a.iter().enumerate().chain(b.iter().enumerate()).map(|(i, v)| i as i64 ^ *v as i64).fold(0i64, |s, v| s.wrapping_mul(7).wrapping_add(v));
    t ^ s ^ u.rotate_left(3) ^ w.rotate_left(9) ^ z.rotate_left(15) ^ m ^ e.rotate_left(21)
}
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundIdiomsDfltGain { k: f32, n: [u8; 2] }
impl Default for FoundIdiomsDfltGain { fn default() -> Self { FoundIdiomsDfltGain { k: 2.5, n: [3, 4] } } }
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundIdiomsDfltMode { Off, #[default] On, Of(u8) }
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundIdiomsDfltPlain { A, #[default] B }
#[function]
fn found_idioms_dflt_pick<T: Copy + Default>(x: Option<T>, y: Result<T, u8>) -> (T, T) { (x.unwrap_or_default(), y.unwrap_or_default()) }
#[function]
fn found_idioms_dflt_get(g: FoundIdiomsDfltGain, c: bool) -> Result<FoundIdiomsDfltGain, u8> { if c { Ok(g) } else { Err(g.n[0]) } }
#[function]
pub fn found_idioms_dflt(k: f32, c: u8, v: [f64; 3]) -> (FoundIdiomsDfltGain, FoundIdiomsDfltGain, f32, u32) {
    let g = FoundIdiomsDfltGain { k, n: [c, 7] };
    let a = (c & 1 == 1).then_some(g).unwrap_or_default();
    let b = found_idioms_dflt_get(g, c & 2 == 2).unwrap_or_default();
    let m = (c & 1 == 1).then_some(FoundIdiomsDfltMode::Of(c)).unwrap_or_default();
    let p: FoundIdiomsDfltPlain = (c & 1 == 1).then_some(FoundIdiomsDfltPlain::A).unwrap_or_default();
    let f: f32 = (c & 4 == 4).then_some(k).unwrap_or_default();
    let i = v.iter().position(|x| *x > 1.0).unwrap_or_default();
    let arr: [i16; 2] = (c & 4 == 4).then_some([c as i16; 2]).unwrap_or_default();
    let vec: Vector3<f64> = (c & 4 == 4).then_some(Vector3::from(v)).unwrap_or_default();
    let t: (u8, bool) = (c & 8 == 8).then_some((c, true)).unwrap_or_default();
    let o: Option<u8> = (c & 8 == 8).then_some(Some(c)).unwrap_or_default();
    let l: List<u8, 3> = (c & 8 == 8).then_some(List::new()).unwrap_or_default();
    let (x, y) = found_idioms_dflt_pick((c & 1 == 1).then_some(m), if c & 2 == 2 { Ok(FoundIdiomsDfltMode::Off) } else { Err(3) });
    let (x2, y2) = found_idioms_dflt_pick((c & 1 == 1).then_some(3_u16), if c & 2 == 2 { Ok(4) } else { Err(3) });
    let s = (m == FoundIdiomsDfltMode::On) as u32 + (p == FoundIdiomsDfltPlain::B) as u32 * 2 + i as u32 * 4 + arr[1] as u32 + (vec[0] > 1.0) as u32 * 16 + t.0 as u32 + t.1 as u32 + o.unwrap_or(9) as u32 + l.len() as u32 + (x == y) as u32 + x2 as u32 + y2 as u32;
    (a, b, f, s)
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct FoundIdiomsKeysKey { a: u8, b: i8 }
#[function]
pub fn found_idioms_keys(xs: [i16; 5], ks: [u8; 4]) -> u32 {
    let a = xs.iter().enumerate().max_by_key(|&(_, n)| n).map_or(9, |(i, _)| i);
    let b = xs.iter().enumerate().min_by_key(|&(_, n)| n).map_or(9, |(i, _)| i);
    let keys = ks.map(|k| FoundIdiomsKeysKey { a: k & 1, b: k as i8 });
    let c = keys.iter().enumerate().max_by_key(|(_, k)| *k).map_or(9, |(i, _)| i);
    let d = keys.iter().enumerate().min_by_key(|(_, k)| &k.b).map_or(9, |(i, _)| i);
    let e = ks.iter().max_by_key(|k| *k).copied().unwrap_or(0);
    (a * 1000 + b * 100 + c * 10 + d) as u32 * 256 + e as u32
}
#[function]
fn found_idioms_fr_span(r: core::ops::Range<f64>, k: f64) -> f64 { if r.contains(&k) { r.end - r.start } else { r.start } }
#[function]
pub fn found_idioms_fr(a: f64, b: f64) -> f64 {
    let inside = (-1.0..2.5).contains(&b);
    found_idioms_fr_span(0.0..a, b) + found_idioms_fr_span(-1.0..1.0, a) + if inside { 1.0 } else { 0.0 }
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundIdiomsKrefS { a: i32, b: [i32; 2] }
#[function]
fn found_idioms_kref_with<T: Copy>(s: &FoundIdiomsKrefS, f: impl Fn(&FoundIdiomsKrefS) -> &T) -> T { let r = f(s); *r }
#[function]
pub fn found_idioms_kref(a: i32, b: [i32; 2]) -> i32 {
    let mut s = FoundIdiomsKrefS { a, b };
    let x = found_idioms_kref_with(&s, |s| &s.b[1]);
    let y = found_idioms_kref_with(&s, |s| &s.a);
    x ^ y.rotate_left(3) ^ s.b[0].rotate_left(7)
}
#[function]
fn found_idioms_r2_len(r: core::ops::Range<f64>) -> f64 {
    r.end - r.start
}
#[function]
fn found_idioms_r2_count(r: core::ops::Range<u16>) -> u16 {
    r.end.wrapping_sub(r.start)
}
#[function]
pub fn found_idioms_r2(a: f64, b: f64, n: u16) -> f64 {
    let r = core::ops::Range { start: a, end: b };
    found_idioms_r2_len(core::ops::Range { start: a, end: b }) + r.end + f64::from(found_idioms_r2_count(core::ops::Range { start: 3, end: n }))
}
