//! Proves that a `while` loop ends, and finds two numbers that bound its passes.
//!
//! The condition compares two integers, `low < high`. In every pass, on every path, `low` increases or `high`
//! decreases, and neither ever moves the other way. Either may be part of a compared expression, such as `i` of `i +
//! 2 < n`. The number that moves is a place; the other is not written in the loop. Then the loop has at most as many
//! passes as there are integers between the two before the first pass. A loop with statements before its condition is
//! followed from one condition to the next, and has one pass more.
//!
//! Invariant: if in doubt, there is no proof. Known are sums, differences, halves, remainders, midpoints and names
//! for these in the same pass. Integer overflow is a fault, so no value wraps.

use std::collections::HashMap;

use bessemer_ir::{
    BinaryOp, Block, CompareOp, Expr, ExprKind, Intrinsic, LocalId, Module, Place, Step, Stmt,
    StmtKind,
};

use bessemer_ir::effects::{lent, overlap, reads, same_place, writes, writes_local};
use bessemer_ir::used::Rule;

mod called;
mod compared;
#[cfg(test)]
mod tests;

use compared::{bounds, is_unsigned, place, shown_least};

/// Two numbers whose difference bounds the number of passes.
pub(crate) struct Proof {
    pub low: Expr,
    pub high: Expr,
    /// True if another pass may begin where the two numbers are equal.
    pub inclusive: bool,
}

/// A loop that is left if `condition` is not `truth`.
pub(crate) struct Loop<'a> {
    /// The statements before the condition.
    pub before: &'a [Stmt],
    pub condition: &'a Expr,
    pub truth: bool,
    /// The statements after the condition.
    pub rest: &'a [Stmt],
    /// The statements before the loop, back to the beginning of the function.
    pub lead: &'a [Stmt],
}

/// Reason why there is no proof, as a text for the author.
pub(crate) type Reason = String;

/// Proves that a loop ends, and returns the bound of its passes.
pub(crate) fn proof(
    module: &Module,
    name: impl Fn(&Place) -> String,
    of: &Loop,
) -> Result<Proof, Reason> {
    if of.before.iter().any(continues) {
        return Err("a `continue` comes before its condition".into());
    }
    let mut reason = None;
    for (low, high, inclusive) in bounds(module, of.before, of.condition, of.truth) {
        let least = least_at(module, low, of.lead);
        let mut looked =
            Looked { module, low, high, inclusive, least, name: &name, moving: Vec::new() };
        match looked.shown(of.before, of.condition, of.rest, Path::default()) {
            Ok(()) => {
                Rule::Ends.used();
                return Ok(Proof { low: low.clone(), high: high.clone(), inclusive });
            }
            Err(why) => reason = reason.or(Some(why)),
        }
    }
    Err(reason.unwrap_or_else(no_integers))
}

/// Proves that a loop ends, by following it from one condition to the next. Its number of passes depends on the first
/// pass, of which nothing is known.
pub(crate) fn turned(
    module: &Module,
    name: impl Fn(&Place) -> String,
    of: &Loop,
) -> Result<(), Reason> {
    if of.before.iter().chain(of.rest).any(continues) {
        return Err("a `continue` skips its condition".into());
    }
    let turn: Vec<Stmt> = of.rest.iter().chain(of.before).cloned().collect();
    let mut reason = None;
    for (low, high, inclusive) in bounds(module, of.before, of.condition, of.truth) {
        let mut looked =
            Looked { module, low, high, inclusive, least: None, name: &name, moving: Vec::new() };
        match looked.shown(&[], of.condition, &turn, Path::default()) {
            Ok(()) => return Ok(()),
            Err(why) => reason = reason.or(Some(why)),
        }
    }
    Err(reason.unwrap_or_else(no_integers))
}

/// Proves that a loop ends which removes an element of a list in every pass, and stops at an empty list.
pub(crate) fn popped(
    module: &Module,
    name: impl Fn(&Place) -> String,
    length: &Expr,
    body: &[Stmt],
) -> Result<Proof, Reason> {
    let low = Expr::literal_like(0, length);
    let (inclusive, least, moving) = (false, None, vec![1]);
    let looked = Looked { module, low: &low, high: length, inclusive, least, name: &name, moving };
    if place(length).is_none() {
        return Err("the list changes in every pass".into());
    }
    let path = Path { moved: true, written: [false, true], ..Path::default() };
    looked.block(body, path, false)?;
    Ok(Proof { low: low.clone(), high: length.clone(), inclusive })
}

fn no_integers() -> Reason {
    "its condition compares no integers with `<`".into()
}

/// Returns true if a statement continues the loop that is being proved.
fn continues(stmt: &Stmt) -> bool {
    stmt.any_branch(&|kind| matches!(kind, StmtKind::Continue))
}

/// Returns a lower bound of a number at the beginning of a loop, from the last write before it.
fn least_at(module: &Module, number: &Expr, lead: &[Stmt]) -> Option<i128> {
    let ours = place(number)?;
    let touches = |stmt: &&Stmt| reads(number, &writes([*stmt]));
    let value = match &lead.iter().rev().find(touches)?.kind {
        StmtKind::Let { local, value } if ours.steps.is_empty() && ours.root == *local => {
            value.as_ref()?
        }
        StmtKind::Assign { place, value } if same_place(place, ours) => value,
        _ => return None,
    };
    shown_least(module, value)
}

/// A bound of a value relative to a number: at least equal to it, or beyond it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Far {
    AsFar,
    Further,
}

/// Facts that hold on a path through the body.
#[derive(Clone, Default)]
struct Path {
    /// True if `low` has increased or `high` has decreased.
    moved: bool,
    /// True for `low` or `high` if it was written.
    written: [bool; 2],
    /// True if a condition on the path implies that `high` is more than 0.
    above: bool,
    /// Bound of each local relative to the present `low` (upwards) and `high` (downwards).
    locals: HashMap<LocalId, [Option<Far>; 2]>,
}

impl Path {
    /// Removes the facts about locals that are written.
    fn forget(&mut self, writes: &[Place]) {
        writes.iter().for_each(|written| {
            self.locals.remove(&written.root);
        });
    }

    /// Returns the facts that hold on both of two paths that meet.
    fn join(self, other: Option<Path>) -> Path {
        let Some(other) = other else { return self };
        let locals = self.locals.into_iter().filter_map(|(local, sides)| {
            let theirs = other.locals.get(&local)?;
            Some((local, [sides[0].min(theirs[0]), sides[1].min(theirs[1])]))
        });
        let either = |side: usize| self.written[side] || other.written[side];
        Path {
            moved: self.moved && other.moved,
            written: [either(0), either(1)],
            above: self.above && other.above,
            locals: locals.collect(),
        }
    }
}

/// The comparison that a proof follows.
struct Looked<'a> {
    module: &'a Module,
    low: &'a Expr,
    high: &'a Expr,
    inclusive: bool,
    /// Lower bound of `low`, before the loop and in each pass.
    least: Option<i128>,
    name: &'a dyn Fn(&Place) -> String,
    /// The compared numbers that the loop changes.
    moving: Vec<Side>,
}

/// Index of a compared number: 0 is `low`, which increases; 1 is `high`, which decreases.
type Side = usize;

const WAYS: [&str; 2] = ["go up", "go down"];

impl Looked<'_> {
    fn shown(
        &mut self,
        before: &[Stmt],
        condition: &Expr,
        body: &[Stmt],
        path: Path,
    ) -> Result<(), Reason> {
        // What the condition itself writes, it writes before or behind the comparison.
        self.lent(condition, &mut Path::default())?;
        let written = writes(before.iter().chain(body));
        self.moving = (0..2).filter(|side| reads(self.side(*side), &written)).collect();
        if self.moving.is_empty() {
            let value = [self.low, self.high].into_iter().find_map(place);
            return Err(match value {
                Some(place) => format!("nothing in it changes `{}`", (self.name)(place)),
                None => "nothing in it changes what its condition compares".into(),
            });
        }
        let led = writes(before);
        let anew = |side: &Side| self.place(*side).is_none() || reads(self.side(*side), &led);
        if self.moving.iter().any(anew) {
            return Err("its condition compares a value that each pass computes again".into());
        }
        let path = self.named(before, path);
        let end = self.block(body, path, false)?;
        if end.is_some_and(|end| !end.moved) {
            return Err(self.stuck(""));
        }
        Ok(())
    }

    /// Adds the facts about names that statements declare before the condition. These statements write neither
    /// number.
    fn named(&self, before: &[Stmt], mut path: Path) -> Path {
        for (at, stmt) in before.iter().enumerate() {
            if let StmtKind::Let { local, value: Some(value) } = &stmt.kind
                && !before[at + 1..].iter().any(|later| writes_local(later, *local))
            {
                let known = [self.against(0, value, &path), self.against(1, value, &path)];
                path.locals.insert(*local, known);
            }
        }
        path
    }

    fn side(&self, side: Side) -> &Expr {
        [self.low, self.high][side]
    }

    /// Returns the place of a side, if it is one; a constant never moves.
    fn place(&self, side: Side) -> Option<&Place> {
        place(self.side(side))
    }

    fn stuck(&self, more: &str) -> Reason {
        let sides = self.moving.iter().filter_map(|&side| {
            let place = self.place(side)?;
            Some(format!("`{}` does not {}", (self.name)(place), WAYS[side]))
        });
        format!("{} in every pass{more}", sides.collect::<Vec<_>>().join(", nor "))
    }

    /// Follows a block and returns the facts at its end; none if no path reaches it. `inner`: inside a loop of the
    /// body.
    fn block(&self, stmts: &[Stmt], path: Path, inner: bool) -> Result<Option<Path>, Reason> {
        let mut path = Some(path);
        for stmt in stmts {
            let Some(now) = path else { return Ok(None) };
            path = self.stmt(&stmt.kind, now, inner)?;
        }
        Ok(path)
    }

    fn stmt(&self, kind: &StmtKind, mut path: Path, inner: bool) -> Result<Option<Path>, Reason> {
        match kind {
            StmtKind::Let { local, value } => {
                if let Some(value) = value {
                    self.lent(value, &mut path)?;
                    let known = [self.against(0, value, &path), self.against(1, value, &path)];
                    path.locals.insert(*local, known);
                }
            }
            StmtKind::Assign { place, value } => {
                self.lent(value, &mut path)?;
                self.assign(place, value, &mut path, inner)?;
            }
            StmtKind::Expr(value) => self.lent(value, &mut path)?,
            StmtKind::If { condition, then, otherwise } => {
                self.lent(condition, &mut path)?;
                let above = self.says_above(condition);
                let held = Path { above: path.above || above, ..path.clone() };
                let then = self.block(&then.0, held, inner)?;
                if above && self.is_above(&path) {
                    return Ok(then);
                }
                let otherwise = self.block(&otherwise.0, path, inner)?;
                return Ok(meet(then, otherwise));
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.lent(scrutinee, &mut path)?;
                let mut end = None;
                for Block(body) in arms.iter().map(|arm| &arm.body).chain(otherwise) {
                    end = meet(end, self.block(body, path.clone(), inner)?);
                }
                return Ok(end);
            }
            StmtKind::For { from, to, body, .. } => {
                self.lent(from, &mut path)?;
                self.lent(to, &mut path)?;
                // It may run any number of times, so that only what it does wrong counts.
                let touched = writes(&body.0);
                path.forget(&touched);
                for side in 0..2 {
                    if reads(self.side(side), &touched) {
                        path.written[side] = true;
                        path.above = false;
                        path.locals.values_mut().for_each(|known| known[side] = None);
                    }
                }
                self.block(&body.0, path.clone(), true)?;
            }
            StmtKind::Check { condition, .. } => self.lent(condition, &mut path)?,
            StmtKind::Continue if !inner && !path.moved => {
                return Err(self.stuck(": a `continue` comes before"));
            }
            StmtKind::Return(_) | StmtKind::Break | StmtKind::Continue => return Ok(None),
        }
        Ok(Some(path))
    }

    /// Returns true if `high` is known to be more than 0, since it is more than `low` in the first pass.
    fn is_above(&self, path: &Path) -> bool {
        let first = !self.inclusive || self.least(self.low) >= Some(1);
        let from_zero = is_unsigned(self.high) || self.least(self.low) >= Some(0);
        path.above || (first && from_zero && !path.written[1])
    }

    /// Returns true if a condition implies that `high` is more than 0.
    fn says_above(&self, condition: &Expr) -> bool {
        matches!(&condition.kind, ExprKind::Compare(CompareOp::Gt, a, b)
            if self.is(1, a) && is_unsigned(a) && matches!(b.kind, ExprKind::Literal(0)))
    }

    fn assign(&self, to: &Place, value: &Expr, path: &mut Path, inner: bool) -> Result<(), Reason> {
        // An index may be computed by a function.
        for step in &to.steps {
            match step {
                Step::Field(_) => {}
                Step::Index(index) | Step::From(index) => self.lent(index, path)?,
                Step::Element(row, column) => {
                    self.lent(row, path)?;
                    self.lent(column, path)?;
                }
            }
        }
        for side in 0..2 {
            let Some(ours) = self.place(side).filter(|ours| overlap(ours, to)) else { continue };
            let part = part(ours, to, value);
            let Some(far) = part.and_then(|value| self.against(side, value, path)) else {
                let name = (self.name)(ours);
                return Err(format!("`{name}` may {}", WAYS[1 - side]));
            };
            // In a loop of the body's own a step may be none.
            path.moved |= far == Far::Further && !inner;
            path.written[side] = true;
            path.above &= side == 0;
            path.locals.values_mut().for_each(|known| known[side] = None);
        }
        path.locals.remove(&to.root);
        Ok(())
    }

    /// Forgets the places that a call may write; an error if it may write one of the two numbers.
    fn lent(&self, expr: &Expr, path: &mut Path) -> Result<(), Reason> {
        let lent = lent(expr);
        path.forget(&lent);
        let mut sides = (0..2).filter(|side| reads(self.side(*side), &lent));
        let side = sides.next();
        if let (Some(side), None) = (side, sides.next())
            && let Some(moved) = self.by_call(side, expr, path)
        {
            path.moved |= moved;
            path.written[side] = true;
            path.above &= side == 0;
            path.locals.values_mut().for_each(|known| known[side] = None);
            return Ok(());
        }
        match side {
            Some(side) => Err(match self.place(side) {
                Some(place) => {
                    format!("`{}` is passed to a function by `&mut`", (self.name)(place))
                }
                None => "the value that it compares with is passed to a function by `&mut`".into(),
            }),
            None => Ok(()),
        }
    }

    /// Returns the bound of a value relative to the present `low` (upwards) or `high` (downwards).
    fn against(&self, side: Side, value: &Expr, path: &Path) -> Option<Far> {
        if self.is(side, value) {
            return Some(Far::AsFar);
        }
        if let ExprKind::Load(place) = &value.kind
            && place.steps.is_empty()
            && let Some(known) = path.locals.get(&place.root)
        {
            return known[side];
        }
        if let Some(far) = self.middle(side, value, path) {
            return Some(far);
        }
        match &value.kind {
            ExprKind::Binary(op, a, b) => self.computed(side, *op, (a, b), path),
            ExprKind::Intrinsic(Intrinsic::Max, parts) if side == 0 => {
                parts.iter().filter_map(|part| self.against(side, part, path)).max()
            }
            ExprKind::Intrinsic(Intrinsic::Min, parts) if side == 1 => {
                parts.iter().filter_map(|part| self.against(side, part, path)).max()
            }
            ExprKind::Intrinsic(Intrinsic::SaturatingAdd, parts) if side == 0 => {
                let on = self.least(&parts[1]) >= Some(0);
                self.against(side, &parts[0], path).filter(|_| on).map(|_| Far::AsFar)
            }
            ExprKind::Intrinsic(Intrinsic::SaturatingSub, parts) if side == 1 => {
                let least = self.least(&parts[1]).filter(|least| *least >= 0)?;
                let above = least >= 1 && self.is(1, &parts[0]) && self.is_above(path);
                let far = self.against(side, &parts[0], path)?;
                Some(if above { Far::Further } else { far.min(Far::AsFar) })
            }
            // One less than what is above 0.
            ExprKind::Intrinsic(Intrinsic::WrappingSub, parts) if side == 1 => {
                let one = matches!(parts[1].kind, ExprKind::Literal(1));
                (one && self.is(1, &parts[0]) && self.is_above(path)).then_some(Far::Further)
            }
            _ => None,
        }
    }

    fn computed(
        &self,
        side: Side,
        op: BinaryOp,
        (a, b): (&Expr, &Expr),
        path: &Path,
    ) -> Option<Far> {
        // As far as `x`, and by that much further.
        let on = |x: &Expr, by: &Expr| {
            let least = self.least(by).filter(|least| *least >= 0)?;
            let far = self.against(side, x, path)?;
            Some(if least > 0 { Far::Further } else { far })
        };
        // Less than what it is a part of, unless that may be 0: high is more than low at first.
        let part = |x: &Expr, less: bool| {
            let positive = self.is_above(path) && self.is(1, x);
            // A half of what is negative is more.
            let far = self.against(side, x, path).filter(|_| positive || is_unsigned(x))?;
            Some(if less && positive { Far::Further } else { far })
        };
        match (op, side) {
            (BinaryOp::Add, 0) => on(a, b).max(on(b, a)),
            (BinaryOp::Sub, 1) => on(a, b),
            (BinaryOp::Mul, 0) => {
                let positive = self.least >= Some(1);
                // Of nothing, twice is no more.
                let by = |x: &Expr, by| {
                    let least = self.least(by).filter(|least| *least >= 1)?;
                    let far = self.against(side, x, path)?;
                    Some(if positive && least >= 2 { Far::Further } else { far })
                };
                (positive || is_unsigned(a)).then(|| by(a, b).max(by(b, a))).flatten()
            }
            (BinaryOp::Div, 1) if self.least(b) >= Some(1) => part(a, self.least(b) >= Some(2)),
            (BinaryOp::Shr, 1) => part(a, self.least(b) >= Some(1)),
            (BinaryOp::Rem, 1) if is_unsigned(b) => {
                // A remainder is less than the divisor, and no more than the number.
                let below = self.against(side, b, path).map(|_| Far::Further);
                below.max(self.against(side, a, path))
            }
            (BinaryOp::And, 1) if is_unsigned(a) => {
                self.against(side, a, path).max(self.against(side, b, path))
            }
            _ => None,
        }
    }

    /// Recognises midpoints, `(low + high) / 2` and `low + (high - low) / 2`. They are at least `low`, and less than
    /// `high` unless the two are equal.
    fn middle(&self, side: Side, value: &Expr, path: &Path) -> Option<Far> {
        let half = |expr: &Expr| -> Option<Expr> {
            match &expr.kind {
                ExprKind::Binary(BinaryOp::Div, a, b) if self.least(b) == Some(2) => {
                    Some((**a).clone())
                }
                ExprKind::Binary(BinaryOp::Shr, a, b) if self.least(b) == Some(1) => {
                    Some((**a).clone())
                }
                _ => None,
            }
        };
        let between = |op: BinaryOp, first: Side, expr: &Expr| match &expr.kind {
            ExprKind::Binary(found, a, b) => {
                *found == op && self.is(first, a) && self.is(1 - first, b)
            }
            _ => false,
        };
        let sum = half(value).is_some_and(|sum| {
            is_unsigned(&sum)
                && (between(BinaryOp::Add, 0, &sum) || between(BinaryOp::Add, 1, &sum))
        });
        let rest = match &value.kind {
            ExprKind::Binary(BinaryOp::Add, a, b) => {
                let other = if self.is(0, a) { b } else { a };
                (self.is(0, a) || self.is(0, b))
                    && half(other).is_some_and(|rest| between(BinaryOp::Sub, 1, &rest))
            }
            _ => false,
        };
        if !(sum || rest) || path.written != [false, false] {
            return None;
        }
        Some(if side == 1 && !self.inclusive { Far::Further } else { Far::AsFar })
    }

    /// Returns true if an expression is the number of this side.
    fn is(&self, side: Side, expr: &Expr) -> bool {
        match (&self.side(side).kind, &expr.kind) {
            (ExprKind::Load(a), ExprKind::Load(b)) => same_place(a, b),
            (ExprKind::Const(a), ExprKind::Const(b)) => a == b,
            (ExprKind::Literal(a), ExprKind::Literal(b)) => a == b,
            _ => false,
        }
    }

    /// Returns a lower bound of an integer, if its expression implies one.
    fn least(&self, expr: &Expr) -> Option<i128> {
        shown_least(self.module, expr)
    }
}

/// Returns the part of `value` that an assignment to `to` writes to `ours`, if it can be seen.
fn part<'v>(ours: &Place, to: &Place, value: &'v Expr) -> Option<&'v Expr> {
    let (outer, inner) = ours.steps.split_at_checked(to.steps.len())?;
    if !same_place(&Place { steps: outer.to_vec(), ..ours.clone() }, to) {
        return None;
    }
    inner.iter().try_fold(value, |value, step| match (&value.kind, step) {
        (ExprKind::Struct(parts), Step::Field(at)) => parts.get(*at as usize),
        _ => None,
    })
}

fn meet(a: Option<Path>, b: Option<Path>) -> Option<Path> {
    match a {
        Some(a) => Some(a.join(b)),
        None => b,
    }
}
