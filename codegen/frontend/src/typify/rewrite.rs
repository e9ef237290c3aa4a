//! Calls of `#[function(rewrite)]`: each is replaced by the function's body, as if its caller had written it.
//!
//! An argument replaces its parameter, and the body of a closure replaces its call, so a place remains a place, and
//! unused arguments are not evaluated. If this would change the order of evaluation, the argument is bound to a name
//! first.
//!
//! Invariants: a body consists of `match`, `if`, assignments, constructors and unambiguous names. It uses each value
//! parameter once, and calls a parameter with names that the arm binds. Types inside it have no slots; its value has
//! the type of the call.
//!
//! Must not know: what any such function computes.

use std::collections::HashMap;

use bessemer_ir::tree::visit::{self, Visit, VisitMut};
use bessemer_ir::tree::{
    self, Arm, Block, Expr, ExprKind, FunctionTree, NO_SLOT, Pattern, Role, Site, Source, Stmt,
};

use super::lowering::Lowering;
use super::order::syntax;

#[cfg(test)]
mod tests;

impl<'a> Lowering<'a, '_> {
    /// Returns the rewriting function that `expr` calls, and its arguments; none for another expression.
    pub(super) fn rule<'e>(&self, expr: &'e Expr) -> Option<(&'a FunctionTree, &'e [Expr])> {
        let (function, arguments) = self.called(expr)?;
        (function.tree.role == Role::Rewritten).then_some((&function.tree, arguments))
    }
}

/// Returns the expression that replaces `call` of a rule.
pub(super) fn rewritten(rule: &FunctionTree, arguments: &[Expr], call: &Expr) -> Expr {
    let (site, slot) = (call.site, call.slot);
    let mut body = match (rule.body.stmts.as_slice(), &rule.body.tail) {
        ([], Some(body)) => (**body).clone(),
        _ => Expr { kind: ExprKind::Block(rule.body.clone()), site, slot },
    };
    let given = rule.params.iter().map(|param| param.name.as_str()).zip(arguments);
    let mut rewriting = Rewriting { given: given.collect(), asked: HashMap::new() };
    let stmts = rewriting.held_before(rule, &body, arguments, site);
    Placed(site).expr(&mut body);
    give(&mut body, slot);
    rewriting.expr(&mut body);
    if stmts.is_empty() {
        return body;
    }
    let block = Block { stmts, tail: Some(Box::new(body)) };
    Expr { kind: ExprKind::Block(block), site, slot }
}

/// The unit value `()`.
const NOTHING: ExprKind = ExprKind::Tuple(Vec::new());

/// Returns a name that no author can write.
fn hidden(name: &str) -> String {
    format!("%{name}")
}

/// Visitor that moves a tree to another site, and removes its slots, since rustc's types in them do not apply there.
pub(super) struct Placed(pub Site);

impl VisitMut for Placed {
    fn expr(&mut self, expr: &mut Expr) {
        (expr.site, expr.slot) = (self.0, None);
        visit::walk_expr_mut(self, expr);
    }

    fn source(&mut self, source: &mut Source) {
        if let Source::Numbers(range) = source {
            range.slot = NO_SLOT;
        }
        visit::walk_source_mut(self, source);
    }

    fn stmt(&mut self, stmt: &mut Stmt) {
        match stmt {
            Stmt::Let { slot, site, .. } => (*slot, *site) = (NO_SLOT, self.0),
            Stmt::Apart { site, .. } => *site = self.0,
            Stmt::Expr(_) => {}
        }
        visit::walk_stmt_mut(self, stmt);
    }

    fn arm(&mut self, arm: &mut Arm) {
        arm.site = self.0;
        visit::walk_arm_mut(self, arm);
    }

    fn pattern(&mut self, pattern: &mut Pattern) {
        if let Pattern::Name { slot, .. } = pattern {
            *slot = NO_SLOT;
        }
        visit::walk_pattern_mut(self, pattern);
    }
}

/// Gives the result of a rule the slot of the call. Without a slot, only effects remain.
fn give(expr: &mut Expr, slot: Option<u32>) {
    expr.slot = slot;
    match &mut expr.kind {
        ExprKind::Match(_, arms) => arms.iter_mut().for_each(|arm| give(&mut arm.body, slot)),
        ExprKind::If(_, then, otherwise) => {
            then.tail.iter_mut().for_each(|tail| give(tail, slot));
            otherwise.iter_mut().for_each(|otherwise| give(otherwise, slot));
        }
        ExprKind::Block(block) => block.tail.iter_mut().for_each(|tail| give(tail, slot)),
        ExprKind::Constructor(_, parts) if slot.is_none() => match parts.pop() {
            Some(part) => {
                *expr = part;
                give(expr, slot);
            }
            None => expr.kind = NOTHING,
        },
        ExprKind::Local(_) if slot.is_none() => expr.kind = NOTHING,
        // Its own type says more than that of the call, which may be a reference.
        ExprKind::Local(_) => expr.slot = None,
        _ => {}
    }
}

/// A rule with the arguments of a call.
struct Rewriting<'e> {
    /// Arguments that replace their parameters.
    given: HashMap<&'e str, &'e Expr>,
    /// Names that the present arm binds and passes to a closure, with the closure's own patterns for them.
    asked: HashMap<String, Pattern>,
}

impl<'e> Rewriting<'e> {
    /// Binds arguments to names, if the body would evaluate them in another order, or may write one while it is
    /// matched.
    fn held_before(
        &mut self,
        rule: &'e FunctionTree,
        body: &Expr,
        arguments: &[Expr],
        site: Site,
    ) -> Vec<Stmt> {
        let first = syntax::held_first(rule, body, arguments);
        // A reference that is given is that to the same place behind the others, too.
        let is_followed = |name: &str| syntax::is_followed(body, name);
        let held = |(param, argument): (&'e tree::Param, &Expr)| {
            self.given.remove(param.name.as_str());
            let (name, slot, value) = (hidden(&param.name), NO_SLOT, argument.clone());
            if is_followed(&param.name) || matches!(value.kind, ExprKind::Ref(..)) {
                // Another name of its place.
                let pattern = Box::new(Pattern::name(&name));
                return Stmt::Apart { pattern, value, otherwise: None, site };
            }
            Stmt::Let { name, slot, value: Some(value), site, mutable: param.mutable }
        };
        first.into_iter().map(held).collect()
    }

    /// Returns the closure that the caller wrote for a parameter; none if the caller received it itself.
    fn closure(&self, name: &str) -> Option<&'e tree::Closure> {
        match &self.given.get(name)?.kind {
            ExprKind::Closure(closure) => Some(closure),
            _ => None,
        }
    }
}

impl VisitMut for Rewriting<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        // What a reference that is written out refers to is the place itself.
        if let ExprKind::Deref(inner) = &expr.kind
            && let ExprKind::Local(name) = &inner.kind
            && let Some(ExprKind::Ref(_, place)) = self.given.get(name.as_str()).map(|it| &it.kind)
        {
            *expr = (**place).clone();
            return;
        }
        match &mut expr.kind {
            ExprKind::Local(name) => match self.given.get(name.as_str()) {
                Some(argument) => *expr = (*argument).clone(),
                None => *name = hidden(name),
            },
            ExprKind::Apply(name, arguments) => {
                match (self.closure(name), self.given.get(name.as_str())) {
                    (Some(closure), _) => *expr = (*closure.body).clone(),
                    (None, Some(Expr { kind: ExprKind::Local(own), .. })) => {
                        name.clone_from(own);
                        arguments.iter_mut().for_each(|argument| self.expr(argument));
                    }
                    (None, _) => visit::walk_expr_mut(self, expr),
                }
            }
            _ => visit::walk_expr_mut(self, expr),
        }
    }

    fn stmt(&mut self, stmt: &mut Stmt) {
        visit::walk_stmt_mut(self, stmt);
        if let Stmt::Let { name, .. } = stmt {
            *name = hidden(name);
        }
    }

    fn arm(&mut self, arm: &mut Arm) {
        let mut uses = Uses { rewriting: self, asked: HashMap::new(), read: Vec::new() };
        arm.guard.iter().for_each(|guard| uses.expr(guard));
        uses.expr(&arm.body);
        let Uses { mut asked, read, .. } = uses;
        for name in read {
            let inner = asked.remove(&name).map(Box::new);
            let hidden =
                Pattern::Name { name: hidden(&name), slot: NO_SLOT, mutable: false, inner };
            asked.insert(name, hidden);
        }
        self.asked = asked;
        visit::walk_arm_mut(self, arm);
    }

    fn pattern(&mut self, pattern: &mut Pattern) {
        match pattern {
            Pattern::Name { name, .. } => {
                *pattern = self.asked.remove(name).unwrap_or(Pattern::Any);
            }
            _ => visit::walk_pattern_mut(self, pattern),
        }
    }
}

/// Visitor that finds the uses of names that an arm binds.
struct Uses<'r, 'e> {
    rewriting: &'r Rewriting<'e>,
    asked: HashMap<String, Pattern>,
    /// Names that are read.
    read: Vec<String>,
}

impl Visit for Uses<'_, '_> {
    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Apply(name, arguments)
                if let Some(closure) = self.rewriting.closure(name) =>
            {
                for (argument, pattern) in arguments.iter().zip(&closure.parameters) {
                    let argument = match &argument.kind {
                        ExprKind::Ref(_, lent) => &lent.kind,
                        argument => argument,
                    };
                    if let ExprKind::Local(name) = argument {
                        self.asked.insert(name.clone(), pattern.clone());
                    }
                }
            }
            ExprKind::Local(name) => self.read.push(name.clone()),
            _ => visit::walk_expr(self, expr),
        }
    }
}
