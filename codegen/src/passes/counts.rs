//! Locals that a loop only counts up, and how far they come: so that `count += 1` in a loop over an array cannot overflow.
//!
//! Invariant: what is given holds of every execution that did not fault. A local counts if all that the body writes
//! to it adds a literal; each pass adds at most the sum along one path, a loop within it that times its passes.

use bessemer_ir::{BinaryOp, Block, Expr, ExprKind, LocalId, Place, Stmt, StmtKind};

use super::facts::Facts;
use super::places::{load, overlap, whole, writes};
use super::ranges::Interval;

/// A `for` that is about to be entered.
pub(super) struct Loop<'a> {
    pub(super) variable: LocalId,
    /// The ranges of its bounds.
    pub(super) bounds: (Interval, Interval),
    pub(super) inclusive: bool,
    /// Whether its body ends it, so that nothing counts its passes.
    pub(super) ended: bool,
    /// What the body writes.
    pub(super) written: &'a [Place],
    pub(super) body: &'a Block,
}

impl Loop<'_> {
    /// Makes `facts` those at the head of the loop, and gives those behind it.
    pub(super) fn enter<'m>(&self, facts: &mut Facts<'m>) -> Facts<'m> {
        let counted: Vec<(Expr, Interval)> = self
            .written
            .iter()
            .filter(|place| !self.ended && place.steps.is_empty() && place.ty.as_int().is_some())
            .map(|place| load(place.root, &place.ty, place.span))
            .map(|local| (local.clone(), facts.range(&local)))
            .filter(|(local, before)| facts.all(&local.ty) != Some(*before))
            .collect();
        facts.enter_loop(self.variable, self.written);
        let mut behind = facts.clone();
        let passes = passes(self.bounds, self.inclusive);
        for (local, before) in counted {
            let ExprKind::Load(place) = &local.kind else { continue };
            let Some(more) = increase(&self.body.0, place.root, facts) else { continue };
            let up_to = |passes: i128| Interval {
                low: before.low,
                high: before.high.saturating_add(more.saturating_mul(passes)),
            };
            facts.bound(&local, up_to((passes - 1).max(0)));
            behind.bound(&local, up_to(passes));
        }
        behind
    }
}

/// How many passes there are at most.
fn passes((from, to): (Interval, Interval), inclusive: bool) -> i128 {
    to.high.saturating_sub(from.low).saturating_add(i128::from(inclusive)).max(0)
}

/// What statements add to a local at most, if they do nothing else to it.
fn increase(stmts: &[Stmt], local: LocalId, facts: &Facts) -> Option<i128> {
    let of_block = |block: &Block| increase(&block.0, local, facts);
    let mut sum = 0i128;
    for stmt in stmts {
        let added = match &stmt.kind {
            StmtKind::Assign { place, value } if place.root == local => added(place, value)?,
            StmtKind::If { condition, then, otherwise } if is_left(condition, local) => {
                of_block(then)?.max(of_block(otherwise)?)
            }
            StmtKind::Match { scrutinee, arms, otherwise } if is_left(scrutinee, local) => {
                let mut most = otherwise.as_ref().map_or(Some(0), of_block)?;
                for arm in arms {
                    most = most.max(of_block(&arm.body)?);
                }
                most
            }
            StmtKind::For { from, to, inclusive, ended: false, body, .. }
                if is_left(from, local) && is_left(to, local) =>
            {
                let passes = passes((facts.range(from), facts.range(to)), *inclusive);
                of_block(body)?.saturating_mul(passes)
            }
            _ if writes([stmt]).iter().any(|place| overlap(place, &whole(local))) => return None,
            _ => 0,
        };
        sum = sum.saturating_add(added);
    }
    Some(sum)
}

/// Whether the calls in an expression leave a local as it is.
fn is_left(expr: &Expr, local: LocalId) -> bool {
    !super::places::lent(expr).iter().any(|place| place.root == local)
}

/// `k` of `local = local + k`.
fn added(place: &Place, value: &Expr) -> Option<i128> {
    let ExprKind::Binary(BinaryOp::Add, a, b) = &value.kind else { return None };
    let (ExprKind::Load(from), ExprKind::Literal(word)) = (&a.kind, &b.kind) else { return None };
    let same = place.steps.is_empty() && from.steps.is_empty() && from.root == place.root;
    let added = b.ty.as_int()?.from_word(*word);
    (same && added >= 0).then_some(added)
}
