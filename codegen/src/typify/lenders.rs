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
    Argument, BinaryOp, Block, Expr, ExprKind, FunctionId, Local, LocalId, Mode, Place, Span, Step,
    StmtKind, Type,
};

use super::borrowed::Borrowed;
use super::lengths::is_number;
use super::lowering::{Lowering, UNNAMED};
use super::regions::{Awaited, Copied, Path};
use super::value::Slice;
use super::{Problem, Result, problem};
use crate::effects::same_place;

/// The refusal of a slice with two lenders.
const ONE_OR_OTHER: &str =
    "this may be a part of one array or of another, which is decided at run time";
const ONE_ARRAY: &str = "let both be parts of one array, or do what is to be done in each branch";

/// The refusals of what is chosen by an index that is younger than the name.
const CHOSEN: (&str, &str) = (
    "the array that this is a part of is chosen while the name lives",
    "compute its index above the `let`",
);
const OF_MATRIX: (&str, &str) = (
    "a value refers to elements of arrays in the DSL, and this is one of a matrix",
    "find where it is, and index: `if let Some(at) = m.iter().position(|x| …) { m[at] = … }`",
);

/// The fields of the struct that a slice is in a value.
pub(super) const FROM: u32 = 0;
pub(super) const LENGTH: u32 = 1;

/// The fields among the steps of a place.
pub(super) fn path_of(place: &Place) -> Path {
    let field = |step: &Step| match step {
        Step::Field(at) => Some(*at),
        _ => None,
    };
    place.steps.iter().filter_map(field).collect()
}

impl Lowering<'_, '_> {
    /// Declares the parameters that lend the slices in another one.
    pub(super) fn lending_parameters(&mut self, param: &tree::Param, local: LocalId) -> Result<()> {
        let Local { ty, span, .. } = self.locals[local.index()].clone();
        let groups = self.cx.groups_in(&ty);
        if !groups.is_empty() && matches!(self.source.tree.role, tree::Role::Entry { .. }) {
            return problem(
                param.site,
                "an entry point takes no value with a slice in it: nothing could tell whether its length is right",
                "take an array, `&[T; N]`, or a `List<T, N>`, and make the value of it inside",
            );
        }
        for (paths, Borrowed { element, mutable, .. }) in groups {
            let name = self.cx.lender_name(&param.name, &ty, &paths[0]);
            let mode = if mutable { Mode::RefMut } else { Mode::Ref };
            let (root, ty) = (LocalId(self.locals.len() as u32), Type::Slice(Box::new(element)));
            let length = format!("{name}_length");
            self.locals.push(Local { name, ty: ty.clone(), mode, span });
            self.local(length, Type::USIZE, span);
            self.lenders.lending.push((root, local, paths[0].clone()));
            let lender = Place::local(root, ty, span);
            let known = paths.into_iter().map(|path| (local, path, lender.clone()));
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
        if param != also {
            return false;
        }
        let ty = self.locals[param.index()].ty.clone();
        match self.cx.within_one(&ty, &one, &other) {
            Some(both) if !self.cx.joined.contains(&both) => {
                self.cx.joined.push(both);
                true
            }
            _ => false,
        }
    }

    /// All elements of the array that lends a slice.
    fn all_lent(&mut self, lender: &Place) -> Option<Slice> {
        match &lender.ty {
            Type::Slice(element) => {
                let all = Slice::parameter(lender.root, (**element).clone(), lender.span);
                Some(Slice { base: lender.clone(), ..all })
            }
            _ => self.all_of(lender.clone()),
        }
    }

    /// The lender of the slice at a place.
    pub(super) fn lender_of(&self, place: &Place) -> Option<Place> {
        self.lenders.of(place.root, &path_of(place))
    }

    /// Follows the slices in a value to the place where a statement puts it.
    pub(super) fn follow(&mut self, stmt: &StmtKind) {
        match stmt {
            StmtKind::Let { local, value } => {
                self.lenders.known.retain(|it| it.0 != *local);
                if let Some(value) = value {
                    let found = self.lenders_in(value);
                    self.lend_to(*local, &[], found, value.span);
                    self.note_copies((Some(*local), &[]), value);
                }
            }
            StmtKind::Assign { place, value } => {
                let found = self.lenders_in(value);
                self.lend_to(place.root, &path_of(place), found, value.span);
                self.note_copies((Some(place.root), &path_of(place)), value);
            }
            StmtKind::Return(Some(value)) => {
                for (path, lender) in self.lenders_in(value) {
                    self.lend_out(path, lender, value.span);
                }
                self.note_copies((None, &[]), value);
            }
            _ => {}
        }
    }

    /// Notes the slices in a value that are copied from where their lender is not known yet.
    fn note_copies(&mut self, (to, at): (Option<LocalId>, &[u32]), value: &Expr) {
        if self.cx.borrowed.is_empty() {
            return;
        }
        match &value.kind {
            ExprKind::Load(place) => {
                let path = path_of(place);
                for (inside, _) in self.cx.slices_in(&value.ty) {
                    let from = (place.root, [&path[..], &inside].concat());
                    if self.lenders.of(from.0, &from.1).is_none() {
                        let to = (to, [at, &inside].concat());
                        self.lenders.copied.push(Copied { to, from, span: value.span });
                    }
                }
            }
            ExprKind::Struct(parts) if self.cx.as_borrowed(&value.ty).is_none() => {
                for (field, part) in (0..).zip(parts) {
                    self.note_copies((to, &[at, &[field]].concat()), part);
                }
            }
            ExprKind::Array(items) => items.iter().for_each(|it| self.note_copies((to, at), it)),
            ExprKind::Splat(item) => self.note_copies((to, at), item),
            _ => {}
        }
    }

    /// Follows what was copied before its lender was known: both are of one array.
    pub(super) fn follow_copies(&mut self) {
        let mut left = std::mem::take(&mut self.lenders.copied);
        loop {
            let before = left.len();
            for copied in std::mem::take(&mut left) {
                let Copied { to: (to, path), from, span } = &copied;
                match (self.lenders.of(from.0, &from.1), to) {
                    (None, _) => left.push(copied),
                    (Some(lender), Some(to)) => {
                        self.lend_to(*to, &[], vec![(path.clone(), lender)], *span);
                    }
                    (Some(lender), None) => self.lend_out(path.clone(), lender, *span),
                }
            }
            // What is left was never given anything.
            if left.len() == before {
                return;
            }
        }
    }

    /// The lenders of the slices in a value, as far as there are any.
    fn lenders_in(&self, value: &Expr) -> Vec<(Path, Place)> {
        if self.cx.borrowed.is_empty() || self.cx.slices_in(&value.ty).is_empty() {
            return Vec::new();
        }
        let inside = |at: usize, found: Vec<(Path, Place)>| {
            let at = at as u32;
            found.into_iter().map(move |(path, it)| ([vec![at], path].concat(), it))
        };
        match &value.kind {
            ExprKind::Load(place) => {
                let path = path_of(place);
                let of = |(root, known, lender): &(LocalId, Path, Place)| {
                    let rest =
                        known.strip_prefix(path.as_slice()).filter(|_| *root == place.root)?;
                    Some((rest.to_vec(), lender.clone()))
                };
                self.lenders.known.iter().filter_map(of).collect()
            }
            ExprKind::Struct(_) if self.cx.as_borrowed(&value.ty).is_some() => {
                let made = self.lenders.made.iter().find(|(made, _)| made == value);
                made.map(|(_, lender)| (Vec::new(), lender.clone())).into_iter().collect()
            }
            ExprKind::Struct(parts) => {
                let parts = parts.iter().enumerate();
                parts.flat_map(|(at, part)| inside(at, self.lenders_in(part))).collect()
            }
            ExprKind::Array(items) => items.iter().flat_map(|it| self.lenders_in(it)).collect(),
            ExprKind::Splat(item) => self.lenders_in(item),
            ExprKind::Call(id, arguments) => self.lent_by_call(*id, arguments),
            _ => Vec::new(),
        }
    }

    /// What a call gives slices of: what it was lent.
    fn lent_by_call(&self, id: FunctionId, arguments: &[Argument]) -> Vec<(Path, Place)> {
        let Some(given) = self.cx.given_back.get(&id) else { return Vec::new() };
        let mapped = |(path, lender): &(Path, Place)| {
            let of = passed_for(lender, arguments)?;
            let mut steps = of.steps.clone();
            if let Some(Step::From(_)) = steps.last() {
                steps.pop();
            }
            steps.extend(lender.steps.iter().cloned());
            let ty = match (&lender.ty, lender.steps.is_empty()) {
                (Type::Slice(_), true) => self.type_of(of.root, &steps),
                (ty, _) => ty.clone(),
            };
            Some((path.clone(), Place { root: of.root, steps, ty, span: of.span }))
        };
        given.iter().filter_map(mapped).collect()
    }

    /// The type at a place.
    pub(super) fn type_of(&self, root: LocalId, steps: &[Step]) -> Type {
        let mut ty = self.locals[root.index()].ty.clone();
        for step in steps {
            ty = match (step, ty) {
                (Step::Field(at), Type::Struct(id)) => self.cx.field_type(id, *at),
                (Step::Index(_), Type::Array { element, .. } | Type::Slice(element)) => *element,
                (_, Type::Matrix { element, .. }) => Type::Scalar(element),
                (_, other) => other,
            };
        }
        ty
    }

    fn lend_to(&mut self, root: LocalId, at: &[u32], found: Vec<(Path, Place)>, span: Span) {
        for (path, lender) in found {
            let path = [at, path.as_slice()].concat();
            match self.lenders.of(root, &path) {
                Some(known) if same_place(&known, &lender) || self.join(&known, &lender) => {}
                Some(_) => self.refuse_lender(span, ONE_OR_OTHER, ONE_ARRAY),
                None if lender.steps.iter().any(|step| mentions_from(step, root)) => {
                    let outer = lender.steps.split_last().map_or(&[][..], |(_, outer)| outer);
                    let (message, help) = match self.type_of(lender.root, outer) {
                        Type::Matrix { .. } => OF_MATRIX,
                        _ => CHOSEN,
                    };
                    self.refuse_lender(span, message, help);
                }
                None => self.lenders.known.push((root, path, lender)),
            }
        }
    }

    /// Notes what the result has slices of.
    fn lend_out(&mut self, path: Path, lender: Place, span: Span) {
        let fixed = lender.steps.iter().all(super::order::is_fixed);
        if lender.root.index() >= self.lenders.params || !fixed {
            self.refuse_lender(
                span,
                "what this function gives is a part of an array that its caller cannot name",
                "let the caller pass the array itself, and give a part of it",
            );
            return;
        }
        match self.lenders.result.iter().find(|it| it.0 == path).map(|it| it.1.clone()) {
            Some(known) if same_place(&known, &lender) || self.join(&known, &lender) => {}
            Some(_) => self.refuse_lender(span, ONE_OR_OTHER, ONE_ARRAY),
            None => self.lenders.result.push((path, lender)),
        }
    }

    fn refuse_lender(&mut self, span: Span, message: &str, help: &str) {
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
        let known = match argument {
            Argument::Value(value) | Argument::Ref(value) => self.lenders_in(value),
            Argument::RefMut(place) => self.lenders_in(&place.load()),
        };
        let mut passed = Vec::new();
        for (paths, Borrowed { mutable, one, .. }) in groups {
            let mut lenders = known.iter().filter(|it| paths.contains(&it.0)).map(|it| &it.1);
            let lender = lenders.next().cloned();
            if lenders.any(|it| lender.as_ref().is_some_and(|lender| !same_place(it, lender))) {
                return problem(
                    site,
                    "two slices in this value are parts of two arrays, and this function makes one a part of the other",
                    "let both be parts of one array",
                );
            }
            let Some((lender, slice)) = lender
                .filter(|lender| !self.stands(lender.root))
                .and_then(|lender| Some((lender.clone(), self.all_lent(&lender)?)))
            else {
                let help = match one {
                    true => {
                        "pass one that an array gave: `values.get_mut(i)`, `values.iter_mut().find(…)`"
                    }
                    false => {
                        "give the slice its first value, `&values[..0]` if need be, above this line"
                    }
                };
                return problem(
                    site,
                    "whose elements this value refers to is not known here",
                    help,
                );
            };
            passed.extend(slice.passed(if mutable { Mode::RefMut } else { Mode::Ref }));
            // What had no elements may have some behind the call.
            if let Argument::RefMut(place) = argument {
                for path in paths.into_iter().filter(|path| known.iter().all(|it| it.0 != *path)) {
                    let path = [path_of(place), path].concat();
                    self.lenders.known.push((place.root, path, lender.clone()));
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
            let Block(stmts) = self.scoped(|inner| inner.shift(&place, &path, &from))?;
            self.out.extend(stmts);
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
        let case = cases.position(|case| case.field == Some(*first));
        let then = self.scoped(|it| it.shift(&inner, rest, by))?;
        match case {
            Some(word) => {
                let condition = self.tag_is(place, id, word as u64);
                self.emit_if(condition, then, span);
            }
            None => self.out.extend(then.0),
        }
        Ok(())
    }

    /// What the slices in the result are parts of, or what is wrong with a slice of the function.
    pub(super) fn lent_out(&mut self) -> Result<Vec<(Path, Place)>> {
        let is_entry = matches!(self.source.tree.role, tree::Role::Entry { .. });
        if is_entry && !self.cx.slices_in(&self.result).is_empty() {
            return problem(
                self.source.tree.site,
                "the firmware takes no slice: it would not know of which array",
                "return a copy, or where the elements are: an index and a length",
            );
        }
        match self.lenders.problem.take() {
            Some(wrong) => Err(wrong),
            None => Ok(std::mem::take(&mut self.lenders.result)),
        }
    }

    /// What stands for the array whose elements the slice at a place has.
    pub(super) fn awaited(
        &mut self,
        place: &Place,
        element: &Type,
        (site, help): (Site, &'static str),
    ) -> Place {
        let of = (place.root, path_of(place));
        let ty = Type::Array { element: Box::new(element.clone()), len: u32::MAX };
        let known = self.lenders.awaited.iter().find(|it| it.of == of).map(|it| it.stands);
        let stands = known.unwrap_or(LocalId(self.locals.len() as u32));
        if known.is_none() {
            self.local(UNNAMED, ty.clone(), place.span);
            let element = element.clone();
            self.lenders.awaited.push(Awaited { stands, element, of, site, help });
        }
        Place::local(stands, ty, place.span)
    }

    /// Whether a local stands for an array.
    pub(super) fn stands(&self, local: LocalId) -> bool {
        self.lenders.awaited.iter().any(|it| it.stands == local)
    }

    /// Puts the arrays where something stands for them.
    pub(super) fn put_awaited(&mut self) -> Result<()> {
        for Awaited { stands, element, of, site, help } in std::mem::take(&mut self.lenders.awaited)
        {
            let lender = self.lenders.of(of.0, &of.1).filter(|it| it.root != stands);
            let Some(lender) = lender else {
                // Where it was shown, and refused.
                if let Some(told) = self.lenders.problem.take() {
                    return Err(told);
                }
                return problem(site, "whose elements these are is not known here", help);
            };
            let mut put = Put { stands, whole: lender.ty == element, lender };
            let mut body = Block(std::mem::take(&mut self.out));
            put.block(&mut body);
            self.out = body.0;
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
    match arguments.get(lender.root.index())? {
        Argument::RefMut(place) => Some(place),
        Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => Some(place),
        _ => None,
    }
}

/// Whether an index is computed from a local as young as `root`, or younger.
fn mentions_from(step: &Step, root: LocalId) -> bool {
    step.indices().any(|index| {
        index.any_expr(|it| matches!(&it.kind, ExprKind::Load(place) if place.root >= root))
    })
}

/// Puts an array in the place of what stands for it.
struct Put {
    stands: LocalId,
    lender: Place,
    /// Whether what lends is the one element itself.
    whole: bool,
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
