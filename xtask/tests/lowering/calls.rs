//! The circle of files that call each other, by methods and by functions. Imports do not show it: a method needs none.
//!
//! A method is found by the type of its receiver, where that is written: `self`, a parameter, a variable that is made as
//! a struct, a field of one of the types here. Elsewhere each type that has such a method counts, unless the name is also
//! one of std's, of the IR's or of the tree's.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{self, Visit};

use super::modules::{Module, circles, is_test};
use super::types::{methods, name_of};
use super::{Files, parsed, root};

/// Names of std's methods.
const OF_STD: [&str; 13] = [
    "copied", "count", "entry", "is_empty", "iter", "len", "map", "nth", "ok", "or", "rev",
    "value", "zip",
];

/// Returns the files of all circles.
pub fn circle(files: &Files) -> Vec<String> {
    let index = Index::of(files);
    let graph: BTreeMap<Module, BTreeSet<Module>> = files
        .iter()
        .map(|(module, file)| {
            let mut calls = Calls {
                index: &index,
                own: None,
                types: Vec::new(),
                imports: BTreeMap::new(),
                found: BTreeSet::new(),
            };
            calls.visit_file(file);
            calls.found.remove(module);
            (module.clone(), calls.found)
        })
        .collect();
    let shown = |module: &Module| match module.is_empty() {
        true => "mod".to_owned(),
        false => module.join("::"),
    };
    circles(&graph).iter().flatten().map(|it| shown(it)).collect()
}

/// Definitions of all files.
#[derive(Default)]
struct Index {
    /// The types with a method of a name, and the files where.
    methods: BTreeMap<String, BTreeMap<String, BTreeSet<Module>>>,
    /// The files with a function of a name that others may call.
    functions: BTreeMap<String, BTreeSet<Module>>,
    /// The types of fields, by struct and name.
    fields: BTreeMap<(String, String), String>,
    /// The methods of other crates, as far as their names tell.
    foreign: BTreeSet<String>,
}

impl Index {
    fn of(files: &Files) -> Index {
        let mut index = Index::default();
        index.foreign.extend(OF_STD.map(str::to_owned));
        for folder in ["codegen/ir/src", "dsl/tree/src"] {
            for file in parsed(&root().join(folder)).values() {
                let impls = file.items.iter().filter_map(as_impl);
                index.foreign.extend(impls.flat_map(methods).map(|it| it.sig.ident.to_string()));
            }
        }
        for (module, file) in files {
            for item in &file.items {
                index.note(module, item);
            }
        }
        index
    }

    fn note(&mut self, module: &Module, item: &syn::Item) {
        match item {
            syn::Item::Impl(it) if it.trait_.is_none() => {
                let Some(name) = name_of(&it.self_ty, None) else { return };
                for method in methods(it) {
                    let types = self.methods.entry(method.sig.ident.to_string()).or_default();
                    types.entry(name.clone()).or_default().insert(module.clone());
                }
            }
            syn::Item::Fn(it) => {
                let files = self.functions.entry(it.sig.ident.to_string()).or_default();
                files.insert(module.clone());
            }
            syn::Item::Struct(it) => {
                for field in &it.fields {
                    if let (Some(name), Some(ty)) = (&field.ident, name_of(&field.ty, None)) {
                        self.fields.insert((it.ident.to_string(), name.to_string()), ty);
                    }
                }
            }
            _ => {}
        }
    }
}

fn as_impl(item: &syn::Item) -> Option<&syn::ItemImpl> {
    match item {
        syn::Item::Impl(it) => Some(it),
        _ => None,
    }
}

/// Notes the modules from which a `use` takes names.
fn import(
    module: Option<&syn::Ident>,
    tree: &syn::UseTree,
    imports: &mut BTreeMap<String, String>,
) {
    match tree {
        syn::UseTree::Path(it) => import(Some(&it.ident), &it.tree, imports),
        syn::UseTree::Group(it) => it.items.iter().for_each(|it| import(module, it, imports)),
        syn::UseTree::Name(it) => {
            imports.extend(module.map(|module| (it.ident.to_string(), module.to_string())));
        }
        syn::UseTree::Rename(_) | syn::UseTree::Glob(_) => {}
    }
}

/// Visitor that collects the files that one file calls.
struct Calls<'i> {
    index: &'i Index,
    /// The type of `self`.
    own: Option<String>,
    /// The types of parameters, by name, of the functions around.
    types: Vec<(String, Option<String>)>,
    /// The modules that imported names come from.
    imports: BTreeMap<String, String>,
    found: BTreeSet<Module>,
}

impl Calls<'_> {
    /// The type of a receiver: none if it is not written, and no name if it is none that is defined here.
    fn receiver(&self, expr: &syn::Expr) -> Option<String> {
        match expr {
            syn::Expr::Path(it) => {
                let name = it.path.get_ident()?.to_string();
                match name == "self" {
                    true => self.own.clone(),
                    false => self.types.iter().rev().find(|it| it.0 == name)?.1.clone(),
                }
            }
            syn::Expr::Field(it) => {
                let syn::Member::Named(name) = &it.member else { return None };
                match self.receiver(&it.base) {
                    Some(base) => self.index.fields.get(&(base, name.to_string())).cloned(),
                    None => {
                        let fields = self.index.fields.iter();
                        let mut types = fields.filter(|it| name == &it.0.1).map(|it| it.1);
                        let first = types.next()?;
                        types.all(|it| it == first).then(|| first.clone())
                    }
                }
            }
            syn::Expr::Paren(it) => self.receiver(&it.expr),
            syn::Expr::Reference(it) => self.receiver(&it.expr),
            _ => None,
        }
    }

    fn method(&mut self, ty: Option<&str>, name: &str) {
        let Some(types) = self.index.methods.get(name) else { return };
        match ty {
            Some(ty) => self.found.extend(types.get(ty).into_iter().flatten().cloned()),
            None if self.index.foreign.contains(name) => {}
            None => self.found.extend(types.values().flatten().cloned()),
        }
    }

    /// Notes where a function is that this file imports by its name, or names in a module.
    fn function(&mut self, before: &[String], name: &str) {
        let Some(files) = self.index.functions.get(name) else { return };
        let module = before.last().or_else(|| self.imports.get(name));
        let named = |file: &&Module| file.last() == module;
        if module.is_some() {
            self.found.extend(files.iter().filter(named).cloned());
        }
    }

    fn inside(&mut self, signature: &syn::Signature, visit: impl FnOnce(&mut Self)) {
        let before = self.types.len();
        for input in &signature.inputs {
            if let syn::FnArg::Typed(it) = input {
                self.typed(&it.pat, Some(&it.ty));
            }
        }
        visit(self);
        self.types.truncate(before);
    }

    fn typed(&mut self, pat: &syn::Pat, ty: Option<&syn::Type>) {
        match (pat, ty) {
            (syn::Pat::Ident(it), ty) => {
                let ty = ty.and_then(|ty| name_of(ty, self.own.as_deref()));
                self.types.push((it.ident.to_string(), ty));
            }
            (syn::Pat::Type(it), _) => self.typed(&it.pat, Some(&it.ty)),
            _ => {}
        }
    }
}

impl<'ast> Visit<'ast> for Calls<'_> {
    fn visit_item_use(&mut self, it: &'ast syn::ItemUse) {
        import(None, &it.tree, &mut self.imports);
    }

    fn visit_item_impl(&mut self, it: &'ast syn::ItemImpl) {
        let own = name_of(&it.self_ty, None);
        let outer = std::mem::replace(&mut self.own, own);
        visit::visit_item_impl(self, it);
        self.own = outer;
    }

    fn visit_item_mod(&mut self, it: &'ast syn::ItemMod) {
        if !is_test(&it.attrs) {
            visit::visit_item_mod(self, it);
        }
    }

    fn visit_item_fn(&mut self, it: &'ast syn::ItemFn) {
        self.inside(&it.sig, |inner| visit::visit_item_fn(inner, it));
    }

    fn visit_impl_item_fn(&mut self, it: &'ast syn::ImplItemFn) {
        self.inside(&it.sig, |inner| visit::visit_impl_item_fn(inner, it));
    }

    fn visit_expr_closure(&mut self, it: &'ast syn::ExprClosure) {
        let before = self.types.len();
        it.inputs.iter().for_each(|input| self.typed(input, None));
        visit::visit_expr_closure(self, it);
        self.types.truncate(before);
    }

    fn visit_local(&mut self, it: &'ast syn::Local) {
        visit::visit_local(self, it);
        self.typed(&it.pat, None);
        if let (Some(syn::Expr::Struct(made)), Some(typed)) =
            (it.init.as_ref().map(|init| &*init.expr), self.types.last_mut())
        {
            typed.1 = made.path.segments.last().map(|it| it.ident.to_string());
        }
    }

    fn visit_expr_method_call(&mut self, it: &'ast syn::ExprMethodCall) {
        let ty = self.receiver(&it.receiver);
        self.method(ty.as_deref(), &it.method.to_string());
        visit::visit_expr_method_call(self, it);
    }

    fn visit_expr_path(&mut self, it: &'ast syn::ExprPath) {
        let names: Vec<String> = it.path.segments.iter().map(|it| it.ident.to_string()).collect();
        let Some((last, before)) = names.split_last() else { return };
        match before.last().map(String::as_str) {
            Some("Self") => self.method(self.own.clone().as_deref(), last),
            Some(ty) if ty.starts_with(char::is_uppercase) => self.method(Some(ty), last),
            _ => self.function(before, last),
        }
    }
}
