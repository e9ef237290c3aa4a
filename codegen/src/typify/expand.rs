//! Functions that stand where they are called: `#[function(expand)]`.
//!
//! The body is lowered at each call, in a scope of its own. A parameter is the place that is borrowed for it, or a value
//! that does not change. A closure is called in the scope that it was written in: it may use all that its author sees
//! there, slices too.
//!
//! Invariants: the body ends in its last expression, since a `return` would leave the caller; the macro refuses others.
//!
//! Must not know: what any such function computes.

use std::collections::HashMap;

use bessemer_ir::tree::{self, ExprKind as Tree, Role, Site, Ty};
use bessemer_ir::{Expr, ExprKind, Type};

use super::generator::generates;
use super::lowering::{Binding, Handed, Lowering, Target};
use super::{Context, Problem, Result, diagnostic, problem};

/// The meaning of a function's parameters: values and places, and closures.
pub(super) type Given<'a> = (Vec<(String, Binding)>, HashMap<String, Handed<'a>>);

impl<'a> Context<'a> {
    /// Notes the functions that stand where they are called.
    pub(super) fn note_expanded(&mut self, functions: impl Iterator<Item = &'a tree::Function>) {
        let expanded = functions.filter(|it| it.tree.role == Role::Expanded);
        self.expanded = expanded.map(|it| (it.path.as_str(), it)).collect();
    }
}

impl<'a> Lowering<'a, '_> {
    /// The function that stands where `expr` calls it, and its arguments; none if `expr` is something else.
    pub(super) fn expansion<'e>(
        &self,
        expr: &'e tree::Expr,
    ) -> Option<(&'a tree::Function, &'e [tree::Expr])> {
        let Tree::Call(callee, arguments) = &expr.kind else { return None };
        let Some(tree::Callee::Function(path)) = self.source.callees.get(*callee as usize) else {
            return None;
        };
        let function = self.cx.expanded.get(path.as_str())?;
        Some((function, arguments))
    }

    /// Its value.
    pub(super) fn expanded_value(
        &mut self,
        (function, arguments): (&'a tree::Function, &[tree::Expr]),
        expected: Option<&Type>,
        site: Site,
    ) -> Result<Expr> {
        let before = self.locals.len();
        let value =
            self.expanded(function, arguments, site, |inner| match &function.tree.body.tail {
                Some(tail) => inner.value(tail, expected),
                None => Ok(inner.nothing(function.tree.site)),
            })?;
        // A local of its own, which nothing names from here on.
        if let ExprKind::Load(place) = &value.kind
            && place.steps.is_empty()
            && place.root.index() >= before
        {
            self.held.insert(place.root);
        }
        Ok(value)
    }

    /// Its value, where it goes.
    pub(super) fn expanded_into(
        &mut self,
        (function, arguments): (&'a tree::Function, &[tree::Expr]),
        target: &Target,
        site: Site,
    ) -> Result<()> {
        self.expanded(function, arguments, site, |inner| match &function.tree.body.tail {
            Some(tail) => inner.into(tail, target),
            None => Ok(()),
        })
    }

    /// Its statements, without its value.
    pub(super) fn expanded_effect(
        &mut self,
        (function, arguments): (&'a tree::Function, &[tree::Expr]),
        site: Site,
    ) -> Result<()> {
        self.expanded(function, arguments, site, |inner| match &function.tree.body.tail {
            Some(tail) => inner.effect(tail),
            None => Ok(()),
        })
    }

    fn expanded<T>(
        &mut self,
        function: &'a tree::Function,
        arguments: &[tree::Expr],
        site: Site,
        end: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        if generates(function) {
            return problem(
                site,
                "an iterator that a function gives is gone through where the function is called",
                "write the call in the `for`, or before `.map(…)`, `.filter(…)`, `.sum()` and the like, with `.into_iter()` between",
            );
        }
        let given = self.given_to(function, arguments)?;
        self.inside(function, given, site, |inner| {
            inner.stmts(&function.tree.body)?;
            end(inner)
        })
    }

    /// The meaning of the parameters of a function: values and places, and closures.
    pub(super) fn given_to(
        &mut self,
        function: &'a tree::Function,
        arguments: &[tree::Expr],
    ) -> Result<Given<'a>> {
        let (mut bound, mut handed) = (Vec::new(), HashMap::new());
        for (param, argument) in function.tree.params.iter().zip(arguments) {
            if param.closure {
                handed.insert(param.name.clone(), self.handed_in_scope(param, argument)?);
                continue;
            }
            bound.push(self.given_as(function, param, argument)?);
        }
        Ok((bound, handed))
    }

    pub(super) fn given_as(
        &mut self,
        function: &'a tree::Function,
        param: &tree::Param,
        argument: &tree::Expr,
    ) -> Result<(String, Binding)> {
        let ty = function.slots.get(param.slot as usize).cloned().unwrap_or(Ty::Unit);
        let given = self.given((&param.name, param.mutable), &ty, argument)?;
        Ok((param.name.clone(), given))
    }

    /// The closure that an argument is, with the scope that it was written in.
    fn handed_in_scope(
        &mut self,
        param: &tree::Param,
        argument: &tree::Expr,
    ) -> Result<Handed<'a>> {
        if let Tree::Local(name) = &argument.kind
            && let Some(handed) = self.handed.get(name)
        {
            return Ok(handed.clone());
        }
        let closure = match param.items {
            true => self.items(argument)?,
            false => self.closure_of(argument)?,
        };
        let scope = Some(self.scope());
        let (captures, nothing) = (Vec::new(), Vec::new());
        Ok(Handed { closure, source: self.source, captures, nothing, scope })
    }

    /// Lowers what belongs to another function, in which names and closures have these meanings.
    pub(super) fn inside<T>(
        &mut self,
        function: &'a tree::Function,
        (bound, handed): Given<'a>,
        site: Site,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        if self.expanding.contains(&function.path.as_str()) {
            return problem(site, "this calls itself where it stands", "write a loop over a range");
        }
        self.expanding.push(&function.path);
        let scopes = std::mem::replace(&mut self.scopes, vec![bound]);
        let handed = std::mem::replace(&mut self.handed, handed);
        let done = self.from(function, site, lower);
        self.scopes = scopes;
        self.handed = handed;
        self.expanding.pop();
        done
    }

    /// Lowers what stands in another function. What is wrong there is told in that function's file, once; at `site`
    /// nothing is left to say.
    pub(super) fn from<T>(
        &mut self,
        function: &'a tree::Function,
        site: Site,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let source = std::mem::replace(&mut self.source, function);
        let told = self.cx.told.len();
        let done = lower(self);
        self.source = source;
        done.or_else(|Problem { site: at, message, help }| {
            let known = diagnostic(&function.file, Problem { site: at, message, help });
            let is_new = told == self.cx.told.len()
                && !known.message.is_empty()
                && !self.cx.told.contains(&known);
            if is_new {
                self.cx.told.push(known);
            }
            problem(site, "", "")
        })
    }
}
