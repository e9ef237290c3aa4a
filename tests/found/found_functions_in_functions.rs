// Functions inside functions, several of one name: of modules, methods, interfaces, operators and instances; named as an author's own, as words of C; that fault.
pub mod found_functions_in_functions_m {
use bessemer::prelude::*;
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter<T>(pub T);
#[interface]
pub trait Shape { fn area(&self) -> f64; fn twice(&self) -> f64 { fn helper(x: f64) -> f64 { x * 2.0 } helper(self.area()) } }
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc(pub f64);
#[data]
impl Shape for Disc { fn area(&self) -> f64 { fn helper(x: f64) -> f64 { x * x } 3.0 * helper(self.0) } }
#[data]
impl Shape for Filter<f64> { fn area(&self) -> f64 { fn helper(x: f64) -> f64 { x + 1.0 } helper(self.0) } }
#[data]
impl core::ops::Add for Disc { type Output = Self; fn add(self, o: Self) -> Self { fn helper(a: f64, b: f64) -> f64 { a.sin() - b } Disc(helper(self.0, o.0)) } }
#[data]
impl From<f64> for Disc { fn from(x: f64) -> Self { fn helper(x: f64) -> f64 { x / 3.0 } Disc(helper(x)) } }
#[data]
impl From<u8> for Disc { fn from(x: u8) -> Self { fn helper(x: u8) -> f64 { f64::from(x) + 0.25 } Disc(helper(x)) } }
#[data]
impl<T: Real> Filter<T> {
    pub fn step(self, x: T) -> T {
        fn mix<U: Real>(a: U, b: U) -> U { a - b * b }
        mix(self.0, x)
    }
}
#[function]
fn helper(x: f64) -> f64 { x - 100.0 }
#[function]
fn scaled<const N: usize>(x: f64) -> f64 {
    const K: f64 = 3.0;
    fn helper(x: f64) -> f64 { x * K }
    let mut y = x;
    for _ in 0..N { y = helper(y); }
    y
}
#[function]
pub fn found_functions_in_functions(a: f64, b: u8) -> [f64; 7] {
    /// Orders two.
    fn order(x: &mut f64, y: &mut f64) { if *y < *x { core::mem::swap(x, y); } }
    fn outer(x: f64) -> f64 {
        fn inner(x: f64) -> f64 { x.cos() + sibling(x) }
        inner(x) + sibling(x)
    }
    fn sibling(x: f64) -> f64 { helper(x) }
    fn int(x: f64) -> f64 { x.floor() }
    fn applied(f: impl Fn(f64) -> f64, x: f64) -> f64 { f(x) + f(1.0) }
    let (mut p, mut q) = (a, f64::from(b));
    order(&mut p, &mut q);
    let m = [a, p, q].map(int);
    [p, q, outer(a), applied(|x| x * p, a) + applied(sibling, a), m[0] + Disc(a).twice() + Filter(a).twice(), scaled::<2>(a) + scaled::<5>(a), (Disc(a) + Disc::from(b) + Disc::from(a)).0 + Filter(a).step(p)]
}
#[function]
pub fn found_functions_in_functions_b(a: f32) -> f32 {
    fn helper(x: f32) -> f32 { if x < 0.0 { return -x; } x.sqrt() }
    fn owner(x: f32) -> f32 { x + 1.0 }
    fn cx(x: f32) -> f32 { x * 0.5 }
    let n = Some(a).map(helper).map(owner).map(cx).unwrap_or(0.0);
    n + Filter(a).step(2.0)
}
}
pub use found_functions_in_functions_m::{found_functions_in_functions, found_functions_in_functions_b};
#[function]
fn found_functions_in_functions_clash_helper_in(x: i32) -> i32 { x.wrapping_mul(7) }
#[function]
fn helper_in_found_functions_in_functions_clash_a(x: i32) -> i32 { found_functions_in_functions_clash_helper_in(x) }
#[function]
fn found_functions_in_functions_clash_a(x: i32) -> i32 { fn helper(x: i32) -> i32 { x.wrapping_sub(5) } helper(x) ^ helper_in_found_functions_in_functions_clash_a(x) }
#[function]
pub fn found_functions_in_functions_clash(x: i32) -> i32 { fn a(x: i32) -> i32 { x ^ 1 } fn double(x: i32) -> i32 { a(x).wrapping_add(a(x ^ 7)) } found_functions_in_functions_clash_a(x).wrapping_add(double(x)) }
#[function]
pub fn found_functions_in_functions_words(x: i32) -> i32 { fn int(x: i32) -> i32 { x ^ 1 } fn register(x: i32) -> i32 { int(x) ^ 3 } fn main(x: i32) -> i32 { register(x).wrapping_mul(3) } main(x) }
#[function]
pub fn found_functions_in_functions_faults(x: i32, y: [i32; 3], i: usize) -> i32 {
    const T: &[i32] = &[3, 0, -1];
    #[inline]
    fn div(a: i32, b: i32) -> i32 { a / b }
    fn at(y: &[i32], i: usize) -> i32 { let mut s = 0; for v in &y[i..] { s += v; } s }
    let int = |x: i32| div(x, T[i % 4]);
    int(x) + at(&y, i) + { let div = 3; div }
}
