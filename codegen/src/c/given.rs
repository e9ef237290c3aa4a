//! The names that authors give to functions in the C: one that is taken is refused, not changed.

use std::collections::BTreeMap;

use bessemer_ir::{Module, Span};

use super::Options;
use super::names::Names;
use super::reserved::{is_keyword, is_reserved_globally};

/// What is wrong with a name that an author gave.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Taken {
    /// C, C++ or POSIX have it.
    #[error("`{0}` is a name that C, C++ or POSIX reserve")]
    Reserved(String),
    /// Something else of the package has it.
    #[error("two items would be `{0}` in the C")]
    Twice(String),
}

/// The names that cannot be given, each with the place of its function.
pub fn taken(module: &Module, options: &Options) -> Vec<(Span, Taken)> {
    let names = Names::new(module, options);
    let mut wanted: BTreeMap<&str, u32> = BTreeMap::new();
    let types = names.structs.iter().flat_map(|it| [Some(&it.ty), it.init.as_ref()]).flatten();
    let enums = names.enums.iter().flat_map(|it| it.variants.iter().chain([&it.ty]));
    let functions = names.functions.iter().map(|signature| &signature.name);
    for name in types.chain(enums).chain(functions).chain([&names.status.ty]) {
        *wanted.entry(name).or_default() += 1;
    }
    let given = module.functions.iter().filter_map(|function| {
        let name = function.attributes.name.as_deref()?;
        let taken = if is_keyword(name) || is_reserved_globally(name) {
            Taken::Reserved(name.to_owned())
        } else if wanted.get(name).is_some_and(|count| *count > 1) {
            Taken::Twice(name.to_owned())
        } else {
            return None;
        };
        Some((function.span, taken))
    });
    given.collect()
}
