//! Sizes that fit into 32 bits: reassigned locals of `usize`, and their ranges.
//!
//! Precondition: an explicit function. Invariant: in each execution, what such a local holds lies within what is given for it.
//! Both proofs have to show it, each with its own account of what is assigned, as of a check that is left out.
//!
//! Must not know: what C makes of it, but that a call gives its result in 64 bits.

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_place, walk_stmt};
use bessemer_ir::{BinaryOp, Expr, ExprKind, Function, Mode, Module, Place, Stmt, StmtKind, Type};

use super::{analysis, proof};

/// The largest value that fits, also on the way to another.
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

/// The locals that might fit.
struct Wanted {
    found: Vec<Fate>,
}

/// Uses of a local.
#[derive(Clone, Copy)]
struct Fate {
    /// True if it is assigned behind its declaration.
    assigned: bool,
    /// True if something else gives it a value, or it is no size of the function's own.
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

    // In 32 bits, gcc takes a difference that it is compared with for a complement that was promoted, and warns; and it warns
    // of a number that 32 bits never exceed.
    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Compare(_, a, b) = &expr.kind {
            for (one, other) in [(a, b), (b, a)] {
                let ExprKind::Load(place) = &one.kind else { continue };
                self.found[place.root.index()].refused |= match &other.kind {
                    ExprKind::Binary(BinaryOp::Sub, most, _) => most.is_literal(),
                    ExprKind::Literal(most) => *most >= u64::from(u32::MAX),
                    _ => false,
                };
            }
        }
        walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        self.found[place.root.index()].refused |= access == Access::Lend;
        walk_place(self, place);
    }
}
