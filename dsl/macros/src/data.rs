//! Expands `#[data]` and `#[component]` on structs, enums and their `impl` blocks.
//!
//! Every build implements `Plain` (values as words). A generation build also emits the definition of the type and the
//! builders of its methods.

use bessemer_tree::Role;
use bessemer_tree::attributes::Given;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;

use crate::attributes;
use crate::builder::{self, Home, Subject};
use crate::closures;
use crate::defaults;
use crate::docs;
use crate::generics::Scope;
use crate::given::{self, On};
use crate::implied;
use crate::imports;
use crate::instance;
use crate::interface;
use crate::kind::Kind;
use crate::lower::{self, Refusals, refuse};
use crate::owned;
use crate::place;
use crate::redirect;
use crate::sizes;
use crate::state;
use crate::table;

/// Expands the attribute on a struct, an enum or an `impl` block.
pub fn expand(kind: Kind, arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut refusals = Refusals::default();
    // The library's own: methods that a named instance brings only where they are called.
    let more = arguments.to_string() == "more";
    if !arguments.is_empty() && !more {
        refusals.add(&arguments, refuse::ARGUMENTS);
    }
    let (native, beside) = match syn::parse2::<syn::Item>(item.clone()) {
        Ok(syn::Item::Struct(mut it)) => {
            let beside = data_struct(kind, &it, &mut refusals);
            let default = defaults::of_arrays(&mut it);
            given::strip(&mut it.attrs);
            strip_fields(&mut it.fields);
            (it.to_token_stream(), quote! { #beside #default })
        }
        Ok(syn::Item::Enum(mut it)) => {
            let beside = data_enum(kind, &it, &mut refusals);
            given::strip(&mut it.attrs);
            for variant in &mut it.variants {
                given::strip(&mut variant.attrs);
                strip_fields(&mut variant.fields);
            }
            (it.to_token_stream(), beside)
        }
        Ok(syn::Item::Type(mut it)) => {
            let beside = instance::named(&it, &mut refusals);
            given::strip(&mut it.attrs);
            (it.to_token_stream(), beside)
        }
        Ok(syn::Item::Const(mut it)) if kind == Kind::Data => {
            let beside = table::constant(&mut it, &mut refusals);
            (it.to_token_stream(), beside)
        }
        Ok(syn::Item::Static(mut it)) if kind == Kind::Data => {
            let beside = table::fixed(&mut it, &mut refusals);
            (it.to_token_stream(), beside)
        }
        Ok(syn::Item::Impl(it)) => methods(kind, more, it, &mut refusals),
        Ok(syn::Item::Union(it)) => {
            refusals.add(it.union_token.span, refuse::UNION);
            (it.to_token_stream(), TokenStream::new())
        }
        Ok(other) => {
            refusals.add(refuse::first_token(&other), refuse::NOT_DATA);
            (item, TokenStream::new())
        }
        Err(error) => (item, error.into_compile_error()),
    };
    let errors = refusals.into_tokens();
    quote! { #errors #native #beside }
}

/// Refuses a component with a lifetime: its state outlives every call, so it cannot hold references.
fn refuse_lifetimes(kind: Kind, generics: &syn::Generics, refusals: &mut Refusals) {
    for parameter in generics.params.iter().filter(|_| kind == Kind::Component) {
        if let syn::GenericParam::Lifetime(it) = parameter {
            refusals.add(it, refuse::REFERENCE_FIELD);
        }
    }
}

fn data_struct(kind: Kind, it: &syn::ItemStruct, refusals: &mut Refusals) -> TokenStream {
    check_type(&it.attrs, &it.generics, refusals);
    if it.fields.is_empty() {
        check_empty(kind, it, refusals);
    }
    let borrows = kind == Kind::Data && it.generics.lifetimes().next().is_some();
    check_fields(&it.fields, borrows, refusals);
    // A reference is reported at the field that holds it.
    if refusals.is_empty() {
        refuse_lifetimes(kind, &it.generics, refusals);
    }
    if !refusals.is_empty() {
        return TokenStream::new();
    }
    let name = &it.ident;
    let scope = Scope::of_type(&it.generics);
    if borrows {
        // It lives in locals, and has no words.
        if !lower::generating() {
            return TokenStream::new();
        }
        let definition = struct_definition(kind, it);
        let plain = plain_while_generating(name, scope, &[]);
        return quote! { #definition #plain };
    }
    let members: Vec<_> = it.fields.members().collect();
    let types: Vec<_> = it.fields.iter().map(|field| &field.ty).collect();
    // Spanned at the field's type: a type that is not plain is reported there.
    let words = types.iter().map(|ty| {
        quote_spanned! { ty.span() => + <#ty as ::bessemer::Plain>::WORDS }
    });
    let store = members.iter().zip(&types).map(|(member, ty)| {
        quote_spanned! { ty.span() => <#ty as ::bessemer::Plain>::store(&self.#member, out); }
    });
    let load = members.iter().zip(&types).map(|(member, ty)| {
        quote_spanned! { ty.span() => #member: <#ty as ::bessemer::Plain>::load(next) }
    });
    let (declared, arguments) = (scope.declared(), scope.arguments());
    let bounds = field_bounds(scope, &it.fields, &quote! { ::bessemer::Plain });
    let plain = quote! {
        #[diagnostic::do_not_recommend]
        #[allow(private_bounds)]
        impl #declared ::bessemer::Plain for #name #arguments #bounds {
            const WORDS: usize = 0 #(#words)*;
            #[inline]
            #[allow(unused_variables)]
            fn store(&self, out: &mut dyn ::core::ops::FnMut(u64)) { #(#store)* }
            #[inline]
            #[allow(unused_variables)]
            fn load(next: &mut dyn ::core::ops::FnMut() -> u64) -> Self {
                Self { #(#load),* }
            }
        }
    };
    let initial = (kind == Kind::Component && !scope.is_generic()).then(|| {
        quote_spanned! { name.span() =>
            const _: fn() -> #name = <#name as ::core::default::Default>::default;
        }
    });
    let definition = lower::generating().then(|| struct_definition(kind, it));
    quote! { #plain #initial #definition }
}

/// Returns the bounds of a generic type on its fields that depend on its parameters.
fn field_bounds(scope: Scope<'_>, fields: &syn::Fields, of: &TokenStream) -> TokenStream {
    let types = fields.iter().map(|field| &field.ty).filter(|ty| scope.is_named_in(ty));
    scope.bounds(types.map(|ty| quote! { #ty: #of }))
}

fn strip_fields(fields: &mut syn::Fields) {
    fields.iter_mut().for_each(|field| given::strip(&mut field.attrs));
}

/// Checks the attributes of a type. A generic type cannot have a C name, since each instance would have it.
fn check_type(attributes: &[syn::Attribute], generics: &syn::Generics, refusals: &mut Refusals) {
    lower::check_attributes(attributes, refusals);
    let given = given::read(attributes, On::Type, refusals);
    let named = attributes.iter().find(|it| it.path().is_ident("c"));
    if let (true, Some(_), Some(at)) = (Scope::of_type(generics).is_generic(), given.name, named) {
        refusals.add(at.path(), refuse::GENERIC_NAME);
    }
}

/// Refuses a component or a C name without fields, since zero-sized types are not in the C.
fn check_empty(kind: Kind, it: &syn::ItemStruct, refusals: &mut Refusals) {
    if kind == Kind::Component {
        refusals.add(&it.ident, refuse::EMPTY_COMPONENT);
    }
    if let Some(at) = it.attrs.iter().find(|it| it.path().is_ident("c")) {
        refusals.add(at.path(), refuse::EMPTY_NAME);
    }
}

/// Checks the fields of a type; `borrows` is true if it may hold references.
fn check_fields(fields: &syn::Fields, borrows: bool, refusals: &mut Refusals) {
    for field in fields {
        given::read(&field.attrs, On::Value, refusals);
        lower::check_attributes(&field.attrs, refusals);
        match borrows {
            true => lower::check_type(&field.ty, refusals),
            false => lower::check_field(&field.ty, refusals),
        }
    }
}

fn struct_definition(kind: Kind, it: &syn::ItemStruct) -> TokenStream {
    let fields = field_definitions(&it.fields);
    let name = &it.ident;
    let none = quote! { ::core::option::Option::None };
    let generic = Scope::of_type(&it.generics).is_generic();
    let (initial, defaults) = match kind {
        Kind::Component => (
            quote! {
                ::core::option::Option::Some(::bessemer::generate::words(&<Self as ::core::default::Default>::default()))
            },
            none,
        ),
        // A derived one has no code of its own; and an instance with one cannot be recognised here.
        Kind::Data if generic || derives("Default", &it.attrs) => (none.clone(), none),
        Kind::Data => (
            none,
            quote! {{
                #[allow(unused_imports)]
                use ::bessemer::generate::NoDefault as _;
                ::bessemer::generate::Defaults::<#name>::of().words()
            }},
        ),
    };
    let indices = (generic && derives("State", &it.attrs)).then(|| {
        let method = state::of_instance();
        quote! { Self::#method(__cx, arguments); }
    });
    let body = quote! {{
        #indices
        ::bessemer::generate::tree::DefinitionKind::Struct {
            fields: #fields,
            initial: #initial,
            defaults: #defaults,
        }
    }};
    let scope = Scope::of_type(&it.generics);
    let mut bounds = definition_bounds(scope, [&it.fields]);
    if scope.is_generic() && kind == Kind::Component {
        let arguments = scope.arguments();
        bounds.push(quote! { #name #arguments: ::core::default::Default + ::bessemer::Plain });
    }
    let owns = scope.lifetimes().next().is_none();
    let ranked = (owns && derives("PartialOrd", &it.attrs)).then(|| ranked(name, scope));
    let definition = definition(name, scope, &scope.bounds(bounds), &it.attrs, body);
    let template = scope.is_generic().then(|| template(kind, name));
    quote! { #definition #ranked #template }
}

/// Registers a generic type; if it has no instance, its author is warned that the C lacks it.
fn template(kind: Kind, name: &syn::Ident) -> TokenStream {
    place::template(
        name,
        &match kind {
            Kind::Component => quote! { Component },
            Kind::Data => quote! { Data },
        },
    )
}

/// Implements the marker trait of types that are ordered by their fields or numbers.
fn ranked(name: &syn::Ident, scope: Scope<'_>) -> TokenStream {
    let (declared, arguments) = (scope.declared(), scope.arguments());
    let bounds = scope.bounds([quote! { #name #arguments: ::bessemer::generate::Value }]);
    quote! {
        impl #declared ::bessemer::generate::Ranked for #name #arguments #bounds {}
    }
}

/// Returns the bounds of a generic type's definition on its parameters, and on the fields that depend on them.
fn definition_bounds<'a>(
    scope: Scope<'_>,
    fields: impl IntoIterator<Item = &'a syn::Fields>,
) -> Vec<TokenStream> {
    let types = fields.into_iter().flatten().map(|field| &field.ty);
    let types = types.filter(|ty| scope.is_named_in(ty));
    let fields = types.map(|ty| quote! { #ty: ::bessemer::generate::DslType });
    let own = scope.types().map(|name| quote! { #name: ::bessemer::generate::Value });
    fields.chain(own).collect()
}

/// Returns the list of field definitions.
fn field_definitions(fields: &syn::Fields) -> TokenStream {
    let fields = fields.iter().zip(fields.members()).map(|(field, member)| {
        let (name, docs, ty) = (lower::member(&member), docs::lines(&field.attrs), &field.ty);
        let given = given::read(&field.attrs, On::Value, &mut Refusals::default());
        let given = given::tokens(&Given { sizes: sizes::of(ty), ..given });
        quote! { ::bessemer::generate::field::<#ty>(__cx, #name, &[#(#docs),*], #given) }
    });
    quote! { ::bessemer::generate::list([#(#fields),*]) }
}

/// Returns the attributes of an item, which were checked before.
fn said(attributes: &[syn::Attribute], on: On) -> TokenStream {
    given::tokens(&given::read(attributes, on, &mut Refusals::default()))
}

/// Returns true if a trait is in a `derive` below the DSL's attribute.
fn derives(name: &str, attributes: &[syn::Attribute]) -> bool {
    attributes.iter().filter(|it| it.path().is_ident("derive")).any(|derive| {
        use syn::punctuated::Punctuated;
        let parser = Punctuated::<syn::Path, syn::Token![,]>::parse_terminated;
        let list = derive.parse_args_with(parser).unwrap_or_default();
        list.iter().any(|it| it.segments.last().is_some_and(|last| last.ident == name))
    })
}

/// Returns the definition of a type and its registration. Instances of a generic type are built where they are used.
fn definition(
    name: &syn::Ident,
    scope: Scope<'_>,
    bounds: &TokenStream,
    attributes: &[syn::Attribute],
    kind: TokenStream,
) -> TokenStream {
    let docs = docs::lines(attributes);
    let [equal, ordered, copied, cloned, ranked] =
        ["PartialEq", "PartialOrd", "Copy", "Clone", "Ord"].map(|name| derives(name, attributes));
    let ranked = ranked || !ordered;
    let given = said(attributes, On::Type);
    let (named, site) = (place::named(name), place::site(name));
    let (declared, arguments, told) = (scope.declared(), scope.applied(), scope.told());
    let lasting = scope.lasting();
    let held = scope.types().filter(|_| scope.lifetimes().next().is_some());
    let outer = scope.bounds(held.map(|name| quote! { #name: 'static }));
    let implied = scope.is_generic().then(|| implied::ask(&quote! { Self }));
    let registered = (!scope.is_generic()).then(|| {
        place::registered(
            name,
            &quote! { Type(<#name #lasting as ::bessemer::generate::DslType>::ty) },
        )
    });
    quote! {
        const _: () = {
            impl #declared ::bessemer::generate::Seen for #name #arguments #outer {
                type Slot = #name #lasting;
            }
            #[allow(private_bounds)]
            impl #declared ::bessemer::generate::DslType for #name #arguments #bounds {
                fn ty(__cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Ty {
                    #[allow(unused_imports)]
                    use ::bessemer::generate::NotImplemented as _;
                    let arguments = #told;
                    #implied
                    let asked = ::bessemer::generate::Asked::<Self>::of();
                    let own = ::bessemer::generate::Own {
                        clone: !#cloned && asked.clones(),
                        order: !#ranked && asked.orders(),
                        drop: asked.drops(),
                        lends: asked.lends(),
                    };
                    __cx.definition(
                        #named, &[#(#docs),*], #site, arguments, ([#equal, #ordered, #copied], own, #given),
                        &|__cx: &mut ::bessemer::generate::Builder| #kind,
                    )
                }
            }
            #registered
        };
    }
}

fn data_enum(kind: Kind, it: &syn::ItemEnum, refusals: &mut Refusals) -> TokenStream {
    let borrows = it.generics.lifetimes().next().is_some();
    check_type(&it.attrs, &it.generics, refusals);
    if kind == Kind::Component {
        refusals.add(it.enum_token.span, refuse::COMPONENT_ENUM);
    }
    if it.variants.is_empty() {
        refusals.add(&it.ident, refuse::EMPTY_ENUM);
    }
    let payload = it.variants.iter().any(|variant| !variant.fields.is_empty());
    let mut fallback = false;
    for variant in &it.variants {
        lower::check_attributes(&variant.attrs, refusals);
        if given::read(&variant.attrs, On::Variant, refusals).fallback {
            if std::mem::replace(&mut fallback, true) {
                refusals.add(&variant.ident, refuse::FALLBACK_TWICE);
            }
            if !variant.fields.is_empty() {
                refusals.add(&variant.ident, refuse::FALLBACK_PAYLOAD);
            }
        }
        check_fields(&variant.fields, borrows, refusals);
        if let (Some((_, value)), true) = (&variant.discriminant, payload) {
            refusals.add(value, refuse::DISCRIMINANT);
        }
    }
    if !refusals.is_empty() {
        return TokenStream::new();
    }
    let plain = (!borrows).then(|| enum_words(it));
    let numbered = it.variants.iter().any(|variant| variant.discriminant.is_some());
    let definition = lower::generating().then(|| {
        let variants = it.variants.iter().map(|variant| {
            let (name, docs) = (lower::text(&variant.ident), docs::lines(&variant.attrs));
            let fields = field_definitions(&variant.fields);
            let (whole, ident) = (&it.ident, &variant.ident);
            let value = match numbered {
                true => quote! { ::core::option::Option::Some(#whole::#ident as i64) },
                false => quote! { ::core::option::Option::None },
            };
            let given = said(&variant.attrs, On::Variant);
            quote! { ::bessemer::generate::variant(#name, &[#(#docs),*], #fields, #value, #given) }
        });
        let kind = quote! {
            ::bessemer::generate::tree::DefinitionKind::Enum(::bessemer::generate::list([#(#variants),*]))
        };
        let scope = Scope::of_type(&it.generics);
        let fields = it.variants.iter().map(|variant| &variant.fields);
        let bounds = scope.bounds(definition_bounds(scope, fields));
        let ranks = !payload && !borrows && derives("PartialOrd", &it.attrs);
        let ranked = ranks.then(|| ranked(&it.ident, scope));
        let empty = it.variants.iter().enumerate().filter(|(_, it)| it.fields.is_empty());
        let arms = empty.map(|(index, variant)| {
            let (index, ident) = (index as u64, &variant.ident);
            quote! { Self::#ident { .. } => out(#index), }
        });
        let arms: Vec<_> = arms.collect();
        let plain = borrows.then(|| plain_while_generating(&it.ident, scope, &arms));
        let definition = definition(&it.ident, scope, &bounds, &it.attrs, kind);
        let generic = scope.is_generic().then(|| template(Kind::Data, &it.ident));
        quote! { #definition #ranked #generic #plain }
    });
    quote! { #plain #definition }
}

/// Implements the plain-data traits for a type with borrows in generation builds. It has no words, but acts as a
/// parameter type there, and rustc evaluates its variants without payload: their words are their index.
fn plain_while_generating(
    name: &syn::Ident,
    scope: Scope<'_>,
    empty: &[TokenStream],
) -> TokenStream {
    let (declared, arguments, bounds) = (scope.declared(), scope.applied(), scope.bounds([]));
    quote! {
        const _: () = {
            #[diagnostic::do_not_recommend]
            #[allow(private_bounds)]
            impl #declared ::bessemer::Plain for #name #arguments #bounds {
                const WORDS: usize = 0;
                #[allow(unused_variables, unreachable_patterns)]
                fn store(&self, out: &mut dyn ::core::ops::FnMut(u64)) {
                    match self { #(#empty)* _ => {} }
                }
                fn load(_: &mut dyn ::core::ops::FnMut() -> u64) -> Self {
                    ::core::unreachable!()
                }
            }
        };
    }
}

/// Returns the words of an enum: the index of its variant, then the words of each payload in order, zero for inactive
/// payloads.
fn enum_words(it: &syn::ItemEnum) -> TokenStream {
    let name = &it.ident;
    let (mut stores, mut loads, mut skips) = (Vec::new(), Vec::new(), Vec::new());
    for (index, variant) in it.variants.iter().enumerate() {
        let (index, ident) = (index as u64, &variant.ident);
        let members: Vec<_> = variant.fields.members().collect();
        let names: Vec<_> = (0..members.len()).map(|at| quote::format_ident!("__{at}")).collect();
        let types: Vec<_> = variant.fields.iter().map(|field| &field.ty).collect();
        let payloads = it.variants.iter().enumerate().map(|(other, payload)| {
            let types = payload.fields.iter().map(|field| &field.ty);
            if other as u64 == index {
                quote! { #(<#types as ::bessemer::Plain>::store(#names, out);)* }
            } else {
                quote! { #(for _ in 0..<#types as ::bessemer::Plain>::WORDS { out(0); })* }
            }
        });
        stores.push(quote! {
            #name::#ident { #(#members: #names),* } => { out(#index); #(#payloads)* }
        });
        let before = it.variants.iter().take(index as usize).flat_map(|variant| &variant.fields);
        let after = it.variants.iter().skip(index as usize + 1).flat_map(|it| &it.fields);
        let (before, after) = (before.map(|field| &field.ty), after.map(|field| &field.ty));
        let load = quote! {
            #(for _ in 0..<#before as ::bessemer::Plain>::WORDS { next(); })*
            #(let #names = <#types as ::bessemer::Plain>::load(next);)*
            #(for _ in 0..<#after as ::bessemer::Plain>::WORDS { next(); })*
            #name::#ident { #(#members: #names),* }
        };
        // A word that is no variant's becomes the first variant.
        let word = if index == 0 {
            quote! { _ }
        } else {
            quote! { #index }
        };
        if index == 0 {
            skips.push(quote! { #word => { #load } })
        } else {
            loads.push(quote! { #word => { #load } })
        }
    }
    let types: Vec<_> = it.variants.iter().flat_map(|it| &it.fields).map(|it| &it.ty).collect();
    // Spanned at the field's type: a type that is not plain is reported there.
    let words = types.iter().map(|ty| {
        quote_spanned! { ty.span() => + <#ty as ::bessemer::Plain>::WORDS }
    });
    let scope = Scope::of_type(&it.generics);
    let (declared, arguments) = (scope.declared(), scope.arguments());
    let named = types.iter().filter(|ty| scope.is_named_in(ty));
    let bounds = scope.bounds(named.map(|ty| quote! { #ty: ::bessemer::Plain }));
    quote! {
        #[diagnostic::do_not_recommend]
        #[allow(private_bounds)]
        impl #declared ::bessemer::Plain for #name #arguments #bounds {
            const WORDS: usize = 1 #(#words)*;
            #[allow(clippy::reversed_empty_ranges)]
            #[inline]
            fn store(&self, out: &mut dyn ::core::ops::FnMut(u64)) {
                match self { #(#stores)* }
            }
            #[inline]
            fn load(next: &mut dyn ::core::ops::FnMut() -> u64) -> Self {
                match next() { #(#loads)* #(#skips)* }
            }
        }
    }
}

/// Returns the native `impl` block, and the items beside it.
fn methods(
    kind: Kind,
    more: bool,
    mut it: syn::ItemImpl,
    refusals: &mut Refusals,
) -> (TokenStream, TokenStream) {
    refuse_lifetimes(kind, &it.generics, refusals);
    lower::name_lifetimes(&mut it);
    lower::name_owner(&mut it);
    for item in &mut it.items {
        if let syn::ImplItem::Fn(method) = item {
            imports::write_out(&method.sig, &mut method.block);
        }
    }
    if it.trait_.is_some() {
        return interface::implementation(kind, it, refusals);
    }
    let mut beside = TokenStream::new();
    let (mut owned, mut faces) = (Vec::new(), Vec::new());
    for item in &mut it.items {
        let method = match item {
            syn::ImplItem::Fn(method) => method,
            syn::ImplItem::Const(_) => continue,
            other => {
                refusals.add(refuse::first_token(other), refuse::IMPL_ITEM);
                continue;
            }
        };
        let mut refusals = Refusals::default();
        let asked = attributes::of_own_method(kind, method, &mut refusals);
        let role = asked.role;
        let subject = Subject::of(method, asked, Home::Block);
        beside.extend(builder::method(&it.self_ty, &it.generics, &subject, &mut refusals));
        let own = closures::without(&closures::with_names(&method.sig).generics);
        let generic = Scope::of_function(&own).is_generic();
        // A refused method is not built. A method with a `where` of its own does not exist for every instance.
        if refusals.is_empty()
            && !generic
            && own.where_clause.is_none()
            && (matches!(role, Role::Entry { .. })
                || attributes::is_public(&method.vis) && kind == Kind::Data)
        {
            faces.push(builder::build_name(&method.sig.ident));
        }
        owned.extend(alias(&it.self_ty, method));
        let scope = Scope::of_type(&it.generics).with_method(&method.sig.generics);
        redirect::native((&mut method.attrs, &mut method.block), scope, refusals);
    }
    it.items.extend(owned);
    if !more {
        beside.extend(instance::block(&it, &faces));
    }
    (it.into_token_stream(), beside)
}

/// Returns an alias of an author's method whose name the DSL owns, since calls of it were redirected to the alias.
fn alias(owner: &syn::Type, method: &syn::ImplItemFn) -> Option<syn::ImplItem> {
    let mut alias = method.clone();
    let name = &method.sig.ident;
    let of_turns = || owned::of_turns(lower::last_ident(owner)?, name);
    alias.sig.ident = owned::owned(name).or_else(of_turns)?;
    alias.attrs = vec![syn::parse_quote!(#[doc(hidden)]), syn::parse_quote!(#[allow(dead_code)])];
    let arguments = alias.sig.inputs.iter_mut().enumerate().map(|(index, input)| match input {
        syn::FnArg::Receiver(receiver) => receiver.self_token.to_token_stream(),
        syn::FnArg::Typed(typed) => {
            let name = quote::format_ident!("__{index}");
            *typed.pat = syn::parse_quote!(#name);
            name.into_token_stream()
        }
    });
    let arguments: Vec<_> = arguments.collect();
    alias.block = syn::parse_quote!({ Self::#name(#(#arguments),*) });
    Some(syn::ImplItem::Fn(alias))
}
