//! Entry points of a module: which there are, what they are called, and which can be called with words.
//!
//! Must not know: the legs.

use bessemer_codegen::compile::Compiled;
use bessemer_ir::{Function, FunctionId, Module, Owner, Role, Type};

/// Iterates the entry points of a module.
pub fn all(module: &Module) -> impl Iterator<Item = FunctionId> + '_ {
    let ids = (0..module.functions.len()).map(|index| FunctionId(index as u32));
    ids.filter(|id| matches!(module.functions[id.index()].role, Role::Entry { .. }))
}

/// Returns the name of a function in the Rust, behind its component's: `Motor::step`.
pub fn named(module: &Module, function: &Function) -> String {
    match function.owner {
        Some(Owner::Struct(id)) => {
            format!("{}::{}", module.structs[id.index()].name, function.name)
        }
        _ => function.name.clone(),
    }
}

/// Returns true if words can call the function: it has a component and no borrowed slice.
pub fn can_call(function: &Function) -> bool {
    let parameters = function.parameters();
    let slice = parameters.iter().any(|local| matches!(local.ty, Type::Slice(_)));
    parameters.first().is_some_and(|local| local.name == "self") && !slice
}

/// Returns the entry points that words can call, with the number of the author's parameters. A board's firmware has them in this
/// order.
pub fn callable(compiled: &Compiled) -> Vec<(FunctionId, u32)> {
    let functions = &compiled.module.functions;
    let can = all(&compiled.module).filter(|id| can_call(&functions[id.index()]));
    can.map(|id| (id, functions[id.index()].params)).collect()
}

/// Returns the entry points with a name, in the C or in the Rust; without a name all of them.
pub fn chosen(compiled: &Compiled, name: Option<&str>) -> Vec<FunctionId> {
    let module = &compiled.module;
    let in_rust = |name| {
        let mut entries = compiled.interface.entries.iter();
        entries.find(|it| it.name == name).map_or(name, |it| it.rust.as_str())
    };
    let name = name.map(in_rust);
    let is_meant =
        |id: &FunctionId| name.is_none_or(|it| named(module, &module.functions[id.index()]) == it);
    all(module).filter(is_meant).collect()
}

/// Returns the words of a component before its first call: those of its constructor, or zeros, to which C initialises
/// static objects.
pub fn initial(module: &Module, component: &Type) -> Vec<u64> {
    let built = match component {
        Type::Struct(id) => module.structs[id.index()].initial.clone(),
        _ => None,
    };
    built.unwrap_or_else(|| vec![0; module.width(component)])
}
