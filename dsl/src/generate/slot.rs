//! Witness slots: phantom values by which rustc reports the types that it inferred.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::Ty;
use bessemer_tree::number::{Float, Int, Scalar};
use nalgebra::SMatrix;

use super::builder::{Builder, Callee, Witness, words};
use crate::{List, Plain};

/// A slot for a type, created as `[]`.
///
/// It is an array, since rustc requires almost nothing of the elements of `[]` before it knows their type. rustc
/// revisits all pending obligations each time it looks up a method, and a function has as many slots as values.
pub type Slot<T> = [T; 0];

/// Phantom of the types `T`, without a value of them.
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
    /// Returns the type, and adds its parts to the package.
    fn ty(cx: &mut Builder) -> Ty;
}

#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a type of the DSL",
    label = "not a type of the DSL",
    note = "the DSL has scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`"
)]
/// A type without the lifetime of its reference, so a slot outside a closure can hold it.
pub trait Seen {
    /// The type that the slot holds.
    type Slot;
}

/// Type argument of a generic item: a value of the DSL.
pub trait Value: DslType + Seen<Slot = Self> + Plain + Sized + 'static {}

impl<T: DslType + Seen<Slot = T> + Plain + 'static> Value for T {}

/// A block of a generic type whose methods are in the C for a named instance: `#[component] pub type PidF32 = Pid<f32>;`.
///
/// Only the attribute of the `impl` block implements it: for the entry points of a generic component, and the public methods
/// of generic data. `BLOCK` numbers the blocks of a type, which may apply to different instances: `impl Pid<f32>` beside
/// `impl<T> Pid<T>`.
pub trait EntriesOfBlock<const BLOCK: usize> {
    /// Builds them.
    fn build(cx: &mut Builder);
}

/// Query for the entry points that a block has for a named instance.
pub struct Instance<T, const BLOCK: usize>(Of<T>);

impl<T, const BLOCK: usize> Instance<T, BLOCK> {
    /// Returns the query for the instance `T`.
    #[allow(clippy::new_without_default)]
    pub fn new() -> Instance<T, BLOCK> {
        Instance(PhantomData)
    }
}

impl<T: EntriesOfBlock<BLOCK>, const BLOCK: usize> Instance<T, BLOCK> {
    /// Builds the entry points.
    pub fn build_entries(&self, cx: &mut Builder) {
        T::build(cx);
    }
}

/// Answer where there is no such block, or none for this instance; an inherent method has priority.
pub trait WithoutEntries {
    /// Builds nothing.
    fn build_entries(&self, _: &mut Builder) {}
}

impl<T, const BLOCK: usize> WithoutEntries for Instance<T, BLOCK> {}

/// Represents `&T` in a slot.
pub struct Shared<T: ?Sized>(PhantomData<T>);

/// Represents `&mut T` in a slot.
pub struct Exclusive<T: ?Sized>(PhantomData<T>);

/// Passes values through a slot as a method, so that the expression remains a method call.
pub trait Through {
    /// The type in the slot.
    type Of;

    /// Works like [`__glance`].
    fn __glance<U: Seen<Slot = Self::Of>>(&self, value: U) -> U {
        value
    }

    /// Works like [`__take`].
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

/// Ends a part of a witness copy: the slot records the types of the names that the next part uses.
pub fn __pass<T, R>(_: &Slot<T>, _: T) -> R {
    unreachable!("a witness copy is never run")
}

/// Begins the next part of a witness copy; its arguments have the types in the slot.
pub fn __next<T, R>(_: &Slot<T>, _: impl FnOnce(T) -> R) {}

/// Passes a value through, and records its type in the slot.
pub fn __see<T>(_: &Slot<T>, value: T) -> T {
    value
}

/// Passes a value that may contain references through, and records its type without their lifetimes.
pub fn __glance<T: Seen>(_: &Slot<T::Slot>, value: T) -> T {
    value
}

/// Records the type of a place in a slot.
pub fn __look<T: Seen>(_: &Slot<T::Slot>, _: &T) {}

/// Returns a value of the slot's type, for a variable that is assigned later.
pub fn __any<T>(_: &Slot<T>) -> T {
    unreachable!("a witness copy is never run")
}

/// Records a type that the author wrote.
pub fn __result<T>(_: &Slot<T>) {}

/// Returns the result of a call, and records its function in a slot.
pub fn __take<M, R>(_: &Slot<M>, _: Called<M, R>) -> R {
    unreachable!("a witness copy is never run")
}

/// A slot that reports an `R`. Builders have a table of references to slots, which rustc compiles faster than a call
/// for each.
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
    /// Collects the reports of slots: types, functions, and authors' operators.
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

/// A type of constants: plain data, or a reference to an array or a slice of it, whose array is in the tree.
#[diagnostic::on_unimplemented(
    message = "a constant of the type `{Self}` is not part of the DSL",
    label = "not a constant of the DSL",
    note = "mark each type in it `#[data]`; a constant is plain data, an array, or a slice of these: `&[(u8, f64)]`"
)]
pub trait Evaluated {
    /// Returns the words and the type of the value; for a reference, a reference to the array.
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

/// Returns the value of a path that rustc evaluated: a constant, or a variant without payload.
pub fn constant<T: Evaluated>(cx: &mut Builder, _: &Slot<T>, value: &T) -> tree::Constant {
    value.evaluated(cx)
}

/// Converts an array to a `Vec`.
pub fn list<T, const N: usize>(items: [T; N]) -> Vec<T> {
    Vec::from(items)
}

/// Implements the DSL's traits for types: their form in the tree, and their type in a slot.
///
/// The first parameters belong to the type, the second to its slot type.
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

/// Implements the DSL's traits for types of std and nalgebra, each represented by a type of the DSL.
macro_rules! stands {
    ($([$($parameters:tt)*] $native:ty $(where $place:ty: $bound:path)? => $data:ty;)*) => {
        $crate::generate::slot::dsl_types! {$(
            [$($parameters)*] [$($parameters)*] $native as Self $(where $place: $bound)? => |cx| <$data>::ty(cx);
        )*}
    };
}
pub(super) use stands;

/// Implements the DSL's traits for types without values.
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
    /// Kind of the scalar.
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
    [T: DslType + ?Sized] [T: ?Sized] &T as Shared<T> => |cx| shared(T::ty(cx));
    [T: DslType + ?Sized] [T: ?Sized] &mut T as Exclusive<T> => |cx| Ty::Ref(Box::new(T::ty(cx)), true);
    [T: DslType + ?Sized] [T: ?Sized] Shared<T> as Self => |cx| shared(T::ty(cx));
    [T: DslType + ?Sized] [T: ?Sized] Exclusive<T> as Self => |cx| Ty::Ref(Box::new(T::ty(cx)), true);
    [T: DslType] [T: Seen] Option<T> as Option<T::Slot> => |cx| Ty::Option(Box::new(T::ty(cx)));
    [T: DslType, E: DslType] [T: Seen, E: Seen] Result<T, E> as Result<T::Slot, E::Slot>
        => |cx| Ty::Result(Box::new(T::ty(cx)), Box::new(E::ty(cx)));
}

never_held! {
    [T: ?Sized] Shared<T>;
    [T: ?Sized] Exclusive<T>;
}

/// Returns the type of a shared reference. A name is a value: nobody can write to its text.
fn shared(to: Ty) -> Ty {
    match to {
        Ty::Known(name, inner) if name == Ty::NAME => Ty::Known(name, inner),
        other => Ty::Ref(Box::new(other), false),
    }
}

/// The text of a name, which is its word.
impl DslType for str {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Known(Ty::NAME.into(), Box::new(Ty::Scalar(Scalar::Int(Int::U32))))
    }
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
