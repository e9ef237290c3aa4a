//! Sizes by name: numbers of elements that callers see, by the constants that the author named for them.
//!
//! A constant is one of these for what it is: marked, `pub`, and a `usize`. C takes no object for the bound of an array, so
//! each is a macro, in a header that others include; it holds these alone, so that none needs another back.

use std::collections::BTreeSet;

use bessemer_ir::{Const, ConstId, Given, Module, Type};

use super::options::Options;
use super::spelling::identifier;

/// The header's name.
pub fn header(options: &Options) -> String {
    options.header(&format!("{}_sizes", identifier(&options.status)))
}

/// Returns true if a constant stands among them.
pub fn is_one(item: &Const) -> bool {
    item.given.public && item.given.section.is_none() && item.ty == Type::USIZE
}

/// The constants by which the module names sizes.
pub fn named(module: &Module) -> BTreeSet<ConstId> {
    let fields = module.structs.iter().flat_map(|it| &it.fields).map(|field| &field.given);
    let functions = module.functions.iter().map(|function| &function.attributes);
    let params = functions.clone().flat_map(|it| it.parameters.iter().map(|(_, given)| given));
    let all = fields.chain(params).chain(functions.map(|it| &it.result));
    all.flat_map(|given| sizes(module, given)).flatten().collect()
}

/// The constants of the sizes of something, in order.
pub fn sizes(module: &Module, given: &Given) -> Vec<Option<ConstId>> {
    let constant = |path: &String| {
        let at = module.consts.iter().position(|it| is_one(it) && it.path() == *path)?;
        Some(ConstId(at as u32))
    };
    given.sizes.iter().map(constant).collect()
}
