//! The call graph: functions that may fault, and functions that reach the firmware.

use bessemer_ir::visit::{Visit, walk_expr, walk_stmt};
use bessemer_ir::{Expr, ExprKind, Fault, Function, FunctionId, Module, Stmt, StmtKind};

use super::positions::Callee;

/// Returns true for each function of an explicit module that may fault.
pub fn fallible(module: &Module) -> Vec<bool> {
    callees(module).into_iter().map(|callee| callee.fallible).collect()
}

pub(super) fn callees(module: &Module) -> Vec<Callee> {
    module.functions.iter().fold(Vec::new(), |mut callees, function| {
        callees.push(callee(function, &callees));
        callees
    })
}

/// Callees of a function, and true if it has checks itself.
#[derive(Default)]
struct Calls {
    checks: bool,
    called: Vec<FunctionId>,
}

impl Calls {
    fn of(function: &Function) -> Calls {
        let mut calls = Calls::default();
        calls.block(&function.body);
        calls
    }
}

impl Visit for Calls {
    fn stmt(&mut self, stmt: &Stmt) {
        let fault = |fault: &Fault| *fault != Fault::LeftOut;
        self.checks |= matches!(&stmt.kind, StmtKind::Check { fault: told, .. } if fault(told));
        walk_stmt(self, stmt);
    }
    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(callee, _) = &expr.kind {
            self.called.push(*callee);
        }
        walk_expr(self, expr);
    }
}

/// Returns the facts about a function that its callers need; its callees precede it.
pub(super) fn callee(function: &Function, callees: &[Callee]) -> Callee {
    let calls = Calls::of(function);
    let any = |is: fn(&Callee) -> bool| {
        calls.called.iter().any(|id| callees.get(id.index()).is_some_and(is))
    };
    let fallible = calls.checks || any(|callee| callee.fallible);
    let outside = function.attributes.external.is_some() || any(|callee| callee.outside);
    Callee::of(function, fallible, outside)
}

/// Returns a function and all its direct and indirect callees, callees before callers.
pub fn reached(module: &Module, index: usize) -> Vec<usize> {
    let mut reached = vec![false; module.functions.len()];
    reached[index] = true;
    for caller in (0..=index).rev() {
        if reached[caller] {
            let calls = Calls::of(&module.functions[caller]);
            calls
                .called
                .iter()
                .filter(|id| id.index() < caller)
                .for_each(|id| reached[id.index()] = true);
        }
    }
    (0..=index).filter(|index| reached[*index]).collect()
}
