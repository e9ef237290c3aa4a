// Blocks and loops that are left within a condition.
#[function]
fn found_left_in_conditions_0_g<const N: usize>(o: Option<i32>, n: i32) -> i32 {
    'a: { if let Some(x) = o && { if N == 3 { break 'a x; } n > 3 } { return x.wrapping_mul(3); } if n == 2 { break 'a 9; } n }
}
#[function]
pub fn found_left_in_conditions_0(x: i32, n: i32) -> i32 { let o = if x > 0 { Some(x) } else { None }; found_left_in_conditions_0_g::<3>(o, n).wrapping_mul(3).wrapping_add(found_left_in_conditions_0_g::<4>(o, n)) }
#[function]
pub fn found_left_in_conditions_1(x: i32, n: i32) -> i32 {
    let o = if x > 0 { Some(x) } else { None };
    let r = 'a: { if let Some(x) = o && { break 'a x } { 3 } else { 4 } };
    let mut s = 0; let mut i = 0;
    while i < 4 { i += 1; if let Some(x) = o && { if i == 2 { continue; } true } && { break } { s += 1; } s += 2; }
    let t = 'b: { let z = n > 5 && { break 'b 7 }; if z { 1 } else { 2 } };
    r.wrapping_add(s * 1000).wrapping_add(t * 100000)
}
#[function]
fn found_left_in_conditions_2_f(x: &[i32; 4], k: &mut i32) -> i32 {
    let mut n = 0_i32;
    'a: for i in 0..4 {
        'b: for j in (0..4).rev() {
            let v = 'c: { if x[i] == x[j] { break 'c 3; } match x[i] & 3 { 0 => continue 'b, 1 => break 'b, 2 if x[j] < 0 => continue 'a, 2 => { 'd: for y in x { *k += 1; if *y > x[i] { break 'd; } if *y == 5 { break 'a; } if *y == 6 { break 'c 8; } if *y == 1 { return *k; } } 4 } _ => 5 } };
            n = n.wrapping_mul(3).wrapping_add(v);
            if let Some(q) = x.iter().position(|z| *z == v) { if q == j { continue 'a; } n ^= q as i32; }
        }
        n = n.wrapping_add(1);
    }
    n
}
#[function]
pub fn found_left_in_conditions_2(x0: [i32; 4]) -> i32 { let x = x0.map(|y| y & 7); let mut k = 0; let r = found_left_in_conditions_2_f(&x, &mut k); r.wrapping_mul(64).wrapping_add(k) }
