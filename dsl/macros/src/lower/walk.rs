//! State of a walk over one function: locals in scope, slots, and further items of the builder.
//!
//! Must not know: syntax. Each form is lowered in its own file.

use bessemer_tree as tree;
use proc_macro2::TokenStream;
use quote::quote_spanned;

use super::aliases::Aliases;
use super::names::{UNIT, generating, slot_name, span, text};
use super::refuse::{Place, Reason, Refusals};

/// State of a walk over one function.
#[derive(Default)]
pub struct Lowering {
    /// Refusals so far.
    pub refusals: Refusals,
    /// Locals in scope: the author's name, and the name in the tree.
    pub(super) scopes: Vec<Vec<(String, String)>>,
    /// Names of closures in the tree.
    pub(super) closures: Vec<String>,
    /// Named functions among them, each with its path.
    pub(super) functions: Vec<(String, syn::ExprPath)>,
    /// Parameters that take closures.
    pub called: Vec<String>,
    /// True if names of patterns are made unique.
    pub(super) apart: bool,
    /// Names of the previous alternative, which later alternatives of a pattern share.
    pub(super) alternative: Vec<(String, String)>,
    pub(super) slots: u32,
    pub(super) callees: u32,
    /// Operators, each of which may be a function of a library type.
    pub operators: Vec<tree::Operator>,
    /// Slots of struct literals, whose type may be an iterator.
    pub literals: Vec<u32>,
    /// True if the next expression is the left operand of an operator.
    pub(super) chained: bool,
    /// Names of the present operator's operands, where they are names.
    pub(super) sides: [Option<syn::Ident>; 2],
    /// Statements of the witness copy for the left operand of the present operator.
    pub(super) before: Vec<TokenStream>,
    /// Positions in the witness copy at the beginning of each statement, and at the end of the last.
    pub begins: Vec<Begin>,
    /// Paths that rustc must evaluate.
    pub constants: Vec<Evaluated>,
    /// Called macros of Rust, without duplicates.
    pub macros: Vec<syn::Ident>,
    /// `const` items of the body, which the builder also needs.
    pub items: Vec<syn::Item>,
    /// Imports of the open blocks but the body, with which their constants are evaluated.
    pub(super) imports: Vec<syn::ItemUse>,
    /// Name of the function, and if it is a method, to detect direct recursion. None where the type may have another
    /// method of this name, which Rust prefers.
    pub(super) name: Option<String>,
    pub(super) method: bool,
    /// True if the matched value is a place, so that `ref` in a pattern refers to a part of it.
    pub(super) lent: bool,
    /// Label of the closure body that is being lowered, which `return` and `?` leave; none in a function.
    pub(super) leaves: Option<String>,
    /// Names that the function declares `mut`.
    pub mutable: Vec<String>,
    /// Names through which statements of the function may write others.
    pub aliases: Aliases,
    /// Copies for `move` closures of the present statement; none where nothing can be declared before the closure.
    pub(super) moved: Option<Moved>,
}

/// Copies that the present statement, or closure body, declares before itself.
pub(super) struct Moved {
    /// Names that it writes outside `move` closures.
    pub(super) written: Vec<String>,
    /// Number of scopes at its beginning, and of names in the innermost.
    pub(super) known: (usize, usize),
    pub(super) copies: Vec<tree::Stmt>,
}

/// Position of a statement: the counts of everything before it.
#[derive(Clone, Copy, Default)]
pub struct Begin {
    /// Number of statements of the witness copy.
    pub statements: usize,
    /// Number of slots.
    pub slots: u32,
    /// Number of callees.
    pub callees: u32,
    /// Number of operators.
    pub operators: usize,
    /// Number of constants.
    pub constants: usize,
}

/// A path that rustc evaluates.
pub struct Evaluated {
    /// Slot of its type.
    pub slot: u32,
    /// Imports of the blocks around it.
    pub imports: Vec<syn::ItemUse>,
    /// The path.
    pub tokens: TokenStream,
    /// Kind of its value.
    pub constant: Constant,
}

/// Kind of a path that rustc evaluates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Constant {
    /// A value.
    Value,
    /// A value, or a constructor of one.
    Made,
}

impl Lowering {
    /// Returns the initial state for the function or method called `name`.
    pub fn new(name: Option<&syn::Ident>, method: bool, refusals: Refusals) -> Lowering {
        let (scopes, name) = (vec![Vec::new()], name.map(text));
        Lowering { refusals, scopes, name, method, ..Lowering::default() }
    }

    /// Refuses the code at `place`; returns the expression that replaces it.
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

    /// Returns a new slot.
    pub fn slot(&mut self) -> u32 {
        self.slots += 1;
        self.slots - 1
    }

    /// Returns a new slot for a callee.
    pub(super) fn callee(&mut self) -> u32 {
        self.callees += 1;
        self.callees - 1
    }

    /// Adds `name` as a local of the innermost scope.
    pub fn bind(&mut self, name: &str) {
        self.bind_as(name, name);
    }

    /// Binds a name that neither hides another in the tree nor is hidden, so that a moved node keeps its meaning.
    /// Marks in the name do not reach the C.
    pub(super) fn bind_apart(&mut self, name: &str) -> String {
        let apart = self.hidden(&format!("{name}%"));
        self.bind_as(name, &apart);
        apart
    }

    /// Adds `name` as a local, unique if names of patterns are; returns its name in the tree.
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

    /// Returns a free name in the tree for a value without an author's name.
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

    /// Returns the tree's name of a local.
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

    /// Replaces `expr` by `see(&slot, expr)` and returns the slot.
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

    /// Returns the statement `look(&slot, &place);`.
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

/// Replaces `expr` by `function(&slot, …, expr)`, only in the witness copy.
pub(super) fn wrap(expr: &mut syn::Expr, function: &str, slots: impl Iterator<Item = syn::Ident>) {
    if generating() {
        let (function, span) = (syn::Ident::new(function, span(expr)), span(expr));
        *expr = syn::Expr::Verbatim(quote_spanned! { span => #function(#(&#slots,)* #expr) });
    }
}
