//! Finds a function's operations in double and in 64 bits, for which small processors have no instructions.
//!
//! Each operation counts once, however often it runs; calls do not count. Operations that C computes in 32 bits, or
//! that compilers compute, do not count; nor do conversions between integers, which add at most a word.

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_stmt};
use bessemer_ir::{
    BinaryOp, Expr as Ir, ExprKind, Fault, Float, Place, Scalar, Span, Step, Stmt, StmtKind, Type,
};

use super::super::wide::{Wide, Width};
use super::Lower;
use super::range::const_value;

impl Lower<'_> {
    /// Returns the wide operations of the function after its lowering.
    pub(super) fn wide(&self) -> Vec<Wide> {
        let mut found = Found { lower: self, wide: Vec::new() };
        found.block(&self.function.body);
        found.wide
    }

    /// Returns true if C computes a size in 32 bits.
    fn is_narrow(&self, expr: &Ir) -> bool {
        self.range(expr).is_some_and(|(low, high)| low == high || self.counts(expr))
            && !self.is_wide(expr)
    }

    /// Returns true if compilers know the value.
    fn is_known(&self, expr: &Ir) -> bool {
        let one = |(low, high): (i128, i128)| low == high;
        matches!(expr.kind, ExprKind::Literal(_) | ExprKind::Const(_))
            || const_value(expr).is_some()
            || self.range(expr).is_some_and(one)
    }

    /// Returns the width that values of a type exceed.
    fn width(&self, expr: &Ir) -> Option<Width> {
        match &expr.ty {
            Type::Scalar(Scalar::Float(Float::F64))
            | Type::Matrix { element: Scalar::Float(Float::F64), .. } => Some(Width::Double),
            Type::Scalar(Scalar::Int(int)) | Type::Matrix { element: Scalar::Int(int), .. } => {
                (int.bits() == 64 && !self.is_narrow(expr)).then_some(Width::Long)
            }
            _ => None,
        }
    }
}

struct Found<'l, 'a> {
    lower: &'l Lower<'a>,
    wide: Vec<Wide>,
}

impl Found<'_, '_> {
    fn note(&mut self, width: Option<Width>, span: Span) {
        self.wide.extend(width.map(|width| Wide { width, span }));
    }

    /// Returns true if C compares two sizes in 32 bits.
    fn narrow_comparison(&self, left: &Ir, right: &Ir) -> bool {
        let fits = |expr: &Ir| self.lower.is_narrow(expr) || self.lower.is_known(expr);
        let ranges = self.lower.range(left).is_some() && self.lower.range(right).is_some();
        ranges && fits(left) && fits(right)
    }

    fn operation(&mut self, expr: &Ir) {
        let lower = self.lower;
        match &expr.kind {
            ExprKind::Compare(op, left, right) => {
                let decided = lower.decided(*op, left, right).is_some();
                if !decided && !self.narrow_comparison(left, right) {
                    self.note(lower.width(left).or(lower.width(right)), expr.span);
                }
            }
            ExprKind::Unary(..) | ExprKind::Binary(..) if !lower.is_known(expr) => {
                self.note(lower.width(expr), expr.span);
            }
            ExprKind::Cast(operand) if !lower.is_known(operand) => {
                let float = |ty: &Type| ty.as_float().is_some();
                if float(&expr.ty) || float(&operand.ty) {
                    self.note(lower.width(expr).or(lower.width(operand)), expr.span);
                }
            }
            ExprKind::Intrinsic(_, operands) | ExprKind::Routine(_, operands) => {
                let width = operands.iter().find_map(|operand| lower.width(operand));
                self.note(width.or(lower.width(expr)), expr.span);
            }
            _ => {}
        }
    }
}

impl Found<'_, '_> {
    /// Finds the operations of an index. A processor's addresses have 32 bits, so compilers that optimise compute the sums and products of
    /// an index in as many.
    fn index(&mut self, index: &Ir) {
        match &index.kind {
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul, left, right)
                if self.lower.range(index).is_some() =>
            {
                self.index(left);
                self.index(right);
            }
            _ => self.expr(index),
        }
    }
}

impl Visit for Found<'_, '_> {
    fn place(&mut self, place: &Place, _: Access) {
        for step in &place.steps {
            match step {
                Step::Field(_) => {}
                Step::Index(index) | Step::From(index) => self.index(index),
                Step::Element(row, column) => {
                    self.index(row);
                    self.index(column);
                }
            }
        }
    }

    fn stmt(&mut self, stmt: &Stmt) {
        if matches!(stmt.kind, StmtKind::Check { fault: Fault::LeftOut, .. }) {
            // A proved check is in the C only to test the proofs.
            return;
        }
        if let StmtKind::For { variable, ended: false, .. } = &stmt.kind {
            let long = self.lower.function.local(*variable).ty.as_int();
            let counted = self.lower.counters[variable.index()].is_some();
            if long.is_some_and(|int| int.bits() == 64) && !counted {
                self.note(Some(Width::Long), stmt.span);
            }
        }
        walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Ir) {
        if let (ExprKind::Cast(operand), Type::Scalar(target)) = (&expr.kind, &expr.ty)
            && let Some(direct) = self.lower.without_double(operand, *target)
        {
            let direct = Ir { kind: ExprKind::Cast(Box::new(direct.clone())), ..expr.clone() };
            return self.expr(&direct);
        }
        self.operation(expr);
        walk_expr(self, expr);
    }
}
