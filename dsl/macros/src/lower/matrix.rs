//! nalgebra's methods that take a closure for each element of a matrix: `map`, `zip_map`, `apply`, `fold` and
//! the like, and `from_fn`.
//!
//! In the tree each is the loop that it stands for, by columns as nalgebra goes; in the witness copy it stays
//! a call, and the closure looks at what it is given.

use bessemer_ir::tree::{self, ExprKind, Start};
use quote::quote_spanned;
use syn::spanned::Spanned;

use super::closure::{closure_of, closure_parameter};
use super::flow::Source;
use super::made::{UNIT, plain};
use super::names::text;
use super::refuse;
use super::walk::Lowering;

/// The methods: how many arguments stand before the closure, and how many elements it takes.
const METHODS: [(&str, usize, usize); 6] = [
    ("zip_map", 1, 2),
    ("map_with_location", 0, 1),
    ("apply", 0, 1),
    ("zip_apply", 1, 2),
    ("fold", 1, 1),
    ("zip_fold", 2, 2),
];

impl Lowering<'_> {
    /// A method of matrices that takes a closure; none if the call is something else.
    pub(super) fn each_element(&mut self, it: &mut syn::ExprMethodCall) -> Option<ExprKind> {
        let name = text(&it.method);
        let (_, before, elements) = METHODS.into_iter().find(|(known, ..)| *known == name)?;
        let others = match name.as_str() {
            "map_with_location" => 2,
            "fold" | "zip_fold" => 1,
            _ => 0,
        };
        if !name.ends_with("apply") {
            self.function_as_closure(it, others + elements);
        }
        if it.args.len() != before + 1 || !matches!(it.args.last(), Some(syn::Expr::Closure(_))) {
            return None;
        }
        let mut arrays = vec![self.value(&mut it.receiver)];
        if elements == 2 {
            arrays.push(self.value(&mut it.args[0]));
        }
        let start = name.ends_with("fold").then(|| self.value(&mut it.args[before - 1]));
        let node = it.method.clone();
        let kind = self.scoped(|walk| {
            let closure = closure_of(it.args.last_mut()?)?;
            match name.as_str() {
                "fold" | "zip_fold" => walk.gathered(&node, closure, arrays, start?),
                "apply" | "zip_apply" => walk.applied(&node, closure, arrays),
                "map_with_location" => walk.located(&node, closure, arrays),
                _ => walk.mapped(&node, closure, arrays),
            }
        });
        Some(self.or_refused(kind, &node))
    }

    /// A function in the place of a closure: the closure that calls it.
    fn function_as_closure(&self, it: &mut syn::ExprMethodCall, parameters: usize) {
        let Some(syn::Expr::Path(function)) = it.args.last() else { return };
        if function.path.get_ident().is_some_and(|name| self.is_local(&text(name))) {
            return;
        }
        let span = proc_macro2::Span::mixed_site();
        let names = (0..parameters).map(|at| syn::Ident::new(&format!("value_{at}"), span));
        let names: Vec<_> = names.collect();
        let closure = quote_spanned! { function.span() => |#(#names),*| #function(#(#names),*) };
        if let (Ok(closure), Some(last)) = (syn::parse2(closure), it.args.last_mut()) {
            *last = closure;
        }
    }

    /// `Matrix3::from_fn(|row, column| …)`.
    pub(super) fn matrix_from_fn(&mut self, it: &mut syn::ExprCall) -> Option<ExprKind> {
        let syn::Expr::Path(function) = &*it.func else { return None };
        let node = function.path.segments.last()?.ident.clone();
        if node != "from_fn" || it.args.len() != 1 {
            return None;
        }
        let closure = closure_of(&mut it.args[0])?;
        if closure.inputs.len() != 2 {
            return None;
        }
        let kind = self.scoped(|walk| walk.located(&node, closure, Vec::new()));
        Some(self.or_refused(kind, &node))
    }

    fn or_refused(&mut self, kind: Option<ExprKind>, node: &syn::Ident) -> ExprKind {
        kind.unwrap_or_else(|| {
            self.refusals.add(node, refuse::CLOSURE_PARAMETERS);
            UNIT
        })
    }

    /// Names the elements for a closure, from one of its parameters on.
    fn element_names(
        &mut self,
        closure: &syn::ExprClosure,
        from: usize,
        arrays: Vec<tree::Expr>,
        looks: &mut Vec<syn::Stmt>,
    ) -> Option<Vec<tree::Part>> {
        let mut parts = Vec::new();
        if closure.inputs.len() != from + arrays.len() {
            return None;
        }
        self.apart = Some("");
        for (pattern, array) in closure.inputs.iter().skip(from).zip(arrays) {
            let source =
                Source::One { array: Box::new(array), owned: true, group: None, reversed: false };
            self.elements(pattern, source, &mut parts, looks);
        }
        self.apart = None;
        Some(parts)
    }

    /// `a.map(|x| …)`, `a.zip_map(&b, |x, y| …)`: the elements of another matrix.
    fn mapped(
        &mut self,
        node: &syn::Ident,
        closure: &mut syn::ExprClosure,
        arrays: Vec<tree::Expr>,
    ) -> Option<ExprKind> {
        let index = self.hidden("i");
        let mut looks = Vec::new();
        let parts = self.element_names(closure, 0, arrays, &mut looks)?;
        let value = self.closure_body(closure, looks);
        let name = self.hidden("mapped");
        let at = local(&index, node);
        let body = assigned(&name, at, value, node);
        let kind = ExprKind::Each {
            label: None,
            index: Some(index),
            parts,
            order: tree::Order::Up,
            cuts: Vec::new(),
            body,
        };
        Some(ExprKind::Fold { name, start: Start::Elements, each: Box::new(plain(kind, node)) })
    }

    /// The same by row and column: `a.map_with_location(|row, column, x| …)`.
    fn located(
        &mut self,
        node: &syn::Ident,
        closure: &mut syn::ExprClosure,
        arrays: Vec<tree::Expr>,
    ) -> Option<ExprKind> {
        let mut looks = Vec::new();
        let mut name_index = |walk: &mut Self, pattern: Option<&syn::Pat>, unnamed: &str| {
            if let Some(syn::Pat::Wild(_)) = pattern {
                return Some(walk.hidden(unnamed));
            }
            let index = closure_parameter(pattern?)?;
            let slot = walk.slot();
            looks.push(walk.look(slot, &index));
            Some(walk.bind_apart(&text(&index)))
        };
        let row = name_index(self, closure.inputs.get(0), "row")?;
        let column = name_index(self, closure.inputs.get(1), "column")?;
        let parts = self.element_names(closure, 2, arrays, &mut looks)?;
        let value = self.closure_body(closure, looks);
        let name = self.hidden("mapped");
        let at = ExprKind::Tuple(vec![*local(&row, node), *local(&column, node)]);
        let body = assigned(&name, Box::new(plain(at, node)), value, node);
        let of = local(&name, node);
        let kind = ExprKind::Grid { row, column, of, parts, body };
        Some(ExprKind::Fold { name, start: Start::Elements, each: Box::new(plain(kind, node)) })
    }

    /// `a.apply(|x| …)`, `a.zip_apply(&b, |x, y| …)`: what is done to each element.
    fn applied(
        &mut self,
        node: &syn::Ident,
        closure: &mut syn::ExprClosure,
        arrays: Vec<tree::Expr>,
    ) -> Option<ExprKind> {
        let mut looks = Vec::new();
        let mut parts = self.element_names(closure, 0, arrays, &mut looks)?;
        // What is changed is no copy.
        parts.iter_mut().for_each(|part| part.owned = false);
        let effect = self.closure_effect(closure, looks);
        let body = tree::Block { stmts: vec![tree::Stmt::Expr(effect)], tail: None };
        let kind = ExprKind::Each {
            label: None,
            index: None,
            parts,
            order: tree::Order::Up,
            cuts: Vec::new(),
            body,
        };
        let stmts = vec![tree::Stmt::Expr(plain(kind, node))];
        Some(ExprKind::Block(tree::Block { stmts, tail: None }))
    }

    /// `a.fold(start, |gathered, x| …)`, `a.zip_fold(&b, start, |gathered, x, y| …)`.
    fn gathered(
        &mut self,
        node: &syn::Ident,
        closure: &mut syn::ExprClosure,
        arrays: Vec<tree::Expr>,
        start: tree::Expr,
    ) -> Option<ExprKind> {
        let name = self.bind_apart(&text(&closure_parameter(closure.inputs.first()?)?));
        let mut looks = Vec::new();
        let parts = self.element_names(closure, 1, arrays, &mut looks)?;
        let value = self.closure_body(closure, looks);
        let assign = ExprKind::Assign(None, local(&name, node), Box::new(value));
        let body = tree::Block { stmts: vec![tree::Stmt::Expr(plain(assign, node))], tail: None };
        let kind = ExprKind::Each {
            label: None,
            index: None,
            parts,
            order: tree::Order::Up,
            cuts: Vec::new(),
            body,
        };
        let each = Box::new(plain(kind, node));
        Some(ExprKind::Fold { name, start: Start::Value(Box::new(start)), each })
    }
}

fn local(name: &str, node: &syn::Ident) -> Box<tree::Expr> {
    Box::new(plain(ExprKind::Local(name.to_owned()), node))
}

/// The block that assigns one element.
fn assigned(name: &str, at: Box<tree::Expr>, value: tree::Expr, node: &syn::Ident) -> tree::Block {
    let element = Box::new(plain(ExprKind::Index(local(name, node), at), node));
    let assign = plain(ExprKind::Assign(None, element, Box::new(value)), node);
    tree::Block { stmts: vec![tree::Stmt::Expr(assign)], tail: None }
}
