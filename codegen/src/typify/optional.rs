//! Methods of `Option` that return references: `insert`, `get_or_insert`, `as_mut`. Nothing is copied: the reference is
//! another name for the content.

use bessemer_ir::tree::{self, Builtin, OptionMethod};
use bessemer_ir::{Block, Fault, Place, Stmt, StmtKind, StructId, Type};

use super::lowering::Lowering;
use super::{OUR_FAULT, Result, order, problem};

impl Lowering<'_, '_> {
    /// The place in an `Option` that a call lends; none if the call is something else.
    pub(super) fn in_option(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        let Some((Builtin::Option(method), arguments)) = self.builtin_call(expr) else {
            return Ok(None);
        };
        match (method, arguments) {
            (OptionMethod::Insert, [option, value]) => {
                let value = Some(value);
                self.filled((option, value, None), false, expr).map(Some)
            }
            (OptionMethod::GetOrInsert, [option, value]) => {
                self.filled((option, Some(value), None), true, expr).map(Some)
            }
            (OptionMethod::GetOrInsertWith, [option, value]) => {
                self.filled((option, None, Some(value)), true, expr).map(Some)
            }
            (OptionMethod::Unwrap, [lent]) => match self.option_lent(lent)? {
                Some(place) => {
                    let (id, word, field) = self.held_in(&place, expr)?;
                    let (condition, span) = (self.tag_is(&place, id, word), self.span(expr.site));
                    self.emit(StmtKind::Check { condition, fault: Fault::Absent }, span);
                    Ok(Some(self.part(&place, id, field)))
                }
                None => Ok(None),
            },
            _ => Ok(None),
        }
    }

    /// The `Option` that `as_mut` is called of; none if `expr` is something else.
    pub(super) fn option_lent(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        match self.builtin_call(expr) {
            Some((Builtin::Option(OptionMethod::AsMut), [option])) => {
                self.settled(option).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// A place that stays the same whatever comes; its indices have been looked at.
    fn settled(&mut self, expr: &tree::Expr) -> Result<Place> {
        match self.place(expr)? {
            Some(mut place) => {
                self.fix(&mut place);
                Ok(place)
            }
            None => problem(expr.site, "this is not a place", "keep it in a variable"),
        }
    }

    /// The struct of an `Option`, the word of `Some`, and the field of what is in it.
    fn held_in(&mut self, place: &Place, expr: &tree::Expr) -> Result<(StructId, u64, usize)> {
        let Type::Struct(id) = place.ty else {
            return problem(expr.site, "this is not an `Option`", OUR_FAULT);
        };
        match self.case(id, "Some").map(|(word, case)| (word, case.field)) {
            Some((word, Some(field))) => Ok((id, word, field as usize)),
            _ => problem(expr.site, "there is nothing to this value", "keep a `bool`"),
        }
    }

    /// Puts a value into an `Option`, or what a closure computes; `unless` there is one.
    fn filled(
        &mut self,
        (option, value, closure): (&tree::Expr, Option<&tree::Expr>, Option<&tree::Expr>),
        unless: bool,
        expr: &tree::Expr,
    ) -> Result<Place> {
        let place = self.settled(option)?;
        let (id, word, field) = self.held_in(&place, expr)?;
        let (there, span) = (self.part(&place, id, field), self.span(expr.site));
        let value = match value {
            Some(value) => {
                let value = self.value(value, Some(&there.ty))?;
                // It is computed whether it is wanted or not.
                let free = !unless || order::is_free(&value);
                Some(if free { value } else { self.temporary("value", value) })
            }
            None => None,
        };
        let Block(put) = self.scoped(|inner| {
            let value = match (value, closure.map(|it| &it.kind)) {
                (Some(value), _) => value,
                (None, Some(tree::ExprKind::Closure(it))) => {
                    inner.value(&it.body, Some(&there.ty))?
                }
                _ => return problem(expr.site, "this takes a closure", "write `|| …`"),
            };
            inner.agree(&value.ty, &there.ty, expr.site)?;
            let value = inner.choice(id, word, Some(value), expr.site)?;
            inner.emit(StmtKind::Assign { place: place.clone(), value }, span);
            Ok(())
        })?;
        if unless {
            let condition = self.tag_is(&place, id, word).negated();
            let kind = StmtKind::If { condition, then: Block(put), otherwise: Block::default() };
            self.out.push(Stmt::new(kind, span));
        } else {
            self.out.extend(put);
        }
        Ok(there)
    }
}
