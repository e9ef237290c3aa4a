//! Meaning of an expression, a name or a matched value during lowering. A slice is known by its array and its ends,
//! and a part of a matrix by the matrix and its first row and column.

use bessemer_ir::tree::Site;
use bessemer_ir::{
    Argument, BinaryOp, CompareOp, Expr, ExprKind, LocalId, Mode, Place, Scalar, Span, Step, Type,
};

use bessemer_ir::visit::Walk;

use super::lengths::{compared, is_number, minus, plus, size};

/// Meaning of an expression or a name.
#[derive(Clone, PartialEq)]
pub(super) enum Value {
    /// A local that the author named.
    Local(LocalId),
    /// The place of a value, or the referent of a reference.
    Place(Place),
    /// A literal or a constant.
    Word(Box<Expr>),
    /// A slice.
    Slice(Box<Slice>),
    /// A part of a matrix, as an alias.
    Submatrix(Box<Submatrix>),
    /// The parts of a tuple that is not built, and its type if it can be built.
    Tuple(Vec<Value>, Option<Type>),
    /// A reference that exists only if the condition is true.
    Maybe(Expr, Box<Value>),
    /// A closure, by its index in `Lowering::closures`.
    Closure(usize),
    /// A zero-sized value.
    Nothing,
}

/// A name of a pattern, and its meaning.
#[derive(Clone)]
pub(super) struct Named {
    pub name: String,
    pub slot: u32,
    pub mutable: bool,
    pub stands: Value,
    pub site: Site,
}

impl Named {
    /// Returns the place that a name with a value type is copied from; none if its meaning is no place.
    pub(super) fn copied_from(&self) -> Option<&Place> {
        match &self.stands {
            Value::Place(place) => Some(place),
            Value::Slice(part) => Some(&part.base),
            _ => None,
        }
    }
}

impl Value {
    /// Returns true if it contains a local for which `is` holds.
    pub(super) fn any_local(&self, is: &dyn Fn(LocalId) -> bool) -> bool {
        let value = |value: &Expr| value.any_place(|place, _| is(place.root));
        let place = |place: &Place| value(&place.load());
        let submatrix =
            |part: &Submatrix| place(&part.matrix) || value(&part.row) || value(&part.column);
        match self {
            Value::Local(local) => is(*local),
            Value::Place(it) => place(it),
            Value::Word(word) => value(word),
            Value::Slice(slice) => {
                place(&slice.base)
                    || [&slice.from, &slice.to, &slice.length].into_iter().any(value)
                    || slice.within.as_deref().is_some_and(submatrix)
            }
            Value::Submatrix(part) => submatrix(part),
            Value::Tuple(parts, _) => parts.iter().any(|part| part.any_local(is)),
            Value::Maybe(there, it) => value(there) || it.any_local(is),
            Value::Closure(_) | Value::Nothing => false,
        }
    }
}

/// Returns the indices that lead to a place.
pub(super) fn indices(place: &Place) -> impl Iterator<Item = &Expr> {
    place.steps.iter().flat_map(Step::indices)
}

/// Returns the step to an element of an array by its index. A matrix with several rows and columns is indexed by its
/// columns.
pub(super) fn step_to(whole: &Type, index: Expr, span: Span) -> Step {
    match whole {
        Type::Matrix { cols: 1, .. } => Step::Element(index, Expr::usize(0, span)),
        Type::Matrix { rows: 1, .. } => Step::Element(Expr::usize(0, span), index),
        _ => Step::Index(index),
    }
}

/// Largest number of elements that are read one by one where a part of a matrix is used.
pub(super) const SMALL: u32 = 16;

/// Elements of an array, in place.
#[derive(Clone, PartialEq)]
pub(super) struct Slice {
    /// The array, or the slice parameter.
    pub base: Place,
    /// Type of one element.
    pub element: Type,
    /// Index of the first element, and the index after the last: literals, or locals that are not written again.
    pub from: Expr,
    pub to: Expr,
    /// Number of elements.
    pub length: Expr,
    /// True if the slice has all elements of the base.
    pub whole: bool,
    /// The part of the base, a matrix, that contains the elements column by column.
    pub within: Option<Box<Submatrix>>,
}

impl Slice {
    pub fn whole(base: Place, element: Type, length: Expr) -> Slice {
        let from = Expr::usize(0, base.span);
        Slice { base, element, from, to: length.clone(), length, whole: true, within: None }
    }

    /// Returns all elements of a slice parameter; the next parameter is its length.
    pub fn parameter(root: LocalId, element: Type, span: Span) -> Slice {
        let base = Place::local(root, Type::Slice(Box::new(element.clone())), span);
        Slice::whole(base, element, Expr::local(LocalId(root.0 + 1), &Type::USIZE, span))
    }

    /// Returns the slice type.
    pub fn ty(&self) -> Type {
        Type::Slice(Box::new(self.element.clone()))
    }

    /// Returns the place of the first element.
    pub fn place(&self) -> Place {
        match (&self.base.ty, is_number(&self.from, 0)) {
            (Type::Slice(_), true) => self.base.clone(),
            _ => self.base.inside(Step::From(self.from.clone()), self.ty()),
        }
    }

    /// Returns the place of an element, by its index in the base.
    pub fn at(&self, index: Expr) -> Place {
        if let Some(part) = &self.within {
            return part.nth(index);
        }
        self.base.inside(step_to(&self.base.ty, index, self.base.span), self.element.clone())
    }

    /// Returns the place of an element, by its index in the slice.
    pub fn nth(&self, index: Expr) -> Place {
        self.at(plus(self.from.clone(), index))
    }

    /// Returns `length` elements from `begin` on, without a check.
    pub fn part(&self, begin: Expr, length: Expr) -> Slice {
        let from = plus(self.from.clone(), begin);
        let to = plus(from.clone(), length.clone());
        Slice { from, to, length, whole: false, ..self.clone() }
    }

    /// Returns the elements from `from` to `to`, without a check.
    pub fn between(&self, from: Expr, to: Expr) -> Slice {
        let length = minus(to.clone(), from.clone());
        let (from, to) = (plus(self.from.clone(), from), plus(self.from.clone(), to));
        Slice { from, to, length, whole: false, ..self.clone() }
    }

    /// Returns the elements from `begin` on, without a check.
    pub fn behind(&self, begin: Expr) -> Slice {
        let length = minus(self.length.clone(), begin.clone());
        Slice { from: plus(self.from.clone(), begin), length, whole: false, ..self.clone() }
    }

    /// Returns the condition that there are exactly `count` elements, or at least as many unless `exact`. It is a
    /// literal for an array.
    pub fn has(&self, count: u64, exact: bool, span: Span) -> Expr {
        let op = if exact { CompareOp::Eq } else { CompareOp::Ge };
        match self.length.kind {
            ExprKind::Literal(length) if exact => Expr::bool(length == count, span),
            ExprKind::Literal(length) => Expr::bool(length >= count, span),
            _ => compared(op, &self.length, &Expr::usize(count, span), span),
        }
    }

    /// Returns the elements as an array value; the lengths must agree.
    pub fn as_array(&self, ty: Type, span: Span) -> Expr {
        let len = if let Type::Array { len, .. } = ty { len } else { 0 };
        let elements = (0..len).map(|at| self.nth(size(at, span)).load()).collect();
        Expr { kind: ExprKind::Array(elements), ty, span }
    }

    /// Returns the two arguments with which a call passes the slice.
    pub fn passed(self, mode: Mode) -> [Argument; 2] {
        let place = self.place();
        let first = match mode {
            Mode::RefMut => Argument::RefMut(place),
            _ => Argument::Ref(place.load()),
        };
        [first, Argument::Value(self.length)]
    }
}

/// A part of a matrix, in place.
#[derive(Clone, PartialEq)]
pub(super) struct Submatrix {
    pub matrix: Place,
    /// First row: a literal, a local that is not written again, or a sum of these.
    pub row: Expr,
    pub column: Expr,
    pub element: Scalar,
    pub rows: u32,
    pub cols: u32,
}

impl Submatrix {
    pub fn ty(&self) -> Type {
        Type::Matrix { element: self.element, rows: self.rows, cols: self.cols }
    }

    pub fn is_large(&self) -> bool {
        self.rows.saturating_mul(self.cols) > SMALL
    }

    /// Returns the place of an element, without a check.
    pub fn at(&self, row: Expr, column: Expr) -> Place {
        let step = Step::Element(plus(self.row.clone(), row), plus(self.column.clone(), column));
        self.matrix.inside(step, Type::Scalar(self.element))
    }

    /// Returns the element with an index counted by columns.
    pub fn nth(&self, index: Expr) -> Place {
        let zero = Expr::usize(0, index.span);
        match (self.rows, self.cols) {
            (_, 1) => self.at(index, zero),
            (1, _) => self.at(zero, index),
            (rows, _) => {
                let rows = size(rows, index.span);
                let row = Expr::binary(BinaryOp::Rem, index.clone(), rows.clone());
                self.at(row, Expr::binary(BinaryOp::Div, index, rows))
            }
        }
    }

    /// Returns all elements of the part, column by column.
    pub fn elements(&self) -> Slice {
        let length = size(self.rows * self.cols, self.matrix.span);
        let all = Slice::whole(self.matrix.clone(), Type::Scalar(self.element), length);
        Slice { whole: false, within: Some(Box::new(self.clone())), ..all }
    }
}
