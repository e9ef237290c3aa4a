// What an iterator goes through is looked for before its links are counted, and before what a fold begins with is computed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundRow { pub a: i16, pub b: [i16; 3] }
#[function]
fn found_iterators_next(n: &mut usize) -> usize { *n = (*n + 1) % 3; *n }
#[function]
pub fn found_order_of_iterators(a0: [i16; 3], n0: u8, k0: i16, t: &mut u64) -> i64 {
let mut n = n0 as usize % 3;
let r = [FoundRow { a: 7, b: a0 }, FoundRow { a: a0[1], b: [k0, 2, a0[0]] }];
let one = r[found_iterators_next(&mut n) % 2].b.iter().take(found_iterators_next(&mut n)).copied().fold(k0, |c, x| c.wrapping_mul(3) ^ x);
let two = r[n % 2].b.iter().copied().fold({ n = (n + 1) % 3; 1 }, |c: i16, x| c.wrapping_mul(3) ^ x);
let three = (&r[n % 2].b).iter().rev().skip({ n = (n + 1) % 3; n }).copied().fold(2, |c: i16, x| c.wrapping_mul(3) ^ x);
*t = t.wrapping_mul(31).wrapping_add(n as u64);
i64::from(one) + 31 * i64::from(two) + 961 * i64::from(three)
}
