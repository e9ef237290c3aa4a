//! How many elements a local has, by the constants that its author named for it.
//!
//! No type of Rust keeps the name. What a local is lent to as a whole has it, if it is a parameter.

use std::collections::BTreeMap;

use bessemer_ir::visit::{Visit, walk_expr, walk_stmt};
use bessemer_ir::{
    Argument, ConstId, Expr, ExprKind, Function, FunctionId, LocalId, Place, Stmt, StmtKind,
};

use crate::c::names::Names;

/// The constants of the sizes of a function's locals: those of the parameters that they are lent to as a whole, unless two of
/// these differ.
pub(super) fn of_locals(
    names: &Names,
    function: &Function,
) -> BTreeMap<LocalId, Vec<Option<ConstId>>> {
    let mut lent = Lent { names, function, found: BTreeMap::new() };
    lent.block(&function.body);
    lent.found.into_iter().filter_map(|(local, sizes)| Some((local, sizes?))).collect()
}

/// Looks for what is lent to parameters whose sizes have names.
struct Lent<'l> {
    names: &'l Names,
    function: &'l Function,
    /// Nothing where two differ.
    found: BTreeMap<LocalId, Option<Vec<Option<ConstId>>>>,
}

impl Lent<'_> {
    fn note(&mut self, local: LocalId, callee: FunctionId, parameter: usize) {
        let Some(param) = self.names.signature(callee).params.get(parameter) else { return };
        let named = param.sizes.iter().any(Option::is_some);
        if !named || self.function.local(local).ty != param.ty {
            return;
        }
        let found = self.found.entry(local).or_insert_with(|| Some(param.sizes.clone()));
        if found.as_ref() != Some(&param.sizes) {
            *found = None;
        }
    }

    /// A call's result is lent to the parameter behind the others.
    fn result(&mut self, local: LocalId, value: &Expr) {
        if let ExprKind::Call(callee, arguments) = &value.kind {
            self.note(local, *callee, arguments.len());
        }
    }
}

impl Visit for Lent<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } => self.result(*local, value),
            StmtKind::Assign { place: Place { root, steps, .. }, value } if steps.is_empty() => {
                self.result(*root, value);
            }
            _ => {}
        }
        walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(callee, arguments) = &expr.kind {
            for (at, argument) in arguments.iter().enumerate() {
                let place = match argument {
                    Argument::RefMut(place) => place,
                    Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => place,
                    Argument::Ref(_) | Argument::Value(_) => continue,
                };
                if place.steps.is_empty() {
                    self.note(place.root, *callee, at);
                }
            }
        }
        walk_expr(self, expr);
    }
}
