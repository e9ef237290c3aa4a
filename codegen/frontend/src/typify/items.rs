//! Iterators that are arguments: closures that hand each item on.
//!
//! Rust makes an iterator where it is an argument, and goes through it later. What it copies then, the ends of a range, a
//! number, an array by value, has a name from there on; what it borrows stays as it is as long.
//!
//! Must not know: how an iterator is gone through ([`generator`](super::generator)).

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, Builtin, Desugared, EACH, ExprKind as Tree, Site, Source, Stmt, Ty};
use bessemer_ir::{Int, Mode, Scalar};

use super::Result;
use super::closure_args::is_hidden;
use super::lowering::{Closure, Lowering, meaning_in};
use super::syntax::{bare, generates, is_named, is_of_library};
use super::value::Value;

/// An iterator that is an argument, as a closure that hands each item on: written as one by the macro, or, where it takes
/// types to see what it is, a loop through it.
pub(super) fn handing(argument: &tree::Expr) -> tree::Closure {
    if let Tree::Closure(closure) = &argument.kind {
        return closure.clone();
    }
    let plain = |kind| tree::Expr::plain(kind, argument.site);
    let (name, site) = ("item%", argument.site);
    // What is given by value is its function's own, whatever is written to what it was copied from.
    let owned = !matches!(argument.kind, Tree::Ref(..));
    let source = Source::Elements(argument.clone(), owned);
    let hand_on = Tree::Apply(EACH.into(), vec![tree::Expr::local(name, site)]);
    let each = Tree::each(tree::Pattern::name(name), source, plain(hand_on));
    tree::Closure { name: None, parameters: Vec::new(), body: Box::new(plain(each)) }
}

/// The iterator that is lent: `bytes` of `&mut *bytes`, and a chain of a reference to one. An array is not one.
pub(super) fn lent(argument: &tree::Expr) -> &tree::Expr {
    let Tree::Ref(true, of) = &argument.kind else { return argument };
    match &of.kind {
        Tree::Deref(inner) => inner,
        Tree::Closure(_) | Tree::Call(..) => of,
        _ => argument,
    }
}

/// Whether a function goes through the one iterator that it takes before anything else that it takes is looked at.
pub(super) fn begins_at_once(function: &tree::Function) -> bool {
    let params = &function.tree.params;
    let Some((_, before)) = function.tree.body.stmts.split_last() else { return false };
    let is_literal = |stmt: &Stmt| matches!(stmt, Stmt::Let { value: Some(value), .. } if matches!(value.kind, Tree::Bool(_)));
    generates(function)
        && params.iter().filter(|param| param.items).count() == 1
        && params.iter().all(|param| param.closure)
        && before.iter().all(is_literal)
}

/// The type of a count.
const SIZE: Ty = Ty::Scalar(Scalar::Int(Int::Usize));

impl<'a> Lowering<'a, '_> {
    /// What goes through an argument.
    pub(super) fn gone_through(&mut self, argument: &tree::Expr) -> Result<Value> {
        if let Some(known) = self.iterator_copied(argument) {
            return Ok(Value::Closure(self.copy_of_hand(known)));
        }
        self.check_taken(argument)?;
        let mut closure = handing(argument);
        self.settle_items(&mut closure.body)?;
        Ok(self.closure_here(closure))
    }

    /// The same of the only argument but closures of a function that goes through it before anything else.
    pub(super) fn gone_through_at_once(&mut self, argument: &tree::Expr) -> Result<Value> {
        self.check_taken(argument)?;
        Ok(match self.iterator_copied(argument) {
            Some(known) => Value::Closure(known),
            None => self.closure_here(handing(argument)),
        })
    }

    /// What goes through a value, if that is an iterator.
    pub(super) fn iterator(&mut self, value: &tree::Expr) -> Result<Option<Value>> {
        let is_iterator = matches!(value.kind, Tree::Closure(_))
            || self.expansion(value).is_some_and(|(it, _)| generates(it))
            || self.iterator_named(value).is_some();
        is_iterator.then(|| self.gone_through(value)).transpose()
    }

    /// The iterator that an expression names, or is a copy of.
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

    /// The same; an own iterator in a copy of one is copied.
    pub(super) fn iterator_copied(&mut self, expr: &tree::Expr) -> Option<usize> {
        let known = self.iterator_named(expr)?;
        let of = self.builtin_call(expr).map(|it| it.0);
        let copies = matches!(of, Some(Builtin::Desugared(Desugared::AsRef)));
        // The copy of one that is gone through by hand copies its state itself.
        let by_hand = self.hands.values().any(|hand| hand.again == known);
        if !copies || by_hand || self.cx.iterators.is_empty() {
            return Some(known);
        }
        Some(self.own_copied(known))
    }

    /// An iterator with copies of the own iterators that are part of it.
    fn own_copied(&mut self, known: usize) -> usize {
        let mut closure = (*self.closures[known]).clone();
        let mut copies = Vec::new();
        for name in closure.text.body.locals() {
            let copy = match meaning_in(&closure.scope.names, &name) {
                Some(Value::Place(own)) if is_hidden(&name) && self.cx.holds_iterator(&own.ty) => {
                    let own = own.load();
                    Value::Place(self.own_copy(own))
                }
                Some(&Value::Closure(inner)) => match self.own_copied(inner) {
                    copy if copy == inner => continue,
                    copy => Value::Closure(copy),
                },
                _ => continue,
            };
            copies.push((name, copy));
        }
        if copies.is_empty() {
            return known;
        }
        closure.scope.names.push(copies);
        self.closure(closure)
    }

    /// Computes what a loop copies that begins later.
    pub(super) fn settle_items(&mut self, through: &mut tree::Expr) -> Result<()> {
        match &mut through.kind {
            Tree::Block(block) | Tree::Labelled(_, block) => {
                let stmts = std::mem::take(&mut block.stmts);
                for mut stmt in stmts {
                    if let Stmt::Expr(part) = &mut stmt {
                        self.settle_items(part)?;
                        block.stmts.push(stmt);
                        continue;
                    }
                    // What the loop counts in.
                    self.stmts(&tree::Block { stmts: vec![stmt], tail: None })?;
                }
            }
            Tree::Each { source, .. } => self.settle_source(source)?,
            _ => {}
        }
        Ok(())
    }

    pub(super) fn settle_source(&mut self, source: &mut Source) -> Result<()> {
        match source {
            Source::Elements(array, owned) => {
                self.settle_elements(array, *owned)?;
                if let Some(meant) = self.meant(source) {
                    *source = meant;
                }
                Ok(())
            }
            Source::Numbers(range) => {
                let ty = self.source.slots.get(range.slot as usize).cloned().unwrap_or(SIZE);
                self.settle_number(&mut range.from, "start%", &ty)?;
                range.to.iter_mut().try_for_each(|to| self.settle_number(to, "end%", &ty))
            }
            Source::Groups(_, array, size) => {
                self.settle_elements(array, false)?;
                self.settle_number(size, "size%", &SIZE)
            }
            Source::Zip(one, other, _) | Source::Chain(one, other) => {
                self.settle_source(one)?;
                self.settle_source(other)
            }
            Source::Enumerate(of) | Source::Rev(of) | Source::Cycle(of) => self.settle_source(of),
            Source::Skip(of, count) | Source::Take(of, count) => {
                self.settle_source(of)?;
                self.settle_number(count, "count%", &SIZE)
            }
            Source::StepBy(of, size) => {
                self.settle_source(of)?;
                let role = if matches!(**of, Source::Numbers(_)) { "step%" } else { "size%" };
                self.settle_number(size, role, &SIZE)
            }
        }
    }

    fn settle_number(&mut self, number: &mut tree::Expr, name: &str, ty: &Ty) -> Result<()> {
        let stays = match &number.kind {
            Tree::Int(..) => true,
            Tree::Local(name) => match self.lookup(name, number.site)? {
                Value::Local(local) => !self.changing.contains_key(&local),
                _ => true,
            },
            _ => false,
        };
        if stays {
            return Ok(());
        }
        let given = self.given((name, false), ty, number)?;
        self.stand_in(number, name, given);
        Ok(())
    }

    fn settle_elements(&mut self, elements: &mut tree::Expr, owned: bool) -> Result<()> {
        if let Some((function, _)) = self.expansion(elements).filter(|(it, _)| generates(it)) {
            let Tree::Call(_, arguments) = &mut elements.kind else { return Ok(()) };
            for (param, argument) in function.tree.params.iter().zip(arguments) {
                if param.items {
                    let owned = !matches!(argument.kind, Tree::Ref(..));
                    match &mut argument.kind {
                        Tree::Closure(closure) => self.settle_items(&mut closure.body)?,
                        _ => self.settle_elements(argument, owned)?,
                    }
                } else if !param.closure {
                    let (_, given) = self.given_as(function, param, argument)?;
                    self.stand_in(argument, &format!("{}%", param.name), given);
                }
            }
            // What the DSL's own compute before their first item changes with each item, so each loop begins with it.
            if !is_of_library(function)
                && let Tree::Call(_, arguments) = &elements.kind
                && let Some(own) = self.start(function, arguments, elements.site)?
            {
                let own = Value::Closure(self.closure(own));
                self.stand_in(elements, "items%", own);
            }
            return Ok(());
        }
        if self.iterator_named(elements).is_some() {
            return Ok(());
        }
        if self.own_next(elements).is_some() {
            let place = self.own_iterator(elements)?;
            self.stand_in(elements, "items%", Value::Place(place));
            return Ok(());
        }
        if let Some(part) = self.submatrix(elements)? {
            self.stand_in(elements, "items%", Value::Submatrix(Box::new(part)));
            return Ok(());
        }
        // What a slice that is held has is borrowed, and the slice itself is copied.
        let held = self.is_held_slice(elements);
        match &mut elements.kind {
            _ if held => {}
            // What is borrowed.
            Tree::Local(name) if !owned || !self.is_changeable(name) => return Ok(()),
            _ => {}
        }
        let borrowed = match &elements.kind {
            Tree::Field(..) if !owned => self.is_borrowed_variable(elements)?,
            Tree::Ref(_, inner) => self.is_borrowed_variable(inner)?,
            _ => false,
        };
        if borrowed {
            return Ok(());
        }
        let given = match self.slice(elements)? {
            Some(slice) => Value::Slice(Box::new(self.kept_elements(slice))),
            None => {
                let mut place = self.base(elements)?;
                self.fix(&mut place);
                match (owned || self.is_loan(&place)) && !self.held.contains(&place.root) {
                    true => self.own("items%", place.load(), None),
                    false => Value::Place(place),
                }
            }
        };
        self.stand_in(elements, "items%", given);
        Ok(())
    }

    /// Starts a generator function: lowers the statements before its loop here, as Rust runs them when the iterator is made, and
    /// computes what the loop goes through. Gives the loop; none if the function ends in something else.
    pub(super) fn start(
        &mut self,
        function: &'a tree::Function,
        arguments: &[tree::Expr],
        site: Site,
    ) -> Result<Option<Closure<'a>>> {
        let Some((Stmt::Expr(each), before)) = function.tree.body.stmts.split_last() else {
            return Ok(None);
        };
        let given = self.given_to(function, arguments)?;
        self.inside(function, given, site, |inner| {
            inner.stmts(&tree::Block { stmts: before.to_vec(), tail: None })?;
            let mut each = each.clone();
            inner.settle_items(&mut each)?;
            let (name, parameters, body) = (None, Vec::new(), Box::new(each));
            Ok(Some(inner.written_here(tree::Closure { name, parameters, body })))
        })
    }

    /// Whether an expression names a slice that a variable holds, which may come to hold another.
    fn is_held_slice(&mut self, expr: &tree::Expr) -> bool {
        let named = bare(expr);
        !self.cx.borrowed.is_empty()
            && is_named(named, false)
            && self.place_type(named).is_ok_and(|ty| self.cx.as_borrowed(&ty).is_some())
    }

    /// Whether elements are those of a variable that is borrowed, and stays what it is.
    fn is_borrowed_variable(&mut self, elements: &tree::Expr) -> Result<bool> {
        if !is_named(elements, false) {
            return Ok(false);
        }
        Ok(!self.place(elements)?.is_some_and(|place| self.is_loan(&place)))
    }

    /// Whether a name is that of a value which may be written to.
    fn is_changeable(&self, name: &str) -> bool {
        let Ok(Value::Local(root)) = self.lookup(name, Site::default()) else { return false };
        self.locals[root.index()].mode == Mode::Value && self.changing.contains_key(&root)
    }

    /// Puts a name in the place of an expression: one that nothing else has here, since a loop goes through several parts.
    fn stand_in(&mut self, expr: &mut tree::Expr, name: &str, given: Value) {
        let known: usize = self.scopes.iter().map(|scope| scope.len()).sum();
        let name = format!("{name}{known}");
        self.bind(&name, given);
        *expr = tree::Expr::local(&name, expr.site);
    }
}
