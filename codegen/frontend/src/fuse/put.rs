//! Substitutes values of temporaries for their reads.
//!
//! Must not know: why a temporary is substituted.

use bessemer_ir::visit::{
    Access, VisitMut, walk_block_mut, walk_expr_mut, walk_place_mut, walk_stmt_mut,
};
use bessemer_ir::{Block, Expr, ExprKind, Function, LocalId, Place, Stmt, StmtKind};

use super::decide::Decided;

/// Substitutes the values of the locals that go where they are read, and removes checks. With `blanks`, an empty statement
/// replaces each declaration and check, so that indices of statements stay.
pub(super) fn put(body: &mut Block, decided: &Decided, blanks: bool) {
    let Decided { gone, repeated } = decided;
    let values = vec![None; gone.len()];
    Put { gone, values, checks: repeated.iter().rev(), blanks }.block(body);
}

/// Removes the substituted locals from the table and renumbers the others.
pub(super) fn close_ranks(function: &mut Function, gone: &[bool]) {
    let mut next = 0;
    let to = gone.iter().map(|gone| {
        let to = LocalId(next);
        next += u32::from(!gone);
        to
    });
    Renumber(to.collect()).block(&mut function.body);
    let mut stays = gone.iter().map(|gone| !gone);
    function.locals.retain(|_| stays.next().unwrap_or(true));
}

/// Substitutes values of temporaries for their reads, statement by statement.
struct Put<'g> {
    gone: &'g [bool],
    values: Vec<Option<Expr>>,
    /// For each remaining check, from the last on: true if it is removed.
    checks: std::iter::Rev<std::slice::Iter<'g, bool>>,
    blanks: bool,
}

impl VisitMut for Put<'_> {
    fn block(&mut self, block: &mut Block) {
        let mut comments = Vec::new();
        for mut stmt in std::mem::take(&mut block.0) {
            let check = matches!(stmt.kind, StmtKind::Check { .. });
            let repeated = check && self.checks.next() == Some(&true);
            if !repeated {
                walk_stmt_mut(self, &mut stmt);
            }
            comments.append(&mut stmt.comments);
            match stmt.kind {
                StmtKind::Let { local, value } if self.gone[local.index()] => {
                    self.values[local.index()] = value;
                }
                _ if repeated => {}
                kind => {
                    let comments = std::mem::take(&mut comments);
                    block.0.push(Stmt { kind, span: stmt.span, comments });
                    continue;
                }
            }
            if self.blanks {
                let nothing = StmtKind::Expr(Expr::bool(true, stmt.span));
                block.0.push(Stmt::new(nothing, stmt.span));
            }
        }
    }

    fn expr(&mut self, expr: &mut Expr) {
        if let ExprKind::Load(place) = &expr.kind
            && place.steps.is_empty()
            && let value = &mut self.values[place.root.index()]
            && let Some(known) = value
        {
            // A name is read often; a computed value is read once.
            *expr = match is_name(known) {
                true => known.clone(),
                false => value.take().unwrap_or_else(|| expr.clone()),
            };
            return;
        }
        walk_expr_mut(self, expr);
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        walk_place_mut(self, place);
        if let Some(Expr { kind: ExprKind::Load(of), .. }) = &self.values[place.root.index()] {
            place.root = of.root;
            place.steps.splice(0..0, of.steps.iter().cloned());
        }
    }
}

/// Returns true for a literal, a constant, a place, and a conversion of these.
fn is_name(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Literal(_) | ExprKind::Const(_) | ExprKind::Load(_) => true,
        ExprKind::Cast(inner) => is_name(inner),
        _ => false,
    }
}

/// Replaces each local's handle by its new one.
struct Renumber(Vec<LocalId>);

impl VisitMut for Renumber {
    fn block(&mut self, block: &mut Block) {
        walk_block_mut(self, block);
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        self.declaration(&mut place.root);
        walk_place_mut(self, place);
    }

    fn declaration(&mut self, local: &mut LocalId) {
        *local = self.0[local.index()];
    }
}
