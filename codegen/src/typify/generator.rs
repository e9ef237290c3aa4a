//! Functions that give or take iterators, put where what they give is gone through.
//!
//! A function that gives one hands each item to a closure; a loop through it is the function's own loop, in which the body
//! of the author's loop stands for that closure. An iterator that is an argument is a closure of the same kind: a loop
//! through the parameter is the loop that stands in the argument.
//!
//! Invariants: one loop of the function hands its items on, so that what leaves the body's pass, or the author's loop,
//! leaves the same of that one.

use std::rc::Rc;

use bessemer_ir::tree::visit::{VisitMut, walk_expr_mut};
use bessemer_ir::tree::{self, EACH, ExprKind as Tree, ITER, ITER_MUT, NO_SLOT, Order, Site, Stmt};
use bessemer_ir::{Place, Type};

use super::call::Called;
use super::lowering::{Lowering, Said};
use super::value::Value;
use super::{Result, problem};

/// A loop through what a function gives.
pub(super) struct Generated<'a, 'e> {
    by: By<'a, 'e>,
    pattern: &'e tree::Pattern,
    /// Whether it is gone through one by one, as it comes.
    straight: bool,
}

/// What gives the items.
enum By<'a, 'e> {
    /// A call of a function.
    Call(Called<'a, 'e>),
    /// An iterator that is an argument.
    Argument(usize),
}

/// Whether a function gives an iterator.
pub(super) fn generates(function: &tree::Function) -> bool {
    function.tree.params.last().is_some_and(|param| param.name == EACH)
}

impl<'a> Lowering<'a, '_> {
    /// What a loop goes through, if a function gives that.
    pub(super) fn generated<'e>(
        &mut self,
        parts: &'e [tree::Part],
    ) -> Result<Option<Generated<'a, 'e>>> {
        let mut found = None;
        for part in parts {
            let called = self.expansion(&part.array).filter(|(it, _)| generates(it));
            let by = match called {
                Some(called) => Some(By::Call(called)),
                None if let Some(closure) = self.items_given(&part.array) => {
                    Some(By::Argument(closure))
                }
                // What is gone through by value is what `into_iter` gives, which may be something else.
                None if part.owned => None,
                None => {
                    let own = self.own_items(&part.array)?;
                    own.map(By::Call)
                }
            };
            let Some(by) = by else { continue };
            if parts.len() > 1 {
                return problem(
                    part.array.site,
                    "what a function gives is gone through by itself in the DSL",
                    "go through it alone, and count: `.enumerate()`, and index the other",
                );
            }
            let straight = part.group.is_none() && !part.reversed;
            found = Some(Generated { by, pattern: &part.pattern, straight });
        }
        Ok(found)
    }

    /// The iterator that a parameter is.
    fn items_given(&self, of: &tree::Expr) -> Option<usize> {
        let Tree::Local(name) = &of.kind else { return None };
        let mut params = self.source.tree.params.iter();
        params.find(|param| param.items && param.name == *name)?;
        self.closure_named(name)
    }

    /// An author's own `iter` of what is gone through: the adaptor is the iterator's own, as its name is.
    fn own_items<'e>(&mut self, of: &'e tree::Expr) -> Result<Option<Called<'a, 'e>>> {
        let is_place = matches!(of.kind, Tree::Local(_) | Tree::Field(..) | Tree::Index(..));
        let own = |it: &&&'a tree::Function| generates(it) && it.tree.name == ITER;
        if !is_place || self.holds_nothing(of) {
            return Ok(None);
        }
        let own: Vec<_> = self.cx.all.values().filter(own).copied().collect();
        let other = |it: &&&'a tree::Function| generates(it) && it.tree.name == ITER_MUT;
        let changed: Vec<_> = self.cx.all.values().filter(other).map(|it| &it.owner).collect();
        if own.is_empty() {
            return Ok(None);
        }
        let Type::Struct(id) = self.type_alone(of)? else { return Ok(None) };
        let path = self.cx.types.iter().find(|(_, ty)| **ty == Type::Struct(id));
        let path = path.map(|(path, _)| path.as_str());
        let function = own.into_iter().find(|it| it.owner.as_deref() == path);
        let function = function.filter(|it| !changed.contains(&&it.owner));
        Ok(function.map(|function| (function, std::slice::from_ref(of))))
    }

    /// `for pattern in function(arguments)`.
    pub(super) fn generated_stmt(
        &mut self,
        site: Site,
        (said, index): (Said<'_>, Option<&str>),
        generated: Generated<'a, '_>,
        (order, cuts): (Order, &[tree::Cut]),
        body: &tree::Block,
    ) -> Result<()> {
        let Generated { by, pattern, straight } = generated;
        let way = Way { order, counted: index.is_some() };
        let plain = match &by {
            By::Argument(closure) => way.of(&self.closures[*closure].text.body),
            By::Call(_) => None,
        };
        if !straight || (order != Order::Up && plain.is_none()) || !cuts.is_empty() {
            return problem(
                site,
                "what a function gives is gone through one by one in the DSL, and from the first on",
                "count with `.enumerate()`, and leave out in the loop, or in a `.filter(…)`, what is not wanted",
            );
        }
        self.naming_scope(|inner| {
            let mut body = body.clone();
            let mut pattern = pattern.clone();
            if let Some(index) = index {
                match plain {
                    Some(_) => pattern = tree::Pattern::Tuple(vec![named(index), pattern]),
                    None => inner.count_items(index, &mut body, site)?,
                }
            }
            let body = tree::Expr { kind: Tree::Block(body), site, slot: None };
            let (name, parameters, body) = (None, vec![pattern], Box::new(body));
            let closure = tree::Closure { name, parameters, body };
            match by {
                By::Call((function, arguments)) => {
                    let mut bound = inner.given_to(function, arguments)?;
                    bound.push((EACH.to_owned(), inner.closure_here(closure)));
                    let mut text = function.tree.body.clone();
                    if let Some(Stmt::Expr(last)) = text.stmts.last_mut() {
                        stands_for(said, last);
                    }
                    inner.inside(function, bound, site, |inner| inner.stmts(&text))
                }
                By::Argument(through) => {
                    let each = inner.closure_here(closure);
                    let through = Rc::clone(&inner.closures[through]);
                    let mut text = plain.unwrap_or_else(|| (*through.text.body).clone());
                    stands_for(said, &mut text);
                    inner.in_scope_of(&through, Some(each), site, |inner| inner.effect(&text))
                }
            }
        })
    }

    /// What a function hands on: of an element that has a name, its place, by the counter of the function's loop.
    /// A value has the name that its taker gives it.
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
                Value::Place(place) => Ok(Value::Place(place)),
                Value::Local(local) if !self.steady.contains(&local) => {
                    // Nothing else writes to it: it was made to be handed on.
                    self.held.insert(local);
                    if let Some(tree::Pattern::Name { name, mutable: false, inner: None, .. }) =
                        taken
                        && !name.contains('%')
                    {
                        self.locals[local.index()].name.clone_from(name);
                    }
                    self.subject(expr)
                }
                _ => self.subject(expr),
            },
            _ => self.subject(expr),
        }
    }

    /// The counter of a loop, if that is what is handed on: nothing else changes it.
    pub(super) fn counted(&self, subject: &Value) -> Option<Place> {
        match subject {
            Value::Place(place) if place.steps.is_empty() && self.steady.contains(&place.root) => {
                Some(place.clone())
            }
            _ => None,
        }
    }

    /// Numbers the items, from zero on.
    fn count_items(&mut self, index: &str, body: &mut tree::Block, site: Site) -> Result<()> {
        let plain = |kind| tree::Expr { kind, site, slot: None };
        let size = Some(bessemer_ir::Scalar::Int(bessemer_ir::Int::Usize));
        let number = |digits: &str| plain(Tree::Int(digits.into(), size));
        let next = || plain(Tree::Local(NEXT.into()));
        let named = |name: &str, value| Stmt::Let {
            name: name.into(),
            slot: NO_SLOT,
            value: Some(value),
            site,
        };
        let more = Tree::Assign(Some(tree::BinaryOp::Add), Box::new(next()), Box::new(number("1")));
        body.stmts.splice(0..0, [named(index, next()), Stmt::Expr(plain(more))]);
        let begin = tree::Block { stmts: vec![named(NEXT, number("0"))], tail: None };
        self.stmts(&begin)
    }
}

/// How a loop goes through an iterator that is an argument.
struct Way {
    order: Order,
    counted: bool,
}

impl Way {
    /// A loop that hands on each element, going that way itself, each element with its index if they are counted; none if
    /// that cannot be said of it.
    fn of(&self, through: &tree::Expr) -> Option<tree::Expr> {
        let mut text = through.clone();
        let Tree::Each { index: own @ None, order, cuts, body, .. } = &mut text.kind else {
            return None;
        };
        *order = match (*order, self.order, self.counted) {
            (own, Order::Up, false) => own,
            (own, Order::Down, false) if own != Order::Mirrored => match own {
                Order::Up => Order::Down,
                _ => Order::Up,
            },
            (Order::Up, Order::Up | Order::Down, true) if cuts.is_empty() => self.order,
            (Order::Down, Order::Up, true) if cuts.is_empty() => Order::Mirrored,
            _ => return None,
        };
        if self.counted {
            let [Stmt::Expr(tree::Expr { kind: Tree::Apply(_, items), site, .. })] =
                body.stmts.as_mut_slice()
            else {
                return None;
            };
            let of = |kind| tree::Expr { kind, site: *site, slot: None };
            let counter = of(Tree::Local(COUNTER.into()));
            let pair = std::iter::once(counter).chain(std::mem::take(items)).collect();
            *items = vec![of(Tree::Tuple(pair))];
            *own = Some(COUNTER.into());
        }
        Some(text)
    }
}

/// The index of an element that is handed on.
const COUNTER: &str = "i%";

fn named(name: &str) -> tree::Pattern {
    let (name, slot) = (name.to_owned(), NO_SLOT);
    tree::Pattern::Name { name, slot, mutable: false, inner: None }
}

/// The number of the next item.
const NEXT: &str = "next%";

/// Says of the loop that gives items what its author says of the loop through them.
fn stands_for(said: Said<'_>, given: &mut tree::Expr) {
    if let Some(label) = said.label {
        Labels(label).expr(given);
    }
    if said.joined {
        join(given);
    }
}

/// Gives a loop, and all loops that are one with it, a label: what goes on with one goes on with the innermost.
struct Labels<'l>(&'l str);

impl VisitMut for Labels<'_> {
    fn expr(&mut self, expr: &mut tree::Expr) {
        match &mut expr.kind {
            Tree::For { label, body, .. } | Tree::Each { label, body, .. } => {
                *label = Some(self.0.to_owned());
                body.stmts.iter_mut().for_each(|stmt| Parts(self.0).stmt(stmt));
            }
            Tree::Joined(inner) => self.expr(inner),
            Tree::Block(block) | Tree::Labelled(_, block) => {
                for stmt in &mut block.stmts {
                    if let Stmt::Expr(part) = stmt {
                        self.expr(part);
                    }
                }
            }
            _ => {}
        }
    }
}

/// The loops within one that are one with it.
struct Parts<'l>(&'l str);

impl VisitMut for Parts<'_> {
    fn expr(&mut self, expr: &mut tree::Expr) {
        match &mut expr.kind {
            Tree::Joined(inner) => Labels(self.0).expr(inner),
            _ => walk_expr_mut(self, expr),
        }
    }
}

/// Makes a loop one with what stands around the loop through its items.
fn join(given: &mut tree::Expr) {
    match &mut given.kind {
        Tree::For { .. } | Tree::Each { .. } => {
            let (site, whole) = (given.site, given.clone());
            *given = tree::Expr { kind: Tree::Joined(Box::new(whole)), site, slot: None };
        }
        Tree::Labelled(_, block) => given.kind = Tree::Block(std::mem::take(block)),
        Tree::Block(block) => {
            if let Some(Stmt::Expr(last)) = block.stmts.last_mut() {
                join(last);
            }
        }
        _ => {}
    }
}
