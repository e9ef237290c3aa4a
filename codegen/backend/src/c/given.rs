//! Checks the C names that authors choose: a conflicting name is refused, not changed. A conflict between two
//! generated names is refused, too.

use std::collections::BTreeMap;

use bessemer_ir::{ConstId, FunctionId, Given, Module, Span};

use super::helpers::is_helper_name;
use super::names::{Names, OVERLAY};
use super::reserved::{is_keyword, is_reserved_for_locals, is_reserved_globally};
use super::tree::Storage;

/// Conflict of a name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Taken {
    /// A reserved name of C, C++ or POSIX.
    #[error("`{0}` is a name that C, C++ or POSIX reserve")]
    Reserved(String),
    /// The name of a possible helper function.
    #[error("`{0}` is what the C calls a helper of its own")]
    Helper(String),
    /// The name of another item of the package.
    #[error("two items would be `{0}` in the C")]
    Twice(String),
    /// A generated name that two items of the package would have.
    #[error("two items would be `{0}` in the C")]
    Made(String),
}

/// A conflict of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// Place of the name, or of its item.
    pub span: Span,
    /// The conflict.
    pub taken: Taken,
    /// Places of the other items that would have the name.
    pub others: Vec<Span>,
    /// Fields of the item at the place that would have the name, by their names in Rust; the first is the one reported.
    pub fields: Vec<String>,
}

/// Returns all conflicts, each with its places.
pub fn conflicts(module: &Module, names: &Names) -> Vec<Conflict> {
    let mut found = Found { wanted: wanted(module, names), list: Vec::new() };
    found.types(module, names);
    found.tables(module, names);
    for (index, function) in module.functions.iter().enumerate() {
        let signature = names.signature(FunctionId(index as u32));
        if let Some(name) = &function.attributes.name {
            found.global(name, function.span);
        } else if signature.storage != Storage::Static {
            found.made(&signature.name, function.span);
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
    // A name that the author chose is the one reported.
    let (made, mut list): (Vec<_>, Vec<_>) =
        found.list.into_iter().partition(|it| matches!(it.taken, Taken::Made(_)));
    let known =
        |name: &str| list.iter().any(|it| matches!(&it.taken, Taken::Twice(own) if own == name));
    let alone = |it: &Conflict| !matches!(&it.taken, Taken::Made(name) if known(name));
    let alone: Vec<_> = made.into_iter().filter(alone).collect();
    list.extend(alone);
    list.dedup();
    list
}

/// Number of characters that are significant in external names for every linker (C99, 5.2.4.1; MISRA C:2012, rule 5.1).
const SIGNIFICANT: usize = 31;

/// Returns the functions whose external names begin as an earlier one's, as far as every linker looks: the place, the
/// name and the earlier name.
pub fn alike(module: &Module, names: &Names) -> Vec<(Span, String, String)> {
    let mut earlier: BTreeMap<&str, &str> = BTreeMap::new();
    let mut alike = Vec::new();
    for (function, signature) in module.functions.iter().zip(&names.functions) {
        let name = signature.name.as_str();
        let Some(begin) = name.get(..SIGNIFICANT) else { continue };
        if signature.storage != Storage::Extern {
            continue;
        }
        match earlier.get(begin) {
            Some(first) => alike.push((function.span, name.to_owned(), (*first).to_owned())),
            None => {
                earlier.insert(begin, name);
            }
        }
    }
    alike
}

/// Returns the places of the items that request each global name; the type of the status has none.
fn wanted(module: &Module, names: &Names) -> BTreeMap<String, Vec<Span>> {
    let types = module.structs.iter().zip(&names.structs).flat_map(|(item, own)| {
        let span = at(&item.given, item.span);
        [Some(&own.ty), own.init.as_ref()].into_iter().flatten().map(move |name| (name, span))
    });
    let enums = module.enums.iter().zip(&names.enums).flat_map(|(item, own)| {
        let variants = item.variants.iter().zip(&own.variants);
        let variants = variants.map(|(variant, name)| (name, at(&variant.given, item.span)));
        variants.chain([(&own.ty, at(&item.given, item.span))])
    });
    let functions = module.functions.iter().zip(&names.functions);
    let functions = functions.map(|(function, signature)| (&signature.name, function.span));
    let status = [(&names.status.ty, Span::default())];
    let mut wanted: BTreeMap<String, Vec<Span>> = BTreeMap::new();
    for (name, span) in types.chain(enums).chain(functions).chain(status) {
        wanted.entry(name.clone()).or_default().push(span);
    }
    wanted
}

struct Found {
    wanted: BTreeMap<String, Vec<Span>>,
    list: Vec<Conflict>,
}

impl Found {
    fn types(&mut self, module: &Module, names: &Names) {
        for (item, own) in module.structs.iter().zip(&names.structs) {
            if item.given.name.is_none() {
                self.made(&own.ty, item.span);
            } else {
                let span = at(&item.given, item.span);
                self.global(&own.ty, span);
                own.init.iter().for_each(|init| self.global(init, span));
            }
            for (field, name) in item.fields.iter().zip(&own.fields) {
                let name = name.strip_prefix(OVERLAY).unwrap_or(name);
                let others = item.fields.iter().zip(&own.fields).filter(|(other, own)| {
                    other.name != field.name && own.trim_start_matches(OVERLAY) == name
                });
                let others: Vec<String> = others.map(|(other, _)| other.name.clone()).collect();
                let own = &field.given;
                if own.name.is_some() && is_keyword(name) {
                    self.note(at(own, item.span), Taken::Reserved(name.to_owned()), &[]);
                } else if !others.is_empty() {
                    let (span, taken) = match own.name {
                        Some(_) => (at(own, item.span), Taken::Twice(name.to_owned())),
                        None => (item.span, Taken::Made(name.to_owned())),
                    };
                    let fields = std::iter::once(field.name.clone()).chain(others).collect();
                    self.note_fields(span, taken, fields);
                }
            }
        }
        for (item, own) in module.enums.iter().zip(&names.enums) {
            match item.given.name.is_some() {
                true => self.global(&own.ty, at(&item.given, item.span)),
                false => self.made(&own.ty, item.span),
            }
            for (variant, name) in item.variants.iter().zip(&own.variants) {
                match variant.given.name.is_some() {
                    true => self.global(name, at(&variant.given, item.span)),
                    false => self.made(name, item.span),
                }
            }
        }
    }

    fn tables(&mut self, module: &Module, names: &Names) {
        for (index, item) in module.consts.iter().enumerate() {
            let Some(name) = &item.given.name else { continue };
            let span = at(&item.given, item.span);
            if is_keyword(name) || is_reserved_globally(name) {
                self.note(span, Taken::Reserved(name.clone()), &[]);
            } else if self.wanted.contains_key(name) || names.renamed(ConstId(index as u32), name) {
                let others = self.wanted.get(name).cloned().unwrap_or_default();
                self.note(span, Taken::Twice(name.clone()), &others);
            }
        }
    }

    /// Adds a conflict with the items at other places.
    fn note(&mut self, span: Span, taken: Taken, others: &[Span]) {
        let others = others.iter().copied().filter(|it| *it != span && it.line > 0).collect();
        self.list.push(Conflict { span, taken, others, fields: Vec::new() });
    }

    /// Adds a conflict between fields of one item.
    fn note_fields(&mut self, span: Span, taken: Taken, fields: Vec<String>) {
        self.list.push(Conflict { span, taken, others: Vec::new(), fields });
    }

    /// Returns true if two items would have this name.
    fn is_twice(&self, name: &str) -> bool {
        self.wanted.get(name).is_some_and(|all| all.len() > 1)
    }

    /// Checks a generated global name.
    fn made(&mut self, name: &str, span: Span) {
        if self.is_twice(name) {
            let others = self.wanted[name].clone();
            self.note(span, Taken::Made(name.to_owned()), &others);
        }
    }

    /// Checks a global name of the author's.
    fn global(&mut self, name: &str, span: Span) {
        if is_keyword(name) || is_reserved_globally(name) {
            self.note(span, Taken::Reserved(name.to_owned()), &[]);
        } else if is_helper_name(name) {
            self.note(span, Taken::Helper(name.to_owned()), &[]);
        } else if self.is_twice(name) {
            let others = self.wanted[name].clone();
            self.note(span, Taken::Twice(name.to_owned()), &others);
        }
    }

    /// Checks the name of a parameter against the name that it got.
    fn local(&mut self, given: &Given, became: &str, function: Span) {
        let Some(name) = &given.name else { return };
        let span = at(given, function);
        if is_reserved_for_locals(name) {
            self.note(span, Taken::Reserved(name.clone()), &[]);
        } else if name != became {
            self.note(span, Taken::Twice(name.clone()), &[]);
        }
    }
}

/// Returns the span of a name, or of its item if it has none.
fn at(given: &Given, item: Span) -> Span {
    match given.site.0 {
        0 => item,
        line => Span { line, column: given.site.1, ..item },
    }
}
