//! Names that code has, and names that it may write, by its text alone.
//!
//! Invariant: a name that code itself may write is found; rather one too many. The body of a `move` closure runs later, and
//! does not count.
//!
//! Must not know: types; what another name refers to.

use syn::visit::{self, Visit};

use super::names::text;
use super::syntax::bare;

/// Returns the names that a statement may write outside `move` closures, and outside the blocks that come after its head.
pub(super) fn written(stmt: &syn::Stmt) -> Vec<String> {
    Written::of(|it| match stmt {
        syn::Stmt::Local(local) => {
            local.init.iter().for_each(|init| it.visit_expr(&init.expr));
        }
        syn::Stmt::Expr(expr, _) => it.head(expr),
        other => it.visit_stmt(other),
    })
}

/// Visitor that collects the names that may be written.
pub(super) struct Written(Vec<String>);

impl Written {
    pub(super) fn of(visit: impl FnOnce(&mut Written)) -> Vec<String> {
        let mut written = Written(Vec::new());
        visit(&mut written);
        written.0
    }

    /// Visits what runs before the blocks of a statement, each of which has statements of its own.
    pub(super) fn head(&mut self, expr: &syn::Expr) {
        match expr {
            syn::Expr::If(it) => {
                self.visit_expr(&it.cond);
                it.else_branch.iter().for_each(|(_, otherwise)| self.head(otherwise));
            }
            syn::Expr::Match(it) => {
                self.visit_expr(&it.expr);
                for arm in &it.arms {
                    if let syn::Pat::Guard(it) = &arm.pat {
                        self.visit_expr(&it.guard);
                    }
                }
            }
            syn::Expr::ForLoop(it) => self.visit_expr(&it.expr),
            syn::Expr::While(it) => self.visit_expr(&it.cond),
            syn::Expr::Block(_) | syn::Expr::Loop(_) | syn::Expr::Unsafe(_) => {}
            other => self.visit_expr(other),
        }
    }

    /// Notes the variable of a place.
    pub(super) fn note(&mut self, place: &syn::Expr) {
        match bare(place) {
            syn::Expr::Path(it) => self.0.extend(it.path.get_ident().map(text)),
            syn::Expr::Field(it) => self.note(&it.base),
            syn::Expr::Index(it) => self.note(&it.expr),
            syn::Expr::Unary(it) => self.note(&it.expr),
            syn::Expr::Tuple(it) => it.elems.iter().for_each(|part| self.note(part)),
            syn::Expr::Array(it) => it.elems.iter().for_each(|part| self.note(part)),
            syn::Expr::Reference(it) => self.note(&it.expr),
            syn::Expr::MethodCall(it) => self.note(&it.receiver),
            _ => {}
        }
    }
}

impl<'ast> Visit<'ast> for Written {
    fn visit_expr_assign(&mut self, it: &'ast syn::ExprAssign) {
        self.note(&it.left);
        visit::visit_expr_assign(self, it);
    }

    fn visit_expr_binary(&mut self, it: &'ast syn::ExprBinary) {
        // Any other operator takes values.
        if is_assignment(&it.op) {
            self.note(&it.left);
        }
        visit::visit_expr_binary(self, it);
    }

    fn visit_expr_reference(&mut self, it: &'ast syn::ExprReference) {
        if it.mutability.is_some() {
            self.note(&it.expr);
        }
        visit::visit_expr_reference(self, it);
    }

    fn visit_expr_method_call(&mut self, it: &'ast syn::ExprMethodCall) {
        self.note(&it.receiver);
        visit::visit_expr_method_call(self, it);
    }

    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        // A name that a pattern binds, or a variable that it borrows.
        self.0.push(text(&it.ident));
    }

    fn visit_expr_closure(&mut self, it: &'ast syn::ExprClosure) {
        if it.capture.is_none() {
            visit::visit_expr_closure(self, it);
        }
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        fn all(tokens: proc_macro2::TokenStream, found: &mut Vec<String>) {
            for token in tokens {
                match token {
                    proc_macro2::TokenTree::Ident(ident) => found.push(text(&ident)),
                    proc_macro2::TokenTree::Group(group) => all(group.stream(), found),
                    _ => {}
                }
            }
        }
        all(it.tokens.clone(), &mut self.0);
    }
}

/// Returns true for `+=` and its like.
fn is_assignment(op: &syn::BinOp) -> bool {
    use syn::BinOp::{
        AddAssign, BitAndAssign, BitOrAssign, BitXorAssign, DivAssign, MulAssign, RemAssign,
        ShlAssign, ShrAssign, SubAssign,
    };
    matches!(
        op,
        AddAssign(_)
            | SubAssign(_)
            | MulAssign(_)
            | DivAssign(_)
            | RemAssign(_)
            | BitXorAssign(_)
            | BitAndAssign(_)
            | BitOrAssign(_)
            | ShlAssign(_)
            | ShrAssign(_)
    )
}

/// Names in code outside `move` closures, which run later.
pub(super) struct Named(Vec<String>);

impl Named {
    pub(super) fn of(visit: impl FnOnce(&mut Named)) -> Vec<String> {
        let mut named = Named(Vec::new());
        visit(&mut named);
        named.0
    }

    /// Notes the names of a statement but those that it binds.
    pub(super) fn stmt(&mut self, stmt: &syn::Stmt) {
        match stmt {
            syn::Stmt::Local(local) => local.init.iter().for_each(|it| self.visit_local_init(it)),
            other => self.visit_stmt(other),
        }
    }
}

impl<'ast> Visit<'ast> for Named {
    fn visit_ident(&mut self, it: &'ast syn::Ident) {
        self.0.push(text(it));
    }

    fn visit_expr_closure(&mut self, it: &'ast syn::ExprClosure) {
        if it.capture.is_none() {
            visit::visit_expr_closure(self, it);
        }
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        let mut written = Written::of(|written| written.visit_macro(it));
        self.0.append(&mut written);
    }
}
