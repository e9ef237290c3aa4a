//! Evaluation of iterators where Rust creates them, though their items are consumed later. Numbers, ranges and arrays
//! by value are copied, sizes of zero are refused, and a generator function runs up to its loop.
//!
//! Invariant: no statement between an iterator and its loop changes its items, unless the iterator borrows them.
//!
//! Must not know: how an iterator is consumed ([`generator`](super::generator)).

use bessemer_ir::tree::{self, ExprKind as Tree, Site, Source, Stmt, Ty};
use bessemer_ir::{CompareOp, Expr, Fault, Int, Mode, Scalar, Type};

use super::Result;
use super::closure_args::is_hidden;
use super::lowering::{Closure, Lowering};
use super::syntax::{bare, generates, is_named, is_of_library};
use super::value::Value;

/// Type of a number of items.
const SIZE: Ty = Ty::Scalar(Scalar::Int(Int::Usize));

impl<'a> Lowering<'a, '_> {
    /// Evaluates whatever a later loop would copy when Rust creates the iterator.
    pub(super) fn create_items(&mut self, through: &mut tree::Expr) -> Result<()> {
        match &mut through.kind {
            Tree::Block(block) | Tree::Labelled(_, block) => {
                let stmts = std::mem::take(&mut block.stmts);
                for mut stmt in stmts {
                    if let Stmt::Expr(part) = &mut stmt {
                        self.create_items(part)?;
                        block.stmts.push(stmt);
                        continue;
                    }
                    // What the loop counts in.
                    self.stmts(&tree::Block { stmts: vec![stmt], tail: None })?;
                }
            }
            Tree::Each { source, .. } => self.create_source(source)?,
            _ => {}
        }
        Ok(())
    }

    pub(super) fn create_source(&mut self, source: &mut Source) -> Result<()> {
        match source {
            Source::Elements(array, owned) => {
                self.create_elements(array, *owned)?;
                if let Some(meant) = self.meant(source) {
                    *source = meant;
                }
                Ok(())
            }
            Source::Numbers(range) => {
                let ty = self.source.slots.get(range.slot as usize).cloned().unwrap_or(SIZE);
                self.create_number(&mut range.from, "start%", &ty)?;
                range.to.iter_mut().try_for_each(|to| self.create_number(to, "end%", &ty))
            }
            Source::Groups(_, array, size) => {
                self.create_elements(array, false)?;
                self.create_size(size, "size%")
            }
            Source::Zip(one, other, _) | Source::Chain(one, other) => {
                self.create_source(one)?;
                self.create_source(other)
            }
            Source::Enumerate(of) | Source::Rev(of) | Source::Cycle(of) => self.create_source(of),
            Source::Skip(of, count) | Source::Take(of, count) => {
                self.create_source(of)?;
                self.create_number(count, "count%", &SIZE)
            }
            Source::StepBy(of, size) => {
                self.create_source(of)?;
                let role = if matches!(**of, Source::Numbers(_)) { "step%" } else { "size%" };
                self.create_size(size, role)
            }
        }
    }

    /// Evaluates a size or a step, and checks that it is not zero, as std does when it creates the iterator.
    fn create_size(&mut self, size: &mut tree::Expr, name: &str) -> Result<()> {
        self.create_number(size, name, &SIZE)?;
        let value = self.value(size, Some(&Type::USIZE))?;
        if self.known(&value).is_none() {
            let (span, zero) = (value.span, Expr::usize(0, value.span));
            self.check(Expr::compare(CompareOp::Ne, value, zero), Fault::Assertion, span);
        }
        Ok(())
    }

    fn create_number(&mut self, number: &mut tree::Expr, name: &str, ty: &Ty) -> Result<()> {
        match &number.kind {
            Tree::Int(..) => return Ok(()),
            // No author writes it, and its name says what it is.
            Tree::Local(name) if is_hidden(name) => return Ok(()),
            _ => {}
        }
        let given = self.given((name, false), ty, number)?;
        self.stand_in(number, name, given);
        Ok(())
    }

    fn create_elements(&mut self, elements: &mut tree::Expr, owned: bool) -> Result<()> {
        if let Some((function, _)) = self.expansion(elements).filter(|(it, _)| generates(it)) {
            let Tree::Call(_, arguments) = &mut elements.kind else { return Ok(()) };
            for (param, argument) in function.tree.params.iter().zip(arguments) {
                if param.items {
                    let owned = !matches!(argument.kind, Tree::Ref(..));
                    match &mut argument.kind {
                        Tree::Closure(closure) => self.create_items(&mut closure.body)?,
                        _ => self.create_elements(argument, owned)?,
                    }
                } else if !param.closure {
                    let (_, given) = self.given_as(function, param, argument)?;
                    self.stand_in(argument, &format!("{}%", param.name), given);
                }
            }
            let Tree::Call(_, arguments) = &elements.kind else { return Ok(()) };
            if is_of_library(function) {
                return self.assert_first(function, arguments, elements.site);
            }
            if let Some(own) = self.start(function, arguments, elements.site)? {
                let own = Value::Closure(self.closure(own));
                self.stand_in(elements, "items%", own);
            }
            return Ok(());
        }
        if let Some(known) = self.iterator_copied(elements) {
            let copy = self.copy_of_hand(known);
            if self.iterator_named(elements) != Some(copy) {
                self.stand_in(elements, "items%", Value::Closure(copy));
            }
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
        let is_variable = |name: &str| match self.lookup(name, Site::default()) {
            Ok(Value::Local(root)) => self.locals[root.index()].mode == Mode::Value,
            _ => false,
        };
        match &mut elements.kind {
            _ if held => {}
            // What is borrowed.
            Tree::Local(name) if !owned || !is_variable(name) => return Ok(()),
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
                let place = self.base(elements)?;
                let variable = matches!(elements.kind, Tree::Local(_));
                match owned || self.is_loan(&place) {
                    true if variable => {
                        Value::Place(self.naming_as("", |it| it.copied_place("items%", place)))
                    }
                    true => self.own("items%", place.load(), None),
                    false => Value::Place(place),
                }
            }
        };
        self.stand_in(elements, "items%", given);
        Ok(())
    }

    /// Starts a generator function: lowers the statements before its loop here, as Rust runs them when it creates the
    /// iterator, and evaluates the loop's source. Returns the loop; none if the function does not end in one.
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
            // An assertion of the library runs where the iterator is made.
            let is_assert = |it: &&Stmt| matches!(it, Stmt::Expr(_)) && is_of_library(function);
            let stmts = before.iter().filter(|it| !is_assert(it)).cloned().collect();
            inner.stmts(&tree::Block { stmts, tail: None })?;
            let mut each = each.clone();
            inner.create_items(&mut each)?;
            let (name, parameters, body) = (None, Vec::new(), Box::new(each));
            Ok(Some(inner.written_here(tree::Closure { name, parameters, body })))
        })
    }

    /// Emits the assertions before the loop of a function of the DSL, since std makes them when it creates the
    /// iterator. Its locals change with each item, so each loop begins with them.
    fn assert_first(
        &mut self,
        function: &'a tree::Function,
        arguments: &[tree::Expr],
        site: Site,
    ) -> Result<()> {
        let Some((_, before)) = function.tree.body.stmts.split_last() else { return Ok(()) };
        let asserts = before.iter().take_while(|stmt| matches!(stmt, Stmt::Expr(_)));
        let asserts: Vec<_> = asserts.cloned().collect();
        if asserts.is_empty() {
            return Ok(());
        }
        let given = self.given_to(function, arguments)?;
        self.inside(function, given, site, |inner| {
            inner.stmts(&tree::Block { stmts: asserts, tail: None })
        })
    }

    /// Returns true if an expression names a variable that holds a slice, since another slice may be assigned to it.
    fn is_held_slice(&mut self, expr: &tree::Expr) -> bool {
        let named = bare(expr);
        !self.cx.types.borrowed.is_empty()
            && is_named(named, false)
            && self.place_type(named).is_ok_and(|ty| self.cx.as_borrowed(&ty).is_some())
    }

    /// Returns true if elements belong to a borrowed variable, which does not change.
    fn is_borrowed_variable(&mut self, elements: &tree::Expr) -> Result<bool> {
        if !is_named(elements, false) {
            return Ok(false);
        }
        Ok(!self.place(elements)?.is_some_and(|place| self.is_loan(&place)))
    }

    /// Replaces an expression by a new unique name for `given`.
    pub(super) fn stand_in(&mut self, expr: &mut tree::Expr, name: &str, given: Value) {
        let known = self.scopes.len();
        let name = format!("{name}{known}");
        self.bind(&name, given);
        *expr = tree::Expr::local(&name, expr.site);
    }
}
