//! The arrays whose elements the slices in values are: which one each is of, followed from local to local and through calls.
//!
//! What is read of a slice, or of a `&mut T`, before anything shows which array it is of (in a loop, that the local begins as
//! `None` and an assignment further down gives it one) is read of a local that stands for the array while the function is
//! lowered, and is nowhere in what is given: the array has been shown by then.
//!
//! Invariants: a slice in a local has one lender at most, whatever path was taken; the indices in a lender were computed
//! before the local was declared, so that they mean the same as long as it lives. What else would need a pointer is refused.
//!
//! Must not know: how a slice becomes a value, or what is done with one ([`held_slices`](super::held_slices)).

use bessemer_ir::tree::{self, Site};
use bessemer_ir::visit::{self, Access, VisitMut, Walk};
use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, FunctionId, Local, LocalId, Mode, Place, Span, Step,
    StmtKind, Type,
};

use super::borrowed::{Awaited, Borrowed, Copied, Path, Spot, in_field, spot_of};
use super::call::lent;
use super::lengths::is_number;
use super::lowering::{Lowering, UNNAMED};
use super::order::indices;
use super::value::{Slice, Submatrix, Value};
use super::{Needed, Problem, Result, problem, refusals, refused};
use bessemer_ir::effects::same_place;

/// The remedies where the array of a slice, or of a `&mut T`, is not known.
const FIRST_VALUE: &str = "assign the slice a first value above this line, such as `&values[..0]`";
const KEEP_INDEX: &str = "store an index instead of the reference, `Option<usize>`, or choose with `iter_mut().min_by_key(…)` and the like";
const PASS_GIVEN: &str =
    "pass an element of an array: `values.get_mut(i)`, `values.iter_mut().find(…)`";

/// The lender of a slice or, where it is not known yet, what the slice is a copy of.
type Lent = Result<Place, Copied>;

/// The fields of the struct that a slice is in a value.
pub(super) const FROM: u32 = 0;
pub(super) const LENGTH: u32 = 1;

impl Lowering<'_, '_> {
    /// Declares the parameters that lend the slices in another one.
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

    /// Joins the two slices in a parameter that two lenders are of, if they are; what is lowered with that known is right.
    fn join(&mut self, one: &Place, other: &Place) -> bool {
        let slice = |of: &Place| self.lenders.lending.iter().find(|it| it.0 == of.root).cloned();
        let (Some((_, param, one)), Some((_, also, other))) = (slice(one), slice(other)) else {
            return false;
        };
        let ty = self.locals[param.index()].ty.clone();
        let both = self.cx.within_one(&ty, &one, &other);
        let both = both.filter(|both| param == also && !self.cx.joined.contains(both));
        let joins = both.is_some();
        self.cx.joined.extend(both);
        joins
    }

    /// The lender of the slice at a place.
    pub(super) fn lender_of(&self, place: &Place) -> Option<Place> {
        self.lenders.of(&spot_of(place))
    }

    /// Follows the slices in a value to the place where a statement puts it.
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

    /// Follows what was copied before its lender was known: both are of one array.
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

    /// The slices in a value: their lenders, or what they are copies of where it is not known yet.
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

    /// What a call gives slices of: what it was lent.
    fn lent_by_call(&self, id: FunctionId, arguments: &[Argument]) -> Vec<(Path, Lent)> {
        let Some(given) = self.cx.given_back.get(&id) else { return Vec::new() };
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

    /// The type at a place.
    pub(super) fn type_of(&self, root: LocalId, steps: &[Step]) -> Type {
        let root = self.locals[root.index()].ty.clone();
        steps.iter().fold(root, |ty, step| match step {
            // A part is lent as the whole is.
            Step::From(_) => ty,
            _ => self.cx.module.step_type(&ty, step).unwrap_or(ty),
        })
    }

    /// Notes the lender of a slice; refuses what would need a pointer.
    fn lend(&mut self, to: Spot, lender: Place, span: Span) {
        let of_param = lender.root.index() < self.lenders.params;
        let (message, help) = match (to.0, self.lenders.of(&to)) {
            (None, _) if !of_param || !indices(&lender).all(Expr::is_literal) => {
                refusals::UNNAMEABLE
            }
            (_, Some(known)) if same_place(&known, &lender) || self.join(&known, &lender) => return,
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

    /// The arguments that lend the slices in another one.
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
                .filter(|lender| !self.stands(lender.root))
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

    /// The value of a call whose slices count from where its arguments begin, counted from where their lenders do.
    pub(super) fn counted_from_lender(&mut self, call: Expr) -> Result<Expr> {
        let ExprKind::Call(id, arguments) = &call.kind else { return Ok(call) };
        let Some(given) = self.cx.given_back.get(id) else { return Ok(call) };
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

    /// Moves the slice at a path of a place, where there is one.
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

    /// What the slices in the result are parts of, or what is wrong with a slice of the function.
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

    /// What stands for the array whose elements the slice at a place has.
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

    /// Whether a local stands for an array.
    pub(super) fn stands(&self, local: LocalId) -> bool {
        self.lenders.awaited.iter().any(|it| it.stands == local)
    }

    /// Puts the arrays where something stands for them.
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

/// The place that a call lends for a parameter.
fn passed_for<'a>(lender: &Place, arguments: &'a [Argument]) -> Option<&'a Place> {
    lent(arguments.get(lender.root.index())?).map(|(place, _)| place)
}

/// Whether an index is computed from a local as young as `root`, or younger.
fn mentions_from(index: &Expr, root: LocalId) -> bool {
    index.any_expr(|it| matches!(&it.kind, ExprKind::Load(place) if place.root >= root))
}

/// Puts a place where a local stands for it.
pub(super) struct Put {
    stands: LocalId,
    lender: Place,
    /// Whether what lends is the one element itself.
    whole: bool,
}

impl Put {
    pub(super) fn new(stands: LocalId, place: Place) -> Put {
        Put { stands, lender: place, whole: false }
    }

    /// Puts the place into what a name stands for.
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
