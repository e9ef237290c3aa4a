//! Places, indices, and elements of matrices.

use bessemer_ir::{Expr as Ir, ExprKind, Int, LocalId, Place, Scalar, Step, Type, Written};

use super::super::matrices::Layout;
use super::super::tree::Expr;
use super::{Lower, bound};

impl Lower<'_> {
    /// Returns the place of a local that is a part of the result.
    pub(super) fn part_of_result(&self, local: LocalId) -> Option<Expr> {
        let (path, mut value) = (self.parts.get(&local)?, self.result_storage()?);
        let mut ty = &self.function.result;
        for field in path {
            let Type::Struct(id) = ty else { return None };
            value = value.field(&self.context.names.structs[id.index()].fields[*field]);
            ty = &self.context.module.structs[id.index()].fields[*field].ty;
        }
        Some(value)
    }

    /// Returns a place as an lvalue.
    pub(super) fn place(&mut self, place: &Place) -> Expr {
        let function = self.function;
        self.mentioned[place.root.index()] = true;
        let mut value = self.part_of_result(place.root).unwrap_or_else(|| self.local(place.root));
        let mut ty = function.local(place.root).ty.clone();
        for step in &place.steps {
            (value, ty) = self.step(value, &ty, step);
        }
        value
    }

    /// Returns the expression of a local.
    fn local(&mut self, local: LocalId) -> Expr {
        let binding = self.bindings[local.index()].as_ref();
        let binding = binding.expect("a local is declared before its use");
        let (value, constant) = (bound(binding), binding.constant);
        if let Some(id) = constant {
            let ty = self.function.local(local).ty.clone();
            self.uses.consts.insert(id);
            self.include_type(&ty);
        }
        value
    }

    fn step(&mut self, value: Expr, ty: &Type, step: &Step) -> (Expr, Type) {
        match (step, ty) {
            (Step::Field(field), Type::Struct(id)) => {
                let name = &self.context.names.structs[id.index()].fields[*field as usize];
                let item = &self.context.module.structs[id.index()];
                (value.field(name), item.fields[*field as usize].ty.clone())
            }
            (Step::Index(index), Type::Array { element, .. } | Type::Slice(element)) => {
                (value.at(self.index(index)), (**element).clone())
            }
            // By columns, as nalgebra counts.
            (Step::Index(index), Type::Matrix { element, rows, cols }) => {
                let (layout, shape) = (self.context.names.layout, (*rows, *cols));
                let index = self.index(index);
                let element = Type::Scalar(*element);
                if layout.has_columns(shape) {
                    return (value.at(index), element);
                }
                let part = |op| Expr::binary(op, index.clone(), Expr::name(format!("{rows}U")));
                (layout.at(value, shape, part("%"), part("/")), element)
            }
            (Step::Element(row, column), Type::Matrix { element, rows, cols }) => {
                // What is left out is not mentioned.
                let value = match (rows, cols) {
                    (_, 1) => value.at(self.index(row)),
                    (1, _) => value.at(self.index(column)),
                    shape => {
                        let (row, column) =
                            (self.beside_index(row, column), self.beside_index(column, row));
                        self.context.names.layout.at(value, (*shape.0, *shape.1), row, column)
                    }
                };
                (value, Type::Scalar(*element))
            }
            // The array itself is the address of its first element.
            (Step::From(from), ty) if ty.is_array() => {
                let element = match ty {
                    Type::Array { element, .. } | Type::Slice(element) => element.clone(),
                    Type::Matrix { element, .. } => Box::new(Type::Scalar(*element)),
                    _ => unreachable!("no other type is an array in C"),
                };
                let value = match &from.kind {
                    ExprKind::Literal(0) => value,
                    _ => value.at(self.index(from)).address(),
                };
                (value, Type::Slice(element))
            }
            (step, ty) => unreachable!("the validator refuses {step:?} into {ty:?}"),
        }
    }

    /// Returns an index. Any integer type is valid, so conversions to `usize` and suffixes are omitted.
    pub(super) fn index(&mut self, index: &Ir) -> Expr {
        if let ExprKind::Literal(word) = index.kind {
            return self.spelt(index).unwrap_or_else(|| Expr::name(word.to_string()));
        }
        if self.range(index).is_some() {
            return self.narrow(index, true);
        }
        match &index.kind {
            ExprKind::Cast(inner)
                if index.ty == Type::USIZE
                    && inner.ty.as_int().is_some_and(|int| !int.signed()) =>
            {
                self.index(inner)
            }
            _ => self.word(index),
        }
    }

    /// Returns the name of a literal index, if its author wrote one.
    fn spelt(&mut self, index: &Ir) -> Option<Expr> {
        match self.context.module.written(index)? {
            Written::Hexadecimal => None,
            Written::Constant(id) => {
                self.uses.consts.insert(id);
                Some(Expr::name(self.constant(id)))
            }
            Written::Variant(id, at) => {
                self.include_type(&Type::Enum(id));
                Some(Expr::name(&self.context.names.enums[id.index()].variants[at as usize]))
            }
        }
    }

    /// Returns one of two indices that are added. A 64-bit index is cast to 32 bits beside a 32-bit one, since both
    /// are within the matrix.
    fn beside_index(&mut self, index: &Ir, other: &Ir) -> Expr {
        let is_long = |index: &Ir| {
            let long = index.ty.as_int().is_some_and(|int| int.bits() == 64);
            long && self.range(index).is_none() && matches!(index.kind, ExprKind::Load(_))
        };
        let alone = is_long(index) && self.counts(other) && !self.is_wide(other);
        // No arithmetic has an enum as its operand.
        let variant = matches!(self.context.module.written(index), Some(Written::Variant(..)));
        let value = self.index(index);
        let flat = self.context.names.layout != Layout::Array;
        if (alone || variant) && flat { Expr::cast("uint32_t", value) } else { value }
    }

    /// Returns the place or the constant of an aggregate.
    pub(super) fn operand(&mut self, expr: &Ir) -> Expr {
        match &expr.kind {
            ExprKind::Load(place) => self.place(place),
            ExprKind::Const(id) => {
                self.uses.consts.insert(*id);
                self.include_type(&expr.ty);
                Expr::name(self.constant(*id))
            }
            _ => {
                let name = self.fresh("value");
                self.define(&expr.ty, &name, expr, true);
                Expr::name(name)
            }
        }
    }

    /// Returns the argument for a parameter that C takes by address.
    pub(super) fn address(value: Expr, ty: &Type) -> Expr {
        match ty {
            ty if ty.is_array() => value,
            _ => value.address(),
        }
    }
}

/// Returns element type, rows and columns of a matrix type.
pub(super) fn shape(ty: &Type) -> (Scalar, u32, u32) {
    match ty {
        Type::Matrix { element, rows, cols } => (*element, *rows, *cols),
        Type::Array { element, len } => match **element {
            Type::Scalar(scalar) => (scalar, *len, 1),
            _ => unreachable!("routines take matrices: {ty:?}"),
        },
        _ => unreachable!("routines take matrices: {ty:?}"),
    }
}

/// Returns true if an integer type is narrower than C's `int`.
pub(super) fn is_small(int: Int) -> bool {
    int.bits() < 32
}
