//! Witness slots: phantom places through which rustc tells the types that it inferred.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::marker::PhantomData;

use bessemer_ir::tree::{self, Ty};
use bessemer_ir::{Float, Int, Scalar};
use nalgebra::SMatrix;

use super::builder::{Builder, Callee, words};
use crate::{EntriesInOneBlock, EntriesOfSomeInstances, List, Plain};

/// A place for a type, `[]` where it is made.
///
/// An array, since of the elements of `[]` rustc asks almost nothing before it knows them. It goes through all that it
/// has asked and not yet answered each time that it looks for a method, and there are as many slots as a function has values.
pub type Slot<T> = [T; 0];

/// What a companion returns: the type of the result, and the marker of the function.
pub struct Called<M, R>(PhantomData<fn() -> (M, R)>);

/// A type of the DSL.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a type of the DSL",
    label = "not a type of the DSL",
    note = "the DSL has scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`"
)]
pub trait DslType {
    /// The type, and what it is made of, told to the package.
    fn ty(cx: &mut Builder) -> Ty;
}

#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a type of the DSL",
    label = "not a type of the DSL",
    note = "the DSL has scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`"
)]
/// A type without the lifetime of its reference, so that a slot outside a closure can hold it.
pub trait Seen {
    /// The type that the slot holds.
    type Slot;
}

/// What stands for a parameter of something generic: a value of the DSL.
pub trait Value: DslType + Seen<Slot = Self> + Plain + Sized + 'static {}

impl<T: DslType + Seen<Slot = T> + Plain + 'static> Value for T {}

/// An instance with a name of its own, asked for its entry points.
pub struct Instance<T>(PhantomData<fn() -> T>);

impl<T> Instance<T> {
    /// The instance `T`.
    #[allow(clippy::new_without_default)]
    pub fn new() -> Instance<T> {
        Instance(PhantomData)
    }
}

impl<T: EntriesInOneBlock> Instance<T> {
    /// Builds them.
    pub fn build_entries(&self, cx: &mut Builder) {
        T::build(cx);
    }
}

impl<T: EntriesOfSomeInstances> Instance<T> {
    /// Builds those that not every instance has.
    pub fn build_further_entries(&self, cx: &mut Builder) {
        T::build(cx);
    }
}

/// An instance that has none: the inherent method wins where it is there.
pub trait WithoutEntries {
    /// Builds nothing.
    fn build_entries(&self, _: &mut Builder) {}
    /// Builds nothing.
    fn build_further_entries(&self, _: &mut Builder) {}
}

impl<T> WithoutEntries for Instance<T> {}

/// Stands for `&T` in a slot.
pub struct Shared<T: ?Sized>(PhantomData<T>);

/// Stands for `&mut T` in a slot.
pub struct Exclusive<T: ?Sized>(PhantomData<T>);

/// What passes values through a slot in the form of a method, so that the expression stays a method call.
pub trait Through {
    /// The type in the slot.
    type Of;

    /// As [`__glance`].
    fn __glance<U: Seen<Slot = Self::Of>>(&self, value: U) -> U {
        value
    }

    /// As [`__take`].
    fn __take<R>(&self, _: Called<Self::Of, R>) -> R {
        unreachable!("a witness copy is never run")
    }
}

/// Where a witness copy ends, were it run.
pub fn __unreached() -> ! {
    unreachable!("a witness copy is never run")
}

impl<T> Through for Slot<T> {
    type Of = T;
}

/// Ends a part of a witness copy: the slot learns the types of the names that the next part uses.
pub fn __pass<T, R>(_: &Slot<T>, _: T) -> R {
    unreachable!("a witness copy is never run")
}

/// The next part of a witness copy, of names of the types in the slot.
pub fn __next<T, R>(_: &Slot<T>, _: impl FnOnce(T) -> R) {}

/// Passes a value through, and its type into the slot.
pub fn __see<T>(_: &Slot<T>, value: T) -> T {
    value
}

/// Passes a value with references in it through.
pub fn __glance<T: Seen>(_: &Slot<T::Slot>, value: T) -> T {
    value
}

/// Tells a slot the type of a place.
pub fn __look<T: Seen>(_: &Slot<T::Slot>, _: &T) {}

/// Stands for a value that is assigned later.
pub fn __any<T>(_: &Slot<T>) -> T {
    unreachable!("a witness copy is never run")
}

/// Tells a slot a type that the author wrote.
pub fn __result<T>(_: &Slot<T>) {}

/// The result of a call; the slot learns which function it was.
pub fn __take<M, R>(_: &Slot<M>, _: Called<M, R>) -> R {
    unreachable!("a witness copy is never run")
}

/// A slot that holds a type of the DSL. Builders ask their slots by reference: rustc compiles a table of addresses faster than
/// a call for each.
pub trait TypeSlot {
    /// The type that rustc put here.
    fn ty(&self, cx: &mut Builder) -> Ty;
}

impl<T: DslType> TypeSlot for Slot<T> {
    fn ty(&self, cx: &mut Builder) -> Ty {
        T::ty(cx)
    }
}

/// A slot that holds a function.
pub trait CalleeSlot {
    /// The function that rustc put here.
    fn callee(&self, cx: &mut Builder) -> tree::Callee;
}

impl<T: Callee> CalleeSlot for Slot<T> {
    fn callee(&self, cx: &mut Builder) -> tree::Callee {
        T::callee(cx)
    }
}

/// The types in slots.
pub fn types(cx: &mut Builder, slots: &[&dyn TypeSlot]) -> Vec<Ty> {
    slots.iter().map(|slot| slot.ty(cx)).collect()
}

/// The functions in slots.
pub fn callees(cx: &mut Builder, slots: &[&dyn CalleeSlot]) -> Vec<tree::Callee> {
    slots.iter().map(|slot| slot.callee(cx)).collect()
}

/// The value of a path that rustc evaluated: a constant, or a variant without payload.
pub fn constant<T: DslType + Plain>(cx: &mut Builder, _: &Slot<T>, value: T) -> tree::Constant {
    tree::Constant { ty: T::ty(cx), words: words(&value) }
}

/// An array as a list.
pub fn list<T, const N: usize>(items: [T; N]) -> Vec<T> {
    Vec::from(items)
}

macro_rules! scalars {
    ($($ty:ty => $scalar:expr;)*) => {$(
        impl DslType for $ty {
            fn ty(_: &mut Builder) -> Ty {
                Ty::Scalar($scalar)
            }
        }
        impl Seen for $ty {
            type Slot = $ty;
        }
        impl ScalarType for $ty {
            const SCALAR: Scalar = $scalar;
        }
    )*};
}

/// A scalar of the DSL.
pub trait ScalarType {
    /// Which one.
    const SCALAR: Scalar;
}

scalars! {
    bool => Scalar::Bool;
    f32 => Scalar::Float(Float::F32);
    f64 => Scalar::Float(Float::F64);
    i8 => Scalar::Int(Int::I8);
    i16 => Scalar::Int(Int::I16);
    i32 => Scalar::Int(Int::I32);
    i64 => Scalar::Int(Int::I64);
    isize => Scalar::Int(Int::Isize);
    u8 => Scalar::Int(Int::U8);
    u16 => Scalar::Int(Int::U16);
    u32 => Scalar::Int(Int::U32);
    u64 => Scalar::Int(Int::U64);
    usize => Scalar::Int(Int::Usize);
}

/// A character is its code point.
impl DslType for char {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Scalar(Scalar::Int(Int::U32))
    }
}

impl Seen for char {
    type Slot = char;
}

impl DslType for () {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Unit
    }
}

impl Seen for () {
    type Slot = ();
}

/// Tells types apart, and holds nothing.
impl<T: ?Sized> DslType for PhantomData<T> {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Unit
    }
}

impl<T: ?Sized> Seen for PhantomData<T> {
    type Slot = PhantomData<T>;
}

impl<T: DslType, const N: usize> DslType for [T; N] {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Array(Box::new(T::ty(cx)), N as u32)
    }
}

impl<T, const N: usize> Seen for [T; N] {
    type Slot = [T; N];
}

impl<T: ScalarType, const R: usize, const C: usize> DslType for SMatrix<T, R, C> {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Matrix(T::SCALAR, R as u32, C as u32)
    }
}

impl<T, const R: usize, const C: usize> Seen for SMatrix<T, R, C> {
    type Slot = SMatrix<T, R, C>;
}

impl<T: DslType> DslType for [T] {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Slice(Box::new(T::ty(cx)))
    }
}

impl<T: DslType + ?Sized> DslType for &T {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Ref(Box::new(T::ty(cx)), false)
    }
}

impl<T: DslType + ?Sized> DslType for &mut T {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Ref(Box::new(T::ty(cx)), true)
    }
}

impl<T: ?Sized> Seen for &T {
    type Slot = Shared<T>;
}

impl<T: ?Sized> Seen for &mut T {
    type Slot = Exclusive<T>;
}

impl<T: DslType + ?Sized> DslType for Shared<T> {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Ref(Box::new(T::ty(cx)), false)
    }
}

impl<T: DslType + ?Sized> DslType for Exclusive<T> {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Ref(Box::new(T::ty(cx)), true)
    }
}

macro_rules! tuples {
    ($($($ty:ident),*;)*) => {$(
        impl<$($ty: DslType),*> DslType for ($($ty,)*) {
            fn ty(cx: &mut Builder) -> Ty {
                Ty::Tuple(list([$($ty::ty(cx)),*]))
            }
        }
        impl<$($ty: Seen),*> Seen for ($($ty,)*) {
            type Slot = ($($ty::Slot,)*);
        }
    )*};
}

tuples! {
    A;
    A, B;
    A, B, C;
    A, B, C, D;
    A, B, C, D, E;
    A, B, C, D, E, F;
    A, B, C, D, E, F, G;
    A, B, C, D, E, F, G, H;
}

impl<T: DslType> DslType for Option<T> {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Option(Box::new(T::ty(cx)))
    }
}

impl<T: Seen> Seen for Option<T> {
    type Slot = Option<T::Slot>;
}

impl<T: DslType, E: DslType> DslType for Result<T, E> {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Result(Box::new(T::ty(cx)), Box::new(E::ty(cx)))
    }
}

impl<T: Seen, E: Seen> Seen for Result<T, E> {
    type Slot = Result<T::Slot, E::Slot>;
}

impl<T: DslType, const N: usize> DslType for List<T, N> {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::List(Box::new(T::ty(cx)), N as u32)
    }
}

impl<T, const N: usize> Seen for List<T, N> {
    type Slot = List<T, N>;
}

/// The function behind a companion.
pub(super) trait Companion {
    /// Builds it, and names it.
    fn callee(self, cx: &mut Builder) -> tree::Callee;
}

macro_rules! companions_of {
    ($($($argument:ident),*;)*) => {$(
        impl<M: Callee, R, $($argument),*> Companion for fn($($argument),*) -> Called<M, R> {
            fn callee(self, cx: &mut Builder) -> tree::Callee {
                M::callee(cx)
            }
        }
    )*};
}

companions_of! { ; A; A, B; A, B, C; A, B, C, D; }
