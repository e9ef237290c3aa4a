//! What the operators of a function mean, as far as they are functions: of nalgebra's rotations and poses, and of
//! authors' own types.
//!
//! The types of the operands decide, as rustc put them into slots. Own operators announce themselves through a link-time
//! registry, by the trait and the types that they take.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use bessemer_ir::tree::{self, BinaryOp, Callee, Implied, Ty};

use super::{Builder, spatial};

/// The traits that are called by no name and no operator of one's own.
const IMPLIED: [&str; 2] = ["PartialEq", "From"];

/// An implementation of an operator that its author marked, or of one of [`IMPLIED`].
pub struct OwnOperator {
    name: &'static str,
    left: fn(&mut Builder) -> Ty,
    right: fn(&mut Builder) -> Ty,
    build: fn(&mut Builder) -> tree::Callee,
}

inventory::collect!(OwnOperator);

impl OwnOperator {
    /// An implementation of the trait `name`, for operands of two types; of the sign, twice the same.
    pub const fn new(
        name: &'static str,
        left: fn(&mut Builder) -> Ty,
        right: fn(&mut Builder) -> Ty,
        build: fn(&mut Builder) -> tree::Callee,
    ) -> OwnOperator {
        OwnOperator { name, left, right, build }
    }
}

/// What the operators of a function call.
pub(super) fn called(
    cx: &mut Builder,
    operators: &[tree::Operator],
    slots: &[Ty],
) -> Vec<(u32, tree::Callee)> {
    let mut found = spatial::operators(cx, operators, slots);
    for operator in operators {
        let of_slot = |slot: &Option<u32>| slots.get(slot.unwrap_or(u32::MAX) as usize);
        let operands: Vec<Option<&Ty>> = operator.operands.iter().map(of_slot).collect();
        if found.iter().all(|(at, _)| *at != operator.at)
            && let Some(own) = own(trait_of(operator), &operands)
        {
            found.push((operator.at, (own.build)(cx)));
        }
    }
    found
}

/// Builds what is called by no name, of each type that the package has, and says what it is.
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
        if found.is_empty() {
            break;
        }
        for own in found {
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

/// The trait of an operator.
fn trait_of(operator: &tree::Operator) -> &'static str {
    let assigns = operator.operands.first() == Some(&Some(operator.at));
    match (operator.op, assigns) {
        (Some(BinaryOp::Add), false) => "Add",
        (Some(BinaryOp::Sub), false) => "Sub",
        (Some(BinaryOp::Mul), false) => "Mul",
        (Some(BinaryOp::Div), false) => "Div",
        (Some(BinaryOp::Add), true) => "AddAssign",
        (Some(BinaryOp::Sub), true) => "SubAssign",
        (Some(BinaryOp::Mul), true) => "MulAssign",
        (Some(BinaryOp::Div), true) => "DivAssign",
        _ => "Neg",
    }
}

/// The one implementation that takes the operands; the type of a literal is any number's.
fn own(name: &str, operands: &[Option<&Ty>]) -> Option<&'static OwnOperator> {
    let left = (*operands.first()?)?;
    // Numbers and matrices have none, and most operators are theirs.
    if !matches!(left, Ty::Named(_)) {
        return None;
    }
    // Only to name types: nothing that it is told becomes part of the package.
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
