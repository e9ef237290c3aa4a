//! Iterators with explicit `next` calls: `let mut bytes = frame.iter();`, then `bytes.next()` in several places.
//!
//! A local counts the items that were taken. Each loop over the iterator begins at this count and increments it in
//! each pass.
//!
//! Invariants: such an iterator yields at most one item per item of its source and has no state; or it is one loop of
//! a generator function, whose locals then persist between calls; or an adapter with state ([`pulled`](super::pulled)).
//! Any other iterator that is used more than once is an error.
//!
//! Must not know: which methods consume an iterator.

use std::rc::Rc;

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, EACH, ExprKind as Tree, Pattern, Site, Source, Stmt};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Int, LocalId, Scalar, Span, StmtKind, Type, effects,
};

use super::choice::takes_all;
use super::items::handing;
use super::lengths::{minus, number};
use super::lowering::{Closure, Hand, Lowering, Way};
use super::mentions::{mentions, takes_from_end};
use super::single_pass::single_pass;
use super::syntax::{generates, some_of};
use super::value::Value;
use super::{Needed, Result, refusals, refused};
use crate::standard::{is_enumerate, is_next_back, is_zip};

/// Library function for `Iterator::next`.
const NEXT: &str = "bessemer::iterate::next";

/// Library functions that compare two iterators. If std knows both lengths, it compares these first and may take no
/// item.
const COMPARED: [&str; 2] = ["bessemer::iterate::eq", "bessemer::iterate::ne"];

/// Name of an item's index, in the pattern of a counted loop.
const TAKEN: &str = "index%";

/// Name of the counted iterator below an adapter, in the adapter's call.
const WITHIN: &str = "within%";

/// Name of an iterator with as many items as another has left; a `while let` loops over it.
const PASSES: &str = "passes%";

/// A change of the innermost loop of an iterator.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// It begins after the taken items.
    Begin,
    /// It also counts each item.
    Count,
    /// It ends after a number of items.
    End,
    /// It begins after the taken items, is reversed, and moves the end to each item.
    Back,
    /// It begins after the finished items, and counts those that it begins.
    Enter,
    /// As `Count`, for the parts of an item, which each pass makes.
    Parts,
}

/// Returns true for the pattern of a loop that counts the items it takes: it also binds an index. Such a loop is
/// neither reversed nor zipped.
pub(super) fn takes(pattern: &Pattern) -> bool {
    matches!(pattern, Pattern::Tuple(parts) if matches!(&parts[..], [Pattern::Name { name, .. }, _] if name == TAKEN))
}

impl<'a> Lowering<'a, '_> {
    /// Registers a mutable named iterator, if it is one: each item is yielded once.
    pub(super) fn by_hand(
        &mut self,
        name: &str,
        iterator: Value,
        function: &tree::Function,
        site: Site,
    ) -> Result<Value> {
        let Value::Closure(through) = iterator else { return Ok(iterator) };
        if let Some(counted) = self.counted_already(through) {
            return Ok(Value::Closure(counted));
        }
        let body = &function.tree.body;
        if mentions(name, body) < 2 {
            return Ok(iterator);
        }
        let known = |path: &str| self.cx.calls.all.get(path).copied();
        if body.any_expr(|it| takes_from_end(name, it, (function, &known))) {
            return self.two_ended(name, through, site).map(Value::Closure);
        }
        self.counted(name, through, site).map(Value::Closure)
    }

    /// Returns the counted iterator that `through` is or shares its items with.
    fn counted_already(&self, through: usize) -> Option<usize> {
        let mut all = self.hands.iter();
        all.find(|(counted, hand)| **counted == through || hand.again == through).map(|it| *it.0)
    }

    /// Returns the iterator as a counted one, whose taken items a local counts.
    pub(super) fn counted(&mut self, name: &str, through: usize, site: Site) -> Result<usize> {
        if let Some(counted) = self.counted_already(through) {
            return Ok(counted);
        }
        let taken = format!("taken%{through}");
        let through = (*self.closures[through]).clone();
        // One that gives the items of another unchanged is that other.
        if let Some(of) = all_of(&through.text.body)
            && let Some(named) =
                self.in_scope_of(&through, None, site, |inner| Ok(inner.iterator_named(of)))?
        {
            return self.counted(name, named, site);
        }
        let (through, mut kept) = match started(self, &through, site)? {
            Some((own, kept)) => (own, kept),
            None => (through, Vec::new()),
        };
        let mut both = [through.clone(), through.clone()];
        let [counted, again] = both.each_mut().map(|it| &mut *it.text.body);
        // Where it was written, its calls have their numbers.
        let (counts, own) = self.in_scope_of(&through, None, site, |inner| {
            let counts = inner.count(counted, &taken, Change::Count)
                && inner.count(again, &taken, Change::Begin);
            Ok((counts, own_below(inner, again)))
        })?;
        if !counts {
            let counted = match self.counted_within(name, &through, site)? {
                None => self.pulled(name, &through, site)?,
                within => within,
            };
            return counted.or_refused(site, refusals::BY_HAND);
        }
        kept.extend(own.iter().map(|(name, _)| name.clone()));
        // A loop through a copy of the iterator must not change the iterator's state, so it works on copies of the locals.
        if !kept.is_empty() {
            *again = again.clone().with_copies(&kept);
        }
        if let Some((_, own)) = own {
            return Ok(self.hand(both, None, own, kept).0);
        }
        let none = Expr::usize(0, self.span(site));
        let local = self.let_local(format!("{name}_taken"), none).root;
        Ok(self.hand(both, Some(taken), local, kept).0)
    }

    /// Counts the iterator below an adapter, `values.iter().map(f)`, where the adapter itself cannot be counted.
    fn counted_within(
        &mut self,
        name: &str,
        through: &Closure<'a>,
        site: Site,
    ) -> Result<Option<usize>> {
        let Some(of) = all_of(&through.text.body) else { return Ok(None) };
        let within = self.in_scope_of(through, None, site, |inner| {
            let Some((function, arguments)) = inner.expansion(of) else { return Ok(None) };
            let mut params = function.tree.params.iter();
            let at = params.position(|it| it.items).filter(|_| inner.is_for_each(function));
            let Some(at) = at else { return Ok(None) };
            match inner.gone_through(&arguments[at])? {
                Value::Closure(of) => Ok(Some((at, inner.counted(name, of, site)?))),
                _ => Ok(None),
            }
        })?;
        let Some((at, within)) = within else { return Ok(None) };
        let hand = self.hands[&within].clone();
        let mut closure = through.clone();
        if let Tree::Each { source, .. } = &mut closure.text.body.kind
            && let Source::Elements(tree::Expr { kind: Tree::Call(_, arguments), .. }, _) =
                &mut **source
        {
            arguments[at] = tree::Expr::local(WITHIN, site);
        }
        let below = vec![(WITHIN.to_owned(), within)];
        if hand.stateful {
            closure.way = Way::Forward;
            let both = [closure.clone(), closure];
            return Ok(Some(self.over_state(both, hand.local, below)));
        }
        let counted = self.closures.len();
        for of in [within, hand.again] {
            let mut closure = closure.clone();
            closure.scope.names.push(vec![(WITHIN.to_owned(), Value::Closure(of))]);
            self.closure(closure);
        }
        self.hands.insert(counted, Hand { again: counted + 1, within: below, ..hand });
        Ok(Some(counted))
    }

    /// Registers a counted iterator and its non-consuming twin, which reads the remaining items without counting
    /// them.
    pub(super) fn hand(
        &mut self,
        both: [Closure<'a>; 2],
        taken: Option<String>,
        local: LocalId,
        kept: Vec<String>,
    ) -> (usize, usize) {
        let counted = self.closures.len();
        for mut closure in both {
            let name = taken.iter().map(|name| (name.clone(), Value::Local(local)));
            closure.scope.names.push(name.collect());
            self.closure(closure);
        }
        let again = counted + 1;
        let (within, stateful, last, nested) = (Vec::new(), false, None, None);
        let hand = Hand { again, taken, local, kept, within, stateful, last, nested };
        self.hands.insert(counted, hand);
        (counted, again)
    }

    /// Refuses a consumer whose number of taken items depends on std's specialisations, if the iterator is used
    /// afterwards. `handed` is false if an author's `for` loop consumes the items.
    pub(super) fn check_settled(
        &self,
        (function, handed): (&tree::Function, bool),
        argument: &tree::Expr,
    ) -> Result<()> {
        let path = format!("{}::{}", function.module, function.tree.name);
        let open = COMPARED.contains(&&*path) || is_zip(function) && handed;
        match self.iterator_named(argument) {
            Some(named) if open && self.hands.contains_key(&named) => {
                refused(argument.site, refusals::TAKEN_BY_LENGTH)
            }
            _ => Ok(()),
        }
    }

    /// Returns true if an expression reads the count of a counted iterator.
    pub(super) fn is_taken(&self, value: &Expr) -> bool {
        let is_counted = |hand: &&Hand| hand.taken.is_some() || hand.nested.is_some();
        let mut counts = self.hands.values().filter(is_counted);
        let is_count = |hand: &Hand, local| {
            hand.local == local
                || hand.last.is_some_and(|(end, _)| end == local)
                || hand.nested.as_ref().is_some_and(|it| it.counts.contains(&local))
        };
        matches!(&value.kind, ExprKind::Load(place) if counts.any(|it| is_count(it, place.root)))
    }

    /// Returns the statements of a loop that takes only the next item of an iterator, without the loop: it has one
    /// pass, or none.
    pub(super) fn at_most_once(&self, kind: &StmtKind, span: Span) -> Option<Block> {
        let StmtKind::For { variable, from, to, inclusive, reversed, ended, body, .. } = kind
        else {
            return None;
        };
        if *ended && *inclusive && from.is_literal() && from == to {
            return single_pass(&body.0);
        }
        // It has a first pass, and needs no number of it.
        if let (Some(0), Some(1..)) = (number(from), number(to))
            && from.ty == Type::Scalar(Scalar::Int(Int::U64))
            && !effects::mentions(body, *variable)
        {
            return single_pass(&body.0);
        }
        if *inclusive || !self.is_taken(from) || *reversed && !self.is_taken(to) {
            return None;
        }
        let first = match reversed {
            true => minus(to.clone(), Expr::literal_like(1, to)),
            false => from.clone(),
        };
        let mut then = Block::of(StmtKind::Let { local: *variable, value: Some(first) }, span);
        then.0.extend(single_pass(&body.0)?.0);
        let condition = Expr::compare(CompareOp::Lt, from.clone(), to.clone());
        Some(Block::of(StmtKind::If { condition, then, otherwise: Block::default() }, span))
    }

    /// Changes the innermost loop of an iterator, whose adapters yield one item for each of its items. Returns false for
    /// a loop that cannot be changed.
    pub(super) fn count(&mut self, through: &mut tree::Expr, taken: &str, change: Change) -> bool {
        let site = through.site;
        let Tree::Each { pattern, source, body, .. } = &mut through.kind else { return false };
        if let Source::Elements(of, _) = &mut **source
            && let Some((function, _)) = self.expansion(of).filter(|(it, _)| generates(it))
        {
            let mut params = function.tree.params.iter();
            let ends = is_zip(function) || is_enumerate(function);
            let each = self.is_for_each(function) || change == Change::End && ends;
            let Some(at) = params.position(|it| it.items && each) else { return false };
            let Tree::Call(_, arguments) = &mut of.kind else { return false };
            let mut inner = handing(&arguments[at]);
            let counted = self.count(&mut inner.body, taken, change);
            arguments[at].become_closure(inner);
            return counted;
        }
        // An own iterator goes on by itself.
        if let Source::Elements(of, _) = &**source
            && self.own_next(of).is_some()
        {
            return !matches!(change, Change::End | Change::Enter);
        }
        if let Source::Elements(of, _) = &mut **source
            && change == Change::End
            && let Some(named) = self.iterator_named(of)
        {
            let Ok(most) = self.lookup(taken, site) else { return false };
            let Ok(limited) = limited(self, named, most, site) else { return false };
            self.stand_in(of, "limited%", Value::Closure(limited));
            return true;
        }
        let is_made = |leaf: &&Source| match leaf {
            Source::Elements(of, _) => {
                change != Change::Parts && matches!(of.kind, Tree::Call(..) | Tree::Apply(..))
                    || self.iterator_named(of).is_some()
            }
            _ => false,
        };
        if source.leaves().iter().any(is_made) {
            return false;
        }
        let local = |name: &str| tree::Expr::local(name, site);
        let wrapped = |source: &mut Box<Source>, wrap: &dyn Fn(Box<Source>) -> Source| {
            **source = wrap(source.clone());
        };
        if !matches!(change, Change::Begin | Change::End) {
            wrapped(source, &Source::Enumerate);
            let inner = std::mem::replace(&mut **pattern, Pattern::Any);
            **pattern = Pattern::Tuple(vec![Pattern::name(TAKEN), inner]);
            let next = match change {
                Change::Back => local(TAKEN),
                _ => tree::Expr::successor(TAKEN, site),
            };
            let counts = match change {
                Change::Back => last_of(taken),
                Change::Enter => begun_of(taken),
                _ => taken.to_owned(),
            };
            body.stmts.insert(0, Stmt::assigned(&counts, next, site));
        }
        wrapped(source, &|inner| match change {
            Change::End => Source::Take(inner, local(taken)),
            _ => Source::Skip(inner, local(taken)),
        });
        if change == Change::Back {
            wrapped(source, &Source::Rev);
        }
        true
    }

    /// Returns true for an adapter like `map`: a generator function with one loop over all items and no state.
    pub(super) fn is_for_each(&self, function: &tree::Function) -> bool {
        let [Stmt::Expr(through)] = function.tree.body.stmts.as_slice() else { return false };
        function.tree.body.tail.is_none() && self.goes_through_all(function, through)
    }

    /// Returns true if `through` is such a loop, without `break` or an inner loop.
    fn goes_through_all(&self, function: &tree::Function, through: &tree::Expr) -> bool {
        let Tree::Each { source, body: pass, .. } = &through.kind else { return false };
        use Tree::{Break, Each, While};
        let loops = |it: &tree::Expr| matches!(it.kind, Break(..) | Each { .. } | While { .. });
        let Source::Elements(of, _) = &**source else { return false };
        !pass.any_expr(loops) && self.are_all(function, of)
    }

    /// Returns true for the adapter's iterator parameter, and for a chain above it that consists of such adapters.
    fn are_all(&self, function: &tree::Function, of: &tree::Expr) -> bool {
        match &of.kind {
            Tree::Local(name) => function.tree.params.iter().any(|it| it.items && it.name == *name),
            Tree::Closure(closure) => self.goes_through_all(function, &closure.body),
            Tree::Call(callee, arguments) => {
                let Some(tree::Callee::Function(path)) = function.callees.get(*callee as usize)
                else {
                    return false;
                };
                let Some(link) = self.cx.calls.all.get(path.as_str()) else { return false };
                let at = link.tree.params.iter().position(|it| it.items);
                let taken = at.and_then(|at| arguments.get(at));
                generates(link)
                    && self.is_for_each(link)
                    && taken.is_some_and(|taken| self.are_all(function, taken))
            }
            _ => false,
        }
    }

    /// Returns the pattern and the source of `while let Some(x) = bytes.next()`, as a loop over the remaining items.
    /// The body must not use the iterator.
    pub(super) fn rest_of<'e>(
        &self,
        condition: &'e tree::Expr,
        body: &tree::Block,
    ) -> Option<(&'e Pattern, Source)> {
        let ([pattern], value) = some_of(condition)? else { return None };
        let (function, [array]) = self.called(value)? else { return None };
        let Tree::Local(name) = &array.kind else { return None };
        let is_iterator = self.iterator_named(array).is_some();
        if !is_next(function) || !is_iterator || !takes_all(pattern) || mentions(name, body) > 0 {
            return None;
        }
        Some((pattern, Source::Elements(array.clone(), false)))
    }

    /// Lowers `while let Some(x) = bytes.next()` with a body that takes more items of `bytes`. The loop has as many
    /// passes as items are left, since each pass takes at least one.
    pub(super) fn as_many_as_left(
        &mut self,
        condition: &tree::Expr,
        body: &tree::Block,
    ) -> Option<(Source, tree::Block)> {
        let ([item], value) = some_of(condition)? else { return None };
        let (function, [iterator]) = self.called(value)? else { return None };
        let takes = is_next(function) || is_next_back(function);
        let through = self.iterator_named(iterator).filter(|_| takes)?;
        let mut hand = self.hands.get(&through)?;
        // A loop in a loop may have more passes than items.
        while hand.nested.is_none() && (hand.taken.is_none() || !hand.stateful) {
            match &hand.within[..] {
                [] => break,
                [(_, within)] => hand = self.hands.get(within)?,
                // Two of them may have more passes than one.
                _ => return None,
            }
        }
        let body = taking_next(item, value.clone(), body, condition.site);
        let over = Source::Elements(tree::Expr::local(PASSES, condition.site), false);
        if let Some(nested) = &hand.nested {
            let passes = Value::Closure(nested.passes?);
            self.bind(PASSES, passes);
            return Some((over, body));
        }
        let (again, site) = (Rc::clone(&self.closures[hand.again]), condition.site);
        let own = |inner: &mut Self| Ok(own_below(inner, &again.text.body).is_some());
        if self.in_scope_of(&again, None, site, own).ok()? {
            return None;
        }
        let (source, hand_on) = (items_of(&again.text.body)?, Tree::Apply(EACH.into(), Vec::new()));
        let each = Tree::each(Pattern::Any, source, tree::Expr::plain(hand_on, site));
        let mut passes = (*again).clone();
        *passes.text.body = tree::Expr::plain(each, site);
        let passes = Value::Closure(self.closure(passes));
        self.bind(PASSES, passes);
        Some((over, body))
    }
}

/// Returns the body of a loop that takes its item by a call: it begins with `let Some(item) = next else { break };`.
pub(super) fn taking_next(
    item: &Pattern,
    next: tree::Expr,
    body: &tree::Block,
    site: Site,
) -> tree::Block {
    let leave = Stmt::Expr(tree::Expr::plain(Tree::Break(None, None), site));
    let otherwise = Some(tree::Block { stmts: vec![leave], tail: None });
    let pattern = Box::new(Pattern::Constructor("Some".into(), vec![item.clone()]));
    let mut body = body.clone();
    body.stmts.insert(0, Stmt::Apart { pattern, value: next, otherwise, site });
    body
}

/// Refuses `next_back` of a counted iterator whose end no local has.
pub(super) fn check_end(
    lowering: &Lowering,
    function: &tree::Function,
    argument: &tree::Expr,
) -> Result<()> {
    let named = lowering.iterator_named(argument).and_then(|it| lowering.hands.get(&it));
    match is_next_back(function) {
        true if named.is_some_and(|hand| hand.last.is_none()) => {
            refused(argument.site, refusals::BOTH_ENDS)
        }
        _ => Ok(()),
    }
}

/// Returns the name of the end of an iterator whose taken items this name counts.
pub(super) fn last_of(taken: &str) -> String {
    let number = taken.rsplit('%').next().unwrap_or_default();
    format!("end%{number}")
}

/// Returns the name of the count of begun items, beside this count of finished ones.
pub(super) fn begun_of(finished: &str) -> String {
    let number = finished.rsplit('%').next().unwrap_or_default();
    format!("begun%{number}")
}

/// Returns the author's own iterator that is the source of an iterator: its name and its local.
fn own_below(lowering: &mut Lowering, through: &tree::Expr) -> Option<(String, LocalId)> {
    let Source::Elements(of, _) = items_of(through)? else { return None };
    let Tree::Local(name) = &of.kind else { return None };
    lowering.own_next(&of)?;
    let (meaning, span) = (lowering.meaning(&of)?, lowering.span(of.site));
    Some((name.clone(), lowering.place_of(&meaning, span)?.root))
}

/// Returns an iterator that a function takes by `&mut`: the same one.
pub(super) fn borrowed(lowering: &mut Lowering, through: usize) -> usize {
    let borrowed = Closure { borrowed: true, ..(*lowering.closures[through]).clone() };
    let borrowed = lowering.closure(borrowed);
    if let Some(counted) = lowering.hands.get(&through).cloned() {
        lowering.hands.insert(borrowed, counted);
    }
    borrowed
}

/// Returns an iterator that ends after `most` items, before any closure of it is called for another.
pub(super) fn limited(
    lowering: &mut Lowering,
    through: usize,
    most: Value,
    site: Site,
) -> Result<usize> {
    let mut limited = (*lowering.closures[through]).clone();
    let mut text = limited.text.body.clone();
    let name = format!("limit%{through}");
    let names = lowering.in_scope_of(&limited, None, site, |inner| {
        inner.bind(&name, most);
        let done = inner.count(&mut text, &name, Change::End);
        Ok(done.then(|| inner.scopes.clone()))
    })?;
    limited.scope.names = names.or_refused(site, refusals::ZIPPED_BY_ACCESS)?;
    limited.text.body = text;
    Ok(lowering.closure(limited))
}

/// Returns true for `bessemer::iterate::next`, the DSL's `Iterator::next`.
pub(super) fn is_next(function: &tree::Function) -> bool {
    format!("{}::{}", function.module, function.tree.name) == NEXT
}

/// Returns the expression whose items an iterator yields unchanged; none for another iterator.
pub(super) fn all_of(through: &tree::Expr) -> Option<&tree::Expr> {
    let Tree::Each { pattern, source, body, .. } = &through.kind else { return None };
    let Source::Elements(of, _) = &**source else { return None };
    let ([Stmt::Expr(last)], None) = (&body.stmts[..], &body.tail) else { return None };
    let handed = matches!(&last.kind, Tree::Apply(name, items)
        if name == EACH && matches!((&**pattern, &items[..]), (Pattern::Name { name, .. }, [item])
            if matches!(&item.kind, Tree::Local(it) if it == name)));
    handed.then_some(of)
}

/// Returns true for a generator function without an iterator parameter whose body is `let`s and one loop without
/// `break`.
fn counts_on(function: &tree::Function) -> bool {
    let Some((Stmt::Expr(each), before)) = function.tree.body.stmts.split_last() else {
        return false;
    };
    let Tree::Each { body: pass, .. } = &each.kind else { return false };
    use Tree::{Break, Each, While};
    let loops = |it: &tree::Expr| matches!(it.kind, Break(..) | Each { .. } | While { .. });
    let named = |it: &Stmt| matches!(it, Stmt::Let { value: Some(_), .. });
    generates(function)
        && function.tree.body.tail.is_none()
        && !function.tree.params.iter().any(|it| it.items)
        && before.iter().all(named)
        && !pass.any_expr(loops)
}

/// Returns the innermost source of a counted iterator. It has at least one item for each item of the iterator.
pub(super) fn items_of(through: &tree::Expr) -> Option<Source> {
    let source = match &through.kind {
        Tree::Block(block) => match block.stmts.last()? {
            Stmt::Expr(through) => return items_of(through),
            _ => return None,
        },
        Tree::Each { source, .. } => source,
        _ => return None,
    };
    match &**source {
        Source::Elements(tree::Expr { kind: Tree::Call(_, arguments), .. }, _) => {
            arguments.iter().find_map(|it| match &it.kind {
                Tree::Closure(inner) => items_of(&inner.body),
                _ => None,
            })
        }
        source => Some(source.clone()),
    }
}

/// Starts the generator function that an iterator calls. Returns its loop and the names of the locals that
/// persist between items.
fn started<'a>(
    lowering: &mut Lowering<'a, '_>,
    through: &Closure<'a>,
    site: Site,
) -> Result<Option<(Closure<'a>, Vec<String>)>> {
    let Some(of) = all_of(&through.text.body) else { return Ok(None) };
    lowering.in_scope_of(through, None, site, |inner| {
        let Some((function, arguments)) = inner.expansion(of).filter(|it| counts_on(it.0)) else {
            return Ok(None);
        };
        let Some(own) = inner.start(function, arguments, site)? else { return Ok(None) };
        let kept = function.tree.body.stmts.iter().filter_map(|stmt| match stmt {
            Stmt::Let { name, .. } => Some(name.clone()),
            _ => None,
        });
        Ok(Some((own, kept.collect())))
    })
}
