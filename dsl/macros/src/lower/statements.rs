//! Blocks and their statements: `let`, items, expressions for their effect.

use bessemer_tree as tree;
use quote::quote;
use syn::parse_quote;
use syn::punctuated::Punctuated;

use super::expr::is_unit_control;
use super::names::{site, slot_name, text};
use super::pattern::alone;
use super::syntax::bare;
use super::walk::Lowering;
use super::written::written;
use super::{pattern, refuse, signature};

impl Lowering {
    /// Lowers a block, which is the scope of its locals.
    pub fn block(&mut self, block: &mut syn::Block) -> tree::Block {
        self.scoped(|walk| walk.statements(&mut block.stmts))
    }

    pub(super) fn statements(&mut self, stmts: &mut Vec<syn::Stmt>) -> tree::Block {
        let mut lowered = tree::Block::default();
        self.ranges_with_names(stmts);
        let mut originals = std::mem::take(stmts);
        originals.retain(|stmt| !is_empty(stmt));
        originals.iter_mut().for_each(without_value);
        let last = originals.len().saturating_sub(1);
        let outermost = self.is_outermost();
        let imports = self.imports.len();
        for (index, mut stmt) in originals.into_iter().enumerate() {
            if outermost {
                self.begins.push(self.here(stmts.len()));
            }
            let mut looks = Vec::new();
            let (moved, at) =
                (self.begin_copies(written(&stmt), |it| it.stmt(&stmt)), lowered.stmts.len());
            match &mut stmt {
                syn::Stmt::Local(local) => lowered.stmts.extend(self.local(local, &mut looks)),
                // The names that it brings end with its block, where rustc finds them.
                syn::Stmt::Item(syn::Item::Use(it)) if !outermost => {
                    self.imports.push(it.clone());
                    self.end_copies(moved);
                    stmts.push(stmt);
                    continue;
                }
                syn::Stmt::Item(item) => {
                    self.item(item);
                    self.end_copies(moved);
                    continue;
                }
                syn::Stmt::Expr(expr, None) if index == last && !is_unit_control(expr) => {
                    lowered.tail = Some(Box::new(self.value(expr)));
                }
                syn::Stmt::Expr(expr, _) => {
                    lowered.stmts.push(tree::Stmt::Expr(self.statement(expr)));
                }
                syn::Stmt::Macro(mac) => {
                    lowered.stmts.extend(self.macro_call(&mut mac.mac).map(tree::Stmt::Expr));
                }
            }
            lowered.stmts.splice(at..at, self.end_copies(moved));
            stmts.push(stmt);
            stmts.extend(looks);
        }
        self.imports.truncate(imports);
        lowered
    }

    /// Returns true if a block is the body itself, whose names come behind those of the parameters.
    fn is_outermost(&self) -> bool {
        self.scopes.len() == 2
    }

    fn item(&mut self, item: &syn::Item) {
        let token = match item {
            syn::Item::Const(it) => it.const_token.span,
            syn::Item::Use(it) => it.use_token.span,
            syn::Item::Fn(it) => it.sig.fn_token.span,
            syn::Item::Static(it) if matches!(it.mutability, syn::StaticMutability::None) => {
                it.static_token.span
            }
            syn::Item::Static(it) => {
                return self.refusals.add(it.static_token.span, refuse::STATIC);
            }
            other => return self.refusals.add(refuse::first_token(other), refuse::NESTED_ITEM),
        };
        match self.is_outermost() {
            true => self.items.push(item.clone()),
            false => self.refusals.add(token, refuse::NESTED_CONST),
        }
    }

    /// Lowers a `let`; the statements that record the types of its names go to `looks`.
    fn local(&mut self, local: &mut syn::Local, looks: &mut Vec<syn::Stmt>) -> Vec<tree::Stmt> {
        let init = local.init.as_ref().filter(|it| it.diverge.is_none());
        let is_closure = init.is_some_and(|it| matches!(*it.expr, syn::Expr::Closure(_)));
        // What is changed is a value.
        let is_function =
            !is_mutable(&local.pat) && init.is_some_and(|it| self.names_function(&it.expr));
        if is_closure || is_function {
            return self.closure_local(local);
        }
        if let syn::Pat::Type(typed) = &local.pat {
            signature::check_type(&typed.ty, &mut self.refusals);
        }
        if local.init.is_none() {
            return self.later(local);
        }
        let lowered = match takes_apart(local) {
            true => self.apart(local, looks),
            false => self.named(local, looks),
        };
        lowered.into_iter().collect()
    }

    /// Lowers `let name;` or `let (a, [b, c]);`, whose names are assigned later, to a declaration of each.
    fn later(&mut self, local: &mut syn::Local) -> Vec<tree::Stmt> {
        let mut declared = Vec::new();
        match self.any_value(&mut local.pat, site(&local.let_token), &mut declared) {
            Some(value) => {
                local.init = Some(syn::LocalInit {
                    eq_token: Default::default(),
                    expr: Box::new(value),
                    diverge: None,
                });
            }
            None => self.refusals.add(&local.pat, refuse::LATER),
        }
        declared
    }

    /// Declares each name of a pattern of tuples and arrays. Returns the value in the witness copy, in which each name has a slot of
    /// its own; none for another pattern.
    fn any_value(
        &mut self,
        pattern: &mut syn::Pat,
        site: tree::Site,
        declared: &mut Vec<tree::Stmt>,
    ) -> Option<syn::Expr> {
        let mut each = |parts: &mut Punctuated<syn::Pat, syn::Token![,]>| {
            let parts = parts.iter_mut().map(|part| self.any_value(part, site, declared));
            parts.collect::<Option<Vec<_>>>()
        };
        match pattern {
            syn::Pat::Type(it) => self.any_value(&mut it.pat, site, declared),
            syn::Pat::Paren(it) => self.any_value(&mut it.pat, site, declared),
            syn::Pat::Tuple(it) => each(&mut it.elems).map(|parts| parse_quote! { (#(#parts,)*) }),
            syn::Pat::Slice(it) => each(&mut it.elems).map(|parts| parse_quote! { [#(#parts),*] }),
            syn::Pat::Ident(_) | syn::Pat::Wild(_) => {
                let mutable = is_mutable(pattern);
                let ident = pattern::simple_name(pattern, &mut self.refusals)?;
                let (slot, name) = (self.slot(), self.bind_here(&text(&ident)));
                pattern::make_mutable(pattern);
                declared.push(tree::Stmt::Let { name, slot, value: None, site, mutable });
                let slot = slot_name(slot);
                Some(syn::Expr::Verbatim(quote! { __any(&#slot) }))
            }
            _ => None,
        }
    }

    /// Lowers `let name = value;`.
    fn named(&mut self, local: &mut syn::Local, looks: &mut Vec<syn::Stmt>) -> Option<tree::Stmt> {
        let site = site(&local.let_token);
        if let Some(init) = &local.init
            && let syn::Expr::Range(syn::ExprRange {
                limits: syn::RangeLimits::HalfOpen(_), ..
            }) = bare(&init.expr)
        {
            self.refusals.add(&init.expr, refuse::RANGE_VALUE);
        }
        let value = self.value(&mut local.init.as_mut()?.expr);
        let ident = pattern::simple_name(&mut local.pat, &mut self.refusals)?;
        let (slot, mutable) = (self.slot(), is_mutable(&local.pat));
        let name = self.bind_here(&text(&ident));
        looks.push(self.look(slot, &ident));
        Some(tree::Stmt::Let { name, slot, value: Some(value), site, mutable })
    }

    /// Lowers `let pattern = value;`, possibly with an `else`.
    fn apart(&mut self, local: &mut syn::Local, looks: &mut Vec<syn::Stmt>) -> Option<tree::Stmt> {
        let (site, init) = (site(&local.let_token), local.init.as_mut()?);
        let lent = self.is_place(&init.expr);
        let value = self.whole(&mut init.expr);
        let otherwise = match init.diverge.as_mut().map(|(_, expr)| &mut **expr) {
            Some(syn::Expr::Block(it)) => {
                // It leaves: its last expression has no value, nor a type that a slot could be reported.
                if let Some(syn::Stmt::Expr(_, end)) = it.block.stmts.last_mut() {
                    end.get_or_insert_default();
                }
                Some(self.branch(&mut it.block, false))
            }
            _ => None,
        };
        pattern::brace_variants(&mut local.pat);
        let pattern = Box::new(self.pattern_of(lent, &local.pat, looks));
        Some(tree::Stmt::Apart { pattern, value, otherwise, site })
    }

    /// Lowers a destructured value; the parts of a tuple need not be built.
    pub(super) fn whole(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        match expr {
            syn::Expr::Paren(it) => self.whole(&mut it.expr),
            syn::Expr::Tuple(it) => {
                let parts = it.elems.iter_mut().map(|part| self.whole(part)).collect();
                tree::Expr { kind: tree::ExprKind::Tuple(parts), site: site(it), slot: None }
            }
            other => self.matched(other),
        }
    }

    /// Lowers a matched value. A slot records the type of an unsuffixed number, which may depend only on its use.
    fn matched(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        let mut value = self.value(expr);
        let number = value.is_unsuffixed();
        value.slot = value.slot.or_else(|| number.then(|| self.see(expr)));
        value
    }
}

/// Returns true for a semicolon without a statement.
fn is_empty(stmt: &syn::Stmt) -> bool {
    matches!(stmt, syn::Stmt::Expr(syn::Expr::Verbatim(tokens), Some(_)) if tokens.is_empty())
}

/// Gives the value of `Err(error)?;` a type: nothing determines it, and rustc would infer `!`, which no slot can
/// hold.
fn without_value(stmt: &mut syn::Stmt) {
    let tried = match stmt {
        syn::Stmt::Expr(tried, Some(_)) => tried,
        syn::Stmt::Local(syn::Local { pat: syn::Pat::Wild(_), init: Some(init), .. }) => {
            &mut *init.expr
        }
        _ => return,
    };
    if let syn::Expr::Try(it) = tried
        && let syn::Expr::Call(call) = &mut *it.expr
        && matches!(&*call.func, syn::Expr::Path(path) if path.path.is_ident("Err"))
    {
        *call.func = parse_quote! { Err::<(), _> };
    }
}

/// Returns true if a `let` destructures its value.
fn takes_apart(local: &syn::Local) -> bool {
    let bare = match &local.pat {
        syn::Pat::Type(it) => &it.pat,
        pattern => pattern,
    };
    let diverges = local.init.as_ref().is_some_and(|init| init.diverge.is_some());
    diverges || !matches!(bare, syn::Pat::Wild(_)) && alone(bare).is_none()
}

/// Returns true if a pattern binds a mutable name.
fn is_mutable(pattern: &syn::Pat) -> bool {
    match pattern {
        syn::Pat::Ident(it) => it.mutability.is_some(),
        syn::Pat::Reference(it) => is_mutable(&it.pat),
        syn::Pat::Paren(it) => is_mutable(&it.pat),
        syn::Pat::Type(it) => is_mutable(&it.pat),
        _ => false,
    }
}
