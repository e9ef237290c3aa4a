//! Writes of parts of matrices: loops where they stand, so that a place that is constant, or bounded by a loop
//! around it, leaves no check.

use bessemer_ir::tree;
use bessemer_ir::{
    Block, CompareOp, Expr, Fault, LocalId, LogicOp, Place, Span, Step, Stmt, StmtKind, Type,
};

use super::Result;
use super::expr::Operand;
use super::lengths::plus;
use super::lowering::Lowering;

/// A part of a matrix: from where on, and how many rows and columns.
struct Part {
    row: Expr,
    column: Expr,
    rows: u32,
    columns: u32,
}

impl Lowering<'_, '_> {
    /// A call of the library that writes a part of a matrix; false if it is something else.
    pub(super) fn part_effect(&mut self, expr: &tree::Expr) -> Result<bool> {
        let tree::ExprKind::Call(callee, arguments) = &expr.kind else { return Ok(false) };
        let source = self.source;
        let Some(tree::Callee::Function(path)) = source.callees.get(*callee as usize) else {
            return Ok(false);
        };
        let Some(path) = path.strip_prefix("bessemer::linear::") else { return Ok(false) };
        let name = path.split('<').next().unwrap_or(path);
        let [matrix, rest @ ..] = arguments.as_slice() else { return Ok(false) };
        let known = match (name, rest) {
            ("views::set_row" | "views::set_fixed_rows", [row, part]) => {
                self.set_part(matrix, [Some(row), None], part)?
            }
            ("views::set_column" | "views::set_fixed_columns", [column, part]) => {
                self.set_part(matrix, [None, Some(column)], part)?
            }
            ("views::set_fixed_view", [row, column, part]) => {
                self.set_part(matrix, [Some(row), Some(column)], part)?
            }
            ("matrix_edit::fill_row" | "views::fill_row", [row, value]) => {
                self.fill_line(matrix, row, value, (true, name))?
            }
            ("matrix_edit::fill_column" | "views::fill_column", [column, value]) => {
                self.fill_line(matrix, column, value, (false, name))?
            }
            ("matrix_edit::swap_rows", [one, other]) => {
                self.swap_lines(matrix, [one, other], true)?
            }
            ("matrix_edit::swap_columns", [one, other]) => {
                self.swap_lines(matrix, [one, other], false)?
            }
            _ => false,
        };
        Ok(known)
    }

    /// The matrix that is written.
    fn written_matrix(&mut self, matrix: &tree::Expr) -> Result<Option<Place>> {
        let Some(mut place) = self.place(matrix)? else { return Ok(None) };
        if !matches!(place.ty, Type::Matrix { .. }) {
            return Ok(None);
        }
        self.keep_indices(&mut place, |index| !index.is_literal());
        Ok(Some(place))
    }

    /// Writes `part` from a row and a column on; a place that is left out is the first.
    fn set_part(
        &mut self,
        matrix: &tree::Expr,
        first: [Option<&tree::Expr>; 2],
        part: &tree::Expr,
    ) -> Result<bool> {
        let span = self.span(matrix.site);
        let Some(place) = self.written_matrix(matrix)? else { return Ok(false) };
        let Type::Matrix { rows: most_rows, cols: most_columns, element } = place.ty else {
            return Ok(false);
        };
        let mut operands = Vec::new();
        for (index, role) in first.iter().zip(["row", "column"]) {
            if let Some(expr) = index {
                operands.push(Operand { expr, expected: Some(Type::USIZE), role });
            }
        }
        operands.push(Operand { expr: part, expected: None, role: "part" });
        let mut values = self.operands(&operands)?;
        let Some(value) = values.pop() else { return Ok(false) };
        let mut values = values.into_iter();
        let [row, column] = [(first[0], "row"), (first[1], "column")].map(|(index, role)| {
            match index.and_then(|_| values.next()) {
                Some(value) => self.steady(role, value),
                None => Expr::usize(0, span),
            }
        });
        let from = self.hold(value, part.site)?;
        let Type::Matrix { rows, cols: columns, .. } = from.ty else { return Ok(false) };
        for (first, count, most) in [(&row, rows, most_rows), (&column, columns, most_columns)] {
            let end = plus(first.clone(), Expr::usize(u64::from(count), span));
            self.claim(
                Expr::compare(CompareOp::Le, end, Expr::usize(u64::from(most), span)),
                Fault::Index,
            );
        }
        let part = Part { row, column, rows, columns };
        let scalar = Type::Scalar(element);
        self.each_cell(part, span, |place_of, source_of| {
            let to = place.inside(place_of, scalar.clone());
            let value = from.inside(source_of, scalar.clone()).load();
            StmtKind::Assign { place: to, value }
        });
        Ok(true)
    }

    /// Writes one value to a row, or to a column; a view's end may overflow first.
    fn fill_line(
        &mut self,
        matrix: &tree::Expr,
        line: &tree::Expr,
        value: &tree::Expr,
        (is_row, routine): (bool, &str),
    ) -> Result<bool> {
        let span = self.span(matrix.site);
        let Some(place) = self.written_matrix(matrix)? else { return Ok(false) };
        let Type::Matrix { rows, cols, element } = place.ty else { return Ok(false) };
        let scalar = Type::Scalar(element);
        let values = self.operands(&[
            Operand { expr: line, expected: Some(Type::USIZE), role: "line" },
            Operand { expr: value, expected: Some(scalar.clone()), role: "value" },
        ])?;
        let [line, value] = super::expr::two(values, matrix.site)?;
        let (line, value) = (self.steady("line", line), self.steady("value", value));
        let most = Expr::usize(u64::from(if is_row { rows } else { cols }), span);
        let is_there = match routine.starts_with("views::") {
            true => Expr::compare(CompareOp::Le, plus(line.clone(), Expr::usize(1, span)), most),
            false => Expr::compare(CompareOp::Lt, line.clone(), most),
        };
        self.claim(is_there, Fault::Index);
        let zero = Expr::usize(0, span);
        let part = match is_row {
            true => Part { row: line, column: zero, rows: 1, columns: cols },
            false => Part { row: zero, column: line, rows, columns: 1 },
        };
        self.each_cell(part, span, |at, _| StmtKind::Assign {
            place: place.inside(at, scalar.clone()),
            value: value.clone(),
        });
        Ok(true)
    }

    /// Exchanges two rows, or two columns.
    fn swap_lines(
        &mut self,
        matrix: &tree::Expr,
        lines: [&tree::Expr; 2],
        are_rows: bool,
    ) -> Result<bool> {
        let span = self.span(matrix.site);
        let Some(place) = self.written_matrix(matrix)? else { return Ok(false) };
        let Type::Matrix { rows, cols, element } = place.ty else { return Ok(false) };
        let usize = || Some(Type::USIZE);
        let values = self.operands(&[
            Operand { expr: lines[0], expected: usize(), role: "one" },
            Operand { expr: lines[1], expected: usize(), role: "other" },
        ])?;
        let [one, other] = super::expr::two(values, matrix.site)?;
        let (one, other) = (self.steady("one", one), self.steady("other", other));
        let most = || Expr::usize(u64::from(if are_rows { rows } else { cols }), span);
        let inside_both = Expr::logic(
            LogicOp::And,
            Expr::compare(CompareOp::Lt, one.clone(), most()),
            Expr::compare(CompareOp::Lt, other.clone(), most()),
        );
        self.claim(inside_both, Fault::Assertion);
        let count = if are_rows { cols } else { rows };
        let index = self.counter(if are_rows { "column" } else { "row" }, span);
        let along = local(index, span);
        let cell = |line: &Expr| {
            let step = match are_rows {
                true => Step::Element(line.clone(), along.clone()),
                false => Step::Element(along.clone(), line.clone()),
            };
            place.inside(step, Type::Scalar(element))
        };
        let held = LocalId(self.locals.len() as u32);
        let ty = Type::Scalar(element);
        let (name, mode) = ("held".to_owned(), bessemer_ir::Mode::Value);
        self.locals.push(bessemer_ir::Local { name, ty: ty.clone(), mode, span });
        let held_place = Place::local(held, ty, span);
        let body = vec![
            Stmt::new(StmtKind::Let { local: held, value: Some(cell(&one).load()) }, span),
            Stmt::new(StmtKind::Assign { place: cell(&one), value: cell(&other).load() }, span),
            Stmt::new(StmtKind::Assign { place: cell(&other), value: held_place.load() }, span),
        ];
        self.emit(counted(index, count, Block(body), span), span);
        Ok(true)
    }

    /// Loops over the cells of a part: where each is, and where in the part.
    fn each_cell(&mut self, part: Part, span: Span, write: impl Fn(Step, Step) -> StmtKind) {
        let Part { row, column, rows, columns } = part;
        let column_at = (columns > 1).then(|| self.counter("column", span));
        let row_at = (rows > 1).then(|| self.counter("row", span));
        let index = |at: Option<LocalId>| at.map_or(Expr::usize(0, span), |at| local(at, span));
        let (i, j) = (index(row_at), index(column_at));
        let at = Step::Element(plus(row, i.clone()), plus(column, j.clone()));
        let mut kind = write(at, Step::Element(i, j));
        for (counter, count) in [(row_at, rows), (column_at, columns)] {
            if let Some(counter) = counter {
                kind = counted(counter, count, Block(vec![Stmt::new(kind, span)]), span);
            }
        }
        self.emit(kind, span);
    }

    /// A check, unless it plainly holds.
    fn claim(&mut self, condition: Expr, fault: Fault) {
        let span = condition.span;
        self.emit(StmtKind::Check { condition, fault }, span);
    }
}

/// The value of a counter.
pub(super) fn local(root: LocalId, span: Span) -> Expr {
    Place::local(root, Type::USIZE, span).load()
}

/// A loop that counts from 0.
pub(super) fn counted(variable: LocalId, count: u32, body: Block, span: Span) -> StmtKind {
    StmtKind::For {
        variable,
        from: Expr::usize(0, span),
        to: Expr::usize(u64::from(count), span),
        inclusive: false,
        reversed: false,
        unroll: None,
        ended: false,
        body,
    }
}
