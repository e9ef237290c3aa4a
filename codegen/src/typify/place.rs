//! Places: where values are held.

use bessemer_ir::tree;
use bessemer_ir::{Expr, ExprKind, Int, Place, Scalar, Step, Type};

use super::expr::{Operand, two};
use super::lowering::{Lowering, RESULT, UNNAMED};
use super::words;
use super::{Result, problem};
use crate::effects;

/// Whether a field is all there is: of a point its `coords`, of a translation its `vector`.
fn is_whole(base: &Type, name: &str) -> bool {
    matches!(base, Type::Matrix { .. }) && (name == "coords" || name == "vector")
}

/// The row and the column of nalgebra's `m12`, from 0.
fn by_name(name: &str) -> Option<(u64, u64)> {
    let digit = |at: usize| match name.as_bytes().get(at)? {
        digit @ b'1'..=b'6' => Some(u64::from(digit - b'1')),
        _ => None,
    };
    (name.len() == 3 && name.starts_with('m')).then_some((digit(1)?, digit(2)?))
}

impl Lowering<'_, '_> {
    /// The place that `expr` names; none if it is a value.
    pub(super) fn place(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        let span = self.span(expr.site);
        if self.holds_nothing(expr) {
            return Ok(None);
        }
        match &expr.kind {
            tree::ExprKind::Local(name) => {
                let meaning = self.lookup(name, expr.site)?;
                let place = self.place_of(&meaning, span);
                place.map(|place| self.followed(place, expr.site)).transpose()
            }
            tree::ExprKind::Deref(inner) | tree::ExprKind::Ref(_, inner) => self.place(inner),
            tree::ExprKind::Call(..) => match self.in_option(expr)? {
                Some(place) => Ok(Some(place)),
                None => match self.lent_place(expr)? {
                    None if self.gives_element(expr) => {
                        let value = self.value(expr, None)?;
                        let held = self.hold(value);
                        self.element_lent(&held, expr.site)
                    }
                    place => Ok(place),
                },
            },
            tree::ExprKind::Try(..) => self.tried_place(expr),
            tree::ExprKind::Field(_, name) if name == "coords" && self.in_coords(expr)? => Ok(None),
            tree::ExprKind::Field(base, name) if let Some(part) = self.submatrix(base)? => {
                match self.field_step(&part.ty(), name, expr)?.0 {
                    Step::Element(row, column) => Ok(Some(Place { span, ..part.at(row, column) })),
                    _ => Ok(None),
                }
            }
            tree::ExprKind::Field(base, name) => {
                let base = self.base(base)?;
                let place = self.field(base, name, expr)?;
                self.followed(place, expr.site).map(Some)
            }
            tree::ExprKind::Index(base, index) => {
                if let Some(part) = self.submatrix(base)? {
                    return self.part_element(&part, index, expr).map(Some);
                }
                if let Some(slice) = self.slice(base)? {
                    return self.slice_element(&slice, index, span).map(Some);
                }
                if !self.cx.indexing.is_empty()
                    && let Ok(owner) = self.place_type(base)
                    && let Some(place) = self.own_element(&owner, [base, index], expr.site)?
                {
                    return Ok(Some(place));
                }
                let base = self.base(base)?;
                self.element(base, index, expr).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// The subject that is taken apart: a place, or a value held in a temporary.
    pub(super) fn base(&mut self, expr: &tree::Expr) -> Result<Place> {
        if let Some(place) = self.place(expr)? {
            return Ok(place);
        }
        let value = self.value(expr, None)?;
        Ok(self.hold(value))
    }

    /// The place of a value: its own, or a temporary. An index that calls is computed here, once.
    pub(super) fn hold(&mut self, value: Expr) -> Place {
        if let ExprKind::Load(mut place) = value.kind {
            self.keep_indices(&mut place, effects::calls);
            return place;
        }
        let known = self.cx.known(&value.ty);
        let role = match &value.ty {
            Type::Struct(id)
                if let Type::Struct(of) = self.type_behind(value.ty.clone())
                    && of != *id =>
            {
                super::names::role(&self.cx.module.structs[of.index()].name)
            }
            Type::Struct(id) if known.shown.is_some() && !self.cx.borrowed.contains_key(id) => {
                match known.cases.first().map(|case| case.name.as_str()) {
                    Some("None") => words::OPTION.into(),
                    Some("Err") => words::OUTCOME.into(),
                    _ => words::TUPLES[1].into(),
                }
            }
            Type::Struct(id) => super::names::role(&self.cx.module.structs[id.index()].name),
            Type::Matrix { .. } => words::VECTOR.into(),
            Type::Array { .. } => words::ELEMENTS.into(),
            _ => words::SELECTOR.into(),
        };
        // One that is looked into once has the name of what comes of it, if the author gave that one.
        let choice = known.shown.is_some()
            && !known.cases.is_empty()
            && ![UNNAMED, RESULT].contains(&self.naming.as_str());
        let naming = if choice { self.naming.clone() } else { String::new() };
        self.naming_as(naming, |inner| inner.temporary_place(&role, value))
    }

    fn field(&mut self, mut base: Place, name: &str, expr: &tree::Expr) -> Result<Place> {
        if is_whole(&base.ty, name) {
            return Ok(base);
        }
        let (step, ty) = self.field_step(&base.ty, name, expr)?;
        base.steps.push(step);
        base.ty = ty;
        base.span = self.span(expr.site);
        Ok(base)
    }

    fn field_step(&mut self, base: &Type, name: &str, expr: &tree::Expr) -> Result<(Step, Type)> {
        match base {
            Type::Struct(id) => {
                if let Some(Some(index)) = self.cx.field_at(*id, name) {
                    let step = Step::Field(index as u32);
                    return Ok((step, self.cx.field_type(*id, index as u32)));
                }
            }
            Type::Matrix { element, rows, cols } => {
                if let Some((row, col)) = by_name(name).filter(|(row, col)| {
                    *cols > 1 && *row < u64::from(*rows) && *col < u64::from(*cols)
                }) {
                    let (row, col) = (self.index_literal(row, expr), self.index_literal(col, expr));
                    return Ok((Step::Element(row, col), Type::Scalar(*element)));
                }
                let place = ["x", "y", "z", "w", "a", "b"].iter().position(|axis| *axis == name);
                let place = place.filter(|place| (*place as u32) < rows * cols);
                if let (Some(place), true) = (place, *rows == 1 || *cols == 1) {
                    let (row, col) = if *cols == 1 { (place, 0) } else { (0, place) };
                    let mut index = |at: usize| self.index_literal(at as u64, expr);
                    return Ok((Step::Element(index(row), index(col)), Type::Scalar(*element)));
                }
            }
            _ => {}
        }
        problem(expr.site, format!("`{name}` is not a field that the DSL knows"), "use an index")
    }

    fn element(&mut self, mut base: Place, index: &tree::Expr, expr: &tree::Expr) -> Result<Place> {
        let mark = self.out.len();
        let (mut step, ty) = match base.ty.clone() {
            Type::Array { element, .. } => {
                let index = self.value(index, Some(&Type::USIZE))?;
                (Step::Index(index), *element)
            }
            Type::Matrix { element, rows, cols } => {
                (self.matrix_step(index, rows, cols, expr)?, Type::Scalar(element))
            }
            ref bounded if self.bounded_type(bounded).is_some() => {
                let span = self.span(expr.site);
                return self.bounded_element(base, index, span);
            }
            ref list if self.list_type(list).is_some() => {
                let index = self.value(index, Some(&Type::USIZE))?;
                let later = self.later(mark);
                self.settle_place(&mut base, &later);
                self.out.extend(later);
                self.keep_indices(&mut base, |index| !index.is_literal());
                let span = self.span(expr.site);
                return Ok(self.list_element(base, index, span));
            }
            _ => {
                return problem(
                    expr.site,
                    "only arrays, matrices and vectors have elements in the DSL",
                    "use `[T; N]`, or a vector",
                );
            }
        };
        // Whoever gets the place may read it more than once, which must write nothing.
        if !effects::lent_by_step(&step).is_empty() {
            self.keep_indices_of(&mut step, |index| !index.is_literal());
        }
        let later = self.later(mark);
        self.settle_place(&mut base, &later);
        self.out.extend(later);
        base.steps.push(step);
        base.ty = ty;
        base.span = self.span(expr.site);
        Ok(base)
    }

    pub(super) fn matrix_step(
        &mut self,
        index: &tree::Expr,
        rows: u32,
        cols: u32,
        expr: &tree::Expr,
    ) -> Result<Step> {
        if let tree::ExprKind::Tuple(parts) = &index.kind
            && let [row, col] = parts.as_slice()
        {
            let usize = Some(Type::USIZE);
            let indices = self.operands(&[
                Operand { expr: row, expected: usize.clone(), role: "row" },
                Operand { expr: col, expected: usize, role: "column" },
            ])?;
            let [row, col] = two(indices, expr.site)?;
            return Ok(Step::Element(row, col));
        }
        let index = self.value(index, Some(&Type::USIZE))?;
        if cols == 1 {
            return Ok(Step::Element(index, self.index_literal(0, expr)));
        }
        if rows == 1 {
            return Ok(Step::Element(self.index_literal(0, expr), index));
        }
        match index.kind {
            ExprKind::Literal(word) => {
                let (row, col) = (word % u64::from(rows), word / u64::from(rows));
                Ok(Step::Element(self.index_literal(row, expr), self.index_literal(col, expr)))
            }
            _ => Ok(Step::Index(index)),
        }
    }

    pub(super) fn index_literal(&mut self, word: u64, expr: &tree::Expr) -> Expr {
        let span = self.span(expr.site);
        Expr::literal(word, Type::Scalar(Scalar::Int(Int::Usize)), span)
    }

    /// The type at a place that is to be assigned, without computing its indices.
    pub(super) fn place_type(&mut self, expr: &tree::Expr) -> Result<Type> {
        if self.is_submatrix(expr) {
            return self.type_alone(expr);
        }
        match &expr.kind {
            tree::ExprKind::Local(name) => Ok(self.named(name, expr.site)?.ty),
            tree::ExprKind::Ref(_, inner) => self.place_type(inner),
            tree::ExprKind::Deref(inner) => {
                let ty = self.place_type(inner)?;
                Ok(self.type_behind(ty))
            }
            tree::ExprKind::Field(base, name) => {
                let base = self.place_type(base)?;
                let base = self.type_behind(base);
                if is_whole(&base, name) {
                    return Ok(base);
                }
                Ok(self.field_step(&base, name, expr)?.1)
            }
            tree::ExprKind::Index(base, index) => {
                match self.place_type(base).map(|base| self.type_behind(base))? {
                    other if let Some(own) = self.own_element_type(&other, index, expr.site)? => {
                        Ok(own)
                    }
                    Type::Array { element, .. } | Type::Slice(element) => Ok(*element),
                    Type::Matrix { element, .. } => Ok(Type::Scalar(element)),
                    other if let Some((_, slice)) = self.cx.as_borrowed(&other) => {
                        Ok(slice.element.clone())
                    }
                    other => Ok(match (self.list_type(&other), self.bounded_type(&other)) {
                        (Some((_, element, _)), _) | (_, Some((element, ..))) => element,
                        _ => other,
                    }),
                }
            }
            tree::ExprKind::Slice(base, ..) => self.place_type(base),
            tree::ExprKind::Call(..) | tree::ExprKind::Try(..) if expr.slot.is_some() => {
                self.refers_to(expr.slot.unwrap_or_default(), expr.site)
            }
            _ => {
                problem(expr.site, "this is not a place to assign", "assign a variable or a field")
            }
        }
    }
}
