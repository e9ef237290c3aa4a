//! What is matched, or given to a closure: a value that is held, a place, or the parts of a tuple that is never made.
//!
//! Invariant: a part that is a value stays what it was where it stood, whatever later parts, or guards, write; one that is a
//! reference stays one.
//!
//! Must not know: what patterns ask of it ([`pattern`](super::pattern)).

use bessemer_ir::tree::{self, ExprKind as Tree, Pattern};
use bessemer_ir::{Expr, Place, Stmt, Type};

use super::lowering::{Lowering, local_since};
use super::order::is_settled;
use super::value::Value;
use super::{Result, words};
use bessemer_ir::effects;

impl Lowering<'_, '_> {
    /// The subject of a `match` or a `let`, computed once.
    pub(super) fn subject(&mut self, expr: &tree::Expr) -> Result<Value> {
        // One that rustc saw as a whole is matched by a name.
        if let (Tree::Tuple(parts), None) = (&expr.kind, expr.slot)
            && !parts.is_empty()
        {
            let mut subjects: Vec<Value> = Vec::new();
            for part in parts {
                let next = self.settling(
                    |inner| inner.subject(part),
                    |inner, _, later| {
                        let before = subjects.iter_mut().zip(parts);
                        before.for_each(|(it, part)| inner.settle_subject(it, part, later));
                    },
                )?;
                subjects.push(next);
            }
            return Ok(Value::Tuple(subjects, None));
        }
        if let Tree::Apply(name, arguments) = &expr.kind
            && self.stands_here(expr)
        {
            return self.applied(name, arguments, expr.site, |inner, closure| {
                inner.subject(&closure.body)
            });
        }
        if let Some(parts) = self.parts_named(expr) {
            return Ok(parts);
        }
        if let Some(part) = self.submatrix(expr)? {
            return Ok(Value::Submatrix(Box::new(part)));
        }
        if let Some(lent) = self.lent(expr)? {
            return Ok(lent);
        }
        // A number that is written out is of the type that rustc saw.
        let expected = match self.seen_as(expr) {
            Some(tree::Ty::Scalar(scalar)) => Some(Type::Scalar(*scalar)),
            _ => None,
        };
        let value = self.value(expr, expected.as_ref())?;
        Ok(self.value_subject(value))
    }

    /// The same of a pattern; a value that has to be held has the name of what the pattern takes from it.
    pub(super) fn subject_of(&mut self, pattern: &Pattern, expr: &tree::Expr) -> Result<Value> {
        let before = self.locals.len();
        let subject = self.subject(expr)?;
        taken_name(pattern).into_iter().for_each(|name| self.name_held(&subject, before, name));
        Ok(subject)
    }

    /// Names the temporary that a subject is held in, if it is none of the locals `before`.
    pub(super) fn name_held(&mut self, subject: &Value, before: usize, name: &str) {
        if let Value::Place(place) = subject
            && let Some(local) = local_since(place, before).filter(|it| self.held.contains(it))
        {
            self.atoms.remove(&local);
            self.locals[local.index()].name = name.to_owned();
        }
    }

    /// The same, its value known.
    pub(super) fn value_subject(&mut self, value: Expr) -> Value {
        if value.ty == Type::Unit {
            self.discard(value);
            return Value::Nothing;
        }
        let mut place = self.hold(value);
        // Its indices are checked also where no pattern comes to read it.
        self.fix(&mut place);
        Value::Place(place)
    }

    /// Copies what the statements to come could change; of what is lent, where it is.
    fn settle_subject(&mut self, subject: &mut Value, expr: &tree::Expr, later: &[Stmt]) {
        self.settle_parts((subject, expr), later, &|place| {
            !later.is_empty() && !is_settled(&place.load(), later)
        });
    }

    /// The same of an argument of a closure: only what the statements write is copied.
    pub(super) fn settle_argument(
        &mut self,
        subject: &mut Value,
        expr: &tree::Expr,
        later: &[Stmt],
    ) {
        let written = effects::writes(later);
        self.settle_parts((subject, expr), later, &|place| is_among(place, &written));
    }

    /// Copies those parts of a subject that are values in places which something writes.
    pub(super) fn copy_subject(
        &mut self,
        subject: &mut Value,
        expr: &tree::Expr,
        written: &[Place],
    ) {
        self.settle_parts((subject, expr), &[], &|place| is_among(place, written));
    }

    /// Settles each place of a subject that is lent, and copies each other that `changes`; all else is another name for what is
    /// there, whatever becomes of it.
    fn settle_parts(
        &mut self,
        (subject, expr): (&mut Value, &tree::Expr),
        later: &[Stmt],
        changes: &dyn Fn(&Place) -> bool,
    ) {
        match (subject, &expr.kind) {
            (Value::Tuple(parts, _), Tree::Tuple(exprs)) => {
                for both in parts.iter_mut().zip(exprs) {
                    self.settle_parts(both, later, changes);
                }
            }
            (Value::Tuple(parts, _), _) => {
                parts.iter_mut().for_each(|part| self.settle_parts((part, expr), later, changes));
            }
            // One that holds a reference is a value: another may come to stand there.
            (Value::Place(place), _) if self.is_lent(expr) && !self.is_loan(place) => {
                self.settle_place(place, later);
            }
            (Value::Place(place), _) if changes(place) => {
                *place = self.temporary_place(words::SELECTOR, place.load());
            }
            _ => {}
        }
    }

    /// Whether an expression lends a place, and is no value.
    fn is_lent(&self, expr: &tree::Expr) -> bool {
        match &expr.kind {
            Tree::Ref(..) => true,
            // Another name for a place is a reference to it.
            Tree::Local(name) => {
                matches!(self.lookup(name, expr.site), Ok(Value::Place(_)))
            }
            _ => matches!(self.seen_as(expr), Some(tree::Ty::Ref(..))),
        }
    }
}

/// Whether a place is one of those that something writes, or a part of one.
fn is_among(place: &Place, written: &[Place]) -> bool {
    written.iter().any(|written| effects::overlap(place, written))
}

/// The only name in `Some(name)`, or that of the whole, of what does not change.
pub(super) fn taken_name(pattern: &Pattern) -> Option<&str> {
    match pattern {
        Pattern::Constructor(_, parts) => match parts.as_slice() {
            [Pattern::Name { name, mutable: false, inner: None, .. }] => Some(name),
            _ => None,
        },
        Pattern::Name { name, mutable: false, .. } => Some(name),
        Pattern::Or(cases) => cases.first().and_then(taken_name),
        _ => None,
    }
}
