//! Values of structs and variants: fields evaluated in the author's order, and the rest from a base value.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Expr, ExprKind, Place, Span, StmtKind, StructId, Type};

use super::context::Case;
use super::expr::Operand;
use super::lowering::{Lowering, local_since};
use super::syntax::numbered;
use super::words;
use super::{Needed, OUR_FAULT, Result, problem, refusals, refused};

impl Lowering<'_, '_> {
    /// Lowers `Name { field: value, ..base }` of a struct or a variant.
    pub(super) fn struct_value(
        &mut self,
        name: &str,
        fields: &[(String, tree::Expr)],
        rest: Option<&tree::Expr>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        let Type::Struct(id) = ty else {
            if let Type::Enum(_) = ty {
                return refused(expr.site, refusals::VARIANT_BRACES);
            }
            return problem(expr.site, "this is not a struct", OUR_FAULT);
        };
        if self.cx.known_of(id).cases.is_empty() {
            return self.parts(id, fields, rest, expr);
        }
        let case = self.named_case(id, name, expr.site)?;
        self.variant(id, case, fields, expr)
    }

    /// Lowers a variant of an enum with payload, from its word and its fields.
    fn variant(
        &mut self,
        id: StructId,
        (word, case): (u64, Case),
        fields: &[(String, tree::Expr)],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let held = case.field.map(|field| self.cx.field_type(id, field));
        let payload = match (held, fields) {
            (Some(held), [(_, value)]) if case.single => {
                let value = self.value(value, Some(&held))?;
                self.agree(&value.ty, &held, expr.site)?;
                Some(value)
            }
            (Some(Type::Struct(inner)), _) => Some(self.parts(inner, fields, None, expr)?),
            (None, [(_, value)]) => {
                // `Ok(())` holds nothing.
                self.effect(value)?;
                None
            }
            _ => None,
        };
        self.choice(id, word, payload, expr.site)
    }

    /// Lowers `Name(a, b)`.
    pub(super) fn constructed(
        &mut self,
        name: &str,
        parts: &[tree::Expr],
        expected: Option<&Type>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        // Where no author wrote it, what it is for tells its type.
        if let (None, Some(Type::Struct(id))) = (expr.slot, expected)
            && let Some(case) = self.case(*id, name)
        {
            return self.variant(*id, case, &numbered(parts), expr);
        }
        self.struct_value(name, &numbered(parts), None, expr)
    }

    /// Returns the value of variant `word` of a struct that represents an enum.
    pub(super) fn choice(
        &mut self,
        id: StructId,
        word: u64,
        mut payload: Option<Expr>,
        site: Site,
    ) -> Result<Expr> {
        let span = self.span(site);
        let definition = self.cx.module.structs[id.index()].clone();
        let mut parts = Vec::new();
        for (index, field) in definition.fields.iter().enumerate() {
            parts.push(match index {
                0 => Expr::literal(word, field.ty.clone(), span),
                _ if definition.holds(index, word) => {
                    payload.take().needed(site, "the payload is missing")?
                }
                _ => self.zero(&field.ty, span),
            });
        }
        self.node(ExprKind::Struct(parts), Type::Struct(id), site)
    }

    /// Returns the value of a type in which every word is zero.
    pub(super) fn zero(&self, ty: &Type, span: Span) -> Expr {
        let kind = match ty {
            Type::Unit | Type::Slice(_) | Type::Scalar(_) | Type::Enum(_) => ExprKind::Literal(0),
            Type::Array { element, .. } => ExprKind::Splat(Box::new(self.zero(element, span))),
            Type::Matrix { element, .. } => {
                ExprKind::Splat(Box::new(self.zero(&Type::Scalar(*element), span)))
            }
            Type::Struct(id) => {
                let fields = self.cx.fields(*id);
                ExprKind::Struct(fields.iter().map(|field| self.zero(&field.ty, span)).collect())
            }
        };
        Expr { kind, ty: ty.clone(), span }
    }

    /// Lowers a struct with its fields.
    pub(super) fn parts(
        &mut self,
        id: StructId,
        fields: &[(String, tree::Expr)],
        rest: Option<&tree::Expr>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        if let Some((_, moved)) = fields.iter().find(|(_, it)| self.is_submatrix(it)) {
            return refused(moved.site, refusals::MOVED_VIEW);
        }
        let declared = self.cx.fields(id).to_vec();
        let at = |(name, _): &(String, _)| self.cx.field_at(id, name).flatten();
        let places: Vec<Option<usize>> = fields.iter().map(at).collect();
        // Values are evaluated in the author's order. If the definition has another, each is held.
        let in_order = rest.is_none() && places.iter().flatten().is_sorted();
        let operands = fields.iter().zip(&places).map(|((name, expr), at)| Operand {
            expr,
            expected: at.map(|at| declared[at].ty.clone()),
            role: if in_order { words::PART } else { name },
        });
        let operands: Vec<_> = operands.collect();
        let before = self.locals.len();
        let values = match in_order {
            true => self.operands(&operands)?,
            false => self.parts_held(&operands)?,
        };
        let rest = rest.map(|rest| self.base(rest)).transpose()?;
        // Where the rest is a value that was held just now, that becomes the struct.
        let is_made =
            |it: &&Place| local_since(it, before).is_some_and(|it| self.locals.is_temporary(it));
        if let Some(made) = rest.as_ref().filter(is_made) {
            for ((value, at), (_, expr)) in values.into_iter().zip(&places).zip(fields) {
                let Some(at) = at else { continue };
                let (place, span) = (self.part(made, id, *at), value.span);
                self.agree(&value.ty, &place.ty, expr.site)?;
                self.emit(StmtKind::Assign { place, value }, span);
            }
            // It is written here, so no name may stand for a part of it before.
            self.locals.release(made.root);
            return Ok(made.load());
        }
        let mut ordered = Vec::new();
        for (at, field) in declared.iter().enumerate() {
            let value = match (places.iter().position(|place| *place == Some(at)), &rest) {
                (Some(index), _) => values[index].clone(),
                (None, Some(rest)) => self.part(rest, id, at).load(),
                (None, None) => {
                    return problem(expr.site, format!("`{}` is missing", field.name), OUR_FAULT);
                }
            };
            self.agree(&value.ty, &field.ty, expr.site)?;
            ordered.push(value);
        }
        self.node(ExprKind::Struct(ordered), Type::Struct(id), expr.site)
    }
}
