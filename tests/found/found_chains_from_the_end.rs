// Arrays one behind the other that stand beside another from their end.
#[function]
pub fn found_chains_from_the_end_0(x: [i32; 3], y: [i32; 2], z: [i32; 6]) -> i32 {
    let mut s = 0_i32;
    for (a, b) in z.iter().zip(x.iter().chain(y.iter()).rev()) { s = s.wrapping_mul(3).wrapping_add(*a).wrapping_sub(*b); }
    s
}
#[function]
pub fn found_chains_from_the_end_1(x: [i32; 3], y: [i32; 2], z: [i32; 6]) -> i32 {
    let mut s = 0_i32;
    for (b, a) in x.iter().chain(y.iter()).rev().zip(z.iter()) { s = s.wrapping_mul(3).wrapping_add(*a).wrapping_sub(*b); }
    for b in x.iter().chain(y.iter()).rev() { s = s.wrapping_mul(3).wrapping_sub(*b); }
    for (i, b) in x.iter().chain(&y).rev().enumerate().skip(1) { s = s.wrapping_mul(3).wrapping_sub(*b).wrapping_add(i as i32); }
    s
}
#[function]
pub fn found_chains_from_the_end_2(x: [i32; 3], y: [i32; 2], z: [i32; 6]) -> i32 {
    let t = x.iter().chain(y.iter()).rev().zip(z.iter().rev()).fold(0_i32, |a, (b, c)| a.wrapping_mul(3).wrapping_add(b ^ c));
    let u = z.iter().rev().zip(x.iter().chain(y.iter()).rev()).map(|(b, c)| b ^ c).fold(0_i32, |a, c| a.wrapping_mul(3).wrapping_add(c));
    t.wrapping_add(u.wrapping_mul(5))
}
