//! Loops without a range: `while` and `loop`, and the bound that they declare.
//!
//! `#[bound(64)]` above one says how many passes there may be. The native loop counts them down and
//! panics where another would begin, as the C reports a fault.

use bessemer_ir::tree::EACH;
use proc_macro2::Span;
use quote::quote_spanned;
use syn::visit::{self, Visit};

/// Takes the attribute that declares the bound.
pub fn take(attributes: &mut Vec<syn::Attribute>) -> Option<syn::Attribute> {
    let index = attributes.iter().position(|attribute| attribute.path().is_ident("bound"))?;
    Some(attributes.remove(index))
}

/// `#[bound(8)] let x = loop …` says it of the loop.
pub fn hand_on(local: &mut syn::Local) {
    if let Some(init) = &mut local.init
        && let syn::Expr::Loop(it) = &mut *init.expr
    {
        it.attrs.extend(take(&mut local.attrs));
    }
}

/// Makes a native loop count its passes.
pub fn count(expr: &mut syn::Expr) {
    let (attribute, body) = match expr {
        syn::Expr::While(it) => (take(&mut it.attrs), &mut it.body),
        syn::Expr::Loop(it) => (take(&mut it.attrs), &mut it.body),
        _ => return,
    };
    let Some(Ok(bound)) = attribute.map(|attribute| attribute.parse_args::<syn::Expr>()) else {
        return;
    };
    let left = syn::Ident::new("passes_left", Span::mixed_site());
    let span = Span::mixed_site();
    let counted = [
        quote_spanned! { span =>
            ::core::assert!(#left > 0, "the loop did not end within its bound");
        },
        quote_spanned! { span => #left -= 1; },
    ];
    for (index, statement) in counted.into_iter().enumerate() {
        body.stmts.insert(index, syn::Stmt::Expr(syn::Expr::Verbatim(statement), None));
    }
    *expr = syn::Expr::Verbatim(quote_spanned! { span => { let mut #left = #bound; #expr } });
}

/// Whether a `loop` ends in `break` with a value.
pub fn gives_value(it: &syn::ExprLoop) -> bool {
    Breaks::of(it).value
}

/// Whether nothing breaks a `loop`: it ends in `return` alone.
pub fn is_endless(it: &syn::ExprLoop) -> bool {
    !Breaks::of(it).any
}

/// Whether control may leave a loop by its body; what hands its items on is left by whoever goes through them.
pub fn is_left(body: &syn::Block) -> bool {
    let mut leaves = Leaves(false);
    leaves.visit_block(body);
    leaves.0
}

/// Looks for what leaves a loop, whichever.
struct Leaves(bool);

impl<'ast> Visit<'ast> for Leaves {
    fn visit_expr(&mut self, it: &'ast syn::Expr) {
        use syn::Expr::{Break, Return, Try};
        self.0 |= matches!(it, Break(_) | Return(_) | Try(_));
        visit::visit_expr(self, it);
    }
    fn visit_expr_call(&mut self, it: &'ast syn::ExprCall) {
        self.0 |= matches!(&*it.func, syn::Expr::Path(it) if it.path.is_ident(EACH));
        visit::visit_expr_call(self, it);
    }
    fn visit_expr_closure(&mut self, _: &'ast syn::ExprClosure) {}
}

/// The `break`s that leave one loop.
struct Breaks<'a> {
    label: Option<&'a syn::Ident>,
    depth: u32,
    any: bool,
    value: bool,
}

impl<'a> Breaks<'a> {
    fn of(it: &'a syn::ExprLoop) -> Breaks<'a> {
        let label = it.label.as_ref().map(|label| &label.name.ident);
        let mut breaks = Breaks { label, depth: 0, any: false, value: false };
        visit::visit_block(&mut breaks, &it.body);
        breaks
    }

    fn inside(&mut self, look: impl FnOnce(&mut Self)) {
        self.depth += 1;
        look(self);
        self.depth -= 1;
    }
}

impl<'ast> Visit<'ast> for Breaks<'_> {
    fn visit_expr_break(&mut self, it: &'ast syn::ExprBreak) {
        let ours = match &it.label {
            Some(label) => Some(&label.ident) == self.label,
            None => self.depth == 0,
        };
        self.any |= ours;
        self.value |= ours && it.expr.is_some();
        visit::visit_expr_break(self, it);
    }
    fn visit_expr_for_loop(&mut self, it: &'ast syn::ExprForLoop) {
        self.inside(|inner| visit::visit_expr_for_loop(inner, it));
    }
    fn visit_expr_while(&mut self, it: &'ast syn::ExprWhile) {
        self.inside(|inner| visit::visit_expr_while(inner, it));
    }
    fn visit_expr_loop(&mut self, it: &'ast syn::ExprLoop) {
        self.inside(|inner| visit::visit_expr_loop(inner, it));
    }
}
