// Names inside `|` that stand for other places in each case, in `if let` and `matches!`.
#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum FoundPatternsByCaseE { A(i32), B(i32), C { x: i32, y: i32 }, D(Option<i32>), E }
#[function]
fn make(k: u8, x: i32) -> FoundPatternsByCaseE { match k % 6 { 0 => FoundPatternsByCaseE::A(x), 1 => FoundPatternsByCaseE::B(x), 2 => FoundPatternsByCaseE::C { x, y: 3 }, 3 => FoundPatternsByCaseE::D(Some(x)), 4 => FoundPatternsByCaseE::D(None), _ => FoundPatternsByCaseE::E } }
#[function]
pub fn found_patterns_by_case(k: u8, x: i32) -> (i32, bool, bool, i32) {
    let e = make(k, x);
    let a = if let FoundPatternsByCaseE::A(n) | FoundPatternsByCaseE::B(n) | FoundPatternsByCaseE::C { x: n, .. } = e { n.wrapping_add(1) } else { 7 };
    let b = matches!(e, FoundPatternsByCaseE::A(n) | FoundPatternsByCaseE::B(n) if n > 3);
    let c = matches!(make(k, a), FoundPatternsByCaseE::A(n) | FoundPatternsByCaseE::D(Some(n)) if n > 3) && x != 4;
    let mut s = 0;
    if let FoundPatternsByCaseE::D(Some(n @ (1 | 3))) | FoundPatternsByCaseE::C { y: n, .. } = make(k, x) { s += n; }
    if let FoundPatternsByCaseE::A(n) | FoundPatternsByCaseE::B(n) = e { if n > 2 { return (n, b, c, 1); } } else if let FoundPatternsByCaseE::D(Some(n)) = e { s = s.wrapping_add(n); }
    (a, b, c, s)
}
#[function]
pub fn found_patterns_by_case_2(k: u8, x: i32) -> (i32, i32) {
    let mut e = make(k, x);
    if let FoundPatternsByCaseE::A(n) | FoundPatternsByCaseE::B(n) | FoundPatternsByCaseE::C { y: n, .. } = &mut e { *n = n.wrapping_mul(3); }
    let p = (x, k as i32);
    let r = if let (1, v) | (v, 1) = p { v } else { -1 };
    let q = match e { FoundPatternsByCaseE::A(v) | FoundPatternsByCaseE::B(v) => v, FoundPatternsByCaseE::C { x, y } => x.wrapping_sub(y), _ => 0 };
    let z = if matches!(p, (0, v) | (v, 0) if v > 9) { 1 } else { 2 };
    (q.wrapping_add(z), r)
}
