//! Lengths of local arrays, by the author's named constants.
//!
//! No Rust type contains the name. A local gets it from the parameter to which it is passed as a whole. Loops over a
//! whole array use it as their end.

use std::collections::BTreeMap;

use bessemer_ir::visit::{Visit, walk_expr, walk_stmt};
use bessemer_ir::{
    Argument, ConstId, Expr, ExprKind, Function, FunctionId, LocalId, Place, Stmt, StmtKind,
};

use super::Lower;
use crate::c::names::Names;
use crate::c::tree::Expr as CExpr;

impl Lower<'_> {
    /// Returns the length of an array: its named constant if it is a variable or parameter with one, else the number.
    pub(super) fn extent(&mut self, array: &CExpr, count: u32) -> CExpr {
        let named = match array {
            CExpr::Name(name) => self.named_extent(name, count),
            _ => None,
        };
        self.uses.consts.extend(named);
        let name = named.and_then(|id| self.context.names.shared_constant(id));
        CExpr::name(name.map_or_else(|| format!("{count}U"), str::to_owned))
    }

    fn named_extent(&self, array: &str, count: u32) -> Option<ConstId> {
        let param = || self.signature.params.iter().find(|param| param.name == array);
        let sizes = self.declared.get(array).or_else(|| Some(&param()?.sizes))?;
        let is_all =
            |id: &&ConstId| self.context.module.consts[id.index()].words == [u64::from(count)];
        sizes.iter().flatten().find(is_all).copied()
    }
}

/// Returns the constants of the lengths of a function's locals. They come from the parameters to which the locals are
/// passed as a whole, unless two of these differ.
pub(super) fn of_locals(
    names: &Names,
    function: &Function,
) -> BTreeMap<LocalId, Vec<Option<ConstId>>> {
    let mut lent = Lent { names, function, found: BTreeMap::new() };
    lent.block(&function.body);
    lent.found.into_iter().filter_map(|(local, sizes)| Some((local, sizes?))).collect()
}

/// Visitor that finds locals passed to parameters whose lengths have names.
struct Lent<'l> {
    names: &'l Names,
    function: &'l Function,
    /// Constants of each local; none if two parameters disagree.
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

    /// Records that a call's result is passed by a pointer after the other parameters.
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
