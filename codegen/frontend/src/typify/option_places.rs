//! Methods of `Option` that return references: `insert`, `get_or_insert`, `as_mut`. Nothing is copied: the reference
//! is an alias of the payload.

use bessemer_ir::tree::{self, Builtin, ExprKind as Tree, OptionMethod, Pattern, Ty};
use bessemer_ir::{Block, Place, StmtKind};

use super::borrowed::is_element;
use super::lowering::Lowering;
use super::order::syntax::is_plain;
use super::{Needed, Result, refusals, refused, struct_of};

/// Hidden name of the place to which `option?` refers.
const TRIED: &str = "__tried";

impl Lowering<'_, '_> {
    /// Returns the place in an `Option` to which a call's result refers; none for another call.
    pub(super) fn in_option(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        let Some((Builtin::Option(method), arguments)) = self.builtin_call(expr) else {
            return Ok(None);
        };
        match (method, arguments) {
            (
                OptionMethod::Insert | OptionMethod::GetOrInsert | OptionMethod::GetOrInsertWith,
                [option, value],
            ) => self.filled(method, option, value, expr).map(Some),
            (OptionMethod::Unwrap, [lent]) => {
                let option = self.option_lent(lent)?;
                let by_itself = option.is_some();
                let place = match option {
                    Some(place) => place,
                    None if self.may_lend_element(lent) => self.base(lent)?,
                    None => return Ok(None),
                };
                let held = self.unwrapped(&place, false, expr.site)?;
                let held = held.or_refused(expr.site, refusals::EMPTY_OPTION)?;
                if by_itself { Ok(Some(held)) } else { self.element_lent(&held, expr.site) }
            }
            _ => Ok(None),
        }
    }

    /// Returns true if the type of an expression is `Option<&mut T>`.
    fn may_lend_element(&self, expr: &tree::Expr) -> bool {
        matches!(self.seen_as(expr), Some(Ty::Option(value)) if is_element(value))
    }

    /// Returns the `Option` whose `as_mut` an expression calls; none for another expression.
    pub(super) fn option_lent(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        match self.builtin_call(expr) {
            Some((Builtin::Option(OptionMethod::AsMut), [option])) => {
                self.option_place(option).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Returns the option and the early exit of `option?`, also behind `.ok_or(error)`, if the payload is a
    /// reference. Such an option is matched where it is called.
    fn tried_lent(&self, tried: &tree::Expr) -> Option<(tree::Expr, tree::Block)> {
        let Tree::Try(label, operand) = &tried.kind else { return None };
        if !self.seen_as(tried).is_some_and(refers) {
            return None;
        }
        let plain = |kind| tree::Expr::plain(kind, tried.site);
        let Tree::Call(callee, arguments) = &operand.kind else { return None };
        let callee = self.source.callees.get(*callee as usize);
        let arguments = self.written_out(arguments);
        let (lent, case, error) = match (callee, &*arguments, self.seen_as(operand)?) {
            // Of an `Option` and something else, core makes a `Result` in these two alone.
            (Some(_), [lent, error], Ty::Result(..))
                if matches!(self.seen_as(lent), Some(Ty::Option(_))) =>
            {
                let error = match &error.kind {
                    Tree::Closure(closure) => &*closure.body,
                    _ if is_of_names(error) => error,
                    _ => return None,
                };
                (lent, "Err", Some(error))
            }
            (_, _, Ty::Option(_)) => (&**operand, "None", None),
            _ => return None,
        };
        let left = plain(Tree::Constructor(case.into(), error.into_iter().cloned().collect()));
        let left = match label {
            Some(label) => Tree::Break(Some(label.clone()), Some(Box::new(left))),
            None => Tree::Return(Some(Box::new(left))),
        };
        let stmts = vec![tree::Stmt::Expr(plain(left))];
        Some((lent.clone(), tree::Block { stmts, tail: None }))
    }

    /// Lowers `let pattern = option?;` with a reference as payload; returns false for another expression.
    pub(super) fn take_tried(&mut self, pattern: &Pattern, tried: &tree::Expr) -> Result<bool> {
        let Some((lent, otherwise)) = self.tried_lent(tried) else { return Ok(false) };
        let there = Pattern::Constructor("Some".into(), vec![pattern.clone()]);
        self.take_apart(&there, &lent, Some(&otherwise))?;
        Ok(true)
    }

    /// Returns the place to which `option?` refers; none for another expression.
    pub(super) fn tried_place(&mut self, tried: &tree::Expr) -> Result<Option<Place>> {
        if !self.take_tried(&Pattern::name(TRIED), tried)? {
            return self.tried_element(tried);
        }
        let (meaning, span) = (self.lookup(TRIED, tried.site)?, self.span(tried.site));
        Ok(self.place_of(&meaning, span))
    }

    /// Returns the element to which `result?` refers, for a `Result<&mut T, E>`; none for another expression.
    fn tried_element(&mut self, tried: &tree::Expr) -> Result<Option<Place>> {
        let Tree::Try(label, operand) = &tried.kind else { return Ok(None) };
        if !matches!(self.seen_as(operand), Some(Ty::Result(value, _)) if is_element(value)) {
            return Ok(None);
        }
        let Some(value) = self.try_value(label.as_deref(), operand, tried.site)? else {
            return Ok(None);
        };
        let held = self.hold(value);
        self.element_lent(&held, tried.site)
    }

    fn option_place(&mut self, option: &tree::Expr) -> Result<Place> {
        self.place(option)?.or_refused(option.site, refusals::PLACE)
    }

    /// Stores a value, or a closure's result, into an `Option`. Only `insert` replaces an existing payload.
    fn filled(
        &mut self,
        method: OptionMethod,
        option: &tree::Expr,
        given: &tree::Expr,
        expr: &tree::Expr,
    ) -> Result<Place> {
        let unless = method != OptionMethod::Insert;
        let place = self.option_place(option)?;
        let (id, span) = (struct_of(&place.ty, expr.site, "an `Option`")?, self.span(expr.site));
        let Some((is_there, Some(there))) = self.present(&place, false) else {
            return refused(expr.site, refusals::EMPTY_OPTION);
        };
        // What no closure computes is computed whether it is wanted or not.
        let given = &self.written_out(std::slice::from_ref(given))[0];
        let given = match &given.kind {
            Tree::Closure(it) if method == OptionMethod::GetOrInsertWith => Err(&it.body),
            _ if method == OptionMethod::GetOrInsertWith => {
                return refused(expr.site, refusals::CLOSURE_TAKEN);
            }
            _ => {
                let value = self.value(given, Some(&there.ty))?;
                Ok(self.atom("value", value))
            }
        };
        let Block(put) = self.scoped(|inner| {
            let value = given.or_else(|body| inner.value(body, Some(&there.ty)))?;
            inner.agree(&value.ty, &there.ty, expr.site)?;
            let value = inner.choice(id, 1, Some(value), expr.site)?;
            inner.emit(StmtKind::Assign { place: place.clone(), value }, span);
            Ok(())
        })?;
        if unless {
            self.emit_if(is_there.negated(), Block(put), span);
        } else {
            self.out.extend(put);
        }
        Ok(there)
    }
}

/// Returns true if a type is a reference or contains one in a tuple.
fn refers(ty: &Ty) -> bool {
    match ty {
        Ty::Ref(..) => true,
        Ty::Tuple(parts) => parts.iter().any(refers),
        _ => false,
    }
}

/// Returns true if evaluating a value has no effect: a name, a literal, or an aggregate of these.
fn is_of_names(expr: &tree::Expr) -> bool {
    match &expr.kind {
        Tree::Tuple(parts) | Tree::Array(parts) | Tree::Constructor(_, parts) => {
            parts.iter().all(is_of_names)
        }
        Tree::Struct(_, fields, None) => fields.iter().all(|(_, value)| is_of_names(value)),
        _ => is_plain(expr),
    }
}
