//! Memory that large temporaries need at a time, computed independently by data-flow analysis.
//!
//! A value is alive from its first complete write to the last read of it. The analysis goes backwards through the
//! statements, and repeats loops until nothing changes. The compiler's result (`codegen/backend/src/passes/lend/`),
//! which counts statements, must be close to this. This module must not use anything of that.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_backend::passes;
use bessemer_codegen::compile::Compiled;
use bessemer_ir::visit::{Access, Visit, Walk, walk_place};
use bessemer_ir::{
    Block, Expr, ExprKind, Float, Form, Function, LocalId, Mode, Module, Place, Scalar, Stmt,
    StmtKind, Type,
};

type Alive = BTreeSet<LocalId>;

/// Returns the name of each function with passed memory, the size of that memory, and the bytes alive at once.
///
/// # Panics
/// If the passes refuse what they took before.
pub fn lent(compiled: &Compiled) -> Vec<(String, u64, u64)> {
    let (before, _) = passes::explicit(compiled.module.clone()).expect("compiled before");
    let after = &compiled.explicit;
    let mut at_once: Vec<u64> = Vec::new();
    let mut list = Vec::new();
    for (function, lent) in before.functions.iter().zip(&after.functions) {
        let added = &lent.parameters()[function.params as usize..];
        let bytes: u64 = added.iter().map(|local| size(after, &local.ty).0).sum();
        let most = if function.kernel.is_some() {
            bytes
        } else {
            // Which locals were moved is read off the result; when they live is not.
            let moved = (function.params..function.locals.len() as u32).map(LocalId);
            let moved =
                moved.filter(|id| lent.locals[id.index() + added.len()].mode == Mode::RefMut);
            let sizes = moved.map(|id| (id, size(after, &function.local(id).ty).0)).collect();
            Account::of(function, sizes, &at_once)
        };
        at_once.push(most);
        if bytes > 0 || most > 0 {
            list.push((format!("{}::{}", function.module, function.name), bytes, most));
        }
    }
    list
}

struct Account<'a> {
    sizes: BTreeMap<LocalId, u64>,
    /// Memory for large temporaries that each callee needs.
    callees: &'a [u64],
    /// Sets alive after each surrounding loop, and at the start of its next pass.
    loops: Vec<(Alive, Alive)>,
    most: u64,
}

impl Account<'_> {
    fn of(function: &Function, sizes: BTreeMap<LocalId, u64>, callees: &[u64]) -> u64 {
        let mut account = Account { sizes, callees, loops: Vec::new(), most: 0 };
        account.block(&function.body, Alive::new());
        account.most
    }

    /// Returns the set alive before a block, from the set after it.
    fn block(&mut self, block: &Block, behind: Alive) -> Alive {
        block.0.iter().rev().fold(behind, |alive, stmt| self.stmt(stmt, alive))
    }

    fn stmt(&mut self, stmt: &Stmt, behind: Alive) -> Alive {
        match &stmt.kind {
            StmtKind::If { condition, then, otherwise } => {
                let mut alive = self.block(then, behind.clone());
                alive.extend(self.block(otherwise, behind));
                self.reads(condition, alive)
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let mut alive = Alive::new();
                for arm in arms {
                    alive.extend(self.block(&arm.body, behind.clone()));
                }
                if let Some(otherwise) = otherwise {
                    alive.extend(self.block(otherwise, behind));
                }
                self.reads(scrutinee, alive)
            }
            StmtKind::For { from, to, body, .. } => {
                let mut head = behind.clone();
                loop {
                    self.loops.push((behind.clone(), head.clone()));
                    let mut next = self.block(body, head.clone());
                    self.loops.pop();
                    next.extend(head.iter().copied());
                    if next == head {
                        break;
                    }
                    head = next;
                }
                let alive = self.reads(to, head);
                self.reads(from, alive)
            }
            StmtKind::Break => self.loops.last().expect("a loop").0.clone(),
            StmtKind::Continue => self.loops.last().expect("a loop").1.clone(),
            StmtKind::Return(None) => Alive::new(),
            StmtKind::Return(Some(value)) => self.reads(value, Alive::new()),
            StmtKind::Expr(value) | StmtKind::Check { condition: value, .. } => {
                self.reads(value, behind)
            }
            StmtKind::Let { value: None, local } => without(behind, *local),
            StmtKind::Let { local, value: Some(value) } => {
                self.writes(*local, true, stmt, behind, value)
            }
            StmtKind::Assign { place, value } => {
                self.writes(place.root, place.steps.is_empty(), stmt, behind, value)
            }
        }
    }

    /// Processes a statement that writes a local while its operands may still be read.
    fn writes(
        &mut self,
        to: LocalId,
        whole: bool,
        stmt: &Stmt,
        behind: Alive,
        value: &Expr,
    ) -> Alive {
        let mut during = behind.clone();
        during.insert(to);
        let before = if whole { without(behind, to) } else { behind };
        let read = read(stmt);
        during.extend(&read);
        self.count(&during, value);
        before.into_iter().chain(read).collect()
    }

    fn reads(&mut self, value: &Expr, behind: Alive) -> Alive {
        let alive: Alive = behind.into_iter().chain(read(value)).collect();
        self.count(&alive, value);
        alive
    }

    fn count(&mut self, alive: &Alive, value: &Expr) {
        let own: u64 = alive.iter().filter_map(|id| self.sizes.get(id)).sum();
        let mut called = 0;
        value.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind {
                called = called.max(self.callees[callee.index()]);
            }
        });
        self.most = self.most.max(own + called);
    }
}

fn without(mut alive: Alive, local: LocalId) -> Alive {
    alive.remove(&local);
    alive
}

/// Returns the locals that are read, or passed to a call by reference.
fn read(node: &impl Walk) -> Alive {
    struct Reads(Alive);
    impl Visit for Reads {
        fn place(&mut self, place: &Place, access: Access) {
            if access != Access::Write {
                self.0.insert(place.root);
            }
            walk_place(self, place);
        }
    }
    let mut reads = Reads(Alive::new());
    node.walk(&mut reads);
    reads.0
}

/// Returns size and alignment in the usual ABIs.
fn size(module: &Module, ty: &Type) -> (u64, u64) {
    match ty {
        Type::Unit | Type::Slice(_) => (0, 1),
        Type::Enum(_) => (4, 4),
        Type::Scalar(scalar) => (word(*scalar), word(*scalar)),
        Type::Array { element, len } => {
            let (size, align) = size(module, element);
            (size * u64::from(*len), align)
        }
        Type::Matrix { element, rows, cols } => {
            (word(*element) * u64::from(rows * cols), word(*element))
        }
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            let fields = item.fields.iter().map(|field| size(module, &field.ty));
            let shared = if item.overlaid() { 1 } else { 0 };
            let (mut end, mut most, mut strictest) = (0_u64, 0, 1);
            for (index, (size, align)) in fields.enumerate() {
                strictest = strictest.max(align);
                if item.form == Form::Shared || item.overlaid() && index >= shared {
                    most = most.max(end.next_multiple_of(align) + size);
                } else {
                    end = end.next_multiple_of(align) + size;
                }
            }
            (most.max(end).next_multiple_of(strictest), strictest)
        }
    }
}

fn word(scalar: Scalar) -> u64 {
    match scalar {
        Scalar::Bool => 1,
        Scalar::Int(int) => u64::from(int.bits() / 8),
        Scalar::Float(Float::F32) => 4,
        Scalar::Float(Float::F64) => 8,
    }
}
