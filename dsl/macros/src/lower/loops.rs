//! Attributes of loops, and exits from loops.
//!
//! `#[bound(64)]` above a `while`, a `loop`, or a `for` over an author-defined iterator declares the largest number
//! of passes. The native loop counts them and panics where another would begin, as the C reports a fault.
//! `#[unroll(4)]` and `#[keep]` above a `for` are hints for C compilers; the native loop has no effect of them.

use bessemer_tree::EACH;
use proc_macro2::Span;
use quote::quote_spanned;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Attributes of a loop without a range.
pub(super) const BOUND: &[&str] = &["bound"];
/// Hints to C compilers for a `for`.
pub(super) const HINTS: &[&str] = &["unroll", "keep"];
/// Attributes of a `for`; a bound is allowed over an author-defined iterator.
const OF_FOR: &[&str] = &[HINTS[0], HINTS[1], BOUND[0]];

/// Returns the span of a bound among attributes.
pub(super) fn bound_at(attributes: &[syn::Attribute]) -> Option<Span> {
    let is_bound = |it: &&syn::Attribute| BOUND.iter().any(|name| it.path().is_ident(name));
    attributes.iter().find(is_bound).map(|it| it.path().span())
}

/// Removes and returns the first attribute with one of these names.
pub(super) fn take(attributes: &mut Vec<syn::Attribute>, names: &[&str]) -> Option<syn::Attribute> {
    let is_one = |it: &syn::Attribute| names.iter().any(|name| it.path().is_ident(name));
    let index = attributes.iter().position(is_one)?;
    Some(attributes.remove(index))
}

/// Returns the attributes of a loop, and the names of the DSL's attributes that it may have.
fn attributes(expr: &mut syn::Expr) -> Option<(&mut Vec<syn::Attribute>, &'static [&'static str])> {
    Some(match expr {
        syn::Expr::While(it) => (&mut it.attrs, BOUND),
        syn::Expr::Loop(it) => (&mut it.attrs, BOUND),
        syn::Expr::ForLoop(it) => (&mut it.attrs, OF_FOR),
        _ => return None,
    })
}

/// Calls `visit` with an expression whose loop attributes are removed meanwhile.
pub(super) fn without(expr: &mut syn::Expr, visit: impl FnOnce(&mut syn::Expr)) {
    let attribute = attributes(expr).and_then(|(all, names)| take(all, names));
    visit(expr);
    attributes(expr).into_iter().for_each(|(all, _)| all.extend(attribute.clone()));
}

/// Moves the bound in `#[bound(8)] let x = loop …` to the loop.
pub fn hand_on(local: &mut syn::Local) {
    if let Some(init) = &mut local.init
        && let syn::Expr::Loop(it) = &mut *init.expr
    {
        it.attrs.extend(take(&mut local.attrs, BOUND));
    }
}

/// Makes a native loop count its passes, if it has a bound.
pub fn native(expr: &mut syn::Expr) {
    let attribute = attributes(expr).and_then(|(all, names)| take(all, names));
    let body = match expr {
        syn::Expr::While(it) => &mut it.body,
        syn::Expr::Loop(it) => &mut it.body,
        syn::Expr::ForLoop(it) => &mut it.body,
        _ => return,
    };
    let Some(attribute) = attribute.filter(|it| !HINTS.iter().any(|hint| it.path().is_ident(hint)))
    else {
        return;
    };
    let Ok(bound) = attribute.parse_args::<syn::Expr>() else { return };
    let span = Span::mixed_site();
    let left = syn::Ident::new("passes_left", span);
    let counted = quote_spanned! { span =>
        ::core::assert!(#left > 0, "the loop did not end within its bound");
        #left -= 1;
    };
    body.stmts.insert(0, syn::Stmt::Expr(syn::Expr::Verbatim(counted), None));
    *expr = syn::Expr::Verbatim(quote_spanned! { span => { let mut #left = #bound; #expr } });
}

/// Returns true if a `loop` ends in `break` with a value.
pub(super) fn gives_value(it: &syn::ExprLoop) -> bool {
    Exits::of(&it.body, it.label.as_ref()).value
}

/// Returns true if no `break` leaves a `loop`; only `return` ends it.
pub(super) fn is_endless(it: &syn::ExprLoop) -> bool {
    !Exits::of(&it.body, it.label.as_ref()).breaks
}

/// Returns true if the body may leave its loop.
pub(super) fn is_left(body: &syn::Block) -> bool {
    Exits::of(body, None).any
}

/// Visitor that finds the exits of a loop.
struct Exits<'a> {
    label: Option<&'a syn::Ident>,
    /// Number of inner loops around the present node.
    depth: u32,
    /// True if a `break` leaves the loop; another flag records that it has a value.
    breaks: bool,
    value: bool,
    /// True if anything may leave the loop, or a loop in it.
    any: bool,
}

impl<'a> Exits<'a> {
    fn of(body: &'a syn::Block, label: Option<&'a syn::Label>) -> Exits<'a> {
        let label = label.map(|label| &label.name.ident);
        let mut exits = Exits { label, depth: 0, breaks: false, value: false, any: false };
        exits.visit_block(body);
        exits
    }
}

impl<'ast> Visit<'ast> for Exits<'_> {
    fn visit_expr(&mut self, it: &'ast syn::Expr) {
        use syn::Expr::{Break, Call, Closure, ForLoop, Loop, Return, Try, While};
        let inner = u32::from(matches!(it, ForLoop(_) | While(_) | Loop(_)));
        match it {
            Closure(_) => return,
            Break(it) => {
                let ours = match &it.label {
                    Some(label) => Some(&label.ident) == self.label,
                    None => self.depth == 0,
                };
                self.breaks |= ours;
                self.value |= ours && it.expr.is_some();
                self.any = true;
            }
            Return(_) | Try(_) => self.any = true,
            Call(it) => {
                self.any |= matches!(&*it.func, syn::Expr::Path(it) if it.path.is_ident(EACH));
            }
            _ => {}
        }
        self.depth += inner;
        visit::visit_expr(self, it);
        self.depth -= inner;
    }
}
