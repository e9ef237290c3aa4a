//! Types that borrow: slices in structs, variants, tuples and results, and `&mut T` in an `Option` or a `Result`.
//!
//! C has no lifetimes, so no value contains a pointer. A slice in a value is a struct of two numbers: the index of
//! its first element and its length. A `&mut T` is a slice of one element, a struct of one number. The array of these
//! elements, the slice's *lender*, is known when the C is written, for each slice in each local; the analysis follows
//! the value through assignments. A function that takes such a value also takes the lender of each of its slices, as
//! a slice parameter. The slices of a returned value refer to arrays that the function received.
//!
//! Must not know: how the lenders of a function's values are found ([`lenders`](super::lenders)).

use bessemer_ir::tree::{Site, Ty};
use bessemer_ir::visit::Walk;
use bessemer_ir::{Expr, Field, LocalId, Place, Span, Step, StructId, Type};

use super::context::{Borrowed, Context, Joined, Path};
use super::problem::Problem;

/// Location of a slice: a local or, without one, the result; and the fields that lead to it.
pub(super) type Spot = (Option<LocalId>, Path);

/// The slices in the locals of a function, with the arrays that they refer to.
#[derive(Default)]
pub(super) struct Lenders {
    /// The lender of each slice.
    pub known: Vec<(Spot, Place)>,
    /// The lenders of values that no local holds yet.
    pub made: Vec<(Expr, Place)>,
    /// Parameters that are lenders: the lender, the parameter that has the slice, and the path to the slice in it.
    pub lending: Vec<(LocalId, LocalId, Path)>,
    /// Locals that represent lenders that are not known yet.
    pub awaited: Vec<Awaited>,
    /// Slices that were copied before their lender was known: destination and source.
    pub copied: Vec<(Spot, Copied)>,
    /// Number of locals that are parameters.
    pub params: usize,
    /// The first slice that was refused.
    pub problem: Option<Problem>,
}

impl Lenders {
    /// Returns the lender of the slice at a spot.
    pub fn of(&self, spot: &Spot) -> Option<Place> {
        self.known.iter().find(|it| it.0 == *spot).map(|it| it.1.clone())
    }

    /// Returns true if a local is a placeholder for a lender.
    pub fn has_placeholder(&self, local: LocalId) -> bool {
        self.awaited.iter().any(|it| it.stands == local)
    }

    /// Returns true if the place of a lender contains a local for which `is` holds.
    pub fn mention(&self, is: &dyn Fn(LocalId) -> bool) -> bool {
        let lenders = self.known.iter().map(|it| &it.1).chain(self.made.iter().map(|it| &it.1));
        let mut reached = lenders.map(|place| place.load());
        reached.any(|place| place.any_place(|place, _| is(place.root)))
    }
}

/// Source of a copied slice, and the span of the copy.
pub(super) type Copied = (Spot, Span);

/// A local that represents a lender until it is known.
pub(super) struct Awaited {
    pub stands: LocalId,
    /// The slice whose lender is unknown.
    pub slice: Borrowed,
    pub of: Spot,
    pub site: Site,
}

/// Returns the location of the slice at a place: the fields among its steps.
pub(super) fn spot_of(place: &Place) -> Spot {
    let field = |step: &Step| match step {
        Step::Field(at) => Some(*at),
        _ => None,
    };
    (Some(place.root), place.steps.iter().filter_map(field).collect())
}

/// Extends paths within a field to paths within its struct.
pub(super) fn in_field<T>(at: u32, found: Vec<(Path, T)>) -> impl Iterator<Item = (Path, T)> {
    found.into_iter().map(move |(path, known)| ([vec![at], path].concat(), known))
}

/// Returns the struct that a type is, or that its array elements are.
fn struct_in(ty: &Type) -> Option<StructId> {
    match ty {
        Type::Array { element, .. } => struct_in(element),
        Type::Struct(id) => Some(*id),
        _ => None,
    }
}

/// Returns true for a `&mut T` to one value, not to a slice.
pub(super) fn is_element(ty: &Ty) -> bool {
    matches!(ty, Ty::Ref(of, true) if !matches!(**of, Ty::Slice(_)))
}

impl Context<'_> {
    /// Returns the struct and the slice of a type that represents one.
    pub(super) fn as_borrowed(&self, ty: &Type) -> Option<(StructId, &Borrowed)> {
        match ty {
            Type::Struct(id) => Some((*id, self.types.borrowed.get(id)?)),
            _ => None,
        }
    }

    /// Returns the slices in a value of a type, each with its path.
    pub(super) fn slices_in(&self, ty: &Type) -> Vec<(Path, Borrowed)> {
        let Some(id) = struct_in(ty).filter(|_| !self.types.borrowed.is_empty()) else {
            return Vec::new();
        };
        if let Some(borrowed) = self.types.borrowed.get(&id) {
            return vec![(Path::new(), borrowed.clone())];
        }
        let inside = |(at, field): (u32, &Field)| in_field(at, self.slices_in(&field.ty));
        (0..).zip(self.fields(id)).flat_map(inside).collect()
    }

    /// Returns the slices in a value of a type, grouped by common lender.
    pub(super) fn groups_in(&self, ty: &Type) -> Vec<(Vec<Path>, Borrowed)> {
        let mut groups: Vec<(Vec<Path>, Borrowed)> = Vec::new();
        for (path, borrowed) in self.slices_in(ty) {
            let known = |both| self.types.joined.contains(&both);
            let joins = |group: &(Vec<Path>, _)| {
                group.0.iter().any(|it| self.within_one(ty, it, &path).is_some_and(known))
            };
            let (own, rest): (Vec<_>, Vec<_>) = groups.into_iter().partition(joins);
            groups = rest;
            let mut paths: Vec<Path> = own.into_iter().flat_map(|group| group.0).collect();
            paths.push(path);
            groups.push((paths, borrowed));
        }
        groups.sort_by(|one, other| one.0.cmp(&other.0));
        groups
    }

    /// Returns two slices of a value by their paths from the innermost struct that contains both.
    pub(super) fn within_one(&self, ty: &Type, one: &[u32], other: &[u32]) -> Option<Joined> {
        let common = one.iter().zip(other).take_while(|(one, other)| one == other).count();
        let mut id = struct_in(ty)?;
        for at in &one[..common] {
            id = struct_in(&self.fields(id)[*at as usize].ty)?;
        }
        let mut both = [one[common..].to_vec(), other[common..].to_vec()];
        both.sort();
        Some((id, both))
    }

    /// Returns the name of the lender parameter for the slice at `path` in the parameter `param`.
    pub(super) fn lender_name(&self, param: &str, ty: &Type, path: &[u32]) -> String {
        let (mut name, mut ty) = (param.to_owned(), ty);
        for at in path {
            let Some(id) = struct_in(ty) else { break };
            let field = &self.fields(id)[*at as usize];
            name = format!("{name}_{}", field.name);
            ty = &field.ty;
        }
        // What is a slice and nothing else has its name already.
        if path.is_empty() { format!("{name}_items") } else { name }
    }
}
