//! Adapters with a loop in their loop, `flat_map` and `flatten`, whose items are taken by explicit `next` calls.
//!
//! A local counts the items of the first iterator that are finished, and another the parts that were taken of the present
//! one. Each loop makes the present item anew, and continues after these parts.
//!
//! Invariant: whatever yields the items and their parts writes nothing and calls no external function, so it yields the same
//! ones when it is evaluated again.
//! Any other such iterator is refused.
//!
//! Must not know: which methods consume an iterator.

use std::collections::BTreeSet;

use bessemer_ir::tree::visit::{Visit, Walk, walk_pattern};
use bessemer_ir::tree::{
    self, Builtin, Callee, EACH, ExprKind as Tree, Pattern, Site, Source, Stmt, Ty,
};
use bessemer_ir::{Expr, LocalId, Type};

use super::by_hand::{Change, begun_of};
use super::lowering::{Closure, Lowering, Nested, Way};
use super::scopes::Names;
use super::syntax::bare;
use super::value::Value;
use super::{Result, refusals, refused};

/// First part of the names of the counts of finished items, and of the parts that were taken.
const FINISHED: &str = "finished%";
const OF_ITEM: &str = "parts%";

/// Returns the name of the count of parts in a source that continues after them, and the source of all parts.
pub(super) fn parts_in(source: &Source) -> Option<(&str, &Source)> {
    match source {
        Source::Skip(of, tree::Expr { kind: Tree::Local(name), .. })
            if name.starts_with(OF_ITEM) =>
        {
            Some((name, of))
        }
        _ => None,
    }
}

/// Returns the iterator as a counted one if its function is a loop in a loop; none for any other function.
pub(super) fn nested<'a>(
    lowering: &mut Lowering<'a, '_>,
    name: &str,
    function: &tree::Function,
    mut own: Closure<'a>,
    site: Site,
) -> Result<Option<usize>> {
    let Some(items) = function.tree.params.iter().find(|it| it.items) else { return Ok(None) };
    let Some(&Value::Closure(of)) = own.scope.names.meaning(&items.name) else {
        return Ok(None);
    };
    let number = lowering.closures.len();
    let [finished, parts] = [FINISHED, OF_ITEM].map(|of| format!("{of}{number}"));
    let begun = begun_of(&finished);
    let outer = (*lowering.closures[of]).clone();
    if lowering.hands.iter().any(|(it, hand)| *it == of || hand.again == of)
        || outer.way != Way::Any
        || !evaluates_again(lowering, &outer)
    {
        return Ok(None);
    }
    for param in function.tree.params.iter().filter(|it| it.closure && it.name != EACH) {
        let Some(&Value::Closure(made)) = own.scope.names.meaning(&param.name) else {
            continue;
        };
        let made = (*lowering.closures[made]).clone();
        if !evaluates_again(lowering, &made) {
            return refused(site, refusals::NESTED_WRITES);
        }
    }
    let Some(text) = counted(lowering, &outer, &finished, Change::Enter)? else { return Ok(None) };
    let Some(left) = counted(lowering, &outer, &finished, Change::Begin)? else { return Ok(None) };
    let whole = own.clone();
    let resumed = lowering.in_scope_of(&own.clone(), None, site, |inner| {
        Ok(continued(inner, &mut own.text.body, [&finished, &begun, &parts]))
    })?;
    if !resumed {
        return Ok(None);
    }
    let none = Expr::usize(0, lowering.span(site));
    let mut local = |role: &str| lowering.let_local(format!("{name}_{role}"), none.clone()).root;
    let locals = [local("taken"), local("begun"), local("part")];
    let kept = [finished, begun, parts];
    let below: Names = kept.iter().cloned().zip(locals.map(Value::Local)).collect();
    let over = |lowering: &mut Lowering<'a, '_>, own: &mut Closure<'a>, text: tree::Expr| {
        let mut outer = Closure { way: Way::Forward, ..outer.clone() };
        *outer.text.body = text;
        outer.scope.names.push(below.clone());
        let outer = lowering.closure(outer);
        own.way = Way::Forward;
        own.scope.names.push(below.clone());
        own.scope.names.push(vec![(items.name.clone(), Value::Closure(outer))]);
    };
    over(lowering, &mut own, text);
    let passes = passes(whole).map(|mut passes| {
        over(lowering, &mut passes, left);
        lowering.closure(passes)
    });
    let both = [own.clone(), own];
    let [taken, _, parts] = locals;
    let counted = lowering.over_state(both, parts, Vec::new());
    if let Some(hand) = lowering.hands.get_mut(&counted) {
        let items = items.name.clone();
        (hand.kept, hand.nested) =
            (kept.to_vec(), Some(Nested { items, counts: [taken, parts], passes }));
    }
    Ok(Some(counted))
}

/// Returns the whole loop in a loop, with passes without items.
fn passes(mut whole: Closure) -> Option<Closure> {
    let Tree::Each { body, .. } = &mut whole.text.body.kind else { return None };
    let [Stmt::Expr(inner)] = &mut body.stmts[..] else { return None };
    inner.without_items(EACH);
    Some(whole)
}

/// Returns the loop of the first iterator, which begins after the finished items.
fn counted<'a>(
    lowering: &mut Lowering<'a, '_>,
    outer: &Closure<'a>,
    finished: &str,
    change: Change,
) -> Result<Option<tree::Expr>> {
    let mut text = (*outer.text.body).clone();
    lowering.in_scope_of(outer, None, text.site, |inner| {
        Ok(inner.count(&mut text, finished, change).then_some(text))
    })
}

/// Lets the inner loop continue after the parts that were taken, and count them. Returns false for another function.
fn continued(
    lowering: &mut Lowering,
    text: &mut tree::Expr,
    [finished, begun, parts]: [&str; 3],
) -> bool {
    let site = text.site;
    let Tree::Each { body, .. } = &mut text.kind else { return false };
    let ([Stmt::Expr(inner)], None) = (&mut body.stmts[..], &body.tail) else { return false };
    let Tree::Each { source, .. } = &mut inner.kind else { return false };
    let is_made =
        matches!(&**source, Source::Elements(of, _) if matches!(of.kind, Tree::Apply(..)));
    if is_made {
        // Its loop is the closure's, and is changed there.
        **source = (**source).clone().behind(parts, site);
    } else if !lowering.count(inner, parts, Change::Parts) {
        return false;
    }
    body.assign_behind(finished, Some(begun), site);
    body.assign_behind(parts, None, site);
    true
}

/// Changes the loop over the parts of an item, which continues after those that were taken.
pub(super) fn continue_parts(
    lowering: &mut Lowering,
    text: &mut tree::Expr,
    parts: &str,
) -> Result<()> {
    let done = match &mut text.kind {
        Tree::Block(block) => match block.stmts.last_mut() {
            Some(Stmt::Expr(last)) => return continue_parts(lowering, last, parts),
            _ => false,
        },
        _ => lowering.count(text, parts, Change::Parts),
    };
    match done {
        true => Ok(()),
        false => refused(text.site, refusals::BY_HAND),
    }
}

/// Copies the loop of the first iterator with copies of the counts, for a copy of the iterator.
pub(super) fn with_copies<'a>(
    lowering: &mut Lowering<'a, '_>,
    all: &mut [Closure<'a>],
    nested: &Nested,
    copies: &[(String, Value)],
) -> Option<Nested> {
    let &Value::Closure(below) = all.first()?.scope.names.meaning(&nested.items)? else {
        return None;
    };
    let mut below = (*lowering.closures[below]).clone();
    below.scope.names.push(copies.to_vec());
    let below = Value::Closure(lowering.closure(below));
    for closure in all {
        closure.scope.names.push(vec![(nested.items.clone(), below.clone())]);
    }
    let counts = [FINISHED, OF_ITEM].map(|of| {
        copies.iter().find_map(|(name, copy)| match copy {
            Value::Local(local) if name.starts_with(of) => Some(*local),
            _ => None,
        })
    });
    let [Some(finished), Some(parts)] = counts else { return None };
    Some(Nested { items: nested.items.clone(), counts: [finished, parts], passes: None })
}

/// Returns true if an iterator, or a closure, writes nothing and continues no other iterator: evaluated again, it yields the same.
/// A closure whose items the consumer may write in between is none.
fn evaluates_again<'a>(lowering: &mut Lowering<'a, '_>, closure: &Closure<'a>) -> bool {
    let mut exclusive = Exclusive { slots: &closure.source.slots, is_there: false };
    closure.text.parameters.iter().for_each(|it| exclusive.pattern(it));
    exclusive.expr(&closure.text.body);
    if exclusive.is_there {
        return false;
    }
    let body = &closure.text.body;
    let again = lowering.in_scope_of(closure, None, body.site, |inner| {
        Ok(!body.any_expr(|it| may_write(inner, it)))
    });
    again.unwrap_or(false)
}

/// Visitor that looks for a name of a mutable reference.
struct Exclusive<'s> {
    slots: &'s [Ty],
    is_there: bool,
}

impl Visit for Exclusive<'_> {
    fn pattern(&mut self, pattern: &Pattern) {
        if let Pattern::Name { slot, .. } = pattern {
            self.is_there |= self.slots.get(*slot as usize).is_some_and(is_exclusive);
        }
        walk_pattern(self, pattern);
    }
}

fn is_exclusive(ty: &Ty) -> bool {
    match ty {
        Ty::Ref(_, true) => true,
        Ty::Ref(of, _) | Ty::Option(of) | Ty::Array(of, _) => is_exclusive(of),
        Ty::Tuple(parts) => parts.iter().any(is_exclusive),
        _ => false,
    }
}

fn may_write(lowering: &Lowering, expr: &tree::Expr) -> bool {
    if let Some(Callee::Function(path)) = lowering.operator(expr.slot)
        && calls_external(lowering, path)
    {
        return true;
    }
    match &expr.kind {
        Tree::Assign(_, place, _) | Tree::Ref(true, place) => changes(lowering, place).is_some(),
        Tree::Apply(name, _) => name != EACH,
        Tree::Call(_, arguments) => match lowering.called(expr) {
            Some((function, _)) if calls_external(lowering, &function.path) => true,
            Some((function, _)) => {
                let params = function.tree.params.iter();
                params.zip(arguments).any(|(param, argument)| {
                    let borrows = |ty: &Ty| matches!(ty, Ty::Ref(_, true));
                    let borrows = function.slots.get(param.slot as usize).is_some_and(borrows);
                    (borrows || param.items || param.mutable)
                        && changes(lowering, argument).is_some()
                })
            }
            None => {
                let is_copy = matches!(lowering.builtin_call(expr), Some((Builtin::Owned, _)));
                !is_copy && arguments.iter().any(|it| is_state(lowering, it))
            }
        },
        _ => false,
    }
}

/// Returns true if the function at a path may call an external one, which may count its calls.
fn calls_external(lowering: &Lowering, path: &str) -> bool {
    let (mut seen, mut open) = (BTreeSet::new(), vec![path]);
    while let Some(path) = open.pop() {
        let function = lowering.cx.calls.all.get(path);
        let Some(function) = function.filter(|_| seen.insert(path)) else { continue };
        if function.tree.attributes.external.is_some() {
            return true;
        }
        let operators = function.operators.iter().map(|(_, callee)| callee);
        open.extend(function.callees.iter().chain(operators).filter_map(|callee| match callee {
            Callee::Function(path) => Some(path.as_str()),
            Callee::Builtin(_) => None,
        }));
    }
    false
}

/// Returns true for a variable that a call may write: no number, which a method takes by value, and no element of a loop.
fn is_state(lowering: &Lowering, argument: &tree::Expr) -> bool {
    changes(lowering, argument).is_some_and(|ty| !matches!(ty, Some(ty) if ty.is_word()))
}

/// Returns the type of a variable that may be written, if an expression is a part of one; the type is none for an iterator.
fn changes(lowering: &Lowering, place: &tree::Expr) -> Option<Option<Type>> {
    let root = match &bare(place).kind {
        Tree::Local(name) => name,
        Tree::Field(base, _) | Tree::Index(base, _) => return changes(lowering, base),
        _ => return None,
    };
    let changing = |local: LocalId| {
        lowering.locals.may_change(local).then(|| Some(lowering.locals[local.index()].ty.clone()))
    };
    match lowering.lookup(root, place.site).ok()? {
        Value::Local(local) => changing(local),
        Value::Place(place) => changing(place.root),
        Value::Slice(slice) => changing(slice.base.root),
        Value::Closure(_) => Some(None),
        _ => None,
    }
}
