//! Finds enums that an entry point gets from its caller, which may hold no variant of theirs.
//!
//! They are parameters and fields of parameters; elements of arrays and payloads are left out. Must not know: how each is
//! checked.

use bessemer_ir::{EnumId, Form, Function, Module, Owner, Role, StructId, Type};

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
