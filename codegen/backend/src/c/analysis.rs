//! Facts about a module for several parts of the back end: functions that can fault, and locals that are written or
//! read.
//!
//! Invariant: a fact about a function depends only on that function and its callees.

use std::collections::BTreeSet;

use bessemer_ir::visit::{Access, Visit, Walk, walk_place, walk_stmt};
use bessemer_ir::{
    ExprKind, Fault, Form, Function, FunctionId, LocalId, Mode, Module, Owner, Place, Role, Stmt,
    StmtKind, Struct, StructId, Type,
};

/// Set of functions that can fault.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    functions: Vec<bool>,
    latched: Vec<bool>,
    /// Number of checks in each function, including its callees once for each call.
    pub checks: Vec<u32>,
    /// True if a fault calls the user's hook and no function returns a status.
    hook: bool,
}

impl Faults {
    /// Computes the facts about all functions; callees precede callers.
    pub fn new(module: &Module, hook: bool) -> Faults {
        let mut faults = Faults {
            hook,
            functions: Vec::new(),
            latched: vec![false; module.structs.len()],
            checks: Vec::new(),
        };
        for function in &module.functions {
            let mut checks = 0;
            let mut fallible = matches!(function.role, Role::Entry { infallible: false });
            function.body.each_stmt(|stmt| {
                if matches!(stmt.kind, StmtKind::Check { fault, .. } if fault != Fault::LeftOut) {
                    checks += 1;
                    fallible = true;
                }
            });
            function.body.each_expr(|expr| {
                if let ExprKind::Call(callee, _) = &expr.kind {
                    checks += faults.checks[callee.index()];
                    fallible |= faults.functions[callee.index()];
                }
            });
            faults.functions.push(fallible);
            faults.checks.push(checks);
            let latches = fallible && !hook && !function.attributes.atomic;
            if let (true, Some(component)) = (latches, entry_owner(module, function)) {
                faults.latched[component.index()] = true;
            }
        }
        faults
    }

    /// Returns true if the function returns a status.
    pub fn fallible(&self, function: FunctionId) -> bool {
        !self.hook && self.functions[function.index()]
    }

    /// Returns true if the component's state holds the fault that stopped it.
    pub fn latched(&self, component: StructId) -> bool {
        self.latched[component.index()]
    }

    /// Returns true if any function can fault.
    pub fn any(&self) -> bool {
        self.functions.iter().any(|fallible| *fallible)
    }
}

/// Returns the component of which a function is an entry point.
fn entry_owner(module: &Module, function: &Function) -> Option<StructId> {
    match (function.role, function.owner) {
        (Role::Entry { .. }, Some(Owner::Struct(id))) => {
            module.structs[id.index()].initial.is_some().then_some(id)
        }
        _ => None,
    }
}

/// Use of a function's locals.
#[derive(Clone, Debug, Default)]
pub struct Usage {
    /// True for each local that is written after its declaration, or borrowed mutably.
    pub assigned: Vec<bool>,
    /// True for each local that is read or borrowed.
    pub read: Vec<bool>,
    /// True for each local that is read or borrowed as a whole, so that all its bytes may be copied.
    pub whole: Vec<bool>,
}

impl Usage {
    /// Collects the uses in a whole body.
    pub fn new(function: &Function) -> Usage {
        let count = function.locals.len();
        let none = || vec![false; count];
        let usage = Usage { assigned: none(), read: none(), whole: none() };
        let mut uses = Uses { function, usage, own: None };
        uses.block(&function.body);
        uses.usage
    }
}

/// Visitor that collects uses of locals.
struct Uses<'f> {
    function: &'f Function,
    usage: Usage,
    /// Local that the present statement assigns as a whole; its own old value is no use.
    own: Option<LocalId>,
}

impl Visit for Uses<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        let own = match &stmt.kind {
            StmtKind::Assign { place, .. } if place.steps.is_empty() => Some(place.root),
            _ => None,
        };
        let outer = std::mem::replace(&mut self.own, own);
        walk_stmt(self, stmt);
        self.own = outer;
    }

    fn place(&mut self, place: &Place, access: Access) {
        let (root, Usage { assigned, read, whole }) = (place.root, &mut self.usage);
        assigned[root.index()] |= access != Access::Read;
        read[root.index()] |= match access {
            Access::Read => Some(root) != self.own,
            // Through a reference, the write is the use.
            Access::Write => self.function.local(root).mode == Mode::RefMut,
            Access::Lend => true,
        };
        whole[root.index()] |= access != Access::Write && place.steps.is_empty();
        walk_place(self, place);
    }
}

/// Returns the functions that the C needs: those that others can call, and their callees. Not included are functions
/// that only the Rust stand-in of an external function calls, and those that a function replaced by a library calls.
pub fn reachable(
    module: &Module,
    is_extern: impl Fn(FunctionId) -> bool,
    is_library: impl Fn(FunctionId) -> bool,
) -> Vec<bool> {
    let count = module.functions.len();
    let ids = || (0..count).map(|index| FunctionId(index as u32));
    let is_external = |id: FunctionId| module.functions[id.index()].attributes.external.is_some();
    let mut stands_in: Vec<bool> = ids().map(is_external).collect();
    follow(module, &mut stands_in, |_| true);
    let is_own = |id: FunctionId| is_own(module, &module.functions[id.index()]);
    let is_root = |id: FunctionId| is_extern(id) && (!stands_in[id.index()] || is_own(id));
    let mut reached: Vec<bool> = ids().map(is_root).collect();
    follow(module, &mut reached, |id| !is_external(id) && !is_library(id));
    reached
}

/// Returns true for a function of the package, and false for one of another crate.
pub fn is_own(module: &Module, function: &Function) -> bool {
    let package = module.name.replace('-', "_");
    function.module.split("::").next() == Some(package.as_str())
}

/// Marks the callees of marked functions; `through` selects the functions whose callees are followed.
fn follow(module: &Module, marked: &mut [bool], through: impl Fn(FunctionId) -> bool) {
    // Callees precede callers.
    for index in (0..marked.len()).rev() {
        if marked[index] && through(FunctionId(index as u32)) {
            module.functions[index].body.each_expr(|expr| {
                if let ExprKind::Call(callee, _) = &expr.kind {
                    marked[callee.index()] = true;
                }
            });
        }
    }
}

/// Returns the structs that the C need not name: parts of a work struct that no code uses as a whole.
pub fn unnamed(module: &Module) -> BTreeSet<StructId> {
    let of_union = |item: &Struct| item.form == Form::Shared;
    let parts = module.structs.iter().filter(|it| of_union(it)).flat_map(|it| &it.fields);
    let mut unnamed: BTreeSet<StructId> = parts.filter_map(|field| struct_of(&field.ty)).collect();
    unnamed.retain(|id| module.structs[id.index()].form == Form::Lent);
    let elsewhere = module.structs.iter().filter(|it| !of_union(it)).flat_map(|it| &it.fields);
    let spoken = module.functions.iter().flat_map(|it| &it.locals).map(|local| &local.ty);
    for ty in elsewhere.map(|field| &field.ty).chain(spoken) {
        if let Some(id) = struct_of(ty) {
            unnamed.remove(&id);
        }
    }
    unnamed
}

fn struct_of(ty: &Type) -> Option<StructId> {
    match ty {
        Type::Struct(id) => Some(*id),
        Type::Array { element, .. } | Type::Slice(element) => struct_of(element),
        _ => None,
    }
}

/// Returns the inline functions that these functions call, directly or indirectly, callees first.
pub fn inline_callees(
    module: &Module,
    callers: impl IntoIterator<Item = FunctionId>,
    is_inline: impl Fn(FunctionId) -> bool,
) -> BTreeSet<FunctionId> {
    let mut found = BTreeSet::new();
    let mut open: Vec<FunctionId> = callers.into_iter().collect();
    while let Some(caller) = open.pop() {
        module.functions[caller.index()].body.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind
                && is_inline(*callee)
                && found.insert(*callee)
            {
                open.push(*callee);
            }
        });
    }
    // Callees precede callers in the module.
    found
}
