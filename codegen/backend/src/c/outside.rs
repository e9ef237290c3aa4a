//! Finds enums that an entry point gets from its caller, which may hold no variant of theirs.
//!
//! They are parameters and fields of parameters; elements of arrays and payloads are left out. Must not know: how each is
//! checked.

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_place};
use bessemer_ir::{
    Argument, EnumId, Expr, ExprKind, Form, Function, LocalId, Module, Owner, Place, Role,
    Step as Part, StructId, Type,
};

/// A field of a struct.
pub type Step = (StructId, usize);

/// An enum of a parameter.
pub struct Outside {
    /// Index of the parameter.
    pub parameter: usize,
    /// Fields from the parameter to the enum; empty if it is the parameter.
    pub path: Vec<Step>,
    /// The enum.
    pub id: EnumId,
}

/// Returns the enums of an entry point's parameters, except those of the component: its state comes from its entry points.
pub fn enums(module: &Module, function: &Function) -> Vec<Outside> {
    let mut found = Vec::new();
    if !matches!(function.role, Role::Entry { .. }) {
        return found;
    }
    for (parameter, local) in function.parameters().iter().enumerate() {
        let own = matches!((function.owner, &local.ty),
            (Some(Owner::Struct(owner)), Type::Struct(id)) if parameter == 0 && *id == owner);
        if !own {
            within(module, &local.ty, &mut Vec::new(), &mut |path, id| {
                found.push(Outside { parameter, path: path.to_vec(), id });
            });
        }
    }
    found
}

/// Returns the enums of [`enums`] that the entry point or one of its callees may read; a copy of one counts as read.
pub fn read(module: &Module, function: &Function) -> Vec<Outside> {
    let mut found = enums(module, function);
    found.retain(|it| reads(module, function, it.parameter, &it.path));
    found
}

/// Returns true if a function may read a part of a parameter.
fn reads(module: &Module, function: &Function, parameter: usize, path: &[Step]) -> bool {
    let parameter = LocalId(parameter as u32);
    let mut reads = Reads { module, parameter, path, found: false };
    reads.block(&function.body);
    reads.found
}

struct Reads<'m> {
    module: &'m Module,
    parameter: LocalId,
    path: &'m [Step],
    found: bool,
}

impl Reads<'_> {
    /// Returns the rest of the path behind a place that holds the enum.
    fn behind(&self, place: &Place) -> Option<&[Step]> {
        let steps = self.path.get(..place.steps.len())?;
        let leads = |(part, step): (&Part, &Step)| matches!(part, Part::Field(at) if *at as usize == step.1);
        let leads = place.root == self.parameter && place.steps.iter().zip(steps).all(leads);
        leads.then(|| &self.path[place.steps.len()..])
    }
}

impl Visit for Reads<'_> {
    fn expr(&mut self, expr: &Expr) {
        let ExprKind::Call(callee, arguments) = &expr.kind else { return walk_expr(self, expr) };
        let callee = &self.module.functions[callee.index()];
        for (index, argument) in arguments.iter().enumerate() {
            let passed = match argument {
                Argument::RefMut(place) => Some(place),
                Argument::Value(value) | Argument::Ref(value) => match &value.kind {
                    ExprKind::Load(place) if !value.ty.is_word() => Some(place),
                    _ => None,
                },
            };
            // A function without a body may read what it gets.
            match passed.and_then(|place| self.behind(place)) {
                Some(rest) if !callee.body.0.is_empty() => {
                    self.found = self.found || reads(self.module, callee, index, rest);
                }
                _ => match argument {
                    Argument::Value(value) | Argument::Ref(value) => self.expr(value),
                    Argument::RefMut(place) => self.place(place, Access::Lend),
                },
            }
        }
    }

    fn place(&mut self, place: &Place, access: Access) {
        self.found |= access != Access::Write && self.behind(place).is_some();
        walk_place(self, place);
    }
}

fn within(module: &Module, ty: &Type, path: &mut Vec<Step>, see: &mut dyn FnMut(&[Step], EnumId)) {
    match ty {
        Type::Enum(id) => see(path, *id),
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            let count = match item.form {
                Form::Record => item.fields.len(),
                // The first field says which of the others holds a value: an enum among these may hold none.
                Form::Choice(_) | Form::Sequence => 1,
                // The entry point has written nothing to its work memory yet.
                Form::Lent | Form::Shared => 0,
            };
            for (index, field) in item.fields.iter().enumerate().take(count) {
                path.push((*id, index));
                within(module, &field.ty, path, see);
                path.pop();
            }
        }
        _ => {}
    }
}
