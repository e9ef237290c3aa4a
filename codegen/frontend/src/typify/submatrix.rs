//! Parts of matrices in place: `m.column_mut(j)`, `m.fixed_view_mut::<2, 2>(i, j)`; and small views that are read
//! element by element.
//!
//! C has no type for a view: a part is its matrix, with a first row and column, and an element of it is an element of
//! the matrix. A function that takes the whole part receives a copy, which is written back after the call.
//!
//! Invariants: the first row and column are evaluated and checked once, where Rust creates the view. Nobody can
//! observe when a copy is written back, since nothing else may access the matrix while the view is alive.
//!
//! Must not know: what the methods of matrices compute.

use bessemer_ir::tree::{self, Builtin, MatrixMethod, MatrixPart, Site};
use bessemer_ir::{CompareOp, Expr, ExprKind, Place, Span, Step, StmtKind, Type};

use super::callee::Called;
use super::expr::Call;
use super::lengths::{plus, size};
use super::lowering::Lowering;
use super::syntax::bare;
use super::value::{SMALL, Submatrix, Value};
use super::words;
use super::{OUR_FAULT, Result, problem};

/// First row and first column of a part; 0 if absent.
type From<'e> = (Option<&'e tree::Expr>, Option<&'e tree::Expr>);

impl<'a> Lowering<'a, '_> {
    /// Returns true if an expression is a part of a matrix in place.
    pub(super) fn is_submatrix(&self, expr: &tree::Expr) -> bool {
        let called = || self.builtin_call(bare(expr)).map(|(builtin, _)| builtin);
        matches!(self.meaning(expr), Some(Value::Submatrix(_)))
            || matches!(called(), Some(Builtin::Matrix(MatrixMethod::Part(_))))
    }

    /// Returns the part of a matrix that an expression is; none for another expression.
    pub(super) fn submatrix(&mut self, expr: &tree::Expr) -> Result<Option<Submatrix>> {
        if let Some(Value::Submatrix(part)) = self.meaning(expr) {
            return Ok(Some(*part));
        }
        let expr = bare(expr);
        let Some((Builtin::Matrix(MatrixMethod::Part(part)), arguments)) = self.builtin_call(expr)
        else {
            return Ok(None);
        };
        let from = match (part, arguments) {
            (MatrixPart::Rows, [_, row]) => (Some(row), None),
            (MatrixPart::Columns, [_, column]) => (None, Some(column)),
            (MatrixPart::Block, [_, row, column]) => (Some(row), Some(column)),
            _ => return Ok(None),
        };
        let ty = self.slot_of(expr)?;
        self.part_from(&arguments[0], from, &ty, expr.site)
    }

    /// Returns the part that begins at a row and a column, with the check that it fits.
    pub(super) fn part_from(
        &mut self,
        matrix: &tree::Expr,
        (row, column): From,
        ty: &Type,
        site: Site,
    ) -> Result<Option<Submatrix>> {
        let Type::Matrix { element, rows, cols } = *ty else { return Ok(None) };
        let span = self.span(site);
        let outer = match self.submatrix(matrix)? {
            Some(outer) => outer,
            None => {
                let place = self.base(matrix)?;
                let Type::Matrix { element, rows, cols } = place.ty else { return Ok(None) };
                let (row, column) = (Expr::usize(0, span), Expr::usize(0, span));
                Submatrix { matrix: place, row, column, element, rows, cols }
            }
        };
        let mut begins = |role, index: Option<&tree::Expr>| match index {
            Some(index) => self.steady_index(role, index),
            None => Ok(Expr::usize(0, span)),
        };
        let (row, column) = (begins(words::ROW, row)?, begins(words::COLUMN, column)?);
        // As in nalgebra, the view ends in the matrix.
        for (first, count, most) in [(&row, rows, outer.rows), (&column, cols, outer.cols)] {
            let end = plus(first.clone(), size(count, span));
            self.check_index(&end, CompareOp::Le, &size(most, span), span);
        }
        let (row, column) = (plus(outer.row, row), plus(outer.column, column));
        Ok(Some(Submatrix { matrix: outer.matrix, row, column, element, rows, cols }))
    }

    /// Returns the place of an element of a part, with the check of its index.
    pub(super) fn part_element(
        &mut self,
        part: &Submatrix,
        index: &tree::Expr,
        expr: &tree::Expr,
    ) -> Result<Place> {
        let span = self.span(expr.site);
        let place = match self.matrix_step(index, &part.ty(), span)? {
            Step::Element(row, column) => {
                let (row, column) = (self.atom("row", row), self.atom("column", column));
                self.check_index(&row, CompareOp::Lt, &size(part.rows, span), span);
                self.check_index(&column, CompareOp::Lt, &size(part.cols, span), span);
                part.at(row, column)
            }
            Step::Index(index) => {
                let index = self.atom(words::INDEX, index);
                let most = size(part.rows * part.cols, span);
                self.check_index(&index, CompareOp::Lt, &most, span);
                part.nth(index)
            }
            _ => return problem(expr.site, "this is no element", OUR_FAULT),
        };
        Ok(Place { span, ..place })
    }

    /// Returns the value of a part: its elements, or a copy.
    pub(super) fn submatrix_value(&mut self, part: &Submatrix, site: Site) -> Result<Expr> {
        if part.is_large() {
            let copy = self.part_copied("part", part, site)?;
            self.locals.note_temporary(copy.root);
            return Ok(copy.load());
        }
        let span = self.span(site);
        let mut elements = Vec::new();
        for column in 0..part.cols {
            for row in 0..part.rows {
                elements.push(part.at(size(row, span), size(column, span)).load());
            }
        }
        self.node(ExprKind::Matrix(elements), part.ty(), site)
    }

    /// Copies a part into a mutable local.
    fn part_copied(&mut self, name: &str, part: &Submatrix, site: Site) -> Result<Place> {
        if !part.is_large() {
            let value = self.submatrix_value(part, site)?;
            return Ok(self.mutable_place(name, value));
        }
        let span = self.span(site);
        // No compiler sees that the loop assigns all of it.
        let copy = self.mutable_place(name, self.zero(&part.ty(), span));
        self.each_of_part(part, span, |at, step| (copy.inside(step, at.ty.clone()), at.load()))?;
        Ok(copy)
    }

    /// Copies a part into a mutable local with this name.
    pub(super) fn copy_of_part(
        &mut self,
        name: &str,
        part: &Submatrix,
        site: Site,
    ) -> Result<Place> {
        self.naming_as("", |inner| inner.part_copied(name, part, site))
    }

    /// Emits a call that changes copies of parts, and writes the copies back.
    pub(super) fn written_back(
        &mut self,
        call: Expr,
        copies: Vec<(Submatrix, Place)>,
    ) -> Result<Expr> {
        if copies.is_empty() {
            return Ok(call);
        }
        let given = self.called_here("given", call);
        for (part, copy) in copies {
            self.write_part(&part, copy.load())?;
        }
        Ok(given)
    }

    /// Emits a call now, and returns its result.
    pub(super) fn called_here(&mut self, role: &str, call: Expr) -> Expr {
        if call.ty != Type::Unit {
            return self.atom(role, call);
        }
        let span = call.span;
        self.emit(StmtKind::Expr(call), span);
        Expr::literal(0, Type::Unit, span)
    }

    /// Writes a value to a part.
    pub(super) fn write_part(&mut self, part: &Submatrix, value: Expr) -> Result<()> {
        let span = value.span;
        if let ExprKind::Splat(value) = value.kind {
            let value = self.atom(words::ELEMENT, *value);
            return self.each_of_part(part, span, |at, _| (at, value.clone()));
        }
        let place = match value.kind {
            ExprKind::Load(place) if place.root != part.matrix.root => place,
            _ => self.atom_place("part", value),
        };
        self.each_of_part(part, span, |at, step| {
            let value = place.inside(step, at.ty.clone()).load();
            (at, value)
        })
    }

    /// Emits an assignment for each element of a part, column by column. `assigned` receives the element's place and
    /// the step to it in a matrix of the part's size.
    fn each_of_part(
        &mut self,
        part: &Submatrix,
        span: Span,
        assigned: impl Fn(Place, Step) -> (Place, Expr),
    ) -> Result<()> {
        self.each_cell(words::COLUMN, (part.rows, part.cols), span, |walk, row, column| {
            let at = part.at(row.clone(), column.clone());
            let (place, value) = assigned(at, Step::Element(row, column));
            walk.emit(StmtKind::Assign { place, value }, span);
            Ok(())
        })
    }

    /// Lowers `part += value`, and `*part = value` of an inlined function.
    pub(super) fn assign_part(
        &mut self,
        op: Option<tree::BinaryOp>,
        place: &tree::Expr,
        value: &tree::Expr,
        site: Site,
    ) -> Result<()> {
        let Some(part) = self.submatrix(place)? else { return Ok(()) };
        let ty = part.ty();
        let Some(op) = op else {
            let value = self.value(value, Some(&ty))?;
            self.agree(&value.ty, &ty, site)?;
            return self.write_part(&part, value);
        };
        let naming = match self.expanding.is_empty() {
            true => self.name_of(place),
            false => words::PART.into(),
        };
        let copy = self.copy_of_part(&naming, &part, site)?;
        let value = self.naming_as(naming, |inner| match inner.operator(place.slot).cloned() {
            Some(callee) => inner.naming_scope(|inner| {
                inner.bind(COPY, Value::Place(copy.clone()));
                let held = tree::Expr::local(COPY, site);
                inner.call_of(&callee, &[held, value.clone()], place)
            }),
            None => {
                let expected = inner.compound_operand(op, &ty);
                let value = inner.read(value, expected.as_ref())?;
                inner.binary_node(op, copy.load(), value, site)
            }
        })?;
        self.agree(&value.ty, &ty, site)?;
        let span = value.span;
        self.emit(StmtKind::Assign { place: copy.clone(), value }, span);
        self.write_part(&part, copy.load())
    }

    /// Returns the inlined call that `expr` is, if the function only assigns a whole part.
    pub(super) fn assigns_part<'e>(&self, expr: &'e tree::Expr) -> Option<Called<'a, 'e>> {
        let (function, arguments) = self.called(expr)?;
        let tree::Block { stmts, tail: None } = &function.tree.body else { return None };
        let [tree::Stmt::Expr(tree::Expr { kind: tree::ExprKind::Assign(_, place, _), .. })] =
            stmts.as_slice()
        else {
            return None;
        };
        let whole = matches!(&place.kind, tree::ExprKind::Deref(of) if matches!(of.kind, tree::ExprKind::Local(_)));
        (whole && self.is_submatrix(arguments.first()?)).then_some((function, arguments))
    }

    /// Returns the value of an operand, which may be a part.
    pub(super) fn read(&mut self, expr: &tree::Expr, expected: Option<&Type>) -> Result<Expr> {
        match self.submatrix(expr)? {
            Some(part) => self.submatrix_value(&part, expr.site),
            None => self.value(expr, expected),
        }
    }

    /// The inlined form of a call of the library; none if it stays a call.
    pub(super) fn shorter(&mut self, path: &str, call: Call<'_>) -> Result<Option<Expr>> {
        let view = path.strip_prefix("bessemer::linear::views::");
        match view.and_then(|view| view.split('<').next()) {
            Some(name) => self.view(name, call),
            None => self.small_power(path, call),
        }
    }

    /// Lowers `v.zyx()`: components of a vector by their names.
    pub(super) fn swizzle(&mut self, axes: &[u8], call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        let ty = self.slot_of(expr)?;
        let span = self.span(expr.site);
        let place = self.base(&arguments[0])?;
        let Type::Matrix { element, .. } = place.ty else {
            return problem(expr.site, "this takes a vector", OUR_FAULT);
        };
        let component = |axis: &u8| {
            let step = Step::Element(size((*axis).into(), span), Expr::usize(0, span));
            place.inside(step, Type::Scalar(element)).load()
        };
        self.node(ExprKind::Matrix(axes.iter().map(component).collect()), ty, expr.site)
    }

    fn view(&mut self, name: &str, call: Call<'_>) -> Result<Option<Expr>> {
        let Call { arguments, expr } = call;
        let from = match (name, arguments) {
            _ if expr.slot.is_none() => return Ok(None),
            ("row" | "fixed_rows", [_, row]) => (Some(row), None),
            ("column" | "fixed_columns", [_, column]) => (None, Some(column)),
            ("fixed_view", [_, row, column]) => (Some(row), Some(column)),
            _ => return Ok(None),
        };
        let ty = self.slot_of(expr)?;
        let small = |rows: u32, cols| rows.saturating_mul(cols) <= SMALL;
        if !matches!(ty, Type::Matrix { rows, cols, .. } if small(rows, cols)) {
            return Ok(None);
        }
        let part = self.part_from(&arguments[0], from, &ty, expr.site)?;
        part.map(|part| self.submatrix_value(&part, expr.site)).transpose()
    }
}

/// Name of a copy, which no author can write.
const COPY: &str = "part%";
