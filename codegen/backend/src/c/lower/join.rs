//! One loop for neighbouring statements over the elements of vectors.
//!
//! [`joined`](crate::joined) finds the statements, and knows why one loop computes the same. A local vector that only the loop uses is a
//! number of each pass, so it needs no memory:
//!
//! ```text
//! float largest = 0.0F;
//! for (uint32_t i = 0U; i < 12U; i++) {
//!     const float slack = upper_f32(stage->x[i] + stage->dual[i], plan->low[i]);
//!     stage->dual[i] += stage->x[i] - slack;
//!     largest = larger_magnitude_f32(largest, fabsf(stage->x[i] - slack));
//!     stage->slack[i] = slack;
//! }
//! ```
//!
//! The largest magnitude begins at zero instead of the first element: of zero and a magnitude, which may be NaN, the helper
//! returns the magnitude.
//!
//! Compilers compute four numbers of single precision at once where a loop only stores them, but not where it also chooses the
//! largest: with NaN, the order decides. So four numbers or a multiple, up to [`KEPT`], have their magnitudes stored, and a second
//! loop chooses. Must not know: which statements join.

use bessemer_ir::effects::{mentions, whole};
use bessemer_ir::visit::Walk as _;
use bessemer_ir::{
    Expr as Ir, ExprKind, Float, LocalId, Routine, Scalar, Stmt as IrStmt, StmtKind as IrKind, Type,
};

use super::super::literal::{self, Readers};
use super::super::tree::{Expr, Init, StmtKind};
use super::Lower;
use super::place::shape;
use super::routine::{At, Fused, chooser, float};
use super::stmt::is_own;
use crate::joined::joined;

/// Numbers that vectors of most processors hold.
const LANES: u32 = 4;
/// Largest number of magnitudes that are stored.
const KEPT: u32 = 32;

/// Work of a pass for one statement.
struct Part<'s> {
    stmt: &'s IrStmt,
    target: Target,
    value: Fused,
    scalar: Scalar,
}

/// Destination of an element.
enum Target {
    /// The element of a vector.
    Element(Expr),
    /// A variable of the pass.
    Number(String),
    /// The largest magnitude so far.
    Largest(String),
    /// A vector of magnitudes, and the largest of them, which a loop behind chooses.
    Magnitudes(String, String),
}

impl Lower<'_> {
    /// Lowers the first statements to one loop; returns their number, or 0 if the first has its own loop or none.
    pub(super) fn join(&mut self, stmts: &[IrStmt]) -> usize {
        let is_read = |stmt: &&IrStmt| match stmt.kind {
            IrKind::Let { local, .. } => self.usage.read[local.index()],
            _ => true,
        };
        let read = stmts.iter().take_while(is_read);
        let joined = joined(self.context.module, self.function, read);
        if joined < 2 {
            return 0;
        }
        let stmts = &stmts[..joined];
        let operand = stmts.iter().find_map(operand).expect("a member has an operand");
        let (scalar, rows, cols) = shape(&operand.ty);
        let count = rows * cols;
        let are_kept =
            scalar == Scalar::Float(Float::F32) && count <= KEPT && count.is_multiple_of(LANES);
        let are_kept = are_kept && stmts.iter().any(|stmt| !is_magnitude(stmt));
        let parts: Vec<Part> =
            stmts.iter().filter_map(|stmt| self.part_of_loop(stmt, stmts, are_kept)).collect();
        let array = parts.iter().find_map(|part| match &part.target {
            Target::Element(array) => Some(array.clone()),
            Target::Number(name) => Some(Expr::name(name)),
            Target::Largest(_) | Target::Magnitudes(..) => None,
        });
        self.few(count, parts.iter().map(|part| 1 + part.value.operations()).sum());
        let array = array.unwrap_or_else(|| Expr::name(""));
        self.count_up(count, &array, |lower, index| lower.pass(&parts, &index));
        self.choose(count, &array, &parts);
        joined
    }

    /// Emits the loop that chooses the largest of stored magnitudes.
    fn choose(&mut self, count: u32, array: &Expr, parts: &[Part]) {
        let kept = |part: &Part| match &part.target {
            Target::Magnitudes(all, largest) => Some((all.clone(), largest.clone(), part.scalar)),
            _ => None,
        };
        let kept: Vec<(String, String, Scalar)> = parts.iter().filter_map(kept).collect();
        if kept.is_empty() {
            return;
        }
        self.count_up(count, array, |lower, index| {
            for (all, largest, scalar) in &kept {
                lower.grow(largest, *scalar, Expr::name(all).at(index.clone()));
            }
        });
    }

    /// Replaces the largest magnitude so far by a larger one.
    fn grow(&mut self, largest: &str, scalar: Scalar, magnitude: Expr) {
        let helper = chooser(Routine::Amax, float(scalar));
        let chosen = self.helper(helper, vec![Expr::name(largest), magnitude]);
        self.assign(Expr::name(largest), chosen);
    }

    /// Declares what a statement needs before the loop; returns its work in each pass.
    fn part_of_loop<'s>(
        &mut self,
        stmt: &'s IrStmt,
        all: &[IrStmt],
        are_kept: bool,
    ) -> Option<Part<'s>> {
        self.at(stmt.span);
        let operand = operand(stmt)?;
        let (scalar, ..) = shape(&operand.ty);
        let (target, value) = match &stmt.kind {
            IrKind::Let { local, value: Some(value) } if value.ty.is_word() => {
                let magnitudes = Fused::Abs(Box::new(self.fuse_operand(operand, None)));
                let name = self.bind(*local);
                let zero = literal::number(float(scalar), 0, Readers::C);
                self.declare(&value.ty, &name, Some(Init::Value(zero)), false);
                let target = if are_kept {
                    let all = self.fresh("magnitudes");
                    self.begin(&operand.ty, &all, &[]);
                    Target::Magnitudes(all, name)
                } else {
                    Target::Largest(name)
                };
                (target, magnitudes)
            }
            IrKind::Let { local, .. } => {
                let value = self.fuse_operand(operand, None);
                (self.target(*local, &operand.ty, all), value)
            }
            IrKind::Assign { place, .. } => {
                let mentioned = self.mentioned[place.root.index()];
                let dest = self.place(place);
                let value = self.fuse_operand(operand, Some(place));
                // A C compiler does not count a store as a use.
                if is_own(&dest) && !mentions(operand, place.root) {
                    self.mentioned[place.root.index()] = mentioned;
                }
                (Target::Element(dest), value)
            }
            _ => return None,
        };
        Some(Part { stmt, target, value, scalar })
    }

    /// Declares a local vector; one that only these statements use is a number of each pass.
    fn target(&mut self, local: LocalId, ty: &Type, all: &[IrStmt]) -> Target {
        if self.in_place == Some(local) {
            self.let_in_place(local, None);
            return Target::Element(self.place(&whole(local)));
        }
        if let Some(part) = self.part_of_result(local) {
            return Target::Element(part);
        }
        let sizes = self.sizes.remove(&local).unwrap_or_default();
        let name = self.bind(local);
        let everywhere = uses(&self.function.body.0, local);
        if !self.usage.assigned[local.index()] && uses(all, local) == everywhere {
            self.declared.insert(name.clone(), sizes);
            return Target::Number(name);
        }
        self.begin(ty, &name, &sizes);
        Target::Element(Expr::name(name))
    }

    /// Emits the work of one pass.
    fn pass(&mut self, parts: &[Part], index: &Expr) {
        let mut numbers: Vec<&str> = Vec::new();
        for (at, part) in parts.iter().enumerate() {
            if at > 0 && !part.stmt.comments.is_empty() {
                self.origin = None;
                self.emit(StmtKind::Comment(part.stmt.comments.clone()));
            }
            self.at(part.stmt.span);
            let mut value = self.fused_element(&part.value, part.scalar, &At::Counted(index));
            numbers.iter().for_each(|name| value.replace_elements(name));
            match &part.target {
                Target::Element(array) => self.assign(array.clone().at(index.clone()), value),
                Target::Number(name) => {
                    numbers.push(name);
                    self.declare(&Type::Scalar(part.scalar), name, Some(Init::Value(value)), true);
                }
                Target::Largest(name) => self.grow(name, part.scalar, value),
                Target::Magnitudes(all, _) => {
                    self.assign(Expr::name(all).at(index.clone()), value);
                }
            }
        }
    }
}

/// Returns the element-wise value of a statement that has one.
fn operand(stmt: &IrStmt) -> Option<&Ir> {
    let (IrKind::Let { value: Some(value), .. } | IrKind::Assign { value, .. }) = &stmt.kind else {
        return None;
    };
    match &value.kind {
        ExprKind::Routine(Routine::Amax, operands) => operands.first(),
        _ => Some(value),
    }
}

/// Returns true for the largest magnitude of a vector.
fn is_magnitude(stmt: &IrStmt) -> bool {
    matches!(&stmt.kind, IrKind::Let { value: Some(value), .. } if value.ty.is_word())
}

/// Returns the number of reads and writes of a local.
fn uses(stmts: &[IrStmt], local: LocalId) -> usize {
    let mut uses = 0;
    stmts.each_place(|place, _| uses += usize::from(place.root == local));
    uses
}
