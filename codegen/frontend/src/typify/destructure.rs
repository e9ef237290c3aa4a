//! Lowers `let` with a pattern, and tuples that are never built, such as the items of `zip` and `enumerate` in
//! expanded functions. A name of such a tuple denotes its parts; the tuple is built only if it is used as a value.

use std::borrow::Cow;
use std::cell::RefCell;

use bessemer_ir::tree::{self, ExprKind as Tree, NO_SLOT, Pattern, Site};

use super::Result;
use super::lowering::Lowering;
use super::pattern::{Test, aligned};
use super::syntax::either;
use super::value::Value;

/// A `let name = value;`.
#[derive(Clone, Copy)]
pub(super) struct Let<'t> {
    pub name: &'t str,
    pub slot: u32,
    pub value: Option<&'t tree::Expr>,
    pub site: Site,
    pub mutable: bool,
}

impl Lowering<'_, '_> {
    /// Lowers `let name = value;`.
    pub(super) fn let_stmt(&mut self, it: Let) -> Result<()> {
        let Let { name, slot, value, site, mutable } = it;
        let whole = Pattern::Name { name: name.to_owned(), slot, mutable: false, inner: None };
        if !value.map_or(Ok(false), |value| self.take_tried(&whole, value))? {
            self.give_name(it)?;
        }
        if mutable && let Value::Local(local) = self.lookup(name, site)? {
            self.note_changing(local, slot);
        }
        Ok(())
    }

    /// Lowers `let pattern = value;`.
    pub(super) fn take_apart(
        &mut self,
        pattern: &Pattern,
        value: &tree::Expr,
        otherwise: Option<&tree::Block>,
    ) -> Result<()> {
        match (otherwise, pattern, &value.kind) {
            (None, Pattern::Tuple(_), Tree::Tuple(_)) => return self.take_each(pattern, value),
            (None, ..) if self.take_tried(pattern, value)? => return Ok(()),
            (_, Pattern::Any, _) => return self.effect(value),
            _ => {}
        }
        let subject = self.subject_of(pattern, value)?;
        self.name_own(pattern, &subject, None);
        self.bind_or(pattern, &subject, value.site, |inner| {
            otherwise.map(|otherwise| inner.block(otherwise, None)).transpose()
        })
    }

    /// Lowers `let (a, b) = (x, y);`: each part is stored in a local before the next is evaluated.
    fn take_each(&mut self, pattern: &Pattern, value: &tree::Expr) -> Result<()> {
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
        pattern: &Pattern,
        value: &tree::Expr,
        bound: &mut Vec<(String, Value)>,
    ) -> Result<()> {
        match (pattern, &value.kind) {
            (Pattern::Tuple(patterns), Tree::Tuple(values)) => {
                let mut pairs = aligned(patterns, values.len()).into_iter().peekable();
                for (index, value) in values.iter().enumerate() {
                    match pairs.next_if(|(_, at)| *at == index) {
                        Some((pattern, _)) => self.take_part(pattern, value, bound)?,
                        None => self.take_part(&Pattern::Any, value, bound)?,
                    }
                }
                Ok(())
            }
            (Pattern::Any, _) => self.effect(value),
            // What a block lends is found where the block is lowered, by the subject below.
            (&Pattern::Name { ref name, slot, mutable, inner: None }, _)
                if slot != NO_SLOT
                    && (self.slot_is_slice(slot, value.site)?
                        || !self.slot_is_reference(slot, value.site)?) =>
            {
                self.naming_scope(|inner| {
                    let (site, value) = (value.site, Some(value));
                    inner.let_stmt(Let { name, slot, value, site, mutable })?;
                    bound.push((name.clone(), inner.lookup(name, site)?));
                    Ok(())
                })
            }
            _ => {
                let subject = self.subject(value)?;
                let names = self.test(pattern, &subject, value.site)?.names;
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

    /// Returns the parts of an unbuilt tuple that an expression names.
    pub(super) fn parts_named(&self, expr: &tree::Expr) -> Option<Value> {
        self.meaning_lent(expr).filter(|it| matches!(it, Value::Tuple(..)))
    }

    /// Lowers `let name = match lent { Some(x) => x, None => return 0 };`, where `x` refers to a place. All arms but
    /// one leave, so the name denotes the place of that arm. Returns true if a value has this form.
    pub(super) fn alias_of_arm(
        &mut self,
        (name, slot): (&str, u32),
        value: &tree::Expr,
        site: Site,
    ) -> Result<bool> {
        let (subject, arms) = match &value.kind {
            Tree::Match(subject, arms) => (subject, Cow::Borrowed(&arms[..])),
            Tree::If(condition, then, otherwise @ Some(_))
                if let Tree::Let(pattern, subject) = &condition.kind =>
            {
                let arms = either(pattern, then, otherwise.as_deref(), value.site);
                (subject, Cow::Owned(arms.into()))
            }
            _ => return Ok(false),
        };
        let stays = |arm: &tree::Arm| !leaves(&arm.body);
        let mut staying = arms.iter().filter(|arm| stays(arm));
        let (Some(stay), None) = (staying.next(), staying.next()) else { return Ok(false) };
        if arms.iter().any(|arm| arm.guard.is_some()) {
            return Ok(false);
        }
        let (subject, span) = (self.subject_of(&stay.pattern, subject)?, self.span(site));
        let given = RefCell::new(Value::Nothing);
        self.arms_by_conditions(&arms, span, Some(&stays), &|inner, arm, last| {
            let Test { condition, names } = inner.test(&arm.pattern, &subject, site)?;
            let then = inner.scoped(|inner| {
                inner.bind_names(&names)?;
                if !stays(arm) {
                    return inner.effect(&arm.body);
                }
                let mut body = &arm.body;
                while let Tree::Block(tree::Block { stmts, tail: Some(tail) }) = &body.kind {
                    inner.stmts(&tree::Block { stmts: stmts.clone(), tail: None })?;
                    body = tail;
                }
                inner.alias((name, slot), Some(body), site)?;
                given.replace(inner.lookup(name, site)?);
                Ok(())
            })?;
            Ok((condition.filter(|_| !last), then))
        })?;
        self.bind(name, given.into_inner());
        Ok(true)
    }
}

/// Returns true if control always leaves the block by an expression.
fn leaves(expr: &tree::Expr) -> bool {
    let block = |block: &tree::Block| match (&block.tail, block.stmts.last()) {
        (Some(tail), _) => leaves(tail),
        (None, Some(tree::Stmt::Expr(last))) => leaves(last),
        _ => false,
    };
    match &expr.kind {
        Tree::Return(_) | Tree::Break(..) | Tree::Continue(_) => true,
        Tree::Assert(condition, _) => matches!(condition.kind, Tree::Bool(false)),
        Tree::Block(it) => block(it),
        Tree::If(_, then, Some(otherwise)) => block(then) && leaves(otherwise),
        Tree::Match(_, arms) => arms.iter().all(|arm| leaves(&arm.body)),
        _ => false,
    }
}
