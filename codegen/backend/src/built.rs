//! Finds the locals that are built directly in the caller's storage for the result.
//!
//! A local that every `return` returns is the result from the start. A local that is moved into a field of the
//! returned struct, or of the first value of such a local, is that field from the start, if nothing else reads the
//! field earlier and nothing uses the local later.
//!
//! Only for functions that cannot fault: after a fault, the caller would see a partly written result.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit, Walk as _};
use bessemer_ir::{
    Expr as Ir, ExprKind, Function, LocalId, Mode, Module, Place, Stmt, StmtKind, Type,
};

/// Fields that lead from the result to a part.
pub(crate) type Path = Vec<usize>;

/// Returns the local that every `return` returns.
pub(crate) fn whole(function: &Function) -> Option<LocalId> {
    if !function.result.is_aggregate() {
        return None;
    }
    let declared = function.body.0.iter().filter_map(|stmt| match stmt.kind {
        StmtKind::Let { local, .. } => Some(local),
        _ => None,
    });
    let declared: Vec<LocalId> = declared.collect();
    let mut returned: Vec<Option<LocalId>> = Vec::new();
    function.body.each_stmt(|stmt| {
        if let StmtKind::Return(value) = &stmt.kind {
            returned.push(value.as_ref().and_then(|value| match &value.kind {
                ExprKind::Load(place) if place.steps.is_empty() => Some(place.root),
                _ => None,
            }));
        }
    });
    let first = returned.first().copied().flatten()?;
    let same = returned.iter().all(|other| *other == Some(first));
    (same && declared.contains(&first)).then_some(first)
}

/// Returns the locals that are parts of the result, with their paths.
pub(crate) fn parts(function: &Function, module: &Module) -> BTreeMap<LocalId, Path> {
    let whole = whole(function);
    let mut uses = Uses {
        module,
        whole,
        moved: BTreeMap::new(),
        others: BTreeSet::new(),
        built: false,
        by_parts: true,
    };
    uses.block(&function.body);
    if !uses.by_parts {
        return BTreeMap::new();
    }
    let declared = function.body.0.iter().filter_map(|stmt| match &stmt.kind {
        StmtKind::Let { local, .. } => Some(*local),
        _ => None,
    });
    let is_own = |local: &LocalId| {
        let local = function.local(*local);
        local.mode == Mode::Value && local.ty.is_aggregate()
    };
    let mut parts: BTreeMap<LocalId, Path> = BTreeMap::new();
    for local in declared.filter(is_own) {
        let Some([path]) = uses.moved.get(&local).map(Vec::as_slice) else { continue };
        // Two that would share memory: the first has it.
        let shared = |other: &Path| other.starts_with(path) || path.starts_with(other);
        if !uses.others.contains(&local) && !parts.values().any(shared) {
            parts.insert(local, path.clone());
        }
    }
    parts
}

/// Collected uses of each local.
struct Uses<'m> {
    module: &'m Module,
    /// The local that is the result.
    whole: Option<LocalId>,
    /// Paths in the result to which each local is moved.
    moved: BTreeMap<LocalId, Vec<Path>>,
    /// Locals that are used while the result is being written, or later.
    others: BTreeSet<LocalId>,
    /// True if the local that is the result has its first value.
    built: bool,
    /// True if each `return` builds a struct field by field, or the returned local begins with one.
    by_parts: bool,
}

impl Uses<'_> {
    /// Visits a returned struct at the end of a path in the result; false if it is not built field by field.
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
            StmtKind::Let { local, value } if self.whole == Some(*local) => {
                self.built = true;
                self.by_parts = value.as_ref().is_some_and(|it| self.returned(it, &mut Vec::new()));
            }
            StmtKind::Return(Some(_)) if self.whole.is_some() => {}
            StmtKind::Return(Some(value)) => self.by_parts &= self.returned(value, &mut Vec::new()),
            StmtKind::Return(None) => self.by_parts = false,
            _ => visit::walk_stmt(self, stmt),
        }
    }

    fn place(&mut self, place: &Place, _: Access) {
        if self.built {
            self.others.insert(place.root);
        }
        visit::walk_place(self, place);
    }
}

/// Visitor of a returned expression that is evaluated after parts of the result were written.
struct Within<'u, 'm>(&'u mut Uses<'m>);

impl Visit for Within<'_, '_> {
    fn place(&mut self, place: &Place, _: Access) {
        self.0.others.insert(place.root);
        visit::walk_place(self, place);
    }
}
