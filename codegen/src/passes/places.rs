//! What expressions read, what statements write, and which places may be the same memory.
//!
//! Two different locals never share memory: references are exclusive, as in Rust.

use bessemer_ir::visit::{Access, Visit, VisitMut, walk_expr, walk_expr_mut, walk_place};
use bessemer_ir::visit::{walk_place_mut, walk_stmt};
use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, LocalId, Place, Routine, Span, Step, Stmt, StmtKind, Type,
};

/// Whether two places may share memory.
pub(crate) fn overlap(a: &Place, b: &Place) -> bool {
    a.root == b.root && !a.steps.iter().zip(&b.steps).any(|(a, b)| apart(a, b))
}

/// Whether two steps out of one place surely lead to different parts.
fn apart(a: &Step, b: &Step) -> bool {
    match (a, b) {
        (Step::Field(a), Step::Field(b)) => a != b,
        (Step::Index(a), Step::Index(b)) => different(a, b),
        (Step::Element(a, c), Step::Element(b, d)) => different(a, b) || different(c, d),
        _ => false,
    }
}

fn different(a: &Expr, b: &Expr) -> bool {
    matches!((&a.kind, &b.kind), (ExprKind::Literal(a), ExprKind::Literal(b)) if a != b)
}

/// The whole of a local, as something that is written.
pub(crate) fn whole(local: LocalId) -> Place {
    Place { root: local, steps: Vec::new(), ty: Type::Unit, span: Span::default() }
}

/// A local as a value.
pub(crate) fn load(local: LocalId, ty: &Type, span: Span) -> Expr {
    let place = Place { root: local, steps: Vec::new(), ty: ty.clone(), span };
    Expr { kind: ExprKind::Load(place), ty: ty.clone(), span }
}

/// Sets the spans of an expression, by what they are.
struct Locate<F>(F);

impl<F: Fn(Span) -> Span> VisitMut for Locate<F> {
    fn expr(&mut self, expr: &mut Expr) {
        expr.span = (self.0)(expr.span);
        walk_expr_mut(self, expr);
    }
    fn place(&mut self, place: &mut Place, _: Access) {
        place.span = (self.0)(place.span);
        walk_place_mut(self, place);
    }
}

/// The same expression without its spans, to compare with others.
pub(crate) fn erased(expr: &Expr) -> Expr {
    let mut expr = expr.clone();
    Locate(|_| Span::default()).expr(&mut expr);
    expr
}

/// The same expression; what comes from nowhere comes from `span`.
pub(crate) fn located(mut expr: Expr, span: Span) -> Expr {
    let nowhere = Span::default();
    Locate(|it| if it == nowhere { span } else { it }).expr(&mut expr);
    expr
}

struct Reads<'a> {
    written: &'a [Place],
    found: bool,
}

impl Visit for Reads<'_> {
    fn place(&mut self, place: &Place, _: Access) {
        self.found |= self.written.iter().any(|written| overlap(place, written));
        walk_place(self, place);
    }
}

/// Whether the value of `expr` may change when `written` are written.
pub(crate) fn reads(expr: &Expr, written: &[Place]) -> bool {
    let mut reads = Reads { written, found: false };
    reads.expr(expr);
    reads.found
}

/// Whether `place` may become another place when `written` are written.
pub(crate) fn moves(place: &Place, written: &[Place]) -> bool {
    let mut reads = Reads { written, found: false };
    walk_place(&mut reads, place);
    reads.found
}

#[derive(Default)]
struct Writes(Vec<Place>);

impl Visit for Writes {
    fn stmt(&mut self, stmt: &Stmt) {
        // `x = x;` changes nothing, and is dropped.
        if !is_idle(stmt) {
            walk_stmt(self, stmt);
        }
    }
    fn place(&mut self, place: &Place, access: Access) {
        if access != Access::Read {
            self.0.push(place.clone());
        }
        walk_place(self, place);
    }
    fn declaration(&mut self, local: &LocalId) {
        self.0.push(whole(*local));
    }
}

/// All that `stmts` may write, the locals they declare among it.
pub(crate) fn writes<'a>(stmts: impl IntoIterator<Item = &'a Stmt>) -> Vec<Place> {
    let mut writes = Writes::default();
    stmts.into_iter().for_each(|stmt| writes.stmt(stmt));
    writes.0
}

/// All that the calls in `expr` may write.
pub(crate) fn lent(expr: &Expr) -> Vec<Place> {
    let mut writes = Writes::default();
    writes.expr(expr);
    writes.0
}

/// All that the calls in the indices of a place may write.
pub(crate) fn lent_by_indices(place: &Place) -> Vec<Place> {
    place.steps.iter().flat_map(lent_by_step).collect()
}

/// All that the calls in an index may write.
pub(crate) fn lent_by_step(step: &Step) -> Vec<Place> {
    match step {
        Step::Field(_) => Vec::new(),
        Step::Index(index) | Step::From(index) => lent(index),
        Step::Element(row, column) => [lent(row), lent(column)].concat(),
    }
}

/// How much text an expression makes: what is written twice should be light.
pub(crate) fn weight(expr: &Expr) -> usize {
    struct Weight(usize);
    impl Visit for Weight {
        fn expr(&mut self, expr: &Expr) {
            self.0 += match &expr.kind {
                ExprKind::Call(..) | ExprKind::Routine(..) => 100,
                ExprKind::Intrinsic(..) => 3,
                _ => 1,
            };
            walk_expr(self, expr);
        }
    }
    let mut weight = Weight(0);
    weight.expr(expr);
    weight.0
}

/// Whether a routine works element by element, so that it may nest.
pub(crate) fn elementwise(routine: Routine) -> bool {
    match routine {
        Routine::Add
        | Routine::Sub
        | Routine::Neg
        | Routine::Scale
        | Routine::Unscale
        | Routine::ComponentMul
        | Routine::ComponentDiv => true,
        Routine::Product
        | Routine::TrMul
        | Routine::Transpose
        | Routine::Dot
        | Routine::Cross
        | Routine::Norm
        | Routine::NormSquared => false,
    }
}

/// Whether a routine is a column times a row: an element is one product, so that it may nest too.
pub(crate) fn outer(routine: Routine, operands: &[Expr]) -> bool {
    routine == Routine::Product && matches!(operands[0].ty, Type::Matrix { cols: 1, .. })
}

/// Whether writing `value` into `destination` part by part would disturb what is still to be read.
/// `through_pointer`: whether a call delivers even a word through a pointer.
pub(crate) fn disturbs(destination: &Place, value: &Expr, through_pointer: bool) -> bool {
    let written = std::slice::from_ref(destination);
    match &value.kind {
        ExprKind::Call(_, arguments) => {
            through_pointer && arguments.iter().any(|argument| lends(argument, destination))
        }
        _ if value.ty.is_word() => false,
        ExprKind::Load(place) => moves(place, written),
        ExprKind::Routine(routine, operands) if elementwise(*routine) => {
            operands.iter().any(|operand| {
                if operand.ty.is_word() {
                    reads(operand, written)
                } else {
                    disturbs(destination, operand, through_pointer)
                }
            })
        }
        _ => reads(value, written),
    }
}

/// Whether a callee may see `destination` through `argument` while it runs.
fn lends(argument: &Argument, destination: &Place) -> bool {
    let written = std::slice::from_ref(destination);
    match argument {
        Argument::Value(value) => value.ty.is_aggregate() && reads(value, written),
        Argument::Ref(value) => reads(value, written),
        Argument::RefMut(place) => overlap(place, destination) || moves(place, written),
    }
}

/// Whether a statement gives a place its own value.
fn is_idle(stmt: &Stmt) -> bool {
    matches!(&stmt.kind, StmtKind::Assign { place, value } if is_own(value, place))
}

/// Whether a value is what a place holds, as it is written: `x`, `x | x`, or `x as u8` of a `u8`.
pub(super) fn is_own(value: &Expr, place: &Place) -> bool {
    match &value.kind {
        ExprKind::Load(from) => same_place(from, place),
        ExprKind::Cast(x) => x.ty == value.ty && is_own(x, place),
        ExprKind::Binary(BinaryOp::And | BinaryOp::Or, a, b) => {
            is_own(a, place) && is_own(b, place)
        }
        _ => false,
    }
}

/// Whether two places are one as they are written, wherever that is.
pub(super) fn same_place(one: &Place, other: &Place) -> bool {
    let steps = || one.steps.iter().zip(&other.steps);
    one.root == other.root
        && one.steps.len() == other.steps.len()
        && steps().all(|steps| match steps {
            (Step::Field(one), Step::Field(other)) => one == other,
            (Step::Index(one), Step::Index(other)) => same_index(one, other),
            (Step::Element(row, column), Step::Element(other_row, other_column)) => {
                same_index(row, other_row) && same_index(column, other_column)
            }
            _ => false,
        })
}

fn same_index(one: &Expr, other: &Expr) -> bool {
    match (&one.kind, &other.kind) {
        (ExprKind::Literal(one), ExprKind::Literal(other)) => one == other,
        (ExprKind::Load(one), ExprKind::Load(other)) => same_place(one, other),
        _ => false,
    }
}
