//! Values: trees whose leaves are numbers, each an expression with its derivatives.

use std::collections::BTreeMap;

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{Expr, Int, Module, Place, Scalar, Span, Step, Type};

/// Derivatives of a number by variables, each of its type. Those by all other variables are zero.
pub type Tangents = BTreeMap<u32, Expr>;

/// A number, a boolean or an enum.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// The value.
    pub value: Expr,
    /// Derivatives of the value.
    pub tangents: Tangents,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// One word.
    Leaf(Word),
    /// Parts in the order of their words: fields, elements, elements by columns.
    Parts(Vec<Value>),
    /// A value without derivatives, at a place that is never written again.
    Place(Place),
    /// A factor of a matrix with derivatives, or a struct of factors.
    Factor(Factor),
}

/// A factor of a matrix. It solves with the derivatives of the matrix; its own are unknown.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// Place of the factor; none if it is never computed.
    pub value: Option<Place>,
    /// The matrix by columns.
    pub of: Vec<Word>,
}

impl Word {
    /// Returns a word without derivatives.
    pub fn constant(value: Expr) -> Word {
        Word { value, tangents: Tangents::new() }
    }
}

/// Returns the steps to the parts of a type, with their types. A word has none.
pub fn parts(module: &Module, ty: &Type, span: Span) -> Vec<(Step, Type)> {
    let at = |index: u32| Expr::literal(index.into(), Type::Scalar(Scalar::Int(Int::Usize)), span);
    match ty {
        Type::Struct(id) => {
            let fields = module.structs[id.index()].fields.iter().enumerate();
            fields.map(|(index, field)| (Step::Field(index as u32), field.ty.clone())).collect()
        }
        Type::Array { element, len } => {
            (0..*len).map(|index| (Step::Index(at(index)), (**element).clone())).collect()
        }
        Type::Matrix { element, rows, cols } => {
            let all = (0..*cols).flat_map(|col| (0..*rows).map(move |row| (row, col)));
            let ty = Type::Scalar(*element);
            all.map(|(row, col)| (Step::Element(at(row), at(col)), ty.clone())).collect()
        }
        _ => Vec::new(),
    }
}

impl Value {
    /// Returns the value at a place that is never written.
    pub fn at(place: Place) -> Value {
        match place.ty.is_word() {
            true => Value::Leaf(Word::constant(place.load())),
            false => Value::Place(place),
        }
    }

    /// Returns the value as parts, unless it is a word.
    pub fn split(self, module: &Module) -> Value {
        match self {
            Value::Place(place) => {
                let parts = parts(module, &place.ty, place.span);
                let part = |(step, ty)| Value::at(place.inside(step, ty));
                Value::Parts(parts.into_iter().map(part).collect())
            }
            other => other,
        }
    }

    /// Returns the words in their order.
    pub fn words(self, module: &Module) -> Vec<Word> {
        match self.split(module) {
            Value::Leaf(word) => vec![word],
            Value::Parts(parts) => parts.into_iter().flat_map(|it| it.words(module)).collect(),
            Value::Place(_) => Vec::new(),
            Value::Factor(factor) => factor.of,
        }
    }

    /// Calls `change` on each word, in order. Places become parts.
    pub fn each(
        &mut self,
        module: &Module,
        change: &mut impl FnMut(&mut Word) -> crate::Result<()>,
    ) -> crate::Result<()> {
        if let Value::Place(place) = self {
            *self = Value::Place(place.clone()).split(module);
        }
        match self {
            Value::Leaf(word) => change(word),
            Value::Parts(parts) => parts.iter_mut().try_for_each(|it| it.each(module, change)),
            Value::Place(_) | Value::Factor(_) => Ok(()),
        }
    }

    /// Returns true if a word has derivatives.
    pub fn is_active(&self) -> bool {
        match self {
            Value::Leaf(word) => !word.tangents.is_empty(),
            Value::Parts(parts) => parts.iter().any(Value::is_active),
            Value::Place(_) => false,
            Value::Factor(_) => true,
        }
    }

    /// Returns true if a part is a factor.
    pub fn has_factor(&self) -> bool {
        match self {
            Value::Parts(parts) => parts.iter().any(Value::has_factor),
            Value::Factor(_) => true,
            Value::Leaf(_) | Value::Place(_) => false,
        }
    }

    /// Returns true if it reads only the first locals, `count` of them.
    pub fn is_visible(&self, count: usize) -> bool {
        let visible = |expr: &Expr| is_visible(expr, count);
        let word = |word: &Word| visible(&word.value) && word.tangents.values().all(visible);
        match self {
            Value::Leaf(it) => word(it),
            Value::Parts(parts) => parts.iter().all(|it| it.is_visible(count)),
            Value::Place(place) => visible(&place.load()),
            Value::Factor(factor) => {
                let value = factor.value.iter().all(|place| visible(&place.load()));
                value && factor.of.iter().all(word)
            }
        }
    }

    /// Returns a value of a type from its words, in order.
    pub fn of(module: &Module, ty: &Type, words: &mut impl Iterator<Item = Word>) -> Option<Value> {
        if ty.is_word() {
            return words.next().map(Value::Leaf);
        }
        let parts = parts(module, ty, Span::default());
        let all = parts.iter().map(|(_, ty)| Value::of(module, ty, words));
        all.collect::<Option<Vec<_>>>().map(Value::Parts)
    }
}

fn is_visible(expr: &Expr, count: usize) -> bool {
    struct Visible(usize, bool);
    impl Visit for Visible {
        fn place(&mut self, place: &Place, _: Access) {
            self.1 &= place.root.index() < self.0;
            visit::walk_place(self, place);
        }
    }
    let mut visible = Visible(count, true);
    visible.expr(expr);
    visible.1
}
