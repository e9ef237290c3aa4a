// Chains: what they go through side by side, in parts of one variable; closures that give an item two names; each end.
#[function]
fn found_iterators_ti(x: usize, t: &mut u64) -> usize { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(1); (*t % 3) as usize }
#[function]
fn found_iterators_tv(x: i16, t: &mut u64) -> i16 { *t = t.wrapping_mul(31).wrapping_add(x as u64).wrapping_add(7); x ^ (*t as i16 & 3) }
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct FoundIteratorsHeld { pub q: [[i16; 3]; 3], pub l: List<i16, 3> }
#[function]
fn found_iterators_mk(a: [i16; 3], n: usize) -> List<i16, 3> { let mut l = List::new(); for i in 0..n % 4 { l.push(a[i]); } l }
#[function]
pub fn found_iterators_0(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = q[1].iter().zip(q[2].iter()).filter(|(x, y)| x > y).count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[1].iter().zip(ll[2].iter()).count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[1].iter().zip(ll[2].iter()).any(|(x, y)| *x != *y) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[1].iter().chain(ll[2].iter()).fold(1_i64, |c, x| c * 3 % 10007 + *x as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1][..n % 3].iter().zip(q[2][..m % 3].iter()).fold(3_i64, |c, (x, y)| c * 3 % 10007 + *x as i64 * 3 + *y as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[n % 3].iter().zip(ll[m % 3].iter()).fold(3_i64, |c, (x, y)| c * 3 % 10007 + *x as i64 * 3 + *y as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_1(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = ll[1].iter().step_by(3).zip(ll[2].chunks_exact(2)).enumerate().filter(|&(i, (&x, _))| x > k).fold(k as i64, |c, (i, (x, w))| i as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = a.chunks(1 + n % 2).zip(b.chunks(1 + m % 3)).fold(3_i64, |c, (x, y)| c * 3 % 10007 + x.len() as i64 * 5 + y.len() as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = b.iter().copied().filter(|x| *x < k).min_by(|x, y| y.cmp(x)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = b.iter().copied().filter(|x| *x < k).min_by(|x, y| x.cmp(y)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = b.iter().copied().skip_while(|x| *x < k).max_by(|x, y| y.cmp(x)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_2(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = q[1].iter().copied().filter(|y| *y < k).max_by(|x, y| x.cmp(y)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = b.iter().copied().filter(|x| *x < k).max_by_key(|x| -(*x as i32)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[n % 3].chunks_exact(1 + m % 2).map(|w| w[0]).filter_map(|x| if x > k { Some(x) } else { None }).last().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = s.l.iter().copied().fold(n as i64, |c, x| c ^ found_iterators_tv(x, t) as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = s.q[1].iter().zip(ll[1].chunks(2)).map(|(x, w)| *x ^ w[0]).last().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[1].iter().copied().map(|x| found_iterators_tv(x, t)).max().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_3(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = s.l.iter().copied().step_by(2).enumerate().filter(|&(i, x)| i > 0 || x > k).map(|(i, x)| x).max().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = { let mut z = 1_i64; for x in s.q[m % 3].iter().copied() { if x > k { continue; } z = z * 3 % 10007 + x as i64; } z };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = l.iter().copied().scan(k, |c, x| { *c ^= x; Some(*c) }).map(|x| found_iterators_tv(x, t)).min_by(|x, y| y.cmp(x)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[(n + m) % 3].iter().copied().next().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[n % 3].iter().copied().fold(3_i64, |c, x| c * 3 % 10007 + x as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1].iter().copied().scan(k, |c, x| { *c ^= x; Some(*c) }).nth(n % 3).unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_4(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = ll[n % 3].iter().copied().all(|x| found_iterators_tv(x, t) > k) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[n % 3].iter().zip(q[1].chunks(2)).map(|(x, w)| *x ^ w[0]).enumerate().map(|(i, x)| x ^ i as i16).last().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[2][n % 3..].iter().copied().min().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[1].iter().copied().take(m % 3).fold((0_i16, 1_i16), |(c, d), x| (c ^ x, d.wrapping_add(x))).1 as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1][..m % 3].iter().copied().map(|x| found_iterators_tv(x, t)).reduce(|x, y| x ^ y.wrapping_mul(3)).unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1].iter().zip(a[n % 3..].iter().take(m % 3).skip(n % 2)).map(|(x, y)| *x ^ *y).reduce(|x, y| x ^ y.wrapping_mul(3)).unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_5(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = l.iter().copied().step_by(2).map(|x| x as i64).sum::<i64>();
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[(n + m) % 3].iter().copied().position(|x| x > k).unwrap_or(7) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[1].iter().step_by(2).zip(q[(n + m) % 3].iter()).map(|(x, y)| *x ^ *y).count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = a.iter().copied().filter_map(|x| if x > k { Some(x) } else { None }).take_while(|x| *x < k).fold((0_i16, 1_i16), |(c, d), x| (c ^ x, d.wrapping_add(x))).1 as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[n % 3].iter().take(m % 3).step_by(2).zip(q[1].chunks(2)).map(|(x, w)| *x ^ w[0]).find(|x| *x > k).unwrap_or(7) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = l.chunks_exact(2).map(|w| w[0]).map(|x| found_iterators_tv(x, t)).max().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_6(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = { let mut z = 1_i64; for x in q[1][..m % 3].iter().zip(s.q[m % 3].iter().take(2)).map(|(x, y)| *x ^ *y) { if x > k { continue; } z = z * 3 % 10007 + x as i64; } z };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = { let mut z = 1_i64; for x in q[2][n % 3..].iter().copied().enumerate().filter(|&(i, x)| i > 0 || x > k).map(|(i, x)| x).skip_while(|x| *x < k) { if x > k { continue; } z = z * 3 % 10007 + x as i64; } z };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1].iter().copied().filter(|x| *x > k).fold(3_i64, |c, x| c * 3 % 10007 + x as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = s.q[1].iter().copied().take_while(|x| *x < k).count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[(n + m) % 3].iter().copied().skip(n % 2).fold(3_i64, |c, x| c * 3 % 10007 + x as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[n % 3].iter().copied().step_by(2).map(|x| found_iterators_tv(x, t)).position(|x| x > k).unwrap_or(7) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_7(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = b.iter().copied().skip_while(|x| *x < k).min_by(|x, y| y.cmp(x)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = l.iter().copied().step_by(2).fold(n as i64, |c, x| c ^ found_iterators_tv(x, t) as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = (0..(n % 7)).step_by(1 + m % 3).map(|x| x as i16).map(|x| found_iterators_tv(x, t)).try_fold(0_i16, |c, x| c.checked_add(x)).unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[(n + m) % 3].iter().copied().scan(k, |c, x| { *c ^= x; Some(*c) }).filter(|x| *x > k).min().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = s.q[1].iter().copied().max().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[n % 3].chunks_exact(1 + m % 2).map(|w| w[0]).map(|x| found_iterators_tv(x, t)).try_fold(0_i16, |c, x| c.checked_add(x)).unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_8(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = { let mut g = 1_i16; q[1][..m % 3].iter().zip(a.chunks(1 + n % 2)).map(|(x, w)| *x ^ w[0]).for_each(|x| { g = g.wrapping_mul(3) ^ x; }); g as i64 };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[2][n % 3..].iter().copied().count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = a[n % 3..].iter().copied().step_by(2).min_by(|x, y| y.cmp(x)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = (n % 3..m % 5).map(|x| x as i16).filter_map(|x| if x > k { Some(x) } else { None }).map(|x| x as i64).sum::<i64>();
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = a.iter().copied().fold((0_i16, 1_i16), |(c, d), x| (c ^ x, d.wrapping_add(x))).1 as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[2][n % 3..].iter().copied().skip(n % 2).try_fold(0_i16, |c, x| c.checked_add(x)).unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_9(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = q[1].iter().zip(q[1].chunks(2)).map(|(x, w)| *x ^ w[0]).take_while(|x| *x < k).fold(n as i64, |c, x| c ^ found_iterators_tv(x, t) as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1].chunks(2).map(|w| w[0]).filter(|x| *x > k).reduce(|x, y| x ^ y.wrapping_mul(3)).unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = a[n % 3..].iter().copied().next().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1][..m % 3].iter().take(m % 3).zip(ll[n % 3].iter().skip(1)).map(|(x, y)| *x ^ *y).enumerate().map(|(i, x)| x ^ i as i16).max_by_key(|x| *x & 7).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = l.iter().copied().skip_while(|x| *x < k).max_by_key(|x| *x & 7).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1][..m % 3].iter().skip(1).skip(1).zip(q[1][..m % 3].iter().skip(m % 3)).map(|(x, y)| *x ^ *y).find(|x| *x > k).unwrap_or(7) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_10(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = l.iter().skip(n % 2).step_by(2).zip(q[1].chunks(2)).map(|(x, w)| *x ^ w[0]).count() as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = { let mut z = 1_i64; for x in s.q[1].iter().copied().map(|x| found_iterators_tv(x, t)) { z = z * 3 % 10007 + x as i64; } z };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1][..m % 3].iter().copied().enumerate().filter(|&(i, x)| i > 0 || x > k).map(|(i, x)| x).filter(|x| *x > k).fold(n as i64, |c, x| c ^ found_iterators_tv(x, t) as i64);
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[(n + m) % 3].iter().skip(m % 3).zip(ll[2].windows(1 + m % 2)).map(|(x, w)| *x ^ w[0]).reduce(|x, y| x ^ y.wrapping_mul(3)).unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = { let mut z = 1_i64; for x in q[found_iterators_ti(n, t)].iter().copied() { if x > k { continue; } z = z * 3 % 10007 + x as i64; } z };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = { let mut z = 1_i64; for x in l.iter().zip(q[1][..m % 3].iter()).map(|(x, y)| *x ^ *y).enumerate().map(|(i, x)| x ^ i as i16) { if x > k { continue; } z = z * 3 % 10007 + x as i64; } z };
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_11(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = b.iter().copied().skip(n % 2).skip(n % 2).position(|x| x > k).unwrap_or(7) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[2].iter().copied().enumerate().filter(|&(i, x)| i > 0 || x > k).map(|(i, x)| x).try_fold(0_i16, |c, x| c.checked_add(x)).unwrap_or(1) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[2][n % 3..].iter().copied().enumerate().map(|(i, x)| x ^ i as i16).last().unwrap_or(5) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = b.iter().copied().take(m % 3).max_by_key(|x| *x & 7).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = ll[2].iter().chain(a.iter()).copied().min_by(|x, y| y.cmp(x)).unwrap_or(4) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1].iter().zip(q[1].chunks(2)).map(|(x, w)| *x ^ w[0]).map(|x| x as i64).sum::<i64>();
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
#[function]
pub fn found_iterators_12(a: [i16; 3], b: [i16; 3], q: [[i16; 3]; 3], n0: u8, m0: u8, k: i16, t: &mut u64) -> i64 {
let mut sum = 0_i64;
let m = m0 as usize;
let l = found_iterators_mk(a, n0 as usize);
let ll = [found_iterators_mk(b, m), found_iterators_mk(q[1], m + 1), found_iterators_mk(q[2], n0 as usize)];
let s = FoundIteratorsHeld { q, l: ll[0] };
{
let mut n = n0 as usize;
let z = q[n % 3].chunks_exact(1 + m % 2).map(|w| w[0]).all(|x| found_iterators_tv(x, t) > k) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
{
let mut n = n0 as usize;
let z = q[1].chunks(2).map(|w| w[0]).filter(|x| *x > k).all(|x| found_iterators_tv(x, t) > k) as i64;
sum = sum.wrapping_mul(31).wrapping_add(z).wrapping_add(n as i64);
}
sum
}
