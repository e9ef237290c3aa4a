//! Methods of `Option` and `Result`: a test, a copy, or a check that the payload exists.

use bessemer_ir::tree::{self, OptionMethod, Site};
use bessemer_ir::{Block, Expr, Fault, Place, Span, StmtKind, StructId, Type};

use super::expr::{Call, Operand};
use super::lowering::Lowering;
use super::words;
use super::{Needed, OUR_FAULT, Result, problem, refusals, refused, struct_of};

impl Lowering<'_, '_> {
    /// Lowers a method of `Option` or `Result`.
    pub(super) fn option_method(&mut self, method: OptionMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        use OptionMethod as M;
        match method {
            M::Unwrap | M::UnwrapErr => {
                self.payload_needed(method, call)?.or_refused(expr.site, refusals::STATEMENT)
            }
            M::Copied => self.value(&arguments[0], None),
            M::Take | M::Replace => self.exchanged(arguments, expr),
            M::UnwrapOr | M::Or | M::And | M::OkOr | M::Ok | M::Err => self.chosen(method, call),
            // A place stays where it is: each use that takes it has tested it before.
            M::AsMut | M::Insert | M::GetOrInsert | M::GetOrInsertWith => {
                refused(expr.site, refusals::LENT_BY_OPTION)
            }
        }
    }

    /// The condition that an `Option` or a `Result` is `Some` or `Ok` (`Err` if `error`), and the payload's place unless it is
    /// zero-sized. None if the type has no such variant.
    pub(super) fn present(&mut self, place: &Place, error: bool) -> Option<(Expr, Option<Place>)> {
        let Type::Struct(id) = place.ty else { return None };
        let name = if error { "Err" } else { self.going_on(id)? };
        let (word, case) = self.case(id, name)?;
        let held = case.field.map(|field| self.part(place, id, field as usize));
        Some((self.tag_is(place, id, word), held))
    }

    /// Lowers `unwrap`: a check, then the payload; none if it is zero-sized.
    pub(super) fn payload_needed(
        &mut self,
        method: OptionMethod,
        call: Call<'_>,
    ) -> Result<Option<Expr>> {
        let Call { arguments, expr } = call;
        if method == OptionMethod::Unwrap
            && let Some(whole) = self.unwrapped_whole(&arguments[0])?
        {
            return Ok(Some(whole));
        }
        let place = self.held(&arguments[0])?;
        let held = self.unwrapped(&place, method == OptionMethod::UnwrapErr, expr.site)?;
        Ok(held.map(|held| held.load()))
    }

    /// Emits the check that the variant is `Some`, `Ok` or (with `error`) `Err`, and returns the payload's place
    /// unless it is zero-sized.
    pub(super) fn unwrapped(
        &mut self,
        place: &Place,
        error: bool,
        site: Site,
    ) -> Result<Option<Place>> {
        let (there, held) = self.present(place, error).needed(site, "this is not an `Option`")?;
        let span = self.span(site);
        self.check(there, Fault::Absent, span);
        Ok(held)
    }

    /// Lowers `take` and `replace`: returns the old value, and stores `None` or the new one.
    fn exchanged(&mut self, arguments: &[tree::Expr], expr: &tree::Expr) -> Result<Expr> {
        let span = self.span(expr.site);
        let place = self.place(&arguments[0])?.or_refused(expr.site, refusals::PLACE)?;
        let id = struct_of(&place.ty, expr.site, "an `Option`")?;
        let next = match arguments.get(1) {
            None => self.choice(id, 0, None, expr.site)?,
            Some(value) => {
                let held = self.payload_type(id, "Some");
                let value = self.value(value, held.as_ref())?;
                let value = self.atom(words::VALUE, value);
                self.choice(id, 1, Some(value), expr.site)?
            }
        };
        let before = self.atom("before", place.load());
        self.emit(StmtKind::Assign { place, value: next }, span);
        Ok(before)
    }

    pub(super) fn payload_type(&self, id: StructId, case: &str) -> Option<Type> {
        let field = self.case(id, case)?.1.field?;
        Some(self.cx.field_type(id, field))
    }

    /// Lowers methods such as `unwrap_or`, whose result is the payload or an alternative.
    fn chosen(&mut self, method: OptionMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        use OptionMethod as M;
        let site = expr.site;
        let ty = self.slot_of(expr)?;
        let other = match (method, &ty) {
            (M::UnwrapOr, _) => Some(ty.clone()),
            (M::OkOr, Type::Struct(id)) => self.payload_type(*id, "Err"),
            _ => None,
        };
        let mut operands = vec![Operand { expr: &arguments[0], expected: None, role: "left" }];
        if let Some(argument) = arguments.get(1) {
            operands.push(Operand { expr: argument, expected: other, role: "right" });
        }
        let mut values = self.operands(&operands)?.into_iter();
        let (Some(first), second) = (values.next(), values.next()) else {
            return problem(site, "this takes an `Option`", OUR_FAULT);
        };
        let place = self.hold(first);
        let (mut there, value) =
            self.present(&place, method == M::Err).needed(site, "this is not an `Option`")?;
        let value = value.map(|value| value.load());
        let (otherwise, then) = match (method, &ty, second) {
            (M::UnwrapOr, _, Some(second)) => (second, value),
            (M::Or, _, Some(second)) => (second, Some(place.load())),
            (M::And, Type::Struct(result), Some(second)) => {
                there = there.negated();
                let error = self.present(&place, true).and_then(|(_, error)| error);
                let error = error.map(|error| error.load());
                (second, Some(self.choice(*result, 0, error, site)?))
            }
            (M::OkOr, Type::Struct(result), second) => {
                let ok = self.choice(*result, 1, value, site)?;
                (self.choice(*result, 0, second, site)?, Some(ok))
            }
            (M::Ok | M::Err, Type::Struct(result), _) => {
                let some = self.choice(*result, 1, value, site)?;
                (self.choice(*result, 0, None, site)?, Some(some))
            }
            _ => return problem(site, "this is not an `Option`", OUR_FAULT),
        };
        let then = then.or_refused(site, refusals::EMPTY_CHOICE)?;
        let span = self.span(site);
        Ok(self.either("choice", otherwise, (there, then), span))
    }

    /// Returns a value, or `other` if the condition holds.
    pub(super) fn either(
        &mut self,
        role: &str,
        value: Expr,
        (condition, other): (Expr, Expr),
        span: Span,
    ) -> Expr {
        let place = self.assigned(role, value);
        self.locals.note_unnamed(place.root);
        let held = place.load();
        let assign = StmtKind::Assign { place, value: other };
        self.follow(&assign);
        self.emit_if(condition, Block::of(assign, span), span);
        held
    }
}
