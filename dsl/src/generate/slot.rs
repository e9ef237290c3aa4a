//! Witness slots: phantom places through which rustc tells the types that it inferred.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::Ty;
use bessemer_tree::number::{Float, Int, Scalar};
use nalgebra::SMatrix;

use super::builder::{Builder, Callee, Witness, words};
use crate::{EntriesInOneBlock, EntriesOfSomeInstances, List, Plain};

/// A place for a type, `[]` where it is made.
///
/// An array, since of the elements of `[]` rustc asks almost nothing before it knows them. It goes through all that it
/// has asked and not yet answered each time that it looks for a method, and there are as many slots as a function has values.
pub type Slot<T> = [T; 0];

/// Is of the types `T`, and holds none of them.
pub(super) type Of<T> = PhantomData<fn() -> T>;

/// Result of a companion: the type of the result, and the marker of the function.
pub struct Called<M, R>(Of<(M, R)>);

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

/// Type argument of a generic item: a value of the DSL.
pub trait Value: DslType + Seen<Slot = Self> + Plain + Sized + 'static {}

impl<T: DslType + Seen<Slot = T> + Plain + 'static> Value for T {}

/// An instance with a name of its own, queried for its entry points.
pub struct Instance<T>(Of<T>);

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

/// Passes values through a slot as a method, so that the expression remains a method call.
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

/// End of a witness copy, never executed.
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

/// A slot that tells an `R`. Builders ask their slots by reference: rustc compiles a table of addresses faster than a call for
/// each.
pub trait Tells<R> {
    /// Returns the type that rustc inferred.
    fn told(&self, cx: &mut Builder) -> R;
}

impl<T: DslType> Tells<Ty> for Slot<T> {
    fn told(&self, cx: &mut Builder) -> Ty {
        T::ty(cx)
    }
}

impl<T: Callee> Tells<tree::Callee> for Slot<T> {
    fn told(&self, cx: &mut Builder) -> tree::Callee {
        T::callee(cx)
    }
}

impl Witness {
    /// Learns what slots tell: types, functions, and for operators those of authors.
    pub fn learn(
        &mut self,
        cx: &mut Builder,
        types: &[&dyn Tells<Ty>],
        callees: &[&dyn Tells<tree::Callee>],
        operators: &[&dyn Tells<Option<tree::Callee>>],
    ) {
        self.slots.extend(types.iter().map(|slot| slot.told(cx)));
        self.callees.extend(callees.iter().map(|slot| slot.told(cx)));
        self.operators.extend(operators.iter().map(|slot| slot.told(cx)));
    }
}

/// Types that rustc evaluates: plain data, or a reference to an array or a slice of such, whose array is in the tree.
#[diagnostic::on_unimplemented(
    message = "a constant of the type `{Self}` is not part of the DSL",
    label = "not a constant of the DSL",
    note = "write a constant of plain data, of an array, or of a slice of these: `&[(u8, f64)]`"
)]
pub trait Evaluated {
    /// The value in words, with its type: of a reference, that of one to the array.
    fn evaluated(&self, cx: &mut Builder) -> tree::Constant;
}

impl<T: DslType + Plain> Evaluated for T {
    fn evaluated(&self, cx: &mut Builder) -> tree::Constant {
        tree::Constant { ty: T::ty(cx), words: words(self) }
    }
}

impl<T: DslType + Plain> Evaluated for &[T] {
    fn evaluated(&self, cx: &mut Builder) -> tree::Constant {
        let array = Ty::Array(Box::new(T::ty(cx)), self.len() as u32);
        let words = self.iter().flat_map(words).collect();
        tree::Constant { ty: Ty::Ref(Box::new(array), false), words }
    }
}

impl<T: DslType + Plain, const N: usize> Evaluated for &[T; N] {
    fn evaluated(&self, cx: &mut Builder) -> tree::Constant {
        self.as_slice().evaluated(cx)
    }
}

/// The value of a path that rustc evaluated: a constant, or a variant without payload.
pub fn constant<T: Evaluated>(cx: &mut Builder, _: &Slot<T>, value: T) -> tree::Constant {
    value.evaluated(cx)
}

/// An array as a list.
pub fn list<T, const N: usize>(items: [T; N]) -> Vec<T> {
    Vec::from(items)
}

/// Types of the DSL: of each what it is in the tree, and what is in a slot in its place.
///
/// The first parameters are those of the one, the second those of the other.
macro_rules! dsl_types {
    ($(
        [$($of:tt)*] [$($seen:tt)*] $ty:ty as $slot:ty $(where $place:ty: $bound:path)?
            => |$cx:pat_param| $told:expr;
    )*) => {$(
        impl<$($of)*> DslType for $ty $(where $place: $bound)? {
            fn ty($cx: &mut Builder) -> Ty {
                $told
            }
        }
        impl<$($seen)*> Seen for $ty $(where $place: $bound)? {
            type Slot = $slot;
        }
    )*};
}
pub(super) use dsl_types;

/// Types of std and nalgebra, for each of which a type of the DSL stands.
macro_rules! stands {
    ($([$($parameters:tt)*] $native:ty $(where $place:ty: $bound:path)? => $data:ty;)*) => {
        $crate::generate::slot::dsl_types! {$(
            [$($parameters)*] [$($parameters)*] $native as Self $(where $place: $bound)? => |cx| <$data>::ty(cx);
        )*}
    };
}
pub(super) use stands;

/// Types of which no value is ever made.
macro_rules! never_held {
    ($([$($parameters:tt)*] $ty:ty;)*) => {$(
        impl<$($parameters)*> $crate::Plain for $ty {
            const WORDS: usize = 0;
            fn store(&self, _: &mut dyn FnMut(u64)) {}
            fn load(_: &mut dyn FnMut() -> u64) -> Self {
                unreachable!("a witness copy is never run")
            }
        }
    )*};
}
pub(super) use never_held;

/// A scalar of the DSL.
pub trait ScalarType {
    /// The scalar.
    const SCALAR: Scalar;
}

macro_rules! scalars {
    ($($ty:ident => $scalar:expr;)*) => {
        dsl_types! { $([] [] $ty as $ty => |_| Ty::Scalar($scalar);)* }
        $(impl ScalarType for $ty {
            const SCALAR: Scalar = $scalar;
        })*
    };
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

// A character is its code point, and a type of its own for traits and what is generic. `PhantomData` tells types apart, and holds nothing.
dsl_types! {
    [] [] char as Self => |_| Ty::Known("char".into(), Box::new(Ty::Scalar(Scalar::Int(Int::U32))));
    [] [] () as Self => |_| Ty::Unit;
    [T: ?Sized] [T: ?Sized] PhantomData<T> as Self => |_| Ty::Unit;
    [T: DslType, const N: usize] [T, const N: usize] [T; N] as Self
        => |cx| Ty::Array(Box::new(T::ty(cx)), N as u32);
    [T: DslType, const N: usize] [T, const N: usize] List<T, N> as Self
        => |cx| Ty::List(Box::new(T::ty(cx)), N as u32);
    [T: ScalarType, const R: usize, const C: usize] [T, const R: usize, const C: usize]
        SMatrix<T, R, C> as Self => |_| Ty::Matrix(T::SCALAR, R as u32, C as u32);
    [T: DslType + ?Sized] [T: ?Sized] &T as Shared<T> => |cx| Ty::Ref(Box::new(T::ty(cx)), false);
    [T: DslType + ?Sized] [T: ?Sized] &mut T as Exclusive<T> => |cx| Ty::Ref(Box::new(T::ty(cx)), true);
    [T: DslType + ?Sized] [T: ?Sized] Shared<T> as Self => |cx| Ty::Ref(Box::new(T::ty(cx)), false);
    [T: DslType + ?Sized] [T: ?Sized] Exclusive<T> as Self => |cx| Ty::Ref(Box::new(T::ty(cx)), true);
    [T: DslType] [T: Seen] Option<T> as Option<T::Slot> => |cx| Ty::Option(Box::new(T::ty(cx)));
    [T: DslType, E: DslType] [T: Seen, E: Seen] Result<T, E> as Result<T::Slot, E::Slot>
        => |cx| Ty::Result(Box::new(T::ty(cx)), Box::new(E::ty(cx)));
}

never_held! {
    [T: ?Sized] Shared<T>;
    [T: ?Sized] Exclusive<T>;
}

impl<T: DslType> DslType for [T] {
    fn ty(cx: &mut Builder) -> Ty {
        Ty::Slice(Box::new(T::ty(cx)))
    }
}

macro_rules! tuples {
    ($($($ty:ident),*;)*) => { dsl_types! {$(
        [$($ty: DslType),*] [$($ty: Seen),*] ($($ty,)*) as ($($ty::Slot,)*)
            => |cx| Ty::Tuple(list([$($ty::ty(cx)),*]));
    )*} };
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
