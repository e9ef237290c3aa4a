//! Finds what of a program can be called with words: its functions, the entry points of its components, the methods of
//! its plain data. For the build scripts that list the programs of a crate.

use proc_macro2::TokenStream;
use quote::{ToTokens as _, format_ident, quote};
use syn::{FnArg, ImplItem, Item, ReturnType, Signature, Type, Visibility};

/// The entries of a crate's programs.
pub struct Entries {
    /// The crate.
    pub root: &'static str,
    /// True if methods of plain data are called by themselves, too.
    pub methods: bool,
    /// Each as the text of a `crate::Entry`.
    pub found: Vec<String>,
}

/// Function of an entry.
struct Callee<'a> {
    /// The path of its module within `programs`.
    module: &'a str,
    /// The type that it is a method of, with what the parameters of that stand for.
    owner: Option<(&'a Type, &'a [Item])>,
    /// True if that is a component.
    component: bool,
    signature: &'a Signature,
}

impl Entries {
    /// Adds those of the items of `module`.
    pub fn items(&mut self, items: &[Item], module: &str) {
        for item in items {
            match item {
                Item::Fn(it) if marked(&it.attrs, "function") && public(&it.vis) => {
                    let signature = &it.sig;
                    let callee = Callee { module, owner: None, component: false, signature };
                    self.found.extend(self.entry(&callee, quote!(())));
                }
                Item::Impl(it) if it.trait_.is_none() => self.block(it, items, module),
                _ => {}
            }
        }
    }

    fn block(&mut self, it: &syn::ItemImpl, items: &[Item], module: &str) {
        let component = marked(&it.attrs, "component");
        if !(component || self.methods && marked(&it.attrs, "data")) {
            return;
        }
        let owners = owners(it, items);
        for item in &it.items {
            let ImplItem::Fn(method) = item else { continue };
            let chosen = match component {
                true => marked(&method.attrs, "entry"),
                false => public(&method.vis),
            };
            for (owner, stand_for) in owners.iter().filter(|_| chosen) {
                let signature = &method.sig;
                let owner = Some((owner, stand_for.as_slice()));
                let callee = Callee { module, owner, component, signature };
                let initial = match component {
                    true => Some(quote!(<__Owner as Default>::default())),
                    false => initial(it, items),
                };
                let initial = match initial {
                    Some(value) => quote!(bessemer::Plain::store(&#value, __out)),
                    None => quote!(()),
                };
                self.found.extend(self.entry(&callee, initial));
            }
        }
    }

    /// The text of a `crate::Entry`; none for generic functions, which are called by others.
    fn entry(&self, callee: &Callee<'_>, initial: TokenStream) -> Option<String> {
        let Callee { module, owner, component, signature } = callee;
        let generic = |it: &syn::GenericParam| !matches!(it, syn::GenericParam::Lifetime(_));
        if signature.generics.params.iter().any(generic) {
            return None;
        }
        let path: syn::Path = syn::parse_str(&format!("crate::programs::{module}")).ok()?;
        let name = &signature.ident;
        let (mut loads, mut arguments, mut stores) = (Vec::new(), Vec::new(), Vec::new());
        let mut made = Vec::new();
        let mut receiver = false;
        for (index, input) in signature.inputs.iter().enumerate() {
            let input = match input {
                FnArg::Receiver(it) if *component => {
                    receiver = true;
                    continue;
                }
                FnArg::Receiver(it) => {
                    receiver = true;
                    made.push(quote!(bessemer::Plain::store(&this, __out);));
                    let changed = matches!(&it.kind, syn::ReceiverKind::Reference(_, _, Some(_)));
                    loads.push(quote!(let mut this = <__Owner as bessemer::Plain>::load(__next);));
                    stores.extend(changed.then(|| quote!(bessemer::Plain::store(&this, __out);)));
                    continue;
                }
                FnArg::Typed(input) => input,
            };
            // Words do not say how long a slice is, nor what a closure does: their callers are run.
            if has_no_words(&input.ty) {
                return None;
            }
            let local = format_ident!("argument_{index}");
            let (ty, pass) = match &*input.ty {
                Type::Reference(it) if it.mutability.is_some() => (&*it.elem, quote!(&mut #local)),
                Type::Reference(it) if !is_name(it) => (&*it.elem, quote!(&#local)),
                ty => (ty, quote!(#local)),
            };
            let ty = own(ty);
            loads.push(quote!(let mut #local = <#ty as bessemer::Plain>::load(__next);));
            made.push(quote!(bessemer::Plain::store(&#local, __out);));
            if matches!(&*input.ty, Type::Reference(it) if it.mutability.is_some()) {
                stores.push(quote!(bessemer::Plain::store(&#local, __out);));
            }
            arguments.push(pass);
        }
        let call = match owner {
            Some(_) if receiver => quote!(this.#name),
            Some(_) => quote!(<__Owner>::#name),
            None => quote!(#path::#name),
        };
        let call = quote!(#call(#(#arguments),*));
        let call = match &signature.output {
            ReturnType::Default => quote!(#call;),
            ReturnType::Type(_, ty) => {
                let result = match &**ty {
                    ty if has_no_words(ty) => return None,
                    // Which place it is shows where it is written.
                    Type::Reference(it) if it.mutability.is_some() => return None,
                    // What lends a place may be no function in the C.
                    Type::Reference(it) if is_name(it) => quote!(result),
                    Type::Reference(_) if self.methods => return None,
                    Type::Reference(_) => quote!(*result),
                    _ => quote!(result),
                };
                quote!(let result = #call; bessemer::Plain::store(&#result, __out);)
            }
        };
        let (load, store) = match component {
            true => (
                quote!(let mut this = <__Owner as bessemer::Plain>::load(__next);),
                quote!(bessemer::Plain::store(&this, __out);),
            ),
            false => (quote!(), quote!()),
        };
        let (ty, stand_for) = owner.unzip();
        let named = ty.map(|ty| quote!(type __Owner = #ty;));
        let owner = ty.map(|ty| ty.to_token_stream().to_string()).unwrap_or_default();
        let (component, data) =
            if *component { (owner, String::new()) } else { (String::new(), owner) };
        let stand_for = stand_for.unwrap_or_default();
        let (name, module) = (name.to_string(), format!("{}::programs::{module}", self.root));
        let entry = quote! {
            crate::Entry {
                module: #module,
                component: #component,
                data: #data,
                name: #name,
                made: {
                    #[allow(unused_imports, unused_mut, unused_variables, dead_code, clippy::all)]
                    fn made(__next: &mut dyn FnMut() -> u64, __out: &mut dyn FnMut(u64)) {
                        use bessemer::prelude::*;
                        use #path::*;
                        #(#stand_for)*
                        #named
                        #load #(#loads)* #store #(#made)*
                    }
                    made
                },
                run: {
                    #[allow(unused_imports, unused_mut, unused_variables, dead_code, clippy::all)]
                    fn run(__next: &mut dyn FnMut() -> u64, __out: &mut dyn FnMut(u64)) {
                        use bessemer::prelude::*;
                        use #path::*;
                        #(#stand_for)*
                        #named
                        #load #(#loads)* #call #store #(#stores)*
                    }
                    run
                },
                initial: {
                    #[allow(unused_imports, unused_variables, dead_code)]
                    fn initial(__out: &mut dyn FnMut(u64)) {
                        use bessemer::prelude::*;
                        use #path::*;
                        #named
                        #initial
                    }
                    initial
                },
            }
        };
        Some(entry.to_string())
    }
}

/// Returns true for a name, `&str`, which is a value.
fn is_name(it: &syn::TypeReference) -> bool {
    matches!(&*it.elem, Type::Path(path) if path.path.is_ident("str"))
}

/// Returns true if a type has references within, or is none by itself.
fn has_no_words(ty: &Type) -> bool {
    let inner = match ty {
        Type::Reference(it) => &*it.elem,
        ty => ty,
    };
    let text = inner.to_token_stream().to_string();
    matches!(inner, Type::Slice(_) | Type::ImplTrait(_)) || text.contains(['&', '\''])
}

/// `Self` by the name that it has here.
fn own(ty: &Type) -> TokenStream {
    fn renamed(tokens: TokenStream) -> TokenStream {
        let token = |token| match token {
            proc_macro2::TokenTree::Ident(it) if it == "Self" => format_ident!("__Owner").into(),
            proc_macro2::TokenTree::Group(it) => {
                proc_macro2::Group::new(it.delimiter(), renamed(it.stream())).into()
            }
            other => other,
        };
        tokens.into_iter().map(token).collect()
    }
    renamed(ty.to_token_stream())
}

/// A first value of plain data: its default, else what its constructor makes of numbers. None, if it has neither.
fn initial(block: &syn::ItemImpl, items: &[Item]) -> Option<TokenStream> {
    let (name, _) = name_of(&block.self_ty)?;
    let of_it = |ty: &Type| name_of(ty).is_some_and(|(other, _)| other == name);
    let has_default = items.iter().any(|item| match item {
        Item::Struct(it) if it.ident == name => derives_default(&it.attrs),
        Item::Enum(it) if it.ident == name => derives_default(&it.attrs),
        Item::Impl(it) => {
            it.trait_.as_ref().is_some_and(|(path, _)| path.is_ident("Default"))
                && of_it(&it.self_ty)
        }
        _ => false,
    });
    if has_default {
        return Some(quote!(<__Owner as Default>::default()));
    }
    block.items.iter().find_map(|item| {
        let ImplItem::Fn(method) = item else { return None };
        let ReturnType::Type(_, result) = &method.sig.output else { return None };
        let result = result.to_token_stream().to_string().replace("Self", &name);
        let is_it = result == name || result.starts_with(&format!("{name} <"));
        if !public(&method.vis) || !is_it || method.sig.receiver().is_some() {
            return None;
        }
        let arguments = method.sig.inputs.iter().map(|input| match input {
            FnArg::Typed(it) => number(&it.ty),
            FnArg::Receiver(_) => None,
        });
        let arguments: Vec<TokenStream> = arguments.collect::<Option<_>>()?;
        let function = &method.sig.ident;
        Some(quote!(<__Owner>::#function(#(#arguments),*)))
    })
}

fn number(ty: &Type) -> Option<TokenStream> {
    let (name, _) = name_of(ty)?;
    Some(match name.as_str() {
        "f32" | "f64" => quote!(0.25),
        "bool" => quote!(true),
        "u8" | "u16" | "u32" | "u64" | "usize" | "i8" | "i16" | "i32" | "i64" => quote!(4),
        _ => return None,
    })
}

fn derives_default(attributes: &[syn::Attribute]) -> bool {
    let derives = attributes.iter().filter(|it| it.path().is_ident("derive"));
    derives.into_iter().any(|it| it.to_token_stream().to_string().contains("Default"))
}

/// The types whose methods stand in an `impl` block: the instances of something generic by their names,
/// each with what its parameters stand for.
fn owners(block: &syn::ItemImpl, items: &[Item]) -> Vec<(Type, Vec<Item>)> {
    if block.generics.params.is_empty() && arguments_of(&block.self_ty).is_none() {
        return vec![((*block.self_ty).clone(), Vec::new())];
    }
    let Some((generic, _)) = name_of(&block.self_ty) else { return Vec::new() };
    let instances = items.iter().filter_map(|item| match item {
        Item::Type(it) if marked(&it.attrs, "component") || marked(&it.attrs, "data") => Some(it),
        _ => None,
    });
    let named = instances.filter_map(|it| {
        let (of, arguments) = name_of(&it.ty)?;
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
        let whole = arguments_of(&block.self_ty) == arguments_of(&it.ty);
        let matches = of == generic && (whole || !block.generics.params.is_empty());
        matches.then(|| (syn::parse_quote!(#name), stand_for.collect()))
    });
    named.collect()
}

fn arguments_of(ty: &Type) -> Option<String> {
    let (_, arguments) = name_of(ty)?;
    let text = |it: &syn::GenericArgument| it.to_token_stream().to_string();
    (!arguments.is_empty()).then(|| arguments.iter().map(text).collect::<Vec<_>>().join(","))
}

/// The last name of a type's path, and its arguments.
fn name_of(ty: &Type) -> Option<(String, Vec<syn::GenericArgument>)> {
    let Type::Path(it) = ty else { return None };
    let last = it.path.segments.last()?;
    let arguments = match &last.arguments {
        syn::PathArguments::AngleBracketed(it) => it.args.iter().cloned().collect(),
        _ => Vec::new(),
    };
    Some((last.ident.to_string(), arguments))
}

fn marked(attributes: &[syn::Attribute], name: &str) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().segments.last().is_some_and(|segment| segment.ident == name)
    })
}

fn public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}
