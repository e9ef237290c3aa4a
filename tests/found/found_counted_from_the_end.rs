// Elements from the last on with numbers that go up, of which some are left out.
#[function]
pub fn found_counted_from_the_end_0(x: [i32; 5], n: usize) -> i32 {
    let mut r = 0_i32;
    for (i, y) in x.iter().rev().enumerate().take(n % 7) { r = r.wrapping_mul(3).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x.iter().rev().enumerate().skip(n % 7) { r = r.wrapping_mul(5).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x.iter().rev().enumerate().skip(n % 3).take(2) { r = r.wrapping_mul(7).wrapping_add(*y).wrapping_add(i as i32); }
    r
}
#[function]
pub fn found_counted_from_the_end_1(x: [i32; 5], z: [i32; 3], n: usize) -> i32 {
    let mut r = 0_i32;
    for (i, (a, b)) in x.iter().zip(z.iter()).rev().enumerate().take(n % 5) { r = r.wrapping_mul(3).wrapping_add(*a).wrapping_sub(*b).wrapping_add(i as i32); }
    r
}
#[function]
pub fn found_counted_from_the_end_2(x: &[i32; 6], n: usize) -> i32 {
    let mut r = 0_i32;
    for (i, y) in x[1..].iter().rev().enumerate().take(n % 7) { r = r.wrapping_mul(3).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x[..n % 6].iter().rev().enumerate().skip(1).take(2) { r = r.wrapping_mul(3).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x.iter().skip(n % 7).rev().enumerate().take(3) { r = r.wrapping_mul(3).wrapping_add(*y).wrapping_add(i as i32); }
    let s: i32 = x.iter().rev().enumerate().skip(1).map(|(i, y)| (y & 255) * i as i32).sum();
    let t = x.iter().rev().enumerate().take(n % 7).fold(0_i32, |a, (i, y)| a.wrapping_mul(5).wrapping_add(*y ^ i as i32));
    let u = x.iter().rev().enumerate().take(n % 7).position(|(i, y)| *y as usize == i);
    let v = x.iter().rev().enumerate().skip(n % 7).find(|(i, y)| **y as usize > *i).map_or(0, |(i, y)| y.wrapping_mul(i as i32));
    r.wrapping_add(s).wrapping_add(t).wrapping_add(u.unwrap_or(50) as i32).wrapping_add(v)
}
#[function]
pub fn found_counted_from_the_end_3(x: [i32; 5], n: usize) -> i32 {
    let mut r = 0_i32;
    for (i, y) in x.iter().enumerate().rev().take(n % 7) { r = r.wrapping_mul(3).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x.iter().enumerate().rev().skip(n % 7) { r = r.wrapping_mul(5).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x.iter().enumerate().skip(n % 3).rev().take(2) { r = r.wrapping_mul(7).wrapping_add(*y).wrapping_add(i as i32); }
    for (i, y) in x.iter().enumerate().take(n % 6).rev().skip(1).rev() { r = r.wrapping_mul(7).wrapping_add(*y).wrapping_add(i as i32); }
    r
}
#[function]
pub fn found_counted_from_the_end_4(y: [i32; 5], m: usize, n: usize) -> i32 {
    let x = &y[..m % 6];
    let mut s = 0_i32;
    for (i, w) in x.windows(2).enumerate() { s = s.wrapping_mul(3).wrapping_add(w[1]).wrapping_add(i as i32); }
    for (i, w) in x.chunks(2).enumerate().rev() { s = s.wrapping_mul(3).wrapping_add(w[0]).wrapping_add(i as i32); }
    for (w, z) in x.windows(3).zip(x.iter().rev()) { s = s.wrapping_mul(3).wrapping_add(w[2]).wrapping_add(*z); }
    for w in x.windows(2).rev() { s = s.wrapping_mul(3).wrapping_add(w[1]); }
    for w in x.chunks(2).rev().skip(1) { s = s.wrapping_mul(3).wrapping_add(w[0]); }
    for w in x.chunks(3).skip(n % 3).take(1) { s = s.wrapping_mul(3).wrapping_add(w[0]); }
    for (i, w) in x.chunks(2).rev().enumerate().take(n % 4) { s = s.wrapping_mul(3).wrapping_add(w[0]).wrapping_add(i as i32); }
    s
}
