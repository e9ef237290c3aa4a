//! Struct literals: their fields in the author's order, and the rest from another value.

use bessemer_ir::tree;
use bessemer_ir::{Expr, ExprKind, Place, Type};

use super::OUR_FAULT;
use super::expr::Operand;
use super::function::Lowering;
use super::order::{has_effect, is_free, is_settled};
use super::{Result, problem};

impl Lowering<'_, '_> {
    pub(super) fn struct_value(
        &mut self,
        fields: &[(String, tree::Expr)],
        rest: Option<&tree::Expr>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        let Type::Struct(id) = ty else {
            return problem(expr.site, "this is not a struct", OUR_FAULT);
        };
        let declared = self.cx.module.structs[id.index()].fields.clone();
        let expected = |name: &str| declared.iter().find(|field| field.name == name);
        let operands: Vec<_> = fields
            .iter()
            .map(|(name, value)| Operand {
                expr: value,
                expected: expected(name).map(|field| field.ty.clone()),
                role: "part",
            })
            .collect();
        // In the author's order; then into the order of the definition.
        let mut values: Vec<_> = self.operands(&operands)?.into_iter().map(Some).collect();
        let rest = match rest {
            Some(rest) => Some(self.rest(&mut values, fields, rest)?),
            None => None,
        };
        let order: Vec<_> = fields
            .iter()
            .map(|(name, _)| declared.iter().position(|field| field.name == *name))
            .collect();
        self.keep_order(&mut values, order.is_sorted(), rest.is_some(), fields);
        let mut ordered = Vec::new();
        for (position, field) in declared.iter().enumerate() {
            let index = fields.iter().position(|(name, _)| *name == field.name);
            let value = index.and_then(|index| values[index].take()).or_else(|| {
                let mut place = rest.clone()?;
                place.steps.push(bessemer_ir::Step::Field(position as u32));
                place.ty = field.ty.clone();
                let (ty, span) = (field.ty.clone(), place.span);
                Some(Expr { kind: ExprKind::Load(place), ty, span })
            });
            let Some(value) = value else {
                return problem(expr.site, format!("`{}` is missing", field.name), OUR_FAULT);
            };
            self.agree(&value.ty, &field.ty, expr.site)?;
            ordered.push(value);
        }
        self.node(ExprKind::Struct(ordered), ty, expr.site)
    }

    /// Computes the values of fields in the author's order, where that of the definition would show.
    fn keep_order(
        &mut self,
        values: &mut [Option<Expr>],
        sorted: bool,
        rest: bool,
        fields: &[(String, tree::Expr)],
    ) {
        let loud = values.iter().flatten().filter(|value| !is_free(value)).count();
        let writing = values.iter().flatten().any(has_effect);
        if !(loud > 1 && !sorted || writing && (!sorted || rest)) {
            return;
        }
        let naming = std::mem::take(&mut self.naming);
        for (value, (name, _)) in values.iter_mut().zip(fields) {
            if let Some(value) = value
                && !super::function::is_literal(value)
            {
                *value = self.temporary(name, value.clone());
            }
        }
        self.naming = naming;
    }

    /// The place of `..base`; values that its statements could change are computed before them.
    fn rest(
        &mut self,
        values: &mut [Option<Expr>],
        fields: &[(String, tree::Expr)],
        rest: &tree::Expr,
    ) -> Result<Place> {
        let mark = self.out.len();
        let place = self.base(rest)?;
        if self.out.len() > mark {
            let later = self.out.split_off(mark);
            for (value, (name, _)) in values.iter_mut().zip(fields) {
                if let Some(value) = value
                    && !is_settled(value, &later)
                {
                    *value = self.temporary(name, value.clone());
                }
            }
            self.out.extend(later);
        }
        Ok(place)
    }
}
