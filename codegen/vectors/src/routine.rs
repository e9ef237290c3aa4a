//! Routines of linear algebra, and kernels.

use bessemer_ir::{Expr, Float, Kernel, KernelRoutine, Routine, Scalar, Span, Type};

use crate::body::{Cx, Result};

/// Returns the rows and columns of a matrix.
fn shape(ty: &Type) -> (u32, u32) {
    match ty {
        Type::Matrix { rows, cols, .. } => (*rows, *cols),
        _ => (1, 1),
    }
}

impl Cx<'_> {
    pub(crate) fn routine(&self, which: Routine, of: &[Expr]) -> Result<String> {
        let Some(first) = of.first() else {
            return Err(self.error(Span::default(), "has a routine without operands"));
        };
        let double = Type::Scalar(Scalar::Float(Float::F64));
        let is_double =
            matches!(first.ty, Type::Matrix { element, .. } if Type::Scalar(element) == double);
        if !is_double {
            return Err(self.error(first.span, "has matrices of other numbers than `f64`"));
        }
        let (rows, columns) = shape(&first.ty);
        let n = rows * columns;
        let name = match which {
            Routine::Add => "add".to_owned(),
            Routine::Sub => "sub".to_owned(),
            Routine::ComponentMul => "component_mul".to_owned(),
            Routine::ComponentDiv => "component_div".to_owned(),
            Routine::Neg => "neg".to_owned(),
            Routine::Scale => "scale".to_owned(),
            Routine::Unscale => "unscale".to_owned(),
            Routine::Cross => "cross".to_owned(),
            Routine::Transpose => format!("transpose::<{rows}, {n}>"),
            Routine::Dot => format!("dot::<{rows}, {n}>"),
            Routine::Norm => format!("norm::<{rows}, {n}>"),
            Routine::NormSquared => format!("norm_squared::<{rows}, {n}>"),
            Routine::Product => {
                let outputs = of.get(1).map_or(1, |it| shape(&it.ty).1);
                let (b, out) = (columns * outputs, rows * outputs);
                format!("product::<{rows}, {columns}, {n}, {b}, {out}>")
            }
            Routine::TrMul => {
                let outputs = of.get(1).map_or(1, |it| shape(&it.ty).1);
                let (b, out) = (rows * outputs, columns * outputs);
                format!("tr_mul::<{rows}, {n}, {b}, {out}>")
            }
            _ => {
                let what = format!("uses `{which:?}`, which lanes do not have");
                return Err(self.error(first.span, &what));
            }
        };
        let scalar = matches!(which, Routine::Scale | Routine::Unscale);
        let argument = |(n, it): (usize, &Expr)| match scalar && n == 1 {
            true => self.value(it),
            false => self.reference(it),
        };
        let arguments = of.iter().enumerate().map(argument).collect::<Result<Vec<_>>>()?;
        Ok(format!("lanes::{name}({})", arguments.join(", ")))
    }

    /// Returns the body of a kernel.
    pub(crate) fn kernel(&self, kernel: &Kernel) -> Result<String> {
        let names: Vec<String> =
            (0..self.function.params).map(|it| self.local(bessemer_ir::LocalId(it))).collect();
        let name = match kernel.routine {
            _ if kernel.element != Float::F64 => None,
            KernelRoutine::Product => Some("product"),
            KernelRoutine::TrProduct => Some("tr_product"),
            _ => None,
        };
        let (Some(name), [r, k, c, ..]) = (name, kernel.dims.as_slice()) else {
            let reason = "is a kernel that lanes do not have";
            return Err(self.error(self.function.span, reason));
        };
        let (a, b, out) = (r * k, k * c, r * c);
        Ok(format!("lanes::{name}::<{r}, {k}, {a}, {b}, {out}>({})", names.join(", ")))
    }
}
