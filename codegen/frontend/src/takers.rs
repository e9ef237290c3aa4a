//! Names temporaries after the place that takes their value: a field, a parameter, or the result.
//!
//! Invariants: only names change, and none becomes the name of another local in a block around it or inside it.
//!
//! Must not know: why lowering made a local; C.

use std::collections::BTreeMap;

use bessemer_ir::visit::{Access, Visit, walk_block, walk_expr, walk_place, walk_stmt};
use bessemer_ir::{
    Argument, Block, Expr, ExprKind, Form, Function, LocalId, Module, Place, Step, Stmt, StmtKind,
    Type,
};

/// Names the locals for which `unnamed` holds and that are read once, by a place with a name.
pub(crate) fn name(module: &Module, function: &mut Function, unnamed: &dyn Fn(LocalId) -> bool) {
    let facts = vec![Facts::default(); function.locals.len()];
    let mut read = Read { module, function, facts, copies: Vec::new(), blocks: vec![0], block: 0 };
    read.block(&function.body);
    let Read { mut facts, copies, blocks, .. } = read;
    // A copy is declared after what it copies, and has its own taker later.
    for (copy, of) in copies.into_iter().rev() {
        let it = &mut facts[copy.index()];
        if unnamed(copy) && it.reads == 1 && !it.is_written {
            facts[of.index()].taker = it.taker.take();
        }
    }
    let mut homes: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (local, facts) in function.locals.iter().zip(&facts) {
        for name in std::iter::once(&local.name).chain(&facts.taker) {
            homes.entry(name.clone()).or_default().push(facts.home);
        }
    }
    for (index, Facts { reads, taker, home, .. }) in facts.into_iter().enumerate() {
        let Some(taker) = taker.filter(|_| reads == 1 && unnamed(LocalId(index as u32))) else {
            continue;
        };
        let near = homes[&taker]
            .iter()
            .filter(|other| is_within(&blocks, **other, home) || is_within(&blocks, home, **other));
        // The one that is near is itself.
        if near.count() == 1 {
            function.locals[index].name = taker;
        }
    }
}

/// Returns true if a block is another one, or inside it; `blocks` has the outer block of each.
fn is_within(blocks: &[usize], mut block: usize, outer: usize) -> bool {
    while block > outer {
        block = blocks[block];
    }
    block == outer
}

/// Facts about one local.
#[derive(Clone, Default)]
struct Facts {
    /// Number of reads.
    reads: usize,
    /// True if it is assigned after its declaration.
    is_written: bool,
    /// Name of the place that takes its value.
    taker: Option<String>,
    /// The block that declares it.
    home: usize,
}

struct Read<'f> {
    module: &'f Module,
    function: &'f Function,
    facts: Vec<Facts>,
    /// Locals that begin as another one, with that one.
    copies: Vec<(LocalId, LocalId)>,
    /// The outer block of each block; the first is its own.
    blocks: Vec<usize>,
    /// The present block.
    block: usize,
}

impl Read<'_> {
    fn taken(&mut self, value: &Expr, taker: &str) {
        if let ExprKind::Load(place) = &value.kind
            && place.steps.is_empty()
            && !taker.is_empty()
            && taker != "self"
        {
            self.facts[place.root.index()].taker = Some(taker.to_owned());
        }
    }

    /// Returns the name of the field at the end of a place.
    fn field(&self, place: &Place) -> Option<&str> {
        let (Step::Field(last), before) = place.steps.split_last()? else { return None };
        let mut ty = self.function.local(place.root).ty.clone();
        for step in before {
            ty = self.module.step_type(&ty, step)?;
        }
        self.name_of(&ty, *last as usize)
    }

    /// Returns the name of an author's field.
    fn name_of(&self, ty: &Type, field: usize) -> Option<&str> {
        let Type::Struct(id) = ty else { return None };
        let item = &self.module.structs[id.index()];
        let authored = item.form == Form::Record;
        authored.then(|| item.fields.get(field).map(|field| field.name.as_str()))?
    }
}

impl Visit for Read<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Assign { place, value } => {
                if let Some(field) = self.field(place).map(str::to_owned) {
                    self.taken(value, &field);
                }
            }
            StmtKind::Let { local, value: Some(Expr { kind: ExprKind::Load(place), .. }) }
                if place.steps.is_empty() =>
            {
                self.copies.push((*local, place.root));
            }
            StmtKind::Return(Some(value)) => {
                let name = &self.function.result_name;
                let name = if name.is_empty() { "result" } else { name };
                self.taken(value, name);
            }
            _ => {}
        }
        walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Struct(parts) => {
                for (index, part) in parts.iter().enumerate() {
                    if let Some(field) = self.name_of(&expr.ty, index).map(str::to_owned) {
                        self.taken(part, &field);
                    }
                }
            }
            ExprKind::Call(callee, arguments) => {
                let callee = self.module.functions.get(callee.index());
                let params = callee.into_iter().flat_map(|callee| &callee.locals);
                for (argument, param) in arguments.iter().zip(params) {
                    if let Argument::Value(value) | Argument::Ref(value) = argument {
                        self.taken(value, &param.name);
                    }
                }
            }
            _ => {}
        }
        walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        let facts = &mut self.facts[place.root.index()];
        facts.reads += usize::from(access != Access::Write || !place.steps.is_empty());
        facts.is_written |= access != Access::Read;
        walk_place(self, place);
    }

    fn block(&mut self, block: &Block) {
        self.blocks.push(self.block);
        let outer = std::mem::replace(&mut self.block, self.blocks.len() - 1);
        walk_block(self, block);
        self.block = outer;
    }

    fn declaration(&mut self, local: &LocalId) {
        self.facts[local.index()].home = self.block;
    }
}
