//! Parts of a result that are built where the caller wants them.
//!
//! A local that a call fills, and that nothing reads but the struct that the function returns at its end, is
//! that struct's field from the start.

use std::collections::BTreeMap;

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{ExprKind, Form, Function, LocalId, Module, Place, Stmt, StmtKind, Type};

/// The locals that are fields of the result, and which. The function must have no fault: its caller would see
/// what was written before.
pub(super) fn parts(function: &Function, module: &Module) -> BTreeMap<LocalId, usize> {
    let none = BTreeMap::new();
    let Type::Struct(id) = function.result else { return none };
    let Some(Stmt { kind: StmtKind::Return(Some(value)), .. }) = function.body.0.last() else {
        return none;
    };
    let ExprKind::Struct(items) = &value.kind else { return none };
    let mut uses = Uses::default();
    uses.block(&function.body);
    if uses.returns != 1 || module.structs[id.index()].form != Form::Record {
        return none;
    }
    let filled = function.body.0.iter().filter_map(|stmt| match &stmt.kind {
        StmtKind::Let { local, value: Some(value) } => {
            matches!(value.kind, ExprKind::Call(..)).then_some(*local)
        }
        _ => None,
    });
    let part = |local: LocalId| {
        let is = |place: &Place| place.root == local && place.steps.is_empty();
        let field = items.iter().position(|item| match &item.kind {
            ExprKind::Load(place) => is(place) && !item.ty.is_word(),
            _ => false,
        })?;
        (uses.places.get(&local) == Some(&1)).then_some((local, field))
    };
    filled.filter_map(part).collect()
}

/// How often each local is mentioned, and how many ways out there are.
#[derive(Default)]
struct Uses {
    places: BTreeMap<LocalId, usize>,
    returns: usize,
}

impl Visit for Uses {
    fn stmt(&mut self, stmt: &Stmt) {
        self.returns += usize::from(matches!(stmt.kind, StmtKind::Return(_)));
        visit::walk_stmt(self, stmt);
    }

    fn place(&mut self, place: &Place, _: Access) {
        *self.places.entry(place.root).or_default() += 1;
        visit::walk_place(self, place);
    }
}
