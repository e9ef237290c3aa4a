//! Runs several passes of an outer loop at once, so that they share what they load.
//!
//! They are eight sums, or two to four passes that change the same element ([`carried`]).
//!
//! Precondition: an explicit function. A loop of this form, whose passes all load `taps[k]`:
//!
//! ```text
//! for n in 0..64 {                  for tile in 0..8 {
//!     let sum = 0.0;                    let sum = [0.0; 8];
//!     for k in 0..32 {                  for part in 0..8 { for k in 0..4 {
//!         sum += taps[k] * x[n + k];        for n in 0..8 { sum[n] += taps[4 * part + k] * x[8 * tile + n + …]; }
//!     }                                 } }
//!     y[n] = sum;                       for n in 0..8 { y[8 * tile + n] = sum[n]; }
//! }                                 }
//! ```
//!
//! Invariants: each sum has its terms in the author's order, so the bits are the same; the loop has no check, and reads
//! nothing that it writes. Must not know: the C, or processors, except that they have some twenty registers.

mod carried;

use bessemer_ir::effects::{calls, mentions, reads_place};
use bessemer_ir::visit::{Access, VisitMut, Walk, walk_expr_mut, walk_place_mut, walk_stmt_mut};
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Function, Local, LocalId, Mode, Module, Place, Span, Step,
    Stmt, StmtKind, Type,
};

use super::positions::Callee;

/// Number of sums at once.
const TILE: u64 = 8;
/// Numbers of terms of each sum whose loads are shared.
const PARTS: [u64; 2] = [8, 4];
/// Comment of the loop over tiles of sums.
const SUMS: &str = "Eight sums at once share what they load; each adds its terms in order.";
/// Largest number of expressions in a term.
const SMALL: usize = 16;

/// Returns a function with tiles; none if it has no such loop.
pub(super) fn tiled(module: &Module, callees: &[Callee], function: &Function) -> Option<Function> {
    // Names for parts of one memory would share it.
    let mut own = function.locals.iter().skip(function.params as usize);
    if own.any(|local| local.mode == Mode::RefMut) {
        return None;
    }
    let mut function = function.clone();
    let mut tiles =
        Tiles { module, callees, locals: std::mem::take(&mut function.locals), found: false };
    tiles.block(&mut function.body);
    function.locals = tiles.locals;
    tiles.found.then_some(function)
}

struct Tiles<'m> {
    module: &'m Module,
    /// Facts about the functions before this one.
    callees: &'m [Callee],
    locals: Vec<Local>,
    found: bool,
}

impl VisitMut for Tiles<'_> {
    fn stmt(&mut self, stmt: &mut Stmt) {
        let tile = self.tile(stmt).map(|kind| (kind, vec![SUMS.to_owned()]));
        match tile.or_else(|| self.carried(stmt)) {
            Some((kind, said)) => {
                stmt.kind = kind;
                stmt.comments.extend(said);
                self.found = true;
            }
            None => walk_stmt_mut(self, stmt),
        }
    }
}

/// A loop from zero without attributes.
struct Counted<'s> {
    variable: LocalId,
    to: &'s Expr,
    body: &'s Block,
}

impl Tiles<'_> {
    /// Returns the tiles of a loop, if it has the form.
    fn tile(&mut self, stmt: &Stmt) -> Option<StmtKind> {
        let outer = counted(stmt)?;
        let [first, adds, last] = &outer.body.0[..] else { return None };
        let StmtKind::Let { local: sum, value: Some(start) } = &first.kind else { return None };
        let inner = counted(adds)?;
        let [add] = &inner.body.0[..] else { return None };
        let StmtKind::Assign { place: added, value: next } = &add.kind else { return None };
        let StmtKind::Assign { place, value } = &last.kind else { return None };

        let passes = self.number(outer.to).filter(|passes| passes % TILE == 0)?;
        let whole = added.root == *sum && added.steps.is_empty();
        let plain = start.is_literal() && start.ty.as_float().is_some() && place.root != *sum;
        let separate =
            ![next, value, inner.to].into_iter().any(|it| calls(it) || reads_place(it, place))
                && !place
                    .steps
                    .iter()
                    .any(|step| indices(step).any(|it| calls(it) || reads_place(it, place)));
        let still = !mentions(inner.to, outer.variable) && !mentions(inner.to, *sum);
        let light = is_sum(next, *sum) && shares(next, outer.variable, *sum);
        if passes < 2 * TILE || !(whole && plain && separate && still && light) {
            return None;
        }

        let sums =
            self.local(*sum, Type::Array { element: Box::new(start.ty.clone()), len: TILE as u32 });
        let tile = self.named("tile", outer.to, stmt.span);
        let row = |tiles: &mut Self, like: &Stmt| {
            let n = tiles.local(outer.variable, outer.to.ty.clone());
            let at = Expr::local(n, &outer.to.ty, like.span);
            let start = times(Expr::local(tile, &outer.to.ty, like.span), TILE);
            let now = Expr::binary(BinaryOp::Add, start, at.clone());
            let mut moved = like.clone();
            Put { variable: outer.variable, now, sum: Some((*sum, sums, at)) }.stmt(&mut moved);
            written_out(n, Expr::literal_like(TILE, outer.to), Block(vec![moved]), TILE, like.span)
        };
        let ty = self.locals[sums.index()].ty.clone();
        let splat = Expr { kind: ExprKind::Splat(Box::new(start.clone())), ty, span: start.span };
        let begin = StmtKind::Let { local: sums, value: Some(splat) };
        let terms = row(self, add);
        let terms = self.parts(&inner, terms, &PARTS);
        let end = row(self, last);
        let body =
            vec![Stmt { kind: begin, ..first.clone() }, Stmt { kind: terms, ..adds.clone() }, end];
        Some(StmtKind::for_below(tile, Expr::literal_like(passes / TILE, outer.to), Block(body)))
    }

    /// Returns the loop over the terms, in parts of one of these lengths if it has whole ones.
    fn parts(&mut self, inner: &Counted<'_>, mut terms: Stmt, lengths: &[u64]) -> StmtKind {
        let (ty, span) = (inner.to.ty.clone(), terms.span);
        let k = self.local(inner.variable, ty.clone());
        let passes = self.number(inner.to).unwrap_or_default();
        let whole = |part: &u64| passes.is_multiple_of(*part) && passes > *part;
        let Some(count) = lengths.iter().copied().find(whole) else {
            let now = Expr::local(k, &ty, span);
            Put { variable: inner.variable, now, sum: None }.stmt(&mut terms);
            return StmtKind::for_below(k, inner.to.clone(), Block(vec![terms]));
        };
        let part = self.named("part", inner.to, span);
        let start = times(Expr::local(part, &ty, span), count);
        let now = Expr::binary(BinaryOp::Add, start, Expr::local(k, &ty, span));
        Put { variable: inner.variable, now, sum: None }.stmt(&mut terms);
        let few =
            written_out(k, Expr::literal_like(count, inner.to), Block(vec![terms]), count, span);
        StmtKind::for_below(part, Expr::literal_like(passes / count, inner.to), Block(vec![few]))
    }

    /// Returns the value of a constant bound.
    fn number(&self, bound: &Expr) -> Option<u64> {
        let pair = |a: &Expr, b: &Expr| self.number(a).zip(self.number(b));
        match &bound.kind {
            ExprKind::Literal(word) => Some(*word),
            ExprKind::Const(id) => self.module.consts[id.index()].words.first().copied(),
            ExprKind::Binary(BinaryOp::Sub, a, b) => pair(a, b).and_then(|(a, b)| a.checked_sub(b)),
            ExprKind::Binary(BinaryOp::Add, a, b) => pair(a, b).and_then(|(a, b)| a.checked_add(b)),
            _ => None,
        }
    }

    /// Adds a local with the name of another.
    fn local(&mut self, like: LocalId, ty: Type) -> LocalId {
        let local = Local { ty, ..self.locals[like.index()].clone() };
        self.locals.push(local);
        LocalId(self.locals.len() as u32 - 1)
    }

    /// Adds a counter.
    fn named(&mut self, name: &str, like: &Expr, span: Span) -> LocalId {
        let local = Local { name: name.to_owned(), ty: like.ty.clone(), mode: Mode::Value, span };
        self.locals.push(local);
        LocalId(self.locals.len() as u32 - 1)
    }
}

fn counted(stmt: &Stmt) -> Option<Counted<'_>> {
    match &stmt.kind {
        StmtKind::For {
            variable,
            from: Expr { kind: ExprKind::Literal(0), .. },
            to,
            inclusive: false,
            reversed: false,
            unroll: None,
            ended: false,
            body,
        } if to.ty == Type::USIZE => Some(Counted { variable: *variable, to, body }),
        _ => None,
    }
}

/// Returns a loop whose passes compilers write out.
fn written_out(variable: LocalId, to: Expr, body: Block, count: u64, span: Span) -> Stmt {
    let mut kind = StmtKind::for_below(variable, to, body);
    if let StmtKind::For { unroll, .. } = &mut kind {
        *unroll = Some(count as u32);
    }
    Stmt::new(kind, span)
}

fn times(value: Expr, factor: u64) -> Expr {
    let factor = Expr::literal_like(factor, &value);
    Expr::binary(BinaryOp::Mul, value, factor)
}

/// Returns the expressions in a step.
fn indices(step: &Step) -> impl Iterator<Item = &Expr> {
    let (one, other) = match step {
        Step::Field(_) => (None, None),
        Step::Index(index) | Step::From(index) => (Some(index), None),
        Step::Element(row, column) => (Some(row), Some(column)),
    };
    one.into_iter().chain(other)
}

/// Returns true if an expression is the sum and one more term.
fn is_sum(next: &Expr, sum: LocalId) -> bool {
    let ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, before, term) = &next.kind else {
        return false;
    };
    let before = matches!(&before.kind, ExprKind::Load(place) if place.root == sum && place.steps.is_empty());
    before && !mentions(&**term, sum)
}

/// Returns true if a short term loads one element that is the same in all passes, and one that differs.
fn shares(term: &Expr, variable: LocalId, sum: LocalId) -> bool {
    let (mut count, mut shared, mut differs) = (0, false, false);
    term.each_expr(|expr| {
        count += 1;
        if let ExprKind::Load(place) = &expr.kind
            && place.root != sum
            && place.steps.iter().any(|step| !matches!(step, Step::Field(_)))
        {
            let varies = mentions(expr, variable);
            (shared, differs) = (shared || !varies, differs || varies);
        }
    });
    count <= SMALL && shared && differs
}

/// Puts an expression in the place of a counter, and an element in the place of a sum.
struct Put {
    variable: LocalId,
    now: Expr,
    sum: Option<(LocalId, LocalId, Expr)>,
}

impl VisitMut for Put {
    fn expr(&mut self, expr: &mut Expr) {
        if matches!(&expr.kind, ExprKind::Load(place) if place.root == self.variable) {
            *expr = self.now.clone();
            return;
        }
        walk_expr_mut(self, expr);
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        walk_place_mut(self, place);
        if let Some((sum, sums, at)) = &self.sum
            && place.root == *sum
        {
            place.root = *sums;
            place.steps.insert(0, Step::Index(at.clone()));
        }
    }
}
