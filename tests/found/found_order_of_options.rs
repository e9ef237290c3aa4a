// Methods of Option and Result: how often, and in which order, operands that write are computed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct FoundOrderOfOptionsTwo { pub a: i16, pub b: [i16; 3] }
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundOrderOfOptionsWay { #[default] Off, On(i16), Both { low: i16, high: i16 } }
#[function]
fn found_order_of_options_ti(x: usize, t: &mut u64) -> usize { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(1); (*t % 3) as usize }
#[function]
fn found_order_of_options_tv(x: i16, t: &mut u64) -> i16 { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); x ^ (*t as i16 & 3) }
#[function]
fn found_order_of_options_to(x: i16, t: &mut u64) -> Option<i16> { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); if *t % 3 == 0 { None } else { Some(x) } }
#[function]
fn found_order_of_options_bn(n: &mut usize) -> i16 { *n = n.wrapping_add(1) % 3; *n as i16 }
#[function]
fn found_order_of_options_bi(n: &mut usize) -> usize { *n = n.wrapping_add(1) % 3; *n }
#[function]
fn found_order_of_options_bon(n: &mut usize) -> Option<i16> { *n = n.wrapping_add(1) % 3; if *n == 1 { None } else { Some(*n as i16) } }
#[function]
fn found_order_of_options_bk(k: &mut i16) -> i16 { *k = k.wrapping_mul(3).wrapping_add(1); *k }
#[function]
fn found_order_of_options_bo(o: &mut [Option<i16>; 3]) -> i16 { o[0] = Some(5); o[1] = None; o[2] = Some(7); 8 }
#[function]
fn found_order_of_options_boo(o: &mut [Option<i16>; 3]) -> Option<i16> { o[0] = Some(5); o[1] = None; o[2] = Some(7); Some(8) }
#[function]
fn found_order_of_options_ba(a: &mut [i16; 3]) -> i16 { a[0] = a[0].wrapping_add(5); a[1] = 4; a[2] ^= 7; a[1] }
#[function]
fn found_order_of_options_bq(q: &mut [[i16; 3]; 3]) -> i16 { q[0] = [3, 4, 5]; q[1] = q[2]; q[2][1] = 3; q[1][1] }
#[function]
fn found_order_of_options_bw(w: &mut [FoundOrderOfOptionsWay; 3]) -> i16 { w[0] = FoundOrderOfOptionsWay::On(4); w[1] = FoundOrderOfOptionsWay::Off; w[2] = FoundOrderOfOptionsWay::Both { low: 3, high: 2 }; 3 }
#[function]
fn found_order_of_options_bs(s: &mut [FoundOrderOfOptionsTwo; 3]) -> i16 { s[0].a = 4; s[1].b[1] = 4; s[2] = s[0]; 3 }
#[function]
fn found_order_of_options_bx(o: &mut Option<i16>) -> i16 { let was = match o { Some(x) => *x, None => 3 }; *o = if was > 0 { None } else { Some(4) }; was }
#[function]
fn found_order_of_options_bv(v: &mut [Vector3<f64>; 3]) -> f64 { v[0] = v[1]; v[1] *= 2.0; v[2][1] = 3.0; 1.5 }
#[function]
fn found_order_of_options_bvv(v: &mut [Vector3<f64>; 3]) -> Vector3<f64> { v[0] = v[1]; v[1] *= 2.0; v[2][1] = 3.0; v[0] }
#[function]
fn found_order_of_options_bm(m: &mut SMatrix<f64, 3, 3>) -> f64 { m[(0, 0)] = 4.0; m[(1, 2)] = m[(2, 2)]; 1.5 }
#[function]
pub fn found_order_of_options_0(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].is_some() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].unwrap_or(found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].unwrap_or_else(|| found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].map(|x| x ^ 1).unwrap_or(2) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].map_or(5, |x| x ^ 1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_1(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].map_or(found_order_of_options_tv(k,t), |x| found_order_of_options_tv(x,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].and_then(|x| found_order_of_options_to(x,t)).unwrap_or(2) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].or(o[found_order_of_options_ti(n,t)]).unwrap_or(9) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].or(found_order_of_options_to(k,t)).unwrap_or(9) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].xor(found_order_of_options_to(k,t)).unwrap_or(9) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].and(found_order_of_options_to(k,t)).unwrap_or(9) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_2(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].filter(|x| *x > found_order_of_options_tv(k,t)).unwrap_or(9) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].is_some_and(|x| x > found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].is_none_or(|x| x > found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].zip(found_order_of_options_to(k,t)).map_or(4, |(a,b)| a ^ b) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].ok_or(k).is_ok() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[found_order_of_options_ti(n,t)].take().unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_3(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = o[found_order_of_options_ti(n,t)].replace(found_order_of_options_tv(k,t)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = *o[found_order_of_options_ti(n,t)].insert(found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = *o[found_order_of_options_ti(n,t)].get_or_insert(found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = *o[found_order_of_options_ti(n,t)].get_or_insert_with(|| found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].is_ok() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].ok().unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_4(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].err().unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let mut k = k0;
let z9 = r[found_order_of_options_ti(n,t)].unwrap_or(found_order_of_options_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].map(|x| found_order_of_options_tv(x,t)).unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].map_err(|x| x ^ 1).is_err() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].unwrap_or_else(|e| found_order_of_options_tv(e as i16,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[found_order_of_options_ti(n,t)].or_else(|e| Ok::<i16,u8>(found_order_of_options_tv(e as i16,t))).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_5(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].unwrap_or(found_order_of_options_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].unwrap_or(found_order_of_options_bo(&mut o)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].or(found_order_of_options_boo(&mut o)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].or(found_order_of_options_bon(&mut n)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].and(found_order_of_options_boo(&mut o)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].xor(found_order_of_options_boo(&mut o)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_6(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].xor(found_order_of_options_bon(&mut n)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].zip(found_order_of_options_boo(&mut o)).map_or(4, |(a,b)| a ^ b) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].zip(found_order_of_options_bon(&mut n)).map_or(4, |(a,b)| a ^ b) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].ok_or(found_order_of_options_bo(&mut o)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].ok_or(found_order_of_options_bn(&mut n)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].map_or(found_order_of_options_bo(&mut o), |x| x ^ 5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_7(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].map_or(found_order_of_options_bn(&mut n), |x| x ^ 5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].map_or_else(|| found_order_of_options_bo(&mut o), |x| x ^ 5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].unwrap_or_else(|| found_order_of_options_bo(&mut o)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].unwrap_or_else(|| found_order_of_options_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].map(|x| x ^ found_order_of_options_bo(&mut o)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].map(|x| x ^ found_order_of_options_bn(&mut n)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_8(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].and_then(|x| { found_order_of_options_bo(&mut o); o[n % 3] }).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].filter(|x| *x > found_order_of_options_bo(&mut o)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].is_some_and(|x| x > found_order_of_options_bo(&mut o)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].replace(found_order_of_options_bn(&mut n)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].insert(found_order_of_options_bn(&mut n)).wrapping_add(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].get_or_insert(found_order_of_options_bn(&mut n)).wrapping_add(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_options_9(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = o[n % 3].get_or_insert_with(|| found_order_of_options_bn(&mut n)).wrapping_add(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[n % 3].unwrap_or(found_order_of_options_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[n % 3].or(Ok::<i16, u8>(found_order_of_options_bn(&mut n))).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[n % 3].and(Ok::<i16, u8>(found_order_of_options_bn(&mut n))).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[n % 3].map(|x| x ^ found_order_of_options_bn(&mut n)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut r: [Result<i16, u8>; 3] = [if a0[0] & 1 == 0 { Ok(a0[0]) } else { Err(7) }, Ok(a0[1]), if a0[2] > 0 { Ok(a0[2]) } else { Err(a0[2] as u8) }];
let mut n = n0;
let z9 = r[n % 3].unwrap_or_else(|e| found_order_of_options_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
sum
}
