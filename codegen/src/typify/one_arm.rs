//! `let x = match lent { Some(x) => x, None => return 0 };`, where `x` refers to a place: all arms but one leave, so the name is
//! that of the place which the one gives.
//!
//! Must not know: how a name stands for a place.

use std::borrow::Cow;

use bessemer_ir::Block;
use bessemer_ir::tree::{self, ExprKind as Tree, Pattern, Site, Stmt};

use super::Result;
use super::lowering::Lowering;
use super::value::Value;

/// A pattern, and what is done with what it takes.
type Arm<'t> = (&'t Pattern, Cow<'t, tree::Expr>);

impl Lowering<'_, '_> {
    /// Gives a name to the place that the only arm gives which does not leave; says whether a value is of that kind.
    pub(super) fn alias_of_arm(
        &mut self,
        name: &str,
        value: &tree::Expr,
        site: Site,
    ) -> Result<bool> {
        let Some((subject, arms)) = arms(value) else { return Ok(false) };
        let mut stay = arms.iter().enumerate().filter(|(_, (_, body))| !leaves(body));
        let (Some((at, (pattern, body))), None) = (stay.next(), stay.next()) else {
            return Ok(false);
        };
        let place = self.naming_scope(|inner| {
            let subject = inner.subject_of(pattern, subject)?;
            inner.leave_by(&arms[..at], &subject, site, false)?;
            let mut names = Vec::new();
            let taken = inner.test(pattern, &subject, site, &mut names)?;
            if let (Some(taken), [_, ..]) = (taken, &arms[at + 1..]) {
                let span = taken.span;
                let others =
                    inner.scoped(|inner| inner.leave_by(&arms[at + 1..], &subject, site, true))?;
                inner.branch(taken.negated(), others, Block::default(), span);
            }
            inner.bind_names(&names)?;
            let mut body = &**body;
            while let Tree::Block(tree::Block { stmts, tail: Some(tail) }) = &body.kind {
                inner.stmts(&tree::Block { stmts: stmts.clone(), tail: None })?;
                body = tail;
            }
            inner.alias(name, Some(body), site)?;
            inner.lookup(name, site)
        })?;
        self.bind(name, place);
        Ok(true)
    }

    /// Leaves by the arm that takes the subject; where they are the last, it is the last arm if none of the others does.
    fn leave_by(&mut self, arms: &[Arm], subject: &Value, site: Site, last: bool) -> Result<()> {
        for (at, (pattern, body)) in arms.iter().enumerate() {
            let mut names = Vec::new();
            let taken = self.test(pattern, subject, site, &mut names)?;
            let then = self.scoped(|inner| {
                inner.bind_names(&names)?;
                inner.effect(body)
            })?;
            match taken.filter(|_| !last || at + 1 < arms.len()) {
                Some(taken) => {
                    let span = taken.span;
                    self.branch(taken, then, Block::default(), span);
                }
                None => {
                    self.out.extend(then.0);
                    break;
                }
            }
        }
        Ok(())
    }
}

/// What is matched, and the arms of a `match` without guards, or of `if let … else`.
fn arms(value: &tree::Expr) -> Option<(&tree::Expr, Vec<Arm<'_>>)> {
    match &value.kind {
        Tree::Match(subject, arms) if arms.iter().all(|arm| arm.guard.is_none()) => {
            let arms = arms.iter().map(|arm| (&arm.pattern, Cow::Borrowed(&arm.body)));
            Some((subject, arms.collect()))
        }
        Tree::If(condition, then, Some(otherwise)) => {
            let Tree::Let(pattern, subject) = &condition.kind else { return None };
            let then = tree::Expr::plain(Tree::Block(then.clone()), value.site);
            let arms =
                [(&**pattern, Cow::Owned(then)), (&Pattern::Any, Cow::Borrowed(&**otherwise))];
            Some((subject, arms.into()))
        }
        _ => None,
    }
}

/// Whether control leaves by an expression, whatever the input.
fn leaves(expr: &tree::Expr) -> bool {
    let block = |block: &tree::Block| match (&block.tail, block.stmts.last()) {
        (Some(tail), _) => leaves(tail),
        (None, Some(Stmt::Expr(last))) => leaves(last),
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
