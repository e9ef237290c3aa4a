//! From syn's tree to the tree that travels, and to the witness copy, in one walk.
//!
//! Each method lowers one syntactic form and at the same time turns it, in place, into its witness
//! form: the same code with every value passed through a slot, so that rustc's inference can be read
//! off. Spans, parentheses and the author's own `&` survive; an error in the copy is the original's.
//!
//! What the DSL does not take is refused at its own token, all of it at once ([`refuse`]).
//!
//! Must not know: types, or what a call means.

mod absent;
pub mod bound;
mod call;
mod chain;
mod closure;
mod control;
mod each;
mod ends;
mod expr;
mod flow;
pub mod halving;
mod item;
mod lines;
mod macros;
mod matrix;
mod named_view;
mod operator;
mod pattern;
pub mod refuse;
mod rewrite;
mod search;
mod signature;
pub mod sort;
mod strip;
pub mod unroll;
mod view;

use bessemer_ir::tree;
use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::ext::IdentExt;
use syn::spanned::Spanned;

pub use bessemer_ir::tree::Site;
pub use call::companion_name;
pub use macros::asked;
pub use pattern::member;
pub use refuse::Refusals;
pub use signature::{
    Parameter, check_field, gives_option, lends, name_parts, parameters, refuse_leaving,
};
pub use strip::{check_attributes, strip};

/// The walk over one function.
pub struct Lowering<'a> {
    /// What was refused so far.
    pub refusals: &'a mut Refusals,
    /// The locals in scope: the author's name, and that in the tree.
    scopes: Vec<Vec<(String, String)>>,
    /// The closures that have a name, by it.
    closures: Vec<closure::Closure>,
    /// The parameters that take closures.
    pub called: Vec<String>,
    /// Whether patterns are those of a closure, whose names are kept apart from those around it, with this mark.
    apart: Option<&'static str>,
    slots: u32,
    callees: u32,
    /// The operators, which may be functions of a type that the library knows.
    pub operators: Vec<tree::Operator>,
    /// Paths that rustc has to evaluate: the slot, and the path.
    pub constants: Vec<(u32, TokenStream)>,
    /// The macros of Rust's that are called, each once.
    pub macros: Vec<syn::Ident>,
    /// `const` items of the body: the builder needs them too.
    pub items: Vec<syn::Item>,
    /// The function's own name, and whether it is a method: to tell a direct recursion.
    name: String,
    method: bool,
    /// Whether what is matched is a place, so that `ref` in a pattern names a part of it.
    lent: bool,
    /// Whether the function gives an `Option`.
    pub optional: bool,
}

/// Whether this is a generation build. Elsewhere the walk only refuses: places cost a call into
/// rustc each, and nobody reads the witness copy.
pub const GENERATING: bool = cfg!(feature = "generate");

/// Line and column of a node, both from 1; unknown outside a generation build.
pub fn site(node: &impl Spanned) -> Site {
    if !GENERATING {
        return Site::default();
    }
    let start = node.span().start();
    Site(start.line as u32, start.column as u32 + 1)
}

/// A name as it travels: without the `r#` of a raw one.
pub fn text(ident: &syn::Ident) -> String {
    ident.unraw().to_string()
}

/// The name of a slot in the builder.
pub fn slot_name(slot: u32) -> syn::Ident {
    format_ident!("__s{slot}")
}

/// The name of a callee's slot in the builder.
pub fn callee_name(callee: u32) -> syn::Ident {
    format_ident!("__c{callee}")
}

/// The name of the slot of the author's own function behind an operator.
pub fn own_name(operator: usize) -> syn::Ident {
    format_ident!("__o{operator}")
}

impl<'a> Lowering<'a> {
    /// A walk over the function or method called `name`, with nothing seen yet.
    pub fn new(name: &syn::Ident, method: bool, refusals: &'a mut Refusals) -> Lowering<'a> {
        Lowering {
            refusals,
            scopes: vec![Vec::new()],
            closures: Vec::new(),
            called: Vec::new(),
            apart: None,
            slots: 0,
            callees: 0,
            operators: Vec::new(),
            constants: Vec::new(),
            macros: Vec::new(),
            items: Vec::new(),
            name: text(name),
            method,
            lent: false,
            optional: false,
        }
    }

    /// How many slots, and how many callees, the walk has used.
    pub fn counts(&self) -> (u32, u32) {
        (self.slots, self.callees)
    }

    /// A fresh slot.
    pub fn slot(&mut self) -> u32 {
        self.slots += 1;
        self.slots - 1
    }

    /// Makes `name` a local of the innermost scope.
    pub fn bind(&mut self, name: &str) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.push((name.to_owned(), name.to_owned()));
        }
    }

    /// The same under another name in the tree, if it would hide a local there: what is lowered out of
    /// its place keeps its meaning. Marks in a name of the tree do not reach the C.
    fn bind_apart(&mut self, name: &str) -> String {
        let apart = self.hidden(name);
        self.bind_as(name, &apart);
        apart
    }

    /// A name in the tree for what the author has none for.
    fn hidden(&mut self, name: &str) -> String {
        let mut hidden = name.to_owned();
        while self.scopes.iter().flatten().any(|(_, known)| *known == hidden) {
            hidden.push('%');
        }
        self.bind_as("", &hidden);
        hidden
    }

    fn bind_as(&mut self, name: &str, in_tree: &str) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.push((name.to_owned(), in_tree.to_owned()));
        }
    }

    /// How often a name was bound, as far as that is in scope.
    fn bindings(&self, name: &str) -> usize {
        self.scopes.iter().flatten().filter(|(known, _)| known == name).count()
    }

    /// The name in the tree of a local.
    fn local_name(&self, name: &str) -> Option<&str> {
        let found = self.scopes.iter().rev().flat_map(|scope| scope.iter().rev());
        found.into_iter().find(|(known, _)| known == name).map(|(_, in_tree)| in_tree.as_str())
    }

    fn is_local(&self, name: &str) -> bool {
        self.local_name(name).is_some()
    }

    fn scoped<T>(&mut self, walk: impl FnOnce(&mut Self) -> T) -> T {
        self.scopes.push(Vec::new());
        let closures = self.closures.len();
        let result = walk(self);
        self.scopes.pop();
        self.closures.truncate(closures);
        result
    }

    /// Turns `expr` into `see(&slot, expr)` and gives the slot.
    fn see(&mut self, expr: &mut syn::Expr) -> u32 {
        let slot = self.slot();
        self.see_in(slot, expr);
        slot
    }

    /// The same for a value with references in it, of which a slot holds the type without their lifetime.
    fn glance(&mut self, expr: &mut syn::Expr) -> u32 {
        let slot = self.slot();
        if GENERATING {
            let name = slot_name(slot);
            *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => __glance(&#name, #expr) });
        }
        slot
    }

    fn see_in(&self, slot: u32, expr: &mut syn::Expr) {
        if GENERATING {
            let name = slot_name(slot);
            *expr = syn::Expr::Verbatim(quote_spanned! { expr.span() => __see(&#name, #expr) });
        }
    }

    /// The statement `look(&slot, &place);`.
    fn look(&self, slot: u32, place: &syn::Ident) -> syn::Stmt {
        let name = slot_name(slot);
        syn::Stmt::Expr(
            syn::Expr::Verbatim(quote_spanned! { place.span() => __look(&#name, &#place) }),
            Some(Default::default()),
        )
    }

    /// The same for what a reference refers to.
    fn look_behind(&self, slot: u32, reference: &syn::Ident) -> syn::Stmt {
        let name = slot_name(slot);
        syn::Stmt::Expr(
            syn::Expr::Verbatim(
                quote_spanned! { reference.span() => __look(&#name, &*#reference) },
            ),
            Some(Default::default()),
        )
    }

    /// Lowers a block; its locals end with it.
    pub fn block(&mut self, block: &mut syn::Block) -> tree::Block {
        self.scoped(|walk| walk.statements(&mut block.stmts))
    }

    fn statements(&mut self, stmts: &mut Vec<syn::Stmt>) -> tree::Block {
        let mut lowered = tree::Block::default();
        self.views_with_names(stmts);
        let originals = std::mem::take(stmts);
        let last = originals.len().saturating_sub(1);
        for (index, mut stmt) in originals.into_iter().enumerate() {
            match &mut stmt {
                syn::Stmt::Local(local) => {
                    rewrite::or_return(local, self.optional);
                    if self.closure_local(local) {
                        stmts.push(stmt);
                        continue;
                    }
                    if takes_apart(local) && local.init.is_none() {
                        self.refusals.add(local.pat.span(), refuse::LATER);
                        continue;
                    }
                    if takes_apart(local) {
                        let (tree, looks) = self.apart(local);
                        lowered.stmts.push(tree);
                        stmts.push(stmt);
                        stmts.extend(looks);
                        continue;
                    }
                    let (tree, look) = self.local(local);
                    lowered.stmts.extend(tree);
                    stmts.push(stmt);
                    stmts.extend(look);
                    continue;
                }
                syn::Stmt::Item(item) => {
                    self.item(item);
                    continue;
                }
                syn::Stmt::Expr(expr, semicolon) => {
                    if semicolon.is_none() && index == last && !is_unit_control(expr) {
                        lowered.tail = Some(Box::new(self.value(expr)));
                    } else {
                        lowered.stmts.push(tree::Stmt::Expr(self.statement(expr)));
                    }
                }
                syn::Stmt::Macro(mac) => {
                    if let Some(tree) = self.macro_statement(mac) {
                        lowered.stmts.push(tree::Stmt::Expr(tree));
                    }
                }
            }
            stmts.push(stmt);
        }
        lowered
    }

    fn item(&mut self, item: &syn::Item) {
        match item {
            // The outermost block holds them after the scope of the parameters.
            syn::Item::Const(_) | syn::Item::Use(_) if self.scopes.len() == 2 => {
                self.items.push(item.clone())
            }
            syn::Item::Static(it)
                if self.scopes.len() == 2
                    && matches!(it.mutability, syn::StaticMutability::None) =>
            {
                self.items.push(item.clone())
            }
            syn::Item::Const(it) => self.refusals.add(it.const_token.span, refuse::NESTED_CONST),
            syn::Item::Use(it) => self.refusals.add(it.use_token.span, refuse::NESTED_CONST),
            syn::Item::Static(it) if matches!(it.mutability, syn::StaticMutability::None) => {
                self.refusals.add(it.static_token.span, refuse::NESTED_CONST);
            }
            syn::Item::Static(it) => self.refusals.add(it.static_token.span, refuse::STATIC),
            other => self.refusals.add(refuse::first_token(other), refuse::NESTED_ITEM),
        }
    }

    fn local(&mut self, local: &mut syn::Local) -> (Option<tree::Stmt>, Option<syn::Stmt>) {
        let site = site(&local.let_token);
        let value = local.init.as_mut().map(|init| self.value(&mut init.expr));
        if let syn::Pat::Type(typed) = &local.pat {
            signature::check_type(&typed.ty, self.refusals);
        }
        let Some(ident) = pattern::simple_name(&local.pat, self.refusals) else {
            return (None, None);
        };
        let slot = self.slot();
        pattern::name_wild(&mut local.pat);
        let name = text(&ident);
        self.bind(&name);
        let look = if local.init.is_some() {
            Some(self.look(slot, &ident))
        } else {
            pattern::make_mutable(&mut local.pat);
            let slot = slot_name(slot);
            local.init = Some(syn::LocalInit {
                eq_token: Default::default(),
                expr: Box::new(syn::Expr::Verbatim(quote! { __any(&#slot) })),
                diverge: None,
            });
            None
        };
        (Some(tree::Stmt::Let { name, slot, value, site }), look)
    }

    /// `let pattern = value;`, perhaps with an `else`.
    fn apart(&mut self, local: &mut syn::Local) -> (tree::Stmt, Vec<syn::Stmt>) {
        let site = site(&local.let_token);
        if let syn::Pat::Type(typed) = &local.pat {
            signature::check_type(&typed.ty, self.refusals);
        }
        let lent = local.init.as_ref().is_some_and(|init| self.is_place(&init.expr));
        let (mut value, mut otherwise) = (tree::Expr { kind: expr::UNIT, site, slot: None }, None);
        if let Some(init) = local.init.as_mut() {
            value = self.whole(&mut init.expr);
            if let Some((_, expr)) = &mut init.diverge {
                otherwise = match &mut **expr {
                    syn::Expr::Block(it) => Some(self.branch(&mut it.block, false)),
                    _ => None,
                };
            }
        }
        let mut looks = Vec::new();
        pattern::brace_variants(&mut local.pat);
        let pattern = Box::new(self.pattern_of(lent, &local.pat, &mut looks));
        (tree::Stmt::Apart { pattern, value, otherwise, site }, looks)
    }

    /// A value that is taken apart: the parts of a tuple need not become one.
    pub(super) fn whole(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        match expr {
            syn::Expr::Paren(it) => self.whole(&mut it.expr),
            syn::Expr::Tuple(it) => {
                let parts = it.elems.iter_mut().map(|part| self.whole(part)).collect();
                tree::Expr { kind: tree::ExprKind::Tuple(parts), site: site(it), slot: None }
            }
            other => self.value(other),
        }
    }

    fn macro_statement(&mut self, mac: &mut syn::StmtMacro) -> Option<tree::Expr> {
        self.macro_call(&mut mac.mac)
    }

    /// Lowers `assert!(condition)` and the like, `panic!()` and the like; every other macro is refused.
    fn macro_call(&mut self, mac: &mut syn::Macro) -> Option<tree::Expr> {
        use syn::punctuated::Punctuated;
        let span = mac.path.span();
        let name =
            mac.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        let compared = match name.as_str() {
            "assert" | "assert_eq" | "assert_ne" | "panic" | "unreachable" | "todo"
            | "unimplemented"
                if !self.is_rusts(&mac.path) =>
            {
                self.refusals.add(span, refuse::MACRO);
                return None;
            }
            "assert" | "__inside" | "__room" | "__between" => None,
            "assert_eq" => Some(tree::BinaryOp::Eq),
            "assert_ne" => Some(tree::BinaryOp::Ne),
            "panic" | "unreachable" | "todo" | "unimplemented" => {
                // What the message would show is not computed.
                mac.tokens = TokenStream::new();
                let never = tree::ExprKind::Bool(false);
                let site = site(&mac.path);
                let never = Box::new(tree::Expr { kind: never, site, slot: None });
                let kind = tree::ExprKind::Assert(never, tree::Claim::Assertion);
                return Some(tree::Expr { kind, site, slot: None });
            }
            _ => {
                self.refusals.add(span, refuse::macro_call(&name));
                return None;
            }
        };
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        let Ok(mut arguments) = mac.parse_body_with(parser) else {
            self.refusals.add(span, refuse::SYNTAX);
            return None;
        };
        let site = site(&mac.path);
        let first = self.value(arguments.first_mut()?);
        let condition = match compared {
            None => {
                let witness = &arguments[0];
                mac.tokens = quote! { #witness };
                first
            }
            Some(op) => {
                let second = self.value(arguments.get_mut(1)?);
                let (left, right) = (&arguments[0], &arguments[1]);
                mac.tokens = quote! { #left, #right };
                let kind = tree::ExprKind::Binary(op, Box::new(first), Box::new(second));
                tree::Expr { kind, site, slot: None }
            }
        };
        let claim = match name.as_str() {
            "__inside" => tree::Claim::Index,
            "__room" => tree::Claim::Capacity,
            "__between" => tree::Claim::Clamp,
            _ => tree::Claim::Assertion,
        };
        let kind = tree::ExprKind::Assert(Box::new(condition), claim);
        Some(tree::Expr { kind, site, slot: None })
    }
}

/// `matches!(value, pattern if guard)` as the `match` that it stands for.
pub fn matching(mac: &syn::Macro) -> Option<syn::ExprMatch> {
    use syn::parse::ParseStream;
    let parser = |input: ParseStream<'_>| {
        let value: syn::Expr = input.parse()?;
        input.parse::<syn::Token![,]>()?;
        Ok((value, input.parse::<TokenStream>()?))
    };
    let (value, rest) = mac.parse_body_with(parser).ok()?;
    let mut arm: Vec<_> = rest.into_iter().collect();
    arm.pop_if(|token| matches!(token, proc_macro2::TokenTree::Punct(it) if it.as_char() == ','));
    syn::parse2(quote! { match #value { #(#arm)* => true, _ => false } }).ok()
}

/// `vector![a, b]`, `matrix![a, b; c, d]` as the call that they stand for.
pub fn by_rows(mac: &syn::Macro) -> Option<syn::Expr> {
    use syn::punctuated::Punctuated;
    type Elements = Punctuated<syn::Expr, syn::Token![,]>;
    let name = &mac.path.segments.last()?.ident;
    let rows: Vec<Vec<syn::Expr>> = if name == "vector" {
        let column = mac.parse_body_with(Elements::parse_terminated).ok()?;
        column.into_iter().map(|element| vec![element]).collect()
    } else if name == "matrix" {
        let parser = Punctuated::<_, syn::Token![;]>::parse_terminated_with;
        let row = |input: syn::parse::ParseStream<'_>| Elements::parse_separated_nonempty(input);
        let rows =
            mac.parse_body_with(|input: syn::parse::ParseStream<'_>| parser(input, row)).ok()?;
        rows.into_iter().map(|row| row.into_iter().collect()).collect()
    } else {
        return None;
    };
    Some(syn::parse_quote! { ::bessemer::linear::by_rows([#([#(#rows),*]),*]) })
}

/// Whether a `let` takes its value apart.
fn takes_apart(local: &syn::Local) -> bool {
    let simple = |pattern: &syn::Pat| match pattern {
        syn::Pat::Ident(it) => it.by_ref.is_none() && it.subpat.is_none(),
        syn::Pat::Wild(_) => true,
        _ => false,
    };
    let diverges = local.init.as_ref().is_some_and(|init| init.diverge.is_some());
    diverges
        || !match &local.pat {
            syn::Pat::Type(it) => simple(&it.pat),
            pattern => simple(pattern),
        }
}

/// Whether an expression at the end of a block is a statement all the same: loops, `if` without
/// `else`, assignments.
fn is_unit_control(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::ForLoop(_)
        | syn::Expr::While(_)
        | syn::Expr::Assign(_)
        | syn::Expr::Return(_) => true,
        syn::Expr::Loop(it) => !bound::gives_value(it) && !bound::is_endless(it),
        syn::Expr::If(it) => it.else_branch.is_none(),
        syn::Expr::Binary(it) => expr::compound(&it.op).is_some(),
        _ => false,
    }
}
