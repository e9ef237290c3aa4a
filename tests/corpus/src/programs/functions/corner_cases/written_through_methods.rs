//! `core::mem::replace` and `swap` of places that methods of slices, lists, options and iterators return: each write
//! occurs where it does in Rust.

#![allow(unused_mut, unused_must_use)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shelf {
    pub b: u8,
    pub c: [u8; 3],
    pub o: Option<u8>,
}

#[function]
fn set(place: &mut u8, n: u8) -> u8 {
    let before = *place;
    *place = n;
    before
}

/// Writes to the last element of a slice.
#[function]
pub fn last(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.last_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.last_mut().unwrap(), &mut other);
    core::mem::swap(&mut other, v.last_mut().unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.last_mut().unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = v.last_mut().unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.last_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.last_mut().unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.last_mut().unwrap(), n ^ 9);
    *v.last_mut().unwrap() ^= sum;
    *v.last_mut().unwrap() = sum.wrapping_add(r);
    core::mem::replace(v.last_mut().unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the first element of a slice.
#[function]
pub fn first(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.first_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.first_mut().unwrap(), &mut other);
    core::mem::swap(&mut other, v.first_mut().unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.first_mut().unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = v.first_mut().unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.first_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.first_mut().unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.first_mut().unwrap(), n ^ 9);
    *v.first_mut().unwrap() ^= sum;
    *v.first_mut().unwrap() = sum.wrapping_add(r);
    core::mem::replace(v.first_mut().unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the element at a checked index.
#[function]
pub fn by_index(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.get_mut(j).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.get_mut(j).unwrap(), &mut other);
    core::mem::swap(&mut other, v.get_mut(j).unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.get_mut(j).unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = v.get_mut(j).unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.get_mut(j).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.get_mut(j).unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.get_mut(j).unwrap(), n ^ 9);
    *v.get_mut(j).unwrap() ^= sum;
    *v.get_mut(j).unwrap() = sum.wrapping_add(r);
    core::mem::replace(v.get_mut(j).unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to an element of a split slice.
#[function]
pub fn split(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.split_first_mut().unwrap().0, n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.split_first_mut().unwrap().0, &mut other);
    core::mem::swap(&mut other, v.split_first_mut().unwrap().0);
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.split_first_mut().unwrap().0, n.wrapping_add(2)).wrapping_add(other);
    let named = v.split_first_mut().unwrap().0;
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.split_first_mut().unwrap().0, n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.split_first_mut().unwrap().0, n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.split_first_mut().unwrap().0, n ^ 9);
    *v.split_first_mut().unwrap().0 ^= sum;
    *v.split_first_mut().unwrap().0 = sum.wrapping_add(r);
    core::mem::replace(v.split_first_mut().unwrap().0, sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the last element of a list.
#[function]
pub fn last_of_list(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(l.last_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(l.last_mut().unwrap(), &mut other);
    core::mem::swap(&mut other, l.last_mut().unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(l.last_mut().unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = l.last_mut().unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(l.last_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(l.last_mut().unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(l.last_mut().unwrap(), n ^ 9);
    *l.last_mut().unwrap() ^= sum;
    *l.last_mut().unwrap() = sum.wrapping_add(r);
    core::mem::replace(l.last_mut().unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to an element of a list.
#[function]
pub fn in_list(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(l.get_mut(j).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(l.get_mut(j).unwrap(), &mut other);
    core::mem::swap(&mut other, l.get_mut(j).unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(l.get_mut(j).unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = l.get_mut(j).unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(l.get_mut(j).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(l.get_mut(j).unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(l.get_mut(j).unwrap(), n ^ 9);
    *l.get_mut(j).unwrap() ^= sum;
    *l.get_mut(j).unwrap() = sum.wrapping_add(r);
    core::mem::replace(l.get_mut(j).unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the content of an option, which is inserted if it is missing.
#[function]
pub fn filled(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(o.get_or_insert(3), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(o.get_or_insert(3), &mut other);
    core::mem::swap(&mut other, o.get_or_insert(3));
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(o.get_or_insert(3), n.wrapping_add(2)).wrapping_add(other);
    let named = o.get_or_insert(3);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(o.get_or_insert(3), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(o.get_or_insert(3), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(o.get_or_insert(3), n ^ 9);
    *o.get_or_insert(3) ^= sum;
    *o.get_or_insert(3) = sum.wrapping_add(r);
    core::mem::replace(o.get_or_insert(3), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the content just inserted into an option.
#[function]
pub fn inserted(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(o.insert(4), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(o.insert(4), &mut other);
    core::mem::swap(&mut other, o.insert(4));
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(o.insert(4), n.wrapping_add(2)).wrapping_add(other);
    let named = o.insert(4);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(o.insert(4), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(o.insert(4), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(o.insert(4), n ^ 9);
    *o.insert(4) ^= sum;
    *o.insert(4) = sum.wrapping_add(r);
    core::mem::replace(o.insert(4), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the content of an option, which a closure computes if it is missing.
#[function]
pub fn filled_by(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(o.get_or_insert_with(|| 9), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(o.get_or_insert_with(|| 9), &mut other);
    core::mem::swap(&mut other, o.get_or_insert_with(|| 9));
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(o.get_or_insert_with(|| 9), n.wrapping_add(2)).wrapping_add(other);
    let named = o.get_or_insert_with(|| 9);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(o.get_or_insert_with(|| 9), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(o.get_or_insert_with(|| 9), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(o.get_or_insert_with(|| 9), n ^ 9);
    *o.get_or_insert_with(|| 9) ^= sum;
    *o.get_or_insert_with(|| 9) = sum.wrapping_add(r);
    core::mem::replace(o.get_or_insert_with(|| 9), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the content of an option.
#[function]
pub fn in_option(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(o.as_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(o.as_mut().unwrap(), &mut other);
    core::mem::swap(&mut other, o.as_mut().unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(o.as_mut().unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = o.as_mut().unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(o.as_mut().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(o.as_mut().unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(o.as_mut().unwrap(), n ^ 9);
    *o.as_mut().unwrap() ^= sum;
    *o.as_mut().unwrap() = sum.wrapping_add(r);
    core::mem::replace(o.as_mut().unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the content of an option in a field.
#[function]
pub fn in_field(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(s.o.get_or_insert(5), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(s.o.get_or_insert(5), &mut other);
    core::mem::swap(&mut other, s.o.get_or_insert(5));
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(s.o.get_or_insert(5), n.wrapping_add(2)).wrapping_add(other);
    let named = s.o.get_or_insert(5);
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(s.o.get_or_insert(5), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(s.o.get_or_insert(5), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(s.o.get_or_insert(5), n ^ 9);
    *s.o.get_or_insert(5) ^= sum;
    *s.o.get_or_insert(5) = sum.wrapping_add(r);
    core::mem::replace(s.o.get_or_insert(5), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to an item of an iterator.
#[function]
pub fn iterated(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.iter_mut().nth(j).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.iter_mut().nth(j).unwrap(), &mut other);
    core::mem::swap(&mut other, v.iter_mut().nth(j).unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.iter_mut().nth(j).unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = v.iter_mut().nth(j).unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.iter_mut().nth(j).unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.iter_mut().nth(j).unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.iter_mut().nth(j).unwrap(), n ^ 9);
    *v.iter_mut().nth(j).unwrap() ^= sum;
    *v.iter_mut().nth(j).unwrap() = sum.wrapping_add(r);
    core::mem::replace(v.iter_mut().nth(j).unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the last item of an iterator.
#[function]
pub fn iterated_last(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.iter_mut().last().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.iter_mut().last().unwrap(), &mut other);
    core::mem::swap(&mut other, v.iter_mut().last().unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.iter_mut().last().unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = v.iter_mut().last().unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.iter_mut().last().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.iter_mut().last().unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.iter_mut().last().unwrap(), n ^ 9);
    *v.iter_mut().last().unwrap() ^= sum;
    *v.iter_mut().last().unwrap() = sum.wrapping_add(r);
    core::mem::replace(v.iter_mut().last().unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}

/// Writes to the greatest item of an iterator.
#[function]
pub fn greatest(a: [u8; 3], i: usize, n: u8) -> ([u8; 5], Shelf, Option<u8>, [u8; 2], u8) {
    let (mut x, mut v, mut o, i) = (a[0], a, (a[2] & 1 == 0).then_some(a[2]), i % 5);
    let mut s = Shelf { b: a[1], c: a, o: None };
    let mut l: List<u8, 4> = List::new();
    l.push(a[0]);
    l.push(a[1]);
    let (j, mut other, mut sum) = (i % 2, n ^ 1, 0_u8);
    let mut r = core::mem::replace(v.iter_mut().max().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ r;
    core::mem::swap(v.iter_mut().max().unwrap(), &mut other);
    core::mem::swap(&mut other, v.iter_mut().max().unwrap());
    sum = sum.wrapping_mul(3)
        ^ core::mem::replace(v.iter_mut().max().unwrap(), n.wrapping_add(2)).wrapping_add(other);
    let named = v.iter_mut().max().unwrap();
    r = core::mem::replace(named, n ^ 4);
    core::mem::swap(named, &mut r);
    sum = sum.wrapping_mul(3) ^ r;
    let mut put = |n: u8| core::mem::replace(v.iter_mut().max().unwrap(), n);
    sum = sum.wrapping_mul(3) ^ put(n.wrapping_add(7));
    sum ^= a[usize::from(core::mem::replace(v.iter_mut().max().unwrap(), n ^ 3)) % 3];
    sum = sum.wrapping_mul(3) ^ set(v.iter_mut().max().unwrap(), n ^ 9);
    *v.iter_mut().max().unwrap() ^= sum;
    *v.iter_mut().max().unwrap() = sum.wrapping_add(r);
    core::mem::replace(v.iter_mut().max().unwrap(), sum);
    ([x, v[0], v[1], v[2], other], s, o, [l[0], l[1]], sum)
}
