//! Lowers the DSL's own operations to IR nodes with their result types.

use bessemer_ir::tree::{self, Builtin, MatrixMethod};
use bessemer_ir::{Expr, ExprKind, Float, Int, Intrinsic, Routine, Scalar, Type};

use super::expr::Call;
use super::kernels::shape;
use super::lengths::size;
use super::lowering::Lowering;
use super::numbers::number;
use super::words;
use super::{Needed, OUR_FAULT, Result, problem, refusals, refused};

impl Lowering<'_, '_> {
    pub(super) fn builtin(&mut self, builtin: Builtin, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        match builtin {
            Builtin::Scalar(op) => self.intrinsic(op, call),
            Builtin::Number(method) => self.number_method(method, call),
            Builtin::Bytes(order) => self.bytes_of_number(order, call),
            Builtin::Real | Builtin::AsF64 => {
                let expected = (builtin == Builtin::Real).then_some(Type::F64);
                let value = self.value(&arguments[0], expected.as_ref())?;
                let ty = self.slot_of(expr)?;
                self.as_float(value, ty, expr.site)
            }
            Builtin::TryFrom => self.if_it_fits(&arguments[0], expr),
            Builtin::Owned => self.read(&arguments[0], None),
            Builtin::Linear(routine) => self.routine(routine, call),
            Builtin::Matrix(method) => self.matrix_method(method, call),
            Builtin::Kernel(routine) => self.kernel_call(routine, arguments, expr),
            Builtin::Spatial(method) => self.spatial(method, call),
            Builtin::Parts(parts) => self.of_parts(parts, call),
            Builtin::List(method) => self.list_method(method, call),
            Builtin::Slice(method) => self.slice_method(method, call),
            Builtin::Option(method) => self.option_method(method, call),
            // It was put in its place before, if its arguments are closures.
            Builtin::Desugared(_) => {
                problem(expr.site, format!("{builtin:?} has no meaning here"), OUR_FAULT)
            }
        }
    }

    fn matrix_method(&mut self, method: MatrixMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        match method {
            MatrixMethod::Rows | MatrixMethod::Cols | MatrixMethod::Elements => {
                self.size(method, call)
            }
            MatrixMethod::ByRows => self.by_rows(&arguments[0], expr),
            MatrixMethod::FromArray => self.exchanged_with_array(&arguments[0], expr),
            MatrixMethod::Swizzle(axes, count) => self.swizzle(&axes[..usize::from(count)], call),
            MatrixMethod::Part(_) => refused(expr.site, refusals::MOVED_VIEW),
            MatrixMethod::New
            | MatrixMethod::Zeros
            | MatrixMethod::Identity
            | MatrixMethod::FromElement
            | MatrixMethod::Axis(_) => self.constructor(method, call),
        }
    }

    /// Returns the number of rows, columns or elements of a matrix.
    fn size(&mut self, method: MatrixMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        let shape = self.shape_of(&arguments[0])?;
        let (rows, cols) = shape.needed(expr.site, "this takes a matrix or vector")?;
        let count = match method {
            MatrixMethod::Rows => rows,
            MatrixMethod::Cols => cols,
            _ => rows * cols,
        };
        Ok(size(count, self.span(expr.site)))
    }

    /// Returns the dimensions of a matrix. Its operand is evaluated for its effects and faults only.
    fn shape_of(&mut self, matrix: &tree::Expr) -> Result<Option<(u32, u32)>> {
        if let Some(part) = self.submatrix(matrix)? {
            return Ok(Some((part.rows, part.cols)));
        }
        let value = self.value(matrix, None)?;
        self.operand_held(words::VECTOR, value.clone());
        Ok(shape(&value.ty).map(|(_, rows, cols)| (rows, cols)))
    }

    /// Lowers `vector![a, b]` and `matrix![a, b; c, d]`.
    fn by_rows(&mut self, rows: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let inside = |expr: &tree::Expr| match &expr.kind {
            tree::ExprKind::Array(elements) => elements.clone(),
            _ => Vec::new(),
        };
        let elements: Vec<_> = inside(rows).iter().flat_map(inside).collect();
        self.constructor(MatrixMethod::New, Call { arguments: &elements, expr })
    }

    fn intrinsic(&mut self, op: Intrinsic, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        // Operands and result are of one type, save for those that change it.
        let expected = match op {
            Intrinsic::FromBits => match self.slot_of(expr)?.as_float() {
                Some(Float::F32) => Some(Type::Scalar(Scalar::Int(Int::U32))),
                _ => Some(Type::Scalar(Scalar::Int(Int::U64))),
            },
            Intrinsic::ToBits
            | Intrinsic::RawBits
            | Intrinsic::UnsignedAbs
            | Intrinsic::IsNan
            | Intrinsic::IsFinite
            | Intrinsic::IsInfinite => None,
            // Of references it gives what is read.
            _ => expr.slot.map(|slot| self.seen(slot, expr.site)).transpose()?,
        };
        let values = self.alike(arguments, expected, &words::OPERANDS)?;
        let ty = match values.first().map(|first| &first.ty) {
            Some(Type::Scalar(scalar)) => op.result(*scalar).map(Type::Scalar),
            _ => None,
        };
        let ty = ty.needed(expr.site, "this does not take that type")?;
        self.node(ExprKind::Intrinsic(op, values), ty, expr.site)
    }

    fn routine(&mut self, routine: Routine, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        // A literal factor is of the matrix' own float.
        let scaled = matches!(routine, Routine::Scale | Routine::Unscale);
        let result = expr.slot.filter(|_| scaled).map(|slot| self.slot(slot, expr.site));
        let factor = match result.transpose()? {
            Some(Type::Matrix { element, .. }) => Some(Type::Scalar(element)),
            _ => None,
        };
        let values = self.alike(arguments, factor, &words::OPERANDS)?;
        self.routine_node(routine, values, expr.site)
    }

    /// Lowers a constructor of a matrix: from its elements, or from a constant such as zero or identity.
    fn constructor(&mut self, method: MatrixMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        let ty = self.slot_of(expr)?;
        let (element, rows, cols) = shape(&ty).needed(expr.site, "this is not a matrix")?;
        let (scalar, span) = (Type::Scalar(element), self.span(expr.site));
        let numbers = |is_one: &dyn Fn(u32) -> bool| {
            let number = |index| number(u8::from(is_one(index)), &scalar, span);
            ExprKind::Matrix((0..rows * cols).map(number).collect())
        };
        let kind = match method {
            MatrixMethod::Zeros => ExprKind::Splat(Box::new(number(0, &scalar, span))),
            MatrixMethod::Identity => numbers(&|index| index % rows == index / rows),
            // The unit vector along this axis.
            MatrixMethod::Axis(axis) => numbers(&|index| index == axis),
            MatrixMethod::FromElement => {
                let value = self.alike(arguments, Some(scalar), &words::OPERANDS)?;
                let first = value.into_iter().next();
                ExprKind::Splat(Box::new(first.needed(expr.site, "this takes an element")?))
            }
            _ => {
                // The author writes rows; the IR, as nalgebra, stores columns. The last element is the last of both.
                let by_rows = self.alike(arguments, Some(scalar), &words::OPERANDS)?;
                let by_columns = (0..rows * cols)
                    .map(|index| by_rows[((index % rows) * cols + index / rows) as usize].clone())
                    .collect();
                ExprKind::Matrix(by_columns)
            }
        };
        self.node(kind, ty, expr.site)
    }
}
