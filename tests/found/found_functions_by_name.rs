// Functions handed on by their names to functions that call them.
#[function]
fn twice(f: impl Fn(i32) -> i32, x: i32) -> i32 { f(f(x)) }
#[function]
fn thrice<F: Fn(i32) -> i32>(f: F, x: i32) -> i32 { f(f(f(x))) }
#[function]
fn plus(x: i32) -> i32 { x.wrapping_mul(3).wrapping_add(1) }
pub mod inner {
    use bessemer::prelude::*;
    #[function]
    pub fn minus(x: i32) -> i32 { x.wrapping_sub(4) }
}
#[function]
pub fn found_functions_by_name(x: i32) -> i32 { twice(plus, x).wrapping_add(thrice(plus, x)).wrapping_mul(thrice(inner::minus, x)).wrapping_sub(twice(i32::wrapping_neg, x)) }
#[function]
fn gather(f: impl Fn(i32, i32) -> i32, x: [i32; 3]) -> i32 { let mut s = x[0]; for v in x { s = f(s, v); } s }
#[function]
fn less(a: i32, b: i32) -> i32 { a.wrapping_mul(2).wrapping_sub(b) }
#[function]
fn through(f: impl Fn(i32) -> i32, g: impl Fn(i32) -> i32, x: i32) -> i32 { g(f(x)) }
#[function]
fn inc(x: i32) -> i32 { x.wrapping_add(1) }
#[function]
fn dbl(x: i32) -> i32 { x.wrapping_mul(2) }
#[function]
fn deep(f: impl Fn(i32) -> i32, x: i32) -> i32 { through(&f, inc, x).wrapping_sub(through(dbl, &f, x)) }
#[function]
pub fn found_functions_by_name_2(x: [i32; 3]) -> (i32, i32, i32) { (gather(less, x), through(inc, dbl, x[0]).wrapping_sub(through(dbl, inc, x[0])), deep(inc, x[1]).wrapping_add(deep(|v| v ^ 3, x[2]))) }

