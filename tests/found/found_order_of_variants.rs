// `<` and what rests on it, of options, results and enums with payload.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum FoundOrderOfVariantsE { A(i32), B, C { x: f64, y: u8 }, D([i16; 6], bool) }
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FoundOrderOfVariantsF { Idle, At(i32), Between { low: i16, high: u8 } }
#[data]
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct FoundOrderOfVariantsS { pub first: Option<f32>, pub second: Result<u8, i8> }
// helper
#[function]
fn found_order_of_variants_e(k: u8, a: i32, x: f64) -> FoundOrderOfVariantsE {
    match k % 4 { 0 => FoundOrderOfVariantsE::A(a), 1 => FoundOrderOfVariantsE::B, 2 => FoundOrderOfVariantsE::C { x, y: k / 8 }, _ => FoundOrderOfVariantsE::D([a as i16, 1, 2, 3, 4, (k / 16) as i16], a > 0) }
}
// helper
#[function]
fn found_order_of_variants_f(k: u8, a: i32) -> FoundOrderOfVariantsF {
    match k % 3 { 0 => FoundOrderOfVariantsF::Idle, 1 => FoundOrderOfVariantsF::At(a), _ => FoundOrderOfVariantsF::Between { low: a as i16, high: k / 4 } }
}
#[function]
pub fn found_order_of_variants_0(k: u8, j: u8, a: i32, b: i32, x: f64, y: f64) -> u32 {
    let (p, q) = (found_order_of_variants_e(k, a, x), found_order_of_variants_e(j, b, y));
    let (r, s) = (found_order_of_variants_f(k, a), found_order_of_variants_f(j, b));
    let all = [p < q, p <= q, p > q, p >= q, p < found_order_of_variants_e(k, b, x), p >= found_order_of_variants_e(k, a, y), r < s, r <= s, r > s, r >= s, r < FoundOrderOfVariantsF::At(3), p <= FoundOrderOfVariantsE::B, p > FoundOrderOfVariantsE::C { x: 0.5, y: 1 }];
    let mut bits = 0;
    for it in all { bits = bits << 1 | it as u32; }
    bits
}
#[function]
pub fn found_order_of_variants_1(k: u8, j: u8, a: i32, b: i32, x: f32) -> u32 {
    let (o, p) = (if k & 1 == 0 { Some(a) } else { None }, if j & 1 == 0 { Some(b) } else { None });
    let (q, r): (Result<i32, u8>, Result<i32, u8>) = (if k & 2 == 0 { Ok(a) } else { Err(k) }, if j & 2 == 0 { Ok(b) } else { Err(j) });
    let (n, m) = (if k & 4 == 0 { Some(o) } else { None }, if j & 4 == 0 { Some(p) } else { None });
    let s = FoundOrderOfVariantsS { first: if k & 8 == 0 { Some(x) } else { None }, second: if k > 99 { Ok(k) } else { Err(-3) } };
    let t = FoundOrderOfVariantsS { first: if j & 8 == 0 { Some(1.0) } else { None }, second: if j > 99 { Ok(j) } else { Err(a as i8) } };
    let all = [o < p, o <= p, o > p, o >= p, q < r, q <= r, q > r, q >= r, n < m, n >= m, s < t, s <= t, s > t, s >= t, o < Some(3), None < o, o <= None, (o, q) < (p, r)];
    let mut bits = 0;
    for it in all { bits = bits << 1 | it as u32; }
    bits
}
