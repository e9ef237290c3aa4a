//! Iterator arguments: closures that yield each item.
//!
//! An iterator is evaluated where it is an argument ([`settled`](super::settled)), and consumed later. A copy of an
//! iterator has a copy of its state.
//!
//! Must not know: how an iterator is consumed ([`generator`](super::generator)).

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, Builtin, Desugared, EACH, ExprKind as Tree, Source, Stmt};

use super::Result;
use super::closure_args::is_hidden;
use super::lowering::Lowering;
use super::scopes::meaning_in;
use super::syntax::generates;
use super::value::Value;

/// Returns an iterator argument as a closure that passes on each item. The macro wrote it as one, or, if only types
/// decide what it is, it is a loop through it.
pub(super) fn handing(argument: &tree::Expr) -> tree::Closure {
    if let Tree::Closure(closure) = &argument.kind {
        return closure.clone();
    }
    let plain = |kind| tree::Expr::plain(kind, argument.site);
    let (name, site) = ("item%", argument.site);
    // A value argument belongs to the function: a later write to its origin does not change it.
    let owned = !matches!(argument.kind, Tree::Ref(..));
    let source = Source::Elements(argument.clone(), owned);
    let hand_on = Tree::Apply(EACH.into(), vec![tree::Expr::local(name, site)]);
    let each = Tree::each(tree::Pattern::name(name), source, plain(hand_on));
    tree::Closure { name: None, parameters: Vec::new(), body: Box::new(plain(each)) }
}

/// Returns the iterator that an argument borrows mutably: `bytes` of `&mut *bytes`, or a chain behind `&mut`. An
/// array is not one.
pub(super) fn lent(argument: &tree::Expr) -> &tree::Expr {
    let Tree::Ref(true, of) = &argument.kind else { return argument };
    match &of.kind {
        Tree::Deref(inner) => inner,
        Tree::Closure(_) | Tree::Call(..) => of,
        _ => argument,
    }
}

/// Returns true if a function consumes its only iterator before it evaluates another parameter.
pub(super) fn begins_at_once(function: &tree::Function) -> bool {
    let params = &function.tree.params;
    let Some((_, before)) = function.tree.body.stmts.split_last() else { return false };
    let is_literal = |stmt: &Stmt| matches!(stmt, Stmt::Let { value: Some(value), .. } if matches!(value.kind, Tree::Bool(_)));
    generates(function)
        && params.iter().filter(|param| param.items).count() == 1
        && params.iter().all(|param| param.closure)
        && before.iter().all(is_literal)
}

impl<'a> Lowering<'a, '_> {
    /// Returns the iteration over an argument.
    pub(super) fn gone_through(&mut self, argument: &tree::Expr) -> Result<Value> {
        if let Some(known) = self.iterator_copied(argument) {
            return Ok(Value::Closure(self.copy_of_hand(known)));
        }
        self.check_taken(argument)?;
        let mut closure = handing(argument);
        self.settle_items(&mut closure.body)?;
        Ok(self.closure_here(closure))
    }

    /// Returns the iteration over the only argument besides closures, in a function that begins with it.
    pub(super) fn gone_through_at_once(&mut self, argument: &tree::Expr) -> Result<Value> {
        self.check_taken(argument)?;
        Ok(match self.iterator_copied(argument) {
            Some(known) => Value::Closure(known),
            None => self.closure_here(handing(argument)),
        })
    }

    /// Returns the iteration over a value that is an iterator.
    pub(super) fn iterator(&mut self, value: &tree::Expr) -> Result<Option<Value>> {
        let is_iterator = matches!(value.kind, Tree::Closure(_))
            || self.expansion(value).is_some_and(|(it, _)| generates(it))
            || self.iterator_named(value).is_some();
        is_iterator.then(|| self.gone_through(value)).transpose()
    }

    /// Returns the iterator that an expression names, or copies.
    pub(super) fn iterator_named(&self, expr: &tree::Expr) -> Option<usize> {
        if let Some((Builtin::Desugared(Desugared::AsRef), of)) = self.builtin_call(expr) {
            let named = self.iterator_named(of.first()?)?;
            return Some(self.hands.get(&named).map_or(named, |hand| hand.again));
        }
        if let Some((Builtin::Desugared(Desugared::ByRef), of)) = self.builtin_call(expr) {
            return self.iterator_named(of.first()?);
        }
        let expr = match &expr.kind {
            Tree::Ref(true, inner) => inner,
            _ => expr,
        };
        let Tree::Local(name) = &expr.kind else { return None };
        match self.lookup(name, expr.site) {
            Ok(Value::Closure(through)) => Some(through),
            _ => None,
        }
    }

    /// Returns the iterator; a copy has a copy of its state.
    pub(super) fn iterator_copied(&mut self, expr: &tree::Expr) -> Option<usize> {
        let known = self.iterator_named(expr)?;
        let of = self.builtin_call(expr).map(|it| it.0);
        let copies = matches!(of, Some(Builtin::Desugared(Desugared::AsRef)));
        // The copy of one that is gone through by hand copies its state itself.
        let by_hand = self.hands.values().any(|hand| hand.again == known);
        Some(if copies && !by_hand { self.copy_of_chain(known) } else { known })
    }

    /// Copies an iterator, with copies of the own iterators and the counted iterators in its chain.
    fn copy_of_chain(&mut self, known: usize) -> usize {
        let mut closure = (*self.closures[known]).clone();
        let mut copies = Vec::new();
        for name in closure.text.body.locals() {
            let copy = match meaning_in(&closure.scope.names, &name) {
                Some(Value::Place(own)) if is_hidden(&name) && self.cx.holds_iterator(&own.ty) => {
                    let own = own.load();
                    Value::Place(self.own_copy(own))
                }
                Some(&Value::Closure(inner)) => {
                    let copy = match self.hands.get(&inner).map(|hand| hand.again) {
                        Some(again) => self.copy_of_hand(again),
                        None => self.copy_of_chain(inner),
                    };
                    if copy == inner {
                        continue;
                    }
                    Value::Closure(copy)
                }
                _ => continue,
            };
            copies.push((name, copy));
        }
        if copies.is_empty() {
            return known;
        }
        closure.scope.names.push(copies.into_iter().collect());
        self.closure(closure)
    }
}
