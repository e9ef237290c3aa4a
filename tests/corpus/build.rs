//! Finds the programs: every file below `src/programs` is a module, and every function and entry point in
//! it that can be called with words is listed, so that dropping in a file adds a test.
//!
//! A folder is a module of its files; a folder with a `mod.rs` is one program. What several programs have in
//! common stands in a file that they `include!`.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use quote::{ToTokens as _, format_ident, quote};
use syn::{FnArg, ImplItem, Item, ReturnType, Signature, Type, Visibility};

fn main() -> io::Result<()> {
    let programs = Path::new(&std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default())
        .join("src")
        .join("programs");
    println!("cargo::rerun-if-changed={}", programs.display());
    let mut found = Found::default();
    found.folder(&programs, &mut Vec::new())?;
    let (modules, entries) = (found.modules, found.entries);
    let entries = entries.iter().map(|entry| format!("    {entry},\n")).collect::<String>();
    let text = format!(
        "{modules}\n/// Every function and entry point of the programs.\n\
         pub const ENTRIES: &[crate::Entry] = &[\n{entries}];\n"
    );
    let output = PathBuf::from(std::env::var("OUT_DIR").unwrap_or_default()).join("programs.rs");
    fs::write(output, text)
}

#[derive(Default)]
struct Found {
    /// The text of the modules.
    modules: String,
    /// The text of each entry.
    entries: Vec<String>,
}

impl Found {
    fn folder(&mut self, folder: &Path, at: &mut Vec<String>) -> io::Result<()> {
        let mut paths = fs::read_dir(folder)?
            .map(|entry| entry.map(|entry| entry.path()))
            .collect::<io::Result<Vec<_>>>()?;
        paths.sort();
        for path in paths {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_dir() && path.join("mod.rs").exists() {
                self.module(&path.join("mod.rs"), &name, at)?;
            } else if path.is_dir() {
                self.modules.push_str(&format!("#[allow(missing_docs)]\npub mod {name} {{\n"));
                at.push(name);
                self.folder(&path, at)?;
                at.pop();
                self.modules.push_str("}\n");
            } else if path.extension().is_some_and(|it| it == "rs") {
                self.module(&path, &name, at)?;
            }
        }
        Ok(())
    }

    fn module(&mut self, path: &Path, name: &str, at: &mut Vec<String>) -> io::Result<()> {
        self.modules.push_str(&format!("#[path = {path:?}]\npub mod {name};\n"));
        at.push(name.to_owned());
        // A file that does not parse is rustc's to tell of.
        if let Ok(file) = syn::parse_file(&fs::read_to_string(path)?) {
            self.items(&file.items, &at.join("::"));
            for shared in file.items.iter().filter_map(included) {
                let text = fs::read_to_string(path.with_file_name(shared))?;
                if let Ok(file) = syn::parse_file(&text) {
                    self.items(&file.items, &at.join("::"));
                }
            }
        }
        at.pop();
        Ok(())
    }

    fn items(&mut self, items: &[Item], module: &str) {
        for item in items {
            match item {
                Item::Fn(it) if marked(&it.attrs, "function") && public(&it.vis) => {
                    self.entries.extend(entry(module, None, &[], &it.sig));
                }
                Item::Impl(it) if marked(&it.attrs, "component") && it.trait_.is_none() => {
                    let owners = owners(it, items);
                    for method in it.items.iter().filter_map(|item| match item {
                        ImplItem::Fn(method) if marked(&method.attrs, "entry") => Some(method),
                        _ => None,
                    }) {
                        let entries = owners.iter().filter_map(|(owner, stand_for)| {
                            entry(module, Some(owner), stand_for, &method.sig)
                        });
                        self.entries.extend(entries);
                    }
                }
                _ => {}
            }
        }
    }
}

/// The file that `include!("…")` brings.
fn included(item: &Item) -> Option<String> {
    match item {
        Item::Macro(it) if it.mac.path.is_ident("include") => {
            it.mac.parse_body::<syn::LitStr>().ok().map(|name| name.value())
        }
        _ => None,
    }
}

/// The types whose methods stand in an `impl` block: the instances of something generic by their names,
/// each with what its parameters stand for.
fn owners(block: &syn::ItemImpl, items: &[Item]) -> Vec<(Type, Vec<Item>)> {
    if block.generics.params.is_empty() {
        return vec![((*block.self_ty).clone(), Vec::new())];
    }
    let Some((generic, _)) = path_of(&block.self_ty) else { return Vec::new() };
    let instances = items.iter().filter_map(|item| match item {
        Item::Type(it) if marked(&it.attrs, "component") => Some(it),
        _ => None,
    });
    let named = instances.filter_map(|it| {
        let (of, arguments) = path_of(&it.ty)?;
        let params = block.generics.params.iter().zip(arguments);
        let stand_for = params.filter_map(|(param, argument)| match param {
            syn::GenericParam::Const(it) => {
                let (name, ty) = (&it.ident, &it.ty);
                Some(syn::parse_quote!(const #name: #ty = #argument;))
            }
            syn::GenericParam::Type(it) => {
                let name = &it.ident;
                Some(syn::parse_quote!(type #name = #argument;))
            }
            syn::GenericParam::Lifetime(_) => None,
        });
        let name = &it.ident;
        (of == generic).then(|| (syn::parse_quote!(#name), stand_for.collect()))
    });
    named.collect()
}

/// The last name of a path, and its arguments.
fn path_of(ty: &Type) -> Option<(String, Vec<syn::GenericArgument>)> {
    let Type::Path(it) = ty else { return None };
    let last = it.path.segments.last()?;
    let syn::PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
    Some((last.ident.to_string(), arguments.args.iter().cloned().collect()))
}

fn marked(attributes: &[syn::Attribute], name: &str) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().segments.last().is_some_and(|segment| segment.ident == name)
    })
}

fn public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The text of a `crate::Entry`; none for generic functions, which are called by others.
fn entry(
    module: &str,
    component: Option<&Type>,
    stand_for: &[Item],
    signature: &Signature,
) -> Option<String> {
    if signature.generics.params.iter().any(|it| !matches!(it, syn::GenericParam::Lifetime(_))) {
        return None;
    }
    let path: syn::Path = syn::parse_str(&format!("crate::programs::{module}")).ok()?;
    let name = &signature.ident;
    let (mut loads, mut arguments, mut stores) = (Vec::new(), Vec::new(), Vec::new());
    for (index, input) in signature.inputs.iter().enumerate() {
        let FnArg::Typed(input) = input else { continue };
        // Words do not say how long a slice is: its callers are run.
        if matches!(&*input.ty, Type::Reference(it) if matches!(*it.elem, Type::Slice(_))) {
            return None;
        }
        let local = format_ident!("argument_{index}");
        let (ty, pass) = match &*input.ty {
            Type::Reference(it) if it.mutability.is_some() => (&*it.elem, quote!(&mut #local)),
            Type::Reference(it) => (&*it.elem, quote!(&#local)),
            ty => (ty, quote!(#local)),
        };
        loads.push(quote!(let mut #local = <#ty as bessemer::Plain>::load(__next);));
        if matches!(&*input.ty, Type::Reference(it) if it.mutability.is_some()) {
            stores.push(quote!(bessemer::Plain::store(&#local, __out);));
        }
        arguments.push(pass);
    }
    let callee = match component {
        Some(_) => quote!(this.#name),
        None => quote!(#path::#name),
    };
    let call = quote!(#callee(#(#arguments),*));
    let call = match &signature.output {
        ReturnType::Default => quote!(#call;),
        ReturnType::Type(..) => quote!(let result = #call; bessemer::Plain::store(&result, __out);),
    };
    let (load, store, initial, owner) = match component {
        Some(ty) => (
            quote!(let mut this = <#ty as bessemer::Plain>::load(__next);),
            quote!(bessemer::Plain::store(&this, __out);),
            quote!(bessemer::Plain::store(&<#ty as Default>::default(), __out)),
            ty.to_token_stream().to_string(),
        ),
        None => (quote!(), quote!(), quote!(()), String::new()),
    };
    let (name, module) = (name.to_string(), format!("corpus::programs::{module}"));
    let entry = quote! {
        crate::Entry {
            module: #module,
            component: #owner,
            name: #name,
            run: {
                #[allow(unused_imports, unused_mut, unused_variables, dead_code, clippy::all)]
                fn run(__next: &mut dyn FnMut() -> u64, __out: &mut dyn FnMut(u64)) {
                    use bessemer::prelude::*;
                    use #path::*;
                    #(#stand_for)*
                    #load #(#loads)* #call #store #(#stores)*
                }
                run
            },
            initial: {
                #[allow(unused_imports, unused_variables)]
                fn initial(__out: &mut dyn FnMut(u64)) {
                    use bessemer::prelude::*;
                    use #path::*;
                    #initial
                }
                initial
            },
        }
    };
    Some(entry.to_string())
}
