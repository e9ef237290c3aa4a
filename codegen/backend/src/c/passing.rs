//! C signatures of functions: parameters, their names, and results.
//!
//! A parameter gives way to functions, types, variants and constants with the same name, so these are named first.

use bessemer_ir::{ConstId, Function, FunctionId, Given, Mode, Module, Type};

use super::analysis::Faults;
use super::names::{Names, local_name};
use super::signature::{Param, Passing, Returned};
use super::sizes;
use super::spelling::unique;

impl Names {
    /// Names the parameters of every function.
    pub(super) fn name_parameters(&mut self, module: &Module, faults: &Faults) {
        for (index, function) in module.functions.iter().enumerate() {
            // A kernel's text is written for its parameters' own names.
            let kernel = function.kernel.is_some();
            let taken = |name: &str| !kernel && self.is_global(name);
            let fallible = faults.fallible(FunctionId(index as u32));
            let sizes = |given: &Given| sizes::sizes(module, given);
            let (params, returned) = passing(function, fallible, &taken, &sizes);
            let signature = &mut self.functions[index];
            (signature.params, signature.returned) = (params, returned);
        }
    }
}

/// Returns the parameters and the returned type.
fn passing(
    function: &Function,
    fallible: bool,
    taken: &dyn Fn(&str) -> bool,
    sizes: &dyn Fn(&Given) -> Vec<Option<ConstId>>,
) -> (Vec<Param>, Returned) {
    let mut params: Vec<Param> = Vec::new();
    for local in function.parameters() {
        let given = function.attributes.parameter(&local.name);
        let sizes = given.map(sizes).unwrap_or_default();
        let given = given.and_then(|given| given.name.clone());
        let wanted = given.unwrap_or_else(|| local_name(&local.name));
        let name =
            unique(&wanted, |name| taken(name) || params.iter().any(|param| param.name == name));
        let passing = match (local.mode, local.ty.is_word()) {
            (Mode::RefMut, _) => Passing::InOut,
            (_, true) => Passing::Value,
            (_, false) => Passing::Input,
        };
        params.push(Param { name, ty: local.ty.clone(), sizes, passing });
    }
    let result = &function.result;
    if *result != Type::Unit && (fallible || result.is_aggregate()) {
        let used = |name: &str| taken(name) || params.iter().any(|param| param.name == name);
        let wanted = local_name(&function.result_name);
        let unnamed = matches!(function.result_name.as_str(), "" | "_") || used(&wanted);
        let name = unique(if unnamed { "result" } else { &wanted }, used);
        let sizes = sizes(&function.attributes.result);
        params.push(Param { name, ty: result.clone(), sizes, passing: Passing::Output });
    }
    let returned = match (fallible, result.is_word()) {
        (true, _) => Returned::Status,
        (false, true) => Returned::Value(result.clone()),
        (false, false) => Returned::Nothing,
    };
    (params, returned)
}
