//! Walks along statements: the facts at the end of a pass, from the facts at its beginning.
//!
//! Invariant: each execution that starts in the state and does not fault satisfies the returned facts at its end; and
//! each value assigned to a local on the way is in the interval reported for it. No statement is rewritten, and no
//! check is reported. Conditions with calls are not assumed, since a second call may return another value.

use bessemer_ir::{Block, Expr, ExprKind, Function, LocalId, Module, Place, Stmt, StmtKind};

use super::domain::Interval;
use super::known::{Known, Parts, the_whole};
use super::loops::Loop;
use super::state::{State, joined};
use bessemer_ir::effects::{calls, lent, whole, writes};

/// Returns the state at the beginning of the next pass, after the end of the body or a `continue`; none if no path
/// leads there.
pub(super) fn again<'m>(body: &Block, head: State<'m>) -> Option<State<'m>> {
    let mut walk = Walk::default();
    let end = walk.block(body, head);
    joined(walk.continued.into_iter().chain(end))
}

/// Returns the state behind a loop that only its body ends, joined from each `break`; none if no path leads to one.
pub(super) fn left<'m>(body: &Block, head: State<'m>) -> Option<State<'m>> {
    let mut walk = Walk::default();
    walk.block(body, head);
    joined(walk.broken)
}

/// Returns the states at the beginning of the next pass and at each `break`.
pub(super) fn passed<'m>(body: &Block, head: State<'m>) -> (Option<State<'m>>, Vec<State<'m>>) {
    let mut walk = Walk::default();
    let end = walk.block(body, head);
    (joined(walk.continued.into_iter().chain(end)), walk.broken)
}

/// Returns the interval of each local, from its declaration and whole assignments; none if it is unknown or the local
/// has no value.
pub(crate) fn held(module: &Module, function: &Function) -> Vec<Option<Interval>> {
    let held = Some(vec![Held::Nothing; function.locals.len()]);
    let mut walk = Walk { held, ..Walk::default() };
    walk.block(&function.body, State::new(module));
    let shown = |held| match held {
        Held::Within(interval) => Some(interval),
        Held::Nothing | Held::Anything => None,
    };
    walk.held.into_iter().flatten().map(shown).collect()
}

/// Returns each place that the statements of a body write, with the facts about its new value. A place that a call
/// borrows has none.
pub(super) fn written_in(body: &Block, head: State) -> Vec<(Place, Parts)> {
    let mut walk = Walk { writes: Some(Vec::new()), ..Walk::default() };
    walk.block(body, head);
    walk.writes.unwrap_or_default()
}

/// Values assigned to a local so far.
#[derive(Clone, Copy)]
enum Held {
    Nothing,
    Within(Interval),
    Anything,
}

#[derive(Default)]
struct Walk<'m> {
    /// States at each `continue`.
    continued: Vec<State<'m>>,
    /// States at each `break`.
    broken: Vec<State<'m>>,
    /// Values assigned to each local, if requested: then the bodies of loops are analysed, too.
    held: Option<Vec<Held>>,
    /// Written places with the facts about each value, if requested; then the bodies of loops are analysed, too.
    writes: Option<Vec<(Place, Parts)>>,
}

impl<'m> Walk<'m> {
    /// Returns the state at the end; none if no path leads there.
    fn block(&mut self, block: &Block, state: State<'m>) -> Option<State<'m>> {
        block.0.iter().try_fold(state, |state, stmt| self.stmt(stmt, state))
    }

    /// Records a value assigned to a local.
    fn given(&mut self, local: LocalId, value: Option<Known>) {
        let Some(held) = self.held.as_mut().and_then(|held| held.get_mut(local.index())) else {
            return;
        };
        *held = match (*held, value) {
            (Held::Nothing, Some(Known::Within(now))) => Held::Within(now),
            (Held::Within(before), Some(Known::Within(now))) => Held::Within(before.join(now)),
            _ => Held::Anything,
        };
    }

    /// Records a value written to a place.
    fn wrote(&mut self, place: &Place, value: &Parts) {
        self.writes.iter_mut().for_each(|all| all.push((place.clone(), value.clone())));
    }

    /// Records that places may get any value.
    fn lent(&mut self, places: &[Place]) {
        places.iter().for_each(|place| self.wrote(place, &Vec::new()));
    }

    /// Returns the facts about an expression's value; none if it has a call. Drops the facts about places that it
    /// borrows mutably.
    fn evaluated(&mut self, expr: &Expr, state: &mut State) -> Parts {
        let (value, written) =
            (if calls(expr) { Vec::new() } else { state.parts(expr) }, lent(expr));
        state.forget(&written);
        self.lent(&written);
        value
    }

    fn stmt(&mut self, stmt: &Stmt, mut state: State<'m>) -> Option<State<'m>> {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                let given = value.as_ref().map(|value| self.evaluated(value, &mut state));
                if let Some(given) = &given {
                    self.given(*local, the_whole(given));
                    self.wrote(&whole(*local), given);
                }
                state.assign(&whole(*local), given.unwrap_or_default());
                if let Some(value) = value.as_ref().filter(|value| !calls(value)) {
                    state.define(*local, value);
                }
            }
            StmtKind::Assign { place, value } => {
                let known = self.evaluated(value, &mut state);
                if place.steps.is_empty() {
                    self.given(place.root, the_whole(&known));
                }
                let written = lent(place);
                state.forget(&written);
                self.lent(&written);
                self.wrote(place, &known);
                state.store(place, value, known);
            }
            StmtKind::Expr(value) => {
                self.evaluated(value, &mut state);
            }
            StmtKind::Check { condition, .. } => {
                self.evaluated(condition, &mut state);
                // Whatever reaches it faults, and the invariant speaks of what does not: so nothing comes behind it. It is
                // a `panic!` or `unreachable!`; taking it for any condition would join a path that nobody takes.
                if condition.kind == ExprKind::Literal(0) {
                    return None;
                }
                assume(&mut state, condition, true);
            }
            StmtKind::If { condition, then, otherwise } => {
                self.evaluated(condition, &mut state);
                let mut other = state.clone();
                assume(&mut state, condition, true);
                assume(&mut other, condition, false);
                let ends = [self.block(then, state), self.block(otherwise, other)];
                return joined(ends.into_iter().flatten());
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.evaluated(scrutinee, &mut state);
                let asks = !calls(scrutinee);
                let mut ends = Vec::new();
                for (index, arm) in arms.iter().enumerate() {
                    let mut state = state.clone();
                    if asks {
                        let rest = otherwise.is_none() && index + 1 == arms.len();
                        state.select(scrutinee, &arm.values, rest);
                    }
                    ends.push(self.block(&arm.body, state));
                }
                if let Some(otherwise) = otherwise {
                    if asks {
                        let values = arms.iter().flat_map(|arm| arm.values.iter().copied());
                        state.exclude(scrutinee, values.collect());
                    }
                    ends.push(self.block(otherwise, state));
                }
                return joined(ends.into_iter().flatten());
            }
            StmtKind::For { variable, from, to, inclusive, ended, body, .. } => {
                self.evaluated(from, &mut state);
                self.evaluated(to, &mut state);
                let (counter, written) =
                    (Expr::local(*variable, &from.ty, stmt.span), writes(&body.0));
                let (inclusive, ended) = (*inclusive, *ended || calls(from) || calls(to));
                let (counter, written) = (&counter, &written[..]);
                let inner = Loop { counter, from, to, inclusive, ended, written, body };
                if self.held.is_none() && self.writes.is_none() {
                    return Some(inner.behind(&state));
                }
                self.lent(&[whole(*variable)]);
                let behind = inner.enter(&mut state);
                let outer = (std::mem::take(&mut self.continued), std::mem::take(&mut self.broken));
                self.block(body, state);
                (self.continued, self.broken) = outer;
                return Some(behind);
            }
            StmtKind::Continue => {
                self.continued.push(state);
                return None;
            }
            StmtKind::Break => {
                self.broken.push(state);
                return None;
            }
            StmtKind::Return(_) => return None,
        }
        Some(state)
    }
}

fn assume(state: &mut State, condition: &Expr, truth: bool) {
    if !calls(condition) {
        state.assume(condition, truth);
    }
}
