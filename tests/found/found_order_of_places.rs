// Assignments, literals and methods that write: how often, and in which order, operands that write are computed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct FoundOrderOfPlacesTwo { pub a: i16, pub b: [i16; 3] }
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundOrderOfPlacesWay { #[default] Off, On(i16), Both { low: i16, high: i16 } }
#[function]
fn found_order_of_places_ti(x: usize, t: &mut u64) -> usize { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(1); (*t % 3) as usize }
#[function]
fn found_order_of_places_tv(x: i16, t: &mut u64) -> i16 { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); x ^ (*t as i16 & 3) }
#[function]
fn found_order_of_places_to(x: i16, t: &mut u64) -> Option<i16> { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); if *t % 3 == 0 { None } else { Some(x) } }
#[function]
fn found_order_of_places_bn(n: &mut usize) -> i16 { *n = n.wrapping_add(1) % 3; *n as i16 }
#[function]
fn found_order_of_places_bi(n: &mut usize) -> usize { *n = n.wrapping_add(1) % 3; *n }
#[function]
fn found_order_of_places_bon(n: &mut usize) -> Option<i16> { *n = n.wrapping_add(1) % 3; if *n == 1 { None } else { Some(*n as i16) } }
#[function]
fn found_order_of_places_bk(k: &mut i16) -> i16 { *k = k.wrapping_mul(3).wrapping_add(1); *k }
#[function]
fn found_order_of_places_bo(o: &mut [Option<i16>; 3]) -> i16 { o[0] = Some(5); o[1] = None; o[2] = Some(7); 8 }
#[function]
fn found_order_of_places_boo(o: &mut [Option<i16>; 3]) -> Option<i16> { o[0] = Some(5); o[1] = None; o[2] = Some(7); Some(8) }
#[function]
fn found_order_of_places_ba(a: &mut [i16; 3]) -> i16 { a[0] = a[0].wrapping_add(5); a[1] = 4; a[2] ^= 7; a[1] }
#[function]
fn found_order_of_places_bq(q: &mut [[i16; 3]; 3]) -> i16 { q[0] = [3, 4, 5]; q[1] = q[2]; q[2][1] = 3; q[1][1] }
#[function]
fn found_order_of_places_bw(w: &mut [FoundOrderOfPlacesWay; 3]) -> i16 { w[0] = FoundOrderOfPlacesWay::On(4); w[1] = FoundOrderOfPlacesWay::Off; w[2] = FoundOrderOfPlacesWay::Both { low: 3, high: 2 }; 3 }
#[function]
fn found_order_of_places_bs(s: &mut [FoundOrderOfPlacesTwo; 3]) -> i16 { s[0].a = 4; s[1].b[1] = 4; s[2] = s[0]; 3 }
#[function]
fn found_order_of_places_bx(o: &mut Option<i16>) -> i16 { let was = match o { Some(x) => *x, None => 3 }; *o = if was > 0 { None } else { Some(4) }; was }
#[function]
fn found_order_of_places_bv(v: &mut [Vector3<f64>; 3]) -> f64 { v[0] = v[1]; v[1] *= 2.0; v[2][1] = 3.0; 1.5 }
#[function]
fn found_order_of_places_bvv(v: &mut [Vector3<f64>; 3]) -> Vector3<f64> { v[0] = v[1]; v[1] *= 2.0; v[2][1] = 3.0; v[0] }
#[function]
fn found_order_of_places_bm(m: &mut SMatrix<f64, 3, 3>) -> f64 { m[(0, 0)] = 4.0; m[(1, 2)] = m[(2, 2)]; 1.5 }
#[function]
pub fn found_order_of_places_0(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = a.contains(&a[found_order_of_places_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut k = k0;
let z9 = a.contains(&found_order_of_places_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = ({ a[found_order_of_places_ti(n,t)] = found_order_of_places_tv(k,t); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = ({ a[found_order_of_places_ti(n,t)] ^= found_order_of_places_tv(k,t); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[found_order_of_places_ti(n,t)] ^= a[found_order_of_places_ti(n,t)]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_ti(n,t)][found_order_of_places_ti(n,t)] = a[found_order_of_places_ti(n,t)]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_1(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_ti(n,t)] = q[found_order_of_places_ti(n,t)]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a = [a[found_order_of_places_ti(n,t)], a[found_order_of_places_ti(n,t)], a[1]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = ({ a = [k, a[2], a[found_order_of_places_ti(n,t)]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = ({ a = [k, a[2], a[n % 3]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a = [a[n % 3], a[(n.wrapping_add(1)) % 3], a[(n.wrapping_mul(2)) % 3]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut s = [FoundOrderOfPlacesTwo { a: a0[0], b: a0 }, FoundOrderOfPlacesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfPlacesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let z9 = ({ s[found_order_of_places_ti(n,t)] = FoundOrderOfPlacesTwo { a: a[found_order_of_places_ti(n,t)], ..s[found_order_of_places_ti(n,t)] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_2(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut s = [FoundOrderOfPlacesTwo { a: a0[0], b: a0 }, FoundOrderOfPlacesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfPlacesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let mut k = k0;
let z9 = ({ s[n%3] = FoundOrderOfPlacesTwo { b: s[(n.wrapping_add(k as usize))%3].b, a: s[n%3].b[found_order_of_places_ti(n,t)] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ (a[0], a[1]) = (a[found_order_of_places_ti(n,t)], a[0]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ (a[found_order_of_places_ti(n,t)], a[found_order_of_places_ti(n,t)]) = (a[found_order_of_places_ti(n,t)], a[0]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a.swap(found_order_of_places_ti(n,t), found_order_of_places_ti(n,t)); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_ti(n,t)].reverse(); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let mut k = k0;
let z9 = ({ q[found_order_of_places_ti(n,t)].fill(found_order_of_places_tv(k,t)); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_3(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_ti(n,t)].rotate_left(1); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_ti(n,t)].sort_unstable(); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let q2 = [[1, a0[1], 2], a0, [a0[2], 5, 9]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_ti(n,t)].copy_from_slice(&q2[found_order_of_places_ti(n,t)]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = (0..5).contains(&a[found_order_of_places_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut n = n0;
let z9 = ({ let e = FoundOrderOfPlacesTwo { a: a[n % 3], b: [found_order_of_places_ba(&mut a), a[0], found_order_of_places_bn(&mut n)] }; e.a as i64 ^ e.b[1] as i64 * 3 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut n = n0;
let z9 = ({ let e = FoundOrderOfPlacesTwo { b: [found_order_of_places_ba(&mut a), a[0], found_order_of_places_bn(&mut n)], a: a[n % 3] }; e.a as i64 ^ e.b[1] as i64 * 3 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_4(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut s = [FoundOrderOfPlacesTwo { a: a0[0], b: a0 }, FoundOrderOfPlacesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfPlacesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let z9 = ({ let e = FoundOrderOfPlacesTwo { a: found_order_of_places_bs(&mut s), ..s[n % 3] }; e.a as i64 ^ e.b[1] as i64 * 3 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut s = [FoundOrderOfPlacesTwo { a: a0[0], b: a0 }, FoundOrderOfPlacesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfPlacesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let z9 = ({ s[n % 3] = FoundOrderOfPlacesTwo { a: found_order_of_places_bs(&mut s), ..s[n % 3] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut s = [FoundOrderOfPlacesTwo { a: a0[0], b: a0 }, FoundOrderOfPlacesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfPlacesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let z9 = ({ s[n % 3] = FoundOrderOfPlacesTwo { a: s[1].a, b: [found_order_of_places_bn(&mut n), s[0].a, s[n % 3].b[1]] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut s = [FoundOrderOfPlacesTwo { a: a0[0], b: a0 }, FoundOrderOfPlacesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfPlacesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let z9 = ({ s[n % 3].b = [s[0].a, found_order_of_places_bn(&mut n), s[n % 3].b[0]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[n % 3] = found_order_of_places_bn(&mut n); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[n % 3] = found_order_of_places_ba(&mut a); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_5(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[n % 3] ^= found_order_of_places_bn(&mut n); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[n % 3] ^= found_order_of_places_ba(&mut a); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[found_order_of_places_bi(&mut n)] ^= found_order_of_places_bn(&mut n); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[found_order_of_places_bi(&mut n)] = found_order_of_places_bn(&mut n); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_bi(&mut n)][found_order_of_places_bi(&mut n)] = found_order_of_places_bn(&mut n); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[found_order_of_places_bi(&mut n)][found_order_of_places_bi(&mut n)] ^= found_order_of_places_bn(&mut n); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_6(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[n % 3] = { found_order_of_places_bn(&mut n); q[n % 3] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[n % 3] = [found_order_of_places_bq(&mut q), q[n % 3][0], q[n % 3][2]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a = [found_order_of_places_bn(&mut n), a[n % 3], found_order_of_places_ba(&mut a)]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let z9 = ({ a = [a[2], found_order_of_places_ba(&mut a), a[0]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a = [a[2], a[n % 3], a[0]]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a = [a[2], a[1], a[0]].map(|x| x ^ a[n % 3]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_7(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = ({ (a[n % 3], a[0]) = (found_order_of_places_bn(&mut n), a[n % 3]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let z9 = ({ (a[0], a[1]) = (a[1], a[0]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7));
}
{
let mut a = a0;
let mut b = [a0[1], a0[0], a0[2] ^ 3];
let mut n = n0;
let z9 = ({ core::mem::swap(&mut a[n % 3], &mut b[{ found_order_of_places_bn(&mut n); n % 3 }]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (b[0] as i64 * 3 + b[1] as i64 * 5 + b[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[n % 3].fill(found_order_of_places_bn(&mut n)); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let q2 = [[1, a0[1], 2], a0, [a0[2], 5, 9]];
let mut n = n0;
let z9 = ({ q[n % 3].copy_from_slice(&q2[found_order_of_places_bi(&mut n)]); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[n % 3].rotate_left(found_order_of_places_bi(&mut n)); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_8(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ q[n % 3].swap(found_order_of_places_bi(&mut n), found_order_of_places_bi(&mut n)); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a.swap(n % 3, found_order_of_places_bi(&mut n)); 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut v = [Vector3::new(a0[0] as f64, 1.5, 2.0), Vector3::new(0.5, a0[1] as f64, 3.0), Vector3::new(1.0, -2.0, a0[2] as f64)];
let mut n = n0;
let z9 = ({ v[n % 3] = found_order_of_places_bvv(&mut v) + v[n % 3]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (v[0] + v[1] * 2.0 + v[2] * 3.0).sum().to_bits() as i64 ^ (n as i64).wrapping_mul(11));
}
{
let mut v = [Vector3::new(a0[0] as f64, 1.5, 2.0), Vector3::new(0.5, a0[1] as f64, 3.0), Vector3::new(1.0, -2.0, a0[2] as f64)];
let mut n = n0;
let z9 = ({ v[found_order_of_places_bi(&mut n)] *= v[found_order_of_places_bi(&mut n)][found_order_of_places_bi(&mut n)]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (v[0] + v[1] * 2.0 + v[2] * 3.0).sum().to_bits() as i64 ^ (n as i64).wrapping_mul(11));
}
{
let mut v = [Vector3::new(a0[0] as f64, 1.5, 2.0), Vector3::new(0.5, a0[1] as f64, 3.0), Vector3::new(1.0, -2.0, a0[2] as f64)];
let mut n = n0;
let z9 = ({ v[n % 3][found_order_of_places_bi(&mut n)] = v[found_order_of_places_bi(&mut n)][n % 3]; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (v[0] + v[1] * 2.0 + v[2] * 3.0).sum().to_bits() as i64 ^ (n as i64).wrapping_mul(11));
}
{
let mut m = SMatrix::<f64, 3, 3>::new(a0[0] as f64, 2.0, 3.0, 4.5, a0[1] as f64, 6.0, 7.0, a0[2] as f64, 9.25);
let mut v = [Vector3::new(a0[0] as f64, 1.5, 2.0), Vector3::new(0.5, a0[1] as f64, 3.0), Vector3::new(1.0, -2.0, a0[2] as f64)];
let mut n = n0;
let z9 = ({ let e = (m * v[n % 3]) * found_order_of_places_bm(&mut m); e.sum().to_bits() as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (v[0] + v[1] * 2.0 + v[2] * 3.0).sum().to_bits() as i64 ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_9(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut m = SMatrix::<f64, 3, 3>::new(a0[0] as f64, 2.0, 3.0, 4.5, a0[1] as f64, 6.0, 7.0, a0[2] as f64, 9.25);
let z9 = ({ let e = (m + m) * found_order_of_places_bm(&mut m); e.sum().to_bits() as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9);
}
{
let mut m = SMatrix::<f64, 3, 3>::new(a0[0] as f64, 2.0, 3.0, 4.5, a0[1] as f64, 6.0, 7.0, a0[2] as f64, 9.25);
let mut n = n0;
let z9 = ({ m[(n % 3, found_order_of_places_bi(&mut n))] = found_order_of_places_bm(&mut m); m.sum().to_bits() as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut m = SMatrix::<f64, 3, 3>::new(a0[0] as f64, 2.0, 3.0, 4.5, a0[1] as f64, 6.0, 7.0, a0[2] as f64, 9.25);
let mut n = n0;
let z9 = ({ m[(n % 3, found_order_of_places_bi(&mut n))] += found_order_of_places_bm(&mut m) + m[(0, 0)]; m.sum().to_bits() as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = ({ let e = [k, found_order_of_places_bk(&mut k), k]; e[0] as i64 + e[1] as i64 * 3 + e[2] as i64 * 5 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = ({ let e = (k, found_order_of_places_bk(&mut k), k); e.0 as i64 + e.1 as i64 * 3 + e.2 as i64 * 5 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[n % 3] = { a = [1, 2, 3]; a[n % 3] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_places_10(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = ({ a[n % 3] ^= { a = [1, 2, 3]; n = 1; a[n % 3] }; 1 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
