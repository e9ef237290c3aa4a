// What is lent stays the place that it was, whatever becomes of the index that led to it; and what is exchanged is the place.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundLender { pub x: i16, pub y: i16 }
#[function]
fn found_lenders_over(r: &mut [i16; 3], k: i16) -> Option<&mut i16> { r.iter_mut().find(|x| **x > k) }
#[function]
fn found_lenders_rest(r: &[i16; 3], k: usize) -> &[i16] { &r[k..] }
#[function]
fn found_lenders_pair(r: &mut [i16; 3], k: usize) -> (usize, &mut i16) { (k, &mut r[k % 3]) }
#[function]
fn found_lenders_next(i: &mut usize) -> usize { *i = (*i + 1) % 3; *i }
#[function]
fn found_lenders_of(k: usize, r: &mut [i16; 3], j: usize) -> Result<&mut i16, u8> { r.get_mut((k + j) % 4).ok_or(3) }
#[function]
fn found_lenders_turned(t: &mut (i16, i16)) -> i16 { core::mem::replace(t, (t.1, t.0)).0 }
#[function]
fn found_lenders_first(t: &mut [i16; 3]) -> i16 { let w = core::mem::replace(t, [t[1], 2, 3]); w[0] }
#[function]
fn found_lenders_kept(s: &mut FoundLender) -> i16 { core::mem::replace(s, FoundLender { x: 9, ..*s }).x }
#[function]
pub fn found_order_of_lenders(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut m = [a0, [k0, 2, a0[1]], [5, a0[2], k0 ^ 3]];
let mut i = n0 % 3;
let o = found_lenders_over(&mut m[i], 3);
i = (i + 1) % 3;
if let Some(x) = o { *x ^= 9; }
if let Some(x) = found_lenders_over(&mut m[i], k0) { i = (i + 2) % 3; *x = x.wrapping_add(i as i16); }
let s = found_lenders_rest(&m[i], 1);
i = (i + 1) % 3;
let mut sum = i64::from(s[0]) * 3 + i64::from(s[1]);
let (z, x) = found_lenders_pair(&mut m[i], found_lenders_next(&mut i));
i = z % 3;
*x ^= 77;
match found_lenders_of(found_lenders_next(&mut i), &mut m[i], found_lenders_next(&mut i)) { Ok(x) => { i = 0; *x = x.wrapping_mul(3); } Err(e) => { sum += i64::from(e); } }
let o = Some(&mut m[i][1]);
i = (i + 1) % 3;
if let Some(x) = o { *x ^= 7; }
let p = (i, &mut m[i][2]);
i = (i + 1) % 3;
*p.1 ^= p.0 as i16;
let mut pair = (a0[0], k0);
let mut of = [a0[1], k0, 4];
let mut kept = FoundLender { x: k0, y: a0[2] };
for x in [found_lenders_turned(&mut pair), found_lenders_first(&mut of), found_lenders_kept(&mut kept), pair.0, pair.1, of[0], of[1], kept.x, kept.y, i as i16] { sum = sum.wrapping_mul(31).wrapping_add(i64::from(x)); }
for r in m { for x in r { sum = sum.wrapping_mul(31).wrapping_add(i64::from(x)); } }
*t = t.wrapping_mul(31).wrapping_add(sum as u64);
sum
}
