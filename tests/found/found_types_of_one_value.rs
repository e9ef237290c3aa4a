// Types, interfaces and methods that the C does not tell apart, and Rust does.
#[interface]
pub trait FoundTypesOfOneValueWide { const W: i32; fn w(self) -> i32; }
#[data]
impl FoundTypesOfOneValueWide for char { const W: i32 = 1; fn w(self) -> i32 { 5 } }
#[data]
impl FoundTypesOfOneValueWide for u32 { const W: i32 = 2; fn w(self) -> i32 { 6 } }
#[function]
fn found_types_of_one_value_w<T: FoundTypesOfOneValueWide + Copy>(t: T) -> i32 { T::W.wrapping_mul(t.w()) }
#[data]
#[derive(Clone, Copy)]
pub struct FoundTypesOfOneValueCode { pub a: i32 }
#[data]
impl From<char> for FoundTypesOfOneValueCode { fn from(c: char) -> FoundTypesOfOneValueCode { FoundTypesOfOneValueCode { a: 5 ^ (c as i32) } } }
#[data]
impl From<u32> for FoundTypesOfOneValueCode { fn from(c: u32) -> FoundTypesOfOneValueCode { FoundTypesOfOneValueCode { a: 500 ^ (c as i32) } } }
#[function]
pub fn found_types_of_one_value_0(a0: i32, n: i32) -> i32 {
    let of_options = found_types_of_one_value_of(Some('a')).wrapping_mul(3) ^ found_types_of_one_value_of(Some(4_u32));
    found_types_of_one_value_w('a').wrapping_mul(100) ^ found_types_of_one_value_w(3_u32) ^ FoundTypesOfOneValueCode::from('a').a ^ FoundTypesOfOneValueCode::from(n as u32).a.wrapping_mul(7) ^ of_options ^ a0
}
#[function]
fn found_types_of_one_value_of<T: FoundTypesOfOneValueWide + Copy>(t: Option<T>) -> i32 { match t { Some(t) => t.w() ^ T::W, None => 3 } }
pub mod found_types_of_one_value_near {
    use bessemer::prelude::*;
    #[interface]
    pub trait FoundTypesOfOneValueDistance { fn f(&self) -> i32; fn g(&self) -> i32 { self.f() ^ 16 } }
    #[data]
    impl FoundTypesOfOneValueDistance for super::FoundTypesOfOneValuePlace { fn f(&self) -> i32 { self.a ^ 1 } }
    #[data]
    impl FoundTypesOfOneValueDistance for i32 { fn f(&self) -> i32 { *self ^ 1 } }
}
pub mod found_types_of_one_value_far {
    use bessemer::prelude::*;
    #[interface]
    pub trait FoundTypesOfOneValueDistance { fn f(&self) -> i32; fn g(&self) -> i32 { self.f() ^ 32 } }
    #[data]
    impl FoundTypesOfOneValueDistance for super::FoundTypesOfOneValuePlace { fn f(&self) -> i32 { self.a ^ 2 } }
    #[data]
    impl FoundTypesOfOneValueDistance for i32 { fn f(&self) -> i32 { *self ^ 2 } }
}
#[data]
#[derive(Clone, Copy)]
pub struct FoundTypesOfOneValuePlace { pub a: i32 }
#[function]
pub fn found_types_of_one_value_1(a0: i32, n: i32) -> i32 {
    let t = FoundTypesOfOneValuePlace { a: n };
    let near = found_types_of_one_value_near::FoundTypesOfOneValueDistance::f(&t) ^ found_types_of_one_value_near::FoundTypesOfOneValueDistance::g(&t).wrapping_mul(5) ^ found_types_of_one_value_near::FoundTypesOfOneValueDistance::f(&a0);
    let far = found_types_of_one_value_far::FoundTypesOfOneValueDistance::f(&t).wrapping_mul(3) ^ found_types_of_one_value_far::FoundTypesOfOneValueDistance::g(&t).wrapping_mul(7) ^ found_types_of_one_value_far::FoundTypesOfOneValueDistance::g(&a0).wrapping_mul(11);
    near ^ far
}
#[data]
#[derive(Clone, Copy)]
pub struct FoundTypesOfOneValueSquare { pub a: i32 }
#[interface]
pub trait FoundTypesOfOneValueShape { fn area(&self) -> i32; }
#[data]
impl FoundTypesOfOneValueSquare { pub fn area(&self) -> i32 { self.a ^ 3 } }
#[data]
impl FoundTypesOfOneValueShape for FoundTypesOfOneValueSquare { fn area(&self) -> i32 { self.area().wrapping_mul(3) } }
#[function]
fn found_types_of_one_value_area<T: FoundTypesOfOneValueShape>(t: &T) -> i32 { t.area() }
#[function]
pub fn found_types_of_one_value_2(a0: i32, n: i32) -> i32 {
    let t = FoundTypesOfOneValueSquare { a: n };
    found_types_of_one_value_area(&t) ^ t.area() ^ a0
}
#[function]
pub fn found_types_of_one_value_3(a0: i32, n: i32) -> i32 {
    let r#type = a0;
    let k = n;
    let f = |x: i32| x ^ r#k ^ r#type;
    let mut last = 3;
    let some = 0..r#last;
    last = 2;
    let mut sum = 0_i32;
    for i in some { sum = sum.wrapping_add(f(i)); }
    sum ^ last
}
