// {"entries":[{"atomic":false,"name":"found_enums_without_zero_0","params":[["","usize"],["","usize"]],"stops":false}],"instances":null,"unit":null}
// Arrays of an enum whose first variant is not 0 in the C.
#[data]
#[derive(Clone, Copy, PartialEq, Default)]
pub enum FoundEnumsWithoutZeroAE { #[default] A = 5, B = 0, C = 7 }
#[data]
#[derive(Clone, Copy, Default)]
pub struct FoundEnumsWithoutZeroAS { e: FoundEnumsWithoutZeroAE, o: Option<FoundEnumsWithoutZeroAE>, n: u8 }
#[function]
pub fn found_enums_without_zero_0(k: usize, n: usize) -> i64 {
    let mut a = [FoundEnumsWithoutZeroAE::A; 20];
    a[k % 20] = FoundEnumsWithoutZeroAE::C;
    let mut b = [[FoundEnumsWithoutZeroAE::A; 10]; 3];
    b[n % 3][k % 10] = FoundEnumsWithoutZeroAE::B;
    let mut s = [FoundEnumsWithoutZeroAS::default(); 12];
    s[n % 12].o = Some(FoundEnumsWithoutZeroAE::A);
    let mut t = [(FoundEnumsWithoutZeroAE::A, 0_u8); 9];
    t[n % 9].1 = 4;
    let u = [None::<FoundEnumsWithoutZeroAE>; 30];
    let mut h = 0_i64;
    for x in a { h = h * 3 + x as i64; h %= 1_000_000_007; }
    for r in b { for x in r { h = h * 3 + x as i64; h %= 1_000_000_007; } }
    for x in s { h = h * 3 + x.e as i64 + x.o.map_or(1, |e| e as i64) + x.n as i64; h %= 1_000_000_007; }
    for x in t { h = h * 3 + x.0 as i64 * x.1 as i64 + x.0 as i64; h %= 1_000_000_007; }
    for x in u { h = h * 3 + if x == Some(FoundEnumsWithoutZeroAE::A) { 1 } else { 0 }; h %= 1_000_000_007; }
    h
}
