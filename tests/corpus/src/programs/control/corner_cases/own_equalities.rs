//! Comparisons of iterators by an author's `==` that faults. Of known lengths, `eq` and `ne` compare
//! these first; a closure with such an `==` in a `zip` is called as often as Rust calls it.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Ratio {
    pub over: u8,
    pub under: u8,
}

#[data]
impl PartialEq for Ratio {
    fn eq(&self, other: &Self) -> bool {
        60 / self.under * self.over == 60 / other.under * other.over
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    pub one: Ratio,
    pub two: [Ratio; 2],
}

#[function]
fn ratio(word: u8) -> Ratio {
    Ratio { over: word % 3, under: word / 3 % 4 }
}

/// Slices of any lengths.
#[function]
pub fn equal(a: [u8; 4], b: [u8; 3], k: u8, m: u8, reached: &mut u8) -> bool {
    let (a, b) = (a.map(ratio), b.map(ratio));
    let (p, q) = (&a[..usize::from(k % 5)], &b[..usize::from(m % 4)]);
    *reached = 1;
    let mut all = p.iter().eq(q.iter());
    *reached = 2;
    all ^= p.iter().ne(q.iter().rev());
    *reached = 3;
    all ^= p.iter().skip(1).eq(q);
    *reached = 4;
    all ^= p == q;
    *reached = 5;
    all ^= q.iter().chain(p.iter().take(1)).eq(p.iter());
    *reached = 6;
    all
}

/// Arrays, whose lengths are written.
#[function]
pub fn equal_arrays(a: [u8; 4], b: [u8; 3], reached: &mut u8) -> bool {
    let (a, b) = (a.map(ratio), b.map(ratio));
    *reached = 1;
    let mut all = a.iter().eq(b.iter());
    *reached = 2;
    all ^= a.iter().take(3).eq(b.iter());
    *reached = 3;
    all ^= a[..3] == b;
    *reached = 4;
    all
}

/// A part of the items has such an `==`.
#[function]
pub fn equal_parts(a: [u8; 3], k: u8, m: u8, reached: &mut u8) -> bool {
    let of = |x: u8| Pair { one: ratio(x), two: [ratio(x / 3), ratio(x / 5)] };
    let all = [of(a[0]), of(a[1]), of(a[2])];
    let (p, q) = (&all[..usize::from(k % 4)], &all[usize::from(m % 4)..]);
    *reached = 1;
    let mut same = p.iter().eq(q.iter());
    *reached = 2;
    same ^= p.iter().enumerate().eq(q.iter().enumerate());
    *reached = 3;
    same ^= p.iter().map(|x| (x.one, x.two)).ne(q.iter().map(|x| (x.one, x.two)));
    *reached = 4;
    same
}

/// A filter, whose number of items is not known: item after item.
#[function]
pub fn equal_serial(a: [u8; 4], b: [u8; 3], k: u8, m: u8, reached: &mut u8) -> bool {
    let (a, b) = (a.map(ratio), b.map(ratio));
    let (p, q) = (&a[..usize::from(k % 5)], &b[..usize::from(m % 4)]);
    *reached = 1;
    let mut all = p.iter().filter(|x| x.over > 0).eq(q.iter());
    *reached = 2;
    all ^= p.iter().ne(q.iter().take_while(|x| x.over > 0));
    *reached = 3;
    all
}

/// Closures that compare, on both sides of a `zip`.
#[function]
pub fn zipped(a: [u8; 4], b: [u8; 3], k: u8, m: u8, reached: &mut u8) -> u32 {
    let (a, b) = (a.map(ratio), b.map(ratio));
    let (p, q) = (&a[..usize::from(k % 5)], &b[..usize::from(m % 4)]);
    *reached = 1;
    let (first, second, begin) = (a[0], a[1], b[0]);
    let one = p.iter().map(|x| *x == first).zip(q.iter().map(|x| *x == begin));
    let mut sum = one.fold(0_u32, |sum, (x, y)| sum * 4 + u32::from(x) * 2 + u32::from(y));
    *reached = 2;
    let other = p.iter().map(|x| *x != second).zip(q.iter());
    sum = sum * 64 + other.fold(0_u32, |sum, (x, y)| sum * 2 + u32::from(x ^ (y.over > 0)));
    *reached = 3;
    let third = q.iter().zip(p.iter()).filter(|(x, y)| x == y).count();
    *reached = 4;
    sum * 8 + third as u32
}

/// Searches end at the first item that is equal.
#[function]
pub fn found(a: [u8; 4], b: u8, k: u8, reached: &mut u8) -> u32 {
    let (a, b) = (a.map(ratio), ratio(b));
    let p = &a[..usize::from(k % 5)];
    *reached = 1;
    let there = p.contains(&b);
    *reached = 2;
    let at = p.iter().position(|x| *x == b);
    *reached = 3;
    let last = p.iter().rposition(|x| x == &b);
    *reached = 4;
    let all = p.iter().all(|x| *x == b) ^ p.iter().any(|x| *x != b);
    *reached = 5;
    let index = |found: Option<usize>| found.map_or(7, |at| at as u32);
    u32::from(there) + 2 * index(at) + 16 * index(last) + 128 * u32::from(all)
}
