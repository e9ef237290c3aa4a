//! Values as sequences of 64-bit words: the form in which data is passed to and from a model.

use core::cmp::Ordering;

use nalgebra::{SMatrix, Scalar};

use crate::name;

/// A value made of scalars only: what a model's state, inputs and outputs are.
///
/// Its *words* are its scalars in order (fields as declared, elements in order, matrices by columns),
/// each in 64 bits: a float is its bits, an integer is sign- or zero-extended, `bool` is 0 or 1, an
/// enum the index of its variant. What is not there (the value of a `None`, the payloads of the variants
/// that an enum is not) has its words too: zeros. `#[data]` and `#[component]` implement it.
///
/// ```
/// use bessemer::Plain;
/// let mut words = Vec::new();
/// [1.5_f64, -0.0].store(&mut |word| words.push(word));
/// assert_eq!(words, [1.5_f64.to_bits(), 1 << 63]);
/// let mut next = words.into_iter();
/// assert_eq!(<[f64; 2]>::load(&mut || next.next().unwrap_or(0)), [1.5, -0.0]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a type that a model can hold",
    label = "not plain data",
    note = "plain data are scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`"
)]
pub trait Plain: Sized {
    /// Number of words of a value.
    const WORDS: usize;

    /// Passes the words of the value to `out`, in order.
    fn store(&self, out: &mut dyn FnMut(u64));

    /// Builds a value from the words that `next` returns. A word out of range is cut to the type; an invalid variant
    /// index becomes the first variant.
    fn load(next: &mut dyn FnMut() -> u64) -> Self;
}

macro_rules! integers {
    ($($ty:ty),*) => {$(
        #[diagnostic::do_not_recommend]
        impl Plain for $ty {
            const WORDS: usize = 1;
            fn store(&self, out: &mut dyn FnMut(u64)) {
                out(*self as u64);
            }
            fn load(next: &mut dyn FnMut() -> u64) -> Self {
                next() as $ty
            }
        }
    )*};
}

integers!(i8, i16, i32, i64, isize, u8, u16, u32, u64, usize);

#[diagnostic::do_not_recommend]
impl Plain for Ordering {
    const WORDS: usize = 1;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(match self {
            Ordering::Less => 0,
            Ordering::Equal => 1,
            Ordering::Greater => 2,
        });
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        match next() {
            1 => Ordering::Equal,
            2 => Ordering::Greater,
            _ => Ordering::Less,
        }
    }
}

/// The word is the CRC-32 of the text. A name that is read from a word has another text of this word.
#[diagnostic::do_not_recommend]
impl Plain for &'static str {
    const WORDS: usize = 1;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(u64::from(name::stored(self)));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        name::name(next() as u32)
    }
}

/// The word is the code point; a number that is none becomes U+FFFD.
#[diagnostic::do_not_recommend]
impl Plain for char {
    const WORDS: usize = 1;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(u64::from(u32::from(*self)));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        char::from_u32(next() as u32).unwrap_or(char::REPLACEMENT_CHARACTER)
    }
}

#[diagnostic::do_not_recommend]
impl Plain for bool {
    const WORDS: usize = 1;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(u64::from(*self));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        next() != 0
    }
}

#[diagnostic::do_not_recommend]
impl Plain for f32 {
    const WORDS: usize = 1;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(u64::from(self.to_bits()));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        f32::from_bits(next() as u32)
    }
}

#[diagnostic::do_not_recommend]
impl Plain for f64 {
    const WORDS: usize = 1;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(self.to_bits());
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        f64::from_bits(next())
    }
}

#[diagnostic::do_not_recommend]
impl<T: Plain, const N: usize> Plain for [T; N] {
    const WORDS: usize = N * T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        for element in self {
            element.store(out);
        }
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        core::array::from_fn(|_| T::load(next))
    }
}

#[diagnostic::do_not_recommend]
impl<T: Plain + Scalar, const R: usize, const C: usize> Plain for SMatrix<T, R, C> {
    const WORDS: usize = R * C * T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        // nalgebra iterates by columns.
        for element in self.iter() {
            element.store(out);
        }
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        SMatrix::from_fn_generic(nalgebra::Const, nalgebra::Const, |_, _| T::load(next))
    }
}

#[diagnostic::do_not_recommend]
impl Plain for () {
    const WORDS: usize = 0;
    fn store(&self, _: &mut dyn FnMut(u64)) {}
    fn load(_: &mut dyn FnMut() -> u64) -> Self {}
}

/// A marker type without content has no words.
#[diagnostic::do_not_recommend]
impl<T: ?Sized> Plain for core::marker::PhantomData<T> {
    const WORDS: usize = 0;
    fn store(&self, _: &mut dyn FnMut(u64)) {}
    fn load(_: &mut dyn FnMut() -> u64) -> Self {
        core::marker::PhantomData
    }
}

/// The error carries no data, so it has no words.
#[diagnostic::do_not_recommend]
impl Plain for core::array::TryFromSliceError {
    const WORDS: usize = 0;
    fn store(&self, _: &mut dyn FnMut(u64)) {}
    fn load(_: &mut dyn FnMut() -> u64) -> Self {
        match <[u8; 1]>::try_from(&[][..]) {
            Err(error) => error,
            Ok(_) => unreachable!("nothing is no array of one"),
        }
    }
}

/// The error carries no data, so it has no words.
#[diagnostic::do_not_recommend]
impl Plain for core::num::TryFromIntError {
    const WORDS: usize = 0;
    fn store(&self, _: &mut dyn FnMut(u64)) {}
    fn load(_: &mut dyn FnMut() -> u64) -> Self {
        match u8::try_from(-1_i8) {
            Err(error) => error,
            Ok(_) => unreachable!("-1 is no `u8`"),
        }
    }
}

macro_rules! tuples {
    ($($($ty:ident $index:tt),*;)*) => {$(
        #[diagnostic::do_not_recommend]
        impl<$($ty: Plain),*> Plain for ($($ty,)*) {
            const WORDS: usize = 0 $(+ $ty::WORDS)*;
            fn store(&self, out: &mut dyn FnMut(u64)) {
                $(self.$index.store(out);)*
            }
            fn load(next: &mut dyn FnMut() -> u64) -> Self {
                ($($ty::load(next),)*)
            }
        }
    )*};
}

tuples! {
    A 0;
    A 0, B 1;
    A 0, B 1, C 2;
    A 0, B 1, C 2, D 3;
    A 0, B 1, C 2, D 3, E 4;
    A 0, B 1, C 2, D 3, E 4, F 5;
    A 0, B 1, C 2, D 3, E 4, F 5, G 6;
    A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7;
}

/// Passes the words of a value that may be missing; a missing one has zeros.
fn store_if<T: Plain>(value: Option<&T>, out: &mut dyn FnMut(u64)) {
    match value {
        Some(value) => value.store(out),
        None => (0..T::WORDS).for_each(|_| out(0)),
    }
}

/// The words are 1 or 0 for whether there is a value, and then the value's.
#[diagnostic::do_not_recommend]
impl<T: Plain> Plain for Option<T> {
    const WORDS: usize = 1 + T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.is_some().store(out);
        store_if(self.as_ref(), out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let (there, value) = (bool::load(next), T::load(next));
        there.then_some(value)
    }
}

/// The words are 1 or 0 for whether it is `Ok`, then the value's, then the error's.
#[diagnostic::do_not_recommend]
impl<T: Plain, E: Plain> Plain for Result<T, E> {
    const WORDS: usize = 1 + T::WORDS + E::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.is_ok().store(out);
        store_if(self.as_ref().ok(), out);
        store_if(self.as_ref().err(), out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let (fine, value, error) = (bool::load(next), T::load(next), E::load(next));
        if fine { Ok(value) } else { Err(error) }
    }
}
