//! Names identity matrices, so that the C has each size once: a module's functions read one constant.
//!
//! Only whole values and operands of element-wise routines become the constant; an identity inside another constructor
//! stays where it is. The meaning is preserved, and no proof depends on it: the elements are floats.

use bessemer_ir::attributes::Given;
use bessemer_ir::visit::{VisitMut, walk_expr_mut, walk_stmt_mut};
use bessemer_ir::{
    Const, ConstId, Expr, ExprKind, Float, Module, Scalar, Span, Stmt, StmtKind, Type,
};

/// Fewest rows of a named identity; a smaller one is shorter where it is used.
const ROWS: u32 = 4;

/// Replaces identity matrices in a module's functions by constants.
pub(super) fn name(module: &mut Module) {
    let mut functions = std::mem::take(&mut module.functions);
    let mut named = Named(&mut module.consts);
    functions.iter_mut().for_each(|function| named.block(&mut function.body));
    module.functions = functions;
}

struct Named<'m>(&'m mut Vec<Const>);

impl Named<'_> {
    fn replace(&mut self, expr: &mut Expr) {
        let Some((element, rows)) = identity(expr) else { return };
        let suffix = if element == Float::F32 { "_F32" } else { "" };
        let name = format!("IDENTITY_{rows}{suffix}");
        let known = self.0.iter().position(|it| it.name == name && it.module == "bessemer");
        let id = known.unwrap_or_else(|| {
            let each = (0..rows).flat_map(|column| (0..rows).map(move |row| row == column));
            self.0.push(Const {
                name,
                module: "bessemer".to_owned(),
                ty: expr.ty.clone(),
                words: each.map(|one| if one { word(element) } else { 0 }).collect(),
                docs: vec![format!("The identity matrix of {rows} rows.")],
                given: Given { public: true, ..Given::default() },
                span: Span::default(),
            });
            self.0.len() - 1
        });
        expr.kind = ExprKind::Const(ConstId(id as u32));
    }
}

impl VisitMut for Named<'_> {
    fn stmt(&mut self, stmt: &mut Stmt) {
        if let StmtKind::Let { value: Some(value), .. }
        | StmtKind::Assign { value, .. }
        | StmtKind::Return(Some(value)) = &mut stmt.kind
        {
            self.replace(value);
        }
        walk_stmt_mut(self, stmt);
    }

    fn expr(&mut self, expr: &mut Expr) {
        if let ExprKind::Routine(_, operands) = &mut expr.kind {
            operands.iter_mut().for_each(|operand| self.replace(operand));
        }
        walk_expr_mut(self, expr);
    }
}

/// Returns the element type and the rows of an identity matrix.
fn identity(expr: &Expr) -> Option<(Float, u32)> {
    let Type::Matrix { element: Scalar::Float(element), rows, cols } = expr.ty else {
        return None;
    };
    let ExprKind::Matrix(items) = &expr.kind else { return None };
    let one = |index: usize| (index as u32).is_multiple_of(rows + 1);
    let is = |(index, item): (usize, &Expr)| {
        item.kind == ExprKind::Literal(if one(index) { word(element) } else { 0 })
    };
    (rows == cols && rows >= ROWS && items.iter().enumerate().all(is)).then_some((element, rows))
}

/// Returns the word of 1.
fn word(element: Float) -> u64 {
    match element {
        Float::F32 => u64::from(1.0_f32.to_bits()),
        Float::F64 => 1.0_f64.to_bits(),
    }
}
