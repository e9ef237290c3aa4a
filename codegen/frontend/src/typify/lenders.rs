//! Follows each slice in a value to the array that it refers to, its lender: from local to local, and through calls.
//!
//! A slice may be read before its lender is known: in a loop, a local begins as `None`, and an assignment further
//! down sets it. Such a read uses a placeholder local instead of the array. When the function is lowered, the lender
//! is known and replaces the placeholder.
//!
//! Invariants: a slice in a local has at most one lender, whatever path is taken. The indices in a lender's place
//! were evaluated before the local was declared, so they do not change during its lifetime. Anything that needs a
//! pointer is refused.
//!
//! Must not know: how a slice becomes a value, or how one is used ([`held_slices`](super::held_slices)).

use bessemer_ir::tree::{self, Site};
use bessemer_ir::visit::{self, Access, VisitMut, Walk};
use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, FunctionId, Local, LocalId, Mode, Place, Span, Step,
    StmtKind, Type,
};

use super::borrowed::{Awaited, Copied, Spot, in_field, spot_of};
use super::call::lent;
use super::context::{Borrowed, Path};
use super::lengths::is_number;
use super::lowering::{Lowering, UNNAMED};
use super::value::{Slice, Submatrix, Value, indices};
use super::{Needed, Problem, Result, problem, refusals, refused};
use bessemer_ir::effects::same_place;

/// Remedies for a slice, or a `&mut T`, without a known array.
const FIRST_VALUE: &str = "assign the slice a first value above this line, such as `&values[..0]`";
const KEEP_INDEX: &str = "store an index instead of the reference, `Option<usize>`, or choose with `iter_mut().min_by_key(…)` and the like";
const PASS_GIVEN: &str =
    "pass an element of an array: `values.get_mut(i)`, `values.iter_mut().find(…)`";

/// Lender of a slice or, if it is not known yet, the slice that this one copies.
type Lent = Result<Place, Copied>;

/// Index of the first element, in the struct that represents a slice.
pub(super) const FROM: u32 = 0;
pub(super) const LENGTH: u32 = 1;

impl Lowering<'_, '_> {
    /// Declares the parameters that are lenders of the slices in another parameter.
    pub(super) fn lending_parameters(&mut self, param: &tree::Param, local: LocalId) -> Result<()> {
        let Local { ty, span, .. } = self.locals[local.index()].clone();
        let groups = self.cx.groups_in(&ty);
        if !groups.is_empty() && matches!(self.source.tree.role, tree::Role::Entry { .. }) {
            return refused(param.site, refusals::ENTRY_BORROWS);
        }
        for (paths, Borrowed { element, mutable, .. }) in groups {
            let name = self.cx.lender_name(&param.name, &ty, &paths[0]);
            let root = self.slice_local(&name, element, mutable, span);
            self.lenders.lending.push((root, local, paths[0].clone()));
            let lender = Place::local(root, self.locals[root.index()].ty.clone(), span);
            let known = paths.into_iter().map(|path| ((Some(local), path), lender.clone()));
            self.lenders.known.extend(known);
        }
        Ok(())
    }

    /// Records that two slices of a parameter have one lender; the function is lowered again with this. Returns false
    /// if they are not slices of one parameter.
    fn join_lenders(&mut self, one: &Place, other: &Place) -> bool {
        let slice = |of: &Place| self.lenders.lending.iter().find(|it| it.0 == of.root).cloned();
        let (Some((_, param, one)), Some((_, also, other))) = (slice(one), slice(other)) else {
            return false;
        };
        let ty = self.locals[param.index()].ty.clone();
        let both = self.cx.within_one(&ty, &one, &other);
        let both = both.filter(|both| param == also && !self.cx.types.joined.contains(both));
        let joins = both.is_some();
        self.cx.types.joined.extend(both);
        joins
    }

    /// Returns the lender of the slice at a place.
    pub(super) fn lender_of(&self, place: &Place) -> Option<Place> {
        self.lenders.of(&spot_of(place))
    }

    /// Records the lenders of the slices in a value where a statement stores it.
    pub(super) fn follow(&mut self, stmt: &StmtKind) {
        let ((to, at), value) = match stmt {
            StmtKind::Let { local, value } => {
                self.lenders.known.retain(|it| it.0.0 != Some(*local));
                ((Some(*local), Path::new()), value.as_ref())
            }
            StmtKind::Assign { place, value } => (spot_of(place), Some(value)),
            StmtKind::Return(value) => ((None, Path::new()), value.as_ref()),
            _ => return,
        };
        let Some(value) = value else { return };
        for (path, lender) in self.slices_of(value) {
            let to = (to, [&at[..], &path].concat());
            match lender {
                Ok(lender) => self.lend(to, lender, value.span),
                Err(copied) => self.lenders.copied.push((to, copied)),
            }
        }
    }

    /// Resolves copies of slices whose lender was unknown when they were made.
    pub(super) fn follow_copies(&mut self) {
        loop {
            let before = self.lenders.copied.len();
            for (to, (from, span)) in std::mem::take(&mut self.lenders.copied) {
                match self.lenders.of(&from) {
                    Some(lender) => self.lend(to, lender, span),
                    None => self.lenders.copied.push((to, (from, span))),
                }
            }
            // What is left was never given anything.
            if self.lenders.copied.len() == before {
                return;
            }
        }
    }

    /// Returns the slices in a value: each with its lender, or with the slice it copies if that is unknown.
    fn slices_of(&self, value: &Expr) -> Vec<(Path, Lent)> {
        let slices = self.cx.slices_in(&value.ty);
        if slices.is_empty() {
            return Vec::new();
        }
        match &value.kind {
            ExprKind::Load(place) => {
                let (root, path) = spot_of(place);
                let of = |(inside, _): (Path, Borrowed)| {
                    let spot = (root, [&path[..], &inside].concat());
                    (inside, self.lenders.of(&spot).ok_or((spot, value.span)))
                };
                slices.into_iter().map(of).collect()
            }
            ExprKind::Struct(_) if self.cx.as_borrowed(&value.ty).is_some() => {
                let made = self.lenders.made.iter().find(|(made, _)| made == value);
                made.map(|(_, lender)| (Path::new(), Ok(lender.clone()))).into_iter().collect()
            }
            ExprKind::Struct(parts) => {
                let inside = |(at, part): (u32, &Expr)| in_field(at, self.slices_of(part));
                (0..).zip(parts).flat_map(inside).collect()
            }
            ExprKind::Array(items) => items.iter().flat_map(|it| self.slices_of(it)).collect(),
            ExprKind::Splat(item) => self.slices_of(item),
            ExprKind::Call(id, arguments) => self.lent_by_call(*id, arguments),
            _ => Vec::new(),
        }
    }

    /// Returns the lenders of the slices in a call's result: places that its arguments borrow.
    fn lent_by_call(&self, id: FunctionId, arguments: &[Argument]) -> Vec<(Path, Lent)> {
        let Some(given) = self.cx.calls.given_back.get(&id) else { return Vec::new() };
        let mapped = |(path, lender): &(Path, Place)| {
            let of = passed_for(lender, arguments)?;
            let outer = match of.steps.split_last() {
                Some((Step::From(_), outer)) => outer,
                _ => &of.steps,
            };
            let steps = [outer, &lender.steps].concat();
            let ty = self.type_of(of.root, &steps);
            Some((path.clone(), Ok(Place { root: of.root, steps, ty, span: of.span })))
        };
        given.iter().filter_map(mapped).collect()
    }

    /// Records the lender of a slice; refuses what would need a pointer.
    fn lend(&mut self, to: Spot, lender: Place, span: Span) {
        let of_param = lender.root.index() < self.lenders.params;
        let (message, help) = match (to.0, self.lenders.of(&to)) {
            (None, _) if !of_param || !indices(&lender).all(Expr::is_literal) => {
                refusals::UNNAMEABLE
            }
            (_, Some(known))
                if same_place(&known, &lender) || self.join_lenders(&known, &lender) =>
            {
                return;
            }
            (_, Some(_)) => refusals::ONE_OR_OTHER,
            (Some(root), None) if indices(&lender).any(|index| mentions_from(index, root)) => {
                let outer = lender.steps.split_last().map_or(&[][..], |(_, outer)| outer);
                match self.type_of(lender.root, outer) {
                    Type::Matrix { .. } => refusals::OF_MATRIX,
                    _ => refusals::CHOSEN,
                }
            }
            (_, None) => return self.lenders.known.push((to, lender)),
        };
        let site = Site(span.line, span.column);
        let told = Problem { site, message: message.into(), help: help.into() };
        self.lenders.problem.get_or_insert(told);
    }

    /// Returns the arguments that pass the lenders of the slices in another argument.
    pub(super) fn lending_arguments(
        &mut self,
        argument: &Argument,
        ty: &Type,
        site: Site,
    ) -> Result<Vec<Argument>> {
        let groups = self.cx.groups_in(ty);
        if groups.is_empty() {
            return Ok(Vec::new());
        }
        let value = match argument {
            Argument::Value(value) | Argument::Ref(value) => value,
            Argument::RefMut(place) => &place.load(),
        };
        let known = self.slices_of(value).into_iter();
        let known: Vec<_> = known.filter_map(|(path, it)| Some((path, it.ok()?))).collect();
        let mut passed = Vec::new();
        for (paths, Borrowed { mutable, one, .. }) in groups {
            let lenders = known.iter().filter(|it| paths.contains(&it.0)).map(|it| &it.1);
            let lenders: Vec<_> = lenders.collect();
            if lenders.iter().any(|it| !same_place(it, lenders[0])) {
                return refused(site, refusals::TWO_LENDERS);
            }
            let (lender, slice) = lenders
                .first()
                .filter(|lender| !self.lenders.has_placeholder(lender.root))
                .and_then(|lender| Some(((*lender).clone(), self.all_of((*lender).clone())?)))
                .or_told(
                    site,
                    "the array that this value refers to is not known here",
                    if one { PASS_GIVEN } else { FIRST_VALUE },
                )?;
            passed.extend(slice.passed(if mutable { Mode::RefMut } else { Mode::Ref }));
            // What had no elements may have some behind the call.
            if let Argument::RefMut(place) = argument {
                let (root, outer) = spot_of(place);
                for path in paths.into_iter().filter(|path| known.iter().all(|it| it.0 != *path)) {
                    let spot = (root, [&outer[..], &path].concat());
                    self.lenders.known.push((spot, lender.clone()));
                }
            }
        }
        Ok(passed)
    }

    /// Shifts the slices in a call's result: they count from the beginning of an argument, and become relative to the
    /// lender's beginning.
    pub(super) fn counted_from_lender(&mut self, call: Expr) -> Result<Expr> {
        let ExprKind::Call(id, arguments) = &call.kind else { return Ok(call) };
        let Some(given) = self.cx.calls.given_back.get(id) else { return Ok(call) };
        let begun =
            |(path, lender): &(Path, Place)| match passed_for(lender, arguments)?.steps.last() {
                Some(Step::From(from)) if !is_number(from, 0) => Some((path.clone(), from.clone())),
                _ => None,
            };
        let begun: Vec<(Path, Expr)> = given.iter().filter_map(begun).collect();
        if begun.is_empty() {
            return Ok(call);
        }
        let place = self.hold(call);
        for (path, from) in begun {
            self.shift(&place, &path, &from)?;
        }
        Ok(place.load())
    }

    /// Adds an offset to the beginning of the slice at a path of a place.
    fn shift(&mut self, place: &Place, path: &[u32], by: &Expr) -> Result<()> {
        let span = place.span;
        let Some((first, rest)) = path.split_first() else {
            let from = place.inside(Step::Field(FROM), Type::USIZE);
            let value = Expr::binary(BinaryOp::Add, from.load(), by.clone()).at(span);
            self.emit(StmtKind::Assign { place: from, value }, span);
            return Ok(());
        };
        let Type::Struct(id) = place.ty else { return Ok(()) };
        let inner = self.part(place, id, *first as usize);
        let mut cases = self.cx.known_of(id).cases.iter();
        let Some(word) = cases.position(|case| case.field == Some(*first)) else {
            return self.shift(&inner, rest, by);
        };
        let then = self.scoped(|it| it.shift(&inner, rest, by))?;
        let condition = self.tag_is(place, id, word as u64);
        self.emit_if(condition, then, span);
        Ok(())
    }

    /// Returns the lender of each slice in the result, or the first error about a slice of the function.
    pub(super) fn lent_out(&mut self) -> Result<Vec<(Path, Place)>> {
        let is_entry = matches!(self.source.tree.role, tree::Role::Entry { .. });
        if is_entry && !self.cx.slices_in(&self.result).is_empty() {
            return refused(self.source.tree.site, refusals::SLICE_GIVEN);
        }
        match self.lenders.problem.take() {
            Some(wrong) => Err(wrong),
            None => {
                let all = std::mem::take(&mut self.lenders.known).into_iter();
                let result = all.filter(|((local, _), _)| local.is_none());
                Ok(result.map(|((_, path), lender)| (path, lender)).collect())
            }
        }
    }

    /// Returns the placeholder for the unknown lender of the slice at a place.
    pub(super) fn awaited(&mut self, place: &Place, slice: &Borrowed, site: Site) -> Place {
        let of = spot_of(place);
        let ty = Type::Array { element: Box::new(slice.element.clone()), len: u32::MAX };
        let known = self.lenders.awaited.iter().find(|it| it.of == of).map(|it| it.stands);
        let stands = known.unwrap_or_else(|| {
            let stands = self.local(UNNAMED, ty.clone(), place.span);
            self.lenders.awaited.push(Awaited { stands, slice: slice.clone(), of, site });
            stands
        });
        Place::local(stands, ty, place.span)
    }

    /// Replaces all placeholders by their lenders.
    pub(super) fn put_awaited(&mut self) -> Result<()> {
        for Awaited { stands, slice, of, site } in std::mem::take(&mut self.lenders.awaited) {
            let lender = self.lenders.of(&of).filter(|it| it.root != stands);
            let Some(lender) = lender else {
                // Where it was shown, and refused.
                if let Some(told) = self.lenders.problem.take() {
                    return Err(told);
                }
                let help = if slice.one { KEEP_INDEX } else { FIRST_VALUE };
                return problem(site, "the array of these elements is not known here", help);
            };
            let mut put = Put { stands, whole: lender.ty == slice.element, lender };
            self.out.iter_mut().for_each(|stmt| put.stmt(stmt));
            // What others were given of it.
            for (.., lender) in &mut self.lenders.known {
                put.place(lender, Access::Read);
            }
            self.locals[stands.index()].ty = Type::BOOL;
        }
        Ok(())
    }
}

/// Returns the place that a call passes for a parameter.
fn passed_for<'a>(lender: &Place, arguments: &'a [Argument]) -> Option<&'a Place> {
    lent(arguments.get(lender.root.index())?).map(|(place, _)| place)
}

/// Returns true if an index reads the local `root` or one declared after it.
fn mentions_from(index: &Expr, root: LocalId) -> bool {
    index.any_expr(|it| matches!(&it.kind, ExprKind::Load(place) if place.root >= root))
}

/// Replaces a placeholder local by a place.
pub(super) struct Put {
    stands: LocalId,
    lender: Place,
    /// True if the lender is a single element, not an array.
    whole: bool,
}

impl Put {
    pub(super) fn new(stands: LocalId, place: Place) -> Put {
        Put { stands, lender: place, whole: false }
    }

    /// Replaces the placeholder in the meaning of a name.
    pub(super) fn value(&mut self, value: &mut Value) {
        match value {
            Value::Place(place) => self.place(place, Access::Read),
            Value::Word(word) => self.expr(word),
            Value::Slice(slice) => self.slice(slice),
            Value::Submatrix(part) => self.submatrix(part),
            Value::Tuple(parts, _) => parts.iter_mut().for_each(|part| self.value(part)),
            Value::Maybe(there, lent) => {
                self.expr(there);
                self.value(lent);
            }
            Value::Local(_) | Value::Closure(_) | Value::Nothing => {}
        }
    }

    fn slice(&mut self, slice: &mut Slice) {
        self.place(&mut slice.base, Access::Read);
        for end in [&mut slice.from, &mut slice.to, &mut slice.length] {
            self.expr(end);
        }
        if let Some(part) = &mut slice.within {
            self.submatrix(part);
        }
    }

    fn submatrix(&mut self, part: &mut Submatrix) {
        self.place(&mut part.matrix, Access::Read);
        self.expr(&mut part.row);
        self.expr(&mut part.column);
    }
}

impl VisitMut for Put {
    fn place(&mut self, place: &mut Place, _: Access) {
        visit::walk_place_mut(self, place);
        if place.root == self.stands {
            let own = usize::from(self.whole).min(place.steps.len());
            let behind = place.steps.split_off(own);
            place.steps = self.lender.steps.iter().cloned().chain(behind).collect();
            place.root = self.lender.root;
        }
    }
}
