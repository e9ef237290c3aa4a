//! Makes each large local an alias of its memory, and passes memory to each call.
//!
//! A declaration becomes the alias, followed by the assignment of the first value, so the lifetime begins at the
//! author's declaration. A first value that is never read is not assigned ([`filled`](crate::filled)).

use std::collections::BTreeMap;

use bessemer_ir::visit::{self, Access, VisitMut};
use bessemer_ir::{
    Argument, Block, Expr, ExprKind, Function, LocalId, Mode, Module, Place, Span, Step, Stmt,
    StmtKind, Type,
};

use super::lives::{Life, What};
use super::row::Row;
use super::rows::Laid;
use crate::filled::filled;

/// Rewrites a function with `taken` additional parameters; `row` returns the place of a row.
pub(super) fn rewrite(
    module: &Module,
    function: &mut Function,
    taken: u32,
    lives: &[Life],
    laid: &[Laid],
    row: &dyn Fn(&Laid) -> Place,
) {
    let first = function.params - taken;
    let mut rewrite =
        Rewrite { module, first, taken, locals: BTreeMap::new(), calls: BTreeMap::new(), call: 0 };
    for (life, laid) in lives.iter().zip(laid) {
        match life.what {
            What::Local(id) => {
                let id = LocalId(id.0 + taken);
                let local = &mut function.locals[id.index()];
                local.mode = Mode::RefMut;
                let place = part(row(laid), laid.offset, &local.ty, &life.row);
                rewrite.locals.insert(id, place);
            }
            What::Call { call, .. } => {
                let place = part(row(laid), laid.offset, &life.row.ty(), &life.row);
                rewrite.calls.entry(call).or_default().push(place);
            }
        }
    }
    rewrite.block(&mut function.body);
}

/// Returns the part of a row at an offset.
fn part(mut row: Place, offset: u32, ty: &Type, own: &Row) -> Place {
    if row.ty == *ty {
        return row;
    }
    let at =
        Expr { kind: ExprKind::Literal(u64::from(offset)), ty: Type::USIZE, span: Span::default() };
    // One element is a value of its own.
    row.steps.push(if own.element == *ty { Step::Index(at) } else { Step::From(at) });
    Place { ty: ty.clone(), ..row }
}

struct Rewrite<'m> {
    module: &'m Module,
    /// First additional parameter of the function.
    first: u32,
    taken: u32,
    /// Place of each large local.
    locals: BTreeMap<LocalId, Place>,
    /// Memory that each call receives.
    calls: BTreeMap<usize, Vec<Place>>,
    /// Number of calls so far.
    call: usize,
}

impl Rewrite<'_> {
    fn renumbered(&self, local: LocalId) -> LocalId {
        if local.0 >= self.first { LocalId(local.0 + self.taken) } else { local }
    }

    /// Returns true if the first value of the local that the first statement declares is never read.
    fn is_filled(&self, stmts: &[Stmt]) -> bool {
        let [Stmt { kind: StmtKind::Let { local, value: Some(value) }, .. }, rest @ ..] = stmts
        else {
            return false;
        };
        let is_idle = match &value.kind {
            ExprKind::Splat(item) => matches!(item.kind, ExprKind::Literal(_)),
            ExprKind::Load(_) => true,
            _ => false,
        };
        self.locals.contains_key(local) && is_idle && filled(self.module, *local, &value.ty, rest)
    }
}

impl VisitMut for Rewrite<'_> {
    fn block(&mut self, block: &mut Block) {
        visit::walk_block_mut(self, block);
        let stmts = std::mem::take(&mut block.0);
        let filled: Vec<bool> = (0..stmts.len()).map(|at| self.is_filled(&stmts[at..])).collect();
        for (mut stmt, is_filled) in stmts.into_iter().zip(filled) {
            let mut behind = None;
            if let StmtKind::Let { local, value } = &mut stmt.kind
                && let Some(place) = self.locals.get(local)
            {
                let span = stmt.span;
                let place = Place { span, ..place.clone() };
                let (id, ty) = (*local, place.ty.clone());
                let kind = ExprKind::Load(place);
                behind = value.replace(Expr { kind, ty: ty.clone(), span }).map(|value| {
                    let place = Place { root: id, steps: Vec::new(), ty, span };
                    Stmt { kind: StmtKind::Assign { place, value }, span, comments: Vec::new() }
                });
            }
            block.0.push(stmt);
            block.0.extend(behind.filter(|_| !is_filled));
        }
    }

    fn expr(&mut self, expr: &mut Expr) {
        visit::walk_expr_mut(self, expr);
        if let ExprKind::Call(_, arguments) = &mut expr.kind {
            let lent = self.calls.get(&self.call).into_iter().flatten();
            arguments.extend(
                lent.map(|place| Argument::RefMut(Place { span: expr.span, ..place.clone() })),
            );
            self.call += 1;
        }
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        visit::walk_place_mut(self, place);
        place.root = self.renumbered(place.root);
    }

    fn declaration(&mut self, local: &mut LocalId) {
        *local = self.renumbered(*local);
    }
}
