//! Elements that are moved by all, none or too many places, in slices, lists and structs.

use bessemer::prelude::*;

/// Reason why a frame is rejected.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trouble {
    /// Its length is wrong.
    Length,
    /// Its content is wrong.
    Content,
}

/// Elements of an author's type.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Own {
    /// A number.
    pub number: u8,
    /// Another.
    pub other: f64,
}

#[data]
impl Own {
    /// An author's method with the name of one of slices'.
    pub fn rotate_left(&mut self, by: u8) -> u8 {
        self.number = by;
        by
    }

    /// An author's method with the name of one of slices'.
    pub fn copy_within(&mut self, from: u8, to: u8) {
        self.number = from ^ to;
    }

    /// An author's method with the name of one of slices'.
    pub fn starts_with(&self, number: u8) -> bool {
        self.number == number
    }

    /// An author's method with the name of a conversion.
    pub fn try_into(self) -> Result<u16, Trouble> {
        if self.number > 3 { Ok(u16::from(self.number)) } else { Err(Trouble::Content) }
    }

    /// An author's method with the name of one of slices'.
    pub fn first_chunk(&self) -> Option<u8> {
        Some(self.number)
    }
}

/// Calls of the author's methods are not taken for those of slices.
#[function]
pub fn own(own: &mut Own, by: u8) -> Result<u16, Trouble> {
    let a = own.rotate_left(by);
    own.copy_within(a, 3);
    let b = own.starts_with(by);
    let c = own.first_chunk().unwrap_or(1);
    let d = (*own).try_into()?;
    Ok(d + u16::from(c) + u16::from(b))
}

/// Rotates in both directions by any number.
#[function]
pub fn round(a: &mut [u8; 5], b: &mut [Own; 3], by: usize) {
    a.rotate_left(by);
    b.rotate_right(by);
    a[1..4].rotate_right(1);
}

/// Rotates a list, and a part of it.
#[function]
pub fn listed(list: &mut List<i16, 6>, by: usize) {
    list.rotate_left(by);
    if list.len() > 3 {
        list[1..].rotate_right(by);
    }
}

/// Copies between overlapping ranges.
#[function]
pub fn over(a: &mut [i32; 6], from: usize, to: usize, place: usize) {
    a.copy_within(from..to, place);
}

/// Copies ranges with and without ends.
#[function]
pub fn over_ends(a: &mut [i32; 6], list: &mut List<u8, 5>, from: usize, to: usize) {
    a.copy_within(from..=to, 1);
    a.copy_within(..to, 2);
    list.copy_within(from.., 0);
    list.copy_within(.., 0);
    list.copy_within(0..=usize::MAX, 0);
}

/// Arguments are evaluated once, in order.
#[function]
pub fn effects(a: &mut [i32; 6], own: &mut Own) {
    a.copy_within(
        usize::from(own.rotate_left(1))..usize::from(own.rotate_left(own.number + 2)),
        usize::from(own.number),
    );
    a.rotate_left(usize::from(own.rotate_left(own.number - 1)));
}

/// `starts_with` and `ends_with` for empty, equal and longer slices; a NaN equals no NaN.
#[function]
pub fn ends(a: &[f64; 3], list: &List<f64, 4>, n: usize) -> [bool; 6] {
    [
        a.starts_with(&a[..n]),
        a.ends_with(&a[n..]),
        list.starts_with(a),
        a.ends_with(list),
        list.ends_with(&a[..0]),
        a[1..].starts_with(&[1.0, 2.0]),
    ]
}

/// Case conversions of bytes.
#[function]
pub fn letters(text: &List<u8, 6>) -> u8 {
    if text.starts_with(b"AT+") {
        return 1;
    }
    if text.ends_with(b"\n") { 2 } else { 0 }
}

/// Conversion of a slice to an array; the error becomes the author's.
#[function]
pub fn whole(list: &List<u8, 6>, from: usize) -> Result<u32, Trouble> {
    let bytes: [u8; 4] = list[from..].try_into().map_err(|_| Trouble::Length)?;
    if bytes[0] == 9 {
        return Err(Trouble::Content);
    }
    Ok(u32::from_le_bytes(bytes))
}

/// A fault if the conversion to an array fails; the array is a copy.
#[function]
pub fn unwrapped(a: &mut [i32; 6], from: usize, to: usize) -> i32 {
    let part: [i32; 2] = a[from..to].try_into().unwrap();
    a[0] = 100;
    a[1] = 200;
    let same: [i32; 6] = a[..].try_into().expect("all of them must be there");
    part[0].wrapping_sub(part[1]).wrapping_add(same[5])
}

/// Tests of elements that hold, and that do not.
#[function]
pub fn tested(list: &List<Own, 4>, a: &[u16; 3]) -> f64 {
    let mut sum = 0.0;
    if let Some(pair) = list.first_chunk::<2>() {
        sum += pair[0].other - pair[1].other;
    }
    let two: Result<[u16; 2], _> = a[1..].try_into();
    if let Ok(two) = two {
        sum += f64::from(two[0]);
    }
    match a[..2].first_chunk::<3>() {
        Some(_) => sum + 1000.0,
        None => sum,
    }
}
