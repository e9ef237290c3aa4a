//! Places, and names of references, which are aliases of places.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Argument, Expr, ExprKind, Local, Module, Place, Span, Step, Type};

use super::expr::{Operand, two};
use super::lowering::{Lowering, RESULT, UNNAMED};
use super::syntax::{bare, control_with_value};
use super::value::{Value, step_to};
use super::words;
use super::{Needed, Result, problem, refusals, refused};

/// Returns true if a field is the whole value: `coords` of a point, `vector` of a translation.
fn is_whole(base: &Type, name: &str) -> bool {
    matches!(base, Type::Matrix { .. }) && (name == "coords" || name == "vector")
}

/// Returns the row and the column, from 0, of nalgebra's `m12`.
fn by_name(name: &str) -> Option<(u64, u64)> {
    let digit = |at: usize| match name.as_bytes().get(at)? {
        digit @ b'1'..=b'6' => Some(u64::from(digit - b'1')),
        _ => None,
    };
    (name.len() == 3 && name.starts_with('m')).then_some((digit(1)?, digit(2)?))
}

impl Lowering<'_, '_> {
    /// Returns the place that `expr` denotes; none if it is a value.
    pub(super) fn place(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        let expr = bare(expr);
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
            tree::ExprKind::Call(..) => match self.lent_place(expr)? {
                None if self.gives_element(expr) => {
                    let held = self.held(expr)?;
                    self.element_lent(&held, expr.site)
                }
                place => Ok(place),
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
                let place = match is_whole(&base.ty, name) {
                    true => base,
                    false => {
                        let (step, ty) = self.field_step(&base.ty, name, expr)?;
                        Place { span, ..base.inside(step, ty) }
                    }
                };
                self.followed(place, expr.site).map(Some)
            }
            tree::ExprKind::Index(base, index) => {
                if let Some(part) = self.submatrix(base)? {
                    return self.part_element(&part, index, expr).map(Some);
                }
                if let Some(slice) = self.slice(base)? {
                    return self.slice_element(&slice, index, span).map(Some);
                }
                if !self.cx.implied.indexing.is_empty()
                    && let Ok(owner) = self.place_type(base)
                    && let Some(place) = self.own_element(&owner, [base, index], expr.site)?
                {
                    return Ok(Some(place));
                }
                let base = self.base(base)?;
                self.element(base, index, span).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Returns the place of a destructured expression; a value is held in a temporary.
    pub(super) fn base(&mut self, expr: &tree::Expr) -> Result<Place> {
        match self.place(expr)? {
            Some(place) => Ok(place),
            None => self.held(expr),
        }
    }

    /// Returns the place of the value of an expression.
    pub(super) fn held(&mut self, expr: &tree::Expr) -> Result<Place> {
        let value = self.value(expr, None)?;
        Ok(self.hold(value))
    }

    /// Returns the place of a value: its own, or a temporary's. An index with a call is evaluated here, once.
    pub(super) fn hold(&mut self, value: Expr) -> Place {
        if let ExprKind::Load(place) = value.kind {
            return place;
        }
        let known = self.cx.known(&value.ty);
        let borrowed = self.cx.as_borrowed(&value.ty).is_some();
        let named = match self.type_behind(value.ty.clone()) {
            behind @ Type::Struct(_) => behind,
            _ => value.ty.clone(),
        };
        let role = match &named {
            Type::Struct(_) if known.shown.is_some() && !borrowed => {
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
        let naming = match known.shown.is_some() && !borrowed {
            _ if choice => self.naming.clone(),
            // The argument tells a second one of the name from the first.
            true if self.locals.iter().any(|local| local.name == role) => {
                argument(&self.cx.module, &self.locals, &value).unwrap_or_default()
            }
            _ => String::new(),
        };
        self.naming_as(naming, |inner| inner.atom_place(&role, value))
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
                let (rows, cols) = (u64::from(*rows), u64::from(*cols));
                let axis = (0..).zip(["x", "y", "z", "w", "a", "b"]).find(|(_, it)| *it == name);
                let axis = axis.filter(|_| rows == 1 || cols == 1);
                let axis = axis.map(|(at, _)| if cols == 1 { (at, 0) } else { (0, at) });
                let at = by_name(name).filter(|_| cols > 1).or(axis);
                if let Some((row, col)) = at.filter(|(row, col)| *row < rows && *col < cols) {
                    let [row, col] = [row, col].map(|at| Expr::usize(at, self.span(expr.site)));
                    return Ok((Step::Element(row, col), Type::Scalar(*element)));
                }
            }
            _ => {}
        }
        problem(expr.site, format!("`{name}` is not a supported field"), "use an index")
    }

    fn element(&mut self, base: Place, index: &tree::Expr, span: Span) -> Result<Place> {
        let whole = base.ty.clone();
        let ty = match &whole {
            Type::Array { element, .. } => (**element).clone(),
            Type::Matrix { element, .. } => Type::Scalar(*element),
            bounded if self.contained(bounded).is_some() => {
                return self.bounded_element(base, index, span);
            }
            Type::Struct(id) if self.cx.known(&whole).unit.is_some() => {
                return Ok(self.part(&base, *id, super::spatial::numbered(index)?));
            }
            _ => return refused(Site(span.line, span.column), refusals::INDEXED),
        };
        let step = match &whole {
            Type::Matrix { .. } => self.matrix_step(index, &whole, span)?,
            _ => Step::Index(self.value(index, Some(&Type::USIZE))?),
        };
        Ok(self.indexed(Place { span, ..base.inside(step, ty) }))
    }

    pub(super) fn matrix_step(
        &mut self,
        index: &tree::Expr,
        matrix: &Type,
        span: Span,
    ) -> Result<Step> {
        if let tree::ExprKind::Tuple(parts) = &index.kind
            && let [row, col] = parts.as_slice()
        {
            let [row, col] = self.row_and_column([row, col])?;
            return Ok(Step::Element(row, col));
        }
        let index = self.value(index, Some(&Type::USIZE))?;
        Ok(match (step_to(matrix, index, span), matrix) {
            (
                Step::Index(Expr { kind: ExprKind::Literal(word), .. }),
                Type::Matrix { rows, .. },
            ) => {
                let [row, col] = [word % u64::from(*rows), word / u64::from(*rows)];
                Step::Element(Expr::usize(row, span), Expr::usize(col, span))
            }
            (step, _) => step,
        })
    }

    /// Returns the indices of a row and a column.
    pub(super) fn row_and_column(&mut self, [row, col]: [&tree::Expr; 2]) -> Result<[Expr; 2]> {
        let operand = |expr, role| Operand { expr, expected: Some(Type::USIZE), role };
        let indices = self.operands(&[operand(row, words::ROW), operand(col, words::COLUMN)])?;
        two(indices, row.site)
    }

    /// Returns the type of a place that is to be assigned, without evaluating its indices.
    pub(super) fn place_type(&mut self, expr: &tree::Expr) -> Result<Type> {
        if let Some(Value::Submatrix(part)) = self.meaning(expr) {
            return Ok(part.ty());
        }
        match &expr.kind {
            tree::ExprKind::Call(..) if self.is_submatrix(expr) => self.slot_of(expr),
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
                    other => Ok(match self.contained(&other) {
                        Some((element, ..)) => element,
                        None => other,
                    }),
                }
            }
            tree::ExprKind::Slice(base, ..) => self.place_type(base),
            tree::ExprKind::Call(..) | tree::ExprKind::Try(..) if expr.slot.is_some() => {
                self.refers_to(expr.slot.unwrap_or_default(), expr.site)
            }
            tree::ExprKind::Path(index, name) => Ok(self.path(*index, name, expr.site)?.ty),
            _ => refused(expr.site, refusals::ASSIGNED),
        }
    }

    /// Returns the meaning of a name, also behind `&` and `*`; none for another expression.
    pub(super) fn meaning(&self, expr: &tree::Expr) -> Option<Value> {
        match &bare(expr).kind {
            tree::ExprKind::Local(name) => self.lookup(name, expr.site).ok(),
            _ => None,
        }
    }

    /// Returns the meaning of a name, also behind `&`, but not behind `*`.
    pub(super) fn meaning_lent(&self, expr: &tree::Expr) -> Option<Value> {
        match &expr.kind {
            tree::ExprKind::Ref(_, inner) => self.meaning_lent(inner),
            tree::ExprKind::Deref(_) => None,
            _ => self.meaning(expr),
        }
    }

    /// Returns the place that a name denotes; none if it denotes another kind of value.
    pub(super) fn place_of(&self, meaning: &Value, span: Span) -> Option<Place> {
        match meaning {
            Value::Place(place) => Some(place.clone()),
            Value::Slice(slice) => Some(slice.place()),
            Value::Local(root) => {
                Some(Place::local(*root, self.locals[root.index()].ty.clone(), span))
            }
            _ => None,
        }
    }

    /// Copies the value at a place into a temporary.
    pub(super) fn hold_copy(&mut self, name: &str, place: Place) -> Place {
        self.naming_as("", |inner| inner.atom_place(name, place.load()))
    }

    /// Lowers `let name = &place`, which makes the name an alias.
    pub(super) fn alias(
        &mut self,
        (name, slot): (&str, u32),
        value: Option<&tree::Expr>,
        site: Site,
    ) -> Result<()> {
        let value = value.map(reborrowed);
        if let Some(value) = value
            && self.alias_of_arm((name, slot), value, site)?
        {
            return Ok(());
        }
        let exclusive = self.slot_is_exclusive(slot, site)?;
        if exclusive && value.and_then(whole_of).is_some_and(control_with_value) {
            return refused(site, refusals::CHOSEN_REFERENCE);
        }
        let naming = match value.map(|value| &bare(value).kind) {
            Some(tree::ExprKind::Call(..) | tree::ExprKind::Try(..)) => self.naming.clone(),
            _ => name.trim_matches('_').to_owned(),
        };
        let mut place =
            value.map_or(Ok(None), |value| self.naming_as(naming, |inner| inner.place(value)))?;
        // The place of a shared reference is not written while the reference lives, so a copy has the same value.
        let chosen = |value: &tree::Expr| {
            matches!(value.kind, tree::ExprKind::Apply(..)) || control_with_value(value)
        };
        let lent = value.filter(|value| lends(value) || chosen(value) && !exclusive);
        // What a call lends is not written while it is lent.
        if let (None, Some(lent)) = (&place, lent) {
            place = Some(self.held(lent)?);
        }
        if let (None, Some(value)) = (&place, value.and_then(referent_without_place)) {
            let (ty, span) = (self.refers_to(slot, site)?, self.span(site));
            let own = self
                .naming_as(name, |inner| inner.decided_by(name.to_owned(), ty, Some(value), span));
            place = Some(own?);
        }
        let reason = match value.is_some_and(|value| control_with_value(bare(value))) {
            true => refusals::CHOSEN_REFERENCE,
            false => refusals::NAMED_REFERENCE,
        };
        let mut place = place.or_refused(site, reason)?;
        let moves = !exclusive && (self.is_loan(&place) || value.is_some_and(is_held));
        if moves {
            // A reference that a value holds is a copy there; the value may get another.
            place = self.hold_copy(name, place);
        }
        self.bind(name, Value::Place(place));
        Ok(())
    }
}

/// Returns the reference that `expr` borrows again: `r` of `&mut *r`.
fn reborrowed(expr: &tree::Expr) -> &tree::Expr {
    match &expr.kind {
        tree::ExprKind::Ref(_, inner) => match &inner.kind {
            tree::ExprKind::Deref(reference) => reborrowed(reference),
            _ => expr,
        },
        _ => expr,
    }
}

/// Returns the expression of whose value a reference denotes a part: `v` of `&mut v.x[1]`, and nothing of `&mut v`.
fn whole_of(reference: &tree::Expr) -> Option<&tree::Expr> {
    use tree::ExprKind::{Deref, Field, Index, Ref, Slice};
    match &reference.kind {
        Ref(_, inner) => whole_of(inner),
        Deref(base) | Field(base, _) | Index(base, _) | Slice(base, ..) => {
            Some(whole_of(base).unwrap_or_else(|| bare(base)))
        }
        _ => None,
    }
}

/// Returns the value without a place to which `expr` refers. Rust gives it a place that lives as long as the name. The
/// caller has found no place, so an expression that Rust takes for a place, and may be written, has no such value.
fn referent_without_place(expr: &tree::Expr) -> Option<&tree::Expr> {
    use tree::ExprKind::{Deref, Field, Index};
    match &expr.kind {
        tree::ExprKind::Ref(_, inner) => {
            (!matches!(inner.kind, Deref(_) | Field(..) | Index(..))).then_some(inner)
        }
        tree::ExprKind::Bytes(_) => Some(expr),
        _ => None,
    }
}

/// Returns true if the referent of `expr` comes from a call or a fold, which hold their own results.
fn lends(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Ref(false, inner) | tree::ExprKind::Try(_, inner) => lends(inner),
        tree::ExprKind::Call(..) | tree::ExprKind::Fold { .. } => true,
        _ => false,
    }
}

/// Returns true if a reference is stored in a field or an element of a value.
fn is_held(expr: &tree::Expr) -> bool {
    matches!(expr.kind, tree::ExprKind::Field(..) | tree::ExprKind::Index(..))
}

/// Returns the name of the first argument of a call, which tells its result from others of the same type.
fn argument(module: &Module, locals: &[Local], value: &Expr) -> Option<String> {
    let ExprKind::Call(_, arguments) = &value.kind else { return None };
    let place = match arguments.first()? {
        Argument::Value(Expr { kind: ExprKind::Load(place), .. })
        | Argument::Ref(Expr { kind: ExprKind::Load(place), .. })
        | Argument::RefMut(place) => place,
        Argument::Value(_) | Argument::Ref(_) => return None,
    };
    let local = &locals[place.root.index()];
    let (mut ty, mut name) = (local.ty.clone(), &local.name);
    for step in &place.steps {
        if let (Type::Struct(id), Step::Field(field)) = (&ty, step) {
            name = &module.structs[id.index()].fields[*field as usize].name;
        }
        ty = module.step_type(&ty, step)?;
    }
    // Several elements of one array have its name.
    let whole = place.steps.iter().all(|step| matches!(step, Step::Field(_)));
    (whole && name != "self").then(|| name.clone())
}
