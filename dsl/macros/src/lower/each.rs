//! `for` over the elements of arrays: `iter`, `enumerate`, `zip`, `rev`.
//!
//! The adaptors stay as they are in the witness copy; the names look at the types that they are given.

use bessemer_ir::tree::{self, ExprKind};
use syn::spanned::Spanned;

use super::{Lowering, refuse, text};

/// What a loop goes through.
pub(super) enum Source {
    One { array: Box<tree::Expr>, owned: bool },
    Zip(Box<Source>, Box<Source>),
}

impl Lowering<'_> {
    pub(super) fn each_loop(&mut self, it: &mut syn::ExprForLoop) -> Option<ExprKind> {
        let label = it.label.as_ref().map(|label| text(&label.name.ident));
        let before = self.refusals.len();
        let (mut indexed, mut reversed) = (false, false);
        let source = match &mut *it.expr {
            syn::Expr::MethodCall(call) if call.method == "enumerate" && call.args.is_empty() => {
                indexed = true;
                self.source(&mut call.receiver)
            }
            syn::Expr::MethodCall(call) if call.method == "rev" && call.args.is_empty() => {
                reversed = true;
                self.source(&mut call.receiver)
            }
            other => self.source(other),
        };
        if reversed && matches!(source, Source::Zip(..)) {
            self.refusals.add(it.expr.span(), refuse::ITERATOR);
        }
        let refused = self.refusals.len();
        self.scoped(|walk| {
            let (mut parts, mut looks) = (Vec::new(), Vec::new());
            let (index, elements) = match (indexed, &*it.pat) {
                (false, pattern) => (None, Some(pattern)),
                (true, syn::Pat::Tuple(pair)) if pair.elems.len() == 2 => {
                    (Some(&pair.elems[0]), Some(&pair.elems[1]))
                }
                (true, _) => (None, None),
            };
            let index = match index {
                Some(syn::Pat::Ident(name))
                    if name.by_ref.is_none()
                        && name.mutability.is_none()
                        && name.subpat.is_none() =>
                {
                    let name = text(&name.ident);
                    walk.bind(&name);
                    Some(name)
                }
                None | Some(syn::Pat::Wild(_)) => None,
                Some(other) => {
                    walk.refusals.add(other.span(), refuse::DESTRUCTURING);
                    None
                }
            };
            match elements {
                Some(pattern) => walk.elements(pattern, source, &mut parts, &mut looks),
                None => walk.refusals.add(it.pat.span(), refuse::DESTRUCTURING),
            }
            if refused > before {
                // What does not go through anything has no elements to tell about.
                walk.refusals.forget_since(refused);
            }
            let body = walk.branch(&mut it.body, false);
            it.body.stmts.splice(0..0, looks);
            Some(ExprKind::Each { label, index, parts, reversed, body })
        })
    }

    pub(super) fn source(&mut self, expr: &mut syn::Expr) -> Source {
        match expr {
            syn::Expr::Paren(it) if !matches!(&*it.expr, syn::Expr::Range(_)) => {
                self.source(&mut it.expr)
            }
            syn::Expr::MethodCall(it) if it.method == "zip" && it.args.len() == 1 => {
                let left = self.source(&mut it.receiver);
                Source::Zip(Box::new(left), Box::new(self.source(&mut it.args[0])))
            }
            syn::Expr::MethodCall(it) if it.args.is_empty() && is_adaptor(&it.method) => {
                let into = it.method == "into_iter";
                match self.source(&mut it.receiver) {
                    Source::One { array, owned } => Source::One { array, owned: owned && into },
                    zip => {
                        self.refusals.add(it.method.span(), refuse::ITERATOR);
                        zip
                    }
                }
            }
            other => {
                let owned = !matches!(other, syn::Expr::Reference(_));
                Source::One { array: Box::new(self.value(other)), owned }
            }
        }
    }

    pub(super) fn elements(
        &mut self,
        pattern: &syn::Pat,
        source: Source,
        parts: &mut Vec<tree::Part>,
        looks: &mut Vec<syn::Stmt>,
    ) {
        match (pattern, source) {
            (syn::Pat::Tuple(pair), Source::Zip(left, right)) if pair.elems.len() == 2 => {
                self.elements(&pair.elems[0], *left, parts, looks);
                self.elements(&pair.elems[1], *right, parts, looks);
            }
            (pattern, Source::One { array, owned }) => {
                let pattern = self.pattern(pattern, looks);
                parts.push(tree::Part { pattern, array: *array, owned });
            }
            (other, _) => self.refusals.add(other.span(), refuse::DESTRUCTURING),
        }
    }
}

fn is_adaptor(method: &syn::Ident) -> bool {
    ["iter", "iter_mut", "into_iter", "copied", "cloned"].iter().any(|name| method == name)
}

/// Whether a loop counts through a range.
pub fn is_range(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Range(_) => true,
        syn::Expr::Paren(it) => is_range(&it.expr),
        syn::Expr::MethodCall(it) => {
            (it.method == "rev" || it.method == "step_by") && is_range(&it.receiver)
        }
        _ => false,
    }
}
