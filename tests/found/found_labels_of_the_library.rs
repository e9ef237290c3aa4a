// Labels of loops through what functions of the library give, which have labels of their own.
#[function]
pub fn found_labels_of_the_library(a: [i32; 4], b: [i32; 3], k: i32) -> i32 {
    let mut s = 0_i32;
    'chain: for x in a.iter().map(|x| x.wrapping_mul(3)).chain(b.iter().map(|x| x ^ 5)) {
        for y in 0..4 {
            if y > (x & 3) { continue 'chain; }
            s = s.wrapping_mul(7).wrapping_add(x ^ y);
            if s & 31 == k & 31 { break 'chain; }
        }
        s = s.wrapping_sub(1);
    }
    s
}
#[function]
pub fn found_labels_of_the_library_rev(a: [i32; 4], b: [i32; 3], k: i32) -> i32 {
    let mut s = 0_i32;
    'chain: for (i, x) in a.iter().map(|x| x.wrapping_mul(3)).chain(b.iter().map(|x| x ^ 5)).enumerate() {
        'outer: for y in b.iter().filter(|y| **y != k).chain(a.iter().filter(|y| **y > 2)) {
            if *y > (x & 3) { continue 'chain; }
            s = s.wrapping_mul(7).wrapping_add(x ^ y);
            for z in 0..3 { if z == (s & 7) { continue 'outer; } s = s.wrapping_add(z); }
            if s & 31 == k & 31 { break 'chain; }
            if s & 3 == 1 { break 'outer; }
        }
        s = s.wrapping_sub(i as i32);
    }
    s
}
// helper
#[function]
fn found_labels_of_the_library_callee(a: [i32; 4], k: i32, mut f: impl FnMut(i32) -> bool) -> i32 {
    let mut n = 0;
    'outer: for x in a {
        for y in 0..3 {
            if f(x.wrapping_add(y)) { n += 1; continue 'outer; }
            if n > (k & 3) { break 'outer; }
        }
        n += 10;
    }
    n
}
#[function]
pub fn found_labels_of_the_library_closure(a: [i32; 4], b: [i32; 3], k: i32) -> i32 {
    let mut s = 0_i32;
    let r = found_labels_of_the_library_callee(a, k, |x| {
        let mut hit = false;
        'outer: for y in b {
            for z in 0..3 {
                s = s.wrapping_add(z);
                if z == (x & 3) { continue 'outer; }
                if y == x { hit = true; break 'outer; }
            }
            s ^= y;
        }
        hit || s & 1 == 0
    });
    s.wrapping_add(r)
}
