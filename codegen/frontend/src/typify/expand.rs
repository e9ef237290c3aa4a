//! Functions that are inlined at each call: `#[function(expand)]`.
//!
//! The body is lowered at each call, in its own scope. A parameter is an alias of the borrowed place, or a value that
//! does not change. A closure is called in the scope of its definition, so it may use everything that its author sees
//! there, also slices.
//!
//! Invariant: the body has no `return`, which would leave the caller; the macro refuses it.
//!
//! Must not know: what any such function computes.

use bessemer_ir::tree::{self, Role, Site, Ty};
use bessemer_ir::visit::Walk;
use bessemer_ir::{Expr, ExprKind, LogicOp, Stmt, Type};

use super::by_hand::{borrowed, check_end};
use super::callee::Called;
use super::consumed::{check_last, is_borrowed, length_of_items, same_length};
use super::items::{begins_at_once, lent};
use super::lowering::{Lowering, Scope, local_since};
use super::syntax::generates;
use super::value::Value;
use super::{Problem, Result, diagnostic, problem, refusals, refused};
use crate::diagnostic::{Diagnostic, Place};
use crate::standard;

/// Name of the DSL's crate, whose code is not the author's.
const DSL: &str = "bessemer";

/// Returns true if a function belongs to the DSL.
pub(super) fn is_ours(function: &tree::Function) -> bool {
    function.module.split("::").next() == Some(DSL)
}

impl<'a> Lowering<'a, '_> {
    /// Returns the inlined function that `expr` calls, and its arguments; none for any other expression.
    pub(super) fn expansion<'e>(&self, expr: &'e tree::Expr) -> Option<Called<'a, 'e>> {
        self.called(expr).filter(|(function, _)| function.tree.role == Role::Expanded)
    }

    /// Lowers an inlined call to its value.
    pub(super) fn expanded_value(
        &mut self,
        called: Called<'a, '_>,
        expected: Option<&Type>,
        site: Site,
    ) -> Result<Expr> {
        let before = self.locals.len();
        let end = |inner: &mut Self, tail: Option<&tree::Expr>| match tail {
            Some(tail) => inner.value(tail, expected),
            None => Ok(inner.nothing(site)),
        };
        if let Some(length) = length_of_items(self, called, site)? {
            return Ok(length);
        }
        let value = match standard::is_comparison(called.0) {
            true => {
                let compared = self.in_block(|inner| inner.expanded(called, site, end))?;
                self.items_compared(compared, called.1, site)?
            }
            false => self.expanded(called, site, end)?,
        };
        // A local of its own, which nothing names from here on.
        if let ExprKind::Load(place) = &value.kind
            && let Some(local) = local_since(place, before)
        {
            self.locals.note_temporary(local);
        }
        Ok(value)
    }

    /// Emits the comparison of two iterators' items, if their lengths are equal where Rust knows these.
    fn items_compared(
        &mut self,
        (equal, stmts): (Expr, Vec<Stmt>),
        arguments: &[tree::Expr],
        site: Site,
    ) -> Result<Expr> {
        let acts = |expr: &Expr| self.cx.calls_own_equality(expr);
        let acts = equal.any_expr(acts) || stmts.iter().any(|stmt| stmt.any_expr(acts));
        let compared = |inner: &mut Self| {
            inner.out.extend(stmts);
            Ok(equal)
        };
        match same_length(self, arguments, acts, site)? {
            Some(same) => {
                let span = same.span;
                self.short_circuit(LogicOp::And, same, span, compared)
            }
            None => compared(self),
        }
    }

    /// Lowers the body of an inlined function, and calls `end` with its tail expression.
    pub(super) fn expanded<T>(
        &mut self,
        (function, arguments): Called<'a, '_>,
        site: Site,
        end: impl FnOnce(&mut Self, Option<&tree::Expr>) -> Result<T>,
    ) -> Result<T> {
        if generates(function) {
            return refused(site, refusals::ITERATOR_CALL);
        }
        let meanings = self.given_to(function, arguments)?;
        self.inside(function, meanings, site, |inner| {
            inner.stmts(&function.tree.body)?;
            end(inner, function.tree.body.tail.as_deref())
        })
    }

    /// Returns the meaning of each parameter of a function.
    pub(super) fn given_to(
        &mut self,
        function: &'a tree::Function,
        arguments: &[tree::Expr],
    ) -> Result<Vec<(String, Value)>> {
        let pairs = function.tree.params.iter().zip(arguments);
        pairs.map(|(param, argument)| self.given_as(function, param, argument)).collect()
    }

    pub(super) fn given_as(
        &mut self,
        function: &'a tree::Function,
        param: &tree::Param,
        argument: &tree::Expr,
    ) -> Result<(String, Value)> {
        let is_borrowed = param.items && is_borrowed(self, argument);
        let argument = if param.items { lent(argument) } else { argument };
        if param.items {
            self.check_settled((function, false), argument)?;
            check_end(self, function, argument)?;
        }
        let meaning = match (param.items, param.mutable) {
            (true, _) if self.own_next(argument).is_some() => {
                Value::Place(self.own_iterator(argument)?)
            }
            (true, true) => {
                let meaning = self.gone_through(argument)?;
                self.by_hand(&param.name, meaning, function, argument.site)?
            }
            (true, false) if begins_at_once(function) => self.gone_through_at_once(argument)?,
            (true, false) => self.gone_through(argument)?,
            // In the scope that it was written in.
            _ if param.closure => Value::Closure(self.closure_given(argument)?),
            _ => {
                let ty = function.slots.get(param.slot as usize).cloned().unwrap_or(Ty::Unit);
                self.given((&param.name, param.mutable), &ty, argument)?
            }
        };
        if let Value::Closure(items) = meaning
            && param.items
        {
            check_last(self, function, items, argument.site)?;
            if is_borrowed {
                return Ok((param.name.clone(), Value::Closure(borrowed(self, items))));
            }
        }
        Ok((param.name.clone(), meaning))
    }

    /// Lowers code of another function, with its parameters bound to these meanings.
    pub(super) fn inside<T>(
        &mut self,
        function: &'a tree::Function,
        bound: Vec<(String, Value)>,
        site: Site,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        if self.expanding.iter().any(|(path, _)| *path == function.path) {
            return refused(site, refusals::EXPANDS_ITSELF);
        }
        let called = (function.path.as_str(), self.span(site));
        let expanding = [&self.expanding[..], &[called]].concat();
        let scope = Scope { names: bound.into_iter().collect(), expanding, locals: None };
        let Site(line, column) = site;
        let call = Place {
            file: self.source.file.clone(),
            start: (line, column),
            label: "called here".to_owned(),
            ..Place::default()
        };
        let call = (!is_ours(self.source)).then_some(call);
        let first = self.cx.told.len();
        let done = self.in_names(function, scope, (site, call.clone()), lower);
        // The error of a function that this one calls: the way to it is a chain of calls.
        if let (Some(call), Some(errors)) = (call, self.cx.told.get_mut(first..)) {
            let is_behind = |it: &&mut Diagnostic| it.also.last().is_some_and(|last| *last != call);
            errors.iter_mut().filter(is_behind).for_each(|it| it.also.push(call.clone()));
        }
        done
    }

    /// Lowers code of another function in its own scope. An error in it is reported once, at its line; the caller's
    /// `site` has no message then. An error in a function of the DSL is reported at the author's call. An error in a called
    /// function shows the `call`, too, since it may follow from the arguments.
    pub(super) fn in_names<T>(
        &mut self,
        function: &'a tree::Function,
        Scope { names, expanding, .. }: Scope<'a>,
        (site, call): (Site, Option<Place>),
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let source = std::mem::replace(&mut self.source, function);
        let scopes = std::mem::replace(&mut self.scopes, names);
        let expanding = std::mem::replace(&mut self.expanding, expanding);
        let first = self.cx.told.len();
        let (had, copies) = (self.lenders.problem.is_some(), self.lenders.copied.len());
        let done = lower(self);
        (self.source, self.scopes, self.expanding) = (source, scopes, expanding);
        if is_ours(function) {
            // What is wrong with these shows when their lender is known.
            let here = self.span(site);
            self.lenders.copied.iter_mut().skip(copies).for_each(|(_, (_, span))| *span = here);
        }
        if let Some(problem) = self.lenders.problem.as_mut().filter(|_| !had && is_ours(function)) {
            problem.site = site;
        }
        done.or_else(|Problem { site: at, message, help }| {
            if is_ours(function) {
                return problem(site, message, help);
            }
            let known = diagnostic(&function.file, Problem { site: at, message, help });
            let is_here = |it: &Diagnostic| Diagnostic { also: Vec::new(), ..it.clone() } == known;
            let is_new = first == self.cx.told.len()
                && !known.message.is_empty()
                && !self.cx.told.iter().any(is_here);
            if is_new {
                self.cx.told.push(Diagnostic { also: call.into_iter().collect(), ..known });
            }
            problem(site, "", "")
        })
    }
}
