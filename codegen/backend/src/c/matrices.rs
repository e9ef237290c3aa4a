//! Layout of matrices in memory: by columns, by rows, or as C's arrays of rows.
//!
//! A matrix with one row or one column is always an array of its elements. Only this module knows the position of an
//! element; code that needs contiguous columns calls it, or takes a copy by columns.

use std::fmt::{Display, Formatter};

use bessemer_ir::{Scalar, Type};

use super::tree::{Expr, Init, Lines};

/// Layout of matrices with several rows and columns in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// `double m[6]`, by columns, as nalgebra stores them: `m[row + 2 * column]`.
    #[default]
    Columns,
    /// `double m[6]`, by rows: `m[column + 3 * row]`.
    Rows,
    /// `double m[2][3]`: `m[row][column]`.
    Array,
}

/// Returns `near + count * far`, unsigned unless both indices are literals. Neutral terms stay: a reader sees row and
/// column of every element alike.
fn flat(near: Expr, count: u32, far: Expr) -> Expr {
    let is_number = |index: &Expr| matches!(index, Expr::Name(text) if text.bytes().all(|it| it.is_ascii_digit()));
    let count = Expr::name(count.to_string());
    let terms = [near, count, far];
    let [near, count, far] = match is_number(&terms[0]) && is_number(&terms[2]) {
        true => terms,
        false => terms.map(|index| match index {
            Expr::Name(text) if is_number(&Expr::name(&text)) => Expr::Name(text + "U"),
            other => other,
        }),
    };
    Expr::binary("+", near, Expr::binary("*", count, far))
}

/// A length, with the name of its constant if it has one.
#[derive(Clone, Copy)]
pub struct Size<'n> {
    /// Number of elements.
    pub number: u32,
    /// Name of the constant.
    pub name: Option<&'n str>,
}

/// Prints the name, or else the number; with `#` as an operand of unsigned arithmetic.
impl Display for Size<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self.name {
            Some(name) => f.write_str(name),
            None if f.alternate() => write!(f, "{}U", self.number),
            None => write!(f, "{}", self.number),
        }
    }
}

impl Layout {
    /// Returns an element of a matrix of this shape.
    pub fn at(self, matrix: Expr, (rows, cols): (u32, u32), row: Expr, column: Expr) -> Expr {
        match (rows, cols) {
            (_, 1) => matrix.at(row),
            (1, _) => matrix.at(column),
            _ => match self {
                Layout::Columns => matrix.at(flat(row, rows, column)),
                Layout::Rows => matrix.at(flat(column, cols, row)),
                Layout::Array => matrix.at(row).at(column),
            },
        }
    }

    /// Returns the element at a constant row and column.
    pub fn element(self, matrix: Expr, shape: (u32, u32), row: u32, column: u32) -> Expr {
        let number = |value: u32| Expr::name(value.to_string());
        self.at(matrix, shape, number(row), number(column))
    }

    /// Returns the element with an index counted by columns.
    pub fn by_columns(self, matrix: Expr, shape: (u32, u32), index: u32) -> Expr {
        self.element(matrix, shape, index % shape.0, index / shape.0)
    }

    /// Returns the subscript of the element with an index counted by columns.
    pub fn subscript(self, shape @ (rows, cols): (u32, u32), index: u32) -> String {
        let (row, column) = (index % rows, index / rows);
        match self {
            _ if self.has_columns(shape) => format!("[{index}]"),
            Layout::Array => format!("[{row}][{column}]"),
            _ => format!("[{}]", column + cols * row),
        }
    }

    /// Returns true if the columns of a matrix of this shape are contiguous and in order.
    pub fn has_columns(self, shape: (u32, u32)) -> bool {
        self == Layout::Columns || is_vector(shape)
    }

    /// Returns true if one index addresses each element.
    pub fn is_flat(self, shape: (u32, u32)) -> bool {
        self != Layout::Array || is_vector(shape)
    }

    /// Returns the text between the brackets of a declaration.
    pub fn dimensions(self, (rows, cols): (Size<'_>, Size<'_>)) -> String {
        let shape = (rows.number, cols.number);
        let is_named = rows.name.is_some() || cols.name.is_some();
        match self.is_flat(shape) {
            true if shape.1 == 1 => format!("[{rows}]"),
            true if shape.0 == 1 => format!("[{cols}]"),
            true if is_named => format!("[{rows:#} * {cols:#}]"),
            true => format!("[{}]", shape.0 * shape.1),
            false => format!("[{rows}][{cols}]"),
        }
    }

    /// Reorders parts by columns to the order in memory.
    pub fn in_memory<T: Clone>(self, parts: &[T], shape @ (rows, cols): (u32, u32)) -> Vec<T> {
        if self.has_columns(shape) {
            return parts.to_vec();
        }
        let each = (0..rows).flat_map(|row| (0..cols).map(move |column| row + rows * column));
        each.filter_map(|index| parts.get(index as usize).cloned()).collect()
    }

    /// Returns the initialiser list of a matrix from its elements by columns.
    pub fn list(self, parts: &[Init], shape @ (rows, cols): (u32, u32), lines: Lines) -> Init {
        let items = |parts: &[Init]| parts.iter().map(|part| (None, part.clone())).collect();
        let parts = self.in_memory(parts, shape);
        if self.is_flat(shape) {
            let group = if self.has_columns(shape) { rows } else { cols };
            let lines =
                if let Lines::Groups(_) = lines { Lines::Groups(group as usize) } else { lines };
            return Init::List { items: items(&parts), lines };
        }
        let row = |row: &[Init]| (None, Init::List { items: items(row), lines: Lines::Fill });
        Init::List { items: parts.chunks(cols as usize).map(row).collect(), lines: Lines::Each }
    }

    /// Returns the array type with the same memory layout as a matrix, for copies word by word.
    pub fn array(self, element: Scalar, shape @ (rows, cols): (u32, u32)) -> Type {
        let array = |element: Type, len: u32| Type::Array { element: Box::new(element), len };
        match self.is_flat(shape) {
            true => array(Type::Scalar(element), rows * cols),
            false => array(array(Type::Scalar(element), cols), rows),
        }
    }
}

fn is_vector((rows, cols): (u32, u32)) -> bool {
    rows == 1 || cols == 1
}
