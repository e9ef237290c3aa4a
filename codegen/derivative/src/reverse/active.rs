//! Locals and expressions that depend on the variables.

use std::collections::BTreeSet;

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    Argument, Block, Expr, ExprKind, Intrinsic, LocalId, Place, Stmt, StmtKind, Type,
};

/// Locals that depend on the variables, among them the parameters that are variables.
pub struct Active(pub BTreeSet<LocalId>);

impl Active {
    /// Returns the active locals of a block.
    pub fn of(block: &Block, variables: BTreeSet<LocalId>) -> Active {
        let mut active = Active(variables);
        loop {
            let before = active.0.len();
            active.block(block);
            if active.0.len() == before {
                return active;
            }
        }
    }

    /// Returns true if an expression depends on the variables. Rounded numbers and comparisons do not.
    pub fn is(&self, expr: &Expr) -> bool {
        use Intrinsic::*;
        match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => false,
            ExprKind::Compare(..) | ExprKind::Logic(..) => false,
            ExprKind::Load(place) => self.0.contains(&place.root),
            ExprKind::Cast(a) => {
                self.is(a) && (a.ty.as_float().is_none() || expr.ty.as_float().is_some())
            }
            ExprKind::Intrinsic(
                Floor | Ceil | Trunc | Round | Signum | DivEuclid | IsNan | IsFinite | IsInfinite,
                _,
            ) => false,
            ExprKind::Unary(_, a) | ExprKind::Splat(a) => self.is(a),
            ExprKind::Binary(_, a, b) => self.is(a) || self.is(b),
            ExprKind::Intrinsic(_, all)
            | ExprKind::Struct(all)
            | ExprKind::Array(all)
            | ExprKind::Matrix(all)
            | ExprKind::Routine(_, all) => all.iter().any(|it| self.is(it)),
            ExprKind::Call(_, arguments) => {
                expr.ty != Type::BOOL && arguments.iter().any(|it| self.argument(it))
            }
        }
    }

    fn argument(&self, argument: &Argument) -> bool {
        match argument {
            Argument::Value(it) | Argument::Ref(it) => self.is(it),
            Argument::RefMut(place) => self.0.contains(&place.root),
        }
    }
}

impl Visit for Active {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } if self.is(value) => {
                self.0.insert(*local);
            }
            StmtKind::Assign { place, value } if self.is(value) => {
                self.0.insert(place.root);
            }
            _ => {}
        }
        visit::walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(_, arguments) = &expr.kind
            && arguments.iter().any(|it| self.argument(it))
        {
            for argument in arguments {
                if let Argument::RefMut(Place { root, .. }) = argument {
                    self.0.insert(*root);
                }
            }
        }
        visit::walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, _: Access) {
        visit::walk_place(self, place);
    }
}
