//! Named sizes: lengths and indices that callers see, as constants of the author.
//!
//! Such a constant is marked, `pub`, and a `usize`; its derive marks the indices of a state. C requires a constant
//! expression as the bound of an array, so
//! each is a macro. They have a header of their own that includes nothing.

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

/// Returns the constants that are sizes, whether a function reads them or not.
pub fn all(module: &Module) -> impl Iterator<Item = ConstId> {
    let is_one = module.consts.iter().map(is_one).enumerate();
    is_one.filter(|(_, is_one)| *is_one).map(|(index, _)| ConstId(index as u32))
}

/// Returns the constants that name the lengths of an item, in order.
pub fn sizes(module: &Module, given: &Given) -> Vec<Option<ConstId>> {
    let constant = |path: &String| {
        let at = module.consts.iter().position(|it| is_one(it) && it.path() == *path)?;
        Some(ConstId(at as u32))
    };
    given.sizes.iter().map(constant).collect()
}
