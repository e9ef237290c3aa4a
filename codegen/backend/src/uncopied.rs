//! Copies that the C avoids. A local that begins as a copy of a place, is never written, and is read only while the
//! place is unchanged, becomes an alias of the place. A constant aggregate that is only read becomes a table.
//!
//! Invariant: from the declaration to the last statement that mentions the local, nothing writes the copied place,
//! and the place's memory remains alive. Must not know: the C text of an alias.

use std::collections::BTreeMap;

use bessemer_ir::visit::{Visit, Walk, walk_block, walk_stmt};
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Function, LocalId, Mode, Module, Place, Step, Stmt, StmtKind,
    Type,
};

use bessemer_ir::effects::{mentions, overlap, writes, writes_local};

/// Largest number of words for which a copy is as cheap as an alias.
const WORDS: usize = 4;

/// Returns the locals that become aliases, with their places; `flat`: matrices are arrays of scalars in the C.
pub(crate) fn uncopied(
    module: &Module,
    function: &Function,
    flat: bool,
) -> BTreeMap<LocalId, Place> {
    let mut names = Names { module, function, flat, counters: Vec::new(), found: BTreeMap::new() };
    names.block(&function.body);
    names.found
}

/// Largest number of words in a table; the code that builds a larger one is shorter.
const TABLE: usize = 64;

/// Number of statements from which on a table is copied instead.
const STORED: usize = 4;

/// Largest number of equal numbers in an initialiser list.
const LISTED: usize = 16;

/// Returns true if a value is worth a table: an aggregate of numbers.
pub(crate) fn is_table(module: &Module, value: &Expr) -> bool {
    let words = module.width(&value.ty);
    value.ty.is_aggregate() && (WORDS + 1..=TABLE).contains(&words) && is_of_numbers(module, value)
}

/// Returns true if a value is a table that is copied to its destination: an aggregate with too many numbers for single
/// assignments.
pub(crate) fn is_stored_whole(module: &Module, value: &Expr) -> bool {
    let words = module.width(&value.ty);
    let overlaid = |expr: &Expr| match &expr.ty {
        Type::Struct(id) => module.structs[id.index()].overlaid(),
        _ => false,
    };
    words <= 2 * TABLE
        && statements(value) >= STORED
        && is_of_numbers(module, value)
        && !value.any_expr(overlaid)
}

/// Returns the number of statements that would write a value, equal elements at once.
fn statements(value: &Expr) -> usize {
    match &value.kind {
        ExprKind::Struct(items) | ExprKind::Array(items) | ExprKind::Matrix(items) => {
            items.iter().map(statements).sum()
        }
        _ => 1,
    }
}

fn is_of_numbers(module: &Module, value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Literal(_) => true,
        ExprKind::Struct(items) | ExprKind::Array(items) | ExprKind::Matrix(items) => {
            items.iter().all(|item| is_of_numbers(module, item))
        }
        ExprKind::Splat(item) => match item.kind {
            ExprKind::Literal(0) => true,
            ExprKind::Literal(_) => module.width(&value.ty) <= LISTED,
            _ => false,
        },
        _ => false,
    }
}

struct Names<'m> {
    module: &'m Module,
    function: &'m Function,
    flat: bool,
    /// Counters of the surrounding loops, which nothing else writes.
    counters: Vec<LocalId>,
    found: BTreeMap<LocalId, Place>,
}

impl Visit for Names<'_> {
    fn block(&mut self, block: &Block) {
        for (index, stmt) in block.0.iter().enumerate() {
            if let StmtKind::Let { local, value: Some(value) } = &stmt.kind
                && let ExprKind::Load(place) = &value.kind
                && self.is_wanted(*local)
                && let Some(place) = self.resolved(place)
                && self.holds_still(*local, &place, &block.0[index + 1..])
            {
                self.found.insert(*local, place);
            }
        }
        walk_block(self, block);
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::For { variable, body, .. } if !writes_local(body, *variable) => {
                self.counters.push(*variable);
                walk_stmt(self, stmt);
                self.counters.pop();
            }
            _ => walk_stmt(self, stmt),
        }
    }
}

impl Names<'_> {
    /// Returns true if an alias would save a copy, and C can express it.
    fn is_wanted(&self, id: LocalId) -> bool {
        let local = self.function.local(id);
        let pointed = match &local.ty {
            Type::Struct(_) => true,
            Type::Array { element, .. } => !element.is_array(),
            Type::Matrix { .. } => self.flat,
            _ => false,
        };
        pointed
            && local.mode == Mode::Value
            && self.module.width(&local.ty) > WORDS
            && !writes_local(&self.function.body, id)
    }

    /// Returns true if nothing writes a place while a local may be read.
    fn holds_still(&self, local: LocalId, place: &Place, rest: &[Stmt]) -> bool {
        let Some(last) = rest.iter().rposition(|stmt| mentions(stmt, local)) else { return false };
        let meets =
            |written: &Place| overlap(written, place) && !self.differ_by_counter(written, place);
        !writes(&rest[..=last]).iter().any(meets)
    }

    /// Returns true if two places in one pass of a loop are different elements, since different numbers are added to its counter.
    fn differ_by_counter(&self, one: &Place, other: &Place) -> bool {
        let mut steps = one.steps.iter().zip(&other.steps);
        steps.any(|steps| match steps {
            (Step::Index(one), Step::Index(other)) => match (counted(one), counted(other)) {
                (Some((one, by)), Some((other, of))) => {
                    one == other && by != of && self.counters.contains(&one)
                }
                _ => false,
            },
            _ => false,
        })
    }

    /// Returns a place with aliases in it resolved; none if its indices might change.
    fn resolved(&self, place: &Place) -> Option<Place> {
        let still = |step: &Step| match step {
            Step::Field(_) => true,
            Step::Index(index) => {
                index.is_literal()
                    || counted(index).is_some_and(|(local, _)| self.counters.contains(&local))
            }
            _ => false,
        };
        if !place.steps.iter().all(still) {
            return None;
        }
        let Some(of) = self.found.get(&place.root) else { return Some(place.clone()) };
        let steps = of.steps.iter().chain(&place.steps).cloned().collect();
        Some(Place { root: of.root, steps, ..place.clone() })
    }
}

/// Returns the counter that an index is, and the number that is added to it.
fn counted(index: &Expr) -> Option<(LocalId, i128)> {
    match &index.kind {
        ExprKind::Load(place) if place.steps.is_empty() => Some((place.root, 0)),
        ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), of, by) => {
            let (local, before) = counted(of)?;
            let ExprKind::Literal(word) = by.kind else { return None };
            let by = by.ty.as_int()?.from_word(word);
            Some((local, if *op == BinaryOp::Add { before + by } else { before - by }))
        }
        _ => None,
    }
}
