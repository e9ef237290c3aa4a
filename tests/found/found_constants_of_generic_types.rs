// Constants of a generic type, where only their use says what stands for its parameters: handed on, given, compared.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundConstantsOfGenericTypes<const F: u32>(i32);
#[data]
impl<const F: u32> FoundConstantsOfGenericTypes<F> {
    pub const ONE: Self = Self(1 << F);
    pub const ZERO: Self = Self(0);
    pub const TABLE: [i32; 3] = [1, 2 + F as i32, 3];
}
#[data]
impl<const F: u32> core::ops::Add for FoundConstantsOfGenericTypes<F> {
    type Output = Self;
    fn add(self, rhs: Self) -> Self { Self(self.0.wrapping_add(rhs.0)) }
}
#[function]
fn found_constants_of_generic_types_sum<const F: u32>(xs: &[FoundConstantsOfGenericTypes<F>]) -> FoundConstantsOfGenericTypes<F> { xs.iter().fold(FoundConstantsOfGenericTypes::ONE, |a, &b| a + b) }
#[function]
fn found_constants_of_generic_types_or<const F: u32>(x: Option<FoundConstantsOfGenericTypes<F>>) -> FoundConstantsOfGenericTypes<F> { x.unwrap_or(FoundConstantsOfGenericTypes::ONE) }
// helper
#[function]
fn found_constants_of_generic_types_pick(x: FoundConstantsOfGenericTypes<5>, first: bool) -> FoundConstantsOfGenericTypes<5> { if first { FoundConstantsOfGenericTypes::ONE } else { let y: FoundConstantsOfGenericTypes<5> = FoundConstantsOfGenericTypes::ZERO; x + y } }
#[function]
pub fn found_constants_of_generic_types(a: i32, b: i32) -> [i32; 6] {
    let s = found_constants_of_generic_types_sum::<4>(&[FoundConstantsOfGenericTypes(a), FoundConstantsOfGenericTypes(b), FoundConstantsOfGenericTypes::ONE]);
    let t = found_constants_of_generic_types_sum::<7>(&[FoundConstantsOfGenericTypes(a), FoundConstantsOfGenericTypes(b), FoundConstantsOfGenericTypes::ONE]);
    let u = found_constants_of_generic_types_or(Some(t).filter(|_| a > b));
    let z = found_constants_of_generic_types_or::<3>(None);
    [s.0, t.0, u.0, z.0, found_constants_of_generic_types_pick(FoundConstantsOfGenericTypes(a), a < 0).0, FoundConstantsOfGenericTypes::<4>::TABLE[1] + if s == FoundConstantsOfGenericTypes::ZERO { 1 } else { 0 }]
}
