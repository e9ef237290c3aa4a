// A `let … else` that ends in what leaves, without a `;`.
#[function]
fn half(x: i32) -> Option<i32> { if x % 2 == 0 { Some(x / 2) } else { None } }
#[function]
pub fn found_else_that_leaves_2(x: [i32; 6]) -> i32 {
    let mut s = 0i32;
    for v in x {
        let Some(v) = half(v) else { continue };
        let Some(v) = half(v) else { s = s.wrapping_add(1); if s > 2 { break } else { continue } };
        let Some(v) = half(v) else { match v { 1 => return s, 2 | 3 => break, _ => { s ^= 1; continue } } };
        s = s.wrapping_add(v);
    }
    s
}
#[function]
pub fn found_else_that_leaves(x: i32) -> i32 {
    let Some(h) = half(x) else { if x > 3 { return 1 } else if x < -3 { return 2 } return 3 };
    h
}

