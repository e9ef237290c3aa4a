//! Tuples that are never made: the items of `zip` and `enumerate` under one name, in functions that stand where they are
//! called. The name means the parts, side by side; only where it is used as a value, one is made of them.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Expr, ExprKind, Type};

use super::lowering::Lowering;
use super::value::Value;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The value of one under its name.
    pub(super) fn made(&mut self, tuple: &Value, site: Site) -> Result<Expr> {
        let made = match tuple {
            Value::Tuple(_, Some(ty)) => self.whole(tuple, ty, site),
            _ => None,
        };
        let Some(made) = made else {
            return problem(
                site,
                "a tuple with a slice in it, or with what may be changed, is not made in the DSL",
                "take it apart where it is named: `|(a, b)| …`",
            );
        };
        Ok(made)
    }

    /// The value of a tuple, if its parts are values.
    fn whole(&mut self, tuple: &Value, ty: &Type, site: Site) -> Option<Expr> {
        match (tuple, ty) {
            (Value::Place(_), _) => self.lent_value(tuple.clone(), ty, site).ok(),
            (Value::Tuple(parts, _), Type::Struct(id)) => {
                let fields = self.cx.fields(*id).to_vec();
                let parts = parts.iter().zip(&fields);
                let parts = parts.map(|(part, field)| self.whole(part, &field.ty, site));
                let kind = ExprKind::Struct(parts.collect::<Option<_>>()?);
                Some(Expr { kind, ty: ty.clone(), span: self.span(site) })
            }
            _ => None,
        }
    }

    /// The parts of one, if an expression names it.
    pub(super) fn parts_named(&self, expr: &tree::Expr) -> Option<Value> {
        match &expr.kind {
            tree::ExprKind::Local(name) => {
                self.lookup(name, expr.site).ok().filter(|it| matches!(it, Value::Tuple(..)))
            }
            tree::ExprKind::Ref(_, inner) => self.parts_named(inner),
            _ => None,
        }
    }
}
