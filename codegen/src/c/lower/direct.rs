//! Parts of a result that are built where the caller wants them.
//!
//! A local that a call fills, and that a `return` moves into the struct that it gives, is that struct's field from the
//! start. Until then its words may be read, and nothing writes it.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{Expr as Ir, ExprKind, Function, LocalId, Module, Place, Stmt, StmtKind, Type};

use super::super::tree::Expr;
use super::Lower;

/// The fields that lead from the result to a part.
pub(super) type Path = Vec<usize>;

/// The locals that are parts of the result, and where. The function must have no fault: its caller would see
/// what was written before.
pub(super) fn parts(function: &Function, module: &Module) -> BTreeMap<LocalId, Path> {
    let mut uses = Uses { module, moved: BTreeMap::new(), others: BTreeSet::new(), whole: true };
    uses.block(&function.body);
    if !uses.whole {
        return BTreeMap::new();
    }
    let filled = function.body.0.iter().filter_map(|stmt| match &stmt.kind {
        StmtKind::Let { local, value: Some(value) } if !value.ty.is_word() => {
            matches!(value.kind, ExprKind::Call(..)).then_some(*local)
        }
        _ => None,
    });
    let mut parts: BTreeMap<LocalId, Path> = BTreeMap::new();
    for local in filled {
        let Some([path]) = uses.moved.get(&local).map(Vec::as_slice) else { continue };
        // Two that would share memory: the first has it.
        let shared = |other: &Path| other.starts_with(path) || path.starts_with(other);
        if !uses.others.contains(&local) && !parts.values().any(shared) {
            parts.insert(local, path.clone());
        }
    }
    parts
}

/// What becomes of locals.
struct Uses<'m> {
    module: &'m Module,
    /// The parts of what is returned that each becomes.
    moved: BTreeMap<LocalId, Vec<Path>>,
    /// Those of which more than words is used before, or anything in what is returned.
    others: BTreeSet<LocalId>,
    /// Whether each `return` gives a struct part by part.
    whole: bool,
}

impl Uses<'_> {
    /// A struct that is returned, at the end of a path into the result.
    fn returned(&mut self, value: &Ir, path: &mut Path) -> bool {
        let (ExprKind::Struct(items), Type::Struct(id)) = (&value.kind, &value.ty) else {
            return false;
        };
        if self.module.structs[id.index()].overlaid() {
            return false;
        }
        for (field, item) in items.iter().enumerate() {
            path.push(field);
            match &item.kind {
                ExprKind::Load(place) if place.steps.is_empty() && !item.ty.is_word() => {
                    self.moved.entry(place.root).or_default().push(path.clone());
                }
                _ if self.returned(item, path) => {}
                _ => Within(self).expr(item),
            }
            path.pop();
        }
        true
    }
}

impl Visit for Uses<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Return(Some(value)) => self.whole &= self.returned(value, &mut Vec::new()),
            StmtKind::Return(None) => self.whole = false,
            _ => visit::walk_stmt(self, stmt),
        }
    }

    fn place(&mut self, place: &Place, access: Access) {
        if access != Access::Read || !place.ty.is_word() {
            self.others.insert(place.root);
        }
        visit::walk_place(self, place);
    }
}

/// What is computed as it is returned, when parts of the result are written already.
struct Within<'u, 'm>(&'u mut Uses<'m>);

impl Visit for Within<'_, '_> {
    fn place(&mut self, place: &Place, _: Access) {
        self.0.others.insert(place.root);
        visit::walk_place(self, place);
    }
}

impl Lower<'_> {
    /// Where a local stands that is a part of the result.
    pub(super) fn part_of_result(&self, local: LocalId) -> Option<Expr> {
        let (path, mut value) = (self.parts.get(&local)?, self.result_storage()?);
        let mut ty = &self.function.result;
        for field in path {
            let Type::Struct(id) = ty else { return None };
            value = value.field(&self.context.names.structs[id.index()].fields[*field]);
            ty = &self.context.module.structs[id.index()].fields[*field].ty;
        }
        Some(value)
    }
}
