// Iterators with a name through slices in variables that get others before the iterator is gone through.
#[function]
pub fn found_iterators_of_held_slices_0(a: [i32; 6], n: i32) -> i32 {
    let mut rest = &a[1..];
    let it = rest.iter();
    rest = &rest[2..];
    let s: i32 = it.fold(0, |s, x| s.wrapping_mul(3).wrapping_add(*x));
    s.wrapping_mul(31).wrapping_add(rest[0]).wrapping_add(n)
}
#[data]
#[derive(Clone, Copy)]
pub struct FoundIteratorsOfHeldSlices1<'a> { pub of: &'a [i32] }
#[function]
pub fn found_iterators_of_held_slices_1(a: [i32; 6], n: i32) -> i32 {
    let mut v = FoundIteratorsOfHeldSlices1 { of: &a[1..] };
    let it = v.of.iter();
    v.of = &v.of[2..];
    let mut s: i32 = n;
    for x in it { s = s.wrapping_mul(3).wrapping_add(*x); }
    s.wrapping_mul(31).wrapping_add(v.of[0])
}
#[function]
pub fn found_iterators_of_held_slices_2(a: [i32; 6], n: i32) -> i32 {
    let mut rest = &a[..];
    let mut it = rest.iter();
    let first = it.next().copied().unwrap_or(0);
    if n & 1 == 1 { rest = &rest[3..]; }
    let mut s = first;
    for x in it { s = s.wrapping_mul(3).wrapping_add(*x); }
    s.wrapping_mul(31).wrapping_add(rest[0])
}
#[function]
pub fn found_iterators_of_held_slices_3(a: [i32; 6], n: i32) -> i32 {
    let mut rest = &a[..];
    let mut s = n;
    rest.iter().enumerate().for_each(|(i, x)| { s = s.wrapping_mul(5).wrapping_add(*x); if i < 2 { rest = &rest[1..]; } });
    s.wrapping_add(rest[0])
}
