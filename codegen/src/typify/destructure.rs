//! `let` with a pattern: what is taken apart, and what of a tuple that is never made.

use bessemer_ir::tree::{self, NO_SLOT};
use bessemer_ir::{Block, Local, LocalId, Mode, StmtKind};

use super::Result;
use super::lowering::Lowering;
use super::pattern::aligned;
use super::value::Value;

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
            let then = self.block_effect(otherwise)?;
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
                let slice = self.naming_as(&**name, |inner| inner.sliced(value))?;
                let slice = self.kept_elements(slice);
                bound.push((name.clone(), Value::Slice(Box::new(slice))));
                Ok(())
            }
            (tree::Pattern::Name { name, slot, inner: None, .. }, _)
                if !self.slot_is_reference(*slot, value.site)? =>
            {
                let ty = self.slot(*slot, value.site)?;
                let lowered = self.naming_as(&**name, |inner| inner.value(value, Some(&ty)))?;
                self.agree(&lowered.ty, &ty, value.site)?;
                let local = LocalId(self.locals.len() as u32);
                let span = lowered.span;
                self.locals.push(Local { name: name.clone(), ty, mode: Mode::Value, span });
                self.emit(StmtKind::Let { local, value: Some(lowered) }, span);
                bound.push((name.clone(), Value::Local(local)));
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
}
