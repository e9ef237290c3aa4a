//! Denotation of an expression during lowering, and of names and matched values. It includes consecutive elements: a
//! slice, known by its base and ends; and a part of a matrix, known by its beginning.

use bessemer_ir::tree::Site;
use bessemer_ir::{
    Argument, BinaryOp, CompareOp, Expr, ExprKind, LocalId, Mode, Place, Scalar, Span, Step, Type,
};

use super::lengths::{compared, is_number, minus, plus, size};

/// The meaning of an expression or a name.
#[derive(Clone, PartialEq)]
pub(super) enum Value {
    /// A local of its own.
    Local(LocalId),
    /// A place: that of a value, or the one that a reference refers to.
    Place(Place),
    /// A literal or a constant.
    Word(Box<Expr>),
    /// Elements in a row.
    Slice(Box<Slice>),
    /// A part of a matrix that is written where it is.
    Submatrix(Box<Submatrix>),
    /// A tuple that is never made: its parts, side by side, and its type, if a value of it can be.
    Tuple(Vec<Value>, Option<Type>),
    /// Value that is borrowed if the condition is true.
    Maybe(Expr, Box<Value>),
    /// A closure, by its place among those of the function that is being lowered.
    Closure(usize),
    /// A zero-sized value.
    Nothing,
}

/// A name of a pattern, and what it stands for.
#[derive(Clone)]
pub(super) struct Named {
    pub name: String,
    pub slot: u32,
    pub mutable: bool,
    pub stands: Value,
    pub site: Site,
}

impl Named {
    /// The place that a name of a value is copied from; none if it stands for something else.
    pub(super) fn copied_from(&self) -> Option<&Place> {
        match &self.stands {
            Value::Place(place) => Some(place),
            Value::Slice(part) => Some(&part.base),
            _ => None,
        }
    }
}

/// The step to an element of an array, or of a matrix of one row or column, by its number; of another matrix by columns.
pub(super) fn step_to(whole: &Type, index: Expr, span: Span) -> Step {
    match whole {
        Type::Matrix { cols: 1, .. } => Step::Element(index, Expr::usize(0, span)),
        Type::Matrix { rows: 1, .. } => Step::Element(Expr::usize(0, span), index),
        _ => Step::Index(index),
    }
}

/// Parts of up to so many elements are written out where they are read.
pub(super) const SMALL: u32 = 16;

/// Elements of an array, in their place.
#[derive(Clone, PartialEq)]
pub(super) struct Slice {
    /// The array, or the parameter that is a slice.
    pub base: Place,
    /// Type of one element.
    pub element: Type,
    /// The first element, and the one behind the last: numbers, or locals that nothing writes.
    pub from: Expr,
    pub to: Expr,
    /// Number of elements.
    pub length: Expr,
    /// True if these are all elements of the base.
    pub whole: bool,
    /// The part of the base, a matrix, whose elements these are, by its columns.
    pub within: Option<Box<Submatrix>>,
}

impl Slice {
    pub fn whole(base: Place, element: Type, length: Expr) -> Slice {
        let from = Expr::usize(0, base.span);
        Slice { base, element, from, to: length.clone(), length, whole: true, within: None }
    }

    /// All elements of a parameter that is a slice; the next parameter is its length.
    pub fn parameter(root: LocalId, element: Type, span: Span) -> Slice {
        let base = Place::local(root, Type::Slice(Box::new(element.clone())), span);
        Slice::whole(base, element, Expr::local(LocalId(root.0 + 1), &Type::USIZE, span))
    }

    /// The type of what is lent.
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

    /// An element of the base, by its index there.
    pub fn at(&self, index: Expr) -> Place {
        if let Some(part) = &self.within {
            return part.nth(index);
        }
        self.base.inside(step_to(&self.base.ty, index, self.base.span), self.element.clone())
    }

    /// An element, by its index in the slice.
    pub fn nth(&self, index: Expr) -> Place {
        self.at(plus(self.from.clone(), index))
    }

    /// `length` elements from `begin` on, which are known to be there.
    pub fn part(&self, begin: Expr, length: Expr) -> Slice {
        let from = plus(self.from.clone(), begin);
        let to = plus(from.clone(), length.clone());
        Slice { from, to, length, whole: false, ..self.clone() }
    }

    /// The elements from `from` to `to`, which is no less and no more than there are.
    pub fn between(&self, from: Expr, to: Expr) -> Slice {
        let length = minus(to.clone(), from.clone());
        let (from, to) = (plus(self.from.clone(), from), plus(self.from.clone(), to));
        Slice { from, to, length, whole: false, ..self.clone() }
    }

    /// The elements from `begin` on, which is no more than there are.
    pub fn behind(&self, begin: Expr) -> Slice {
        let length = minus(self.length.clone(), begin.clone());
        Slice { from: plus(self.from.clone(), begin), length, whole: false, ..self.clone() }
    }

    /// True if there are `count` elements, or no fewer where not `exact`; known of an array.
    pub fn has(&self, count: u64, exact: bool, span: Span) -> Expr {
        let op = if exact { CompareOp::Eq } else { CompareOp::Ge };
        match self.length.kind {
            ExprKind::Literal(length) if exact => Expr::bool(length == count, span),
            ExprKind::Literal(length) => Expr::bool(length >= count, span),
            _ => compared(op, &self.length, &Expr::usize(count, span), span),
        }
    }

    /// A copy of the elements, of which there are as many as the array type has.
    pub fn as_array(&self, ty: Type, span: Span) -> Expr {
        let len = if let Type::Array { len, .. } = ty { len } else { 0 };
        let elements = (0..len).map(|at| self.nth(size(at, span)).load()).collect();
        Expr { kind: ExprKind::Array(elements), ty, span }
    }

    /// The argument that a call passes for it.
    pub fn passed(self, mode: Mode) -> [Argument; 2] {
        let place = self.place();
        let first = match mode {
            Mode::RefMut => Argument::RefMut(place),
            _ => Argument::Ref(place.load()),
        };
        [first, Argument::Value(self.length)]
    }
}

/// A part of a matrix.
#[derive(Clone, PartialEq)]
pub(super) struct Submatrix {
    pub matrix: Place,
    /// First row: a number, a local that nothing writes, or a sum of them.
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

    /// An element, which is known to be there.
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

    /// All its elements.
    pub fn elements(&self) -> Slice {
        let length = size(self.rows * self.cols, self.matrix.span);
        let all = Slice::whole(self.matrix.clone(), Type::Scalar(self.element), length);
        Slice { whole: false, within: Some(Box::new(self.clone())), ..all }
    }
}
