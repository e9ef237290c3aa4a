//! Sizes that fit into 32 bits: reassigned `usize` locals, and their ranges.
//!
//! Precondition: an explicit function. Invariant: in each execution, the value of such a local is in the returned
//! range. As for a removed check, analysis and proof must both show it, each with its own list of assignments.
//!
//! Must not know: the C, except that a call returns 64 bits.

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_place, walk_stmt};
use bessemer_ir::{
    BinaryOp, Expr, ExprKind, Function, LocalId, Mode, Module, Place, Stmt, StmtKind, Type,
};

use super::{analysis, proof};

/// Largest value that fits, also for intermediate results.
const LIMIT: i128 = 1 << 31;

/// Returns the least and greatest value of each local that fits.
pub(crate) fn sizes(module: &Module, function: &Function) -> Vec<Option<(i128, i128)>> {
    let mut wanted = Wanted::of(function);
    wanted.block(&function.body);
    let wanted: Vec<bool> = wanted.found.iter().map(|it| it.assigned && !it.refused).collect();
    // Names for parts of one memory would share it, of which the proofs know nothing.
    let mut own = function.locals.iter().skip(function.params as usize);
    if !wanted.contains(&true) || own.any(|local| local.mode == Mode::RefMut) {
        return vec![None; wanted.len()];
    }
    let (first, second) = (analysis::held(module, function), proof::held(module, function));
    let proofs = first.into_iter().zip(second);
    let shown = wanted.into_iter().zip(proofs).map(|(wanted, (one, other))| {
        let (one, other) = (one.filter(|_| wanted)?, other?);
        let (low, high) = (one.low.min(other.0), one.high.max(other.1));
        (low >= 0 && high <= LIMIT).then_some((low, high))
    });
    shown.collect()
}

/// Returns true for each local that some comparison needs in 64 bits.
pub(crate) fn wide(function: &Function) -> Vec<bool> {
    struct Wide(Vec<bool>);
    impl Visit for Wide {
        fn expr(&mut self, expr: &Expr) {
            compared_wide(expr).for_each(|local| self.0[local.index()] = true);
            walk_expr(self, expr);
        }
    }
    let mut wide = Wide(vec![false; function.locals.len()]);
    wide.block(&function.body);
    wide.0
}

/// Returns the locals that a comparison needs in 64 bits. In 32 bits, gcc takes a difference from a literal for a promoted
/// complement, and warns; it also warns of a literal that 32 bits never exceed.
fn compared_wide(expr: &Expr) -> impl Iterator<Item = LocalId> + '_ {
    let pairs = match &expr.kind {
        ExprKind::Compare(_, a, b) => vec![(a, b), (b, a)],
        _ => Vec::new(),
    };
    pairs.into_iter().filter_map(|(one, other)| {
        let ExprKind::Load(place) = &one.kind else { return None };
        let is_wide = match &other.kind {
            ExprKind::Binary(BinaryOp::Sub, most, _) => most.is_literal(),
            ExprKind::Literal(most) => *most >= u64::from(u32::MAX),
            _ => false,
        };
        is_wide.then_some(place.root)
    })
}

/// Locals that might fit.
struct Wanted {
    found: Vec<Fate>,
}

/// Uses of a local.
#[derive(Clone, Copy)]
struct Fate {
    /// True if it is assigned after its declaration.
    assigned: bool,
    /// True if it is written otherwise, or is no `usize` value of this function.
    refused: bool,
}

impl Wanted {
    fn of(function: &Function) -> Wanted {
        let params = function.params as usize;
        let fate = function.locals.iter().enumerate().map(|(index, local)| Fate {
            assigned: false,
            refused: index < params || local.mode != Mode::Value || local.ty != Type::USIZE,
        });
        Wanted { found: fate.collect() }
    }
}

fn is_call(value: &Expr) -> bool {
    matches!(value.kind, ExprKind::Call(..))
}

impl Visit for Wanted {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                self.found[local.index()].refused |= value.as_ref().is_some_and(is_call);
            }
            StmtKind::Assign { place, value } => {
                let fate = &mut self.found[place.root.index()];
                fate.assigned = true;
                fate.refused |= is_call(value);
            }
            StmtKind::For { variable, .. } => self.found[variable.index()].refused = true,
            _ => {}
        }
        walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        for local in compared_wide(expr) {
            self.found[local.index()].refused = true;
        }
        walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        self.found[place.root.index()].refused |= access == Access::Lend;
        walk_place(self, place);
    }
}
