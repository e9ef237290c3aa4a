//! Routines of linear algebra: a call of a kernel if the routine has its own function. Routines on integer matrices
//! are loops over their elements, in which each operation is checked as for scalars.
//!
//! `a.lu().solve(&b)` is solved by the kernel that keeps no factors, with the bits of the factors' method.
//!
//! The order of operations is nalgebra's: a product adds its terms in the order of the columns of its left factor.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{
    Argument, BinaryOp, Block, Expr, ExprKind, Function, FunctionId, Kernel, KernelRoutine, Local,
    LocalId, Mode, Place, Role, Routine, Scalar, Span, Step, Stmt, StmtKind, Type, UnaryOp,
    effects,
};

use super::callee::Called;
use super::lengths::size;
use super::lowering::Lowering;
use super::words;
use super::{Context, Needed, OUR_FAULT, Result, problem};

/// Module of the factors whose solution is a kernel.
const FACTORS: &str = "bessemer::linear::factored::lu";
/// The function of that module which factors a matrix.
const FACTORED: &str = "bessemer::linear::factored::lu::factored";
/// The method of that module which solves by the factors.
const SOLVED: &str = "bessemer::linear::factored::lu::solve";

/// Returns the matrix whose factors a call computes, if `solves` is a solution by them.
pub(super) fn matrix_of_factors<'t>(
    solves: Option<&tree::Function>,
    factors: Option<Called<'_, 't>>,
) -> Option<&'t tree::Expr> {
    let name = |it: &tree::Function| format!("{}::{}", it.module, it.tree.name);
    match factors? {
        (factored, [a]) if name(factored) == FACTORED && name(solves?) == SOLVED => Some(a),
        _ => None,
    }
}

impl Context<'_> {
    /// Returns the function of a kernel, which is added to the module at its first use.
    pub(super) fn kernel(&mut self, kernel: &Kernel) -> FunctionId {
        let known = |function: &bessemer_ir::Function| function.kernel.as_ref() == Some(kernel);
        let index = self.module.functions.iter().position(known).unwrap_or_else(|| {
            let function = match self.by_columns {
                true => kernel.function(),
                false => kernel.flat_function(),
            };
            self.module.functions.push(function);
            self.module.functions.len() - 1
        });
        FunctionId(index as u32)
    }

    /// Returns the function that solves with a kernel, and returns an option that is `none` for a singular matrix. It
    /// is added to the module at its first use.
    pub(super) fn solving(&mut self, kernel: FunctionId, none: Expr) -> FunctionId {
        let solver = &self.module.functions[kernel.index()];
        let name = solver.name.clone();
        let result_name = solver.result_name.clone();
        let parameters: Vec<Local> = solver.parameters().to_vec();
        let [a, b] = &parameters[..] else { return kernel };
        let is_known = |it: &Function| it.module == FACTORS && it.name == name;
        if let Some(known) = self.module.functions.iter().position(is_known) {
            return FunctionId(known as u32);
        }
        let solution = Local { mode: Mode::Value, ..b.clone() };
        let locals = vec![a.clone(), Local { mode: Mode::Ref, ..b.clone() }, solution];
        let (a, b) = (&a.ty, &b.ty);
        let nowhere = Span::default();
        let read = |index: u32, ty: &Type| Expr::local(LocalId(index), ty, nowhere);
        let mut place = effects::whole(LocalId(2));
        place.ty = b.clone();
        let solve = vec![Argument::Ref(read(0, a)), Argument::RefMut(place)];
        let solves = Expr { kind: ExprKind::Call(kernel, solve), ty: Type::BOOL, span: nowhere };
        let parts = vec![Expr::bool(true, nowhere), read(2, b)];
        let some = Expr { kind: ExprKind::Struct(parts), ..none.clone() };
        let result = none.ty.clone();
        let returned = |value| Block(vec![Stmt::new(StmtKind::Return(Some(value)), nowhere)]);
        let body = vec![
            StmtKind::Let { local: LocalId(2), value: Some(read(1, b)) },
            StmtKind::If { condition: solves, then: returned(some), otherwise: returned(none) },
        ];
        self.module.functions.push(Function {
            name,
            module: FACTORS.to_owned(),
            owner: None,
            role: Role::Public,
            attributes: Default::default(),
            docs: vec![
                "The solution for each column of `b`; none for a singular matrix.".to_owned(),
            ],
            params: 2,
            locals,
            result,
            result_name,
            body: Block(body.into_iter().map(|kind| Stmt::new(kind, nowhere)).collect()),
            kernel: None,
            span: nowhere,
        });
        FunctionId(self.module.functions.len() as u32 - 1)
    }
}

impl Lowering<'_, '_> {
    /// Lowers the call of a kernel.
    pub(super) fn kernel_call(
        &mut self,
        routine: KernelRoutine,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let types = arguments.iter().map(|argument| self.type_of_value(argument));
        let types = types.collect::<Result<Vec<_>>>()?;
        let kernel = kernel_of(routine, &types);
        let kernel = kernel.needed(expr.site, "this takes matrices of `f64` or `f32`")?;
        let id = self.cx.kernel(&kernel);
        match self.cx.by_columns {
            true => self.call_function(id, arguments, expr),
            false => self.call_with_copies(id, arguments, expr),
        }
    }

    /// Lowers the call of a kernel with copies of the matrices whose layout differs from the kernel's. Changed copies
    /// are copied back.
    fn call_with_copies(
        &mut self,
        id: FunctionId,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let function = &self.cx.module.functions[id.index()];
        let result = function.result.clone();
        let by_columns = function.kernel.as_ref().map(|kernel| kernel.function().result);
        let parameters: Vec<_> =
            function.parameters().iter().map(|local| (local.mode, local.ty.clone())).collect();
        let (mut passed, mut back) = (Vec::new(), Vec::new());
        for (argument, (mode, ty)) in arguments.iter().zip(parameters) {
            let place = self.base(argument)?;
            let place = match place.ty {
                Type::Matrix { rows, cols, .. } if place.ty != ty => {
                    let columns = self.mutable_place("columns", self.zero(&ty, place.span));
                    self.copy_columns(&place, &columns, (rows, cols), true)?;
                    if mode == Mode::RefMut {
                        back.push((place, columns.clone(), (rows, cols)));
                    }
                    columns
                }
                _ => place,
            };
            passed.push(match mode {
                Mode::RefMut => Argument::RefMut(place),
                _ => Argument::Ref(place.load()),
            });
        }
        let call = self.node(ExprKind::Call(id, passed), result, expr.site)?;
        let span = self.span(expr.site);
        if let Some(Type::Matrix { element, rows, cols }) = by_columns
            && !matches!(call.ty, Type::Matrix { .. })
        {
            let columns = self.mutable_place("columns", call);
            let ty = Type::Matrix { element, rows, cols };
            let matrix = self.mutable_place("result", self.zero(&ty, span));
            self.copy_columns(&matrix, &columns, (rows, cols), false)?;
            return Ok(matrix.load());
        }
        if back.is_empty() {
            return Ok(call);
        }
        let value = self.called_here("solved", call);
        for (place, columns, shape) in back {
            self.copy_columns(&place, &columns, shape, false)?;
        }
        Ok(value)
    }

    /// Emits loops that copy a matrix to an array of its columns, or back.
    fn copy_columns(
        &mut self,
        matrix: &Place,
        columns: &Place,
        (rows, cols): (u32, u32),
        to_columns: bool,
    ) -> Result<()> {
        let (span, Type::Matrix { element, .. }) = (matrix.span, matrix.ty.clone()) else {
            return Ok(());
        };
        let element = Type::Scalar(element);
        self.below(words::COLUMN, size(cols, span), span, |walk, column| {
            walk.below(words::ROW, size(rows, span), span, |walk, row| {
                let start = Expr::binary(BinaryOp::Mul, size(rows, span), column.clone());
                let index = Expr::binary(BinaryOp::Add, row.clone(), start);
                let cell = matrix.inside(Step::Element(row, column), element.clone());
                let part = columns.inside(Step::Index(index), element);
                let (place, value) =
                    if to_columns { (part, cell.load()) } else { (cell, part.load()) };
                walk.emit(StmtKind::Assign { place, value }, span);
                Ok(())
            })
        })
    }

    /// Lowers a routine: as a kernel if it is large enough, else as an IR node.
    pub(super) fn routine_node(
        &mut self,
        routine: Routine,
        values: Vec<Expr>,
        site: Site,
    ) -> Result<Expr> {
        let ty = result(routine, &values).needed(site, "this takes a matrix or vector")?;
        let integers = |value: &Expr| matches!(&value.ty, Type::Matrix { element, .. } if !matches!(element, Scalar::Float(_)));
        if routine != Routine::Transpose && values.iter().any(integers) {
            return self.integer_routine(routine, values, ty, site);
        }
        let kernel = if self.cx.by_columns { product(routine, &values) } else { None };
        let Some((kernel, operands)) = kernel else {
            return self.node(ExprKind::Routine(routine, values), ty, site);
        };
        let id = self.cx.kernel(&kernel);
        let arguments = operands.into_iter().map(Argument::Ref).collect();
        self.node(ExprKind::Call(id, arguments), ty, site)
    }

    /// Lowers a routine on integer matrices.
    pub(super) fn integer_routine(
        &mut self,
        routine: Routine,
        values: Vec<Expr>,
        ty: Type,
        site: Site,
    ) -> Result<Expr> {
        // The operation on two elements, or on an element and a number.
        let (name, op) = match routine {
            Routine::Neg => (words::NEGATIVE, None),
            Routine::Add => (words::SUM, Some(BinaryOp::Add)),
            Routine::Sub => (words::DIFFERENCE, Some(BinaryOp::Sub)),
            Routine::ComponentMul | Routine::Product => (words::PRODUCT, Some(BinaryOp::Mul)),
            Routine::ComponentDiv | Routine::Unscale => (words::QUOTIENT, Some(BinaryOp::Div)),
            Routine::Scale => (words::SCALED, Some(BinaryOp::Mul)),
            _ => {
                let remedy = "write a loop over their elements";
                return problem(site, "this takes matrices of `f64` or `f32`", remedy);
            }
        };
        let (element, rows, cols) = shape(&ty).needed(site, "this is no matrix")?;
        let mut operands = Vec::new();
        for value in values {
            operands.push(match value.is_literal() {
                true => value,
                false => self.hold(value).load(),
            });
        }
        let span = self.span(site);
        let result = self.assigned(name, self.zero(&ty, span));
        let cell = |matrix: &Place, row: &Expr, column: &Expr| {
            let step = Step::Element(row.clone(), column.clone());
            matrix.inside(step, Type::Scalar(element))
        };
        // A number is the same at each row and column.
        let at = |operand: &Expr, row: &Expr, column: &Expr| match &operand.kind {
            ExprKind::Load(matrix) if matches!(matrix.ty, Type::Matrix { .. }) => {
                cell(matrix, row, column).load()
            }
            _ => operand.clone(),
        };
        let joined = |op, one, other| Expr::binary(op, one, other).at(span);
        self.each_cell("col", (rows, cols), span, |walk, row, column| {
            let place = cell(&result, &row, &column);
            let value = match (op, operands.as_slice()) {
                (Some(op), [one @ Expr { ty: Type::Matrix { cols: terms, .. }, .. }, other])
                    if routine == Routine::Product =>
                {
                    return walk.below_unless_one("k", *terms, span, |walk, k| {
                        let term = joined(op, at(one, &row, &k), at(other, &k, &column));
                        let value = joined(BinaryOp::Add, place.load(), term);
                        walk.emit(StmtKind::Assign { place, value }, span);
                        Ok(())
                    });
                }
                (Some(op), [one, other]) => {
                    joined(op, at(one, &row, &column), at(other, &row, &column))
                }
                (None, [one]) => Expr::unary(UnaryOp::Neg, at(one, &row, &column)).at(span),
                _ => return problem(site, "this is no matrix", OUR_FAULT),
            };
            walk.emit(StmtKind::Assign { place, value }, span);
            Ok(())
        })?;
        Ok(result.load())
    }
}

/// Returns the kernel of a product, and its operands. A factor that is transposed only for the product is read
/// untransposed by a kernel of its own.
fn product(routine: Routine, values: &[Expr]) -> Option<(Kernel, Vec<Expr>)> {
    let [left, right] = values else { return None };
    let transposed = |value: &Expr| match &value.kind {
        ExprKind::Routine(Routine::Transpose, list) => list.first().cloned(),
        _ => None,
    };
    let (which, left, right) = match (routine, transposed(left), transposed(right)) {
        (Routine::TrMul, ..) => (KernelRoutine::TrMul, left.clone(), right.clone()),
        (Routine::Product, _, Some(right)) => (KernelRoutine::ProductTr, left.clone(), right),
        (Routine::Product, Some(left), None) => (KernelRoutine::TrProduct, left, right.clone()),
        (Routine::Product, None, None) => (KernelRoutine::Product, left.clone(), right.clone()),
        _ => return None,
    };
    let kernel = kernel_of(which, &[left.ty.clone(), right.ty.clone()])?;
    kernel.is_function().then(|| (kernel, vec![left, right]))
}

/// Returns the element type, rows and columns of a matrix type.
pub(super) fn shape(ty: &Type) -> Option<(Scalar, u32, u32)> {
    match *ty {
        Type::Matrix { element, rows, cols } => Some((element, rows, cols)),
        _ => None,
    }
}

/// Returns the result type of a routine.
fn result(routine: Routine, values: &[Expr]) -> Option<Type> {
    let (element, rows, cols) = shape(&values.first()?.ty)?;
    let matrix = |rows, cols| Type::Matrix { element, rows, cols };
    let last = || Some(shape(&values.get(1)?.ty)?.2);
    Some(match routine {
        Routine::Transpose => matrix(cols, rows),
        Routine::Dot | Routine::Norm | Routine::NormSquared | Routine::Amax | Routine::Amin => {
            Type::Scalar(element)
        }
        Routine::TrMul => matrix(cols, last()?),
        Routine::Product => matrix(rows, last()?),
        _ => matrix(rows, cols),
    })
}

/// Returns the kernel of a routine for operands of these types, with the dimensions that [`KernelRoutine`] documents.
pub(super) fn kernel_of(routine: KernelRoutine, types: &[Type]) -> Option<Kernel> {
    use KernelRoutine as R;
    let (Scalar::Float(element), rows, cols) = shape(types.first()?)? else { return None };
    let dims = match (routine, types) {
        (_, [_]) => vec![rows],
        (R::ProductTr, [_, right]) => vec![rows, cols, shape(right)?.1],
        (R::TrProduct, [_, right]) => vec![cols, rows, shape(right)?.2],
        (R::Product | R::TrMul, [_, right]) => vec![rows, cols, shape(right)?.2],
        (_, [_, right]) => vec![rows, shape(right)?.2],
        _ => return None,
    };
    Kernel::new(routine, element, &dims)
}
