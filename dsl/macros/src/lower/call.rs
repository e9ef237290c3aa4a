//! Calls: the witness copy calls the *companion* instead of the function.
//!
//! * `wrap(x)` becomes `wrap::__call(x)`: a struct with the function's name carries its companion, so aliases, globs
//!   and re-exports work.
//! * `x.torque(e)` becomes `x.__b_torque(e)`, and `Pid::new(…)` becomes `Pid::__b_new(…)`: the companion is beside
//!   the method, so rustc resolves it by its own rules.
//!
//! A companion returns the function's result, and its marker for a slot.

use bessemer_tree::{EACH, ExprKind};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;

use super::names::{SELF, callee_name, generating, text};
use super::pattern::is_constant_name;
use super::refuse;
use super::syntax::{is_constructor_name, last_segment};
use super::walk::Lowering;
use crate::numeric;
use crate::owned::{associated, of_libm, of_nalgebra, of_num_traits, of_turns};

impl Lowering {
    pub(super) fn call(&mut self, it: &mut syn::ExprCall) -> ExprKind {
        if matches!(&*it.func, syn::Expr::Path(it) if it.path.is_ident(EACH)) {
            let items = it.args.iter_mut().map(|item| self.whole(item)).collect();
            return ExprKind::Apply(EACH.to_owned(), items);
        }
        let arguments: Vec<_> =
            it.args.iter_mut().map(|argument| self.argument(argument)).collect();
        let syn::Expr::Path(function) = &mut *it.func else {
            return self.refused(&it.func, refuse::FUNCTION_VALUE);
        };
        if arguments.is_empty() && is_default(function) {
            return self.default_value(function);
        }
        let name = function.path.get_ident().map(text);
        if let Some(name) = name.as_ref().and_then(|name| self.called_name(name)) {
            return ExprKind::Apply(name, arguments);
        }
        let reason = match name.is_some_and(|name| self.is_local(&name)) {
            // A closure or a function pointer was refused where it came from.
            true => self.refusals.is_empty().then_some(refuse::NO_FUNCTION),
            false => self.redirected(function),
        };
        if let Some(reason) = reason {
            return self.refused(&function, reason);
        }
        let Some(companion) = companion(function, arguments.is_empty()) else {
            return ExprKind::Constructor(last_segment(&function.path), arguments);
        };
        function.path = companion;
        ExprKind::Call(self.take(it), arguments)
    }

    /// Redirects a path from nalgebra or `libm` to the DSL's function; returns the reason if it is not available.
    pub(super) fn redirected(&self, function: &mut syn::ExprPath) -> Option<refuse::Reason> {
        let own = of_libm(&function.path)
            .or_else(|| of_nalgebra(&function.path))
            .or_else(|| of_num_traits(&function.path));
        if let Some(own) = own.filter(|_| function.qself.is_none()) {
            function.path = own;
        }
        if let Some(own) = numeric::by_companions(function) {
            *function = own;
        }
        if function.qself.is_none() && self.is_itself(&function.path) {
            return Some(refuse::RECURSION);
        }
        out_of_reach(function)
    }

    /// Lowers `T::default()` to a constant, since it depends on nothing.
    fn default_value(&mut self, function: &syn::ExprPath) -> ExprKind {
        let mut path = function.path.clone();
        if let Some(last) = path.segments.last_mut() {
            last.ident = syn::Ident::new("DEFAULT", last.ident.span());
        }
        self.constant(quote! { #function() }, &path).kind
    }

    pub(super) fn method_call(&mut self, it: &mut syn::ExprMethodCall) -> ExprKind {
        let mut arguments = vec![self.value(&mut it.receiver)];
        // The C has no messages of panics, as `expect` and `expect_err` have them.
        let message = text(&it.method).trim_end_matches("_err") == "expect"
            && matches!(it.args.first(), Some(syn::Expr::Lit(it)) if matches!(it.lit, syn::Lit::Str(_)));
        if !message {
            arguments.extend(it.args.iter_mut().map(|argument| self.handed(argument)));
        }
        let own = matches!(&arguments[0].kind, ExprKind::Local(name) if name == SELF);
        if own && self.method && self.name.as_ref().is_some_and(|name| it.method == name) {
            return self.refused(&it.method, refuse::RECURSION);
        }
        it.method = companion_name(&it.method);
        ExprKind::Call(self.take_method(it), arguments)
    }

    /// Returns true if `path` names the function that is being lowered.
    fn is_itself(&self, path: &syn::Path) -> bool {
        let names: Vec<_> = path.segments.iter().map(|segment| text(&segment.ident)).collect();
        let Some(name) = self.name.as_deref() else { return false };
        match self.method {
            true => names == ["Self", name],
            false => names == [name] || names == [SELF, name],
        }
    }

    /// Writes `__take(&callee, call)` for a call of a companion, so that a slot learns which function it is.
    fn take(&mut self, it: &mut syn::ExprCall) -> u32 {
        let callee = self.callee();
        if generating() {
            let (name, call) = (callee_name(callee), it.clone());
            *it.func = syn::Expr::Verbatim(quote_spanned! { call.span() => __take });
            it.args = syn::parse_quote! { &#name, #call };
        }
        callee
    }

    /// Writes `callee.__take(call)`, so that the expression stays a method call.
    fn take_method(&mut self, it: &mut syn::ExprMethodCall) -> u32 {
        let callee = self.callee();
        if generating() {
            let (name, call) = (callee_name(callee), it.clone());
            *it.receiver = syn::Expr::Verbatim(quote_spanned! { call.span() => #name });
            it.method = syn::Ident::new("__take", call.method.span());
            it.turbofish = None;
            it.args = syn::parse_quote! { #call };
        }
        callee
    }
}

/// Returns the refusal of a function that its path shows to be unsupported, by the crate or the type in it.
fn out_of_reach(function: &syn::ExprPath) -> Option<refuse::Reason> {
    let names: Vec<_> = function.path.segments.iter().map(|segment| text(&segment.ident)).collect();
    let [.., owner, last] = names.as_slice() else { return None };
    // What is made of its parts has a type, of which rustc knows whether the DSL has it.
    if is_constructor_name(last) {
        return None;
    }
    let of_type = refuse::named_type(&syn::Ident::new(owner, function.span()).into());
    let outside = refuse::library(&function.path);
    if outside.is_some() && last == "discriminant" {
        return Some(refuse::VARIANT_VALUE);
    }
    // A companion of the type answers.
    let answered = bessemer_tree::number::is_number(owner)
        || is_constructor_name(owner) && outside.is_some_and(refuse::Reason::is_of_core);
    of_type.or(outside.filter(|_| !answered))
}

/// Returns true if an expression is a method call, possibly with `?`; its value may refer to an element.
pub(super) fn may_refer(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::MethodCall(_) | syn::Expr::Try(_) => true,
        syn::Expr::Paren(it) => may_refer(&it.expr),
        _ => false,
    }
}

fn is_default(function: &syn::ExprPath) -> bool {
    function.path.segments.len() + usize::from(function.qself.is_some()) > 1
        && function.path.segments.last().is_some_and(|last| last.ident == "default")
}

/// Returns the name of the companion of a method.
pub fn companion_name(method: &syn::Ident) -> syn::Ident {
    syn::Ident::new(&format!("__b_{}", text(method)), method.span())
}

/// Returns the path of the companion; none for a constructor. `is_empty` says that the call has no arguments.
pub(super) fn companion(function: &syn::ExprPath, is_empty: bool) -> Option<syn::Path> {
    let mut path = function.path.clone();
    let last = path.segments.last()?.clone();
    let of_type = associated(function.qself.as_ref(), &path);
    // `T::PI()` of `num_traits`: a variant without fields is not called.
    let in_capitals = of_type && is_empty && !is_constructor_name(&text(&last.ident));
    if is_constant_name(&last.ident) && !in_capitals {
        return None;
    }
    if of_type {
        let owner = path.segments.iter().rev().nth(1);
        let owned = owner.and_then(|owner| of_turns(&owner.ident, &last.ident));
        path.segments.last_mut()?.ident = companion_name(&owned.unwrap_or(last.ident));
    } else {
        // The arguments of a turbofish belong to the companion.
        let call = syn::PathSegment {
            ident: syn::Ident::new("__call", last.ident.span()),
            arguments: last.arguments,
        };
        path.segments.last_mut()?.arguments = syn::PathArguments::None;
        path.segments.push(call);
    }
    Some(path)
}
