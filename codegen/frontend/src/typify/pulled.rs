//! Adapters with state whose items are taken by explicit `next` calls: `let mut sums = values.iter().scan(0, …);`.
//!
//! The function of such an adapter declares its state before its loop. The state is in locals, beside the counts of the
//! iterators below, so each loop continues where the last one was left.
//!
//! Invariants: such a loop is never reversed or limited. A copy of the iterator has copies of its state and of each counted
//! iterator below.
//!
//! Must not know: which methods consume an iterator.

use bessemer_ir::tree::visit::{VisitMut, Walk, walk_expr_mut};
use bessemer_ir::tree::{self, ExprKind as Tree, Site, Source, Stmt};
use bessemer_ir::{Expr, Local, LocalId, Type};

use super::by_hand::{Change, all_of, items_of, last_of};
use super::generator::{NUMBER, going};
use super::items::{copied, handing};
use super::lowering::{Closure, Hand, Lowering, Way};
use super::nested::{nested, with_copies};
use super::scopes::Scopes;
use super::seq::pair;
use super::syntax::{generates, is_of_library};
use super::value::Value;
use super::{Needed, Result, refusals};
use crate::standard::{self, Interrupted};

/// Name of the flag that an adapter has yielded its last item.
const ENDED: &str = "ended%";

/// Returns the iterator as a counted one if an adapter with state yields its items; none for any other iterator.
fn pulled<'a>(
    lowering: &mut Lowering<'a, '_>,
    name: &str,
    through: &Closure<'a>,
    site: Site,
) -> Result<Option<usize>> {
    let Some(of) = all_of(&through.text.body) else { return Ok(None) };
    let started = lowering.in_scope_of(through, None, site, |inner| {
        let called = inner.expansion(of).filter(|it| resumes(it.0) || standard::is_nested(it.0));
        let Some((function, arguments)) = called else { return Ok(None) };
        Ok(inner.start(function, arguments, site)?.map(|own| (function, own)))
    })?;
    let Some((function, mut own)) = started else { return Ok(None) };
    if standard::is_nested(function) {
        return nested(lowering, name, function, own, site);
    }
    if standard::is_rev(function) {
        if let Some(known) = from_the_end(lowering, &own)? {
            return Ok(Some(known));
        }
        let Some(reversed) = reversed(lowering, &own)? else { return Ok(None) };
        let reversed = lowering.closure(reversed);
        return lowering.counted(name, reversed, site).map(Some);
    }
    let declared = function.tree.body.stmts.iter().filter_map(|stmt| match stmt {
        Stmt::Let { name, .. } => Some(name.clone()),
        _ => None,
    });
    let (mut kept, mut within): (Vec<_>, Vec<_>) = (declared.collect(), Vec::new());
    let mut interrupted = None;
    for (at, param) in function.tree.params.iter().filter(|it| it.items).enumerate() {
        let may_go_on = match own.scope.names.meaning(&param.name) {
            Some(&Value::Closure(of)) => {
                let may_go_on = !stays_ended(lowering, of);
                within.push((param.name.clone(), lowering.counted(name, of, site)?));
                may_go_on
            }
            // An author's own iterator, which has its state itself.
            _ => {
                kept.push(param.name.clone());
                true
            }
        };
        if at == 0 && may_go_on {
            interrupted = standard::interrupted(function);
        }
    }
    own.way = Way::Forward;
    let mut texts = [own.text.body.clone(), own.text.body.clone()];
    let taken = format!("taken%{}", lowering.closures.len());
    // One without items has its whole state itself.
    let takes = function.tree.params.iter().any(|it| it.items);
    let is_range = matches!(&own.text.body.kind,
        Tree::Each { source, .. } if takes && matches!(**source, Source::Numbers(_)));
    let is_counted = lowering.in_scope_of(&own.clone(), None, site, |inner| {
        let is_counted = is_range
            && inner.count(&mut texts[0], &taken, Change::Count)
            && inner.count(&mut texts[1], &taken, Change::Begin);
        if numbered(inner, &mut texts[0])? {
            kept.push(NUMBER.to_owned());
            texts[1] = texts[0].clone();
        }
        let flagged = match interrupted {
            Some(Interrupted::Behind) => Some(behind_first as fn(&mut tree::Expr)),
            _ => standard::ends_for_good(function).then_some(until_ended as fn(&mut tree::Expr)),
        };
        if let Some(change) = flagged {
            let not_yet = Expr::bool(false, inner.span(site));
            let ended = inner.let_local(format!("{name}_ended"), not_yet).root;
            inner.bind(ENDED, Value::Local(ended));
            kept.push(ENDED.to_owned());
            texts.iter_mut().for_each(|text| change(text));
        }
        texts.iter_mut().for_each(|text| with_count_behind(text, interrupted));
        own.scope.names.clone_from(&inner.scopes);
        Ok(is_counted)
    })?;
    let both = texts.map(|body| {
        let mut closure = own.clone();
        closure.text.body = body;
        closure
    });
    let local = match is_counted {
        true => {
            let none = Expr::usize(0, lowering.span(site));
            lowering.let_local(format!("{name}_taken"), none).root
        }
        false => some_local(lowering, &own.scope.names, &kept, &within),
    };
    Ok(Some(stateful(lowering, both, (is_counted.then_some(taken), local), kept, within).0))
}

/// Registers a counted iterator with state.
fn stateful<'a>(
    lowering: &mut Lowering<'a, '_>,
    mut both: [Closure<'a>; 2],
    (taken, local): (Option<String>, LocalId),
    kept: Vec<String>,
    within: Vec<(String, usize)>,
) -> (usize, usize) {
    let below: Vec<_> =
        within.iter().map(|(name, of)| (name.clone(), Value::Closure(*of))).collect();
    both.iter_mut().for_each(|closure| closure.scope.names.push(below.clone()));
    let (counted, again) = lowering.hand(both, taken, local, kept);
    if let Some(hand) = lowering.hands.get_mut(&counted) {
        (hand.within, hand.stateful) = (within, true);
    }
    (counted, again)
}

/// Returns an iterator whose items are taken from both ends as a counted one: a local has its end, and a second loop is
/// reversed.
fn two_ended(lowering: &mut Lowering, name: &str, known: usize, site: Site) -> Result<usize> {
    let mut through = (*lowering.closures[known]).clone();
    let (taken, body) = (format!("taken%{known}"), through.text.body.clone());
    let end = last_of(&taken);
    let texts = [body.clone(), body.clone(), body.clone()];
    let counted = lowering.in_scope_of(&through, None, site, |inner| {
        let [mut counted, mut again, mut back] = texts;
        let changes =
            [(&mut counted, Change::Count), (&mut again, Change::Begin), (&mut back, Change::Back)];
        for (text, change) in changes {
            if !inner.count(text, &end, Change::End) || !inner.count(text, &taken, change) {
                return Ok(None);
            }
        }
        let source = items_of(&body).or_refused(site, refusals::BOTH_ENDS)?;
        let length = inner.seq(&source, site)?.ended(site)?;
        let local = inner.let_local(format!("{name}_end"), length).root;
        Ok(Some(([counted, again, back], local)))
    })?;
    let (texts, local) = counted.or_refused(site, refusals::BOTH_ENDS)?;
    through.scope.names.push(vec![(end.clone(), Value::Local(local))]);
    let closures = texts.map(|body| {
        let mut closure = through.clone();
        closure.text.body = body;
        closure
    });
    let none = Expr::usize(0, lowering.span(site));
    let start = lowering.let_local(format!("{name}_taken"), none).root;
    Ok(from_both_ends(lowering, closures, (taken, start), (local, vec![end])).0)
}

/// Registers a counted iterator with a reversed loop, `back`.
fn from_both_ends<'a>(
    lowering: &mut Lowering<'a, '_>,
    [counted, again, mut back]: [Closure<'a>; 3],
    (taken, start): (String, LocalId),
    (end, kept): (LocalId, Vec<String>),
) -> (usize, usize) {
    back.way = Way::Back;
    back.scope.names.push(vec![(taken.clone(), Value::Local(start))]);
    let back = lowering.closure(back);
    let (counted, again) = lowering.hand([counted, again], Some(taken), start, kept);
    if let Some(hand) = lowering.hands.get_mut(&counted) {
        hand.last = Some((end, back));
    }
    (counted, again)
}

impl<'a> Lowering<'a, '_> {
    /// Returns the iterator as a counted one if an adapter with state yields its items; none for any other iterator.
    pub(super) fn pulled(
        &mut self,
        name: &str,
        through: &Closure<'a>,
        site: Site,
    ) -> Result<Option<usize>> {
        pulled(self, name, through, site)
    }

    /// Returns an iterator whose items are taken from both ends as a counted one.
    pub(super) fn two_ended(&mut self, name: &str, known: usize, site: Site) -> Result<usize> {
        two_ended(self, name, known, site)
    }

    /// Registers an adapter over a counted iterator with state.
    pub(super) fn over_state(
        &mut self,
        both: [Closure<'a>; 2],
        local: LocalId,
        below: Vec<(String, usize)>,
    ) -> usize {
        stateful(self, both, (None, local), Vec::new(), below).0
    }

    /// Returns a copy of a counted iterator. The copy continues at the present count, and the two then advance
    /// separately.
    pub(super) fn copy_of_hand(&mut self, known: usize) -> usize {
        let Some((counted, hand)) = self.hands.iter().find(|(_, hand)| hand.again == known) else {
            return known;
        };
        let (counted, hand) = (*counted, hand.clone());
        let ids = [Some(counted), Some(known), hand.last.map(|(_, back)| back)];
        let mut all: Vec<_> =
            ids.into_iter().flatten().map(|it| (*self.closures[it]).clone()).collect();
        if let ([(name, within)], false) = (&hand.within[..], hand.stateful) {
            return copy_within(self, all, (name, *within));
        }
        let (taken, mut local, kept) = (hand.taken, hand.local, hand.kept);
        let (mut end, mut copies) = (None, Vec::new());
        for name in &kept {
            let copy = match all[0].scope.names.meaning(name) {
                Some(&Value::Local(of)) => {
                    let Local { name: own, ty, span, .. } = self.locals[of.index()].clone();
                    let copy = self.let_local(own, Expr::local(of, &ty, span)).root;
                    end = hand.last.filter(|(end, _)| *end == of).map(|_| copy).or(end);
                    Value::Local(copy)
                }
                Some(Value::Place(own)) => {
                    let copy = copied(self, &own.clone());
                    local = if taken.is_some() { local } else { copy.root };
                    Value::Place(copy)
                }
                _ => continue,
            };
            copies.push((name.clone(), copy));
        }
        all.iter_mut().for_each(|closure| closure.scope.names.push(copies.clone()));
        let nested = hand.nested.and_then(|it| with_copies(self, &mut all, &it, &copies));
        if taken.is_some() {
            let Local { name, span, .. } = self.locals[local.index()].clone();
            local = self.let_local(name, Expr::local(local, &Type::USIZE, span)).root;
        }
        let mut all = all.into_iter();
        let (Some(counted), Some(again)) = (all.next(), all.next()) else { return known };
        if let (Some(back), Some(end), Some(taken)) = (all.next(), end, &taken) {
            let all = [counted, again, back];
            return from_both_ends(self, all, (taken.clone(), local), (end, kept)).1;
        }
        if hand.stateful {
            let below = hand.within.into_iter();
            let within = below.map(|(name, of)| (name, copy_counted(self, of))).collect();
            let (counted, _) = stateful(self, [counted, again], (taken, local), kept, within);
            if let Some(hand) = self.hands.get_mut(&counted) {
                hand.nested = nested;
            }
            return counted;
        }
        self.hand([counted, again], taken, local, kept).1
    }
}

/// Copies an adapted iterator by copying the counted iterator below its adapter.
fn copy_within<'a>(
    lowering: &mut Lowering<'a, '_>,
    mut both: Vec<Closure<'a>>,
    (name, within): (&str, usize),
) -> usize {
    let within = copy_counted(lowering, within);
    let Some(hand) = lowering.hands.get(&within).cloned() else { return within };
    let counted = lowering.closures.len();
    for (closure, of) in both.iter_mut().zip([within, hand.again]) {
        closure.scope.names.push(vec![(name.to_owned(), Value::Closure(of))]);
        lowering.closure(closure.clone());
    }
    let within = vec![(name.to_owned(), within)];
    lowering.hands.insert(counted, Hand { again: counted + 1, within, ..hand });
    counted + 1
}

/// Copies a counted iterator, and returns the copy as a counted one.
fn copy_counted(lowering: &mut Lowering, counted: usize) -> usize {
    let Some(again) = lowering.hands.get(&counted).map(|hand| hand.again) else { return counted };
    let copy = lowering.copy_of_hand(again);
    let mut all = lowering.hands.iter();
    all.find(|(_, hand)| hand.again == copy).map_or(copy, |(counted, _)| *counted)
}

/// Returns true for a function of the DSL that adapts iterators by one loop, or by one loop after another.
fn resumes(function: &tree::Function) -> bool {
    let is_loop = |it: &tree::Expr| matches!(it.kind, Tree::Each { .. } | Tree::While { .. });
    let is_flat = |it: &Stmt| match it {
        Stmt::Expr(tree::Expr { kind: Tree::Each { body, .. }, .. }) => !body.any_expr(is_loop),
        _ => false,
    };
    let Some((Stmt::Expr(last), before)) = function.tree.body.stmts.split_last() else {
        return false;
    };
    is_of_library(function)
        && generates(function)
        && before.iter().all(|it| matches!(it, Stmt::Let { .. } | Stmt::Expr(_)))
        && match &last.kind {
            Tree::Each { body, .. } => !body.any_expr(is_loop),
            Tree::Labelled(_, parts) => parts.tail.is_none() && parts.stmts.iter().all(is_flat),
            _ => false,
        }
}

/// Replaces the numbers of `enumerate` by a count that is kept. Returns false for another loop.
fn numbered(lowering: &mut Lowering, text: &mut tree::Expr) -> Result<bool> {
    let site = text.site;
    let Tree::Each { pattern, source, body, .. } = &mut text.kind else { return Ok(false) };
    let Source::Enumerate(of) = &**source else { return Ok(false) };
    let of = of.clone();
    let [number, item] = pair(pattern, site)?.map(Clone::clone);
    lowering.count_items(&number, body, site)?;
    (**pattern, *source) = (item, of);
    Ok(true)
}

/// Lets the loop of an adapter set a flag at its `break`, and run only while the flag is not set.
fn until_ended(text: &mut tree::Expr) {
    struct Ends;
    impl VisitMut for Ends {
        fn expr(&mut self, expr: &mut tree::Expr) {
            walk_expr_mut(self, expr);
            if let Tree::Break(None, None) = &expr.kind {
                *expr = expr.clone().after_flag(ENDED);
            }
        }
    }
    Ends.expr(text);
    *text = text.clone().without_flag(ENDED);
}

/// Lets the first loop of an adapter set a flag at its end, and run only while the flag is not set.
fn behind_first(text: &mut tree::Expr) {
    let Tree::Labelled(_, parts) = &mut text.kind else { return };
    if let Some(Stmt::Expr(first)) = parts.stmts.first_mut() {
        *first = first.clone().once(ENDED);
    }
}

/// Adds the assignment of a count to the end of an adapter's loop. A loop that is left after an item has this value already.
fn with_count_behind(text: &mut tree::Expr, interrupted: Option<Interrupted>) {
    let (count, other) = match interrupted {
        Some(Interrupted::Zero(count)) => (count, None),
        Some(Interrupted::Anew(count, other)) => (count, Some(other)),
        Some(Interrupted::Behind) | None => return,
    };
    *text = text.clone().with_count_behind(count, other);
}

/// Returns a local of an iterator's state.
fn some_local(
    lowering: &Lowering,
    names: &Scopes,
    kept: &[String],
    within: &[(String, usize)],
) -> LocalId {
    let own = kept.iter().find_map(|name| match names.meaning(name) {
        Some(Value::Local(local)) => Some(*local),
        Some(Value::Place(place)) => Some(place.root),
        _ => None,
    });
    let below = || within.iter().find_map(|(_, of)| lowering.hands.get(of)).map(|it| it.local);
    own.or_else(below).unwrap_or(LocalId(0))
}

/// Returns the argument of the adapter `rev` as a counted iterator that takes items from the end. None if the argument is no
/// borrowed iterator with a local that has its end.
fn from_the_end<'a>(
    lowering: &mut Lowering<'a, '_>,
    through: &Closure<'a>,
) -> Result<Option<usize>> {
    let Tree::Each { source: rev, .. } = &through.text.body.kind else { return Ok(None) };
    let (Source::Rev(of), site) = (&**rev, through.text.body.site) else { return Ok(None) };
    let Source::Elements(of, _) = &**of else { return Ok(None) };
    let named = lowering.in_scope_of(through, None, site, |inner| Ok(inner.iterator_named(of)))?;
    let Some(hand) = named.and_then(|of| lowering.hands.get(&of)).cloned() else { return Ok(None) };
    let Some((_, back)) = hand.last else { return Ok(None) };
    let [back, again] = [back, hand.again].map(|of| (*lowering.closures[of]).clone());
    let (counted, again) = (lowering.closure(back), lowering.closure(again));
    lowering.hands.insert(counted, Hand { again, last: None, ..hand });
    Ok(Some(counted))
}

/// Returns the argument of the adapter `rev` with its items in reverse, by a reversed loop over the innermost source. None
/// if an adapter between has state.
fn reversed<'a>(
    lowering: &mut Lowering<'a, '_>,
    through: &Closure<'a>,
) -> Result<Option<Closure<'a>>> {
    let Tree::Each { source: rev, .. } = &through.text.body.kind else { return Ok(None) };
    let (Source::Rev(of), site) = (&**rev, through.text.body.site) else { return Ok(None) };
    let Source::Elements(of, _) = &**of else { return Ok(None) };
    let named = lowering.in_scope_of(through, None, site, |inner| Ok(inner.iterator_named(of)))?;
    let Some(of) = named.map(|of| (of, (*lowering.closures[of]).clone())) else { return Ok(None) };
    let (of, mut through) = of;
    if through.way != Way::Any
        || lowering.hands.iter().any(|(it, hand)| *it == of || hand.again == of)
    {
        return Ok(None);
    }
    let text = through.text.body.clone();
    let turned = lowering.in_scope_of(&through, None, site, |inner| turned(inner, rev, &text))?;
    Ok(turned.map(|text| {
        *through.text.body = text;
        through
    }))
}

/// Returns a loop with its items in reverse.
fn turned(lowering: &mut Lowering, rev: &Source, text: &tree::Expr) -> Result<Option<tree::Expr>> {
    let Some(mut text) = going(rev, text) else { return Ok(None) };
    let Tree::Each { source, .. } = &mut text.kind else { return Ok(None) };
    let Source::Rev(of) = &mut **source else { return Ok(None) };
    let Source::Elements(array, _) = &mut **of else { return Ok(Some(text)) };
    if lowering.iterator_named(array).is_some() || lowering.own_next(array).is_some() {
        return Ok(None);
    }
    let Some((function, _)) = lowering.expansion(array).filter(|it| generates(it.0)) else {
        return Ok(Some(text));
    };
    let at = function.tree.params.iter().position(|it| it.items);
    let Some(at) = at.filter(|_| lowering.is_for_each(function)) else { return Ok(None) };
    let Tree::Call(_, arguments) = &mut array.kind else { return Ok(None) };
    let mut inner = handing(&arguments[at]);
    let Some(body) = turned(lowering, rev, &inner.body)? else { return Ok(None) };
    *inner.body = body;
    arguments[at].become_closure(inner);
    *source = of.clone();
    Ok(Some(text))
}

/// Returns true if an iterator yields no more items once it has yielded `None`.
fn stays_ended(lowering: &mut Lowering, known: usize) -> bool {
    let through = (*lowering.closures[known]).clone();
    if through.way == Way::Forward && !standard::stays_ended(through.source) {
        return false;
    }
    let text = through.text.body.clone();
    let ended =
        lowering.in_scope_of(&through, None, text.site, |inner| Ok(loop_stays_ended(inner, &text)));
    ended.unwrap_or(false)
}

fn loop_stays_ended(lowering: &mut Lowering, text: &tree::Expr) -> bool {
    let all = |lowering: &mut Lowering, block: &tree::Block| {
        block.stmts.iter().all(|it| match it {
            Stmt::Expr(part) => loop_stays_ended(lowering, part),
            _ => true,
        })
    };
    match &text.kind {
        // The flag of an adapter.
        Tree::If(..) => true,
        Tree::Block(block) | Tree::Labelled(_, block) => all(lowering, block),
        Tree::Each { source, .. } => source.leaves().into_iter().all(|leaf| match leaf {
            Source::Elements(of, _) => elements_stay_ended(lowering, of),
            _ => true,
        }),
        _ => false,
    }
}

fn elements_stay_ended(lowering: &mut Lowering, of: &tree::Expr) -> bool {
    if let Some(known) = lowering.iterator_named(of) {
        return stays_ended(lowering, known);
    }
    let Some((function, arguments)) = lowering.expansion(of).filter(|it| generates(it.0)) else {
        return !matches!(of.kind, Tree::Apply(..)) && lowering.own_next(of).is_none();
    };
    let items = function.tree.params.iter().zip(arguments).filter(|(param, _)| param.items);
    is_of_library(function)
        && standard::stays_ended(function)
        && items.into_iter().all(|(_, it)| loop_stays_ended(lowering, &handing(it).body))
}
