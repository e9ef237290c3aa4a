//! The subject of a `match`, or an argument of a closure: a held value, a place, or the parts of an unbuilt tuple.
//!
//! Invariant: a part that is a value keeps the value that it had when it was evaluated, whatever later parts or
//! guards write. A part that is a reference remains an alias.
//!
//! Must not know: how patterns test it ([`pattern`](super::pattern)).

use std::borrow::Cow;

use bessemer_ir::tree::{self, ExprKind as Tree, Pattern};
use bessemer_ir::{Expr, Place, Type};

use super::lowering::{Lowering, local_since};
use super::value::Value;
use super::{Result, words};

impl Lowering<'_, '_> {
    /// Lowers the subject of a `match` or a `let`, evaluated once.
    pub(super) fn subject(&mut self, expr: &tree::Expr) -> Result<Value> {
        // One that rustc saw as a whole is matched by a name.
        if let (Tree::Tuple(parts), None) = (&expr.kind, expr.slot)
            && !parts.is_empty()
        {
            let mut subjects: Vec<Value> = Vec::new();
            for (at, part) in parts.iter().enumerate() {
                let subject = self.subject(part)?;
                subjects.push(match at + 1 < parts.len() {
                    true => self.part_held(subject, part),
                    false => subject,
                });
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

    /// Lowers the subject of a pattern. A temporary for it is named after the pattern.
    pub(super) fn subject_of(&mut self, pattern: &Pattern, expr: &tree::Expr) -> Result<Value> {
        let before = self.locals.len();
        let subject = self.subject(expr)?;
        taken_name(pattern).into_iter().for_each(|name| self.name_held(&subject, before, &name));
        Ok(subject)
    }

    /// Renames the temporary that holds a subject, if its handle is at least `before`.
    pub(super) fn name_held(&mut self, subject: &Value, before: usize, name: &str) {
        if let Value::Place(place) = subject
            && let Some(local) =
                local_since(place, before).filter(|it| self.locals.is_temporary(*it))
        {
            self.locals.note_named(local);
            self.locals[local.index()].name = name.to_owned();
        }
    }

    /// Returns a value as a subject: the place that holds it.
    pub(super) fn value_subject(&mut self, value: Expr) -> Value {
        if value.ty == Type::Unit {
            self.discard(value);
            return Value::Nothing;
        }
        Value::Place(self.hold(value))
    }

    /// Holds the parts of a subject that are no references; a reference remains an alias.
    pub(super) fn part_held(&mut self, mut subject: Value, expr: &tree::Expr) -> Value {
        self.value_parts((&mut subject, expr), &mut |inner, place| {
            *place = inner.copied_place(words::SELECTOR, place.clone());
        });
        subject
    }

    /// Calls `change` for each part that is no reference.
    pub(super) fn value_parts(
        &mut self,
        (subject, expr): (&mut Value, &tree::Expr),
        change: &mut dyn FnMut(&mut Self, &mut Place),
    ) {
        match (subject, &expr.kind) {
            (Value::Tuple(parts, _), Tree::Tuple(exprs)) => {
                for both in parts.iter_mut().zip(exprs) {
                    self.value_parts(both, change);
                }
            }
            (Value::Tuple(parts, _), _) => {
                parts.iter_mut().for_each(|part| self.value_parts((part, expr), change));
            }
            // One that holds a reference is a value: another may come to stand there.
            (Value::Place(place), _) if self.is_lent(expr) && !self.is_loan(place) => {}
            (Value::Place(place), _) => change(self, place),
            _ => {}
        }
    }

    /// Returns true if an expression is a reference to a place, not a value.
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

/// Longest name of a pair after its parts.
const LONGEST: usize = 24;

/// Returns the only name of `Some(name)`, the name of the whole, or the names of a pair's parts, if they are immutable.
pub(super) fn taken_name(pattern: &Pattern) -> Option<Cow<'_, str>> {
    let part = |pattern| match pattern {
        &Pattern::Name { ref name, mutable: false, inner: None, .. } => Some(name.as_str()),
        _ => None,
    };
    match pattern {
        Pattern::Constructor(_, parts) => match parts.as_slice() {
            [only] => part(only).map(Cow::Borrowed),
            _ => None,
        },
        Pattern::Tuple(parts) => match parts.as_slice() {
            [first, second] => {
                let both = format!("{}_{}", part(first)?, part(second)?);
                (both.len() <= LONGEST).then_some(Cow::Owned(both))
            }
            _ => None,
        },
        Pattern::Name { name, mutable: false, .. } => Some(Cow::Borrowed(name)),
        Pattern::Or(cases) => cases.first().and_then(taken_name),
        _ => None,
    }
}
