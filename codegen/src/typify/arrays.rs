//! Slices as arrays: `bytes[2..6].try_into()`, `bytes.first_chunk::<4>()`.

use bessemer_ir::tree::{self, Builtin, SliceMethod};
use bessemer_ir::{Block, CompareOp, Expr, ExprKind, Fault, Stmt, StmtKind, StructId, Type};

use super::elements::Slice;
use super::lengths::plus;
use super::lowering::Lowering;
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    /// `Ok` or `Some` of the elements, if there are as many (`whole`), or no fewer.
    pub(super) fn as_array(
        &mut self,
        whole: bool,
        slice: &Slice,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let (id, ty) = self.array_in(expr)?;
        let (there, array) = self.elements_as(whole, slice, ty, expr)?;
        let span = self.span(expr.site);
        let none = self.choice(id, 0, None, expr.site)?;
        let place = self.temporary_place("part", none);
        let (held, value) = (place.load(), self.choice(id, 1, Some(array), expr.site)?);
        let then = Block(vec![Stmt::new(StmtKind::Assign { place, value }, span)]);
        self.emit_if(there, then, span);
        Ok(held)
    }

    /// The same behind `unwrap`: a check, and the elements; none if `expr` is something else.
    pub(super) fn unwrapped_array(&mut self, expr: &tree::Expr) -> Result<Option<Expr>> {
        let Some((Builtin::Slice(method), arguments)) = self.builtin_call(expr) else {
            return Ok(None);
        };
        let whole = match method {
            SliceMethod::ToArray => true,
            SliceMethod::FirstChunk => false,
            _ => return Ok(None),
        };
        let slice = self.sliced(&arguments[0])?;
        let (_, ty) = self.array_in(expr)?;
        let (condition, array) = self.elements_as(whole, &slice, ty, expr)?;
        if condition.kind != ExprKind::Literal(1) {
            let span = self.span(expr.site);
            self.emit(StmtKind::Check { condition, fault: Fault::Absent }, span);
        }
        Ok(Some(array))
    }

    /// The `Option` or `Result` of a call, and the array in it.
    fn array_in(&mut self, expr: &tree::Expr) -> Result<(StructId, Type)> {
        let ty = match self.slot_of(expr)? {
            Type::Struct(id) => ["Ok", "Some"].iter().find_map(|case| {
                let field = self.case(id, case)?.1.field?;
                Some((id, self.cx.field_type(id, field)))
            }),
            _ => None,
        };
        match ty {
            Some(found @ (_, Type::Array { .. })) => Ok(found),
            _ => problem(expr.site, "a slice becomes an array in the DSL", OUR_FAULT),
        }
    }

    /// Whether there are as many elements as the array has, and these.
    fn elements_as(
        &mut self,
        whole: bool,
        slice: &Slice,
        ty: Type,
        expr: &tree::Expr,
    ) -> Result<(Expr, Expr)> {
        let span = self.span(expr.site);
        let Type::Array { len, .. } = ty else {
            return problem(expr.site, "a slice becomes an array in the DSL", OUR_FAULT);
        };
        if len > MOST {
            return problem(
                expr.site,
                format!("a slice becomes an array of at most {MOST} elements in the DSL"),
                "declare the array, and call `copy_from_slice`",
            );
        }
        let wanted = u64::from(len);
        let there = match slice.length.kind {
            ExprKind::Literal(length) => {
                let enough = if whole { length == wanted } else { length >= wanted };
                Expr::bool(enough, span)
            }
            _ => {
                let op = if whole { CompareOp::Eq } else { CompareOp::Ge };
                Expr::compare(op, slice.length.clone(), Expr::usize(wanted, span)).at(span)
            }
        };
        let element = |index| slice.at(plus(slice.from.clone(), Expr::usize(index, span))).load();
        let kind = ExprKind::Array((0..wanted).map(element).collect());
        Ok((there, Expr { kind, ty, span }))
    }
}

/// How many elements are written out at most.
const MOST: u32 = 32;
