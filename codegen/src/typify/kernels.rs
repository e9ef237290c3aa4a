//! Routines of linear algebra that are functions of their own: which kernel a call means.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{
    Argument, Expr, ExprKind, FunctionId, Kernel, KernelRoutine, Routine, Scalar, Type,
};

use super::function::Lowering;
use super::{Context, OUR_FAULT, Result, problem};

/// What the DSL calls its kernels.
fn routine(name: &str) -> Option<KernelRoutine> {
    Some(match name {
        "solve_mut" => KernelRoutine::LuSolve,
        "solve_into" => KernelRoutine::Solve,
        "inverse_mut" => KernelRoutine::Inverse,
        "determinant" => KernelRoutine::Determinant,
        "cholesky_mut" => KernelRoutine::Cholesky,
        "cholesky_solve_mut" => KernelRoutine::CholeskySolve,
        "solve_lower_mut" => KernelRoutine::SolveLower,
        "solve_upper_mut" => KernelRoutine::SolveUpper,
        "tr_solve_lower_mut" => KernelRoutine::TrSolveLower,
        "tr_solve_upper_mut" => KernelRoutine::TrSolveUpper,
        _ => return None,
    })
}

impl Context<'_> {
    /// The function that stands for a kernel; of the module once it is asked for.
    fn kernel(&mut self, kernel: &Kernel) -> FunctionId {
        let known = |function: &bessemer_ir::Function| function.kernel.as_ref() == Some(kernel);
        let index = self.module.functions.iter().position(known).unwrap_or_else(|| {
            self.module.functions.push(kernel.function());
            self.module.functions.len() - 1
        });
        FunctionId(index as u32)
    }
}

impl Lowering<'_, '_> {
    /// A call that is a kernel's, if `name` is that of one.
    pub(super) fn kernel_call(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Option<Expr>> {
        let Some(routine) = routine(name) else { return Ok(None) };
        let mut shapes = Vec::new();
        for argument in arguments {
            shapes.push(self.type_alone(argument)?);
        }
        let kernel = match (routine, shapes.as_slice()) {
            (_, [a, b]) => of(routine, a, |rows, _| match *b {
                Type::Matrix { cols, .. } => vec![rows, cols],
                _ => Vec::new(),
            }),
            (_, [a]) => of(routine, a, |rows, _| vec![rows]),
            _ => None,
        };
        let Some(kernel) = kernel else {
            return problem(expr.site, "this takes matrices of `f64` or `f32`", OUR_FAULT);
        };
        let id = self.cx.kernel(&kernel);
        self.call_function(id, arguments, expr).map(Some)
    }

    /// A routine of values: a kernel, where it is large enough for one.
    pub(super) fn routine_node(
        &mut self,
        routine: Routine,
        values: Vec<Expr>,
        ty: Type,
        site: Site,
    ) -> Result<Expr> {
        let Some((kernel, operands)) = product(routine, &values) else {
            return self.node(ExprKind::Routine(routine, values), ty, site);
        };
        let id = self.cx.kernel(&kernel);
        let arguments = operands.into_iter().map(Argument::Ref).collect();
        self.node(ExprKind::Call(id, arguments), ty, site)
    }
}

/// The kernel that a product is, and its operands: what is transposed for the product alone is read as it
/// lies in memory.
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
    let Type::Matrix { rows: first, cols: second, .. } = right.ty else { return None };
    let kernel = of(which, &left.ty, |rows, cols| match which {
        KernelRoutine::ProductTr => vec![rows, cols, first],
        KernelRoutine::TrProduct => vec![cols, rows, second],
        _ => vec![rows, cols, second],
    })?;
    kernel.is_function().then(|| (kernel, vec![left, right]))
}

/// The kernel of a routine for its first operand's type.
fn of(
    routine: KernelRoutine,
    first: &Type,
    dims: impl FnOnce(u32, u32) -> Vec<u32>,
) -> Option<Kernel> {
    match *first {
        Type::Matrix { element: Scalar::Float(element), rows, cols } => {
            Kernel::new(routine, element, &dims(rows, cols))
        }
        _ => None,
    }
}
