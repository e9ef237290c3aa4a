#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FOUND_500124_V0_0Alpha(pub u8, pub i32, pub i16, pub i16);
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FOUND_500124_V0_0Line<T, const N: usize> { pub low: T, pub line: [T; N], pub at: usize }
impl<T: Copy + Default, const N: usize> Default for FOUND_500124_V0_0Line<T, N> {
    fn default() -> Self { FOUND_500124_V0_0Line { low: T::default(), line: [T::default(); N], at: 0 } }
}
#[data]
impl<T: Copy + PartialOrd, const N: usize> FOUND_500124_V0_0Line<T, N> {
    pub fn found_500124_v0_0_turned(&mut self, x: T) -> T {
        let old = self.line[self.at % N];
        self.line[self.at % N] = x;
        self.at = self.at.wrapping_add(1);
        old
    }
    pub fn found_500124_v0_0_largest(&self) -> T {
        self.line.iter().fold(self.low, |most, x| if *x > most { *x } else { most })
    }
    pub fn found_500124_v0_0_found(&self, wanted: T) -> Option<usize> {
        self.line.iter().position(|x| *x == wanted)
    }
    pub fn found_500124_v0_0_with(self, low: T) -> FOUND_500124_V0_0Line<T, N> { FOUND_500124_V0_0Line { low, ..self } }
    pub fn found_500124_v0_0_each(&mut self, change: impl Fn(T) -> T) -> usize {
        for x in &mut self.line { *x = change(*x); }
        N
    }
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FOUND_500124_V0_0Maybe<T> { #[default] Nothing, Just(T), Both { low: T, rate: u8 } }
#[data]
impl<T: Copy> FOUND_500124_V0_0Maybe<T> {
    pub fn found_500124_v0_0_or(&self, other: T) -> T {
        match self { FOUND_500124_V0_0Maybe::Nothing => other, FOUND_500124_V0_0Maybe::Just(x) => *x, FOUND_500124_V0_0Maybe::Both { low, .. } => *low }
    }
    pub fn found_500124_v0_0_as_option(self) -> Option<T> {
        match self { FOUND_500124_V0_0Maybe::Both { rate: 0, .. } | FOUND_500124_V0_0Maybe::Nothing => None, FOUND_500124_V0_0Maybe::Just(x) => Some(x), FOUND_500124_V0_0Maybe::Both { low, .. } => Some(low) }
    }
}
#[function]
fn found_500124_v0_0_generic<T: Real>(x: T, y: T) -> T { ((x / x) / T::PI.min(T::ONE)).max((if T::PI < y { T::ONE } else { y }).min(T::MAX.max(T::MAX))) }
#[function]
fn found_500124_v0_0_larger<T: PartialOrd + Copy>(a: T, b: T) -> T { if b > a { b } else { a } }
#[function]
fn found_500124_v0_0_counted<T: PartialEq + Copy, const N: usize>(values: [T; N], of: T) -> usize {
    values.iter().filter(|x| **x == of).count() + 10 * N
}
#[function]
fn found_500124_v0_0_nearest<T: Copy, const N: usize>(values: [T; N], far: impl Fn(T) -> u32) -> T {
    let mut best = values[0];
    for x in values { if far(x) < far(best) { best = x; } }
    best
}
#[function]
fn found_500124_v0_0_visit<T: Copy, F: FnMut(T) -> bool>(first: T, second: T, mut visit: F) -> u8 {
    if visit(first) && visit(second) { 2 } else { 1 }
}
#[interface]
pub trait FOUND_500124_V0_0Way {
const FOUND_500124_V0_0_LIMIT: i32;
fn found_500124_v0_0_way0(&mut self, x: f64) -> bool;
fn found_500124_v0_0_way1(&mut self, x: [u8; 4]) -> BoundedMatrix<i32, 2, 3>;
fn found_500124_v0_0_both(&mut self, x: f64) -> bool { let _ = self.found_500124_v0_0_way0(x); self.found_500124_v0_0_way0(x) }
fn found_500124_v0_0_limit(&self) -> i32 { Self::FOUND_500124_V0_0_LIMIT }
}
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FOUND_500124_V0_0Own { pub low: isize }
#[data]
impl FOUND_500124_V0_0Way for FOUND_500124_V0_0Own {
const FOUND_500124_V0_0_LIMIT: i32 = 63;
fn found_500124_v0_0_way0(&mut self, x: f64) -> bool {
self.low |= (x as isize).min(self.low);
((*self) != Some((FOUND_500124_V0_0Own { low: self.low })).unwrap_or((*self)))
}
fn found_500124_v0_0_way1(&mut self, x: [u8; 4]) -> BoundedMatrix<i32, 2, 3> {
for b in 1..=((x[2] << 4) % 5) as i8 {
for next_a in 0..((self.low as i32) % 6) {
self.low &= (next_a as isize);
}
match (SMatrix::<f32, 4, 2>::from_element((x[3] as f32))) {
_ => { self.low = self.low;
self.low = (self.low as isize);
 }
mut c => { found_500124_v0_0_larger(u16::MAX, (x[(Some(6_usize).unwrap_or(7_usize) % 4)] as u16));
c[(((!(self.low as usize)) % 4), usize::MIN.wrapping_mul(usize::MAX))] -= c[(((match (8_i32) {
2..=5 => { usize::MIN }
part => { (x[0] as usize) }
limit => { (limit as usize) }
}) % 4), (x[2] as usize))];
 }
}
self.low = self.low;
}
BoundedMatrix::<i32, 2, 3>::from_matrix(&SMatrix::<i32, 1, 3>::from_element(9_i32))
}
fn found_500124_v0_0_both(&mut self, x: f64) -> bool {
self.low = self.low;
true
}
}
#[function]
fn found_500124_v0_0_driven<W: FOUND_500124_V0_0Way>(way: &mut W, x: f64) -> bool { way.found_500124_v0_0_both(x) }
#[function]
fn found_500124_v0_0_of<W: FOUND_500124_V0_0Way>(way: &W) -> i32 { way.found_500124_v0_0_limit().wrapping_add(W::FOUND_500124_V0_0_LIMIT) }
#[function]
pub fn found_500124_v0_0(limit: &[[u32; 4]; 4], at: &SMatrix<f32, 4, 1>, mut c: [[u8; 3]; 4], next_a: isize, t: &mut u64) -> Result<Option<Option<u8>>, FOUND_500124_V0_0Maybe<[i16; 1]>> {
c[3][2] |= ('l3: {
if true {
found_500124_v0_0_counted([(-1_i64)], (next_a as i64));
c[(limit[2].chunks_exact(2).skip(3).fold((next_a as u8), |sum, state| { sum }) % 4) as usize][1] = c[(found_500124_v0_0_visit((at[1] as u16), (c[0][0] as u16), |sum| { let limit: bool = false;
limit }) % 4) as usize][(c[0][1].rem_euclid(6) % 3) as usize];
tick_u32(limit[((false as usize) % 4)][2], t);
tick_f32(at[((next_a as u8) % 4) as usize], t);
} else {
c[3][(5_usize % 3)] ^= c[((at[0] as usize) % 4)][((match ((c[0][1] as i32)) {
next_a @ 0..=5 => { (at[2] as usize) }
state => { 3_usize }
}) % 3)];
let _: Result<List<u16, 4>, f32> = Err::<List<u16, 4>, f32>(at[((at[1] as usize) % 4)]);
let index: [u8; 1] = [c[2][((limit[0][0] as usize).div_euclid(9) % 3)]];
}
c[3][2] });
c = [[c[(usize::MAX % 4)][0], (next_a as u8), c[((next_a as usize) % 4)][(c[2].iter().chain(c[2].iter()).chain(c[0].iter()).copied().map(|n| { let state: [FOUND_500124_V0_0Maybe<[i16; 1]>; 1] = [(FOUND_500124_V0_0Maybe::<[i16; 1]>::Just([(c[0][2] as i16)])); 1];
[0_usize, (c[2][1] as usize)] }).fold(1_usize, |sum, result| { let mut length: FOUND_500124_V0_0Line<u64, 4> = (FOUND_500124_V0_0Line::<u64, 4> { line: [6_u64, 0_u64, (c[0][1] as u64), 7_u64], ..(FOUND_500124_V0_0Line::<u64, 4> { low: (next_a as u64), line: [(result[0] as u64), (at[2] as u64), (next_a as u64), (c[2][0] as u64)], at: 1_usize }) });
sum }) % 3)]], c[(found_500124_v0_0_visit(1_u16, (c[1][2] as u16), |mut index| { let length = core::mem::replace(&mut index, 0_u16);
false }) % 4) as usize], c[(c[3][0] % 4) as usize], c[((limit[1][3] as usize) % 4)]];
for (result, [state, _, item]) in c.iter().enumerate() {
match c {
[.., result] if result.contains(&((*state) as u8)) => { let _: f64 = 19.25_f64;
 }
[_, ..] => { let sum: f64 = ((*item) as f64);
tick_isize(next_a, t);
tick_isize(next_a, t);
 }
}
let mut state: FOUND_500124_V0_0Maybe<[i16; 1]> = ('l5: {
let result: usize = result;
if true { break 'l5 (FOUND_500124_V0_0Maybe::<[i16; 1]>::Both { low: [(next_a as i16)], rate: c[1][1] }); }
(FOUND_500124_V0_0Maybe::<[i16; 1]>::Nothing) });
}
c[(c[0][1].abs_diff(c[2][0]) % 4) as usize] = [c[1].iter().copied().map(|a| { a }).map(|x| (x % 3) as u8).sum::<u8>(), None::<u8>.unwrap_or(c[(((limit[0][0] as u16) as u8) % 4) as usize][0]), c[(found_500124_v0_0_visit(1_u16, 4_u16, |mut result| { true }) % 4) as usize][((if (limit[2][3] <= limit[0][1]) && ((next_a as u16) > (limit[2][0] as u16)) { usize::MIN } else { let mut next_a: i8 = 4_i8;
5_usize }) % 3)].pow(3)];
let mut passes7 = 0_u8;
#[bound(40)]
while passes7 < 5 && Ok::<SMatrix<i32, 3, 1>, i64>(matrix![(at[((limit[2][0] as usize) % 4)] as i32); (next_a as i32); (at[0] as i32)]).is_ok() {
passes7 += 1;
let mut result: FOUND_500124_V0_0Maybe<[i16; 1]> = (FOUND_500124_V0_0Maybe::<[i16; 1]>::Just([(at[0] as i16)]));
if (false || false) { return Ok::<Option<Option<u8>>, FOUND_500124_V0_0Maybe<[i16; 1]>>(Some(Some(c[(found_500124_v0_0_counted([(c[2][1] as f64)], 18.0_f64) % 4)][((limit[0][3] as usize).rotate_left(limit[2][0]) % 3)]))); }
tick_f32(at[((at[2] as usize) % 4)], t);
tick_u8(c[0][2], t);
}
c = core::array::from_fn::<[u8; 3], 4, _>(|value| { [c[(found_500124_v0_0_counted([7_i64], 8_i64) % 4)][(5_u8 % 3) as usize], c[((*limit).iter().rev().copied().fold(c[2][2], |sum, [mut length, y, mut item, mut state]| { c[0][2] }) % 4) as usize][(value % 3)], 2_u8] });
let mut passes10 = 0_u8;
#[bound(40)]
while passes10 < 5 && (1_u8 >= (at[(usize::MAX % 4)] as u8)) && let _ = limit[2][(usize::MIN % 4)] {
passes10 += 1;
{
let value = &(*limit)[..];
c[(c[0][2] % 4) as usize][(9_usize % 3)] /= c[3][((c[1][1] as usize) % 3)];
c[(1_usize.rem_euclid(8) % 4)] = c[0];
c[(((value[value.len() / 2][0] as usize) & 9_usize) % 4)].sort_by(|one, other| other.cmp(one));
tick_isize(next_a, t);
tick_u8(c[(tick_usize((next_a as usize), t) % 4)][2], t);
}
c[0] = (match (*limit) {
[[.., _], item, [mut state, mut b, _, _], [next, ..]] if (2_u32 != limit[1][3]) => { c[(c[2][0].abs_diff(c[3][1]) % 4) as usize][0] |= 2_u8;
c[2] }
[index, [.., a], [mut c, mut sum, _, _], [item, ..]] => { [0_u8, (next_a as u8), 0_u8] }
b => { [c[2][1], 7_u8, 0_u8] }
});
for c in limit[(u8::MAX % 4) as usize].iter() {
let mut state: FOUND_500124_V0_0Maybe<[i16; 1]> = (FOUND_500124_V0_0Maybe::<[i16; 1]>::Just([((*c) as i16)]));
(state, state) = (state, state);
}
}
tick_f32(at[2], t);
tick_f32(at[1], t);
Err::<Option<Option<u8>>, FOUND_500124_V0_0Maybe<[i16; 1]>>((FOUND_500124_V0_0Maybe::<[i16; 1]>::Both { low: [2_i16], rate: c[((8_usize >> 25) % 4)][2] }))
}
