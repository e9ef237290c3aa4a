//! Values as words: how data crosses every border of a model.

use nalgebra::{SMatrix, Scalar};

/// A value made of scalars only: what a model's state, inputs and outputs are.
///
/// Its *words* are its scalars in order (fields as declared, elements in order, matrices by columns),
/// each in 64 bits: a float is its bits, an integer is sign- or zero-extended, `bool` is 0 or 1, an
/// enum the index of its variant. `#[data]` and `#[component]` implement it.
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
    /// Gives the words of the value to `out`.
    fn store(&self, out: &mut dyn FnMut(u64));

    /// The value whose words `next` gives. A word out of range is cut to the type; an enum's becomes
    /// the first variant.
    fn load(next: &mut dyn FnMut() -> u64) -> Self;
}

macro_rules! integers {
    ($($ty:ty),*) => {$(
        #[diagnostic::do_not_recommend]
        impl Plain for $ty {
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
impl Plain for bool {
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(u64::from(*self));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        next() != 0
    }
}

#[diagnostic::do_not_recommend]
impl Plain for f32 {
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(u64::from(self.to_bits()));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        f32::from_bits(next() as u32)
    }
}

#[diagnostic::do_not_recommend]
impl Plain for f64 {
    fn store(&self, out: &mut dyn FnMut(u64)) {
        out(self.to_bits());
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        f64::from_bits(next())
    }
}

#[diagnostic::do_not_recommend]
impl<T: Plain, const N: usize> Plain for [T; N] {
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
