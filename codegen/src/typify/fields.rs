//! Values of structs and variants: their fields in the author's order, and the rest from another value.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Expr, ExprKind, Place, Span, Step, StmtKind, StructId, Type};

use super::expr::Operand;
use super::lowering::Lowering;
use super::order::{has_effect, is_free};
use super::syntax::numbered;
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    /// `Name { field: value, ..base }`: a struct, or a variant.
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
                return problem(expr.site, "write the variant without braces", "leave `{}` out");
            }
            return problem(expr.site, "this is not a struct", OUR_FAULT);
        };
        if self.cx.known_of(id).cases.is_empty() {
            return self.parts(id, fields, rest, expr);
        }
        let (word, case) = self.named_case(id, name, expr.site)?;
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

    /// `Name(a, b)`.
    pub(super) fn constructed(
        &mut self,
        name: &str,
        parts: &[tree::Expr],
        expected: Option<&Type>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        // Where no author wrote it, what it is for tells its type.
        if let (None, Some(Type::Struct(id))) = (expr.slot, expected)
            && let Some((word, case)) = self.case(*id, name)
        {
            let held = case.field.map(|field| self.cx.field_type(*id, field));
            let payload = match (parts, held) {
                ([part], Some(held)) => Some(self.value(part, Some(&held))?),
                _ => None,
            };
            return self.choice(*id, word, payload, expr.site);
        }
        self.struct_value(name, &numbered(parts), None, expr)
    }

    /// The variant `word` of a struct that stands for an enum.
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
                _ if definition.holds(index, word) => match payload.take() {
                    Some(payload) => payload,
                    None => return problem(site, "the payload is missing", OUR_FAULT),
                },
                _ => self.zero(&field.ty, span),
            });
        }
        self.node(ExprKind::Struct(parts), Type::Struct(id), site)
    }

    /// The value of a type whose every word is zero.
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

    /// A struct of its parts.
    pub(super) fn parts(
        &mut self,
        id: StructId,
        fields: &[(String, tree::Expr)],
        rest: Option<&tree::Expr>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = Type::Struct(id);
        let declared = self.cx.fields(id).to_vec();
        let at = |name: &str| self.cx.field_at(id, name).flatten();
        let places: Vec<_> = fields.iter().map(|(name, _)| at(name)).collect();
        if let Some((_, moved)) = fields.iter().find(|(_, it)| self.is_submatrix(it)) {
            return Self::moved_part(moved.site);
        }
        let operands: Vec<_> = fields
            .iter()
            .zip(&places)
            .map(|((_, value), at)| Operand {
                expr: value,
                expected: at.map(|at| declared[at].ty.clone()),
                role: "part",
            })
            .collect();
        let before = self.locals.len();
        // In the author's order; then into the order of the definition.
        let mut values: Vec<_> = self.operands(&operands)?.into_iter().map(Some).collect();
        let rest = match rest {
            Some(rest) => Some(self.rest(&mut values, fields, rest)?),
            None => None,
        };
        if let Some(made) = rest.as_ref().filter(|place| self.is_made(place, before)) {
            let written = values.into_iter().zip(&places).zip(fields);
            for ((value, at), (_, expr)) in written {
                let (Some(value), Some(at)) = (value, at) else { continue };
                self.agree(&value.ty, &declared[*at].ty, expr.site)?;
                let place = made.inside(Step::Field(*at as u32), declared[*at].ty.clone());
                let span = value.span;
                self.emit(StmtKind::Assign { place, value }, span);
            }
            // It is written here, so no name may stand for a part of it before.
            self.held.remove(&made.root);
            return Ok(made.load());
        }
        // What holds nothing has been done.
        let kept: Vec<_> = places.iter().flatten().collect();
        let sorted = kept.is_sorted();
        self.keep_order_of_fields(&mut values, sorted, rest.is_some(), fields);
        let mut ordered = Vec::new();
        for (at, field) in declared.iter().enumerate() {
            let index = places.iter().position(|place| *place == Some(at));
            let value = index.and_then(|index| values[index].take()).or_else(|| {
                let step = Step::Field(at as u32);
                Some(rest.as_ref()?.inside(step, field.ty.clone()).load())
            });
            let Some(value) = value else {
                return problem(expr.site, format!("`{}` is missing", field.name), OUR_FAULT);
            };
            self.agree(&value.ty, &field.ty, expr.site)?;
            ordered.push(value);
        }
        self.node(ExprKind::Struct(ordered), ty, expr.site)
    }

    /// Whether the rest of a struct is a value that was held just now: then it becomes the struct.
    fn is_made(&self, rest: &Place, before: usize) -> bool {
        rest.root.index() >= before && rest.steps.is_empty() && self.held.contains(&rest.root)
    }

    /// Computes the values of fields in the author's order, where that of the definition would show.
    fn keep_order_of_fields(
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
        self.naming_as("", |inner| {
            for (value, (name, _)) in values.iter_mut().zip(fields) {
                if let Some(value) = value
                    && !value.is_literal()
                {
                    *value = inner.temporary(name, value.clone());
                }
            }
        });
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
            let named = values.iter_mut().zip(fields);
            let there =
                named.filter_map(|(value, (name, _))| Some((value.as_mut()?, name.as_str())));
            self.settle_all(there, &later);
            self.out.extend(later);
        }
        Ok(place)
    }
}
