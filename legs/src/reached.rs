//! The functions of authors that a call can reach, without those of the DSL's own library.

use std::collections::BTreeSet;

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{ExprKind, FunctionId, Module};

/// Returns a function and its callees, as far as authors wrote them.
pub fn reached(module: &Module, from: FunctionId) -> BTreeSet<FunctionId> {
    let own =
        |id: FunctionId| module.functions[id.index()].module.split("::").next() != Some("bessemer");
    let (mut all, mut next) = (BTreeSet::new(), vec![from]);
    while let Some(id) = next.pop() {
        if !own(id) || !all.insert(id) {
            continue;
        }
        module.functions[id.index()].body.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = expr.kind {
                next.push(callee);
            }
        });
    }
    all
}
