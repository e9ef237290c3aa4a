//! Four or two passes of an outer loop at once, so that an element which each of them changes stays in a register
//! between them. Two or four such elements follow each other, so that a state which moves on with each, as `x2 = x1`, is
//! renamed and not moved.
//!
//! ```text
//! for i in 0..8 {                       for tile in 0..2 {
//!     for j in 0..64 {                      for part in 0..32 { for j in 0..2 {
//!         block[j] = f(state[i], …);            for i in 0..4 { block[2 * part + j] = f(state[4 * tile + i], …); }
//!     }                                     } }
//! }                                     }
//! ```
//!
//! Invariant: each pair of accesses to one memory, one of them a write, is at the same `i` or at the same `j`; so the two
//! keep their order. There are as many passes as registers hold what each of them keeps.

use bessemer_ir::effects::{mentions, overlap, same_place};
use bessemer_ir::visit::{Access, VisitMut as _, Walk};
use bessemer_ir::{BinaryOp, Block, Expr, ExprKind, LocalId, Mode, Place, Step, Stmt, StmtKind};

use super::{Counted, Put, Tiles, counted, times, written_out};

/// Numbers of passes at once, with the comment of the loop.
const AT_ONCE: [(u64, &str); 2] = [
    (4, "Four passes at once: what one leaves to the next stays in a register."),
    (2, "Two passes at once: what one leaves to the next stays in a register."),
];
/// Number of copies of the body: passes at once, of each element that follows.
const COPIES: u64 = 8;
/// Number of registers of each element that follows.
const OWN: u64 = 2;
/// Largest number of values that the passes keep in registers.
const REGISTERS: u64 = 28;
/// Fewest passes of the inner loop.
const MANY: u64 = 16;
/// Largest number of expressions in the body, with those of its callees.
const SMALL: usize = 64;

impl Tiles<'_> {
    /// Returns a loop with several passes at once, and its further comments, if they share an element.
    pub(super) fn carried(&mut self, stmt: &Stmt) -> Option<(StmtKind, Vec<String>)> {
        let outer = counted(stmt)?;
        let [inside] = &outer.body.0[..] else { return None };
        let inner = counted(inside)?;
        let passes = self.number(outer.to).filter(|passes| *passes > 0)?;
        let many = self.number(inner.to).is_none_or(|passes| passes >= MANY);
        let still = !mentions(inner.to, outer.variable) && inner.to.is_literal();
        if !many || !still || !self.is_plain(inner.body) || !carries(inner.body, &outer, &inner) {
            return None;
        }
        let kept = self.kept(inner.body, &outer, &inner);
        let fits = |count: &u64| passes % count == 0 && count * kept <= REGISTERS;
        let (count, said) = AT_ONCE.into_iter().find(|(count, _)| fits(count))?;
        let i = self.local(outer.variable, outer.to.ty.clone());
        let at = Expr::local(i, &outer.to.ty, stmt.span);
        let tile = (passes > count).then(|| self.named("tile", outer.to, stmt.span));
        let now = match tile {
            Some(tile) => {
                let start = times(Expr::local(tile, &outer.to.ty, stmt.span), count);
                Expr::binary(BinaryOp::Add, start, at)
            }
            None => at,
        };
        let mut body = inner.body.clone();
        Put { variable: outer.variable, now, sum: None }.block(&mut body);
        let some = written_out(i, Expr::literal_like(count, outer.to), body, count, stmt.span);
        let following = COPIES / count;
        let has_room = count * kept + OWN * following <= REGISTERS;
        let kind = self.parts(&inner, some, &[following][..usize::from(has_room)]);
        let said = vec![said.to_owned()];
        let Some(tile) = tile else { return Some((kind, [&inside.comments[..], &said].concat())) };
        let body = Block(vec![Stmt { kind, ..inside.clone() }]);
        Some((StmtKind::for_below(tile, Expr::literal_like(passes / count, outer.to), body), said))
    }

    /// Returns the number of values that each pass of the inner loop reads again. Those that callees read by reference
    /// count, too.
    fn kept(&self, body: &Block, outer: &Counted<'_>, inner: &Counted<'_>) -> u64 {
        let mut values = distinct(body, |place| {
            at(place, outer.variable).is_some() && !mentions(place, inner.variable)
        });
        body.each_expr(|expr| {
            if let ExprKind::Call(id, _) = &expr.kind {
                let callee = &self.module.functions[id.index()];
                let by_reference = |place: &Place| {
                    place.root.index() < callee.params as usize
                        && callee.local(place.root).mode != Mode::Value
                };
                values += distinct(&callee.body, by_reference);
            }
        });
        values
    }

    /// Returns true for short statements in sequence whose calls neither fault nor reach the firmware.
    fn is_plain(&self, body: &Block) -> bool {
        let in_sequence = |stmt: &Stmt| {
            matches!(stmt.kind, StmtKind::Let { .. } | StmtKind::Assign { .. } | StmtKind::Expr(_))
        };
        let (mut count, mut plain) = (0, body.0.iter().all(in_sequence));
        body.each_expr(|expr| {
            count += 1;
            if let ExprKind::Call(id, _) = &expr.kind {
                let callee = self.callees.get(id.index());
                plain &= callee.is_some_and(|callee| !callee.fallible && !callee.outside);
                self.module.functions[id.index()].body.each_expr(|_| count += 1);
            }
            plain &= !matches!(expr.kind, ExprKind::Routine(..));
        });
        plain && count <= SMALL
    }
}

/// Returns the number of different words of these places that a block reads.
fn distinct(block: &Block, is_one: impl Fn(&Place) -> bool) -> u64 {
    let mut seen: Vec<Place> = Vec::new();
    block.each_place(|place, access| {
        let new = !seen.iter().any(|known| same_place(known, place));
        if access == Access::Read && place.ty.is_word() && is_one(place) && new {
            seen.push(place.clone());
        }
    });
    seen.len() as u64
}

/// Returns true if each pass of the outer loop reads and writes the elements of the inner one. No other access may
/// change its order.
fn carries(body: &Block, outer: &Counted<'_>, inner: &Counted<'_>) -> bool {
    let mut own = Vec::new();
    body.each_stmt(|stmt| {
        if let StmtKind::Let { local, .. } = &stmt.kind {
            own.push(*local);
        }
    });
    let mut all: Vec<(Place, Access)> = Vec::new();
    body.each_place(|place, access| {
        if !own.contains(&place.root) {
            all.push((place.clone(), access));
        }
    });
    let mut found = false;
    for (written, access) in &all {
        if *access == Access::Read {
            continue;
        }
        for (other, access) in all.iter().filter(|(other, _)| overlap(written, other)) {
            let both = |counter| {
                let position = at(written, counter);
                position.is_some() && position == at(other, counter)
            };
            if !both(outer.variable) && !both(inner.variable) {
                return false;
            }
            let is_float = written.ty.as_float().is_some();
            found |= is_float && *access == Access::Read && at(written, outer.variable).is_none();
        }
    }
    found
}

/// Returns the position of the step that is this counter. Behind the start of a slice, equal counters may be different
/// elements: `x[1..][j]` is `x[2..][j]` of the pass before.
fn at(place: &Place, counter: LocalId) -> Option<usize> {
    let is = |index: &Expr| {
        matches!(&index.kind, ExprKind::Load(place)
            if place.root == counter && place.steps.is_empty())
    };
    let step = |step: &Step| matches!(step, Step::Index(index) if is(index));
    let position = place.steps.iter().position(step)?;
    let whole = !place.steps[..position].iter().any(|step| matches!(step, Step::From(_)));
    whole.then_some(position)
}
