//! Chains of iterators that end in a value: `values.iter().map(|x| x * x).sum()`.
//!
//! In the tree a chain is the loop that it stands for, and what the loop gathers; in the witness copy it
//! stays a chain, and the closures look at what they are given.

use bessemer_ir::tree::{self, BinaryOp, ExprKind, Order, Start, UnaryOp};
use bessemer_ir::{Int, Scalar};

use super::call::companion_name;
use super::closure::{closure_of, closure_parameter, in_full};
use super::each::Way;
use super::flow::{Flow, Item, Over, Step, Takes};
use super::item::{ITEM, is_wild, look_on_the_way, simple};
use super::made::{UNIT, plain};
use super::names::{place, text};
use super::syntax::{is_ended, is_linked, is_made_of_plain};
use super::walk::Lowering;
use super::{each, refuse};

/// The ends of a chain, and how many arguments each takes.
const ENDS: [(&str, usize); 17] = [
    ("sum", 0),
    ("product", 0),
    ("count", 0),
    ("fold", 2),
    ("try_fold", 2),
    ("reduce", 1),
    ("for_each", 1),
    ("any", 1),
    ("all", 1),
    ("min", 0),
    ("max", 0),
    ("last", 0),
    ("find", 1),
    ("position", 1),
    ("rposition", 1),
    ("next", 0),
    ("nth", 1),
];

impl Lowering<'_> {
    /// The value of a chain; none if the call is something else.
    pub(super) fn chain(&mut self, it: &mut syn::ExprMethodCall) -> Option<ExprKind> {
        let (end, arguments) = (text(&it.method), it.args.len());
        if (end.as_str(), arguments) == ("collect", 0) && is_chain(it) {
            return Some(self.collected(it));
        }
        if !ENDS.contains(&(end.as_str(), arguments)) || !is_chain(it) {
            return None;
        }
        if end != "try_fold" {
            return Some(self.end(it));
        }
        let before = self.refusals.len();
        let kind = self.scoped(|walk| walk.tried(it));
        if kind.is_none() && self.refusals.len() == before {
            self.refusals.add(&it.method, refuse::CHAIN);
        }
        Some(kind.unwrap_or(UNIT))
    }

    /// The end of a chain: a call of the library's function of that name.
    fn end(&mut self, it: &mut syn::ExprMethodCall) -> ExprKind {
        let mut arguments = vec![self.items_argument(&mut it.receiver)];
        let of_two = it.method == "fold" || it.method == "reduce";
        if it.method != "nth" {
            it.args.last_mut().into_iter().for_each(|last| in_full(last, of_two));
        }
        arguments.extend(it.args.iter_mut().map(|argument| self.argument(argument)));
        it.method = companion_name(&it.method);
        ExprKind::Call(self.take(it), arguments)
    }

    /// `for x in values.iter().filter(…)`: the body is what the chain ends in.
    pub(super) fn linked_loop(
        &mut self,
        it: &mut syn::ExprForLoop,
        label: Option<String>,
    ) -> Option<ExprKind> {
        let before = self.refusals.len();
        let kind = self.scoped(|walk| {
            let mut flow = walk.flow(&mut it.expr)?;
            let mut looks = Vec::new();
            walk.name_item(&mut flow, (&mut it.pat, Takes::Items), &mut looks)?;
            let body = walk.branch(&mut it.body, false);
            it.body.stmts.splice(0..0, looks);
            let last = tree::Stmt::Expr(plain(ExprKind::Block(body), &it.for_token));
            Some(flow.into_loop(last, label))
        });
        if kind.is_none() && self.refusals.len() == before {
            self.refusals.add(&it.expr, refuse::CHAIN);
        }
        kind
    }

    /// `items.try_fold(start, |so_far, item| …)`: what comes of what was gathered so far and of the item, until nothing does.
    fn tried(&mut self, it: &mut syn::ExprMethodCall) -> Option<ExprKind> {
        let node = it.method.clone();
        it.args.last_mut().into_iter().for_each(|last| in_full(last, true));
        let start = Start::Tried(Box::new(self.value(&mut it.args[0])));
        let mut flow = self.flow(&mut it.receiver)?;
        let name = self.hidden("tried");
        let gathered = || plain(ExprKind::Local(name.clone()), &node);
        let goes_on = |part| Box::new(tree::Pattern::Constructor(tree::GOES_ON.into(), vec![part]));
        let closure = closure_of(it.args.get_mut(1)?)?;
        let (mut looks, site) = (Vec::new(), gathered().site);
        let taken = self.pattern_apart(&closure.inputs.first()?.clone(), &mut looks);
        let (pattern, value, otherwise) = (goes_on(taken), gathered(), None);
        flow.steps.push(Step::Do(tree::Stmt::Apart { pattern, value, otherwise, site }));
        let next = self.through_with(&mut flow, closure, (1, Takes::Items), looks)?;
        let next = ExprKind::Assign(None, Box::new(gathered()), Box::new(next));
        flow.steps.push(Step::Do(tree::Stmt::Expr(plain(next, &node))));
        let stop = tree::Stmt::Expr(plain(ExprKind::Break(None, None), &node));
        let otherwise = Some(tree::Block { stmts: vec![stop], tail: None });
        let (pattern, value) = (goes_on(tree::Pattern::Any), gathered());
        let last = tree::Stmt::Apart { pattern, value, otherwise, site };
        let each = Box::new(plain(flow.into_loop(last, None), &node));
        Some(ExprKind::Fold { name, start, each })
    }

    pub(super) fn flow(&mut self, expr: &mut syn::Expr) -> Option<Flow> {
        if each::is_range(expr) {
            let (site, range) = (place(expr), self.range(expr)?);
            return Some(Flow {
                over: Over::Range(Box::new(range), None),
                before: Vec::new(),
                steps: Vec::new(),
                item: Item::Number,
                site,
            });
        }
        let site = place(expr);
        match expr {
            syn::Expr::Paren(it) => return self.flow(&mut it.expr),
            syn::Expr::MethodCall(it) => match (text(&it.method).as_str(), it.args.len()) {
                (link @ ("map" | "map_while" | "filter" | "take_while" | "skip_while"), 1) => {
                    let mut flow = self.flow(&mut it.receiver)?;
                    in_full(&mut it.args[0], false);
                    let of_items = ["map", "map_while"].contains(&link);
                    let takes = if of_items { Takes::Items } else { Takes::References };
                    let closure = closure_of(&mut it.args[0])?;
                    let value = self.through(&mut flow, closure, (0, takes))?;
                    match link {
                        "map" => flow.item = Item::Value(value),
                        "map_while" => flow.item = Item::Leading(value),
                        "skip_while" => self.skip_while(&mut flow, value, &it.method),
                        "filter" => flow.steps.push(Step::If(value)),
                        _ => flow.steps.push(Step::While(value)),
                    }
                    return Some(flow);
                }
                ("filter_map", 1) => {
                    let mut flow = self.flow(&mut it.receiver)?;
                    in_full(&mut it.args[0], false);
                    let closure = closure_of(&mut it.args[0])?;
                    let value = self.through(&mut flow, closure, (0, Takes::Items))?;
                    flow.item = Item::Optional(value);
                    return Some(flow);
                }
                ("scan", 2) => return self.scan(it),
                ("flat_map", 1) => {
                    let outer = self.flow(&mut it.receiver)?;
                    in_full(&mut it.args[0], false);
                    return self.nested(outer, closure_of(&mut it.args[0])?);
                }
                ("chain", 1) if is_linked(&it.receiver) || is_linked(&it.args[0]) => {
                    let (flow, slot) = self.both(it)?;
                    look_on_the_way(slot, expr);
                    return Some(flow);
                }
                ("flatten", 0) => {
                    let mut flow = self.flow(&mut it.receiver)?;
                    let value = self.item_value(&mut flow, &mut it.receiver)?;
                    flow.item = Item::Optional(value);
                    return Some(flow);
                }
                ("copied" | "cloned", 0) if is_linked(&it.receiver) => {
                    return self.flow(&mut it.receiver);
                }
                ("enumerate", 0) if is_linked(&it.receiver) => return self.numbered(it),
                ("rev" | "skip" | "take", _) if is_linked(&it.receiver) => return None,
                _ => {}
            },
            _ => {}
        }
        let Way { source, indexed, order, cuts } = self.way(expr);
        let over = Over::Each { index: None, parts: Vec::new(), indexed, order, cuts };
        let (before, steps) = (Vec::new(), Vec::new());
        Some(Flow { over, before, steps, item: Item::Source(source), site })
    }

    /// `.map(|x| …).enumerate()`: the index of the loop, or where items are left out a counter.
    fn numbered(&mut self, it: &mut syn::ExprMethodCall) -> Option<Flow> {
        let mut flow = self.flow(&mut it.receiver)?;
        let value = self.item_value(&mut flow, &mut it.receiver)?;
        let item = match &value.kind {
            ExprKind::Local(name) => name.clone(),
            _ => {
                let (name, slot, site) = (self.hidden(ITEM), value.slot?, value.site);
                let (known, value) = (name.clone(), Some(value));
                flow.steps.push(Step::Do(tree::Stmt::Let { name, slot, value, site }));
                known
            }
        };
        let number = self.hidden("i");
        let each = flow.steps.iter().all(|step| matches!(step, Step::Do(_)));
        match &mut flow.over {
            Over::Each { index, indexed: false, order: Order::Up, cuts, .. }
                if each && cuts.is_empty() =>
            {
                *index = Some(number.clone());
            }
            _ => {
                let node = &it.method;
                let (next, slot) = (self.hidden("next"), tree::NO_SLOT);
                let local = || Box::new(plain(ExprKind::Local(next.clone()), node));
                let word = |digits: &str| {
                    let size = Some(Scalar::Int(Int::Usize));
                    plain(ExprKind::Int(digits.into(), size), node)
                };
                let begin = word("0");
                let (name, site) = (next.clone(), begin.site);
                flow.before.push(tree::Stmt::Let { name, slot, value: Some(begin), site });
                let (name, value) = (number.clone(), Some(*local()));
                flow.steps.push(Step::Do(tree::Stmt::Let { name, slot, value, site }));
                let more = ExprKind::Assign(Some(BinaryOp::Add), local(), Box::new(word("1")));
                flow.steps.push(Step::Do(tree::Stmt::Expr(plain(more, node))));
            }
        }
        flow.item = Item::Pair(Box::new(Item::Named(number)), Box::new(Item::Named(item)));
        Some(flow)
    }

    /// `.skip_while(|x| …)`: a flag says whether items are still skipped; behind the first that is not, the closure is
    /// asked no more.
    fn skip_while(&mut self, flow: &mut Flow, condition: tree::Expr, node: &syn::Ident) {
        let name = self.hidden("skipping");
        let flag = || plain(ExprKind::Local(name.clone()), node);
        let value = Some(plain(ExprKind::Bool(true), node));
        let (site, slot) = (condition.site, tree::NO_SLOT);
        flow.before.push(tree::Stmt::Let { name: name.clone(), slot, value, site });
        let asked = ExprKind::Assign(None, Box::new(flag()), Box::new(condition));
        let then = tree::Block { stmts: vec![tree::Stmt::Expr(plain(asked, node))], tail: None };
        let ask = ExprKind::If(Box::new(flag()), then, None);
        flow.steps.push(Step::Do(tree::Stmt::Expr(plain(ask, node))));
        flow.steps.push(Step::If(plain(ExprKind::Unary(UnaryOp::Not, Box::new(flag())), node)));
    }

    /// `.scan(start, |state, x| …)`: a variable that each pass changes.
    fn scan(&mut self, it: &mut syn::ExprMethodCall) -> Option<Flow> {
        let mut flow = self.flow(&mut it.receiver)?;
        if !is_made_of_plain(&it.args[0]) {
            // It would be computed before what the chain begins with.
            self.refusals.add(&it.args[0], refuse::SCAN);
            return None;
        }
        let start = self.value(&mut it.args[0]);
        let closure = closure_of(&mut it.args[1])?;
        let state = closure_parameter(closure.inputs.first()?)?;
        let before = self.scopes.last().map_or(0, Vec::len);
        let (name, slot) = (self.bind_apart(&text(&state)), self.slot());
        let look = self.look_behind(slot, &state);
        let value = self.through_with(&mut flow, closure, (1, Takes::Items), vec![look])?;
        for (name, _) in self.scopes.last_mut()?.iter_mut().skip(before) {
            name.clear();
        }
        let site = start.site;
        flow.before.push(tree::Stmt::Let { name, slot, value: Some(start), site });
        flow.item = Item::Leading(value);
        Some(flow)
    }

    /// The items that a closure makes of those of a chain; `at`: which of its parameters takes them, and how.
    pub(super) fn through(
        &mut self,
        flow: &mut Flow,
        closure: &mut syn::ExprClosure,
        how: (usize, Takes),
    ) -> Option<tree::Expr> {
        self.through_with(flow, closure, how, Vec::new())
    }

    fn through_with(
        &mut self,
        flow: &mut Flow,
        closure: &mut syn::ExprClosure,
        (at, takes): (usize, Takes),
        mut looks: Vec<syn::Stmt>,
    ) -> Option<tree::Expr> {
        let pattern = closure.inputs.iter_mut().nth(at)?;
        let before = self.scopes.last().map_or(0, Vec::len);
        self.name_item(flow, (pattern, takes), &mut looks)?;
        let body = self.closure_body(closure, looks);
        // The next closure sees the names of the function, not those of this one.
        for (name, _) in self.scopes.last_mut()?.iter_mut().skip(before) {
            name.clear();
        }
        Some(body)
    }

    /// `core::array::from_fn(|i| …)`.
    pub(super) fn array_from_fn(&mut self, it: &mut syn::ExprCall) -> Option<ExprKind> {
        let syn::Expr::Path(function) = &*it.func else { return None };
        let mut segments = function.path.segments.iter().rev();
        let last = segments.next()?.ident.clone();
        if last != "from_fn" || segments.next()?.ident != "array" || it.args.len() != 1 {
            return None;
        }
        let closure = closure_of(&mut it.args[0])?;
        self.scoped(|walk| {
            let pattern = closure.inputs.first()?;
            let (index, looks) = match simple(pattern) {
                Some(name) => {
                    let slot = walk.slot();
                    (walk.bind_apart(&text(&name)), vec![walk.look(slot, &name)])
                }
                None if is_wild(pattern) => (walk.hidden("i"), Vec::new()),
                None => return None,
            };
            let value = walk.closure_body(closure, looks);
            let name = walk.hidden("elements");
            let local = |name: &str| Box::new(plain(ExprKind::Local(name.to_owned()), &last));
            let element = Box::new(plain(ExprKind::Index(local(&name), local(&index)), &last));
            let assign = plain(ExprKind::Assign(None, element, Box::new(value)), &last);
            // The loop goes through what it fills.
            let array = *local(&name);
            let pattern = tree::Pattern::Any;
            let part = tree::Part { pattern, array, owned: false, group: None, reversed: false };
            let body = tree::Block { stmts: vec![tree::Stmt::Expr(assign)], tail: None };
            let each = ExprKind::Each {
                label: None,
                index: Some(index),
                parts: vec![part],
                order: Order::Up,
                cuts: Vec::new(),
                body,
            };
            let each = Box::new(plain(each, &last));
            Some(ExprKind::Fold { name, start: Start::Elements, each })
        })
    }
}

/// Whether an end is one of a chain of iterators. Only these have ends that take a closure, but for nalgebra's `fold`.
fn is_chain(it: &syn::ExprMethodCall) -> bool {
    is_ended(it, it.args.len() == 1 && matches!(it.args[0], syn::Expr::Closure(_)))
}
