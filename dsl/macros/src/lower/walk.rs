//! The state of a walk over one function: the locals in scope, the slots so far, and the builder's further items.
//!
//! Must not know: syntax. Each form is lowered in a file of its own.

use bessemer_tree as tree;
use proc_macro2::TokenStream;
use quote::quote_spanned;

use super::names::{UNIT, generating, slot_name, span, text};
use super::refuse::{Place, Reason, Refusals};

/// The walk over one function.
#[derive(Default)]
pub struct Lowering {
    /// The refusals so far.
    pub refusals: Refusals,
    /// The locals in scope: the author's name, and that in the tree.
    pub(super) scopes: Vec<Vec<(String, String)>>,
    /// The names in the tree of closures.
    pub(super) closures: Vec<String>,
    /// The parameters that take closures.
    pub called: Vec<String>,
    /// True if the names of patterns are kept apart from those around them.
    pub(super) apart: bool,
    /// The names of the alternative before, which those behind it in a pattern share.
    pub(super) alternative: Vec<(String, String)>,
    pub(super) slots: u32,
    pub(super) callees: u32,
    /// The operators, which may be functions of a type that the library knows.
    pub operators: Vec<tree::Operator>,
    /// The slots of structs that are written out by their names: what they are an instance of may be an iterator.
    pub literals: Vec<u32>,
    /// True if what is lowered next is the left operand of an operator.
    pub(super) chained: bool,
    /// The names that the operands of the operator have that is being lowered, where they are names.
    pub(super) sides: [Option<syn::Ident>; 2],
    /// The statements of the witness copy before the operator that is being lowered: those of its left operand.
    pub(super) before: Vec<TokenStream>,
    /// Positions in the witness copy at which each statement begins, and at which the last ends.
    pub begins: Vec<Begin>,
    /// Paths that rustc has to evaluate: the slot, the path, and what it is that of.
    pub constants: Vec<(u32, TokenStream, Constant)>,
    /// The macros of Rust's that are called, each once.
    pub macros: Vec<syn::Ident>,
    /// `const` items of the body: the builder needs them too.
    pub items: Vec<syn::Item>,
    /// The function's own name, and whether it is a method: to tell a direct recursion. None where the type may have another
    /// method of this name, which Rust takes first.
    pub(super) name: Option<String>,
    pub(super) method: bool,
    /// True if what is matched is a place, so that `ref` in a pattern names a part of it.
    pub(super) lent: bool,
    /// The label of the closure's body that is being lowered, which `return` and `?` leave; none of a function's.
    pub(super) leaves: Option<String>,
    /// The names of the function that are declared `mut`.
    pub mutable: Vec<String>,
}

/// Position at which a statement begins: the counts of everything before it.
#[derive(Clone, Copy, Default)]
pub struct Begin {
    /// Statements of the witness copy.
    pub statements: usize,
    /// Slots.
    pub slots: u32,
    /// Callees.
    pub callees: u32,
    /// Operators.
    pub operators: usize,
    /// Constants.
    pub constants: usize,
}

/// A path that rustc evaluates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Constant {
    /// Slot of a value.
    Value,
    /// Slot of a value, or of an expression that makes one of its parts.
    Made,
}

impl Lowering {
    /// A walk over the function or method called `name`, with nothing seen yet.
    pub fn new(name: Option<&syn::Ident>, method: bool, refusals: Refusals) -> Lowering {
        let (scopes, name) = (vec![Vec::new()], name.map(text));
        Lowering { refusals, scopes, name, method, ..Lowering::default() }
    }

    /// Refuses what is at `place`; gives what represents it.
    pub(super) fn refused(&mut self, place: impl Place, reason: Reason) -> tree::ExprKind {
        self.refusals.add(place, reason);
        UNIT
    }

    /// Returns the position of the next node, after a number of statements of the witness copy.
    pub fn here(&self, statements: usize) -> Begin {
        Begin {
            statements,
            slots: self.slots,
            callees: self.callees,
            operators: self.operators.len(),
            constants: self.constants.len(),
        }
    }

    /// A fresh slot.
    pub fn slot(&mut self) -> u32 {
        self.slots += 1;
        self.slots - 1
    }

    /// A fresh slot for the function that is called.
    pub(super) fn callee(&mut self) -> u32 {
        self.callees += 1;
        self.callees - 1
    }

    /// Makes `name` a local of the innermost scope.
    pub fn bind(&mut self, name: &str) {
        self.bind_as(name, name);
    }

    /// Binds a name that neither hides another in the tree nor is hidden. A node that is moved keeps its meaning, even
    /// under a second name. Marks in such a name do not reach the C.
    pub(super) fn bind_apart(&mut self, name: &str) -> String {
        let apart = self.hidden(&format!("{name}%"));
        self.bind_as(name, &apart);
        apart
    }

    /// Makes `name` a local, kept apart where those of patterns are; gives its name in the tree.
    pub(super) fn bind_here(&mut self, name: &str) -> String {
        if self.apart {
            let known = self.alternative.iter().find(|(known, _)| known == name);
            return match known {
                Some((_, in_tree)) => in_tree.clone(),
                None => self.bind_apart(name),
            };
        }
        self.bind(name);
        name.to_owned()
    }

    /// A name in the tree for what the author has none for.
    pub(super) fn hidden(&mut self, name: &str) -> String {
        let mut hidden = name.to_owned();
        while self.scopes.iter().flatten().any(|(_, known)| *known == hidden) {
            hidden.push('%');
        }
        self.bind_as("", &hidden);
        hidden
    }

    pub(super) fn bind_as(&mut self, name: &str, in_tree: &str) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.push((name.to_owned(), in_tree.to_owned()));
        }
    }

    /// Returns the number of bindings of a name in scope.
    pub(super) fn bindings(&self, name: &str) -> usize {
        self.scopes.iter().flatten().filter(|(known, _)| known == name).count()
    }

    /// The name in the tree of a local.
    pub(super) fn local_name(&self, name: &str) -> Option<&str> {
        let found = self.scopes.iter().rev().flat_map(|scope| scope.iter().rev());
        found.into_iter().find(|(known, _)| known == name).map(|(_, in_tree)| in_tree.as_str())
    }

    pub(super) fn is_local(&self, name: &str) -> bool {
        self.local_name(name).is_some()
    }

    pub(super) fn scoped<T>(&mut self, walk: impl FnOnce(&mut Self) -> T) -> T {
        self.scopes.push(Vec::new());
        let closures = self.closures.len();
        let result = walk(self);
        self.scopes.pop();
        self.closures.truncate(closures);
        result
    }

    /// Turns `expr` into `see(&slot, expr)` and gives the slot.
    pub(super) fn see(&mut self, expr: &mut syn::Expr) -> u32 {
        let slot = self.slot();
        see_in(slot, expr);
        slot
    }

    /// Returns the slot of a value with references, as a type without their lifetime.
    pub(super) fn glance(&mut self, expr: &mut syn::Expr) -> u32 {
        let slot = self.slot();
        glance_in(slot, expr);
        slot
    }

    /// The statement `look(&slot, &place);`.
    pub(super) fn look(&self, slot: u32, place: &syn::Ident) -> syn::Stmt {
        let name = slot_name(slot);
        syn::Stmt::Expr(
            syn::Expr::Verbatim(quote_spanned! { place.span() => __look(&#name, &#place) }),
            Some(Default::default()),
        )
    }
}

pub(super) fn see_in(slot: u32, expr: &mut syn::Expr) {
    wrap(expr, "__see", [slot].into_iter().map(slot_name));
}

pub(super) fn glance_in(slot: u32, expr: &mut syn::Expr) {
    wrap(expr, "__glance", [slot].into_iter().map(slot_name));
}

/// Writes `function(&slot, …, expr)` for `expr`, in the witness copy alone.
pub(super) fn wrap(expr: &mut syn::Expr, function: &str, slots: impl Iterator<Item = syn::Ident>) {
    if generating() {
        let (function, span) = (syn::Ident::new(function, span(expr)), span(expr));
        *expr = syn::Expr::Verbatim(quote_spanned! { span => #function(#(&#slots,)* #expr) });
    }
}
