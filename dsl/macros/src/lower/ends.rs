//! Ends of chains that are loops over what the chain gives: `.for_each(…)`, `.reduce(…)`.
//!
//! As in `rewrite`, the loop stands in their place in the tree and in the witness copy.

use syn::parse_quote;

use super::closure;
use super::names::text;
use super::syntax::is_ended;
use super::walk::Lowering;

impl Lowering<'_> {
    /// The loop that the end of a chain is; none if the call is something else.
    pub(super) fn ended(&mut self, it: &syn::ExprMethodCall) -> Option<syn::Expr> {
        if !is_ended(it, true) {
            return None;
        }
        let mut argument = it.args.first()?.clone();
        let name = text(&it.method);
        closure::in_full(&mut argument, name == "reduce");
        let syn::Expr::Closure(closure) = argument else { return None };
        self.check_closure(&closure);
        match (name.as_str(), closure.inputs.iter().collect::<Vec<_>>().as_slice()) {
            ("for_each", [item]) => Some(each(&it.receiver, item, &closure.body)),
            ("reduce", [so_far, next]) => Some(self.reduced(it, [so_far, next], &closure.body)),
            _ => None,
        }
    }

    /// `items.reduce(|so_far, next| …)`: the first, and what comes of it and of each of the others.
    fn reduced(
        &mut self,
        it: &syn::ExprMethodCall,
        [so_far, next]: [&syn::Pat; 2],
        body: &syn::Expr,
    ) -> syn::Expr {
        let items = &it.receiver;
        let [reduced, before, item] =
            ["reduced", "before", "item"].map(|name| self.fresh_beside(name, it));
        parse_quote! {
            {
                let mut #reduced = None;
                for #item in #items {
                    #reduced = Some(match #reduced {
                        Some(#before) => { let #so_far = #before; let #next = #item; #body }
                        None => #item,
                    });
                }
                #reduced
            }
        }
    }
}

/// `items.for_each(|item| …)`.
fn each(items: &syn::Expr, item: &syn::Pat, body: &syn::Expr) -> syn::Expr {
    let item = match item {
        syn::Pat::Type(it) => &*it.pat,
        other => other,
    };
    parse_quote! { for #item in #items { #body } }
}
