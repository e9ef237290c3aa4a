//! The names that authors give in the C: one that is taken is refused, not changed.

use std::collections::BTreeMap;

use bessemer_ir::{ConstId, FunctionId, Given, Module, Span};

use super::Options;
use super::names::{Names, OVERLAY};
use super::reserved::{is_keyword, is_reserved_for_locals, is_reserved_globally};

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

/// The names that cannot be given, each with its place.
pub fn taken(module: &Module, options: &Options) -> Vec<(Span, Taken)> {
    let names = Names::new(module, options);
    let mut found = Found { wanted: wanted(&names), list: Vec::new() };
    found.types(module, &names);
    found.tables(module, &names);
    for (index, function) in module.functions.iter().enumerate() {
        let signature = names.signature(FunctionId(index as u32));
        if let Some(name) = &function.attributes.name {
            found.global(name, function.span);
        }
        for (local, param) in function.parameters().iter().zip(&signature.params) {
            if let Some(given) = function.attributes.parameter(&local.name) {
                found.local(given, &param.name, function.span);
            }
        }
        let output = signature.params.get(function.parameters().len());
        if let Some(output) = output {
            found.local(&function.attributes.result, &output.name, function.span);
        }
    }
    found.list
}

/// How many items want each name that is seen everywhere.
fn wanted(names: &Names) -> BTreeMap<String, u32> {
    let types = names.structs.iter().flat_map(|it| [Some(&it.ty), it.init.as_ref()]).flatten();
    let enums = names.enums.iter().flat_map(|it| it.variants.iter().chain([&it.ty]));
    let functions = names.functions.iter().map(|signature| &signature.name);
    let mut wanted = BTreeMap::new();
    for name in types.chain(enums).chain(functions).chain([&names.status.ty]) {
        *wanted.entry(name.clone()).or_default() += 1;
    }
    wanted
}

struct Found {
    wanted: BTreeMap<String, u32>,
    list: Vec<(Span, Taken)>,
}

impl Found {
    fn types(&mut self, module: &Module, names: &Names) {
        for (item, own) in module.structs.iter().zip(&names.structs) {
            if let Some(name) = &item.given.name {
                self.global(name, at(&item.given, item.span));
                if let Some(init) = &own.init {
                    self.global(init, at(&item.given, item.span));
                }
            }
            for (field, name) in item.fields.iter().zip(&own.fields) {
                let name = name.strip_prefix(OVERLAY).unwrap_or(name);
                let twice = own.fields.iter().filter(|it| it.trim_start_matches(OVERLAY) == name);
                if field.given.name.is_some() {
                    self.inner(name, at(&field.given, item.span), twice.count() > 1);
                }
            }
        }
        for item in &module.enums {
            if let Some(name) = &item.given.name {
                self.global(name, at(&item.given, item.span));
            }
            for variant in &item.variants {
                if let Some(name) = &variant.given.name {
                    self.global(name, at(&variant.given, item.span));
                }
            }
        }
    }

    fn tables(&mut self, module: &Module, names: &Names) {
        for (index, item) in module.consts.iter().enumerate() {
            let Some(name) = &item.given.name else { continue };
            let span = at(&item.given, item.span);
            if is_keyword(name) || is_reserved_globally(name) {
                self.list.push((span, Taken::Reserved(name.clone())));
            } else if self.wanted.contains_key(name) || names.renamed(ConstId(index as u32), name) {
                self.list.push((span, Taken::Twice(name.clone())));
            }
        }
    }

    /// A name that is seen everywhere.
    fn global(&mut self, name: &str, span: Span) {
        if is_keyword(name) || is_reserved_globally(name) {
            self.list.push((span, Taken::Reserved(name.to_owned())));
        } else if self.wanted.get(name).is_some_and(|count| *count > 1) {
            self.list.push((span, Taken::Twice(name.to_owned())));
        }
    }

    /// The name of a field.
    fn inner(&mut self, name: &str, span: Span, twice: bool) {
        if is_keyword(name) {
            self.list.push((span, Taken::Reserved(name.to_owned())));
        } else if twice {
            self.list.push((span, Taken::Twice(name.to_owned())));
        }
    }

    /// The name of a parameter, and what it became.
    fn local(&mut self, given: &Given, became: &str, function: Span) {
        let Some(name) = &given.name else { return };
        let span = at(given, function);
        if is_reserved_for_locals(name) {
            self.list.push((span, Taken::Reserved(name.clone())));
        } else if name != became {
            self.list.push((span, Taken::Twice(name.clone())));
        }
    }
}

/// Where a name stands; in a file that is not known to be another than its item's.
fn at(given: &Given, item: Span) -> Span {
    match given.site.0 {
        0 => item,
        line => Span { file: item.file, line, column: given.site.1 },
    }
}
