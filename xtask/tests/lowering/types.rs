//! The types of the front half: their fields and their methods.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{self, Visit};

use super::Files;
use super::modules::is_test;

/// Returns the greatest number of fields of a struct, and of methods of a type, each with the type.
pub fn largest(files: &Files) -> [(usize, String); 2] {
    let mut found = Sizes::default();
    files.values().for_each(|file| found.visit_file(file));
    let most = |of: BTreeMap<String, usize>| {
        let most = of.into_iter().max_by_key(|(_, count)| *count);
        most.map_or_else(Default::default, |(name, count)| (count, name))
    };
    [most(found.fields), most(found.methods)]
}

#[derive(Default)]
struct Sizes {
    fields: BTreeMap<String, usize>,
    methods: BTreeMap<String, usize>,
}

impl Visit<'_> for Sizes {
    fn visit_item_struct(&mut self, it: &syn::ItemStruct) {
        self.fields.insert(it.ident.to_string(), it.fields.len());
    }

    fn visit_item_impl(&mut self, it: &syn::ItemImpl) {
        if let (None, Some(name)) = (&it.trait_, name_of(&it.self_ty, None)) {
            *self.methods.entry(name).or_default() += methods(it).count();
        }
    }

    fn visit_item_mod(&mut self, it: &syn::ItemMod) {
        if !is_test(&it.attrs) {
            visit::visit_item_mod(self, it);
        }
    }
}

/// Returns the functions of an `impl`.
pub fn methods(of: &syn::ItemImpl) -> impl Iterator<Item = &syn::ImplItemFn> {
    of.items.iter().filter_map(|item| match item {
        syn::ImplItem::Fn(it) => Some(it),
        _ => None,
    })
}

/// Returns the name of a type: of a reference, or of what holds others, the name of what it refers to or holds. `own` is
/// the name of `Self`.
pub fn name_of(ty: &syn::Type, own: Option<&str>) -> Option<String> {
    match ty {
        syn::Type::Reference(it) => name_of(&it.elem, own),
        syn::Type::Path(it) => {
            let last = it.path.segments.last()?;
            let name = last.ident.to_string();
            let inner = match &last.arguments {
                syn::PathArguments::AngleBracketed(them) => {
                    them.args.iter().find_map(|it| match it {
                        syn::GenericArgument::Type(ty) => Some(ty),
                        _ => None,
                    })
                }
                _ => None,
            };
            match (name.as_str(), inner) {
                ("Box" | "Rc" | "Option", Some(inner)) => name_of(inner, own),
                ("Self", _) => own.map(str::to_owned),
                _ => Some(name),
            }
        }
        _ => None,
    }
}

/// Returns the names of all functions, methods, structs and enums that a file defines.
pub fn defined(file: &syn::File) -> BTreeSet<String> {
    let mut found = Defined(BTreeSet::new());
    found.visit_file(file);
    found.0
}

struct Defined(BTreeSet<String>);

impl Visit<'_> for Defined {
    fn visit_signature(&mut self, it: &syn::Signature) {
        self.0.insert(it.ident.to_string());
    }

    fn visit_item_struct(&mut self, it: &syn::ItemStruct) {
        self.0.insert(it.ident.to_string());
    }

    fn visit_item_enum(&mut self, it: &syn::ItemEnum) {
        self.0.insert(it.ident.to_string());
    }
}
