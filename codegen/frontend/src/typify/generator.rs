//! Functions that return or take iterators, inlined where their items are consumed.
//!
//! A function that returns an iterator passes each item to a closure. A loop over its result is the function's own
//! loop, with the author's body in the closure's place. An iterator argument is such a closure too: a loop over the
//! parameter is the loop in the argument.
//!
//! Invariant: exactly one loop of the function yields items, so a `break` or `continue` in the body leaves that loop.

use std::rc::Rc;

use bessemer_ir::tree::visit::{Visit, Walk, walk_expr};
use bessemer_ir::tree::{
    self, EACH, ExprKind as Tree, ITER, ITER_MUT, NO_SLOT, Pattern, Site, Source, Stmt,
};
use bessemer_ir::{Expr, Int, Scalar, StmtKind};

use super::by_hand::{takes, taking_next};
use super::callee::Called;
use super::closure_args::is_hidden;
use super::consumed::{Sides, is_borrowed, zipped};
use super::each::Each;
use super::items::{self, handing};
use super::lowering::{Closure, Lowering, Way, local_since};
use super::nested::{continue_parts, parts_in};
use super::numbered::hands_on;
use super::seq::{elements_through, pair};
use super::syntax::generates;
use super::value::Value;
use super::words;
use super::{Result, refusals, refused};
use crate::standard::is_zip;

/// Source of the items.
pub(super) enum By<'a, 'e> {
    /// A call of a generator function.
    Call(Called<'a, 'e>),
    /// An iterator argument.
    Argument(Rc<Closure<'a>>),
    /// A closure that returns an iterator.
    Closure(&'e str, &'e [tree::Expr]),
}

impl By<'_, '_> {
    /// Returns true if it yields elements or numbers unchanged.
    pub(super) fn has_elements(&self) -> bool {
        matches!(self, By::Argument(through) if elements_through(through).is_some())
    }
}

/// Returns the authors' `iter` methods, except of types that also have an `iter_mut`.
pub(super) fn own_iterators(package: &tree::Package) -> Vec<&tree::Function> {
    let named = |name| {
        let all = package.functions.iter().filter(|it| it.owner.is_some());
        all.filter(move |it| it.tree.name == name)
    };
    let changed: Vec<_> = named(ITER_MUT).map(|it| &it.owner).collect();
    named(ITER).filter(|it| !changed.contains(&&it.owner)).collect()
}

impl<'a> Lowering<'a, '_> {
    /// Returns the sequence of a loop if a function generates it.
    pub(super) fn generated<'e>(&mut self, source: &'e Source) -> Result<Option<By<'a, 'e>>> {
        let leaves = source.leaves();
        for leaf in &leaves {
            let Source::Elements(of, _) = leaf else { continue };
            let by = if let Some(called) = self.expansion(of).filter(|it| generates(it.0)) {
                By::Call(called)
            } else if let Tree::Apply(name, arguments) = &of.kind {
                By::Closure(name, arguments)
            } else if let Some(closure) = self.iterator_copied(of) {
                let closure = from_the_end(self, source, of).unwrap_or(closure);
                let through = Rc::clone(&self.closures[closure]);
                // Elements stand beside others.
                if leaves.len() > 1 && elements_through(&through).is_some() {
                    continue;
                }
                By::Argument(through)
            } else {
                continue;
            };
            if leaves.len() > 1 {
                return refused(of.site, refusals::BY_ITSELF);
            }
            return Ok(Some(by));
        }
        Ok(None)
    }

    /// Lowers `for (a, b) in one.zip(other)` where `other` has no elements to index. The loop iterates over `one`, and
    /// each pass takes the next item of `other`. Returns false if `other` has elements.
    pub(super) fn each_beside(&mut self, each: Each) -> Result<bool> {
        let (Source::Zip(one, other, Some(next)), site) = (each.source, each.site) else {
            return Ok(false);
        };
        let Source::Elements(of, _) = &**other else { return Ok(false) };
        if self.generated(other)?.is_none_or(|by| by.has_elements()) {
            return Ok(false);
        }
        let [pattern, item] = pair(each.pattern, site)?;
        // Rust evaluates the operands of `zip` from left to right.
        let mut source = (**one).clone();
        self.create_source(&mut source)?;
        let Value::Closure(through) = self.gone_through(of)? else { return Ok(false) };
        if let Source::Elements(one, _) = &mut source
            && let Some(named) = self.iterator_named(one)
        {
            let sides = Sides { one: named, other: through, arguments: [one, of] };
            let ended = zipped(self, &sides, each.body)?;
            if ended != named {
                self.stand_in(one, "limited%", Value::Closure(ended));
            }
        }
        let name = match &of.kind {
            Tree::Local(name) if !is_hidden(name) => name,
            _ => words::OTHERS,
        };
        let through = self.counted(name, through, site)?;
        self.naming_scope(|inner| {
            inner.bind(OTHERS, Value::Closure(through));
            let others = tree::Expr::local(OTHERS, site);
            let next = tree::Expr::plain(Tree::Call(*next, vec![others]), site);
            let body = taking_next(item, next, each.body, site);
            inner.each_stmt(Each { pattern, source: &source, body: &body, ..each })
        })?;
        Ok(true)
    }

    /// Lowers `for pattern in function(arguments)`.
    pub(super) fn generated_stmt(
        &mut self,
        by: By<'a, '_>,
        Each { site, label, pattern, source, body, .. }: Each,
    ) -> Result<()> {
        let handed = body;
        let text = match &by {
            By::Argument(through) => Some(&*through.text.body),
            // What is counted before a loop is counted from the first item on.
            By::Call((function, _)) => match &function.tree.body.stmts[..] {
                [Stmt::Expr(through)] => Some(through),
                _ => None,
            },
            By::Closure(..) => None,
        };
        let way = match &by {
            By::Argument(through) => through.way,
            _ => Way::Any,
        };
        let going = |links: &Source| match (links, way) {
            (Source::Elements(..), Way::Any | Way::Forward) => text.cloned(),
            (Source::Rev(of), Way::Back) if matches!(**of, Source::Elements(..)) => text.cloned(),
            (_, Way::Any) => text.and_then(|text| going(links, text)),
            _ => None,
        };
        let (links, counted) = match source {
            Source::Enumerate(of) if going(source).is_none() => (&**of, true),
            _ => (source, false),
        };
        let itself = going(links);
        let parts = match (&by, parts_in(links)) {
            (By::Closure(..), Some((name, _))) => Some((name, self.lookup(name, site)?)),
            _ => None,
        };
        if itself.is_none() && parts.is_none() && !matches!(links, Source::Elements(..)) {
            return refused(site, refusals::ONE_BY_ONE);
        }
        self.naming_scope(|inner| {
            let (mut body, mut pattern) = (body.clone(), pattern.clone());
            if counted {
                let [number, item] = pair(&pattern, site)?.map(Pattern::clone);
                inner.count_items(&number, &mut body, site)?;
                pattern = item;
            }
            let body = tree::Expr::plain(Tree::Block(body), site);
            let (name, parameters, body) = (None, vec![pattern], Box::new(body));
            let closure = tree::Closure { name, parameters, body };
            let outermost = Some((label.map(str::to_owned), inner.frames.len()));
            let each = Closure { outermost, ..inner.written_here(closure) };
            let each = Value::Closure(inner.closure(each));
            match by {
                By::Call((function, arguments)) => {
                    if let Some(first) = arguments.first() {
                        inner.check_settled((function, hands_on(handed)), first)?;
                    }
                    let mut bound = match arguments {
                        [one, other] if is_zip(function) => {
                            zip_arguments(inner, function, [one, other], handed)?
                        }
                        _ => inner.given_to(function, arguments)?,
                    };
                    bound.push((EACH.to_owned(), each));
                    let mut text = function.tree.body.clone();
                    if let (Some(itself), Some(last)) = (itself, text.stmts.last_mut()) {
                        *last = Stmt::Expr(itself);
                    }
                    inner.inside(function, bound, site, |inner| inner.statements(&text))
                }
                By::Argument(handed) => {
                    let text = itself.unwrap_or_else(|| (*handed.text.body).clone());
                    inner.in_scope_of(&handed, Some(each), site, |inner| inner.effect(&text))
                }
                By::Closure(name, arguments) => {
                    inner.applied(name, arguments, site, |inner, closure| {
                        inner.bind(EACH, each);
                        let mut text = through(&closure.body);
                        if let Some((name, count)) = parts {
                            inner.bind(name, count);
                            continue_parts(inner, &mut text, name)?;
                        }
                        inner.effect(&text)
                    })
                }
            }
        })
    }

    /// Returns the item that a function passes on. For a named element it is its place, by the counter of the
    /// function's loop; a value is named by its consumer.
    pub(super) fn item(
        &mut self,
        expr: &tree::Expr,
        taken: Option<&tree::Pattern>,
    ) -> Result<Value> {
        match &expr.kind {
            Tree::Tuple(parts) if expr.slot.is_none() => {
                let parts = parts.iter().map(|part| self.item(part, None));
                Ok(Value::Tuple(parts.collect::<Result<_>>()?, None))
            }
            Tree::Local(name) => match self.lookup(name, expr.site)? {
                known @ (Value::Place(_) | Value::Slice(_)) => Ok(known),
                Value::Local(local) if !self.locals.is_counter(local) => {
                    // Nothing else writes to it: it was made to be handed on.
                    self.locals.note_temporary(local);
                    let item = self.subject(expr)?;
                    if let Some(taken) = taken {
                        self.name_own(taken, &item, Some(0));
                    }
                    Ok(item)
                }
                _ => self.subject(expr),
            },
            _ => {
                let before = self.locals.len();
                let subject = self.subject(expr)?;
                if let Some(tree::Pattern::Name { name, .. }) = taken {
                    self.name_held(&subject, before, name);
                }
                Ok(subject)
            }
        }
    }

    /// Returns the last computed value of a subject, if it is read once, and next.
    pub(super) fn just_computed(&mut self, subject: &Value, before: usize) -> Option<Expr> {
        let Value::Place(place) = subject else { return None };
        let own = local_since(place, before)?;
        let is_it = |last: &mut bessemer_ir::Stmt| match &last.kind {
            StmtKind::Let { local, value: Some(_) } => *local == own,
            _ => false,
        };
        match self.out.pop_if(is_it)?.kind {
            StmtKind::Let { value, .. } => value,
            _ => None,
        }
    }

    /// Adds a counter of the items, from zero on, bound to `number`.
    pub(super) fn count_items(
        &mut self,
        number: &Pattern,
        body: &mut tree::Block,
        site: Site,
    ) -> Result<()> {
        let plain = |kind| tree::Expr::plain(kind, site);
        let size = Some(Scalar::Int(Int::Usize));
        let digits = |digits: &str| plain(Tree::Int(digits.into(), size));
        let next = || tree::Expr::local(NUMBER, site);
        let named = |name: &str, value| {
            let (name, value) = (name.into(), Some(value));
            Stmt::Let { name, slot: NO_SLOT, value, site, mutable: true }
        };
        let Pattern::Name { name, .. } = number else { return Ok(()) };
        let more = Tree::Assign(Some(tree::BinaryOp::Add), Box::new(next()), Box::new(digits("1")));
        body.stmts.splice(0..0, [named(name, next()), Stmt::Expr(plain(more))]);
        let begin = tree::Block { stmts: vec![named(NUMBER, digits("0"))], tail: None };
        self.stmts(&begin)
    }
}

/// Returns the closure by which a reversed source takes the items of a counted iterator. It is the reversed loop, or, if nothing
/// takes more items afterwards, the loop that counts nothing.
fn from_the_end(lowering: &Lowering, source: &Source, of: &tree::Expr) -> Option<usize> {
    let source = if let Source::Enumerate(of) = source { of } else { source };
    let Source::Rev(_) = source else { return None };
    let named = lowering.iterator_named(of)?;
    let hand = lowering.hands.get(&named)?;
    let is_moved = !is_borrowed(lowering, of) && !lowering.closures[named].borrowed;
    match hand.last {
        Some((_, back)) => Some(back),
        None => (is_moved && !hand.stateful).then_some(hand.again),
    }
}

/// Returns the meanings of the parameters of `zip`: the first side ends where Rust takes no more of it.
fn zip_arguments<'a>(
    lowering: &mut Lowering<'a, '_>,
    function: &'a tree::Function,
    arguments: [&tree::Expr; 2],
    body: &tree::Block,
) -> Result<Vec<(String, Value)>> {
    let params = &function.tree.params;
    let mut first = lowering.given_as(function, &params[0], arguments[0])?;
    let other = items::lent(arguments[1]);
    if lowering.own_next(other).is_some() {
        return Ok(vec![first, lowering.given_as(function, &params[1], other)?]);
    }
    let second = lowering.gone_through(other)?;
    if let (Value::Closure(one), Value::Closure(other)) = (&mut first.1, &second) {
        let sides = Sides { one: *one, other: *other, arguments };
        *one = zipped(lowering, &sides, body)?;
    }
    let name = &params[1].name;
    let second = lowering.by_hand(name, second, function, other.site)?;
    Ok(vec![first, (name.clone(), second)])
}

/// Returns a loop that yields each item after the given adapters; none if an adapter needs state.
pub(super) fn going(links: &Source, through: &tree::Expr) -> Option<tree::Expr> {
    let (of, counted) = match links {
        Source::Rev(of) => (of, false),
        Source::Enumerate(of) => (of, true),
        Source::Elements(..) => return Some(through.clone()),
        _ => return None,
    };
    let mut text = going(of, through)?;
    let Tree::Each { pattern, source, body, .. } = &mut text.kind else { return None };
    if takes(pattern) {
        return None;
    }
    let mut hands = Hands { each: 0, ends: false };
    hands.block(body);
    // What ends early, or hands on in loops of its own, has no other way.
    if hands.each != 1 || (hands.ends && !counted) {
        return None;
    }
    let array = Source::Elements(tree::Expr::local(COUNTER, through.site), false);
    let inner = Box::new(std::mem::replace(&mut **source, array));
    if !counted {
        **source = Source::Rev(inner);
        return Some(text);
    }
    let (mut number, known) = (COUNTER.to_owned(), pattern.bound());
    while known.contains(&number) {
        number.push('%');
    }
    with_number(body, &number)?;
    **source = Source::Enumerate(inner);
    let item = std::mem::replace(&mut **pattern, Pattern::Any);
    **pattern = Pattern::Tuple(vec![Pattern::name(&number), item]);
    Some(text)
}

/// Adds a number to each item that a pass yields.
fn with_number(body: &mut tree::Block, number: &str) -> Option<()> {
    let Some(Stmt::Expr(tree::Expr { kind: Tree::Apply(name, items), site, .. })) =
        body.stmts.last_mut().filter(|_| body.tail.is_none())
    else {
        return None;
    };
    if name != EACH {
        return None;
    }
    let number = tree::Expr::local(number, *site);
    let pair = std::iter::once(number).chain(std::mem::take(items)).collect();
    *items = vec![tree::Expr::plain(Tree::Tuple(pair), *site)];
    Some(())
}

/// Counts of the yields in a loop.
struct Hands {
    /// Number of places that yield; a nested loop counts as two.
    each: usize,
    /// True if a pass may end the loop.
    ends: bool,
}

impl Visit for Hands {
    fn expr(&mut self, expr: &tree::Expr) {
        match &expr.kind {
            Tree::Apply(name, _) if name == EACH => self.each += 1,
            Tree::Break(..) => self.ends = true,
            Tree::Each { .. } | Tree::While { .. } => {
                let mut inner = Hands { each: 0, ends: false };
                walk_expr(&mut inner, expr);
                self.each += 2 * inner.each;
            }
            _ => walk_expr(self, expr),
        }
    }
}

/// Name of the index of a yielded element.
const COUNTER: &str = "i%";

/// Name of the second iterator of a `zip`, of which each pass takes one item.
const OTHERS: &str = "others%";

/// Name of the number of the next item.
pub(super) const NUMBER: &str = "next%";

/// Returns a loop over the iterator that a closure's body returns.
fn through(body: &tree::Expr) -> tree::Expr {
    match &body.kind {
        Tree::Block(tree::Block { stmts, tail: Some(tail) }) => {
            let mut stmts = stmts.clone();
            stmts.push(Stmt::Expr(through(tail)));
            tree::Expr::plain(Tree::Block(tree::Block { stmts, tail: None }), body.site)
        }
        _ => *handing(body).body,
    }
}
