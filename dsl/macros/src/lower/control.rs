//! Control flow: `if`, `match`, `for`, `return`.

use bessemer_ir::tree::{self, ExprKind};
use syn::spanned::Spanned;

use super::{Lowering, pattern, refuse, site, text};

impl Lowering<'_> {
    pub(super) fn if_expr(&mut self, it: &mut syn::ExprIf, value: bool) -> ExprKind {
        let condition = self.value(&mut it.cond);
        let then = self.branch(&mut it.then_branch, value);
        let otherwise = it.else_branch.as_mut().map(|(_, branch)| {
            let site = site(branch);
            let kind = match &mut **branch {
                syn::Expr::If(it) => self.if_expr(it, value),
                syn::Expr::Block(it) => ExprKind::Block(self.branch(&mut it.block, value)),
                other => return Box::new(self.value(other)),
            };
            Box::new(tree::Expr { kind, site, slot: None })
        });
        ExprKind::If(Box::new(condition), then, otherwise)
    }

    /// A branch of an `if`. Where no value is wanted, a tail without semicolon is a statement.
    fn branch(&mut self, block: &mut syn::Block, value: bool) -> tree::Block {
        let mut lowered = self.block(block);
        if !value && let Some(tail) = lowered.tail.take() {
            lowered.stmts.push(tree::Stmt::Expr(*tail));
        }
        lowered
    }

    pub(super) fn match_expr(&mut self, it: &mut syn::ExprMatch, value: bool) -> ExprKind {
        let scrutinee = self.value(&mut it.expr);
        let mut arms = Vec::new();
        for arm in &mut it.arms {
            let patterns = self.arm_values(&mut arm.pat);
            let body =
                if value { self.value(&mut arm.body) } else { self.statement(&mut arm.body) };
            arms.push(tree::Arm { patterns, body });
        }
        ExprKind::Match(Box::new(scrutinee), arms)
    }

    pub(super) fn for_loop(&mut self, it: &mut syn::ExprForLoop) -> Option<ExprKind> {
        if let Some(label) = &it.label {
            self.refusals.add(label.name.span(), refuse::LABEL);
        }
        let range = self.range(&mut it.expr);
        self.scoped(|walk| {
            let Some(ident) = pattern::simple_name(&it.pat, walk.refusals) else {
                walk.block(&mut it.body);
                return None;
            };
            let slot = walk.slot();
            let name = text(&ident);
            walk.bind(&name);
            let mut body = walk.block(&mut it.body);
            if let Some(tail) = body.tail.take() {
                body.stmts.push(tree::Stmt::Expr(*tail));
            }
            pattern::name_wild(&mut it.pat);
            it.body.stmts.insert(0, walk.look(slot, &ident));
            Some(ExprKind::For { name, slot, range: Box::new(range?), body })
        })
    }

    fn range(&mut self, expr: &mut syn::Expr) -> Option<tree::Range> {
        match expr {
            syn::Expr::Paren(it) => self.range(&mut it.expr),
            syn::Expr::MethodCall(it) if it.method == "rev" && it.args.is_empty() => {
                let range = self.range(&mut it.receiver)?;
                Some(tree::Range { reversed: !range.reversed, ..range })
            }
            syn::Expr::Range(it) => {
                let (Some(from), Some(to)) = (&mut it.start, &mut it.end) else {
                    self.refusals.add(it.limits.span(), refuse::OPEN_RANGE);
                    return None;
                };
                let inclusive = matches!(it.limits, syn::RangeLimits::Closed(_));
                let (from, to) = (self.value(from), self.value(to));
                Some(tree::Range { from, to, inclusive, reversed: false })
            }
            other => {
                self.refusals.add(other.span(), refuse::ITERATOR);
                None
            }
        }
    }

    pub(super) fn return_expr(&mut self, it: &mut syn::ExprReturn) -> ExprKind {
        ExprKind::Return(it.expr.as_mut().map(|value| Box::new(self.value(value))))
    }

    pub(super) fn refuse_label(
        &mut self,
        label: Option<&syn::Lifetime>,
        value: Option<&syn::Expr>,
    ) {
        if let Some(label) = label {
            self.refusals.add(label.span(), refuse::LABEL);
        }
        if let Some(value) = value {
            self.refusals.add(refuse::first_token(value), refuse::BREAK_VALUE);
        }
    }
}
