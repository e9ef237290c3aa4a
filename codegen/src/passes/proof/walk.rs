//! Statements, one after another, and loops.
//!
//! * A write changes which value a place holds; places that may be the same memory hold something new.
//! * Where paths meet, a place holds a new symbol that equals on each path what it held there.
//! * A counter lies between the values that the bounds had when the loop began.
//! * What a counted loop changes moves by so much in a pass, whatever it was before: by that times the passes at most
//!   in all of them.
//! * Of a loop that its body ends bounds are guessed: those from before. One that a pass does not keep is given up, until
//!   a pass that begins within all of them ends within all of them.

use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Function, LocalId, LogicOp, Module, Step, Stmt,
    StmtKind, Type, UnaryOp,
};

use super::knowledge::{Bounds, Formula};
use super::linear::{Linear, Symbol};
use super::values::{At, Point, Value, Values, ordered, step_type, within};
use super::written::{Target, apart, by_expr, by_stmts};
use crate::passes::sites::Site;
use crate::used::Rule;

/// The most that a pass may move a number for it to be followed.
const FAST: i128 = 1 << 32;

pub(super) struct Walk<'m> {
    values: Values<'m>,
    function: &'m Function,
    /// Of each loop around: the points from which another pass begins, and those at which it is left.
    loops: Vec<(Vec<Point>, Vec<Point>)>,
    /// Of each local, the numbers that it was given so far, where that is asked.
    held: Option<Vec<Option<Bounds>>>,
}

impl<'m> Walk<'m> {
    pub(super) fn new(module: &'m Module, function: &'m Function) -> Walk<'m> {
        Walk { values: Values::new(module, function), function, loops: Vec::new(), held: None }
    }

    pub(super) fn run(mut self) -> Vec<Site> {
        let function = self.function;
        self.block(&function.body, Point::default());
        self.values.open
    }

    /// The numbers that each local is given.
    pub(super) fn held(mut self) -> Vec<Option<Bounds>> {
        let function = self.function;
        self.held = Some(vec![None; function.locals.len()]);
        self.block(&function.body, Point::default());
        self.held.unwrap_or_default()
    }

    /// A local is given a value; in a trial, of which nothing has to be true yet, nothing is noted.
    fn given(&mut self, point: &Point, local: LocalId, value: Option<&Value>) {
        let Some(held) = self.held.as_mut().filter(|_| !self.values.quiet) else { return };
        let (low, high) = match value {
            Some(Value::Number(form)) => point.knowledge.closest(form, &self.values.all),
            _ => (i128::MIN, i128::MAX),
        };
        let held = held[local.index()].get_or_insert((low, high));
        *held = (held.0.min(low), held.1.max(high));
    }

    /// The point behind a block; nothing where no path leads there.
    fn block(&mut self, block: &Block, point: Point) -> Option<Point> {
        block.0.iter().try_fold(point, |point, stmt| {
            self.stmt(stmt, point).filter(|point| !point.knowledge.dead)
        })
    }

    fn stmt(&mut self, stmt: &Stmt, mut point: Point) -> Option<Point> {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                let given = value.as_ref().and_then(|value| self.evaluated(value, &mut point));
                if value.is_some() {
                    self.given(&point, *local, given.as_ref());
                }
                self.write(&mut point, &Target::whole(*local), given);
            }
            StmtKind::Assign { place, value } => {
                let value = self.evaluated(value, &mut point);
                let at = self.values.steps(&mut point, place);
                let target = Target { local: place.root, at };
                if target.at.is_empty() {
                    self.given(&point, place.root, value.as_ref());
                }
                self.write(&mut point, &target, value.filter(|_| place.ty.is_word()));
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
                self.values.value(&mut point, condition);
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
                    // The last arm stands for whatever is no variant.
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
                    self.values.value(&mut point, value);
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

    /// The value of an expression; behind it, what it lent may hold anything.
    fn evaluated(&mut self, expr: &Expr, point: &mut Point) -> Option<Value> {
        let value = self.values.value(point, expr);
        self.forget(point, &by_expr(expr));
        value
    }

    /// From here on the value is one of these, or none of the variants of `rest`.
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

    /// From here on a condition, which was evaluated, has this truth.
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

    /// A target is written.
    fn write(&mut self, point: &mut Point, target: &Target, value: Option<Value>) {
        point.version = self.values.next_version();
        let held = point.places.entry(target.local).or_default();
        held.retain(|(other, _)| other.iter().zip(&target.at).any(|(a, b)| apart(a, b)));
        if let Some(value) = value {
            held.push((target.at.clone(), value));
        }
    }

    fn forget(&mut self, point: &mut Point, targets: &[Target]) {
        targets.iter().for_each(|target| self.write(point, target, None));
    }

    fn joined(&mut self, points: impl IntoIterator<Item = Point>) -> Option<Point> {
        points.into_iter().reduce(|a, b| self.join(a, b))
    }

    /// The point where two paths meet.
    fn join(&mut self, mut a: Point, mut b: Point) -> Point {
        if a.knowledge.dead || b.knowledge.dead {
            return if a.knowledge.dead { b } else { a };
        }
        let mut places = std::collections::HashMap::new();
        for (root, held) in std::mem::take(&mut a.places) {
            let Some(others) = b.places.get(&root) else { continue };
            let mut kept = Vec::new();
            for (at, value) in held {
                let Some((_, other)) = others.iter().find(|(it, _)| *it == at) else { continue };
                if value == *other {
                    kept.push((at, value));
                } else if let (Value::Number(x), Value::Number(y)) = (&value, other) {
                    let all = &self.values.all;
                    let (p, q) = (a.knowledge.range(x, all), b.knowledge.range(y, all));
                    let symbol = self.values.fresh((p.0.min(q.0), p.1.max(q.1)));
                    let form = Linear::symbol(symbol);
                    for (knowledge, held) in [(&mut a.knowledge, x), (&mut b.knowledge, y)] {
                        if let Some(equal) = ordered(CompareOp::Eq, &form, held) {
                            knowledge.assume(&equal, &self.values.all);
                        }
                    }
                    kept.push((at, Value::Number(form)));
                }
            }
            places.insert(root, kept);
        }
        a.knowledge.join(&b.knowledge, &self.values.all);
        let version = if a.version == b.version { a.version } else { self.values.next_version() };
        Point { knowledge: a.knowledge, places, version }
    }

    /// Follows the body of a loop: the point where another pass begins, and those where it is left.
    fn pass(&mut self, body: &Block, head: Point) -> (Option<Point>, Vec<Point>) {
        self.loops.push((Vec::new(), Vec::new()));
        let end = self.block(body, head);
        let (continued, left) = self.loops.pop().unwrap_or_default();
        (self.joined(end.into_iter().chain(continued)), left)
    }

    /// The same without a word of what may fault.
    fn trial(&mut self, body: &Block, head: Point) -> (Option<Point>, Vec<Point>) {
        let quiet = std::mem::replace(&mut self.values.quiet, true);
        let ends = self.pass(body, head);
        self.values.quiet = quiet;
        ends
    }

    /// Looks at a loop; the point behind it.
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
            let head = self.guessed(&before, &empty, &written, body);
            self.pass(body, head);
            return empty;
        }
        let all = self.values.unknown(&from.ty);
        let (Some(Value::Number(counter)), Some(last)) =
            (all, end.shifted(i128::from(*inclusive) - 1))
        else {
            self.pass(body, empty.clone());
            return empty;
        };
        let mut head = empty.clone();
        head.places.insert(*variable, vec![(Vec::new(), Value::Number(counter.clone()))]);
        for (low, high) in [(&first, &counter), (&counter, &last)] {
            if let Some(order) = ordered(CompareOp::Le, low, high) {
                head.knowledge.assume(&order, &self.values.all);
            }
        }
        let done = if *reversed { last.minus(&counter) } else { counter.minus(&first) };
        let most = last.minus(&first).and_then(|it| it.shifted(1));
        let most = most.map_or(i128::MAX, |it| before.knowledge.closest(&it, &self.values.all).1);
        let mut behind = empty;
        let moved = self.moved(&before, &head, &written, body);
        for (local, old, (down, up)) in moved {
            Rule::Moved.used();
            let Some(Value::Number(now)) = self.values.unknown(&self.function.local(local).ty)
            else {
                continue;
            };
            // old + down · done <= now <= old + up · done
            let steps =
                done.as_ref().and_then(|done| Some((old.plus(down, done)?, old.plus(up, done)?)));
            if let Some((low, high)) = steps {
                self.between(&mut head, &now, [&low, &high]);
            }
            head.places.insert(local, vec![(Vec::new(), Value::Number(now))]);
            let Some(Value::Number(then)) = self.values.unknown(&self.function.local(local).ty)
            else {
                continue;
            };
            let passes = most.max(0);
            let ends = (down.min(0).checked_mul(passes), up.max(0).checked_mul(passes));
            let ends =
                (ends.0.and_then(|by| old.shifted(by)), ends.1.and_then(|by| old.shifted(by)));
            if let (Some(low), Some(high)) = ends {
                self.between(&mut behind, &then, [&low, &high]);
            }
            behind.places.insert(local, vec![(Vec::new(), Value::Number(then))]);
        }
        if !head.knowledge.dead {
            self.pass(body, head);
        }
        behind
    }

    fn between(&mut self, point: &mut Point, form: &Linear, [low, high]: [&Linear; 2]) {
        for (a, b) in [(low, form), (form, high)] {
            if let Some(order) = ordered(CompareOp::Le, a, b) {
                point.knowledge.assume(&order, &self.values.all);
            }
        }
    }

    /// The locals that a pass moves by no more than so much either way, what they hold before, and by how much.
    fn moved(
        &mut self,
        before: &Point,
        head: &Point,
        written: &[Target],
        body: &Block,
    ) -> Vec<(LocalId, Linear, Bounds)> {
        let held = |local: LocalId| match before.places.get(&local)?.as_slice() {
            [(at, Value::Number(form))] if at.is_empty() => Some(form.clone()),
            _ => None,
        };
        let mut locals: Vec<LocalId> = written
            .iter()
            .filter(|it| it.at.is_empty() && self.function.local(it.local).ty.as_int().is_some())
            .map(|it| it.local)
            .collect();
        locals.sort_unstable();
        locals.dedup();
        let counted: Vec<(LocalId, Linear)> =
            locals.into_iter().filter_map(|local| Some((local, held(local)?))).collect();
        if counted.is_empty() {
            return Vec::new();
        }
        let mut trial = head.clone();
        let mut starts = Vec::new();
        for (local, _) in &counted {
            let start = self.values.unknown(&self.function.local(*local).ty);
            let Some(Value::Number(start)) = start else { return Vec::new() };
            trial.places.insert(*local, vec![(Vec::new(), Value::Number(start.clone()))]);
            starts.push(start);
        }
        let (again, left) = self.trial(body, trial);
        let mut found = Vec::new();
        for ((local, old), start) in counted.into_iter().zip(starts) {
            let mut by = (0, 0);
            for point in again.iter().chain(&left) {
                let now = point.places.get(&local).and_then(|held| match held.as_slice() {
                    [(at, Value::Number(form))] if at.is_empty() => Some(form),
                    _ => None,
                });
                let more = now.and_then(|now| now.minus(&start));
                let more = more.map(|it| point.knowledge.closest(&it, &self.values.all));
                let (low, high) = more.unwrap_or((i128::MIN, i128::MAX));
                by = (low.min(by.0), high.max(by.1));
            }
            if by.0.checked_abs().is_some_and(|by| by < FAST) && by.1 < FAST {
                found.push((local, old, by));
            }
        }
        found
    }

    /// The head of a loop that its body ends: bounds that each pass keeps.
    fn guessed(
        &mut self,
        before: &Point,
        empty: &Point,
        written: &[Target],
        body: &Block,
    ) -> Point {
        let mut guesses: Vec<(LocalId, Vec<At>, Bounds, Bounds, Bounds)> = Vec::new();
        for Target { local, .. } in written {
            for (at, value) in before.places.get(local).into_iter().flatten() {
                let Value::Number(form) = value else { continue };
                let fields = at.iter().all(|step| matches!(step, At::Field(_)));
                let same = |it: &(LocalId, Vec<At>, _, _, _)| it.0 == *local && it.1 == *at;
                if fields && !guesses.iter().any(same) {
                    let start = before.knowledge.range(form, &self.values.all);
                    let widest = self.type_bounds(*local, at);
                    guesses.push((*local, at.clone(), start, start, widest));
                }
            }
        }
        loop {
            let (head, symbols) = self.head(empty, &guesses);
            let (again, _) = self.trial(body, head);
            let Some(again) = again else { break };
            let mut kept = true;
            let mut ends = Vec::new();
            for ((root, at, _, guess, widest), _) in guesses.iter_mut().zip(symbols) {
                let held =
                    again.places.get(root).and_then(|it| it.iter().find(|(it, _)| *it == *at));
                let end = match held {
                    Some((_, Value::Number(form))) => {
                        again.knowledge.closest(form, &self.values.all)
                    }
                    _ => *widest,
                };
                let end = (end.0.max(widest.0), end.1.min(widest.1));
                if end.0 < guess.0 {
                    (guess.0, kept) = (widest.0, false);
                }
                if end.1 > guess.1 {
                    (guess.1, kept) = (widest.1, false);
                }
                ends.push(end);
            }
            if kept {
                // The head is reached only before the first pass and after a pass within the guesses.
                for ((_, _, start, guess, _), end) in guesses.iter_mut().zip(ends) {
                    *guess = (start.0.min(end.0), start.1.max(end.1));
                }
                break;
            }
        }
        Rule::Guessed.told(!guesses.is_empty());
        self.head(empty, &guesses).0
    }

    fn head(
        &mut self,
        empty: &Point,
        guesses: &[(LocalId, Vec<At>, Bounds, Bounds, Bounds)],
    ) -> (Point, Vec<Symbol>) {
        let mut head = empty.clone();
        let mut symbols = Vec::new();
        for (root, at, _, guess, _) in guesses {
            let symbol = self.values.fresh(*guess);
            let held = head.places.entry(*root).or_default();
            held.retain(|(it, _)| it != at);
            held.push((at.clone(), Value::Number(Linear::symbol(symbol))));
            symbols.push(symbol);
        }
        (head, symbols)
    }

    /// The bounds that the word at some fields of a local has by its type.
    fn type_bounds(&mut self, root: LocalId, at: &[At]) -> Bounds {
        let mut ty = Some(self.function.local(root).ty.clone());
        for step in at {
            let At::Field(field) = step else { continue };
            let step = Step::Field(*field);
            ty = ty.and_then(|ty| step_type(self.values.module, &ty, &step));
        }
        let unknown = ty.and_then(|ty| self.values.unknown(&ty));
        match unknown {
            Some(Value::Number(form)) => Point::default().knowledge.range(&form, &self.values.all),
            _ => (-super::linear::FURTHEST, super::linear::FURTHEST),
        }
    }
}
