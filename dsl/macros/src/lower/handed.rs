//! Functions, constructors and constants as arguments: `readings.map(f64::from)`, `codes.map(Reading)`,
//! `self.set(Mode::Idle)`.
//!
//! Only rustc knows the number of a function's parameters, and if a capitalised name is a value or a constructor. So
//! the witness copy queries both, and the builder inserts the closure that calls the function.

use bessemer_tree as tree;
use bessemer_tree::ExprKind;
use quote::{quote, quote_spanned};
use syn::parse_quote;
use syn::spanned::Spanned;

use super::call::companion;
use super::names::{UNIT, callee_name, generating, plain, site, slot_name, text};
use super::syntax::{is_constructor_name, last_segment};
use super::walk::{Constant, Lowering, wrap};
use crate::owned::{associated, of_path};

impl Lowering {
    /// Lowers an argument of a method. A constant in small letters cannot be distinguished from a function, and is
    /// taken for one.
    pub(super) fn handed(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        match expr {
            syn::Expr::Path(it)
                if !it.path.get_ident().is_some_and(|it| self.is_local(&text(it))) =>
            {
                self.named_argument(expr)
            }
            _ => self.argument(expr),
        }
    }

    /// Lowers an argument that is a path and no local.
    pub(super) fn named_argument(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        let syn::Expr::Path(path) = &*expr else { return self.value(expr) };
        let last = last_segment(&path.path);
        let alone = path.path.get_ident().map(text);
        match alone.as_deref() {
            _ if is_small(&last) => self.function_argument(expr),
            // Rust's own, whose type only its use says.
            Some("None" | "PhantomData") => self.value(expr),
            Some("Some" | "Ok" | "Err") => {
                *expr = parse_quote! { |value| #path(value) };
                self.argument(expr)
            }
            _ if is_constructor_name(&last) => self.made_argument(expr),
            _ => self.value(expr),
        }
    }

    /// Lowers a function as an argument. The closure gets its parameters, and the call its arguments, when the types
    /// in its slot are known.
    fn function_argument(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        let syn::Expr::Path(function) = &*expr else { return self.value(expr) };
        let mut asked = function.clone();
        if let Some(reason) = self.redirected(&mut asked) {
            self.refusals.add(function, reason);
            return plain(UNIT, function);
        }
        let Some(companion) = companion(&asked, false) else { return plain(UNIT, function) };
        let native = native(function, &asked);
        let (place, span) = (site(function), function.span());
        let (arguments, result) = (self.slot(), self.slot());
        let callee = self.callee();
        if generating() {
            let [given, gives] = [arguments, result].map(slot_name);
            let callee = callee_name(callee);
            asked.path = companion;
            *expr = syn::Expr::Verbatim(quote_spanned! { span =>
                __function(&#callee, &#given, &#gives, #asked, #native)
            });
        }
        let kind = ExprKind::Call(callee, Vec::new());
        let body = Box::new(tree::Expr { kind, site: place, slot: Some(result) });
        let closure = tree::Closure { name: None, parameters: Vec::new(), body };
        tree::Expr { kind: ExprKind::Closure(closure), site: place, slot: Some(arguments) }
    }

    /// Lowers a variant, a struct, or a constructor of one.
    fn made_argument(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        let syn::Expr::Path(path) = &*expr else { return self.value(expr) };
        let made = self.evaluated(quote! { #path }, &path.path, Constant::Made);
        wrap(expr, "__made", made.slot.into_iter().map(slot_name));
        made
    }
}

/// Returns true if the name at the end of a path shows a function; `π` may be a constant.
pub(super) fn is_function(path: &syn::ExprPath) -> bool {
    let name = last_segment(&path.path);
    is_small(&name) && (name.is_ascii() || associated(path.qself.as_ref(), &path.path))
}

/// Returns true if a name is a function's, and not a constant's or a variant's: `_helper`, and neither `LIMIT` nor `_4_5`.
fn is_small(name: &str) -> bool {
    name.trim_start_matches('_').starts_with(char::is_lowercase)
}

/// Returns the native function, whose type in the witness copy shows its arguments, including references of any
/// lifetime.
fn native(function: &syn::ExprPath, asked: &syn::ExprPath) -> syn::ExprPath {
    let mut native =
        if associated(asked.qself.as_ref(), &asked.path) { asked } else { function }.clone();
    if associated(native.qself.as_ref(), &native.path)
        && let Some(name) = of_path(&native.path)
        && let Some(last) = native.path.segments.last_mut()
    {
        last.ident = name;
    }
    native
}
