//! Conversions between slices and values: slices in structs, variants, tuples and results are read and constructed
//! here.
//!
//! Invariant: a slice that was read does not change when its place is written later.
//!
//! Must not know: how lenders are followed ([`lenders`](super::lenders)).

use bessemer_ir::tree::{self, Site, Ty};
use bessemer_ir::visit::{self, VisitMut};
use bessemer_ir::{Block, Expr, ExprKind, Place, Step, StmtKind, StructId, Type};

use super::borrowed::spot_of;
use super::context::Borrowed;
use super::lenders::{FROM, LENGTH};
use super::locals::Locals;
use super::lowering::{Lowering, UNNAMED, local_since};
use super::syntax::control_with_value;
use super::value::{Slice, Value};
use super::words;
use super::{Needed, OUR_FAULT, Result, problem, refusals, refused};
use bessemer_ir::effects;

impl Lowering<'_, '_> {
    /// Returns the slice at a place whose type represents one.
    pub(super) fn slice_at(&mut self, place: Place, site: Site) -> Result<Option<Slice>> {
        let Some((_, borrowed)) = self.cx.as_borrowed(&place.ty) else { return Ok(None) };
        let borrowed = borrowed.clone();
        let base = self.lender_of(&place).unwrap_or_else(|| self.awaited(&place, &borrowed, site));
        let Borrowed { element, one, .. } = borrowed;
        let part = |at: u32| place.inside(Step::Field(at), Type::USIZE).load();
        let length = if one { Expr::usize(1, place.span) } else { part(LENGTH) };
        let (mut from, mut length) = (part(FROM), length);
        // The slice stays what it is, whatever is written to the place.
        let field = if one { None } else { self.field_name(&place) };
        let name = field.unwrap_or_else(|| self.locals[place.root.index()].name.clone());
        let roles = if one { words::ENDS_OF_ONE } else { words::ENDS };
        let parts = [&mut from, &mut length].into_iter().zip(roles);
        for (part, role) in parts.filter(|(part, _)| !part.is_literal()) {
            if let ExprKind::Load(of) = part.kind.clone() {
                let before = self.locals.len();
                let held = self.naming_as(&*name, |inner| inner.constant_place(role, of));
                let copy = local_since(&held, before);
                copy.into_iter().for_each(|copy| self.locals.note_optional(copy));
                *part = held.load();
            }
        }
        Ok(Some(Slice::whole(base, element, length.clone()).part(from, length)))
    }

    /// Returns the name of the last field of a place.
    fn field_name(&self, place: &Place) -> Option<String> {
        let (Step::Field(at), outer) = place.steps.split_last()? else { return None };
        match self.type_of(place.root, outer) {
            Type::Struct(id) => Some(self.cx.fields(id)[*at as usize].name.clone()),
            _ => None,
        }
    }

    /// Lowers an expression to a slice as a value, if `expected` represents one; none otherwise.
    pub(super) fn wanted_slice(
        &mut self,
        expr: &tree::Expr,
        expected: Option<&Type>,
    ) -> Result<Option<Expr>> {
        let slice = expected.and_then(|ty| self.cx.as_borrowed(ty));
        let Some((id, one)) = slice.map(|(id, it)| (id, it.one)) else { return Ok(None) };
        if control_with_value(expr) {
            return Ok(None);
        }
        if one {
            let element = self.base(expr)?;
            return self.element_value(element, id, expr.site).map(Some);
        }
        if let tree::ExprKind::Ref(_, inner) = &expr.kind
            && let tree::ExprKind::Array(elements) = &inner.kind
            && elements.is_empty()
        {
            // Of no array: nothing is read.
            let span = self.span(expr.site);
            return Ok(Some(self.zero(&Type::Struct(id), span)));
        }
        let slice = self.sliced(expr)?;
        Ok(Some(self.borrowed_value(slice, id, expr.site)))
    }

    /// Returns the element or place to which a `&mut T` in a value refers; none for another place.
    pub(super) fn element_lent(&mut self, place: &Place, site: Site) -> Result<Option<Place>> {
        let Some((_, Borrowed { element, one: true, .. })) = self.cx.as_borrowed(&place.ty) else {
            return Ok(None);
        };
        if let Some(lender) = self.lender_of(place).filter(|lender| lender.ty == *element) {
            return Ok(Some(lender));
        }
        let slice = self.slice_at(place.clone(), site)?;
        Ok(slice.map(|slice| slice.at(slice.from.clone())))
    }

    /// Returns the place itself, or the element to which a `&mut T` there refers.
    pub(super) fn followed(&mut self, place: Place, site: Site) -> Result<Place> {
        Ok(self.element_lent(&place, site)?.unwrap_or(place))
    }

    /// Returns the type itself, or the element type of a `&mut T`.
    pub(super) fn type_behind(&self, ty: Type) -> Type {
        match self.cx.as_borrowed(&ty) {
            Some((_, Borrowed { element, one: true, .. })) => element.clone(),
            _ => ty,
        }
    }

    /// Returns the value of a `&mut T` to a place: the index of an array's element. Any other place is its own
    /// lender, with index 0.
    fn element_value(&mut self, place: Place, id: StructId, site: Site) -> Result<Expr> {
        if place.ty == Type::Struct(id) {
            return Ok(place.load());
        }
        if self.type_behind(Type::Struct(id)) != place.ty {
            return problem(site, "this is not what is lent here", OUR_FAULT);
        }
        let one = Expr::usize(1, place.span);
        let mut base = place.clone();
        let step = base.steps.pop();
        base.ty = self.type_of(base.root, &base.steps);
        let (base, from) = match (step, &base.ty) {
            (Some(Step::Index(from)), Type::Array { .. } | Type::Slice(_)) => (base, from),
            _ => (place.clone(), Expr::usize(0, place.span)),
        };
        let slice = Slice::whole(base, place.ty, one.clone()).part(from, one);
        Ok(self.borrowed_value(slice, id, site))
    }

    /// Returns a slice as a value: its first index and its length.
    fn borrowed_value(&mut self, slice: Slice, id: StructId, site: Site) -> Expr {
        let span = self.span(site);
        if let (ExprKind::Load(from), ExprKind::Load(length)) =
            (&slice.from.kind, &slice.length.kind)
            && let (Some((Step::Field(FROM), whole)), Some((Step::Field(LENGTH), rest))) =
                (from.steps.split_last(), length.steps.split_last())
            && from.root == length.root
            && whole == rest
        {
            let of = Place { root: from.root, steps: whole.to_vec(), ty: Type::Struct(id), span };
            if self.lender_of(&of).is_some_and(|it| effects::same_place(&it, &slice.base)) {
                return of.load();
            }
        }
        let one = self.cx.types.borrowed.get(&id).is_some_and(|it| it.one);
        let parts = if one { vec![slice.from] } else { vec![slice.from, slice.length] };
        let kind = ExprKind::Struct(parts);
        let value = Expr { kind, ty: Type::Struct(id), span };
        let known = self.lenders.made.iter().find(|(made, _)| *made == value);
        match known.map(|(_, base)| effects::same_place(base, &slice.base)) {
            None => self.lenders.made.push((value.clone(), slice.base)),
            Some(true) => {}
            // Two of one shape differ by their names.
            Some(false) => {
                let place = self.assigned(UNNAMED, value);
                let spot = spot_of(&place);
                self.lenders.known.retain(|it| it.0 != spot);
                self.lenders.known.push((spot, slice.base));
                return place.load();
            }
        }
        value
    }

    /// Converts the result of a borrowing method, or the meaning of a name, to a value of type `ty`.
    pub(super) fn lent_value(&mut self, lent: Value, ty: &Type, site: Site) -> Result<Expr> {
        let span = self.span(site);
        match (lent, ty) {
            (Value::Place(place), _) => match self.cx.as_borrowed(ty) {
                Some((id, Borrowed { one: true, .. })) => self.element_value(place, id, site),
                _ => Ok(place.load()),
            },
            (Value::Word(word), _) => Ok(*word),
            (Value::Slice(slice), Type::Struct(id)) => Ok(self.borrowed_value(*slice, *id, site)),
            (Value::Tuple(parts, _), Type::Struct(id)) => {
                let fields = self.cx.fields(*id).to_vec();
                let mut values = Vec::new();
                for (part, field) in parts.into_iter().zip(&fields) {
                    values.push(self.lent_value(part, &field.ty, site)?);
                }
                self.node(ExprKind::Struct(values), ty.clone(), site)
            }
            (Value::Maybe(there, lent), Type::Struct(id)) => {
                let inner =
                    self.payload_type(*id, "Some").needed(site, "this is not an `Option`")?;
                // Of an array it is known.
                if there.kind == ExprKind::Literal(1) {
                    let value = self.lent_value(*lent, &inner, site)?;
                    return self.choice(*id, 1, Some(value), site);
                }
                let none = self.choice(*id, 0, None, site)?;
                let place = self.assigned(words::FOUND, none);
                let held = place.load();
                let then = self.scoped(|it| {
                    let value = it.lent_value(*lent, &inner, site)?;
                    let value = it.choice(*id, 1, Some(value), site)?;
                    it.emit(StmtKind::Assign { place, value }, span);
                    Ok(())
                })?;
                self.emit_if(there, then, span);
                Ok(held)
            }
            _ => refused(site, refusals::TUPLE_MADE),
        }
    }

    /// Removes declarations of temporaries that nothing reads.
    pub(super) fn leave_unasked(&self, body: &mut Block) {
        Unasked(&self.locals).block(body);
    }

    /// Gives a slice parameter that is assigned later a local for its present beginning and length.
    pub(super) fn rebound(&mut self, name: &str, slot: u32, site: Site) -> Result<()> {
        let ty = self.slot(slot, site)?;
        let local = tree::Expr::local(name, site);
        let (value, span) = (self.value(&local, Some(&ty))?, self.span(site));
        let local = self.let_named(&format!("{name}_left"), value, span);
        self.bind(name, Value::Local(local));
        Ok(())
    }

    /// Copies a slice whose base is a loan, since the value that holds the loan may be assigned another one.
    pub(super) fn kept_elements(&mut self, slice: Slice) -> Slice {
        if !self.is_loan(&slice.base) {
            return slice;
        }
        let name = self.field_name(&slice.base).unwrap_or_else(|| UNNAMED.into());
        let base = self.hold_copy(&name, slice.base.clone());
        Slice { base, ..slice }
    }

    /// Returns the type of an expression, if it contains slices.
    pub(super) fn borrowing_type(&mut self, expr: &tree::Expr) -> Option<Type> {
        if !borrows(self.seen_as(expr)?) {
            return None;
        }
        self.seen(expr.slot?, expr.site).ok().filter(|ty| !self.cx.slices_in(ty).is_empty())
    }
}

/// Returns true if a type has a slice in it, or may have one element, by its syntax.
fn borrows(ty: &Ty) -> bool {
    match ty {
        Ty::Tuple(parts) => parts.iter().any(borrows),
        Ty::Option(inner) => matches!(**inner, Ty::Ref(_, true)) || borrows(inner),
        Ty::Ref(inner, _) => borrows(inner),
        Ty::Slice(_) => true,
        _ => false,
    }
}

/// Removes the declarations of locals that no later statement mentions.
struct Unasked<'l>(&'l Locals);

impl VisitMut for Unasked<'_> {
    fn block(&mut self, block: &mut Block) {
        for at in (0..block.0.len()).rev() {
            if let StmtKind::Let { local, .. } = &block.0[at].kind
                && self.0.is_optional(*local)
                && !effects::mentions(&block.0[at + 1..], *local)
            {
                block.0.remove(at);
            }
        }
        visit::walk_block_mut(self, block);
    }
}
