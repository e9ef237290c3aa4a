//! The witness copy of a body: slots, and closures that are type-checked and never called.
//!
//! In a generation build each value of the copy passes through a slot, and the builder reads the type that rustc
//! inferred for it. rustc revisits all pending obligations whenever it meets a type that is not fully known, and a
//! body has as many slots as values. So a long body is copied in parts, each a closure with its own slots: only one
//! part's obligations are pending, and time grows with the length, not with its square. A slot with a tuple of all
//! types passes the names of a part that later statements use to the next.
//!
//! Invariants: a slot is used only in its part; the types of a part are read before the next begins.
//!
//! Must not know: the tree.

use std::collections::HashMap;

use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::visit::{self, Visit};

use crate::lower::{self, Begin, Constant, Lowering, Parameter};

/// Number of slots in a part. A smaller number leaves fewer types open; a larger one makes fewer parts, each of which
/// costs rustc some 20 ms. Of 128 to 768, the values from 192 to 512 are fastest, within 5 % of each other.
const SLOTS: u32 = 256;

/// A lowered body with its signature.
pub struct Copy<'a> {
    /// Parameters.
    pub parameters: &'a [Parameter],
    /// Slot of the result.
    pub result: u32,
    /// Signature in which each parameter has a name.
    pub signature: &'a syn::Signature,
    /// Body in witness form.
    pub body: &'a syn::Block,
}

impl Copy<'_> {
    /// Returns the parts of the copy. Each records the types of its slots in `__told`.
    pub fn parts(&self, walk: &Lowering) -> TokenStream {
        let ends = ends(&walk.begins);
        let last = ends.len() - 1;
        let passed: Vec<_> = (0..last).map(|part| format_ident!("__passed{part}")).collect();
        let mut names: Vec<_> = self.parameters.iter().map(|it| it.ident.clone()).collect();
        let mut begin = Begin::default();
        let mut parts = TokenStream::new();
        let used = last_uses(&self.body.stmts);
        for (index, &end) in ends.iter().enumerate() {
            let stmts = &self.body.stmts[begin.statements..end.statements];
            let given = names.clone();
            bound(stmts, &mut names);
            names.retain(|name| {
                used.get(&lower::text(name)).is_some_and(|&last| last >= end.statements)
            });
            let body = match passed.get(index) {
                Some(slot) => quote! { { #(#stmts)* __pass(&#slot, (#(#names,)*)) } },
                None if index == 0 => self.body.to_token_stream(),
                None => quote! { { #(#stmts)* } },
            };
            let before = index.checked_sub(1).map(|before| (&passed[before], given.as_slice()));
            let copy = self.part(&body, before, index == last);
            let told = told(walk, (begin, end), &copy);
            parts.extend(match last {
                0 => told,
                _ => quote! { (|| { #told })(); },
            });
            begin = end;
        }
        quote! { #(let #passed = [];)* #parts }
    }

    /// Returns the closure of a part; its arguments are the function's parameters, or the names from the part before.
    ///
    /// After `__unreached` rustc infers types, but has no borrows to check; it checks these in the original. A
    /// closure's result cannot refer to its arguments.
    fn part(
        &self,
        body: &TokenStream,
        before: Option<(&syn::Ident, &[syn::Ident])>,
        last: bool,
    ) -> TokenStream {
        let result = result_type(self.signature);
        let (given, body) = match lower::lends(self.signature) {
            true if last => (None, quote! { let __lent: #result = #body; }),
            true => (Some(quote! { -> () }), body.clone()),
            false => (Some(quote! { -> #result }), body.clone()),
        };
        match before {
            None => {
                let patterns = self.parameters.iter().map(|parameter| &parameter.pattern);
                let types = self.parameters.iter().map(|parameter| &parameter.ty);
                let looks = self.looks();
                let told = self.told_result(&result);
                quote! {
                    let _ = |#(#patterns: #types),*| #given {
                        __unreached();
                        #looks
                        #body
                    };
                    #told
                }
            }
            Some((slot, names)) => quote! {
                __next(&#slot, |(#(#names,)*)| #given {
                    __unreached();
                    #body
                });
            },
        }
    }

    /// Returns statements that record the parameters' types. An unsupported type is reported there.
    fn looks(&self) -> TokenStream {
        let looks = self.parameters.iter().map(|parameter| {
            let (slot, name) = (lower::slot_name(parameter.param.slot), &parameter.ident);
            match parameter.param.closure {
                true => quote! { __result::<()>(&#slot); },
                false => quote_spanned! { parameter.place => __look(&#slot, &#name); },
            }
        });
        quote! { #(#looks)* }
    }

    fn told_result(&self, result: &TokenStream) -> TokenStream {
        let slot = lower::slot_name(self.result);
        let place = match &self.signature.output {
            syn::ReturnType::Default => proc_macro2::Span::call_site(),
            syn::ReturnType::Type(_, ty) => lower::named_part(ty),
        };
        quote_spanned! { place => __result::<#result>(&#slot); }
    }
}

/// Returns the result type of a function.
pub fn result_type(signature: &syn::Signature) -> TokenStream {
    match &signature.output {
        syn::ReturnType::Default => quote! { () },
        syn::ReturnType::Type(_, ty) => quote! { #ty },
    }
}

/// Returns the slots between two positions, around the copy of the code there, and the report of their types.
fn told(walk: &Lowering, (begin, end): (Begin, Begin), copy: &TokenStream) -> TokenStream {
    let slots: Vec<_> = (begin.slots..end.slots).map(lower::slot_name).collect();
    let callees: Vec<_> = (begin.callees..end.callees).map(lower::callee_name).collect();
    let owned: Vec<_> = (begin.operators..end.operators).map(lower::own_name).collect();
    let constants = walk.constants[begin.constants..end.constants].iter().map(|it| {
        let (slot, imports, path) = (lower::slot_name(it.slot), &it.imports, &it.tokens);
        let value = match it.constant {
            // By reference: a `static` cannot be moved out of.
            Constant::Value => quote! { ::bessemer::generate::constant(__cx, &#slot, &#path) },
            Constant::Made => quote! { ::bessemer::generate::made(__cx, &#slot, #path) },
        };
        if imports.is_empty() {
            value
        } else {
            quote! { { #(#imports)* #value } }
        }
    });
    let literals = walk.literals.iter().filter(|slot| (begin.slots..end.slots).contains(slot));
    let literals = literals.map(|slot| lower::slot_name(*slot));
    quote! {
        #(let #slots = [];)*
        #(let #callees = [];)*
        #(let #owned = [];)*
        #copy
        __told.learn(__cx, &[#(&#slots),*], &[#(&#callees),*], &[#(&#owned),*]);
        #(__told.constants.push(#constants);)*
        #(__asked(&#literals).note_iterator(__cx);)*
    }
}

/// Returns the ends of the parts: each is the end of a statement, and the last is the end of the body.
fn ends(begins: &[Begin]) -> Vec<Begin> {
    let mut ends: Vec<Begin> = Vec::new();
    let Some((end, begins)) = begins.split_last() else { return ends };
    for begin in begins {
        let from = ends.last().map_or(0, |end| end.slots);
        if begin.slots - from >= SLOTS {
            ends.push(*begin);
        }
    }
    ends.push(*end);
    ends
}

/// Returns the index of the last statement with each word: as a name, or in a string, which may be a format.
fn last_uses(stmts: &[syn::Stmt]) -> HashMap<String, usize> {
    fn note(tokens: TokenStream, at: usize, last: &mut HashMap<String, usize>) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => note(group.stream(), at, last),
                TokenTree::Ident(name) => _ = last.insert(lower::text(&name), at),
                TokenTree::Literal(text) => {
                    let text = text.to_string();
                    let words = text.split(|it: char| !it.is_alphanumeric() && it != '_');
                    last.extend(words.map(|word| (word.to_owned(), at)));
                }
                TokenTree::Punct(_) => {}
            }
        }
    }
    let mut last = HashMap::new();
    for (at, stmt) in stmts.iter().enumerate() {
        note(stmt.to_token_stream(), at, &mut last);
    }
    last
}

/// Adds the names that statements bind to those bound before; one that shadows another replaces it.
fn bound(stmts: &[syn::Stmt], names: &mut Vec<syn::Ident>) {
    struct Bound<'a>(&'a mut Vec<syn::Ident>);
    impl<'ast> Visit<'ast> for Bound<'_> {
        fn visit_local(&mut self, it: &'ast syn::Local) {
            match &it.pat {
                // Alone it is a variable's name, however it is written.
                syn::Pat::Ident(pattern) => self.add(&pattern.ident),
                pattern => self.visit_pat(pattern),
            }
        }
        fn visit_pat_type(&mut self, it: &'ast syn::PatType) {
            match &*it.pat {
                syn::Pat::Ident(pattern) => self.add(&pattern.ident),
                pattern => self.visit_pat(pattern),
            }
        }
        fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
            if it.subpat.is_some() || !lower::is_constant_name(&it.ident) {
                self.add(&it.ident);
            }
            visit::visit_pat_ident(self, it);
        }
    }
    impl Bound<'_> {
        fn add(&mut self, name: &syn::Ident) {
            self.0.retain(|known| lower::text(known) != lower::text(name));
            self.0.push(name.clone());
        }
    }
    for stmt in stmts {
        if let syn::Stmt::Local(local) = stmt {
            Bound(names).visit_local(local);
        }
    }
}
