//! Changes of the native item by the attributes.
//!
//! A closed set of scalar methods is redirected to the DSL, and loops with a declared bound count their iterations.
//!
//! `x.sin()` becomes `x.dsl_sin()`, and `f64::sin(x)` becomes `f64::dsl_sin(x)` (for every type, since `f64` may have
//! an alias); traits of `bessemer::math` implement them. A prelude trait would not work, since inherent methods have
//! priority: `abs` is always core's, and `sin` is std's as soon as any linked crate uses std.

use proc_macro2::Span;
use syn::visit_mut::{self, VisitMut};

use crate::generics::Scope;
use crate::imports;
use crate::lower::macros::{expanded, in_every_build};
use crate::lower::{Refusals, generating, loops, sort};
use crate::numeric;
use crate::owned::{associated, by_method, of_libm, of_path, owned};

/// Writes the body that Rust runs, or the errors in its place. rustc then reports nothing else about the item, and
/// callers still find the function.
pub fn native(
    (attributes, body): (&mut Vec<syn::Attribute>, &mut syn::Block),
    scope: Scope<'_>,
    refusals: Refusals,
) {
    // A generation build runs what its constants call, and nothing else: rustc makes machine code of a function that is
    // `inline` where it is called alone.
    if generating() && !attributes.iter().any(|it| it.path().is_ident("inline")) {
        attributes.push(syn::parse_quote!(#[inline]));
    }
    if refusals.is_empty() {
        return block(body, scope);
    }
    attributes.push(syn::parse_quote!(#[allow(unused, clippy::all)]));
    // An item of the body is not there any more.
    let has_items = body.stmts.iter().any(|it| matches!(it, syn::Stmt::Item(_)));
    let lookups = if has_items { Default::default() } else { refusals.lookups() };
    let errors = refusals.into_tokens();
    let errors = quote::quote! { #lookups #errors };
    body.stmts = vec![syn::Stmt::Expr(syn::Expr::Verbatim(errors), None)];
}

/// Rewrites every call in `block`, and imports the DSL's traits into its scope; if `scope` has type parameters that
/// are floats, also their traits.
fn block(block: &mut syn::Block, scope: Scope<'_>) {
    let mut redirect = Redirect { used: false, imported: Vec::new() };
    redirect.visit_block_mut(block);
    if redirect.used {
        let import = syn::parse_quote_spanned! { Span::call_site() =>
            #[allow(unused_imports)]
            use ::bessemer::math::{
                AbsentMethods as _, AngleMethods as _, BetweenMethods as _, ByteMethods as _, ComplexMethods as _, DivisionMethods as _, ElementaryMethods as _, EulerMethods as _, FloatMethods as _, MatrixMethods as _,
                OrderMethods as _, RankMethods as _, RealMethods as _, RotationMethods as _, RoundMethods as _, SearchMethods as _,
                SignMethods as _, SquareMethods as _, TotalMethods as _, TurnMethods as _,
            };
        };
        block.stmts.insert(0, import);
        let numbers = scope.numbers().into_iter().map(|name| -> syn::Stmt {
            let name = quote::format_ident!("{name}Methods");
            syn::parse_quote! { #[allow(unused_imports)] use ::bessemer::math::#name as _; }
        });
        block.stmts.splice(0..0, numbers);
    }
    let imported = redirect.imported.iter().map(|name| -> syn::Stmt {
        // The import stays used.
        syn::parse_quote! { const _: () = { let _ = #name; }; }
    });
    block.stmts.splice(0..0, imported);
}

struct Redirect {
    used: bool,
    /// The functions of `libm` that the author calls by an imported name.
    imported: Vec<syn::Ident>,
}

impl VisitMut for Redirect {
    /// Skips an inner function, which has its own attribute.
    fn visit_item_fn_mut(&mut self, _: &mut syn::ItemFn) {}

    fn visit_local_mut(&mut self, it: &mut syn::Local) {
        loops::hand_on(it);
        visit_mut::visit_local_mut(self, it);
    }

    fn visit_expr_mut(&mut self, expr: &mut syn::Expr) {
        let stands_for = match expr {
            syn::Expr::Macro(it) => expanded(&it.mac),
            syn::Expr::MethodCall(it) => sort::sorted(it, sort::Leg::Native),
            syn::Expr::Call(it) => by_method(it, numeric::is_of_num_traits),
            _ => None,
        };
        if let Some(other) = stands_for {
            *expr = other;
        }
        visit_mut::visit_expr_mut(self, expr);
        loops::native(expr);
    }

    fn visit_expr_method_call_mut(&mut self, call: &mut syn::ExprMethodCall) {
        visit_mut::visit_expr_method_call_mut(self, call);
        // `min` and `max` of an iterator take nothing.
        let gathers = call.args.is_empty() && (call.method == "min" || call.method == "max");
        if let (Some(name), false) = (owned(&call.method), gathers) {
            call.method = name;
            self.used = true;
        }
    }

    fn visit_expr_path_mut(&mut self, path: &mut syn::ExprPath) {
        visit_mut::visit_expr_path_mut(self, path);
        if let Some(own) = of_libm(&path.path).filter(|_| path.qself.is_none()) {
            self.imported.extend(imports::bare(&path.path).map(|it| it.ident.clone()));
            path.path = own;
        } else if let Some(bare) = imports::bare(&path.path).cloned() {
            path.path = bare.into();
        }
        if associated(path.qself.as_ref(), &path.path)
            && let Some(name) = of_path(&path.path)
            && let Some(last) = path.path.segments.last_mut()
        {
            last.ident = name;
            self.used = true;
        }
    }

    /// Rewrites the expressions in assertions, which are tokens.
    fn visit_macro_mut(&mut self, mac: &mut syn::Macro) {
        use syn::punctuated::Punctuated;
        in_every_build(mac);
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        if let Ok(mut arguments) = mac.parse_body_with(parser) {
            for argument in &mut arguments {
                self.visit_expr_mut(argument);
            }
            mac.tokens = quote::ToTokens::into_token_stream(arguments);
        }
    }
}
