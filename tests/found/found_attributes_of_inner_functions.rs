// Functions inside a function that are `const`, named for the C, lend, give an iterator and write.
#[function]
pub fn found_attributes_of_inner_functions(x: u8) -> u8 {
    const fn square(x: u8) -> u8 { x.wrapping_mul(x) }
    const NINE: u8 = square(3);
    #[c(name = "own_name")]
    fn named(x: u8) -> u8 { x ^ 3 }
    fn first<'a>(x: &'a [u8], k: u8) -> &'a u8 { if k > 3 { &x[0] } else { &x[1] } }
    fn many(x: &[u8]) -> impl Iterator<Item = u8> + '_ { x.iter().map(|v| v ^ 1) }
    fn set(x: &mut [u8; 2], v: u8) { x[0] = v; }
    let mut a = [x, NINE];
    set(&mut a, named(x));
    a[1] ^= *first(&a, x);
    many(&a).fold(square(x), |s, v| s.wrapping_add(v))
}
