//! Named sizes: lengths that callers see, as constants of the author.
//!
//! Such a constant is marked, `pub`, and a `usize`. C requires a constant expression as the bound of an array, so
//! each is a macro. They have a header of their own that includes nothing.

use std::collections::BTreeSet;

use bessemer_ir::{Const, ConstId, Given, Module, Type};

use super::options::Options;
use super::spelling::identifier;

/// Returns the header's name.
pub fn header(options: &Options) -> String {
    options.header(&format!("{}_sizes", identifier(&options.status)))
}

/// Returns the name of the header of names, which are macros for callers, too.
pub fn names_header(options: &Options) -> String {
    options.header(&format!("{}_names", identifier(&options.status)))
}

/// Returns true if a constant can be such a size.
pub fn is_one(item: &Const) -> bool {
    item.given.public && item.given.section.is_none() && item.ty == Type::USIZE
}

/// Returns the constants of names, `&str`: callers compare with any of them.
pub fn names(module: &Module) -> impl Iterator<Item = ConstId> {
    let is_name = module.consts.iter().map(Const::is_name).enumerate();
    is_name.filter(|(_, is_name)| *is_name).map(|(index, _)| ConstId(index as u32))
}

/// Returns the constants that name lengths in the module.
pub fn named(module: &Module) -> BTreeSet<ConstId> {
    let fields = module.structs.iter().flat_map(|it| &it.fields).map(|field| &field.given);
    let functions = module.functions.iter().map(|function| &function.attributes);
    let params = functions.clone().flat_map(|it| it.parameters.iter().map(|(_, given)| given));
    let all = fields.chain(params).chain(functions.map(|it| &it.result));
    all.flat_map(|given| sizes(module, given)).flatten().collect()
}

/// Returns the constants that name the lengths of an item, in order.
pub fn sizes(module: &Module, given: &Given) -> Vec<Option<ConstId>> {
    let constant = |path: &String| {
        let at = module.consts.iter().position(|it| is_one(it) && it.path() == *path)?;
        Some(ConstId(at as u32))
    };
    given.sizes.iter().map(constant).collect()
}
