//! Iterator arguments: closures that yield each item, and values that are converted for iteration.
//!
//! An iterator is evaluated where it is an argument ([`settled`](super::settled)), and consumed later. A copy of an
//! iterator has a copy of its state. A stored range becomes its numbers, as in `for hour in window.hours.clone()`. A value
//! with an author's `iter` becomes a call of it.
//!
//! Invariant: no loop takes numbers from a range in a variable, since it would have to change the variable.
//!
//! Must not know: how an iterator is consumed ([`generator`](super::generator)), or how slices are represented.

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{
    self, Builtin, Desugared, EACH, ExprKind as Tree, NO_SLOT, Range, Site, Source, Stmt, Ty,
};
use bessemer_ir::{Place, Type};

use super::closure_args::is_hidden;
use super::lowering::Lowering;
use super::slots::result_of;
use super::syntax::generates;
use super::value::Value;
use super::{Result, refusals, refused};

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

/// Copies an author's own iterator.
pub(super) fn copied(lowering: &mut Lowering, own: &Place) -> Place {
    lowering.iterator_copy(own.load())
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
        self.create_items(&mut closure.body)?;
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
        // The copy of a counted one copies its state itself.
        let counted = self.hands.values().find(|hand| hand.again == known);
        Some(match counted.map(|hand| hand.stateful) {
            Some(true) if copies => self.copy_of_hand(known),
            None if copies => self.copy_of_chain(known),
            _ => known,
        })
    }

    /// Copies an iterator, with copies of the own iterators and the counted iterators in its chain.
    fn copy_of_chain(&mut self, known: usize) -> usize {
        let mut closure = (*self.closures[known]).clone();
        let mut copies = Vec::new();
        for name in closure.text.body.locals() {
            let copy = match closure.scope.names.meaning(&name) {
                Some(Value::Place(own)) if is_hidden(&name) && self.cx.holds_iterator(&own.ty) => {
                    Value::Place(copied(self, &own.clone()))
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
        closure.scope.names.push(copies);
        self.closure(closure)
    }

    /// Replaces stored ranges in a source by their numbers, and types with an author's `iter` by its call. Returns
    /// none if it has neither.
    pub(super) fn meant(&mut self, source: &Source) -> Option<Source> {
        let mut inner = |of: &Source| self.meant(of).map(Box::new);
        Some(match source {
            Source::Elements(of, owned) => match self.numbers_of(of) {
                Some(range) => Source::Numbers(range),
                // A loop by value calls `into_iter`, which may give something else.
                None if *owned => return None,
                None => Source::Elements(self.own_iter(of)?, false),
            },
            Source::Zip(one, other, next) => {
                let (one, other) = both(one, other, [inner(one), inner(other)])?;
                Source::Zip(one, other, *next)
            }
            Source::Chain(one, other) => {
                let (one, other) = both(one, other, [inner(one), inner(other)])?;
                Source::Chain(one, other)
            }
            Source::Enumerate(of) => Source::Enumerate(inner(of)?),
            Source::Rev(of) => Source::Rev(inner(of)?),
            Source::Cycle(of) => Source::Cycle(inner(of)?),
            Source::Skip(of, count) => Source::Skip(inner(of)?, count.clone()),
            Source::Take(of, count) => Source::Take(inner(of)?, count.clone()),
            Source::StepBy(of, step) => Source::StepBy(inner(of)?, step.clone()),
            Source::Numbers(_) | Source::Groups(..) => return None,
        })
    }

    /// Returns the call of an author's `iter`, since the adapter belongs to the iterator. Returns none for a type
    /// that also has an `iter_mut`, since either may be meant.
    fn own_iter(&mut self, of: &tree::Expr) -> Option<tree::Expr> {
        let is_place = matches!(of.kind, Tree::Local(_) | Tree::Field(..) | Tree::Index(..));
        if !is_place || self.cx.calls.own_iterators.is_empty() || self.holds_nothing(of) {
            return None;
        }
        let ty = self.type_of_value(of).ok()?;
        let (path, _) = self.cx.types.by_path.iter().find(|(_, known)| **known == ty)?;
        let own = self.cx.calls.own_iterators.iter().find(|it| it.owner.as_ref() == Some(path))?;
        let is_iterator = |ty: &Ty| match ty {
            Ty::Named(path) => {
                let ty = self.cx.types.by_path.get(path);
                self.cx.implied.iterators.iter().any(|(own, _)| Some(own) == ty)
            }
            _ => false,
        };
        if !generates(own) && !result_of(own).is_some_and(is_iterator) {
            return None;
        }
        let callee = self.cx.unnamed(&own.path);
        let lent = tree::Expr::plain(Tree::Ref(false, Box::new(of.clone())), of.site);
        Some(tree::Expr::plain(Tree::Call(callee, vec![lent]), of.site))
    }

    /// Returns the numbers of a range in a place, or of its copy.
    pub(super) fn numbers_of(&mut self, of: &tree::Expr) -> Option<Range> {
        self.numbers_in(self.copied(of).unwrap_or(of))
    }

    /// Refuses `range.next()` and the like, which would change the range in the variable.
    pub(super) fn check_taken(&mut self, of: &tree::Expr) -> Result<()> {
        match &of.kind {
            // A copy that has no name.
            Tree::Local(name) if is_hidden(name) => Ok(()),
            _ if self.numbers_in(of).is_some() => refused(of.site, refusals::RANGE_TAKEN),
            _ => Ok(()),
        }
    }

    /// Returns the operand that an expression copies.
    fn copied<'e>(&self, expr: &'e tree::Expr) -> Option<&'e tree::Expr> {
        match self.builtin_call(expr)? {
            (Builtin::Owned | Builtin::Desugared(Desugared::AsRef), of) => of.first(),
            _ => None,
        }
    }

    fn numbers_in(&mut self, of: &tree::Expr) -> Option<Range> {
        // Whatever else is wrong with it is reported where it is lowered.
        let ty = is_place(of).then(|| self.place_type(of).ok())??;
        let (Type::Struct(id), inclusive) = (&ty, self.cx.known(&ty).range?) else { return None };
        let mut ends = self.cx.fields(*id).iter().map(|end| {
            tree::Expr::plain(Tree::Field(Box::new(of.clone()), end.name.clone()), of.site)
        });
        Some(Range { from: ends.next()?, to: Some(ends.next()?), inclusive, slot: NO_SLOT })
    }

    /// Returns the type of the numbers in a range. A stored range has no slot for it.
    pub(super) fn type_of_numbers(&mut self, range: &Range, site: Site) -> Result<Type> {
        match range.slot {
            NO_SLOT => self.place_type(&range.from),
            slot => self.slot(slot, site),
        }
    }
}

/// Returns true for a place that may be evaluated twice: its indices are names and literals.
fn is_place(expr: &tree::Expr) -> bool {
    match &expr.kind {
        Tree::Local(_) => true,
        Tree::Field(base, _) | Tree::Deref(base) => is_place(base),
        Tree::Index(base, index) => {
            is_place(base) && matches!(index.kind, Tree::Local(_) | Tree::Int(..))
        }
        _ => false,
    }
}

/// Returns two sources with the replaced ones in place; none if neither was replaced.
fn both(
    one: &Source,
    other: &Source,
    meant: [Option<Box<Source>>; 2],
) -> Option<(Box<Source>, Box<Source>)> {
    let [first, second] = meant;
    if first.is_none() && second.is_none() {
        return None;
    }
    let or =
        |meant: Option<Box<Source>>, of: &Source| meant.unwrap_or_else(|| Box::new(of.clone()));
    Some((or(first, one), or(second, other)))
}
