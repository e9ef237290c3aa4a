// Values, `==` and patterns: how often, and in which order, operands that write are computed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct FoundOrderOfValuesTwo { pub a: i16, pub b: [i16; 3] }
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundOrderOfValuesWay { #[default] Off, On(i16), Both { low: i16, high: i16 } }
#[function]
fn found_order_of_values_ti(x: usize, t: &mut u64) -> usize { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(1); (*t % 3) as usize }
#[function]
fn found_order_of_values_tv(x: i16, t: &mut u64) -> i16 { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); x ^ (*t as i16 & 3) }
#[function]
fn found_order_of_values_to(x: i16, t: &mut u64) -> Option<i16> { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); if *t % 3 == 0 { None } else { Some(x) } }
#[function]
fn found_order_of_values_bn(n: &mut usize) -> i16 { *n = n.wrapping_add(1) % 3; *n as i16 }
#[function]
fn found_order_of_values_bi(n: &mut usize) -> usize { *n = n.wrapping_add(1) % 3; *n }
#[function]
fn found_order_of_values_bon(n: &mut usize) -> Option<i16> { *n = n.wrapping_add(1) % 3; if *n == 1 { None } else { Some(*n as i16) } }
#[function]
fn found_order_of_values_bk(k: &mut i16) -> i16 { *k = k.wrapping_mul(3).wrapping_add(1); *k }
#[function]
fn found_order_of_values_bo(o: &mut [Option<i16>; 3]) -> i16 { o[0] = Some(5); o[1] = None; o[2] = Some(7); 8 }
#[function]
fn found_order_of_values_boo(o: &mut [Option<i16>; 3]) -> Option<i16> { o[0] = Some(5); o[1] = None; o[2] = Some(7); Some(8) }
#[function]
fn found_order_of_values_ba(a: &mut [i16; 3]) -> i16 { a[0] = a[0].wrapping_add(5); a[1] = 4; a[2] ^= 7; a[1] }
#[function]
fn found_order_of_values_bq(q: &mut [[i16; 3]; 3]) -> i16 { q[0] = [3, 4, 5]; q[1] = q[2]; q[2][1] = 3; q[1][1] }
#[function]
fn found_order_of_values_bw(w: &mut [FoundOrderOfValuesWay; 3]) -> i16 { w[0] = FoundOrderOfValuesWay::On(4); w[1] = FoundOrderOfValuesWay::Off; w[2] = FoundOrderOfValuesWay::Both { low: 3, high: 2 }; 3 }
#[function]
fn found_order_of_values_bs(s: &mut [FoundOrderOfValuesTwo; 3]) -> i16 { s[0].a = 4; s[1].b[1] = 4; s[2] = s[0]; 3 }
#[function]
fn found_order_of_values_bx(o: &mut Option<i16>) -> i16 { let was = match o { Some(x) => *x, None => 3 }; *o = if was > 0 { None } else { Some(4) }; was }
#[function]
fn found_order_of_values_bv(v: &mut [Vector3<f64>; 3]) -> f64 { v[0] = v[1]; v[1] *= 2.0; v[2][1] = 3.0; 1.5 }
#[function]
fn found_order_of_values_bvv(v: &mut [Vector3<f64>; 3]) -> Vector3<f64> { v[0] = v[1]; v[1] *= 2.0; v[2][1] = 3.0; v[0] }
#[function]
fn found_order_of_values_bm(m: &mut SMatrix<f64, 3, 3>) -> f64 { m[(0, 0)] = 4.0; m[(1, 2)] = m[(2, 2)]; 1.5 }
#[function]
pub fn found_order_of_values_0(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let mut k = k0;
let z9 = q[found_order_of_values_ti(n,t)].contains(&k) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_ti(n,t)].contains(&a[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = (o[found_order_of_values_ti(n,t)] == o[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = (o[found_order_of_values_ti(n,t)] == Some(found_order_of_values_tv(k,t))) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let mut k = k0;
let z9 = (Some(found_order_of_values_tv(k,t)) == o[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = (a[found_order_of_values_ti(n,t)] == a[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_1(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = (q[found_order_of_values_ti(n,t)] == q[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut s = [FoundOrderOfValuesTwo { a: a0[0], b: a0 }, FoundOrderOfValuesTwo { a: a0[1], b: [a0[2], 3, a0[0]] }, FoundOrderOfValuesTwo { a: 4, b: [a0[1]; 3] }];
let mut n = n0;
let z9 = (s[found_order_of_values_ti(n,t)] == s[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ s.iter().fold(0_i64, |x, y| x * 3 % 100003 + y.a as i64 + y.b[0] as i64 * 5 + y.b[1] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut w = [FoundOrderOfValuesWay::On(a0[0]), if a0[1] > 0 { FoundOrderOfValuesWay::Off } else { FoundOrderOfValuesWay::On(2) }, FoundOrderOfValuesWay::Both { low: a0[2], high: a0[0] }];
let mut n = n0;
let z9 = (w[found_order_of_values_ti(n,t)] == w[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut w = [FoundOrderOfValuesWay::On(a0[0]), if a0[1] > 0 { FoundOrderOfValuesWay::Off } else { FoundOrderOfValuesWay::On(2) }, FoundOrderOfValuesWay::Both { low: a0[2], high: a0[0] }];
let mut n = n0;
let mut k = k0;
let z9 = matches!(w[found_order_of_values_ti(n,t)], FoundOrderOfValuesWay::On(x) if x > found_order_of_values_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut w = [FoundOrderOfValuesWay::On(a0[0]), if a0[1] > 0 { FoundOrderOfValuesWay::Off } else { FoundOrderOfValuesWay::On(2) }, FoundOrderOfValuesWay::Both { low: a0[2], high: a0[0] }];
let mut n = n0;
let z9 = (match w[found_order_of_values_ti(n,t)] { FoundOrderOfValuesWay::Off => 1, FoundOrderOfValuesWay::On(x) => x as i64, FoundOrderOfValuesWay::Both { low, high } => low as i64 ^ high as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = (match a[found_order_of_values_ti(n,t)] { 0..=100 => 1, x if x < found_order_of_values_tv(k,t) => 2, -5 | -4 => 4, x => x as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_2(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = (match (a[found_order_of_values_ti(n,t)], a[found_order_of_values_ti(n,t)]) { (x, y) if x < y => 1, (x, 0) => x as i64, (_, y) => y as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_ti(n,t)].iter().map(|x| found_order_of_values_tv(*x,t) as i64).sum::<i64>();
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_ti(n,t)].iter().position(|x| *x == a[found_order_of_values_ti(n,t)]).unwrap_or(7) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let mut k = k0;
let z9 = q[found_order_of_values_ti(n,t)].iter().any(|x| *x == found_order_of_values_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let mut k = k0;
let z9 = q[found_order_of_values_ti(n,t)].iter().all(|x| *x < found_order_of_values_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_ti(n,t)].iter().copied().max().unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_3(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let mut k = k0;
let z9 = q[found_order_of_values_ti(n,t)].iter().copied().fold(found_order_of_values_tv(k,t), |x, y| x ^ y) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_ti(n,t)].iter().rev().skip(found_order_of_values_ti(n,t)).count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_ti(n,t)].iter().take(found_order_of_values_ti(n,t)).map(|x| *x as i64).sum::<i64>();
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[found_order_of_values_ti(n,t)].clamp(found_order_of_values_tv(-9,t), 1000) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[found_order_of_values_ti(n,t)].min(a[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = (a[found_order_of_values_ti(n,t)]..=a[found_order_of_values_ti(n,t)]).contains(&found_order_of_values_tv(k,t)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_4(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let mut k = k0;
let z9 = (found_order_of_values_tv(k,t)..).contains(&a[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11) ^ (k as i64).wrapping_mul(11));
}
{
let mut m = SMatrix::<f64, 3, 3>::new(a0[0] as f64, 2.0, 3.0, 4.5, a0[1] as f64, 6.0, 7.0, a0[2] as f64, 9.25);
let mut n = n0;
let z9 = m[(found_order_of_values_ti(n,t), found_order_of_values_ti(n,t))].to_bits() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut v = [Vector3::new(a0[0] as f64, 1.5, 2.0), Vector3::new(0.5, a0[1] as f64, 3.0), Vector3::new(1.0, -2.0, a0[2] as f64)];
let mut n = n0;
let z9 = v[found_order_of_values_ti(n,t)].dot(&v[found_order_of_values_ti(n,t)]).to_bits() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (v[0] + v[1] * 2.0 + v[2] * 3.0).sum().to_bits() as i64 ^ (n as i64).wrapping_mul(11));
}
{
let mut v = [Vector3::new(a0[0] as f64, 1.5, 2.0), Vector3::new(0.5, a0[1] as f64, 3.0), Vector3::new(1.0, -2.0, a0[2] as f64)];
let mut n = n0;
let z9 = (v[found_order_of_values_ti(n,t)] == v[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (v[0] + v[1] * 2.0 + v[2] * 3.0).sum().to_bits() as i64 ^ (n as i64).wrapping_mul(11));
}
{
let z = [SMatrix::<i32, 3, 1>::new(a0[0] as i32, 1, 2), SMatrix::<i32, 3, 1>::new(3, a0[1] as i32, 2), SMatrix::<i32, 3, 1>::new(5, 6, a0[2] as i32)];
let mut n = n0;
let z9 = z[found_order_of_values_ti(n,t)].sum() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let z = [SMatrix::<i32, 3, 1>::new(a0[0] as i32, 1, 2), SMatrix::<i32, 3, 1>::new(3, a0[1] as i32, 2), SMatrix::<i32, 3, 1>::new(5, 6, a0[2] as i32)];
let mut n = n0;
let z9 = (z[found_order_of_values_ti(n,t)] == z[found_order_of_values_ti(n,t)]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_5(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = ({ let x = Some(&q[found_order_of_values_ti(n,t)]); match x { Some(y) => y[0] as i64 ^ y[1] as i64, None => 1 } });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = (o[n % 3] == Some(found_order_of_values_bn(&mut n))) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = (Some(found_order_of_values_bo(&mut o)) == o[n % 3]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = (Some(found_order_of_values_bn(&mut n)) == o[n % 3]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = (a[n % 3] == found_order_of_values_ba(&mut a)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = (a[n % 3] < found_order_of_values_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_6(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let z9 = ({ let mut e = a; a == { found_order_of_values_ba(&mut e); e } } as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ((a, found_order_of_values_bn(&mut n)) == (a, found_order_of_values_ba(&mut a))) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = ([a[n % 3], found_order_of_values_bn(&mut n)] == [found_order_of_values_ba(&mut a), a[n % 3]]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = (match (a[n % 3], found_order_of_values_ba(&mut a)) { (x, y) if x < y => 1, (x, 0) => x as i64, (_, y) => y as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = (match (o[n % 3], found_order_of_values_boo(&mut o)) { (Some(x), Some(y)) => x as i64 ^ y as i64, (None, Some(y)) => y as i64, (x, None) => 9 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut w = [FoundOrderOfValuesWay::On(a0[0]), if a0[1] > 0 { FoundOrderOfValuesWay::Off } else { FoundOrderOfValuesWay::On(2) }, FoundOrderOfValuesWay::Both { low: a0[2], high: a0[0] }];
let mut n = n0;
let z9 = (match (w[n % 3], found_order_of_values_bw(&mut w)) { (FoundOrderOfValuesWay::On(x), y) => x as i64 ^ y as i64, (FoundOrderOfValuesWay::Off, y) => y as i64, (x, _) => 9 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_7(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let z = [SMatrix::<i32, 3, 1>::new(a0[0] as i32, 1, 2), SMatrix::<i32, 3, 1>::new(3, a0[1] as i32, 2), SMatrix::<i32, 3, 1>::new(5, 6, a0[2] as i32)];
let mut n = n0;
let z9 = (match [a[n % 3], found_order_of_values_bn(&mut n), a[n % 3]] { [x, y, z] if x < y => z as i64, [x, .., z] => x as i64 ^ z as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].wrapping_add(found_order_of_values_ba(&mut a)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].wrapping_add(found_order_of_values_bn(&mut n)).wrapping_mul(a[n % 3]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].clamp(found_order_of_values_bn(&mut n).min(-3), 1000) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].clamp(found_order_of_values_ba(&mut a).min(-3), 1000) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].min(found_order_of_values_ba(&mut a)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_8(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].max(found_order_of_values_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].checked_add(found_order_of_values_ba(&mut a)).unwrap_or(3) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].overflowing_mul(found_order_of_values_ba(&mut a)).0 as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].abs_diff(found_order_of_values_ba(&mut a)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].cmp(&found_order_of_values_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = a[n % 3].saturating_add(found_order_of_values_ba(&mut a)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_9(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut a = a0;
let mut n = n0;
let z9 = (a[n % 3] as i64 + found_order_of_values_ba(&mut a) as i64 * a[n % 3] as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = (k as i64 + found_order_of_values_bk(&mut k) as i64 * k as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = (k as i64 - { found_order_of_values_bk(&mut k); k as i64 } - k as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = (-(k as i64) - { let e = found_order_of_values_bk(&mut k); e as i64 } ^ (k as i64));
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = (k > 0 && found_order_of_values_bk(&mut k) > 0 || k < found_order_of_values_bk(&mut k)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[n % 3][found_order_of_values_bi(&mut n)] as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_10(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[found_order_of_values_bi(&mut n)][n % 3] as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[n % 3].contains(&found_order_of_values_bn(&mut n)) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut a = a0;
let mut n = n0;
let z9 = (a[n % 3]..found_order_of_values_ba(&mut a)).contains(&a[n % 3]) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (a[0] as i64 * 3 + a[1] as i64 * 5 + a[2] as i64 * 7) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[n % 3].iter().map(|x| *x ^ found_order_of_values_bn(&mut n)).fold(0_i64, |x, y| x * 3 + y as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[n % 3].iter().fold(found_order_of_values_bn(&mut n) as i64, |x, y| x ^ *y as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[n % 3].map(|x| x ^ found_order_of_values_bn(&mut n))[n % 3] as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_11(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut q = [a0, [a0[2], 3, a0[1]], [7, a0[0], a0[0] ^ 5]];
let mut n = n0;
let z9 = q[n % 3].map(|x| x ^ found_order_of_values_bq(&mut q))[n % 3] as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ q.iter().fold(0_i64, |x, y| x * 3 % 100003 + y[0] as i64 * 3 + y[1] as i64 * 5 + y[2] as i64) ^ (n as i64).wrapping_mul(11));
}
{
let mut w = [FoundOrderOfValuesWay::On(a0[0]), if a0[1] > 0 { FoundOrderOfValuesWay::Off } else { FoundOrderOfValuesWay::On(2) }, FoundOrderOfValuesWay::Both { low: a0[2], high: a0[0] }];
let mut n = n0;
let z9 = ({ let e = w[n % 3]; found_order_of_values_bw(&mut w); match e { FoundOrderOfValuesWay::On(x) => x as i64, FoundOrderOfValuesWay::Both { low, .. } => low as i64, FoundOrderOfValuesWay::Off => 2 } });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut o = [if a0[0] & 1 == 0 { Some(a0[0]) } else { None }, Some(a0[1]), if a0[2] > 0 { Some(a0[2]) } else { None }];
let mut n = n0;
let z9 = ({ let e = match &mut o[n % 3] { Some(x) => { found_order_of_values_bn(&mut n); *x ^= 1; *x }, None => found_order_of_values_bn(&mut n) }; e as i64 });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ o.iter().fold(0_i64, |x, y| x * 3 % 100003 + match y { Some(c) => *c as i64, None => 77 }) ^ (n as i64).wrapping_mul(11));
}
{
let mut m = SMatrix::<f64, 3, 3>::new(a0[0] as f64, 2.0, 3.0, 4.5, a0[1] as f64, 6.0, 7.0, a0[2] as f64, 9.25);
let mut n = n0;
let z9 = (m[(n % 3, found_order_of_values_bi(&mut n))] + found_order_of_values_bm(&mut m) * m[(0, 0)]).to_bits() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (n as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = ({ let e = Some(k).zip(Some(found_order_of_values_bk(&mut k))); match e { Some((x, y)) => x as i64 - y as i64, None => 2 } });
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
{
let mut k = k0;
let z9 = (k.wrapping_add(found_order_of_values_bk(&mut k)).wrapping_sub(k) as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
sum
}
#[function]
pub fn found_order_of_values_12(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
{
let mut k = k0;
let z9 = (k.min(found_order_of_values_bk(&mut k)).max(k) as i64);
sum = sum.wrapping_mul(31).wrapping_add(z9 ^ (k as i64).wrapping_mul(11));
}
sum
}
