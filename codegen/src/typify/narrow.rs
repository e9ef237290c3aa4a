//! `u8::try_from(x)` of an integer: the number if it fits, asked before it is converted.

use bessemer_ir::{Block, CompareOp, Expr, ExprKind, LogicOp, Stmt, StmtKind, Type, tree};

use super::lowering::Lowering;
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    pub(super) fn if_it_fits(&mut self, argument: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let (result, span) = (self.slot_of(expr)?, self.span(expr.site));
        let value = self.value(argument, None)?;
        let place = self.hold(value);
        let Type::Struct(id) = result else {
            return problem(expr.site, "this is no `Result`", OUR_FAULT);
        };
        let (Some((fits, ok)), Some((beyond, _))) = (self.case(id, "Ok"), self.case(id, "Err"))
        else {
            return problem(expr.site, "this is no `Result`", OUR_FAULT);
        };
        let field =
            ok.field.map(|field| &self.cx.module.structs[id.index()].fields[field as usize]);
        let target = field.map(|field| field.ty.clone()).unwrap_or(Type::Unit);
        let (Some(from), Some(to)) = (place.ty.as_int(), target.as_int()) else {
            return problem(expr.site, "this converts integers", OUR_FAULT);
        };
        let x = place.load();
        let bound = |op, bound: i128| {
            let literal = Expr::literal_like(bound as u64, &x);
            Expr::compare(op, x.clone(), literal).at(span)
        };
        let low = (from.min() < to.min()).then(|| bound(CompareOp::Ge, to.min()));
        let high = (from.max() > to.max()).then(|| bound(CompareOp::Le, to.max()));
        let condition = match (low, high) {
            (Some(low), Some(high)) => Some(Expr::logic(LogicOp::And, low, high)),
            (one, other) => one.or(other),
        };
        let number = self.node(ExprKind::Cast(Box::new(x.clone())), target, expr.site)?;
        let there = self.choice(id, fits, Some(number), expr.site)?;
        let Some(condition) = condition else { return Ok(there) };
        let nothing = self.choice(id, beyond, None, expr.site)?;
        let held = self.temporary("narrowed", nothing);
        if let ExprKind::Load(place) = &held.kind {
            let assign = StmtKind::Assign { place: place.clone(), value: there };
            let then = Block(vec![Stmt::new(assign, span)]);
            self.emit(StmtKind::If { condition, then, otherwise: Block::default() }, span);
        }
        Ok(held)
    }
}
