//! Walk along statements and loops.
//!
//! * A write changes the value of a place; places that may overlap it get unknown values.
//! * Where paths meet, a place gets a new symbol that equals its value on each path.
//! * A returned number is within the recorded bounds: each body is walked once with recording, after any trials.
//! * A counter is between the values of the bounds at the beginning of the loop.
//! * A word that a counted loop [moves](super::moved) by a bounded amount per pass moves by at most that times the
//!   number of passes.
//! * For other changed locals, bounds are guessed: first the initial ones, then joined with those at the end of a
//!   pass. A bound that is not preserved is dropped, until a pass that begins within all of them ends within them.
//!   After a counted loop, the local is within its initial bounds, its bounds at the end of a pass, or where the loop
//!   is left. After a loop that only its body ends, each place has its value at one of the `break`s.
//! * Of the [`orders`](super::orders), those hold at the head of a loop that each pass within all guesses preserves.

use std::rc::Rc;

use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Function, LocalId, LogicOp, Module, Stmt, StmtKind,
    Type, UnaryOp,
};

use super::knowledge::{Bounds, Formula, Knowledge};
use super::linear::Linear;
use super::returns::{self, Numbers, Returns};
use super::tracked::{FAR, Met, Moved, Order, put};
use super::values::{At, Parts, Point, Value, Values, fields_of, ordered, the_whole, within};
use super::written::{Target, apart, by_expr, by_stmts};
use crate::passes::sites::Site;
use bessemer_ir::used::Rule;

/// Largest nesting of trials in which bounds are guessed, since each level multiplies the time.
pub(super) const TRIALS: u32 = 2;

/// Guessed bounds of a local's word that a loop changes.
struct Guess {
    local: LocalId,
    at: Vec<At>,
    /// Initial bounds, guessed bounds, and bounds of its type.
    start: Bounds,
    now: Bounds,
    widest: Bounds,
    /// True if a pass has widened them.
    seen: bool,
}

pub(super) struct Walk<'m> {
    pub(super) values: Values<'m>,
    pub(super) function: &'m Function,
    /// For each surrounding loop, the points from which another pass begins, and those at which it is left.
    loops: Vec<(Vec<Point>, Vec<Point>)>,
    /// Numbers assigned to each local so far, if requested.
    held: Option<Vec<Option<Bounds>>>,
    /// Nesting of the trials in progress.
    pub(super) trials: u32,
    /// Bounds of the returned numbers so far.
    returned: Option<Numbers>,
}

impl<'m> Walk<'m> {
    pub(super) fn new(
        module: &'m Module,
        function: &'m Function,
        shown: &'m [Returns],
    ) -> Walk<'m> {
        let values = Values::new(module, function, shown);
        Walk { values, function, loops: Vec::new(), held: None, trials: 0, returned: None }
    }

    pub(super) fn run(mut self) -> (Vec<Site>, Returns) {
        let function = self.function;
        self.block(&function.body, Point::default());
        let returns = Returns::of(function, self.returned, self.values.shown);
        (self.values.open, returns)
    }

    /// Returns the numbers that are assigned to each local.
    pub(super) fn held(mut self) -> Vec<Option<Bounds>> {
        let function = self.function;
        self.held = Some(vec![None; function.locals.len()]);
        self.block(&function.body, Point::default());
        self.held.unwrap_or_default()
    }

    /// Records a value assigned to a local; not in a trial, whose facts need not be true.
    fn given(&mut self, point: &Point, local: LocalId, value: Option<&Value>) {
        let Some(held) = self.held.as_mut().filter(|_| !self.values.quiet) else { return };
        let (low, high) = match value {
            Some(Value::Number(form)) => point.knowledge.closest(form, &self.values.all),
            _ => (i128::MIN, i128::MAX),
        };
        let held = held[local.index()].get_or_insert((low, high));
        *held = (held.0.min(low), held.1.max(high));
    }

    /// Returns the point after a block; none if no path leads there.
    fn block(&mut self, block: &Block, point: Point) -> Option<Point> {
        block.0.iter().try_fold(point, |point, stmt| {
            self.stmt(stmt, point).filter(|point| !point.knowledge.dead)
        })
    }

    fn stmt(&mut self, stmt: &Stmt, mut point: Point) -> Option<Point> {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                let given = value.as_ref().map(|value| self.parts(value, &mut point));
                if let Some(given) = &given {
                    self.given(&point, *local, the_whole(given));
                }
                self.write(&mut point, &Target::whole(*local), given.unwrap_or_default());
            }
            StmtKind::Assign { place, value } => {
                let value = self.parts(value, &mut point);
                let at = self.values.steps(&mut point, place);
                let target = Target { local: place.root, at };
                if target.at.is_empty() {
                    self.given(&point, place.root, the_whole(&value));
                }
                self.write(&mut point, &target, value);
            }
            StmtKind::Expr(value) => {
                self.evaluated(value, &mut point);
            }
            StmtKind::Check { condition, fault: Fault::LeftOut } => {
                let needed = self.values.truth(&mut point, condition);
                self.values.need(&point, &needed, Site::of_check(stmt));
            }
            StmtKind::Check { condition, .. } => {
                self.values.value(&mut point, condition);
                self.assume(&mut point, condition, true);
            }
            StmtKind::If { condition, then, otherwise } => {
                self.evaluated(condition, &mut point);
                let mut other = point.clone();
                self.assume(&mut point, condition, true);
                self.assume(&mut other, condition, false);
                let ends = [self.block(then, point), self.block(otherwise, other)];
                return self.joined(ends.into_iter().flatten());
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let value = self.values.number(&mut point, scrutinee);
                let mut ends = Vec::new();
                let mut all: Vec<i128> =
                    arms.iter().flat_map(|arm| arm.values.iter().copied()).collect();
                for (index, arm) in arms.iter().enumerate() {
                    // The last arm represents whatever is no variant.
                    let rest = otherwise.is_none() && index + 1 == arms.len();
                    let mut point = point.clone();
                    self.one_of(&mut point, &value, &arm.values, rest.then_some(&scrutinee.ty));
                    ends.push(self.block(&arm.body, point));
                }
                if let Some(otherwise) = otherwise {
                    all.sort_unstable();
                    for number in all.iter().chain(all.iter().rev()) {
                        if let Some(not) = ordered(CompareOp::Ne, &value, &Linear::number(*number))
                        {
                            point.knowledge.assume(&not, &self.values.all);
                        }
                    }
                    ends.push(self.block(otherwise, point));
                }
                return self.joined(ends.into_iter().flatten());
            }
            StmtKind::For { .. } => return Some(self.repeat(&stmt.kind, point)),
            StmtKind::Return(value) => {
                if let Some(value) = value {
                    let parts = self.parts(value, &mut point);
                    // In a trial nothing is noted, either.
                    if !self.values.quiet {
                        let now = self.values.numbers(&point, &parts);
                        self.returned = Some(returns::with(self.returned.take(), now));
                    }
                }
                return None;
            }
            StmtKind::Break | StmtKind::Continue => {
                if let Some((continued, left)) = self.loops.last_mut() {
                    let to = if stmt.kind == StmtKind::Break { left } else { continued };
                    to.push(point);
                }
                return None;
            }
        }
        Some(point)
    }

    /// Returns the known words of a value with their positions. The value is a struct literal, or reached by fields
    /// alone. A borrowed value has no known words behind it.
    fn parts(&mut self, expr: &Expr, point: &mut Point) -> Parts {
        let mut parts = Vec::new();
        self.collect(expr, point, &[], &mut parts);
        self.forget(point, &by_expr(expr));
        parts
    }

    fn collect(&mut self, expr: &Expr, point: &mut Point, at: &[At], parts: &mut Parts) {
        if let ExprKind::Struct(fields) = &expr.kind {
            for (field, part) in (0..).zip(fields) {
                self.collect(part, point, &[at, &[At::Field(field)]].concat(), parts);
            }
            return;
        }
        let value = self.values.value(point, expr);
        if expr.ty.is_word() {
            parts.extend(value.map(|value| (at.to_vec(), value)));
        } else if let ExprKind::Call(callee, _) = expr.kind {
            let given = self.values.given(callee, &expr.ty).into_iter();
            parts.extend(given.map(|(inside, value)| ([at, &inside].concat(), value)));
        } else if let ExprKind::Load(from) = &expr.kind
            && let Some(steps) = fields_of(from)
        {
            let held = point.places.get(from.root.0).into_iter().flatten();
            let inside = held.filter_map(|(other, value)| {
                let rest = other.strip_prefix(steps.as_slice())?;
                Some(([at, rest].concat(), value.clone()))
            });
            parts.extend(inside);
        }
    }

    /// Returns the value of an expression; places that it borrows mutably become unknown.
    fn evaluated(&mut self, expr: &Expr, point: &mut Point) -> Option<Value> {
        let value = self.values.value(point, expr);
        self.forget(point, &by_expr(expr));
        value
    }

    /// Adds the fact that a value is one of `numbers`, or an invalid value of the enum `rest`.
    fn one_of(&mut self, point: &mut Point, value: &Linear, numbers: &[i128], rest: Option<&Type>) {
        let stray = match rest {
            Some(Type::Enum(id)) => {
                Some(self.values.module.enums[id.index()].variants.len() as i128)
            }
            _ => None,
        };
        let numbers: Vec<i128> = numbers.iter().copied().chain(stray).collect();
        let (Some(low), Some(high)) = (numbers.iter().min(), numbers.iter().max()) else { return };
        let equal = |number: &i128| ordered(CompareOp::Eq, value, &Linear::number(*number));
        let any: Option<Vec<Formula>> = numbers.iter().map(equal).collect();
        if let (Some(hull), Some(any)) = (within(value, (*low, *high)), any) {
            point.knowledge.assume(&hull, &self.values.all);
            point.knowledge.assume(&Formula::Any(any), &self.values.all);
        }
    }

    /// Adds the fact that an evaluated condition has this truth.
    fn assume(&mut self, point: &mut Point, condition: &Expr, truth: bool) {
        match &condition.kind {
            ExprKind::Unary(UnaryOp::Not, inner) => self.assume(point, inner, !truth),
            ExprKind::Logic(op, a, b) if (*op == LogicOp::And) == truth => {
                self.assume(point, a, truth);
                self.assume(point, b, truth);
            }
            _ => {
                let quiet = std::mem::replace(&mut self.values.quiet, true);
                let formula = self.values.truth(point, condition);
                self.values.quiet = quiet;
                let formula = if truth { formula } else { formula.not() };
                point.knowledge.assume(&formula, &self.values.all);
            }
        }
    }

    /// Writes a target.
    fn write(&mut self, point: &mut Point, target: &Target, value: Parts) {
        point.version = self.values.next_version();
        let held = point.places.change(target.local.0);
        held.retain(|(other, _)| other.iter().zip(&target.at).any(|(a, b)| apart(a, b)));
        held.extend(value.into_iter().map(|(at, part)| ([&target.at[..], &at].concat(), part)));
    }

    fn forget(&mut self, point: &mut Point, targets: &[Target]) {
        targets.iter().for_each(|target| self.write(point, target, Vec::new()));
    }

    fn joined(&mut self, points: impl IntoIterator<Item = Point>) -> Option<Point> {
        points.into_iter().reduce(|a, b| self.join(a, b))
    }

    /// Returns the point where two paths meet.
    fn join(&mut self, mut a: Point, mut b: Point) -> Point {
        if a.knowledge.dead || b.knowledge.dead {
            return if a.knowledge.dead { b } else { a };
        }
        let mut numbers = Vec::new();
        for (root, one, other) in a.places.differences(&b.places) {
            let both = one.zip(other);
            let kept = both.map(|(one, other)| {
                let root = LocalId(root);
                let parts = one.iter().filter_map(|(at, value)| {
                    let (_, other) = other.iter().find(|(it, _)| it == at)?;
                    let paths = [(&mut a.knowledge, value), (&mut b.knowledge, other)];
                    let met = self.met(root, at, paths)?;
                    numbers.extend(Met::of(&met, value, other));
                    Some((at.clone(), met))
                });
                Rc::new(parts.collect())
            });
            a.places.set(root, kept);
        }
        self.order([&mut a.knowledge, &mut b.knowledge], &numbers);
        a.knowledge.join(&b.knowledge, &self.values.all);
        let version = if a.version == b.version { a.version } else { self.values.next_version() };
        Point { knowledge: a.knowledge, places: a.places, version }
    }

    /// The value of a place where two paths meet, from its value on each path; nothing if neither number nor equality shows.
    fn met(
        &mut self,
        root: LocalId,
        at: &[At],
        paths: [(&mut Knowledge, &Value); 2],
    ) -> Option<Value> {
        let [(a, one), (b, other)] = paths;
        if one == other {
            return Some(one.clone());
        }
        let (Value::Number(x), Value::Number(y)) = (one, other) else { return None };
        let (p, q) = (a.range(x, &self.values.all), b.range(y, &self.values.all));
        // Whatever bounds a form has, its value is one of the type.
        let (low, high) = self.values.type_bounds(root, at);
        let symbol = self.values.fresh((p.0.min(q.0).max(low), p.1.max(q.1).min(high)));
        let form = Linear::symbol(symbol);
        for (knowledge, held) in [(a, x), (b, y)] {
            if let Some(equal) = ordered(CompareOp::Eq, &form, held) {
                knowledge.assume(&equal, &self.values.all);
            }
        }
        Some(Value::Number(form))
    }

    /// Walks through the body of a loop; returns the point where another pass begins, and the points where the loop
    /// is left.
    fn pass(&mut self, body: &Block, head: Point) -> (Option<Point>, Vec<Point>) {
        self.loops.push((Vec::new(), Vec::new()));
        let end = self.block(body, head);
        let (continued, left) = self.loops.pop().unwrap_or_default();
        (self.joined(end.into_iter().chain(continued)), left)
    }

    /// Analyses a body without reporting what may fault.
    pub(super) fn trial(&mut self, body: &Block, head: Point) -> (Option<Point>, Vec<Point>) {
        let quiet = std::mem::replace(&mut self.values.quiet, true);
        self.trials += 1;
        let ends = self.pass(body, head);
        self.trials -= 1;
        self.values.quiet = quiet;
        ends
    }

    /// Walks through a loop, and returns the point after it.
    fn repeat(&mut self, kind: &StmtKind, mut before: Point) -> Point {
        let StmtKind::For { variable, from, to, inclusive, reversed, ended, body, .. } = kind
        else {
            return before;
        };
        let first = self.values.number(&mut before, from);
        let end = self.values.number(&mut before, to);
        let mut written = by_stmts(&body.0);
        written.push(Target::whole(*variable));
        let mut empty = before.clone();
        self.forget(&mut empty, &written);
        if *ended {
            let guesses = self.guesses(&before, &written, &[]);
            let mut orders = self.orders(&before, &written, body);
            let (head, _) = self.guessed(&empty, guesses, &mut orders, body);
            let (_, left) = self.pass(body, head);
            return self.joined(left).unwrap_or(empty);
        }
        let all = self.values.unknown(&from.ty);
        let (Some(Value::Number(counter)), Some(last)) =
            (all, end.shifted(i128::from(*inclusive) - 1))
        else {
            self.pass(body, empty.clone());
            return empty;
        };
        let mut head = empty.clone();
        head.places.insert(variable.0, vec![(Vec::new(), Value::Number(counter.clone()))]);
        for (low, high) in [(&first, &counter), (&counter, &last)] {
            if let Some(order) = ordered(CompareOp::Le, low, high) {
                head.knowledge.assume(&order, &self.values.all);
            }
        }
        let done = if *reversed { last.minus(&counter) } else { counter.minus(&first) };
        let most = last.minus(&first).and_then(|it| it.shifted(1));
        let most = most.map_or(i128::MAX, |it| before.knowledge.closest(&it, &self.values.all).1);
        let mut behind = empty;
        let moved = self.moved(&before, &head, &written, most, body);
        // What moves far in a pass may be set rather than moved, so its bounds are guessed, too.
        let steady: Vec<LocalId> =
            moved.iter().filter(|it| it.by.1 - it.by.0 < FAR).map(|it| it.word.local).collect();
        for Moved { word, old, by: (down, up) } in moved {
            Rule::Moved.used();
            let Some(Value::Number(now)) = self.unknown_at(&word) else { continue };
            // old + down · done <= now <= old + up · done
            let steps =
                done.as_ref().and_then(|done| Some((old.plus(down, done)?, old.plus(up, done)?)));
            if let Some((low, high)) = steps {
                self.between(&mut head, &now, [&low, &high]);
            }
            put(&mut head, &word, now);
            let Some(Value::Number(then)) = self.unknown_at(&word) else { continue };
            let passes = most.max(0);
            let ends = (down.min(0).checked_mul(passes), up.max(0).checked_mul(passes));
            let ends =
                (ends.0.and_then(|by| old.shifted(by)), ends.1.and_then(|by| old.shifted(by)));
            if let (Some(low), Some(high)) = ends {
                self.between(&mut behind, &then, [&low, &high]);
            }
            put(&mut behind, &word, then);
        }
        let guesses = self.guesses(&before, &written, &steady);
        let mut orders = self.orders(&before, &written, body);
        let kept = if guesses.is_empty() && orders.is_empty() || head.knowledge.dead {
            orders.clear();
            Vec::new()
        } else {
            let (with, kept) = self.guessed(&head, guesses, &mut orders, body);
            head = with;
            kept
        };
        let left = match head.knowledge.dead {
            true => Vec::new(),
            false => self.pass(body, head).1,
        };
        for Guess { local, at, now: mut hull, .. } in kept {
            for point in &left {
                let held = point.places.get(local.0).and_then(|it| it.iter().find(|it| it.0 == at));
                let end = match held {
                    Some((_, Value::Number(form))) => {
                        point.knowledge.closest(form, &self.values.all)
                    }
                    _ => (i128::MIN, i128::MAX),
                };
                hull = (hull.0.min(end.0), hull.1.max(end.1));
            }
            self.bound(&mut behind, Target { local, at }, hull);
        }
        // Each holds before the loop, after each pass, and wherever else the loop is left.
        orders.retain(|order| left.iter().all(|point| self.is_shown(point, order)));
        self.assume_orders(&mut behind, &orders);
        behind
    }

    /// Gives the number at a place these bounds, besides those that it has.
    fn bound(&mut self, point: &mut Point, word: Target, bounds: Bounds) {
        let widest = self.values.type_bounds(word.local, &word.at);
        let bounds = (bounds.0.max(widest.0), bounds.1.min(widest.1));
        let held =
            point.places.get(word.local.0).and_then(|it| it.iter().find(|it| it.0 == word.at));
        if let Some((_, Value::Number(form))) = held
            && let Some(formula) = within(form, bounds)
        {
            point.knowledge.assume(&formula, &self.values.all);
            return;
        }
        let symbol = self.values.fresh(bounds);
        put(point, &word, Linear::symbol(symbol));
    }

    fn between(&mut self, point: &mut Point, form: &Linear, [low, high]: [&Linear; 2]) {
        for (a, b) in [(low, form), (form, high)] {
            if let Some(order) = ordered(CompareOp::Le, a, b) {
                point.knowledge.assume(&order, &self.values.all);
            }
        }
    }

    /// Returns initial guesses for the words that a loop writes, except locals that are tracked otherwise.
    fn guesses(&mut self, before: &Point, written: &[Target], moving: &[LocalId]) -> Vec<Guess> {
        let mut guesses: Vec<Guess> = Vec::new();
        if self.trials >= TRIALS {
            return guesses;
        }
        for Target { local, .. } in written.iter().filter(|it| !moving.contains(&it.local)) {
            for (at, value) in before.places.get(local.0).into_iter().flatten() {
                let Value::Number(form) = value else { continue };
                let fields = at.iter().all(|step| matches!(step, At::Field(_)));
                let part = Target { local: *local, at: at.clone() };
                let meets = written.iter().any(|it| it.meets(&part));
                let same = |it: &Guess| it.local == *local && it.at == *at;
                if fields && meets && !guesses.iter().any(same) {
                    let start = before.knowledge.range(form, &self.values.all);
                    let widest = self.values.type_bounds(*local, at);
                    let at = at.clone();
                    guesses.push(Guess {
                        local: *local,
                        at,
                        start,
                        now: start,
                        widest,
                        seen: false,
                    });
                }
            }
        }
        guesses
    }

    /// Returns the head of a loop with bounds that each pass preserves, and these bounds. Of the orders, those remain
    /// that each pass preserves.
    fn guessed(
        &mut self,
        empty: &Point,
        mut guesses: Vec<Guess>,
        orders: &mut Vec<Order>,
        body: &Block,
    ) -> (Point, Vec<Guess>) {
        loop {
            let head = self.head(empty, &guesses, orders);
            let (again, _) = self.trial(body, head);
            let Some(again) = again else { break };
            let known = orders.len();
            orders.retain(|order| self.is_shown(&again, order));
            let mut kept = orders.len() == known;
            let mut ends = Vec::new();
            for Guess { local, at, now, widest, seen, .. } in &mut guesses {
                let held =
                    again.places.get(local.0).and_then(|it| it.iter().find(|(it, _)| *it == *at));
                let end = match held {
                    Some((_, Value::Number(form))) => {
                        again.knowledge.closest(form, &self.values.all)
                    }
                    _ => *widest,
                };
                let end = (end.0.max(widest.0), end.1.min(widest.1));
                let wider = (end.0.min(now.0), end.1.max(now.1));
                if wider != *now {
                    // What a pass widens again may move on for ever.
                    let low = if *seen && wider.0 < now.0 { widest.0 } else { wider.0 };
                    let high = if *seen && wider.1 > now.1 { widest.1 } else { wider.1 };
                    (*now, *seen, kept) = ((low, high), true, false);
                }
                ends.push(end);
            }
            if kept {
                // The head is reached only before the first pass and after a pass within the guesses.
                for (Guess { start, now, .. }, end) in guesses.iter_mut().zip(ends) {
                    *now = (start.0.min(end.0), start.1.max(end.1));
                }
                break;
            }
        }
        Rule::Guessed.told(!guesses.is_empty());
        (self.head(empty, &guesses, orders), guesses)
    }

    fn head(&mut self, empty: &Point, guesses: &[Guess], orders: &[Order]) -> Point {
        let mut head = empty.clone();
        for Guess { local, at, now, .. } in guesses {
            self.bound(&mut head, Target { local: *local, at: at.clone() }, *now);
        }
        self.assume_orders(&mut head, orders);
        head
    }
}
