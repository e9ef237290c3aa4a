//! Facts of a module that several parts of the back end ask for: who can fault, which locals are
//! written, which are read.
//!
//! Invariant: a fact about a function depends on that function and its callees only.

use std::collections::BTreeSet;

use bessemer_ir::{
    Argument, Block, Expr, ExprKind, Fault, Function, FunctionId, LocalId, Mode, Module, Owner,
    Place, Role, Step, Stmt, StmtKind, StructId,
};

/// Who can fault.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    functions: Vec<bool>,
    latched: Vec<bool>,
    /// Checks in each function, its callees' included once per call.
    pub checks: Vec<u32>,
    /// Whether a hook of the user's is called at a fault, and nothing returns a status.
    hook: bool,
}

impl Faults {
    /// Looks at every function; callees stand before callers.
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
            walk_stmts(&function.body, &mut |stmt| {
                if matches!(stmt.kind, StmtKind::Check { fault, .. } if fault != Fault::LeftOut) {
                    checks += 1;
                    fallible = true;
                }
            });
            walk_exprs(&function.body, &mut |expr| {
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

    /// Whether the function returns a status.
    pub fn fallible(&self, function: FunctionId) -> bool {
        !self.hook && self.functions[function.index()]
    }

    /// Whether the component's state holds the fault that stopped it.
    pub fn latched(&self, component: StructId) -> bool {
        self.latched[component.index()]
    }

    /// Whether any function can fault.
    pub fn any(&self) -> bool {
        self.functions.iter().any(|fallible| *fallible)
    }
}

/// The component that a function is an entry point of.
fn entry_owner(module: &Module, function: &Function) -> Option<StructId> {
    match (function.role, function.owner) {
        (Role::Entry { .. }, Some(Owner::Struct(id))) => {
            module.structs[id.index()].initial.is_some().then_some(id)
        }
        _ => None,
    }
}

/// What a function does with its locals.
#[derive(Clone, Debug, Default)]
pub struct Usage {
    /// Written after their declaration, or lent out as `RefMut`.
    pub assigned: Vec<bool>,
    /// Read, or lent out.
    pub read: Vec<bool>,
}

impl Usage {
    /// Looks at the whole body.
    pub fn new(function: &Function) -> Usage {
        let count = function.locals.len();
        let mut usage = Usage { assigned: vec![false; count], read: vec![false; count] };
        walk_stmts(&function.body, &mut |stmt| {
            if let StmtKind::Assign { place, .. } = &stmt.kind {
                usage.assigned[place.root.index()] = true;
                // Through a reference, the write is the use.
                if function.local(place.root).mode == Mode::RefMut {
                    usage.read[place.root.index()] = true;
                }
            }
        });
        walk_stmts(&function.body, &mut |stmt| {
            // What flows back into the same variable does not use it.
            let own = match &stmt.kind {
                StmtKind::Assign { place, .. } if place.steps.is_empty() => Some(place.root),
                _ => None,
            };
            walk_own_exprs(stmt, &mut |expr| match &expr.kind {
                ExprKind::Load(place) if Some(place.root) != own => {
                    usage.read[place.root.index()] = true;
                }
                ExprKind::Call(_, arguments) => {
                    for argument in arguments {
                        if let Argument::RefMut(place) = argument {
                            usage.assigned[place.root.index()] = true;
                            usage.read[place.root.index()] = true;
                        }
                    }
                }
                _ => {}
            });
        });
        usage
    }
}

/// Whether two places may share storage: one root, and no step at which they certainly part.
pub fn overlap(a: &Place, b: &Place) -> bool {
    a.root == b.root
        && a.steps.iter().zip(&b.steps).all(|pair| match pair {
            (Step::Field(x), Step::Field(y)) => x == y,
            (Step::Index(x), Step::Index(y)) => !certainly_differ(x, y),
            (Step::Element(r, c), Step::Element(s, d)) => {
                !certainly_differ(r, s) && !certainly_differ(c, d)
            }
            _ => true,
        })
}

fn certainly_differ(a: &Expr, b: &Expr) -> bool {
    matches!((&a.kind, &b.kind), (ExprKind::Literal(x), ExprKind::Literal(y)) if x != y)
}

/// Whether an expression reads a place that may share storage with `place`.
pub fn reads(expr: &Expr, place: &Place) -> bool {
    let mut found = false;
    walk_expr(expr, &mut |expr| match &expr.kind {
        ExprKind::Load(other) => found |= overlap(other, place),
        ExprKind::Call(_, arguments) => {
            for argument in arguments {
                if let Argument::RefMut(other) = argument {
                    found |= overlap(other, place);
                }
            }
        }
        _ => {}
    });
    found
}

/// Whether an expression reads a local at all.
pub fn reads_local(expr: &Expr, local: LocalId) -> bool {
    let mut found = false;
    walk_expr(expr, &mut |expr| {
        if let ExprKind::Load(place) = &expr.kind {
            found |= place.root == local;
        }
    });
    found
}

/// Visits every statement, outer before inner.
pub fn walk_stmts(block: &Block, visit: &mut dyn FnMut(&Stmt)) {
    for stmt in &block.0 {
        visit(stmt);
        for inner in inner_blocks(stmt) {
            walk_stmts(inner, visit);
        }
    }
}

/// The blocks right inside a statement.
fn inner_blocks(stmt: &Stmt) -> Vec<&Block> {
    match &stmt.kind {
        StmtKind::If { then, otherwise, .. } => vec![then, otherwise],
        StmtKind::Match { arms, otherwise, .. } => {
            arms.iter().map(|arm| &arm.body).chain(otherwise).collect()
        }
        StmtKind::For { body, .. } => vec![body],
        _ => Vec::new(),
    }
}

/// Visits every expression of a block.
pub fn walk_exprs(block: &Block, visit: &mut dyn FnMut(&Expr)) {
    walk_stmts(block, &mut |stmt| walk_own_exprs(stmt, visit));
}

/// Visits the expressions of a statement, without those of the statements in it.
fn walk_own_exprs(stmt: &Stmt, visit: &mut dyn FnMut(&Expr)) {
    match &stmt.kind {
        StmtKind::Let { value: Some(value), .. } => walk_expr(value, visit),
        StmtKind::Assign { place, value } => {
            walk_expr(value, visit);
            walk_place(place, visit);
        }
        StmtKind::Expr(value) | StmtKind::Return(Some(value)) => walk_expr(value, visit),
        StmtKind::If { condition, .. } | StmtKind::Check { condition, .. } => {
            walk_expr(condition, visit);
        }
        StmtKind::Match { scrutinee, .. } => walk_expr(scrutinee, visit),
        StmtKind::For { from, to, .. } => {
            walk_expr(from, visit);
            walk_expr(to, visit);
        }
        _ => {}
    }
}

/// Visits an expression and all inside it.
pub fn walk_expr(expr: &Expr, visit: &mut dyn FnMut(&Expr)) {
    visit(expr);
    match &expr.kind {
        ExprKind::Literal(_) | ExprKind::Const(_) => {}
        ExprKind::Load(place) => walk_place(place, visit),
        ExprKind::Unary(_, a) | ExprKind::Cast(a) | ExprKind::Splat(a) => walk_expr(a, visit),
        ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) | ExprKind::Logic(_, a, b) => {
            walk_expr(a, visit);
            walk_expr(b, visit);
        }
        ExprKind::Call(_, arguments) => {
            for argument in arguments {
                match argument {
                    Argument::Value(value) | Argument::Ref(value) => walk_expr(value, visit),
                    Argument::RefMut(place) => walk_place(place, visit),
                }
            }
        }
        ExprKind::Intrinsic(_, items)
        | ExprKind::Struct(items)
        | ExprKind::Array(items)
        | ExprKind::Matrix(items)
        | ExprKind::Routine(_, items) => items.iter().for_each(|item| walk_expr(item, visit)),
    }
}

fn walk_place(place: &Place, visit: &mut dyn FnMut(&Expr)) {
    for step in &place.steps {
        match step {
            Step::Field(_) => {}
            Step::Index(index) | Step::From(index) => walk_expr(index, visit),
            Step::Element(row, column) => {
                walk_expr(row, visit);
                walk_expr(column, visit);
            }
        }
    }
}

/// The functions that the C needs: those that others can call, and what they call. What another crate
/// brings for the stand-in of an external function alone is none of them; nor is what a function of a
/// library calls in Rust.
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
    let package = module.name.replace('-', "_");
    let is_own = |id: FunctionId| {
        module.functions[id.index()].module.split("::").next() == Some(package.as_str())
    };
    let is_root = |id: FunctionId| is_extern(id) && (!stands_in[id.index()] || is_own(id));
    let mut reached: Vec<bool> = ids().map(is_root).collect();
    follow(module, &mut reached, |id| !is_external(id) && !is_library(id));
    reached
}

/// Marks what marked functions call, as far as `through` goes on from them.
fn follow(module: &Module, marked: &mut [bool], through: impl Fn(FunctionId) -> bool) {
    // Callees stand before callers.
    for index in (0..marked.len()).rev() {
        if marked[index] && through(FunctionId(index as u32)) {
            walk_exprs(&module.functions[index].body, &mut |expr| {
                if let ExprKind::Call(callee, _) = &expr.kind {
                    marked[callee.index()] = true;
                }
            });
        }
    }
}

/// The inline functions that these functions call, directly or through one another; callees first.
pub fn inline_callees(
    module: &Module,
    callers: impl IntoIterator<Item = FunctionId>,
    is_inline: impl Fn(FunctionId) -> bool,
) -> BTreeSet<FunctionId> {
    let mut found = BTreeSet::new();
    let mut open: Vec<FunctionId> = callers.into_iter().collect();
    while let Some(caller) = open.pop() {
        walk_exprs(&module.functions[caller.index()].body, &mut |expr| {
            if let ExprKind::Call(callee, _) = &expr.kind
                && is_inline(*callee)
                && found.insert(*callee)
            {
                open.push(*callee);
            }
        });
    }
    // Callees stand before callers in the module.
    found
}
