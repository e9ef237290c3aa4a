// {"entries":[{"atomic":false,"name":"found_chains_that_write_0","params":[["","[i32; 2]"],["","i32"]],"stops":false},{"atomic":false,"name":"found_chains_that_write_1","params":[["","[i32; 2]"],["","i32"]],"stops":false},{"atomic":false,"name":"found_chains_that_write_2","params":[["","[i32; 2]"],["","i32"]],"stops":false},{"atomic":false,"name":"found_chains_that_write_3","params":[["","[i32; 3]"],["","i32"]],"stops":false},{"atomic":false,"name":"found_chains_that_write_4","params":[["","[i32; 3]"],["","i32"],["","usize"]],"stops":false}],"instances":null,"unit":null}
// Conditions in which what stands behind a pattern writes the place that its names are taken from.
#[function]
pub fn found_chains_that_write_0(a0: [i32; 2], n: i32) -> i32 {
    let mut a = if a0[0] & 1 == 0 { Some(a0[0]) } else { None };
    let mut r = 0;
    if let Some(x) = a && { a = Some(n); true } && x > 3 { r = x ^ 5; }
    r ^ a.unwrap_or(7)
}
#[function]
pub fn found_chains_that_write_1_set(a: &mut Option<i32>, n: i32) -> bool { *a = Some(n); n != 4 }
#[function]
pub fn found_chains_that_write_1(a0: [i32; 2], n: i32) -> i32 {
    let mut a = if a0[0] & 1 == 0 { Some(a0[0]) } else { None };
    if let Some(x) = a && found_chains_that_write_1_set(&mut a, n) { x } else { a.unwrap_or(11) }
}
#[function]
pub fn found_chains_that_write_2(a0: [i32; 2], n: i32) -> i32 {
    let mut a = Some(a0[0]);
    let mut i = 0;
    let mut r = 0_i32;
    #[bound(5)]
    while let Some(x) = a && { a = Some(n.wrapping_add(i)); i < 4 } && x > -1000 { i += 1; r = r.wrapping_mul(3).wrapping_add(x); }
    r
}
#[function]
pub fn found_chains_that_write_3(a0: [i32; 3], n: i32) -> i32 {
    let mut t = (a0[0], a0[1]);
    if let (x, 0..) = t && { t.0 = n; true } && x > 2 { x } else { t.0 }
}
#[function]
pub fn found_chains_that_write_4(a0: [i32; 3], n: i32, i0: usize) -> i32 {
    let mut v = [Some(a0[0]), None, Some(a0[2])];
    let mut i = i0 % 3;
    let mut r = 0;
    if let Some(x) = v[i] && { i = (i + 1) % 3; v[i] = Some(n); true } && let Some(y) = v[i] && x != y { r = x.wrapping_sub(y); }
    r
}
