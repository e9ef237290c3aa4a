//! `core::mem::replace` and `swap` of places that calls return, next to assignments and other calls: each write
//! occurs where it does in Rust.
//!
//! There is one function for each way to obtain a place; each writes through a name, directly, in a closure and as an
//! argument.

#![allow(unused_mut, unused_must_use)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shelf {
    pub b: u8,
    pub c: [u8; 3],
    pub o: Option<u8>,
}

#[data]
impl Shelf {
    fn at(&mut self, k: usize) -> &mut u8 {
        &mut self.c[k % 3]
    }

    fn first(&mut self) -> &mut u8 {
        &mut self.b
    }
}

#[function]
fn slot(v: &mut [u8; 3], k: usize) -> &mut u8 {
    &mut v[k % 3]
}

#[function]
fn choose(v: &mut [u8], k: usize) -> &mut u8 {
    if k > 2 {
        return &mut v[0];
    }
    &mut v[1]
}

#[function]
fn any(v: &mut [u8; 3], k: usize) -> Option<&mut u8> {
    v.get_mut(k % 4)
}

#[function]
fn set(place: &mut u8, n: u8) -> u8 {
    let before = *place;
    *place = n;
    before
}

#[function]
fn option_at(v: &mut [Option<u8>; 3], k: usize) -> &mut Option<u8> {
    &mut v[k % 3]
}

#[function]
fn row_at(v: &mut [[i16; 2]; 2], k: usize) -> &mut [i16; 2] {
    &mut v[k % 2]
}

#[function]
fn shelf_at(v: &mut [Shelf; 2], k: usize) -> &mut Shelf {
    &mut v[k % 2]
}

/// Elements that are options, arrays and structs.
#[function]
pub fn elements(a: [u8; 3], i: usize, n: u8) -> ([Option<u8>; 3], [[i16; 2]; 2], [Shelf; 2], u8) {
    let mut options = [Some(a[0]), None, Some(a[2])];
    let mut rows = [[1, 2], [3, i16::from(a[1])]];
    let mut shelves = [Shelf { b: a[0], c: a, o: None }, Shelf::default()];
    let j = i % 6;
    let mut r = core::mem::replace(option_at(&mut options, j), Some(n)).unwrap_or(7);
    let mut spare = None;
    core::mem::swap(option_at(&mut options, j + 1), &mut spare);
    r = r.wrapping_mul(3) ^ spare.unwrap_or(5);
    r = r.wrapping_mul(3) ^ option_at(&mut options, j + 2).take().unwrap_or(9);
    r = r.wrapping_mul(3) ^ option_at(&mut options, j).replace(n ^ 1).unwrap_or(11);
    let row = core::mem::replace(row_at(&mut rows, j), [i16::from(n), 4]);
    core::mem::swap(row_at(&mut rows, j + 1), &mut [row[0] ^ row[1], 8]);
    let shelf =
        core::mem::replace(shelf_at(&mut shelves, j), Shelf { b: n, c: [n; 3], o: Some(n) });
    core::mem::swap(shelf_at(&mut shelves, j + 1).at(j), only(&mut [shelf.b]));
    (options, rows, shelves, r ^ shelf.c[1])
}

#[function]
fn only(v: &mut [u8; 1]) -> &mut u8 {
    &mut v[0]
}

/// The expressions that lead to a place are evaluated once, and before the value.
#[function]
pub fn in_order(a: [u8; 3], n: u8) -> ([u8; 3], u8, u8) {
    let (mut v, mut n) = (a, n);
    let r = core::mem::replace(
        slot(&mut v, {
            n = n.wrapping_add(1);
            usize::from(n)
        }),
        {
            n = n.wrapping_mul(3);
            n
        },
    );
    let mut w = [r, n, 3];
    core::mem::swap(
        slot(&mut v, {
            n ^= 1;
            usize::from(n)
        }),
        slot(&mut w, {
            n = n.wrapping_add(5);
            usize::from(n)
        }),
    );
    (v, w[0] ^ w[1].wrapping_mul(3) ^ w[2].wrapping_mul(5), n)
}

/// Writes to the place that a function returns.
#[function]
pub fn of_a_function(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(slot(&mut v, j), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(slot(&mut v, j), &mut other);
    core::mem::swap(&mut other, slot(&mut v, j));
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(slot(&mut v, j), n.wrapping_add(2)).wrapping_add(other);
    let named = slot(&mut v, j);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(slot(&mut v, j), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(slot(&mut v, j), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(slot(&mut v, j), n ^ 9);
    *slot(&mut v, j) ^= sum;
    *slot(&mut v, j) = sum.wrapping_add(r);
    core::mem::replace(slot(&mut v, j), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the place that a function chooses.
#[function]
pub fn chosen(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(choose(&mut v, i), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(choose(&mut v, i), &mut other);
    core::mem::swap(&mut other, choose(&mut v, i));
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(choose(&mut v, i), n.wrapping_add(2)).wrapping_add(other);
    let named = choose(&mut v, i);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(choose(&mut v, i), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(choose(&mut v, i), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(choose(&mut v, i), n ^ 9);
    *choose(&mut v, i) ^= sum;
    *choose(&mut v, i) = sum.wrapping_add(r);
    core::mem::replace(choose(&mut v, i), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the element that a method returns.
#[function]
pub fn of_a_method(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(s.at(j), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(s.at(j), &mut other);
    core::mem::swap(&mut other, s.at(j));
    sum = sum.wrapping_mul(3) ^ core::mem::replace(s.at(j), n.wrapping_add(2)).wrapping_add(other);
    let named = s.at(j);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(s.at(j), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(s.at(j), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(s.at(j), n ^ 9);
    *s.at(j) ^= sum;
    *s.at(j) = sum.wrapping_add(r);
    core::mem::replace(s.at(j), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the field that a method returns.
#[function]
pub fn of_a_field(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(s.first(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(s.first(), &mut other);
    core::mem::swap(&mut other, s.first());
    sum =
        sum.wrapping_mul(3) ^ core::mem::replace(s.first(), n.wrapping_add(2)).wrapping_add(other);
    let named = s.first();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(s.first(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(s.first(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(s.first(), n ^ 9);
    *s.first() ^= sum;
    *s.first() = sum.wrapping_add(r);
    core::mem::replace(s.first(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the place in an option that a function returns.
#[function]
pub fn given(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(any(&mut v, i).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(any(&mut v, i).unwrap(), &mut other);
    core::mem::swap(&mut other, any(&mut v, i).unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(any(&mut v, i).unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = any(&mut v, i).unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(any(&mut v, i).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(any(&mut v, i).unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(any(&mut v, i).unwrap(), n ^ 9);
    *any(&mut v, i).unwrap() ^= sum;
    *any(&mut v, i).unwrap() = sum.wrapping_add(r);
    core::mem::replace(any(&mut v, i).unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes through a reborrowed reference.
#[function]
pub fn reborrowed(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let q = &mut v[j];
    let mut r = core::mem::replace(&mut *q, n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(&mut *q, &mut other);
    core::mem::swap(&mut other, &mut *q);
    sum = sum.wrapping_mul(3) ^ core::mem::replace(&mut *q, n.wrapping_add(2)).wrapping_add(other);
    let named = &mut *q;
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(&mut *q, n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(&mut *q, n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(&mut *q, n ^ 9);
    *q ^= sum;
    *q = sum.wrapping_add(r);
    core::mem::replace(&mut *q, sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes through a reference.
#[function]
pub fn referred_to(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let q = &mut v[j];
    let mut r = core::mem::replace(q, n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(q, &mut other);
    core::mem::swap(&mut other, q);
    sum = sum.wrapping_mul(3) ^ core::mem::replace(q, n.wrapping_add(2)).wrapping_add(other);
    let named = &mut *q;
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(&mut *q, n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(q, n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(q, n ^ 9);
    *q ^= sum;
    *q = sum.wrapping_add(r);
    core::mem::replace(q, sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to a local.
#[function]
pub fn local(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(&mut x, n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(&mut x, &mut other);
    core::mem::swap(&mut other, &mut x);
    sum = sum.wrapping_mul(3) ^ core::mem::replace(&mut x, n.wrapping_add(2)).wrapping_add(other);
    let named = &mut x;
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(&mut x, n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(&mut x, n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(&mut x, n ^ 9);
    *(&mut x) ^= sum;
    *(&mut x) = sum.wrapping_add(r);
    core::mem::replace(&mut x, sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to an element.
#[function]
pub fn element(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(&mut v[j], n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(&mut v[j], &mut other);
    core::mem::swap(&mut other, &mut v[j]);
    sum =
        sum.wrapping_mul(3) ^ core::mem::replace(&mut v[j], n.wrapping_add(2)).wrapping_add(other);
    let named = &mut v[j];
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(&mut v[j], n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(&mut v[j], n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(&mut v[j], n ^ 9);
    *(&mut v[j]) ^= sum;
    *(&mut v[j]) = sum.wrapping_add(r);
    core::mem::replace(&mut v[j], sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to an element of a field.
#[function]
pub fn field_element(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(&mut s.c[j], n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(&mut s.c[j], &mut other);
    core::mem::swap(&mut other, &mut s.c[j]);
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(&mut s.c[j], n.wrapping_add(2)).wrapping_add(other);
    let named = &mut s.c[j];
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(&mut s.c[j], n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(&mut s.c[j], n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(&mut s.c[j], n ^ 9);
    *(&mut s.c[j]) ^= sum;
    *(&mut s.c[j]) = sum.wrapping_add(r);
    core::mem::replace(&mut s.c[j], sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}
