//! `let` with a pattern: what is taken apart; and tuples that are never made: the items of `zip` and `enumerate` under one
//! name, in functions that stand where they are called. The name means the parts, side by side; only where it is used as a
//! value, one is made of them.

use bessemer_ir::tree::{self, NO_SLOT, Site};
use bessemer_ir::{Block, Expr, ExprKind, StmtKind, Type};

use super::lowering::Lowering;
use super::pattern::aligned;
use super::value::Value;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// `let pattern = value;`
    pub(super) fn take_apart(
        &mut self,
        pattern: &tree::Pattern,
        value: &tree::Expr,
        otherwise: Option<&tree::Block>,
    ) -> Result<()> {
        let mut names = Vec::new();
        if let (None, tree::Pattern::Tuple(_), tree::ExprKind::Tuple(_)) =
            (otherwise, pattern, &value.kind)
        {
            return self.take_each(pattern, value);
        }
        if let tree::Pattern::Any = pattern {
            return self.effect(value);
        }
        let subject = self.subject_of(pattern, value)?;
        let condition = self.test(pattern, &subject, value.site, &mut names)?;
        if let (Some(condition), Some(otherwise)) = (condition, otherwise) {
            let span = condition.span;
            let then = self.block(otherwise, None)?;
            let condition = condition.negated();
            self.branch(condition, then, Block::default(), span);
        }
        self.bind_names(&names)
    }

    /// `let (a, b) = (x, y);`: each in a local of its own before the next is computed.
    fn take_each(&mut self, pattern: &tree::Pattern, value: &tree::Expr) -> Result<()> {
        let mut bound = Vec::new();
        self.take_part(pattern, value, &mut bound)?;
        // The names mean what they are given only behind the `let`.
        for (name, binding) in bound {
            self.bind(&name, binding);
        }
        Ok(())
    }

    fn take_part(
        &mut self,
        pattern: &tree::Pattern,
        value: &tree::Expr,
        bound: &mut Vec<(String, Value)>,
    ) -> Result<()> {
        match (pattern, &value.kind) {
            (tree::Pattern::Tuple(patterns), tree::ExprKind::Tuple(values)) => {
                let mut pairs = aligned(patterns, values.len()).into_iter().peekable();
                for (index, value) in values.iter().enumerate() {
                    match pairs.next_if(|(_, at)| *at == index) {
                        Some((pattern, _)) => self.take_part(pattern, value, bound)?,
                        None => self.take_part(&tree::Pattern::Any, value, bound)?,
                    }
                }
                Ok(())
            }
            (tree::Pattern::Any, _) => {
                let value = self.value(value, None)?;
                let span = value.span;
                self.emit(StmtKind::Expr(value), span);
                Ok(())
            }
            (_, _) if self.holds_nothing(value) => {
                self.effect(value)?;
                let mut names = Vec::new();
                Self::take_nothing(pattern, value.site, &mut names);
                bound.extend(names.into_iter().map(|named| (named.name, Value::Nothing)));
                Ok(())
            }
            (tree::Pattern::Name { name, slot, inner: None, .. }, _)
                if *slot != NO_SLOT && self.slot_is_slice(*slot, value.site)? =>
            {
                bound.push((name.clone(), self.slice_for(name, value)?));
                Ok(())
            }
            (tree::Pattern::Name { name, slot, inner: None, .. }, _)
                if !self.slot_is_reference(*slot, value.site)? =>
            {
                let ty = self.slot(*slot, value.site)?;
                let lowered = self.naming_as(&**name, |inner| inner.value(value, Some(&ty)))?;
                self.agree(&lowered.ty, &ty, value.site)?;
                let place = self.let_local(&**name, lowered);
                bound.push((name.clone(), Value::Local(place.root)));
                Ok(())
            }
            _ => {
                let mut names = Vec::new();
                let subject = self.subject(value)?;
                self.test(pattern, &subject, value.site, &mut names)?;
                let given: Vec<_> = names.iter().map(|named| named.name.clone()).collect();
                self.naming_scope(|inner| {
                    inner.bind_names(&names)?;
                    for name in given {
                        bound.push((name.clone(), inner.lookup(&name, value.site)?));
                    }
                    Ok(())
                })
            }
        }
    }

    /// The value of a tuple that is never made, under its name.
    pub(super) fn made(&mut self, tuple: &Value, site: Site) -> Result<Expr> {
        let made = match tuple {
            Value::Tuple(_, Some(ty)) => self.whole(tuple, ty, site),
            _ => None,
        };
        let Some(made) = made else {
            return problem(
                site,
                "a tuple with a slice in it, or with what may be changed, is not made in the DSL",
                "take it apart where it is named: `|(a, b)| …`",
            );
        };
        Ok(made)
    }

    /// The value of a tuple, if its parts are values.
    fn whole(&mut self, tuple: &Value, ty: &Type, site: Site) -> Option<Expr> {
        match (tuple, ty) {
            (Value::Place(_), _) => self.lent_value(tuple.clone(), ty, site).ok(),
            (Value::Tuple(parts, _), Type::Struct(id)) => {
                let fields = self.cx.fields(*id).to_vec();
                let parts = parts.iter().zip(&fields);
                let parts = parts.map(|(part, field)| self.whole(part, &field.ty, site));
                let kind = ExprKind::Struct(parts.collect::<Option<_>>()?);
                Some(Expr { kind, ty: ty.clone(), span: self.span(site) })
            }
            _ => None,
        }
    }

    /// The parts of such a tuple, if an expression names it.
    pub(super) fn parts_named(&self, expr: &tree::Expr) -> Option<Value> {
        match &expr.kind {
            tree::ExprKind::Local(name) => {
                self.lookup(name, expr.site).ok().filter(|it| matches!(it, Value::Tuple(..)))
            }
            tree::ExprKind::Ref(_, inner) => self.parts_named(inner),
            _ => None,
        }
    }
}
