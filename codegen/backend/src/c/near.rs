//! Copies of small functions beside the loops that call them.
//!
//! A C compiler cannot inline a function of another file, so each pass of a loop would pay for a call, and load again
//! what the function reads. The file of the loop has a `static inline` copy instead, with a name of its own; the
//! function itself stays in its file, for firmware and for other calls. A loop of few passes is not worth a second text.
//!
//! Invariant: a call goes to a copy because of its own function, its callee and their files alone. Must not know: how
//! functions are lowered.

use std::collections::BTreeMap;

use bessemer_ir::visit::{Visit, Walk, walk_expr, walk_stmt};
use bessemer_ir::{
    Expr, ExprKind, Function, FunctionId, Inlining, Module, Owner, Role, Stmt, StmtKind,
};

use super::analysis::Faults;
use super::placing::Placing;
use super::signature::Signature;
use super::status::FEW;
use super::tree::Storage;

/// Largest number of expressions in a function that is copied.
const SMALL: usize = 48;

/// Names of the copies, by caller and callee.
#[derive(Clone, Debug, Default)]
pub struct Near {
    names: BTreeMap<(FunctionId, FunctionId), String>,
}

impl Near {
    /// Determines the copies; `is_taken` is true for a name of some other item.
    pub fn new(
        module: &Module,
        functions: &[Signature],
        placing: &Placing,
        faults: &Faults,
        is_taken: impl Fn(&str) -> bool,
    ) -> Near {
        let small: Vec<bool> = (module.functions.iter().zip(functions).enumerate())
            .map(|(index, (function, signature))| {
                let latched = |owner| matches!(owner, Owner::Struct(id) if faults.latched(id));
                signature.storage == Storage::Extern
                    && !faults.fallible(FunctionId(index as u32))
                    && !function.owner.is_some_and(latched)
                    && is_small(module, function)
            })
            .collect();
        let mut near = Near::default();
        for (index, function) in module.functions.iter().enumerate() {
            let (caller, storage) = (FunctionId(index as u32), functions[index].storage);
            let file = placing.function_file(caller);
            if !matches!(storage, Storage::Extern | Storage::Static | Storage::OwnInline) {
                continue;
            }
            let mut called = InLoops { module, passes: 1, callees: Vec::new() };
            called.block(&function.body);
            for callee in called.callees {
                let name = format!("{}_in_{file}", functions[callee.index()].name);
                let elsewhere = placing.function_file(callee) != file;
                if small[callee.index()] && elsewhere && !is_taken(&name) {
                    near.names.insert((caller, callee), name);
                }
            }
        }
        near
    }

    /// Returns the name of the copy that a function calls instead of another function.
    pub fn name(&self, caller: FunctionId, callee: FunctionId) -> Option<&String> {
        self.names.get(&(caller, callee))
    }

    /// Returns the functions of which these functions call copies, each with the copy's name.
    pub fn copied(
        &self,
        callers: impl Iterator<Item = FunctionId>,
    ) -> BTreeMap<FunctionId, String> {
        let of = |caller| {
            let all = self.names.range((caller, FunctionId(0))..=(caller, FunctionId(u32::MAX)));
            all.map(|((_, callee), name)| (*callee, name.clone()))
        };
        callers.flat_map(of).collect()
    }

    /// Returns true for the name of a copy.
    pub fn contains(&self, name: &str) -> bool {
        self.names.values().any(|copy| copy == name)
    }
}

/// Returns true for a short function that computes, without loops, calls, checks and constants, whose author requests
/// nothing else.
fn is_small(module: &Module, function: &Function) -> bool {
    let attributes = &function.attributes;
    let is_free = attributes.inlining == Inlining::Free && attributes.section.is_none();
    let mut plain = function.kernel.is_none() && is_free;
    let (mut computes, mut count) = (false, 0);
    function.body.each_stmt(|stmt| {
        plain &= !matches!(stmt.kind, StmtKind::For { .. } | StmtKind::Check { .. });
    });
    function.body.each_expr(|expr| {
        count += 1;
        computes |= matches!(expr.kind, ExprKind::Binary(..));
        let heavy = matches!(expr.kind, ExprKind::Call(..) | ExprKind::Routine(..));
        plain &= !heavy && module.constant(expr).is_none();
    });
    plain && computes && count <= SMALL && !matches!(function.role, Role::Inline { .. })
}

/// Functions that are called in loops of more than [`FEW`] passes, nested ones together.
struct InLoops<'m> {
    module: &'m Module,
    passes: u64,
    callees: Vec<FunctionId>,
}

impl InLoops<'_> {
    /// Returns the number of a loop's passes; one bound that varies makes them many.
    fn count(&self, from: &Expr, to: &Expr) -> u64 {
        let number = |bound: &Expr| match &bound.kind {
            ExprKind::Literal(word) => Some(*word),
            ExprKind::Const(id) => self.module.consts[id.index()].words.first().copied(),
            _ => None,
        };
        number(from).zip(number(to)).map_or(u64::MAX, |(from, to)| to.saturating_sub(from))
    }
}

impl Visit for InLoops<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        let outside = self.passes;
        if let StmtKind::For { from, to, .. } = &stmt.kind {
            self.passes = outside.saturating_mul(self.count(from, to));
        }
        walk_stmt(self, stmt);
        self.passes = outside;
    }

    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(callee, _) = &expr.kind
            && self.passes > u64::from(FEW)
        {
            self.callees.push(*callee);
        }
        walk_expr(self, expr);
    }
}
