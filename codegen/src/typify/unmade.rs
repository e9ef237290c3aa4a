//! Tuples that are never made: the items of `zip` and `enumerate` under one name, in functions that stand where they are
//! called. The name means the parts, side by side; only where it is used as a value, one is made of them.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Expr, ExprKind, Type};

use super::lowering::{Binding, Lowering};
use super::subject::{Subject, Unmade};
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The value of a tuple that is written out, if its parts are values.
    pub(super) fn whole(&mut self, subject: &Subject, ty: &Type, site: Site) -> Option<Expr> {
        match (subject, ty) {
            (Subject::Place(place), _) => Some(place.load()),
            (Subject::Parts(parts), Type::Struct(id)) => {
                let fields = self.cx.module.structs[id.index()].fields.clone();
                let parts = parts.iter().zip(&fields);
                let parts = parts.map(|(part, field)| self.whole(part, &field.ty, site));
                let kind = ExprKind::Struct(parts.collect::<Option<_>>()?);
                Some(Expr { kind, ty: ty.clone(), span: self.span(site) })
            }
            _ => None,
        }
    }

    /// The value of one under its name.
    pub(super) fn made(&self, tuple: Unmade, site: Site) -> Result<Expr> {
        match tuple.value {
            Some(value) => Ok(value),
            None => problem(
                site,
                "a tuple with a slice in it, or with what may be changed, is not made in the DSL",
                "take it apart where it is named: `|(a, b)| …`",
            ),
        }
    }

    /// The parts of one, if an expression names it.
    pub(super) fn parts_named(&self, expr: &tree::Expr) -> Option<Subject> {
        match &expr.kind {
            tree::ExprKind::Local(name) => match self.lookup(name, expr.site).ok()? {
                Binding::Unmade(tuple) => Some(tuple.parts),
                _ => None,
            },
            tree::ExprKind::Ref(_, inner) => self.parts_named(inner),
            _ => None,
        }
    }
}
