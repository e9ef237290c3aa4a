#[function]
pub fn found_iterators_made_before(a0: [i16; 3], n0: u8, k0: i16, f0: f64, t: &mut u64) -> Option<i64> {
let mut n = n0 as usize % 3;
let mut a = a0;
let mut s = BesideTwo { a: k0 ^ 5, b: a0 };
let z = { let mut it = beside_up(&mut n).filter_map(|x| if x > 3 { Some(0) } else { None }); {} {} it.fold(core::mem::replace(&mut a, s.b).iter().skip(beside_n(&mut n) % 2).copied().map(|x| x % 100).sum::<i16>(), |c, x| c.wrapping_mul(3) ^ x) };
beside_tells_k(z, t);
Some(0)
}
