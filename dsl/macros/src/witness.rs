//! The witness copy of a body: slots, and closures that are type-checked and never called.
//!
//! In a generation build each value of the copy passes through a slot, and the builder reads off the type that rustc put
//! there. rustc goes through all that it has asked and not yet answered whenever it meets a type that it does not know in
//! full, and there are as many slots as a body has values. So a long body is copied in parts, each with its own slots, in
//! closures of their own: what is open is that of one part, and time grows with the length, not with its square. The names
//! of a part that are in what follows reach the next in a slot that holds the types of them all.
//!
//! Invariants: a slot is used in the part that has it alone; the types of one part are read before the next begins.
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

/// A body that has been lowered, with its signature.
pub struct Copy<'a> {
    /// The parameters.
    pub parameters: &'a [Parameter],
    /// The slot of the result.
    pub result: u32,
    /// The signature, in which each parameter has a name.
    pub signature: &'a syn::Signature,
    /// The body in its witness form.
    pub body: &'a syn::Block,
}

impl Copy<'_> {
    /// The parts, each telling `__told` the types of its slots.
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

    /// The closure of a part: of the parameters, or of the names that the part before passed on.
    ///
    /// Behind `__unreached` rustc infers types and has nothing left to check the borrows of: it does that in the original.
    /// What a closure gives cannot refer to what it is given.
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

    /// Tells the slots of the parameters their types. A type that is none of the DSL's is reported there.
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

/// The type of a function's result.
pub fn result_type(signature: &syn::Signature) -> TokenStream {
    match &signature.output {
        syn::ReturnType::Default => quote! { () },
        syn::ReturnType::Type(_, ty) => quote! { #ty },
    }
}

/// The slots between two places, around the copy of what is there, and what is reported them.
fn told(walk: &Lowering, (begin, end): (Begin, Begin), copy: &TokenStream) -> TokenStream {
    let slots: Vec<_> = (begin.slots..end.slots).map(lower::slot_name).collect();
    let callees: Vec<_> = (begin.callees..end.callees).map(lower::callee_name).collect();
    let owned: Vec<_> = (begin.operators..end.operators).map(lower::own_name).collect();
    let constants =
        walk.constants[begin.constants..end.constants].iter().map(|(slot, path, of)| {
            let slot = lower::slot_name(*slot);
            match of {
                Constant::Value => quote! { ::bessemer::generate::constant(__cx, &#slot, #path) },
                Constant::Made => quote! { ::bessemer::generate::made(__cx, &#slot, #path) },
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

/// Returns the ends of the parts: each at the end of a statement, and the last at that of the body.
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

/// The last statement in which each word stands: as a name, or in a text, which may be one that is filled with names.
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

/// Adds the names that statements bind to those that were bound before; one that hides another takes its place.
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
