// A closure whose parameters have the names of another's, and of what stands around both.
#[function]
fn with(f: impl Fn(i32, i32) -> i32, a: i32, b: i32) -> i32 { f(a, b).wrapping_mul(3) ^ f(b, a) }
#[function]
pub fn found_names_of_closures(x: [i32; 4], y: i32) -> i32 {
    let f = |x: i32, y: i32| x.wrapping_sub(y);
    let g = |y: i32, x: i32| f(y, x).wrapping_mul(f(x, y).wrapping_add(3));
    let x = g(x[1], x[0]);
    let y = g(y, x);
    f(y, x)
}
#[function]
pub fn found_names_of_closures_2(a: i32, b: i32) -> i32 {
    let k = 5;
    let f = |x: i32, y: i32| x.wrapping_sub(y.wrapping_mul(k));
    let h = |(x, y): (i32, i32), z: i32| f(z, x) ^ f(y, z);
    let g = |y: i32, x: i32, z: i32| { let t = f(y, f(x, y)); h((x, t), f(z, y)) };
    let x = g(a, b, f(b, a));
    let z = with(|y, x| f(x, y), x, a);
    with(f, z, x) ^ h((z, x), a)
}
#[function]
pub fn found_names_of_closures_3(a: i32) -> i32 {
    let f = |n: i32| n.wrapping_add(1);
    let mut s = 0;
    for n in 0..3 { s = f(s).wrapping_mul(f(n)); let n = f(n); s = s.wrapping_sub(f(n)); }
    let n = f(a);
    f(n).wrapping_add(s)
}

