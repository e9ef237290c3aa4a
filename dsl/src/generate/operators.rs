//! Operators that are functions: those of nalgebra's rotations and poses, and of authors' types.
//!
//! The types of the operands, which rustc recorded in slots, select the function. rustc itself finds an author's
//! operator, as the function of [`Implements`], wherever the witness copy knows the types. In two cases a link-time
//! registry is searched by trait and types: operands whose types are parameters of a function, and `==` and the
//! conversions of `?`, which have no expression. Generic functions are not in the registry.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::{Callee, Implied, Ty};
use nalgebra::SMatrix;

use super::builder::{self, Builder, OwnOperator};
use super::slot::{Of, ScalarType, Seen, Slot, Tells};
use super::{spatial, wide};

/// Traits whose functions have no call in the source and no operator.
const IMPLIED: [&str; 7] =
    ["PartialEq", "PartialOrd", "From", "Index", "IndexMut", tree::ITERATOR, tree::AS];

/// Marks operators whose operands have one type if both are numbers; a shift is by any number.
pub trait OfOneType {}

macro_rules! signs {
    (of one type: $($of_one_type:ident)*; others: $($other:ident)*) => {
        /// Module with a type for each operator and conversion.
        #[allow(missing_docs)]
        pub mod sign {
            $(pub struct $of_one_type;)*
            $(pub struct $other;)*
            // Methods that loops call by no name: no traits, so no author's interface is taken for one.
            pub struct Iter;
            pub struct IterMut;
        }

        $(impl OfOneType for sign::$of_one_type {})*

        /// Returns true if an interface is an operator or a conversion.
        pub(super) fn is_sign(interface: &str) -> bool {
            [$(stringify!($of_one_type),)* $(stringify!($other)),*].contains(&interface)
        }
    };
}

/// Returns true if an interface is an operator or a conversion with an operand.
pub(super) fn has_operand(interface: &str) -> bool {
    let other = ["FromIterator", "Extend", tree::ITERATOR];
    is_sign(interface) && !other.contains(&interface)
}

signs! {
    of one type: Add Sub Mul Div Rem BitAnd BitOr BitXor Neg Not
        AddAssign SubAssign MulAssign DivAssign RemAssign BitAndAssign BitOrAssign BitXorAssign;
    others: Shl Shr ShlAssign ShrAssign PartialEq PartialOrd From TryFrom Index IndexMut FromIterator Extend Iterator
}

/// An author's type with an operator or a conversion `O` for an operand of type `B`.
pub trait Implements<O, B> {
    /// Builds its function.
    fn build(cx: &mut Builder) -> tree::Callee;
}

/// Marker of that function.
pub struct Operation<O, A, B>(Of<(O, A, B)>);

impl<O, A: Implements<O, B>, B> builder::Callee for Operation<O, A, B> {
    fn callee(cx: &mut Builder) -> tree::Callee {
        A::build(cx)
    }
}

/// A type with the operator `O` for an operand of type `B`. The type is an author's; or, if rustc infers it later, a
/// number or a matrix.
pub trait Operates<O, B> {
    /// Marker of the function.
    type Marker: PerhapsOwn;
}

/// Marker of an operator without an author's function.
pub struct NotOwn;

impl<O: OfOneType, T: ScalarType> Operates<O, T> for T {
    type Marker = NotOwn;
}

// The types in the slots of the operator select the library's function.
impl<O: OfOneType> Operates<O, u128> for u128 {
    type Marker = NotOwn;
}
impl<O: OfOneType> Operates<O, i128> for i128 {
    type Marker = NotOwn;
}

impl<O, T: ScalarType, const R: usize, const C: usize> Operates<O, T> for SMatrix<T, R, C> {
    type Marker = NotOwn;
}

impl<O, T: ScalarType, const R: usize, const C: usize> Operates<O, SMatrix<T, R, C>> for T {
    type Marker = NotOwn;
}

impl<O, T: ScalarType, const R: usize, const C: usize, const R2: usize, const C2: usize>
    Operates<O, SMatrix<T, R2, C2>> for SMatrix<T, R, C>
{
    type Marker = NotOwn;
}

/// Marker of an author's function, or of none.
pub trait PerhapsOwn {
    /// Builds the function, if there is one.
    fn own(cx: &mut Builder) -> Option<tree::Callee>;
}

impl PerhapsOwn for NotOwn {
    fn own(_: &mut Builder) -> Option<tree::Callee> {
        None
    }
}

impl<M: builder::Callee> PerhapsOwn for M {
    fn own(cx: &mut Builder) -> Option<tree::Callee> {
        Some(M::callee(cx))
    }
}

impl<T: PerhapsOwn> Tells<Option<tree::Callee>> for Slot<T> {
    fn told(&self, cx: &mut Builder) -> Option<tree::Callee> {
        T::own(cx)
    }
}

/// Operands of an operator; for a sign, twice the same.
pub struct Operands<O, A, B>(Of<(O, A, B)>);

/// Returns the operands in two slots.
pub fn __operands<O, A, B>(_: &Slot<A>, _: &Slot<B>) -> Operands<O, A, B> {
    Operands(PhantomData)
}

/// Returns the operands if the left one, the right one or both have a name.
pub fn __named_left<O, A, B>(_: &A, _: &Slot<B>) -> Operands<O, A, B> {
    Operands(PhantomData)
}

/// See [`__named_left`].
pub fn __named_right<O, A, B>(_: &Slot<A>, _: &B) -> Operands<O, A, B> {
    Operands(PhantomData)
}

/// See [`__named_left`].
pub fn __named<O, A, B>(_: &A, _: &B) -> Operands<O, A, B> {
    Operands(PhantomData)
}

/// Implemented by every type. rustc expects nothing of its [`Type`](Itself::Type) before it knows the type.
pub trait Itself {
    /// The implementing type.
    type Type;
}

impl<T> Itself for T {
    type Type = T;
}

/// Returns the operands; rustc infers their types before it looks up a method of the result.
pub fn __settled<T: Itself>(_: T) -> T::Type {
    unreachable!("a witness copy is never run")
}

/// Operands whose first one has the operator. rustc selects the first applicable one of this trait and the next.
#[allow(missing_docs)]
pub trait OwnOperands {
    type Marker;
    fn __own(&self) -> Slot<Self::Marker> {
        []
    }
}

impl<O, A: Operates<O, B>, B> OwnOperands for Operands<O, A, B> {
    type Marker = A::Marker;
}

/// Operands without an author's operator.
#[allow(missing_docs)]
pub trait OtherOperands {
    fn __own(&self) -> Slot<NotOwn> {
        []
    }
}

impl<O, A, B> OtherOperands for &Operands<O, A, B> {}

/// Passes a value through and records its type in the slot, whatever type is expected.
pub fn __operand<T: Itself>(_: &Slot<T>, _: T) -> T::Type {
    unreachable!("a witness copy is never run")
}

/// Records the type of a place in a slot.
pub fn __placed<T>(_: &Slot<T>, _: &T) {}

/// Passes the value of an operator through, its type into the second slot, and its function into the first. One call
/// replaces two, since rustc's time is proportional to the calls.
pub fn __computed<M, R>(_: &Slot<M>, _: &Slot<R>, value: R, _: Slot<M>) -> R {
    value
}

/// Passes an operand through, and records its type in both slots, in the second one without a reference's lifetime.
pub fn __both<T: Seen>(_: &Slot<T>, _: &Slot<T::Slot>, value: T) -> T {
    value
}

/// Passes the value of an operator through, and records its function in the slot.
pub fn __operated<M, R>(_: &Slot<M>, value: R, _: Slot<M>) -> R {
    value
}

inventory::collect!(OwnOperator);

/// Returns the functions that the operators of a function call.
pub(super) fn called(
    cx: &mut Builder,
    operators: &[tree::Operator],
    authors: Vec<Option<tree::Callee>>,
    slots: &[Ty],
) -> Vec<(u32, tree::Callee)> {
    let ours = |it: &tree::Operator| {
        let spatial = spatial::operator(cx, it, slots);
        Some((it.at, spatial.or_else(|| wide::operator(cx, it, slots))?))
    };
    let mut found: Vec<_> = operators.iter().filter_map(ours).collect();
    for (operator, authors) in operators.iter().zip(authors) {
        if found.iter().any(|(at, _)| *at == operator.at) {
            continue;
        }
        let callee = authors.or_else(|| {
            let of_slot = |slot: &Option<u32>| slots.get(slot.unwrap_or(u32::MAX) as usize);
            let operands: Vec<Option<&Ty>> = operator.operands.iter().map(of_slot).collect();
            Some((own(&operator.of, &operands)?.build)(cx))
        });
        found.extend(callee.map(|callee| (operator.at, callee)));
    }
    found
}

/// Builds the functions without a call in the source for each type of the package, and returns their list.
pub(super) fn implied(cx: &mut Builder) -> Vec<Implied> {
    let mut list = Vec::new();
    let own = inventory::iter::<OwnOperator>.into_iter();
    let mut waiting: Vec<&OwnOperator> = own.filter(|own| IMPLIED.contains(&own.name)).collect();
    // The linker's order differs from build to build.
    waiting.sort_by_cached_key(|own| {
        let scratch = &mut Builder::default();
        (own.name, format!("{:?} {:?}", (own.left)(scratch), (own.right)(scratch)))
    });
    loop {
        // One may bring the type that another is of.
        let (found, rest): (Vec<_>, Vec<_>) = waiting.into_iter().partition(|own| {
            let scratch = &mut Builder::default();
            cx.knows(&(own.left)(scratch)) && cx.knows(&(own.right)(scratch))
        });
        let untold = core::mem::take(&mut cx.untold);
        if found.is_empty() && untold.is_empty() {
            break;
        }
        for own in untold.values().filter(|own| own.name == tree::ITERATOR) {
            let owner = (own.left)(cx);
            cx.check_iterator(&owner);
        }
        for own in found.into_iter().chain(untold.values()) {
            let (owner, other) = ((own.left)(cx), (own.right)(cx));
            if let Callee::Function(function) = (own.build)(cx) {
                let of = String::from(own.name);
                list.push(Implied { of, owner, other, function });
            }
        }
        waiting = rest;
    }
    list
}

/// Returns the only implementation for these operands; a literal matches any number type.
fn own(name: &str, operands: &[Option<&Ty>]) -> Option<&'static OwnOperator> {
    let left = (*operands.first()?)?;
    // Most operators are those of numbers and matrices.
    if !operands.iter().flatten().any(|operand| matches!(operand, Ty::Named(_))) {
        return None;
    }
    // Only to name types: nothing that it is reported becomes part of the package.
    let scratch = &mut Builder::default();
    let mut list = inventory::iter::<OwnOperator>.into_iter().filter(|own| {
        own.name == name
            && (own.left)(scratch) == *left
            && match operands.get(1) {
                Some(Some(right)) => (own.right)(scratch) == **right,
                Some(None) => matches!((own.right)(scratch), Ty::Scalar(_)),
                None => true,
            }
    });
    let first = list.next();
    first.filter(|_| list.next().is_none())
}
